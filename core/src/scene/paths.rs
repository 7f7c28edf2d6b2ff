//! Motions as straight pieces, and where the probe stands.

use super::tool::Tool;
use crate::geometry::V3;
use crate::machine::{Entries, Entry, MotionKind, Route, Step};

/// Most degrees of an arc that are one straight piece.
const PIECE: f64 = 3.0;

/// A straight piece of a motion, machine coordinates, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Way {
    /// Place of its motion in the trace.
    pub entry: usize,
    /// Kind of that motion.
    pub kind: MotionKind,
    /// From and to.
    pub ends: [[f64; 3]; 2],
    /// Between which parts of its motion it is travelled, 0 to 1.
    pub during: [f64; 2],
}

/// All motions in pieces.
pub fn ways(entries: &Entries) -> impl Iterator<Item = Way> {
    let motions = entries.iter().enumerate().filter_map(|(entry, one)| match one.step {
        Step::Motion { kind, from, to, around, .. } => Some((entry, kind, Route { from, to, around })),
        _ => None,
    });
    motions.flat_map(|(entry, kind, Route { from, to, around })| {
        let count = around.map_or(1, |around| (around.degrees.0.abs() / PIECE).ceil().max(1.0) as usize);
        let mut begin = (0.0, from);
        (1..=count).map(move |piece| {
            let part = piece as f64 / count as f64;
            let end = around.map_or(to, |around| around.at(from, to, part));
            let way = Way { entry, kind, ends: [begin.1.0, end.0], during: [begin.0, part] };
            begin = (part, end);
            way
        })
    })
}

/// Where the centre of the ball is when each entry is done; none where nothing moves. Another length in effect since
/// the last motion is another position, as the axes stand still.
pub fn stands(entries: &Entries, tools: &[Tool]) -> Vec<[f64; 3]> {
    let length = |entry: &Entry| tools.get(entry.in_use).map_or_else(V3::zeros, |tool| V3::from(tool.length));
    let first = entries.iter().find_map(|entry| match &entry.step {
        Step::Motion { from, .. } => Some((V3::from(from.0), length(&entry))),
        _ => None,
    });
    let Some((mut at, mut with)) = first else { return Vec::new() };
    let stand = |entry: Entry| {
        if let Step::Motion { to, .. } = &entry.step {
            (at, with) = (V3::from(to.0), length(&entry));
        }
        (at + with - length(&entry)).into()
    };
    entries.iter().map(stand).collect()
}

/// When each entry begins and the last one ends, s: motions take their time at their feed, all else takes none.
pub fn begins(entries: &Entries) -> Vec<f64> {
    let mut at = 0.0;
    let mut begins = Vec::with_capacity(entries.len() + 1);
    begins.push(at);
    for entry in entries {
        if let Step::Motion { from, to, around, feed, .. } = &entry.step {
            at += Route { from: *from, to: *to, around: *around }.seconds(*feed);
        }
        begins.push(at);
    }
    begins
}
