//! The tools and the probe by the steps in which they are in use, and the tool probes, as the view draws them.

use super::object;
use super::setup_write::solids;
use crate::catalogue::{Dialect, ProbeUse, find};
use crate::control::tools::LATHE_PROBE;
use crate::control::{Control, Edge};
use crate::geometry::V3;
use crate::run::outcome::Outcome;
use crate::run::setup::Setup;
use crate::run::trace::Step;
use crate::workpiece::seen::{self, Drawn};
use crate::workpiece::tool::Tool;
use serde_json::Value;
use std::collections::BTreeSet;

/// The caps of the tool probes.
pub(super) fn probes(setup: &Setup) -> Value {
    let caps: Vec<_> = setup
        .tool_probes
        .iter()
        .map(|probe| probe.solid.clone())
        .collect();
    solids(&caps)
}

/// T and D number of a tool, or of an NCT control T 0 and the register.
type Place = (i64, i64);

/// Whatever was in use, each once, and from which entry on which of them.
pub(super) fn tools(setup: &Setup, outcome: &Outcome) -> (Value, Value) {
    let mut known: Vec<Place> = Vec::new();
    let mut in_use = Vec::new();
    for (entry, place) in changes(outcome) {
        let index = known.iter().position(|one| *one == place);
        let index = index.unwrap_or_else(|| {
            known.push(place);
            known.len() - 1
        });
        in_use.push(Value::from(vec![entry, index]));
    }
    let measured = measured(outcome);
    let view = |place: &Place| tool(setup, outcome, *place, measured.contains(place));
    (known.iter().map(view).collect(), in_use.into())
}

/// What is in use, from which entry on.
fn changes(outcome: &Outcome) -> Vec<(usize, Place)> {
    let begin = outcome.before.active_place();
    let entries = outcome.trace.entries.iter().enumerate();
    let changed =
        entries.filter_map(
            |(index, entry)| match (&entry.step, outcome.before.dialect) {
                (Step::Tool(tool, edge), Dialect::Sinumerik) => Some((index, (*tool, *edge))),
                (Step::Tool(_, edge), Dialect::Nct) => Some((index, (0, *edge))),
                _ => None,
            },
        );
    std::iter::once((0, begin)).chain(changed).collect()
}

/// With what a part was measured, which then was the probe whatever its data say.
fn measured(outcome: &Outcome) -> BTreeSet<Place> {
    let mut changes = changes(outcome).into_iter().peekable();
    let mut place = outcome.before.active_place();
    let mut measured = BTreeSet::new();
    for (index, entry) in outcome.trace.entries.iter().enumerate() {
        while let Some((_, next)) = changes.next_if(|(from, _)| *from <= index) {
            place = next;
        }
        let Step::CallBegin { cycle, .. } = entry.step else {
            continue;
        };
        let cycle = find(outcome.before.dialect, cycle);
        if cycle.is_some_and(|cycle| cycle.purpose.probe == ProbeUse::Workpiece) {
            measured.insert(place);
        }
    }
    measured
}

/// What is drawn: the ball, or the pieces of a tool; on a turning machine also what carries it. `tip`: from the position of
/// the machine to the end of the tool.
fn tool(setup: &Setup, outcome: &Outcome, (number, edge): Place, measured: bool) -> Value {
    let mut control = outcome.before.clone();
    control.plane = outcome.control.plane;
    let later = || outcome.control.edge_of(number, edge).cloned();
    let data = control.edge_of(number, edge).cloned().or_else(later);
    if let Some(data) = &data {
        let tools = control.tools.entry(number).or_default();
        tools.edges.entry(edge).or_insert_with(|| data.clone());
    }
    (control.tool, control.edge) = (number, edge);
    let carrier = V3::from(control.active_length());
    let is_probe = |edge: &Edge| measured || [710, LATHE_PROBE].contains(&edge.kind);
    let Some(data) = data.filter(|data| !is_probe(data)) else {
        return ball(setup, &control, carrier);
    };
    let real = setup.real_tools.get(&(number, edge)).cloned();
    let tool = real.unwrap_or_else(|| Tool::nominal(&data, &outcome.before));
    let tip = V3::from(tool.error(&control));
    let (pieces, along) = seen::tool(&tool, carrier - tip, control.plane);
    let holder = held(setup, &control, carrier - tip, along);
    object([
        ("tip", vector(tip)),
        ("pieces", drawn(&pieces, tip)),
        ("carrier", drawn(&holder, tip)),
    ])
}

/// Ball and stylus. The axis points from the ball to what holds it, in machine coordinates: along the applicate of the
/// plane in which was measured, on a turning machine as the cutting edge position says.
fn ball(setup: &Setup, control: &Control, carrier: V3) -> Value {
    let [abscissa, ordinate, applicate] = control.plane.axes();
    let mut axis = V3::zeros();
    match control.active_edge().and_then(Edge::body) {
        Some([along, across]) => (axis[abscissa], axis[ordinate]) = (along, across),
        None => axis[applicate] = 1.0,
    }
    let holder = held(setup, control, carrier, axis);
    let turret = control.turns().then_some(setup.probe.length);
    let adapter = turret.and_then(|length| seen::adapter(length, carrier, axis));
    object([
        ("ball", vector(axis)),
        ("tip", vector(V3::zeros())),
        ("pieces", drawn(adapter.as_slice(), V3::zeros())),
        ("carrier", drawn(&holder, V3::zeros())),
    ])
}

/// Holder and turret of a turning machine.
fn held(setup: &Setup, control: &Control, carrier: V3, along: V3) -> Vec<Drawn> {
    match control.turns() {
        true => seen::turret(&setup.turret, carrier, along),
        false => Vec::new(),
    }
}

/// Pieces that begin at the end of a tool, from the position of the machine on.
fn drawn(pieces: &[Drawn], tip: V3) -> Value {
    let piece = |piece: &Drawn| match piece {
        Drawn::Round { outline, axis, at } => object([
            (
                "outline",
                outline.iter().copied().map(Value::from).collect(),
            ),
            ("axis", vector(*axis)),
            ("at", vector(at + tip)),
        ]),
        Drawn::Plate {
            corners,
            thick,
            cuts,
        } => object([
            (
                "corners",
                corners.iter().map(|at| vector(at + tip)).collect(),
            ),
            ("thick", vector(*thick)),
            ("cuts", (*cuts).into()),
        ]),
    };
    pieces.iter().map(piece).collect()
}

fn vector(vector: V3) -> Value {
    <[f64; 3]>::from(vector).into()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use crate::json::form;
    use serde_json::{Value, json};

    /// What is drawn of a call of CYCLE971 with these errors of the sliders.
    fn drawn(values: Value, errors: Value) -> Value {
        let asked = json!({
            "control": "sinumerik", "cycle": "CYCLE971", "values": values, "predict": true, "errors": errors,
        });
        form(&asked.to_string()).unwrap()
    }

    fn number(value: &Value) -> f64 {
        value.as_f64().unwrap()
    }

    #[test]
    fn tool_and_probe_are_drawn_where_they_are() {
        // oracle: hand: a cylinder of 5 mm with its end at the position; the probe stands 0.2 mm beside its data
        let values = json!({ "_MVAR": "0", "_MA": "1", "_FA": "3", "_TSA": "1" });
        let view = drawn(values, json!({ "part": { "dx": 0.2 } }));
        let trace = &view["outcome"]["trace"];
        assert_eq!(trace["inUse"], json!([[0, 0]]));
        let mill = &trace["tools"][0]["pieces"][0];
        assert_eq!(mill["axis"], json!([0.0, 0.0, 1.0]));
        assert_eq!(mill["at"], json!([0.0, 0.0, 0.0]));
        let outline = mill["outline"].as_array().unwrap();
        assert!(outline.contains(&json!([5.0, 0.0])), "{outline:?}");
        assert_eq!(trace["toolProbes"][0]["errors"]["shift"][0], 0.2);
        let results = view["outcome"]["results"].as_array().unwrap();
        let difference = results.iter().find(|result| result["name"] == "_OVR[9]");
        assert!((number(&difference.unwrap()["value"]) - 0.2).abs() < 1e-9);
    }

    #[test]
    fn a_wider_tool_is_measured_as_wide_as_the_slider_makes_it() {
        // oracle: hand: 5 mm in the data, 0.1 mm more in truth
        let values = json!({ "_MVAR": "1", "_MA": "1", "_ID": "0", "_FA": "3", "_TSA": "1", "_TDIF": "0.9", "_TZL": "0" });
        let view = drawn(values, json!({ "probe": { "radius": 0.1 } }));
        let results = view["outcome"]["results"].as_array().unwrap();
        let radius = results.iter().find(|result| result["name"] == "_OVR[10]");
        assert!((number(&radius.unwrap()["value"]) - 5.1).abs() < 1e-9);
    }

    #[test]
    fn a_longer_tool_is_measured_as_long_as_the_slider_makes_it() {
        // oracle: hand: 70 mm in the data, 0.15 mm more in truth
        let values = json!({ "_MVAR": "1", "_MA": "3", "_ID": "0", "_FA": "3", "_TSA": "1", "_TDIF": "0.9", "_TZL": "0" });
        let view = drawn(values, json!({ "probe": { "skewX": 0.15 } }));
        let results = view["outcome"]["results"].as_array().unwrap();
        let length = results.iter().find(|result| result["name"] == "_OVR[8]");
        assert!((number(&length.unwrap()["value"]) - 70.15).abs() < 1e-9);
    }

    #[test]
    fn a_program_shows_what_it_takes_into_the_turret() {
        // oracle: hand: nothing is in use until T8, a probe (B:974-985); then T1, a turning tool; X counts as a diameter
        let edge = |kind: i64, tip: i64| json!({ "1": { "type": kind, "tip": tip, "length": [60.0, 40.0, 0.0], "radius": 0.8 } });
        let asked = json!({
            "control": "sinumerik", "text": "G18 DIAMON\nT8 D1\nG0 X100 Z50\nT1 D1\nG0 X120 Z60\nM30\n",
            "setup": {
                "control": "sinumerik", "plane": "G18", "probe": { "radius": 3.0, "length": 50.0 },
                "tools": { "8": { "edges": edge(580, 7) }, "1": { "edges": edge(500, 3) } },
                "workpiece": [{ "shape": "turned", "size": [40.0, 60.0, 0.0, 0.0], "at": [0.0, 0.0, 0.0] }],
                "position": [100.0, 0.0, 100.0],
            },
        });
        let mut run = crate::json::Run::new(&asked.to_string()).unwrap();
        while !run.advance(100) {}
        let run = run.view();
        let trace = &run["trace"];
        assert_eq!(trace["turning"], true);
        assert_eq!(trace["drawing"]["reading"]["diameter"], true);
        let shown: Vec<bool> = trace["tools"]
            .as_array()
            .unwrap()
            .iter()
            .map(|tool| tool["ball"].is_array())
            .collect();
        assert_eq!(shown, [true, true, false]);
        let entries = trace["entries"].as_array().unwrap();
        let in_use = trace["inUse"].as_array().unwrap();
        for (change, tool) in in_use[1..].iter().zip([8, 1]) {
            let entry = &entries[change[0].as_u64().unwrap() as usize];
            assert_eq!(
                (&entry["step"], &entry["tool"]),
                (&json!("tool"), &json!(tool))
            );
        }
    }

    #[test]
    fn each_edge_position_brings_its_insert() {
        // oracle: hand: the nose of 2 mm of the tool that the call brings (B:9049) lies at its end in both axes
        let asked = json!({
            "control": "sinumerik", "cycle": "CYCLE972", "predict": true,
            "values": { "_MVAR": "1", "_MA": "1", "_FA": "3", "_TSA": "1", "_TDIF": "0.9", "_TZL": "0" },
            "setup": { "own": { "plane": "G18", "units": "G71" } },
        });
        let view = form(&asked.to_string()).unwrap();
        let tool = &view["outcome"]["trace"]["tools"][0];
        let pieces = tool["pieces"].as_array().unwrap();
        assert_eq!(pieces.len(), 2, "insert and shank");
        let lowest = |piece: &Value, axis: usize| {
            let corners = piece["corners"].as_array().unwrap().iter();
            corners
                .map(|corner| number(&corner[axis]))
                .fold(f64::INFINITY, f64::min)
        };
        for axis in [0, 2] {
            assert!(lowest(&pieces[0], axis).abs() < 0.01, "{pieces:?}");
            assert!(lowest(&pieces[1], axis) > 2.0, "{pieces:?}");
        }
        assert_eq!(
            tool["carrier"].as_array().unwrap().len(),
            2,
            "holder and disc"
        );
    }
}
