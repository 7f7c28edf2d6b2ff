//! What CYCLE976 finds out about a probe, on the simulated machine.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use super::super::directions::{angle, directions, in_plane, turned};
use super::super::params::{BALL, HOLE, SKEW, UNKNOWN};
use super::super::{VARIANTS, propose};
use crate::catalogue::sinumerik::testing::{at, call, called, put, random_parts, run, stopped};
use crate::control::{Control, Frame, Plane, Units};
use crate::dialect::Dialect;
use crate::entry::{Inputs, names};
use crate::geometry::{Degrees, Dir, Rpy};
use crate::machine::sim::Sim;
use crate::machine::{Setup, Stop};
use proptest::prelude::*;

const PLANES: [Plane; 3] = [Plane::G17, Plane::G18, Plane::G19];
const SIZE: f64 = 60.0;

/// A call: ring of 60 mm, or a surface at 20; the axis is 1 to 3, the direction 0 plus, 1 minus.
pub(super) fn inputs(variant: i64, axis: f64, direction: f64) -> Inputs {
    let hole = variant % 10 != 0;
    call(
        "CYCLE976",
        variant,
        &[
            ("_SETVAL", if hole { SIZE } else { 20.0 }),
            ("_MA", axis),
            ("_MD", direction),
            ("_STA1", 30.0),
            ("_FA", 5.0),
            ("_TSA", 4.0),
            ("_TZL", 0.0),
        ],
    )
}

/// A calibrated machine with what the cycle proposes.
pub(super) fn ready(plane: Plane, inputs: &Inputs) -> Setup {
    placed(Setup::calibrated(Dialect::Sinumerik, plane), inputs)
}

fn placed(mut setup: Setup, inputs: &Inputs) -> Setup {
    let proposal = propose::propose(inputs, &setup.control);
    setup.workpiece = proposal.workpiece;
    setup.position = setup.control.to_machine(proposal.start);
    setup
}

pub(super) fn mm(control: &Control, field: usize) -> f64 {
    control.basic_length(&format!("_WP[0,{field}]"))
}

pub(super) fn close(found: f64, expected: f64, what: &str) {
    assert!((found - expected).abs() < 1e-9, "{what} = {found}, expected {expected}");
}

/// A probe and how it is calibrated.
#[derive(Clone, Copy, Debug)]
struct Case {
    radius: f64,
    skew: [f64; 2],
    /// Where the centre stands beside the start, where it may.
    shift: [f64; 2],
    start_angle: f64,
    rotation: f64,
    plane: Plane,
    units: Units,
    axis: usize,
    minus: bool,
}

fn cases() -> impl Strategy<Value = Case> {
    let probe = (2.5..3.5_f64, prop::array::uniform2(-0.4..0.4_f64));
    let part = (prop::array::uniform2(-1.0..1.0_f64), -180.0..180.0_f64, -180.0..180.0_f64);
    let machine = (0..3_usize, any::<bool>(), 0..2_usize, any::<bool>());
    (probe, part, machine).prop_map(|((radius, skew), part, machine)| Case {
        radius,
        skew,
        shift: part.0,
        start_angle: part.1,
        rotation: part.2,
        plane: PLANES[machine.0],
        units: if machine.1 { Units::Inch } else { Units::Metric },
        axis: machine.2,
        minus: machine.3,
    })
}

impl Case {
    /// The probe's skew as abscissa and ordinate of the WCS see it, which is turned.
    fn seen(&self) -> [f64; 2] {
        turned(self.skew, Degrees(self.rotation))
    }

    fn inputs(&self, variant: i64) -> Inputs {
        let minus = f64::from(u8::from(self.minus));
        let mut inputs = inputs(variant, self.axis as f64 + 1.0, minus);
        inputs.numbers.insert(names::STA1, self.start_angle);
        inputs
    }

    /// A machine with this probe, of which is known what the variant does not find out.
    fn setup(&self, inputs: &Inputs) -> Setup {
        let mut setup = Setup::calibrated_in(Dialect::Sinumerik, self.plane, self.units);
        let frame = Frame {
            rotation: Rpy(at(self.plane, [0.0, 0.0, self.rotation])),
            ..Frame::translation([30.0, -20.0, 10.0])
        };
        setup.control.frames.insert(1, frame);
        setup.control.activate(1);
        setup.probe.radius = self.radius;
        setup.probe.skew = self.skew;
        let mut known = turned(self.seen(), angle(inputs));
        let directions = directions(inputs);
        if directions.len() > 1 {
            directions.iter().for_each(|touched| known[touched.axis] = 0.1);
        }
        let per = setup.control.basic_factor();
        for (field, value) in [7, 8].into_iter().zip(in_plane(known, angle(inputs))) {
            setup.control.set(format!("_WP[0,{field}]"), value / per);
        }
        let mut setup = placed(setup, inputs);
        if UNKNOWN.holds(inputs) {
            let [x, y] = self.shift;
            let shift = at(self.plane, [x, y, 0.0]);
            setup.workpiece.solids[0].errors.shift = setup.control.direction_to_machine(Dir::new(shift)).0;
        }
        setup
    }
}

proptest! {
    #![proptest_config(random_parts(VARIANTS.len()))]

    // oracle: hand: the ball switches its radius before the wall, and the spindle stands beside it by the skew
    // (sequence of B:13441-13452 with F1 to F3)
    #[test]
    fn a_hole_tells_ball_and_skew(case in cases()) {
        for variant in VARIANTS {
            let inputs = case.inputs(variant.number);
            if !HOLE.holds(&inputs) {
                continue;
            }
            let setup = case.setup(&inputs);
            let mut sim = Sim::new(&setup);
            prop_assert_eq!(run(&mut sim, &inputs), Ok(()), "{}", variant.number);
            let (control, what) = (&sim.control, variant.number.to_string());
            let skew = turned(case.seen(), angle(&inputs));
            for touched in directions(&inputs) {
                let field = 1 + 2 * touched.axis + usize::from(touched.sign > 0.0);
                let trigger = -touched.sign * case.radius - skew[touched.axis];
                close(mm(control, field), trigger, &what);
                let result = control.number(&format!("_OVR[{}]", 6 + 2 * field));
                close(result * control.active_factor(), trigger, &what);
            }
            close(mm(control, 0), if BALL.holds(&inputs) { 2.0 * case.radius } else { 6.0 }, &what);
            if SKEW.holds(&inputs) {
                close(mm(control, 7), case.seen()[0], &what);
                close(mm(control, 8), case.seen()[1], &what);
            }
            let mut end = setup.position;
            if UNKNOWN.holds(&inputs) {
                let shift = setup.workpiece.solids[0].errors.shift;
                (0..3).for_each(|axis| end[axis] += shift[axis]);
                let per = control.active_factor();
                close(control.number("_OVR[6]") * per, case.shift[0], &what);
                close(control.number("_OVR[7]") * per, case.shift[1], &what);
            }
            (0..3).for_each(|axis| close(sim.position[axis], end[axis], &what));
            prop_assert_eq!(control.spindle, setup.control.spindle);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4))]

    // oracle: hand: the radius before the face, and later by the pre-travel; along the applicate the length counts
    #[test]
    fn a_surface_tells_one_trigger_value(case in cases(), late in 0.0..0.05_f64, axis in 0..3_usize) {
        let case = Case { rotation: 0.0, axis, ..case };
        let inputs = case.inputs(0);
        let mut setup = case.setup(&inputs);
        setup.probe.pre_travel.0 = late;
        setup.probe.stylus = Some(0.0); // a straight one stands in the way of the applicate in plus direction
        let mut sim = Sim::new(&setup);
        prop_assert_eq!(run(&mut sim, &inputs), Ok(()));
        let sign = if case.minus { -1.0 } else { 1.0 };
        let skew = if axis == 2 { 0.0 } else { case.skew[axis] };
        let field = 1 + 2 * axis + usize::from(sign > 0.0);
        let trigger = sign * (late - case.radius) - skew;
        close(mm(&sim.control, field), trigger, "_WP");
        let per = sim.control.active_factor();
        close(sim.control.number(&format!("_OVR[{}]", 6 + 2 * field)) * per, trigger, "_OVR");
        close(sim.control.number(&format!("_OVR[{}]", 7 + 2 * field)) * per, trigger + sign * 3.0, "_OVR");
    }

    // oracle: manual B:5471-5472, B:5579-5583: L1 ends in the middle of the ball, or with _CBIT[14] at its lowest point
    #[test]
    fn the_length_of_the_probe_is_found(
        wrong in -1.9..4.5_f64, wear in -1.0..1.0_f64, plane in 0..3_usize, inch in any::<bool>(), tip in any::<bool>(),
    ) {
        let units = if inch { Units::Inch } else { Units::Metric };
        let mut setup = Setup::calibrated_in(Dialect::Sinumerik, PLANES[plane], units);
        let inputs = inputs(10_000, 3.0, 1.0);
        setup.control.set("_CBIT[14]", f64::from(u8::from(tip)));
        setup.control.set_variable("$TC_DP12[9,1]", wear);
        let mut setup = placed(setup, &inputs);
        let axis = PLANES[plane].axes()[2];
        let believed = setup.control.active_length()[axis];
        setup.probe.length = believed + wrong - if tip { 3.0 } else { 0.0 };
        let mut sim = Sim::new(&setup);
        prop_assert_eq!(run(&mut sim, &inputs), Ok(()));
        close(sim.control.active_length()[axis], believed + wrong, "L1 in use");
        let geometry = sim.control.variable("$TC_DP3[9,1]").unwrap();
        close(geometry, 50.0 + wrong, "geometry");
        close(sim.control.number("_OVR[22]") * sim.control.active_factor(), geometry, "_OVR[22]");
        let trigger = if tip { 0.0 } else { 3.0 };
        close(mm(&sim.control, 5), trigger, "_WP[0,5]");
        // the spindle nose is back at the start, whatever is now believed of the tool
        close(sim.position[axis] + believed + wrong, setup.position[axis] + believed, "nose");
    }
}

/// A ring with things changed, and what the call made of it.
pub(super) fn ring(variant: i64, change: impl Fn(&mut Setup, &mut Inputs)) -> (Sim, Result<(), Stop>) {
    let mut inputs = inputs(variant, 1.0, 0.0);
    let mut setup = ready(Plane::G17, &inputs);
    change(&mut setup, &mut inputs);
    called(&setup, &inputs)
}

#[test]
fn a_skew_that_is_not_known_leaves_the_chord() {
    // oracle: hand: 0.4 beside the middle the wall of 30 mm is met by a ball of 3 mm at sqrt(27² - 0.4²)
    let (sim, outcome) = ring(2101, |setup, _| setup.probe.skew = [0.0, 0.4]);
    assert_eq!(outcome, Ok(()));
    let met = (27.0_f64.powi(2) - 0.4_f64.powi(2)).sqrt();
    close(mm(&sim.control, 2), met - 30.0, "trigger");
    close(mm(&sim.control, 0), 2.0 * (30.0 - met), "ball");
}

#[test]
fn the_skew_of_a_mono_probe_lies_in_its_trigger_values() {
    // oracle: hand: the ball stands 0.2 further in every direction of probing, so that it seems larger by that
    let (sim, outcome) = ring(10_101, |setup, inputs| {
        inputs.numbers.insert(names::PRNUM, 101.0);
        setup.probe.skew = [0.2, 0.0];
    });
    assert_eq!(outcome, Ok(()));
    for (field, value) in [6.4, 3.2, -3.2, 3.2, -3.2].into_iter().enumerate() {
        close(mm(&sim.control, field), value, "_WP");
    }
    close(mm(&sim.control, 7), 0.0, "skew");
    close(mm(&sim.control, 8), 0.0, "skew");
}

#[test]
fn lobes_of_the_probe_show_in_each_direction() {
    // oracle: hand: three lobes of 0.01 are +, -, 0, 0 at 0, 180, 90, 270 degree. The first two look like a skew, with
    // which a wall 27 mm away would have been met 0.01 beside the middle.
    let (sim, outcome) = ring(101, |setup, _| setup.probe.pre_travel = (0.0, 0.01));
    assert_eq!(outcome, Ok(()));
    close(mm(&sim.control, 2), -2.99, "plus abscissa");
    close(mm(&sim.control, 1), 3.01, "minus abscissa");
    let across = 30.0 - 27.0_f64.hypot(0.01);
    close(mm(&sim.control, 4), -across, "plus ordinate");
    close(mm(&sim.control, 3), across, "minus ordinate");
    close(mm(&sim.control, 0), 3.0 + across, "ball");
}

#[test]
fn what_cannot_be_is_an_alarm() {
    // oracle: manual A:15842-15920, B:5241
    let changed = |variant: i64, name: &'static str, value: f64| {
        let change = |_: &mut Setup, inputs: &mut Inputs| put(inputs, name, value);
        stopped(ring(variant, change).1)
    };
    assert_eq!(changed(1, "_FA", 0.0), 61308);
    assert_eq!(changed(1, "_PRNUM", 9.0), 61313);
    assert_eq!(changed(1, "_SETVAL", 48.0), 61301);
    assert_eq!(changed(1, "_SETVAL", 72.0), 61302);
    assert_eq!(changed(0, "_MA", 4.0), 61325);
    assert_eq!(changed(10_000, "_MA", 1.0), 61325);
    let fixed = |variant: i64, probe: f64| {
        stopped(
            ring(variant, |setup, inputs| {
                setup.control.spindle_positions = false;
                inputs.numbers.insert(names::PRNUM, probe);
            })
            .1,
        )
    };
    assert_eq!((fixed(8, 1.0), fixed(8, 101.0)), (61372, 61373));
    let far = ring(10_000, |setup, inputs| {
        inputs.numbers.extend([(names::MA, 3.0), (names::MD, 1.0)]);
        setup.position[2] += 5.5;
    });
    assert_eq!(stopped(far.1), 61301);
    let ended = ring(1001, |setup, _| setup.control.limits.plus[0] = Some(26.0));
    assert_eq!(stopped(ended.1), 61401);
}

#[test]
fn the_length_of_a_lathe_probe_goes_where_it_counts() {
    // oracle: manual B:5468-5471 (the length of the tool axis), B:828, B:4151 (L1 in the ordinate, L2 in the abscissa);
    // hand:
    // a surface 0.2 mm higher makes the probe so much longer, and is found where it was taken for from then on
    for (plane, tip) in [(Plane::G17, 7), (Plane::G19, 8)] {
        let call = inputs(10_000, 3.0, 1.0);
        let mut setup = ready(plane, &call);
        setup.control.set("SD42950", 2.0);
        let place = (setup.control.tool, setup.control.edge);
        let edge = setup.control.edge_of_mut(place.0, place.1).unwrap();
        (edge.kind, edge.tip, edge.length) = (580, tip, [12.3, -4.5, 50.0]);
        setup.workpiece.solids[0].errors.shift = at(plane, [0.0, 0.0, 0.2]);
        let mut sim = Sim::new(&setup);
        for _ in 0..2 {
            assert_eq!(run(&mut sim, &call), Ok(()));
            let edge = sim.control.active_edge().unwrap();
            for (found, expected) in edge.length.into_iter().zip([12.3, -4.5, 50.2]) {
                close(found, expected, "length");
            }
            close(sim.control.number("_OVR[22]"), 50.2, "_OVR[22]");
        }
    }
}
