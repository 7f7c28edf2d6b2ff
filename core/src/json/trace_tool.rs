//! The tool that touches a tool probe, and the probes, as the view draws them.

use super::object;
use super::setup_write::solids;
use crate::catalogue::{ProbeUse, find};
use crate::control::{Control, Plane};
use crate::geometry::V3;
use crate::run::outcome::Outcome;
use crate::run::setup::Setup;
use crate::run::trace::Step;
use crate::workpiece::tool::{Cut, Nose, Tool};
use serde_json::Value;

/// How much of a turning tool behind its nose is drawn, in nose radii.
const SHANK: f64 = 12.0;

/// The caps of the tool probes.
pub(super) fn probes(setup: &Setup) -> Value {
    let caps: Vec<_> = setup
        .tool_probes
        .iter()
        .map(|probe| probe.solid.clone())
        .collect();
    solids(&caps)
}

/// The tool of the first call that touches a tool probe; none where there is no such call. Its outline is turned about the
/// axis, which points from the end to what holds it; `at`: from the position of the machine to its end.
pub(super) fn tool(setup: &Setup, outcome: &Outcome) -> Option<Value> {
    let (number, edge) = in_use(outcome)?;
    let known = |control: &Control| control.edge_of(number, edge).cloned();
    let data = known(&outcome.before).or_else(|| known(&outcome.control))?;
    let nominal = || Tool::nominal(&data, &outcome.before);
    let tool = setup
        .real_tools
        .get(&(number, edge))
        .cloned()
        .unwrap_or_else(nominal);
    let mut control = outcome.before.clone();
    (control.tool, control.edge, control.plane) = (number, edge, outcome.control.plane);
    let tools = control.tools.entry(number).or_default();
    tools.edges.entry(edge).or_insert(data);
    let at = V3::from(tool.error(&control));
    let (outline, axis, end) = match &tool.cut {
        Cut::Cutter(cutter) => {
            let mut axis = V3::zeros();
            // a groove mill reaches from its upper edge towards its end
            axis[control.plane.axes()[cutter.axis.min(2)]] =
                if cutter.disc > 0.0 { -1.0 } else { 1.0 };
            (cutter.outline(), axis, at)
        }
        Cut::Nose(nose) => {
            let side = directed(nose, control.plane);
            let axis = (-side).try_normalize(0.0).unwrap_or_else(V3::z);
            let end = at - side * nose.radius - axis * nose.radius;
            (rounded(nose.radius), axis, end)
        }
    };
    let outline: Value = outline.into_iter().map(Value::from).collect();
    let vector = |vector: V3| Value::from(<[f64; 3]>::from(vector));
    Some(object([
        ("outline", outline),
        ("axis", vector(axis)),
        ("at", vector(end)),
    ]))
}

/// T and D number at the first call of a cycle at a tool probe.
fn in_use(outcome: &Outcome) -> Option<(i64, i64)> {
    let mut tool = (outcome.before.tool, outcome.before.edge);
    for entry in &outcome.trace.entries {
        match &entry.step {
            Step::Tool(number, edge) => tool = (*number, *edge),
            Step::CallBegin { cycle, .. } => {
                let cycle = find(outcome.before.dialect, cycle)?;
                if cycle.purpose.probe == ProbeUse::Tool {
                    return Some(tool);
                }
            }
            _ => {}
        }
    }
    None
}

/// From the centre of a nose to its point P, X Y Z, in nose radii.
fn directed(nose: &Nose, plane: Plane) -> V3 {
    let [abscissa, ordinate, _] = plane.axes();
    let mut side = V3::zeros();
    (side[abscissa], side[ordinate]) = (nose.side[0], nose.side[1]);
    side
}

/// A quarter circle and the shank behind it.
fn rounded(radius: f64) -> Vec<[f64; 2]> {
    let quarter = (0..=6).map(|step| {
        let (sine, cosine) = (15.0 * f64::from(step)).to_radians().sin_cos();
        [radius * sine, radius * (1.0 - cosine)]
    });
    let mut outline: Vec<_> = quarter.collect();
    outline.push([radius, SHANK * radius]);
    outline.push([0.0, SHANK * radius]);
    outline
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
        assert_eq!(trace["tool"]["axis"], json!([0.0, 0.0, 1.0]));
        assert_eq!(trace["tool"]["at"], json!([0.0, 0.0, 0.0]));
        let outline = trace["tool"]["outline"].as_array().unwrap();
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
}
