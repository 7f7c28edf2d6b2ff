//! The steps of a run in columns: a million of them would be a million objects of the page. Motions are figures, all
//! other steps are told one by one to who asks for them.

use super::Happened;
use crate::machine::{MotionKind, Step};
use crate::run::Outcome;
use crate::scene::Source;
use crate::workpiece::Touching;
use serde::Serialize;
use std::borrow::Cow;

/// One number or three for each step, in order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Columns {
    /// What it is: 0 to 3 a rapid, positioning, measuring or retraction motion, 4 a touch of what measures, 5 another
    /// one, 6 a crash, 7 the begin of a call, 8 its end, 9 anything else.
    pub sorts: Vec<u8>,
    /// Its line of the program from 1; 0: none.
    pub lines: Vec<u32>,
    /// Of a motion: mm/min, 0 rapid traverse.
    pub feeds: Vec<f64>,
    /// Of a motion: X Y Z of its real end.
    pub ends: Vec<f64>,
}

/// See [`Columns::sorts`].
fn sort_of(step: &Step) -> u8 {
    match step {
        Step::Motion { kind: MotionKind::Rapid, .. } => 0,
        Step::Motion { kind: MotionKind::Positioning, .. } => 1,
        Step::Motion { kind: MotionKind::Measuring, .. } => 2,
        Step::Motion { kind: MotionKind::Retract, .. } => 3,
        Step::Touch { by, .. } if Touching::measures(by) => 4,
        Step::Touch { .. } => 5,
        Step::Crash { .. } => 6,
        Step::CallBegin { .. } => 7,
        Step::CallEnd => 8,
        _ => 9,
    }
}

/// All steps of a run.
pub fn columns(source: &Source) -> Columns {
    let entries = &source.outcome.trace.entries;
    let count = entries.len();
    let mut all = Columns {
        sorts: Vec::with_capacity(count),
        lines: Vec::with_capacity(count),
        feeds: Vec::with_capacity(count),
        ends: Vec::with_capacity(3 * count),
    };
    for entry in entries {
        let (feed, end) = match &entry.step {
            Step::Motion { to, feed, .. } => (*feed, to.0),
            _ => (0.0, [0.0; 3]),
        };
        all.sorts.push(sort_of(&entry.step));
        all.lines.push(entry.line.map_or(0, |line| line + 1));
        all.feeds.push(feed);
        all.ends.extend(end);
    }
    all
}

/// The steps that are no motions, in order.
pub fn others(source: &Source) -> impl Iterator<Item = impl Serialize> {
    let Outcome { trace, control, .. } = &source.outcome;
    trace.entries.others().map(|other| Happened::new(Cow::Borrowed(other.step), other.line, control))
}
