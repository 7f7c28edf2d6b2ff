//! What a setup file may ask for: a machine, a probe and a part that can exist, and names that the control knows.

mod solid;

pub(super) use solid::solid;

use super::Error;
use crate::control::nct_data;
use crate::control::{Control, Frame, Value, gud};
use crate::dialect::Dialect;
use crate::geometry::FARTHEST;
use crate::machine::setup::Setup;
use crate::support::FORMS;
use crate::workpiece::Probe;
use crate::workpiece::seen::Turret;

/// Largest length, angle or feed.
const LIMIT: f64 = FARTHEST;
/// Largest number of a datum: that of the control's own numbers, which units can still be applied to.
const LARGEST: f64 = 1e300;
/// Most solids of a part; every motion is held against each.
const SOLIDS: usize = 50;

/// Refuses what cannot be; the first thing found is named with its value.
pub(super) fn check(setup: &Setup) -> Result<(), Error> {
    control(&setup.control)?;
    small("position", &setup.position)?;
    let Turret { diameter, width } = setup.turret;
    for size in [diameter, width] {
        let holds = (0.0..=LIMIT).contains(&size);
        bound("machine.turret", size, holds, "0 to 1000000 mm")?;
    }
    exists(setup)
}

/// Refuses a probe, tools, tool probes and a part that cannot exist.
pub(super) fn exists(setup: &Setup) -> Result<(), Error> {
    probe(&setup.probe)?;
    super::setup_tool::check(setup)?;
    let solids = &setup.workpiece.solids;
    bound("workpiece", solids.len() as f64, solids.len() <= SOLIDS, "at most 50 solids")?;
    for (number, one) in solids.iter().enumerate() {
        solid(&format!("workpiece[{number}]"), one)?;
    }
    Ok(())
}

fn control(control: &Control) -> Result<(), Error> {
    for (number, frame) in &control.frames {
        self::frame(&super::setup_frame::settable_name(control, *number), frame)?;
    }
    for (store, frames) in [("$P_CHBFR", &control.channel_basic), ("$P_NCBFR", &control.global_basic)] {
        for (number, frame) in frames {
            bound(store, *number as f64, *number < 16, "numbers 0 to 15")?;
            self::frame(&format!("{store}[{number}]"), frame)?;
        }
    }
    frame("$P_SETFR", &control.system)?;
    for (number, tool) in &control.tools {
        for (edge, data) in &tool.edges {
            let what = format!("tools {number}, edge {edge}");
            small(&what, &data.length)?;
            small(&what, &data.length_wear)?;
            small(&what, &[data.radius, data.radius_wear])?;
            for offsets in data.additive.values().chain(data.setup.values()) {
                small(&what, offsets)?;
            }
        }
    }
    small("active.spindle", &[control.spindle])?;
    small("active.rotary", &control.rotary)?;
    small("machine.rotaryCentre", &control.rotary_centre)?;
    in_spindle(control)?;
    control.data.iter().try_for_each(|(name, value)| datum(control.dialect, name, value))
}

/// The tool and the edge that are said to be active are there; an NCT register always is.
fn in_spindle(control: &Control) -> Result<(), Error> {
    let (tool, edge) = (control.tool, control.edge);
    let there = match (tool, edge) {
        (0, _) => true,
        (_, 0) => control.tools.contains_key(&tool),
        _ => control.edge_of(tool, edge).is_some(),
    };
    if there || control.dialect == Dialect::Nct {
        return Ok(());
    }
    Err(unknown("active tool and edge", &format!("T{tool} D{edge}")))
}

/// User data, R parameters and # variables must exist, and hold what they are given.
fn datum(dialect: Dialect, name: &str, value: &Value) -> Result<(), Error> {
    if let Value::Number(number) = value {
        let holds = number.abs() <= LARGEST;
        bound(name, *number, holds, "-1E300 to 1E300")?;
    }
    let numbered = |letter: char, most: usize| {
        let number = name.strip_prefix(letter).and_then(|digits| digits.parse::<usize>().ok());
        number.is_some_and(|number| number < most)
    };
    let text = matches!(value, Value::Text(_));
    let known = match dialect {
        Dialect::Nct => (numbered('#', 10_000) || nct_data::find(name).is_some()) && !text,
        Dialect::Sinumerik if name.starts_with('_') || name.starts_with("E_") => {
            gud::named(name).is_some_and(|gud| gud.text() == text)
        }
        Dialect::Sinumerik if name == FORMS => !text,
        Dialect::Sinumerik => {
            numbered('R', 1000) && !text || ["MD", "SD", "TOOLENV["].iter().any(|start| name.starts_with(start))
        }
    };
    if known { Ok(()) } else { Err(unknown("datum, or not of this type", name)) }
}

fn frame(name: &str, frame: &Frame) -> Result<(), Error> {
    let (rotary, fine) = (&frame.rotary, &frame.rotary_fine);
    for values in [&frame.coarse, &frame.fine, &frame.rotation, rotary, fine] {
        small(&format!("frames {name}"), values)?;
    }
    Ok(())
}

fn probe(probe: &Probe) -> Result<(), Error> {
    bound("probe.radius", probe.radius, probe.radius > 0.0 && probe.radius <= LIMIT, "more than 0")?;
    let scatter = probe.repeatability.0;
    bound("probe.repeatability", scatter, (0.0..=1.0).contains(&scatter), "0 to 1 mm")?;
    let positive = |name: &str, length: f64| {
        let holds = length > 0.0 && length <= LIMIT;
        bound(name, length, holds, "more than 0")
    };
    if let Some(radius) = probe.stylus {
        let holds = (0.0..=LIMIT).contains(&radius);
        bound("probe.stylus", radius, holds, "0 or more")?;
    }
    if let Some(body) = &probe.body {
        positive("probe.body.radius", body.radius)?;
        positive("probe.body.distance", body.distance)?;
    }
    small("probe.length", &[probe.length])?;
    small("probe.skew", &probe.skew)?;
    small("probe.preTravel", &[probe.pre_travel.0, probe.pre_travel.1])?;
    small("probe.delay", &[probe.delay])
}

/// Lengths, angles or times that can be reckoned with.
pub(super) fn small(what: &str, values: &[f64]) -> Result<(), Error> {
    values.iter().try_for_each(|value| bound(what, *value, value.abs() <= LIMIT, "-1000000 to 1000000"))
}

/// Refuses a value that does not hold, with what is allowed.
pub(super) fn bound(what: &str, value: f64, holds: bool, allowed: &'static str) -> Result<(), Error> {
    if holds {
        return Ok(());
    }
    Err(Error::Bound { what: what.to_owned(), value, allowed })
}

fn unknown(what: &'static str, name: &str) -> Error {
    Error::Unknown { what, name: crate::message::printable(name) }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::panic)]
    use serde_json::{Value, json};

    fn example() -> Value {
        serde_json::from_str(include_str!("../../../docs/setup.example.json")).unwrap()
    }

    fn refused(path: &str, value: Value) -> String {
        let mut file = example();
        *file.pointer_mut(path).unwrap() = value;
        match crate::json::setup_from_json(&file.to_string()) {
            Ok(_) => String::new(),
            Err(error) => error.to_string(),
        }
    }

    // oracle: hand
    #[test]
    fn a_bore_lies_within_its_part() {
        let turned = |size: [f64; 4]| {
            let part = json!({ "shape": "turned", "size": size, "at": [0, 0, 0] });
            refused("/workpiece/0", part)
        };
        assert_eq!(turned([60.0, 80.0, 0.0, 0.0]), "");
        assert_eq!(turned([60.0, 80.0, 40.0, 30.0]), "");
        for size in [[60.0, 80.0, 60.0, 30.0], [60.0, 80.0, 40.0, 80.0], [60.0, 80.0, 40.0, 0.0]] {
            assert!(turned(size).contains("bore"), "{size:?}");
        }
        assert!(turned([60.0, 80.0, -40.0, 30.0]).contains("workpiece[0].size"));
    }

    // oracle: hand
    #[test]
    fn what_cannot_be_is_refused_by_name() {
        let solid = example()["workpiece"][0].clone();
        for (path, value, told) in [
            ("/probe/radius", json!(0), "probe.radius"),
            ("/workpiece/0/shape", json!("surface"), "Surface"),
            (
                "/workpiece/0",
                json!({ "shape": "hole", "size": [1, 1], "at": [0, 0, 0], "surface": { "triangles": [] } }),
                "Hole",
            ),
            (
                "/workpiece/0",
                json!({ "shape": "surface", "at": [0, 0, 0], "surface": { "triangles": [] } }),
                "no triangles",
            ),
            (
                "/workpiece/0",
                json!({ "shape": "surface", "at": [0, 0, 0], "surface": { "heights": { "columns": 0, "step": [1, 1],
                    "values": [] } } }),
                "grid",
            ),
            (
                "/workpiece/0",
                json!({ "shape": "surface", "at": [0, 0, 0], "surface": { "example": { "name": "moon", "size": [1, 1,
                    1] } } }),
                "moon",
            ),
            (
                "/workpiece/0",
                json!({ "shape": "surface", "at": [0, 0, 0], "surface": { "example": { "name": "dome", "size": [1, 0,
                    1] } } }),
                "surface.size",
            ),
            ("/probe/radius", json!(-3), "probe.radius"),
            ("/probe/length", json!(1e300), "probe.length"),
            ("/position", json!([0, 1e7, 0]), "position"),
            ("/frames/G54/coarse", json!([1e308, 0, 0]), "G54"),
            ("/frames", json!({ "$P_CHBFR[16]": { "coarse": [0, 0, 0] } }), "$P_CHBFR"),
            ("/frames", json!({ "G999": { "coarse": [0, 0, 0] } }), "G999"),
            ("/tools/20/edges/1/radius", json!(-1e9), "tools 20, edge 1"),
            ("/active/tool", json!(77), "T77 D1"),
            ("/active/edge", json!(5), "T9 D5"),
            ("/data", json!({ "_NOTHING": 1 }), "_NOTHING"),
            ("/data", json!({ "_WP[0]": 1 }), "_WP[0]"),
            ("/data", json!({ "_WP[99,0]": 1 }), "_WP[99,0]"),
            ("/data", json!({ "R1000": 1 }), "R1000"),
            ("/data", json!({ "_FA": "wide" }), "_FA"),
            ("/data", json!({ "": 1 }), "datum"),
            ("/workpiece", json!(vec![solid; 51]), "51"),
            ("/workpiece/0/size", json!([0, 40]), "workpiece[0].size"),
            ("/workpiece/0/size", json!([132, -40]), "workpiece[0].size"),
            ("/workpiece/0/errors", json!({ "size": -200 }), "-68"),
            ("/workpiece/0/errors", json!({ "taper": -10 }), "bottom"),
            ("/workpiece/0/errors", json!({ "outOfRound": [0.1, 4_294_967_295_u32] }), "lobes"),
            ("/workpiece/0/errors", json!({ "outOfRound": [70, 3] }), "amplitude"),
            ("/workpiece/0/errors", json!({ "tilt": [0, 1e300, 0] }), "tilt"),
        ] {
            let error = refused(path, value.clone());
            assert!(error.contains(told), "{path} {value}: {error:?}");
        }
    }

    // oracle: hand
    #[test]
    fn what_can_be_is_taken() {
        for (path, value) in [
            ("/data", json!({ "_WP[98,10]": 1, "R999": 2, "MD18600": 0, "_TNAME": "MILL", "_PROTNAME[1]": "LOG" })),
            ("/data", json!({ "TOOLENV[ENV,T]": 20 })),
            ("/active", json!({ "tool": 0, "edge": 0 })),
            ("/workpiece/0/errors", json!({ "outOfRound": [0.1, 5], "size": -1, "taper": 0.01 })),
            (
                "/workpiece/0",
                json!({ "shape": "surface", "at": [0, 0, 0], "surface": { "example": { "name": "dome", "size": [60, 40,
                    10] } } }),
            ),
        ] {
            assert_eq!(refused(path, value.clone()), "", "{path} {value}");
        }
    }
}
