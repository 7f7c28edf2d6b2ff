//! CYCLE961 on the simulated machine.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use super::lines::{Point, along, unit};
use super::params::PLACES;
use crate::catalogue::place;
use crate::catalogue::sinumerik::testing::{
    at, call, called, close, random_parts, run, setup, stopped,
};
use crate::check::Inputs;
use crate::control::{Control, Frame, Plane, Units};
use crate::run::machine::Sim;
use crate::run::{Setup, Stop};
use crate::workpiece::Shape;
use proptest::prelude::*;

pub(super) const PLANES: [Plane; 3] = [Plane::G17, Plane::G18, Plane::G19];
/// How far the probe stands from both edges, mm.
const BESIDE: f64 = 14.0;

/// A corner as it really is, in the WCS.
#[derive(Clone, Copy, Debug)]
struct Real {
    corner: Point,
    /// Angle of the reference edge to the abscissa, degree.
    edge: f64,
    /// From there to the second edge.
    opening: f64,
}

/// A call, and a machine before the corner of a part or pocket whose edges are `wrong` degree beside the set angles.
#[derive(Clone, Copy, Debug)]
struct Case {
    variant: i64,
    plane: Plane,
    frame: Frame,
    real: Real,
    wrong: [f64; 2],
}

impl Case {
    fn outside(&self) -> bool {
        self.variant % 2 == 0
    }

    fn by_points(&self) -> bool {
        self.variant > 110
    }

    fn ready(&self) -> (Setup, Inputs) {
        let mut setup = setup(self.plane);
        setup.control.set("MD18600", 1.0);
        setup.control.frames.insert(1, self.frame);
        setup.control.activate(1);
        setup.workpiece.solids = vec![self.part(&setup.control)];
        let inputs = self.inputs();
        let middle = unit(self.real.edge + self.real.opening / 2.0);
        let way = BESIDE / (self.real.opening.abs().to_radians() / 2.0).sin();
        let [x, y] = along(
            self.real.corner,
            middle,
            if self.outside() { -way } else { way },
        );
        let height = if self.by_points() { 25.0 } else { -15.0 };
        let start = place::in_plane(&setup.control, [x, y, height]);
        setup.position = setup.control.to_machine(start);
        (setup, inputs)
    }

    fn part(&self, control: &Control) -> crate::workpiece::Solid {
        let Real {
            corner: [x, y],
            edge,
            opening,
        } = self.real;
        let clockwise = (opening < 0.0) != self.mirrored();
        let [along, across] = unit(if clockwise { edge + opening } else { edge });
        let (angle, length) = (opening.abs(), [500.0; 2]);
        let shape = match self.outside() {
            true => Shape::OuterCorner {
                angle,
                length,
                height: 60.0,
            },
            false => Shape::InnerCorner {
                angle,
                length,
                depth: 60.0,
            },
        };
        place::solid(
            control,
            shape,
            [x, y, 0.0],
            [along, across, 0.0],
            [0.0, 0.0, 1.0],
        )
    }

    fn mirrored(&self) -> bool {
        self.frame.mirror != [false; 3]
    }

    /// An angle to the abscissa of the WCS as one to that of the machine.
    fn in_machine(&self, angle: f64) -> f64 {
        let turn = self.frame.rotation[self.plane.axes()[2]];
        turn + if self.mirrored() { -angle } else { angle }
    }

    /// `_STA1` and `_INCA` count in the machine.
    fn inputs(&self) -> Inputs {
        let Real { edge, opening, .. } = self.real;
        let first = self.in_machine(edge + self.wrong[0]);
        let set = [
            first,
            self.in_machine(edge + opening + self.wrong[1]) - first,
        ];
        let mut values = vec![
            ("_STA1", set[0]),
            ("_INCA", set[1]),
            // so far that all places lie before the edges of the sharpest corner too
            ("_SETV[0]", 230.0),
            ("_SETV[1]", 200.0),
            ("_SETV[2]", 7.0),
            ("_SETV[3]", -4.0),
            ("_SETV[4]", 1.0),
            ("_ID", 40.0),
            ("_FA", 2.0),
            ("_KNUM", 1.0),
        ];
        if self.by_points() {
            values.extend([("_ID", -40.0), ("_FA", 45.0)]);
            values.extend(
                PLACES
                    .into_iter()
                    .zip(self.places())
                    .flat_map(|(names, place)| [(names[0], place[0]), (names[1], place[1])]),
            );
        }
        call("CYCLE961", self.variant, &values)
    }

    /// P1 to P4: beside the edges, P2 and P4 as much further away as the angles are wrong.
    fn places(&self) -> [Point; 4] {
        let Real {
            corner,
            edge,
            opening,
        } = self.real;
        let sense = opening.signum() * if self.outside() { -1.0 } else { 1.0 };
        let place = |edge: f64, sense: f64, way: f64, off: f64| {
            along(
                along(corner, unit(edge), way),
                unit(edge + 90.0 * sense),
                off,
            )
        };
        let [first, second] = self
            .wrong
            .map(|wrong| 70.0 * wrong.abs().to_radians().tan());
        [
            place(edge, sense, 80.0, BESIDE),
            place(edge, sense, 150.0, BESIDE + first),
            place(edge + opening, -sense, 80.0, BESIDE),
            place(edge + opening, -sense, 150.0, BESIDE + second),
        ]
    }
}

fn variants() -> impl Strategy<Value = i64> {
    prop::sample::select(vec![105, 106, 107, 108, 117, 118])
}

fn cases() -> impl Strategy<Value = Case> {
    let frame = (prop::array::uniform3(-300.0..300.0_f64), -170.0..170.0_f64);
    let real = (
        prop::array::uniform2(-80.0..80.0_f64),
        -180.0..180.0_f64,
        40.0..150.0_f64,
        any::<bool>(),
    );
    let wrong = prop::array::uniform2(-6.0..6.0_f64);
    (variants(), 0..3_usize, frame, real, wrong).prop_map(
        |(variant, plane, (coarse, turn), (corner, edge, opening, clockwise), wrong)| {
            let plane = PLANES[plane];
            let opening = if variant <= 106 { 90.0 } else { opening };
            Case {
                variant,
                plane,
                frame: Frame {
                    coarse,
                    rotation: at(plane, [0.0, 0.0, turn]),
                    ..Frame::default()
                },
                real: Real {
                    corner,
                    edge,
                    opening: if clockwise { -opening } else { opening },
                },
                // both edges of a rectangle are wrong by the same angle
                wrong: if variant <= 106 { [wrong[0]; 2] } else { wrong },
            }
        },
    )
}

pub(super) fn done(setup: &Setup, inputs: &Inputs) -> Sim {
    let mut sim = Sim::new(setup);
    assert_eq!(run(&mut sim, inputs), Ok(()), "{}", inputs.variant);
    sim
}

/// An angle of the results, which may differ by a whole turn.
pub(super) fn close_angle(sim: &Sim, name: &str, angle: f64) {
    let gone = (sim.control.number(name) - angle + 180.0).rem_euclid(360.0) - 180.0;
    assert!(gone.abs() < 1e-9, "{name}: {gone} beside {angle}");
}

proptest! {
    #![proptest_config(random_parts(1))]

    /// The corner and the direction of the reference edge are found again, in the WCS and in the machine, whatever the
    /// opening, its sense and how wrong the set angles are, in mirrored coordinates too.
    #[test]
    fn the_corner_is_recovered(case in cases(), mirrored in any::<bool>()) {
        let mut case = case;
        case.frame.mirror[case.plane.axes()[1]] = mirrored;
        let (setup, inputs) = case.ready();
        let sim = done(&setup, &inputs);
        // oracle: hand (the part as it was made)
        let Real { corner: [x, y], edge, .. } = case.real;
        let axes = case.plane.axes();
        close_angle(&sim, "_OVR[4]", edge);
        close(&sim, "_OVR[5]", x);
        close(&sim, "_OVR[6]", y);
        let machine = setup.workpiece.solids[0].at;
        close_angle(&sim, "_OVR[20]", case.in_machine(edge));
        close(&sim, "_OVR[21]", machine[axes[0]]);
        close(&sim, "_OVR[22]", machine[axes[1]]);
        for (name, value) in [("_OVI[2]", 961.0), ("_OVI[3]", case.variant as f64), ("_OVI[5]", 1.0), ("_OVI[9]", 0.0)] {
            close(&sim, name, value);
        }
        // manual B:8016, B:8170: back at the start, or over P4 at positioning height
        let end = case.plane.axes().map(|axis| sim.control.to_workpiece(sim.position)[axis]);
        let start = case.plane.axes().map(|axis| setup.control.to_workpiece(setup.position)[axis]);
        let wanted = if case.by_points() {
            let [.., p4] = case.places();
            [p4[0], p4[1], start[2]]
        } else {
            start
        };
        for (is, wanted) in end.iter().zip(wanted) {
            prop_assert!((is - wanted).abs() < 1e-9, "{:?} {:?}", end, wanted);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    /// With the corrected frame the corner is its zero and the reference edge its abscissa, in every frame that can be
    /// corrected; the applicate and its place stay.
    #[test]
    fn the_corner_becomes_the_zero(
        case in cases(), target in prop::sample::select(vec![1, 2, 1011, 2000, 9999]), beside in 1..5_u8,
        mirrored in any::<bool>(),
    ) {
        let mut case = case;
        case.frame.mirror[case.plane.axes()[1]] = mirrored;
        let (mut setup, mut inputs) = case.ready();
        setup.control.frames.insert(2, Frame {
            coarse: [11.0, 22.0, 33.0],
            fine: [0.5, 0.25, 0.125],
            rotation: at(case.plane, [0.0, 0.0, 50.0]),
            ..Frame::default()
        });
        inputs.numbers.insert("_KNUM", f64::from(target));
        if case.variant <= 106 {
            inputs.numbers.insert("_SETV[4]", f64::from(beside));
        }
        let wanted = match (case.variant <= 106, beside) {
            (true, 2) => [-7.0, 0.0],
            (true, 3) => [-7.0, 4.0],
            (true, 4) => [0.0, 4.0],
            _ => [0.0; 2],
        };
        let applicate = case.plane.axes()[2];
        let frames = setup.control.frames.clone();
        setup.control = done(&setup, &inputs).control;
        if target != 9999 {
            setup.control.activate(if target == 2 { 2 } else { 1 });
        }
        let seen = setup.control.to_workpiece(setup.workpiece.solids[0].at);
        let found = case.plane.axes().map(|axis| seen[axis]);
        prop_assert!((found[0] - wanted[0]).abs() < 1e-9 && (found[1] - wanted[1]).abs() < 1e-9, "{:?}", found);
        if let Some(before) = frames.get(&(target as usize)) {
            let corrected = setup.control.frames[&(target as usize)];
            prop_assert_eq!(corrected.fine, [0.0; 3]);
            prop_assert_eq!(corrected.origin()[applicate], before.origin()[applicate]);
        }
        if !case.by_points() {
            let sim = done(&setup, &inputs);
            close_angle(&sim, "_OVR[4]", 0.0);
            close(&sim, "_OVR[5]", wanted[0]);
            close(&sim, "_OVR[6]", wanted[1]);
        }
    }

    /// A ball beside the spindle axis changes nothing once it is calibrated.
    #[test]
    fn a_calibrated_skew_does_not_count(skew in prop::array::uniform2(-0.4..0.4_f64), case in cases()) {
        let case = Case { plane: Plane::G17, frame: Frame::default(), ..case };
        let (mut setup, inputs) = case.ready();
        setup.probe.skew = skew;
        for (axis, skew) in skew.into_iter().enumerate() {
            setup.control.set(format!("_WP[0,{}]", 2 * axis + 1), 3.0 - skew);
            setup.control.set(format!("_WP[0,{}]", 2 * axis + 2), -3.0 - skew);
            setup.control.set(format!("_WP[0,{}]", 7 + axis), skew);
        }
        let sim = done(&setup, &inputs);
        close(&sim, "_OVR[5]", case.real.corner[0]);
        close(&sim, "_OVR[6]", case.real.corner[1]);
        close_angle(&sim, "_OVR[4]", case.real.edge);
    }
}

/// The outside corner of 80 degree with something changed.
fn corner(change: impl Fn(&mut Setup, &mut Inputs)) -> (Sim, Result<(), Stop>) {
    let case = Case {
        variant: 108,
        plane: Plane::G17,
        frame: Frame::default(),
        real: Real {
            corner: [20.0, 10.0],
            edge: -35.0,
            opening: 80.0,
        },
        wrong: [0.0; 2],
    };
    let (mut setup, mut inputs) = case.ready();
    change(&mut setup, &mut inputs);
    called(&setup, &inputs)
}

#[test]
fn without_a_target_nothing_is_corrected() {
    // oracle: manual B:7842
    let (sim, outcome) = corner(|_, inputs| _ = inputs.numbers.insert("_KNUM", 0.0));
    assert_eq!(outcome, Ok(()));
    assert_eq!(sim.control.frames[&1], Frame::default());
    close(&sim, "_OVR[5]", 20.0);
}

#[test]
fn an_inch_machine_finds_the_same_corner() {
    // oracle: self (B:1787-1795)
    let (sim, outcome) = corner(|setup, _| {
        let inch = Setup::calibrated_in(
            crate::catalogue::Dialect::Sinumerik,
            Plane::G17,
            Units::Inch,
        );
        setup.control = inch.control;
    });
    assert_eq!(outcome, Ok(()));
    close(&sim, "_OVR[5]", 20.0 / 25.4);
    close(&sim, "_OVR[22]", 10.0 / 25.4);
    close_angle(&sim, "_OVR[4]", -35.0);
    let frame = sim.control.frames[&1];
    assert!((frame.coarse[0] - 20.0).abs() < 1e-9 && (frame.coarse[1] - 10.0).abs() < 1e-9);
}

#[test]
fn alarms_stop() {
    // oracle: manual A:15842-15922
    let value = |name: &'static str, value: f64| {
        stopped(corner(|_, inputs| _ = inputs.numbers.insert(name, value)).1)
    };
    assert_eq!(value("_KNUM", 100.0), 61321);
    assert_eq!(value("_FA", 0.0), 61308);
    // the way to P2 leads into the part
    assert_eq!(value("_STA1", 5.0), 61302);
    // P4 lies beyond the end of the part
    assert_eq!(value("_SETV[1]", 900.0), 61301);
    let limited = corner(|setup, _| setup.control.limits.plus[1] = Some(-40.0));
    assert_eq!(stopped(limited.1), 61401);
}

#[test]
fn a_measured_corner_may_be_none_though_the_points_make_one() {
    // oracle: manual A:15912-15913, hand: four points of one straight face; a rib that ends before the middle of a face
    let outcome = |variant, blocks: &[([f64; 3], [f64; 3])], places: [Point; 4]| {
        stopped(
            corner(|setup, inputs| {
                let solid = setup.workpiece.solids[0].clone();
                let block = |(size, at): &([f64; 3], [f64; 3])| crate::workpiece::Solid {
                    shape: Shape::Block { size: *size },
                    at: *at,
                    rotation: [0.0; 3],
                    ..solid.clone()
                };
                setup.workpiece.solids = blocks.iter().map(block).collect();
                setup.position = [0.0, -20.0, 25.0];
                inputs.variant = variant;
                inputs.numbers.insert("_ID", -40.0);
                for (names, place) in PLACES.into_iter().zip(places) {
                    inputs
                        .numbers
                        .extend([(names[0], place[0]), (names[1], place[1])]);
                }
            })
            .1,
        )
    };
    let face = ([400.0, 40.0, 60.0], [0.0, 20.0, 0.0]);
    let places = [[0.0, -20.0], [40.0, -22.0], [60.0, -22.0], [100.0, -20.0]];
    assert_eq!(outcome(118, &[face], places), 61368);
    let rib = ([10.0, 80.0, 60.0], [75.0, -55.0, 0.0]);
    let places = [[0.0, -20.0], [100.0, -20.0], [60.0, -30.0], [60.0, -60.0]];
    assert_eq!(outcome(117, &[face, rib], places), 61369);
}
