//! How the faces that a program touches lie on the real part: at each touch from where the face should be, along its
//! normal, to where the protocol says that it is.

use crate::app::answer::{Deviates, Values, deviates};
use crate::geometry::{Dir, Mcs, V3};
use crate::machine::{Entry, Step};
use crate::run::Outcome;
use serde::Serialize;
use std::collections::BTreeMap;

/// A face that was touched.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Arrow {
    /// Index of the call.
    pub call: usize,
    /// The point that is touched, machine coordinates, mm.
    pub at: Mcs,
    /// From where the face should be to where it is, machine coordinates, mm.
    pub by: Dir<Mcs>,
}

/// What is smaller is no deviation, mm.
const SMALLEST: f64 = 1e-6;

/// The arrows of all touches of calls that have values. `values`: by the call, of each result.
pub fn arrows(values: &BTreeMap<usize, Values>, outcome: &Outcome) -> Vec<Arrow> {
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let axes = axes.map(|axis| outcome.control.direction_to_machine(Dir::new(axis)));
    let mut all = Vec::new();
    for (call, actual) in values {
        let Some(called) = outcome.called.get(*call) else { continue };
        let (entries, _) = called.entries(outcome);
        let touch = |entry: &Entry| {
            if let Step::Touch { point, normal, .. } = entry.step { Some((point, normal)) } else { None }
        };
        let touches: Vec<(Mcs, Dir<Mcs>)> = entries.iter().filter_map(touch).collect();
        let bodies = deviates(called, &entries, actual);
        let each = touches.len() / bodies.len().max(1);
        if each == 0 || !touches.len().is_multiple_of(bodies.len()) {
            continue; // nobody can tell which touch is whose
        }
        for (body, touches) in bodies.iter().zip(touches.chunks(each)) {
            all.extend(touches.iter().filter_map(|touch| {
                let by = out(body, &axes, touches[0].0, touch);
                (by.abs() > SMALLEST).then(|| Arrow { call: *call, at: touch.0, by: touch.1 * by })
            }));
        }
    }
    all
}

/// By how much the face lies further out at a touch, mm. `axes`: those of the workpiece; `pivot`: about what it turns.
fn out(body: &Deviates, axes: &[Dir<Mcs>; 3], pivot: Mcs, (point, normal): &(Mcs, Dir<Mcs>)) -> f64 {
    let from_pivot = V3::from(*point - pivot);
    let by = |axis: usize| {
        let along = dot(&axes[axis], normal);
        let turned = V3::from(axes[axis]).cross(&from_pivot) * body.turn[axis].to_radians();
        along * body.shift[axis] + along.abs() * body.across[axis] + turned.dot(&V3::from(*normal))
    };
    (0..3).map(by).sum::<f64>() + body.out
}

fn dot(one: &Dir<Mcs>, other: &Dir<Mcs>) -> f64 {
    one.iter().zip(other.iter()).map(|(one, other)| one * other).sum()
}
