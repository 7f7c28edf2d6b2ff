//! Motions along the axes of the plane as a short table, for the tests of the workpiece cycles.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use super::testing::Motion;
use crate::run::trace::MotionKind;

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
