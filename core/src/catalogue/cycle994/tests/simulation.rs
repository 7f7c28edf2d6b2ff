//! CYCLE994 on the simulated machine: how it moves, what it finds and corrects.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use crate::catalogue::lathe::testing::{inputs, placed, setup};
use crate::catalogue::sinumerik::motion_testing::{MEASURING_FEED, PLANE_FEED};
use crate::catalogue::sinumerik::testing::{alarms, close, motions, run, same, stopped};
use crate::control::{Plane, Transverse, Units};
use crate::entry::{Inputs, names};
use crate::machine::trace::MotionKind::{Measuring, Positioning, Retract};
use crate::machine::{Setup, Sim};
use proptest::prelude::*;

const PLANES: [Plane; 3] = [Plane::G17, Plane::G18, Plane::G19];
/// Border of the zone in the axis in which it is left, mm.
const LEFT: f64 = 60.0;

/// What is measured where.
#[derive(Clone, Copy, Debug)]
struct Case {
    plane: Plane,
    transverse: Transverse,
    /// 0 abscissa, 1 ordinate, 2 applicate.
    axis: usize,
    /// Distance of the points from the zero point, mm.
    radius: f64,
    inside: bool,
}

impl Case {
    /// How much a dimension is of a length in an axis: diameters in X (B:10975).
    fn per(&self, axis: usize) -> f64 {
        match self.plane.axes()[axis] {
            0 => self.transverse.shown(),
            _ => 1.0,
        }
    }

    /// A call with the zone around the outside, or in the inside.
    fn call(&self, variant: f64) -> Inputs {
        let Case { axis, radius, .. } = *self;
        let zone = radius + if self.inside { -9.0 } else { 12.0 };
        let [sza, szo] = match axis {
            0 => [zone * self.per(0), LEFT * self.per(1)],
            _ => [LEFT * self.per(0), zone * self.per(axis)],
        };
        let values = [
            ("_MVAR", variant),
            ("_MA", axis as f64 + 1.0),
            ("_SETVAL", radius * self.per(axis)),
            ("_SZA", sza),
            ("_SZO", szo),
        ];
        inputs("CYCLE994", self.plane, &values)
    }

    /// The call with its machine: the part grown by `size` and moved by `shift` along the measuring axis. Without the
    /// zone nothing stands inside.
    fn ready(&self, zone: bool, size: f64, shift: f64) -> (Setup, Inputs) {
        let call = self.call(if self.inside { 1.0 } else { 2.0 });
        let mut setup = placed(setup(self.plane, self.transverse), &call);
        let part = &mut setup.workpiece.solids[0];
        part.errors.size = size;
        part.errors.shift[self.plane.axes()[self.axis]] = shift;
        if zone {
            return (setup, call);
        }
        setup.workpiece.solids.truncate(1);
        (setup, self.call(2.0))
    }
}

fn cases(radius: f64, transverse: Transverse) -> Vec<Case> {
    let mut all = Vec::new();
    for plane in PLANES {
        for axis in 0..3 {
            for inside in [false, true] {
                all.push(Case { plane, transverse, axis, radius, inside });
            }
        }
    }
    all
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(10))]

    // oracle: hand (the part as it was made)
    #[test]
    fn the_size_is_found_wherever_the_part_stands(
        radius in 25.0..45.0_f64, size in -0.5..0.5_f64, shift in -0.5..0.5_f64, dimension in any::<bool>(),
    ) {
        let transverse = if dimension { Transverse::Diameter } else { Transverse::Radius };
        for case in cases(radius, transverse) {
            for zone in [true, false] {
                if !zone && !case.inside {
                    continue; // outside the way leads around it always
                }
                let (setup, call) = case.ready(zone, size, shift);
                let mut sim = Sim::new(&setup);
                prop_assert_eq!(run(&mut sim, &call), Ok(()), "{:?} {}", case, zone);
                let per = case.per(case.axis);
                let actual = (radius + size / 2.0) * per;
                close(&sim, "_OVR[0]", radius * per);
                close(&sim, &format!("_OVR[{}]", 1 + case.axis), radius * per);
                close(&sim, "_OVR[4]", actual);
                close(&sim, &format!("_OVR[{}]", 5 + case.axis), actual);
                close(&sim, "_OVR[16]", size / 2.0 * per);
                close(&sim, "_OVR[20]", -size / 2.0);
            }
        }
    }
}

/// A diameter of 60 mm in G18, ball 3, `_FA` = 5: outside the block begins at 38 and touches at 33, inside at 22 and
/// 27.
const DIAMETER: Case =
    Case { plane: Plane::G18, transverse: Transverse::Diameter, axis: 1, radius: 30.0, inside: false };

#[test]
fn the_way_leads_around_the_zone_or_straight_through_the_bore() {
    // oracle: manual B:10889-10891 (positive point first), B:11104-11142 (ways, end before the negative point)
    let inner = Case { inside: true, ..DIAMETER };
    for (case, zone, start, touch, border) in [
        (DIAMETER, true, 38.0, 33.0, Some(42.0)),
        (inner, true, 22.0, 27.0, Some(21.0)),
        (inner, false, 22.0, 27.0, None),
    ] {
        let (mut setup, call) = case.ready(zone, 0.0, 0.0);
        setup.control.set("_SPEED[1]", PLANE_FEED);
        let z = 35.0; // 20 mm behind the face, which stands 5 mm before the border
        let mut expected = Vec::new();
        if case.inside {
            // it stands there already
        } else {
            expected.push((Positioning, [z, start, 0.0], PLANE_FEED));
        }
        expected.push((Measuring, [z, touch, 0.0], MEASURING_FEED));
        expected.push((Retract, [z, start, 0.0], PLANE_FEED));
        if let Some(border) = border {
            for place in [[z, border], [LEFT, border], [LEFT, -border], [z, -border]] {
                expected.push((Positioning, [place[0], place[1], 0.0], PLANE_FEED));
            }
        }
        expected.push((Positioning, [z, -start, 0.0], PLANE_FEED));
        expected.push((Measuring, [z, -touch, 0.0], MEASURING_FEED));
        expected.push((Retract, [z, -start, 0.0], PLANE_FEED));
        let mut sim = Sim::new(&setup);
        assert_eq!(run(&mut sim, &call), Ok(()));
        same(&motions(&sim, case.plane, [0.0, 0.0, 250.0]), &expected, &format!("{case:?} {zone}"));
    }
}

#[test]
fn without_its_zone_the_probe_meets_the_pin() {
    // oracle: hand: what stands in the zone is in the way of the same call without it
    for case in cases(30.0, Transverse::Diameter) {
        if case.inside {
            let (setup, _) = case.ready(true, 0.0, 0.0);
            let outcome = run(&mut Sim::new(&setup), &case.call(2.0));
            assert_eq!(stopped(outcome), 61302, "{case:?}");
        }
    }
}

#[test]
fn the_ball_alone_is_enough_with_its_bit() {
    // oracle: manual B:10901-10906, B:13943-13945, hand (the ball of 6 mm switches 0.02 late)
    for case in cases(30.0, Transverse::Diameter) {
        let (mut setup, call) = case.ready(true, 0.3, 0.1);
        setup.probe.pre_travel.0 = 0.02;
        (1..7).for_each(|i| setup.control.set(format!("_WP[0,{i}]"), 0.0));
        setup.control.set("_WP[0,0]", 5.96);
        setup.control.set("_CHBIT[7]", 1.0);
        let mut sim = Sim::new(&setup);
        assert_eq!(run(&mut sim, &call), Ok(()));
        close(&sim, "_OVR[16]", 0.15 * case.per(case.axis));
    }
}

#[test]
fn a_corrected_tool_makes_the_next_part_right() {
    // oracle: manual B:8945-8947, B:11087-11096
    for case in cases(30.0, Transverse::Diameter) {
        let (setup, call) = case.ready(true, 0.4, 0.0);
        let mut sim = Sim::new(&setup);
        assert_eq!(run(&mut sim, &call), Ok(()));
        let name = ["$TC_DP13[7,1]", "$TC_DP12[7,1]", "$TC_DP14[7,1]"][case.axis];
        let longer = sim.control.variable(name).unwrap();
        let (setup, call) = case.ready(true, 0.4 + 2.0 * longer, 0.0);
        let mut sim = Sim::new(&setup);
        assert_eq!(run(&mut sim, &call), Ok(()));
        close(&sim, "_OVR[16]", 0.0);
    }
}

#[test]
fn a_radius_grows_inside_and_shrinks_outside() {
    // oracle: hand: a part that is too large outside was cut with a smaller radius than believed, a bore with a larger
    for inside in [false, true] {
        let case = Case { inside, ..DIAMETER };
        let (setup, mut call) = case.ready(true, 0.4, 0.0);
        call.numbers.insert(names::KNUM, 2001.0);
        let mut sim = Sim::new(&setup);
        assert_eq!(run(&mut sim, &call), Ok(()));
        let grown = sim.control.variable("$TC_DP15[7,1]").unwrap();
        let expected = if inside { 0.2 } else { -0.2 };
        assert!((grown - expected).abs() < 1e-9, "{grown}");
    }
}

#[test]
fn a_repeated_measurement_goes_back_around_the_zone() {
    // oracle: manual B:13572-13574 (four repetitions), hand (two points each time)
    let (mut setup, call) = DIAMETER.ready(true, 3.2, 0.0);
    setup.control.set("_CBIT[0]", 1.0);
    setup.control.set("_CBIT[1]", 1.0);
    let mut sim = Sim::new(&setup);
    assert_eq!(stopped(run(&mut sim, &call)), 61303);
    assert_eq!(alarms(&sim), [62303; 4]);
    let motions = motions(&sim, DIAMETER.plane, [0.0; 3]);
    let touches = motions.iter().filter(|(kind, ..)| *kind == Measuring);
    assert_eq!(touches.count(), 10);
}

#[test]
fn an_inch_machine_finds_the_same() {
    // oracle: self (the same part, measured in the other system; values of the call are mm inside)
    let found = |units: Units| {
        let (metric, call) = DIAMETER.ready(true, 0.5, 0.1);
        let mut start = Setup::turning_in(Plane::G18, units);
        start.control.tools = metric.control.tools.clone();
        let mut start = placed(start, &call);
        start.workpiece.solids[0].errors.size = 0.5;
        let mut sim = Sim::new(&start);
        assert_eq!(run(&mut sim, &call), Ok(()));
        [0, 4, 8, 16, 20].map(|i| sim.control.number(&format!("_OVR[{i}]")) * units.factor())
    };
    for (metric, inch) in found(Units::Metric).iter().zip(found(Units::Inch)) {
        assert!((metric - inch).abs() < 1e-9, "{metric} {inch}");
    }
}

#[test]
fn what_leaves_no_way_is_refused() {
    // oracle: manual B:10932 (the first variant is inside), A:15877 (61334 as in CYCLE977)
    let inner = Case { inside: true, ..DIAMETER };
    let (setup, _) = DIAMETER.ready(true, 0.0, 0.0);
    assert_eq!(stopped(run(&mut Sim::new(&setup), &DIAMETER.call(1.0))), 61307);
    for (case, zone) in [(DIAMETER, 65.0), (inner, 55.0)] {
        let (setup, mut call) = case.ready(true, 0.0, 0.0);
        call.numbers.insert(names::SZO, zone);
        assert_eq!(stopped(run(&mut Sim::new(&setup), &call)), 61334);
    }
}

#[test]
fn y_is_measured_with_the_call_of_x() {
    // oracle: manual B:11001, B:14023-14027: with _CHBIT[19] setpoint and zone of Y are those of X; the zone is left in
    // Z, which is no transverse axis
    for transverse in [Transverse::Radius, Transverse::Diameter, Transverse::AbsoluteDiameter] {
        for inside in [false, true] {
            let x = Case { transverse, inside, ..DIAMETER };
            let like_x = |axis: usize| {
                let mut call = x.call(if inside { 1.0 } else { 2.0 });
                call.numbers.insert(names::MA, axis as f64 + 1.0);
                call.settings.insert("_CHBIT[19]", 1.0);
                let mut setup = setup(x.plane, transverse);
                setup.control.set("_CHBIT[19]", 1.0);
                let mut setup = placed(setup, &call);
                setup.workpiece.solids[0].errors.size = 0.3;
                let mut sim = Sim::new(&setup);
                assert_eq!(run(&mut sim, &call), Ok(()), "{x:?} {axis}");
                sim
            };
            let [x, y] = [1, 2].map(like_x);
            for name in ["_OVR[0]", "_OVR[4]", "_OVR[8]", "_OVR[16]", "_OVR[20]"] {
                close(&y, name, x.control.number(name));
            }
            let [x, y] = [(x, [0, 1, 2]), (y, [0, 2, 1])].map(|(sim, order)| {
                let all = motions(&sim, Plane::G18, [0.0, 0.0, 250.0]);
                let turned = all.into_iter().map(|(kind, to, feed)| (kind, order.map(|axis| to[axis]), feed));
                turned.collect::<Vec<_>>()
            });
            same(&y, &x, &format!("{transverse:?} {inside}"));
        }
    }
}
