//! A turned part as a drawing has it: its diameters as they are and as they should be, and those where it was touched.

use super::frames::{UNITS, system};
use crate::catalogue::find;
use crate::control::{Control, Transverse, Units};
use crate::entry::ProbeUse;
use crate::geometry::{Mcs, V3};
use crate::machine::{Setup, Step, Trace};
use crate::run::outcome::Outcome;
use crate::workpiece::{Column, Form, PartErrors, Shape, Solid, Touching};
use serde::Serialize;

/// Axis of the machine in which diameters count.
const TRANSVERSE: usize = 0;
/// Axis of the machine along which its spindle lies.
const SPINDLE: usize = 2;
/// Least part of a direction that counts as along an axis.
const ALONG: f64 = 0.7;

/// What a drawing of the part of a turning machine shows.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Drawing {
    /// Diameters of the part.
    pub diameters: Vec<Diameter>,
    /// Diameters at which the part was touched.
    pub touched: Vec<Touched>,
    /// How the control counts.
    pub reading: Reading,
}

/// A diameter, mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Diameter {
    /// Both ends as it is, machine coordinates.
    pub ends: [[f64; 3]; 2],
    /// Along the axis, away from the part.
    pub out: [f64; 3],
    /// As it should be.
    pub set: f64,
    /// As it is.
    pub real: f64,
}

/// A diameter as the control reads it, mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Touched {
    /// Place of the touch in the trace.
    pub entry: usize,
    /// Diameter.
    pub diameter: f64,
}

/// Where positions count from, machine coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Reading {
    /// Zero, mm.
    pub at: [f64; 3],
    /// Directions.
    pub axes: [[f64; 3]; 3],
    /// Whether X counts as a diameter.
    pub diameter: bool,
    /// Whether lengths count in inches.
    pub inch: bool,
}

/// A drawing at the end of a run: a program says itself how it counts, so that what is active there decides.
pub fn drawing(setup: &Setup, outcome: &Outcome) -> Drawing {
    let diameters: Vec<Diameter> = setup.workpiece.solids.iter().flat_map(diameters).collect();
    let touched = if diameters.is_empty() { Vec::new() } else { touched(&outcome.control, &outcome.trace) };
    Drawing { diameters, touched, reading: reading(&outcome.control) }
}

/// From the zero of the machine where frames are beyond all numbers.
fn reading(control: &Control) -> Reading {
    let (at, axes) = system(control).unwrap_or(([0.0; 3], UNITS));
    let inch = control.active_units == Units::Inch;
    Reading { at, axes, diameter: control.transverse != Transverse::Radius, inch }
}

/// Outside and bore at the front, and at the other end where they differ there.
fn diameters(solid: &Solid) -> Vec<Diameter> {
    let nominal = Form::of(&solid.shape, &PartErrors::default());
    let (Shape::Turned { .. }, Form::Columns(set), Form::Columns(real)) = (&solid.shape, nominal, solid.form()) else {
        return Vec::new();
    };
    let place = solid.place();
    let axis = place.rotation * V3::z();
    if axis[SPINDLE].abs() < ALONG {
        return Vec::new();
    }
    let across = V3::ith(TRANSVERSE, 1.0);
    let across = (across - axis * axis[TRANSVERSE]).try_normalize(0.0).unwrap_or_else(V3::x);
    let mut found = Vec::new();
    for columns in [(set.stands, real.stands), (set.opening, real.opening)] {
        let (Some(Column::Round(set, _)), Some(Column::Round(real, depth))) = columns else { continue };
        for deep in if real.slope == 0.0 { vec![0.0] } else { vec![0.0, depth] } {
            let (set, real) = (2.0 * set.radius, 2.0 * (real.radius + real.slope * deep));
            let front = place.translation.vector - axis * deep;
            let ends = [-0.5, 0.5].map(|half| (front + across * (real * half)).into());
            found.push(Diameter { ends, out: axis.into(), set, real });
        }
    }
    found
}

/// Diameters at which a part was touched, by entry: by where the control was at the signal and the ball as it is.
fn touched(control: &Control, trace: &Trace) -> Vec<Touched> {
    let mut found = Vec::new();
    let mut of_tool = false;
    for other in trace.entries.others() {
        match other.step {
            Step::CallBegin { cycle, .. } => {
                let cycle = find(control.dialect, cycle);
                of_tool = cycle.is_some_and(|cycle| cycle.purpose.probe == ProbeUse::Tool);
            }
            Step::CallEnd => of_tool = false,
            Step::Touch { latched, ball, point, normal, by: Touching::Ball }
                if !of_tool && normal[TRANSVERSE].abs() > ALONG =>
            {
                let seen = V3::from(latched.0) + V3::from(point.0) - V3::from(ball.0);
                let diameter = 2.0 * control.to_workpiece(Mcs(seen.into()))[TRANSVERSE].abs();
                found.push(Touched { entry: other.at, diameter });
            }
            _ => {}
        }
    }
    found
}

/// From the front to the first dimension line, from one to the next, and what the lines at its ends stand out beyond
/// it, which is also the length of an arrow: shares of the size of the scene.
const FIRST: f64 = 0.14;
const NEXT: f64 = 0.12;
pub(super) const OVER: f64 = 0.02;
/// Half of the width of an arrow, share of its length.
const ARROW: f64 = 0.3;

/// Dimension lines before the front of the part, those of small diameters next to it: the diameter, both ends of its
/// dimension line, and its lines: from both ends of the diameter there, then the dimension line with its arrows.
pub fn dimensions(diameters: &[Diameter], size: f64) -> Vec<(Diameter, [V3; 2], Vec<[V3; 2]>)> {
    let level = |diameter: &Diameter| diameter.ends.map(|end| V3::from(end).dot(&V3::from(diameter.out)));
    let front = diameters.iter().flat_map(level).fold(f64::NEG_INFINITY, f64::max);
    let mut sorted = diameters.to_vec();
    sorted.sort_by(|a, b| a.real.total_cmp(&b.real));
    let mut found = Vec::new();
    for (i, diameter) in sorted.into_iter().enumerate() {
        let Diameter { ends, out, .. } = diameter;
        let place = front + (FIRST + i as f64 * NEXT) * size;
        let (ends, out, over) = (ends.map(V3::from), V3::from(out), OVER * size);
        let [low, high] = ends.map(|end| end + out * (place - end.dot(&out)));
        let mut lines = vec![[ends[0], low + out * over], [ends[1], high + out * over]];
        lines.extend(dimension_line([low, high], out, over));
        found.push((diameter, [low, high], lines));
    }
    found
}

/// A dimension line with an arrow at both ends; `aside`: direction in which the arrows open; `arrow`: their length, mm.
pub fn dimension_line([low, high]: [V3; 2], aside: V3, arrow: f64) -> [[V3; 2]; 5] {
    let along = (high - low).try_normalize(0.0).unwrap_or_else(V3::x) * arrow;
    let head = |tip: V3, back: V3, side: f64| [tip, tip + back + aside * (side * ARROW * arrow)];
    let heads = [(high, -along), (low, along)].map(|(tip, back)| [1.0, -1.0].map(|side| head(tip, back, side)));
    let [[a, b], [c, d]] = heads;
    [[low, high], a, b, c, d]
}
