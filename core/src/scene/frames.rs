//! Coordinate systems.

use crate::control::Control;
use crate::geometry::Wcs;
use serde::Serialize;
use std::collections::BTreeSet;

/// A coordinate system, machine coordinates.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "SceneFrame", optional_fields))]
pub struct Frame {
    /// The name of its zero offset; empty: the machine's own.
    pub name: String,
    /// Zero of the frame, mm.
    pub at: [f64; 3],
    /// Directions of the axes.
    pub axes: [[f64; 3]; 3],
    /// `before` and `after` of one that a correction moved.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional, type = "\"before\" | \"after\""))]
    pub moved: Option<&'static str>,
}

/// The directions of the machine.
pub const UNITS: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// The machine's system where it is another one, the active WCS by its zero offset, and what a correction moved.
pub fn frames(before: &Control, after: &Control) -> Vec<Frame> {
    let drawn = |name: &str, control: &Control, moved: Option<&'static str>| {
        let (at, axes) = system(control)?;
        Some(Frame { name: name.to_owned(), at, axes, moved })
    };
    let mut list = Vec::new();
    if before.to_machine(Wcs([0.0; 3])) != [0.0; 3] {
        list.push(Frame { name: String::new(), at: [0.0; 3], axes: UNITS, moved: None });
    }
    let corner = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    for number in shown(before, after) {
        let name = before.make().settable_name(number);
        let (mut old, mut new) = (before.clone(), after.clone());
        if number != before.settable {
            old.activate(number);
        }
        new.activate(number);
        let moves = |point: &[f64; 3]| new.to_machine(Wcs(*point)) != old.to_machine(Wcs(*point));
        let moved = corner.iter().any(moves);
        if moved || [before.settable, after.settable].contains(&number) {
            list.extend(drawn(&name, &old, moved.then_some("before")));
        }
        if moved {
            list.extend(drawn(&name, &new, Some("after")));
        }
    }
    list
}

/// Zero and directions of the active WCS, machine coordinates; none where its frames are beyond all numbers.
pub fn system(control: &Control) -> Option<([f64; 3], [[f64; 3]; 3])> {
    let at = control.to_machine(Wcs([0.0; 3])).0;
    let axes = UNITS.map(|direction| {
        let end = control.to_machine(Wcs(direction));
        [0, 1, 2].map(|i| end[i] - at[i])
    });
    axes.iter().flatten().chain(&at).all(|value| value.is_finite()).then_some((at, axes))
}

/// The zero offset that was active before, then those that are active after or were corrected.
fn shown(before: &Control, after: &Control) -> Vec<usize> {
    let corrected =
        after.frames.iter().filter(|(number, frame)| before.frames.get(number).copied().unwrap_or_default() != **frame);
    let mut others: BTreeSet<usize> = corrected.map(|(number, _)| *number).collect();
    others.insert(after.settable);
    others.remove(&before.settable);
    std::iter::once(before.settable).chain(others).collect()
}
