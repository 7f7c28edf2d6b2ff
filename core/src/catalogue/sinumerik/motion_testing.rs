//! Motions along the axes of the plane as a short table, for the tests of the workpiece cycles.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use super::testing::{Motion, motions};
use crate::control::Plane;
use crate::machine::{MotionKind, Sim};

/// `_SPEED[1]` of these tests.
pub const PLANE_FEED: f64 = 1200.0;
/// `_SPEED[2]` of these tests.
pub const DEPTH_FEED: f64 = 700.0;
/// `_FA` = 5 is above 1 (B:2164-2170).
pub const MEASURING_FEED: f64 = 300.0;

/// Ways in the plane from the start: `x22` goes there at the height of the start; `[27]` goes down by the infeed where
/// there is one, measures along the last axis until the spindle stands at 27, returns, and goes up again.
pub fn expand(table: &str, infeed: f64) -> Vec<Motion> {
    let mut here = [0.0; 3];
    let mut axis = 0;
    let mut motions = Vec::new();
    for word in table.split(' ') {
        if let Some(contact) = word.strip_prefix('[') {
            let mut down = here;
            down[2] += infeed;
            let mut touch = down;
            touch[axis] = contact.trim_end_matches(']').parse().unwrap();
            let level = infeed == 0.0;
            motions.extend((!level).then_some((MotionKind::Positioning, down, DEPTH_FEED)));
            motions.push((MotionKind::Measuring, touch, MEASURING_FEED));
            motions.push((MotionKind::Retract, down, PLANE_FEED));
            motions.extend((!level).then_some((MotionKind::Positioning, here, DEPTH_FEED)));
        } else {
            axis = usize::from(word.starts_with('y'));
            here[axis] = word[1..].parse().unwrap();
            motions.push((MotionKind::Positioning, here, PLANE_FEED));
        }
    }
    motions
}

/// A motion as letter and end: `p` positioning in the plane, `d` along the applicate, `m` measuring, `r` and `s` back
/// in the plane and along the applicate.
pub type Lettered = (char, [f64; 3]);

/// Motions of a trace at the feeds of these tests, machine.
pub fn lettered(sim: &Sim, plane: Plane) -> Vec<Lettered> {
    let letter = |(kind, to, feed): Motion| {
        let letter = match kind {
            MotionKind::Positioning if feed == PLANE_FEED => 'p',
            MotionKind::Positioning if feed == DEPTH_FEED => 'd',
            MotionKind::Measuring if feed == MEASURING_FEED => 'm',
            MotionKind::Retract if feed == PLANE_FEED => 'r',
            MotionKind::Retract if feed == DEPTH_FEED => 's',
            _ => '?',
        };
        (letter, to)
    };
    let all = motions(sim, plane, [0.0; 3]);
    all.into_iter().map(letter).collect()
}

/// Motions are those that were expected, to 1e-9 mm.
pub fn same_lettered(found: &[Lettered], wanted: &[Lettered], what: &str) {
    assert_eq!(found.len(), wanted.len(), "{what}: {found:#?}");
    for (is, wanted) in found.iter().zip(wanted) {
        let near = is.1.iter().zip(wanted.1).all(|(a, b)| (a - b).abs() < 1e-9);
        assert!(is.0 == wanted.0 && near, "{what}: {is:?} {wanted:?}");
    }
}
