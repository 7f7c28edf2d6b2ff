//! How the faces that a program touches lie on the real part: at each touch from where the face should be, along its
//! normal, to where the protocol says that it is.

use crate::app::answer::{Deviates, Values, deviates};
use crate::geometry::{Dir, Mcs};
use crate::machine::Step;
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
        let Deviates { shift, out, across } = deviates(called, &entries, actual);
        for entry in &entries {
            let Step::Touch { point, normal, .. } = &entry.step else { continue };
            let along = axes.map(|axis| dot(&axis, normal));
            let by = (0..3).map(|axis| along[axis] * shift[axis] + along[axis].abs() * across[axis]);
            let by = by.sum::<f64>() + out;
            if by.abs() > SMALLEST {
                all.push(Arrow { call: *call, at: *point, by: *normal * by });
            }
        }
    }
    all
}

fn dot(one: &Dir<Mcs>, other: &Dir<Mcs>) -> f64 {
    one.iter().zip(other.iter()).map(|(one, other)| one * other).sum()
}
