//! A turned part as a drawing has it: its diameters as they are and as they should be, and those where it was touched.

use super::object;
use super::trace::{UNITS, system};
use crate::catalogue::find;
use crate::control::{Control, Transverse};
use crate::entry::ProbeUse;
use crate::geometry::{V3, rigid};
use crate::machine::setup::Setup;
use crate::machine::trace::{Step, Trace};
use crate::run::outcome::Outcome;
use crate::workpiece::feeler::Touching;
use crate::workpiece::{Shape, Solid};
use serde_json::Value;

/// Axis of the machine in which diameters count.
const TRANSVERSE: usize = 0;
/// Axis of the machine along which its spindle lies.
const SPINDLE: usize = 2;
/// Least part of a direction that counts as along an axis.
const ALONG: f64 = 0.7;

/// What a drawing of the part of a turning machine shows. A program says itself how it counts, so that what is in force
/// at its end tells.
pub(super) fn drawing(setup: &Setup, outcome: &Outcome) -> Value {
    let diameters: Vec<Value> = setup.workpiece.solids.iter().flat_map(diameters).collect();
    let touched = match diameters.is_empty() {
        true => Vec::new(),
        false => touched(&outcome.control, &outcome.trace),
    };
    object([("diameters", diameters.into()), ("touched", touched.into()), ("reading", reading(&outcome.control))])
}

/// Where positions count from, and whether those of X are diameters; from the zero of the machine where frames are
/// beyond all numbers.
fn reading(control: &Control) -> Value {
    let (at, axes) = system(control).unwrap_or(([0.0; 3], UNITS));
    object([("at", at.into()), ("axes", axes.into()), ("diameter", (control.transverse != Transverse::Radius).into())])
}

/// Outside and bore at the front, and at the other end where they differ there.
fn diameters(solid: &Solid) -> Vec<Value> {
    let Shape::Turned { diameter, length, bore: [bore, depth] } = solid.shape else {
        return Vec::new();
    };
    let errors = &solid.errors;
    let turn = rigid::rotation(errors.tilt) * rigid::rotation(solid.rotation);
    let axis = turn * V3::z();
    if axis[SPINDLE].abs() < ALONG {
        return Vec::new();
    }
    let front = V3::from(solid.at) + V3::from(errors.shift);
    let mut across = V3::zeros();
    across[TRANSVERSE] = 1.0;
    let across = (across - axis * axis[TRANSVERSE]).try_normalize(0.0).unwrap_or_else(V3::x);
    let dimension = |set: f64, deep: f64| {
        let real = set + errors.size + errors.taper * deep;
        let ends = [-0.5, 0.5].map(|half| vector(front - axis * deep + across * (real * half)));
        object([
            ("ends", ends.into_iter().collect()),
            ("out", vector(axis)),
            ("set", set.into()),
            ("real", real.into()),
        ])
    };
    let mut found = Vec::new();
    for (set, end) in [(diameter, length), (bore, depth)] {
        if set <= 0.0 {
            continue;
        }
        found.push(dimension(set, 0.0));
        if errors.taper != 0.0 {
            found.push(dimension(set, end));
        }
    }
    found
}

/// Diameters at which a part was touched across its axis, by entry: where the control was when the signal came, and the
/// ball as it is.
fn touched(control: &Control, trace: &Trace) -> Vec<Value> {
    let mut found = Vec::new();
    let mut of_tool = false;
    for (index, entry) in trace.entries.iter().enumerate() {
        match &entry.step {
            Step::CallBegin { cycle, .. } => {
                let cycle = find(control.dialect, cycle);
                of_tool = cycle.is_some_and(|cycle| cycle.purpose.probe == ProbeUse::Tool);
            }
            Step::CallEnd => of_tool = false,
            Step::Touch { latched, ball, point, normal, by: Touching::Ball }
                if !of_tool && normal[TRANSVERSE].abs() > ALONG =>
            {
                let seen = V3::from(*latched) + V3::from(*point) - V3::from(*ball);
                let diameter = 2.0 * control.to_workpiece(seen.into())[TRANSVERSE].abs();
                found.push(object([("entry", index.into()), ("diameter", diameter.into())]));
            }
            _ => {}
        }
    }
    found
}

fn vector(vector: V3) -> Value {
    <[f64; 3]>::from(vector).into()
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use crate::json::form;
    use serde_json::{Value, json};

    /// The drawing of a call of CYCLE974 about a part of 45 mm with these errors of the sliders.
    fn drawn(part: Value) -> Value {
        let values = json!({
            "_MVAR": "0", "_MA": "2", "_SETVAL": "45", "_FA": "3", "_TSA": "3", "_TUL": "2", "_TLL": "-2", "_KNUM": "0",
        });
        let asked = json!({
            "control": "sinumerik", "cycle": "CYCLE974", "values": values, "predict": true,
            "setup": { "own": { "plane": "G18", "units": "G71" } }, "errors": { "part": part },
        });
        form(&asked.to_string()).unwrap()["outcome"]["trace"]["drawing"].clone()
    }

    fn close(value: &Value, wanted: f64) {
        assert!((value.as_f64().unwrap() - wanted).abs() < 1e-9, "{value} {wanted}");
    }

    #[test]
    fn a_step_has_its_diameter_and_where_it_was_touched_too() {
        // oracle: hand: 45 mm and 0.2 more; touched at its plus side, 0.1 mm further out by the displacement
        let drawing = drawn(json!({ "size": 0.2, "dx": 0.1 }));
        let [diameter] = &drawing["diameters"].as_array().unwrap()[..] else {
            unreachable!("{drawing}");
        };
        close(&diameter["set"], 45.0);
        close(&diameter["real"], 45.2);
        let [low, high] = [0, 1].map(|end| &diameter["ends"][end][0]);
        close(low, 0.1 - 22.6);
        close(high, 0.1 + 22.6);
        let touched = drawing["touched"].as_array().unwrap();
        assert!(!touched.is_empty());
        for touch in touched {
            close(&touch["diameter"], 45.4);
        }
        assert_eq!(drawing["reading"]["diameter"], true);
    }

    #[test]
    fn a_cone_has_two_diameters() {
        // oracle: hand: 0.01 mm each mm over 60 mm of length
        let drawing = drawn(json!({ "taper": 0.01 }));
        let real = |index: usize| &drawing["diameters"][index]["real"];
        close(real(0), 45.0);
        close(real(1), 45.6);
    }

    #[test]
    fn a_milling_machine_has_no_such_drawing() {
        let asked = json!({
            "control": "sinumerik", "cycle": "CYCLE977", "values": { "_MVAR": "1", "_SETVAL": "40" }, "predict": true,
        });
        let view = form(&asked.to_string()).unwrap();
        assert_eq!(view["outcome"]["trace"]["drawing"], Value::Null);
    }
}
