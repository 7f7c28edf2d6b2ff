#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]
//! The probe with and without errors of its own.

use super::probe::{Stand, ball_offset, touch};
use super::{Boundary, Feeler, Noise, Obstacle, PartErrors, Probe, Shape, Solid, Workpiece};
use crate::geometry::{Degrees, Dir, Mcs, Rpy};
use crate::machine::ideal_probe;
use proptest::prelude::*;

const DIRECTIONS: [[f64; 2]; 4] = [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]];

fn hole(diameter: f64, errors: PartErrors) -> Workpiece {
    let shape = Shape::Hole { diameter, depth: 20.0 };
    let solid = Solid { shape, at: Mcs::default(), rotation: Rpy::default(), errors };
    Workpiece { solids: vec![solid] }
}

fn block() -> Workpiece {
    let shape = Shape::Block { size: [40.0, 40.0, 20.0] };
    let solid = Solid::new(shape, Mcs::default());
    Workpiece { solids: vec![solid] }
}

/// A probe in G17.
fn upright(probe: &Probe, turned: f64) -> Stand {
    Stand { turned: Degrees(turned), axis: 2, feeler: Feeler::new(probe, Dir::new([0.0, 0.0, 1.0])) }
}

/// In the G17 plane, at the ball height −5.
fn go(part: &Workpiece, probe: &Probe, turned: f64, from: [f64; 2], to: [f64; 2]) -> Option<Obstacle> {
    let point = |p: [f64; 2]| Mcs([p[0], p[1], -5.0]);
    touch(&Boundary::of(part), probe, &upright(probe, turned), point(from), point(to), 300.0, &mut Noise::new(1))
}

// oracle: hand: the block's face is at X = 20, the ball of 3 mm comes from outside
#[test]
fn signal_comes_late() {
    let latched = |probe: &Probe| go(&block(), probe, 0.0, [40.0, 0.0], [0.0, 0.0]).unwrap().stop[0];
    let probe = ideal_probe();
    assert!((latched(&probe) - 23.0).abs() < 1e-12);
    let pre_travel = Probe { pre_travel: (0.01, 0.0), ..probe };
    assert!((latched(&pre_travel) - 22.99).abs() < 1e-12);
    let delay = Probe { delay: 0.002, ..probe };
    assert!((latched(&delay) - 22.99).abs() < 1e-12); // 300 mm/min for 2 ms
    let skew = Probe { skew: [0.5, 0.0], ..probe };
    assert!((latched(&skew) - 22.5).abs() < 1e-12);
}

// oracle: hand: lobes repeat every 120 degree and turn with the probe
#[test]
fn lobes_turn_with_the_probe() {
    let probe = Probe { pre_travel: (0.01, 0.004), ..ideal_probe() };
    let part = hole(50.0, PartErrors::default());
    let late = |turned: f64| go(&part, &probe, turned, [0.0, 0.0], [40.0, 0.0]).unwrap().stop[0] - 22.0;
    assert!((late(0.0) - 0.014).abs() < 1e-12 && (late(120.0) - 0.014).abs() < 1e-12);
    assert!((late(60.0) - 0.006).abs() < 1e-12 && (late(180.0) - 0.006).abs() < 1e-12);
    assert!((late(30.0) - 0.010).abs() < 1e-12);
}

// oracle: definition: the offset turns from abscissa to ordinate of the plane
#[test]
fn skew_turns_with_it() {
    let probe = Probe { skew: [0.3, 0.0], ..ideal_probe() };
    assert_eq!(ball_offset(&probe, Degrees(0.0), 2), [0.3, 0.0, 0.0]);
    assert_eq!(ball_offset(&probe, Degrees(90.0), 2), [0.0, 0.3, 0.0]);
    assert_eq!(ball_offset(&probe, Degrees(0.0), 1), [0.0, 0.0, 0.3]); // G18: abscissa Z
    assert_eq!(ball_offset(&probe, Degrees(90.0), 0), [0.0, 0.0, 0.3]); // G19: ordinate Z
}

// oracle: definition: a signal that would come after the end of the way is none
#[test]
fn no_signal_after_the_end() {
    let probe = Probe { pre_travel: (0.01, 0.0), ..ideal_probe() };
    assert!(go(&block(), &probe, 0.0, [40.0, 0.0], [22.995, 0.0]).is_none());
    assert!(go(&block(), &probe, 0.0, [40.0, 0.0], [22.985, 0.0]).is_some());
    assert!(go(&block(), &probe, 0.0, [40.0, 0.0], [24.0, 0.0]).is_none());
}

// oracle: definition: same seed, same scatter, of the deviation asked for
#[test]
fn scatter_repeats() {
    let probe = Probe { repeatability: (0.001, 5), ..ideal_probe() };
    let series = || {
        let mut noise = Noise::new(probe.repeatability.1);
        let one = |_| {
            let (from, to) = (Mcs([40.0, 0.0, -5.0]), Mcs([0.0, 0.0, -5.0]));
            touch(&Boundary::of(&block()), &probe, &upright(&probe, 0.0), from, to, 300.0, &mut noise).unwrap().stop[0]
                - 23.0
        };
        (0..400).map(one).collect::<Vec<f64>>()
    };
    let values = series();
    assert_eq!(values, series());
    let variance = values.iter().map(|x| x * x).sum::<f64>() / values.len() as f64;
    assert!((variance.sqrt() / 0.001 - 1.0).abs() < 0.15, "{variance}");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    // oracle: definition: two chords through each other's middle give centre and diameter of what was put in
    #[test]
    fn a_shifted_hole_is_recovered(
        x in -4.0..4.0, y in -4.0..4.0, diameter in 20.0..60.0, size in -0.5..0.5, radius in 0.5..4.0
    ) {
        let part = hole(diameter, PartErrors { shift: [x, y, 0.0], size, ..PartErrors::default() });
        let probe = Probe { radius, ..ideal_probe() };
        let mut at = [0.0, 0.0];
        let mut chord = [0.0; 2];
        for _ in 0..2 {
            for axis in [0, 1] {
                let ends = [0, 1].map(|side| {
                    let way = DIRECTIONS[2 * axis + side].map(|part| part * 80.0);
                    let to = [at[0] + way[0], at[1] + way[1]];
                    go(&part, &probe, 0.0, at, to).unwrap().stop[axis]
                });
                at[axis] = (ends[0] + ends[1]) / 2.0;
                chord[axis] = ends[0] - ends[1] + 2.0 * radius;
            }
        }
        prop_assert!((at[0] - x).abs() < 1e-9 && (at[1] - y).abs() < 1e-9, "{at:?}");
        prop_assert!((chord[0] - diameter - size).abs() < 1e-9 && (chord[1] - diameter - size).abs() < 1e-9);
    }
}
