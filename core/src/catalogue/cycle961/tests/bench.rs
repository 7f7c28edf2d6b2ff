//! Corners of parts and pockets, and calls before them, for the tests of CYCLE961.

#![allow(clippy::expect_used)]

use super::super::lines::{Point, along, unit};
use super::super::params::PLACES;
use crate::catalogue::place;
use crate::catalogue::sinumerik::testing::{at, call, run, setup};
use crate::control::{Control, Frame, Plane};
use crate::entry::Inputs;
use crate::geometry::{Degrees, Rpy, Wcs};
use crate::machine::Setup;
use crate::machine::sim::Sim;
use crate::workpiece::{Shape, Solid};
use proptest::prelude::*;

pub const PLANES: [Plane; 3] = [Plane::G17, Plane::G18, Plane::G19];
/// How far the probe stands from both edges, mm.
const BESIDE: f64 = 14.0;

/// A corner as it really is, in the WCS.
#[derive(Clone, Copy, Debug)]
pub struct Real {
    /// Where it is, mm.
    pub corner: Point,
    /// Reference edge to abscissa, degree.
    pub edge: f64,
    /// From there to the second edge.
    pub opening: f64,
}

/// A call, and a machine before the corner of a part or pocket whose edges are `wrong` degree beside the set angles.
#[derive(Clone, Copy, Debug)]
pub struct Case {
    pub variant: i64,
    pub plane: Plane,
    pub frame: Frame,
    pub real: Real,
    pub wrong: [f64; 2],
}

impl Case {
    fn outside(&self) -> bool {
        self.variant % 2 == 0
    }

    /// Whether places are given, not distances.
    pub fn by_points(&self) -> bool {
        self.variant > 110
    }

    /// The machine before the corner, and the call.
    pub fn ready(&self) -> (Setup, Inputs) {
        let mut setup = setup(self.plane);
        setup.control.set("MD18600", 1.0);
        setup.control.frames.insert(1, self.frame);
        setup.control.activate(1);
        setup.workpiece.solids = vec![self.part(&setup.control)];
        let inputs = self.inputs();
        let middle = unit(self.real.edge + self.real.opening / 2.0);
        let way = BESIDE / (self.real.opening.abs().to_radians() / 2.0).sin();
        let [x, y] = along(self.real.corner, middle, if self.outside() { -way } else { way });
        let height = if self.by_points() { 25.0 } else { -15.0 };
        let start = place::in_plane(&setup.control, [x, y, height]);
        setup.position = setup.control.to_machine(Wcs(start));
        (setup, inputs)
    }

    fn part(&self, control: &Control) -> Solid {
        let Real { corner: [x, y], edge, opening } = self.real;
        let clockwise = (opening < 0.0) != self.mirrored();
        let [along, across] = unit(if clockwise { edge + opening } else { edge });
        let (angle, length) = (Degrees(opening.abs()), [500.0; 2]);
        let shape = match self.outside() {
            true => Shape::OuterCorner { angle, length, height: 60.0 },
            false => Shape::InnerCorner { angle, length, depth: 60.0 },
        };
        place::solid(control, shape, [x, y, 0.0], [along, across, 0.0], [0.0, 0.0, 1.0])
    }

    fn mirrored(&self) -> bool {
        self.frame.mirror != [false; 3]
    }

    /// An angle to the abscissa of the WCS as one to that of the machine.
    pub fn in_machine(&self, angle: f64) -> f64 {
        let turn = self.frame.rotation[self.plane.axes()[2]];
        turn + if self.mirrored() { -angle } else { angle }
    }

    /// `_STA1` and `_INCA` count in the machine.
    fn inputs(&self) -> Inputs {
        let Real { edge, opening, .. } = self.real;
        let first = self.in_machine(edge + self.wrong[0]);
        let set = [first, self.in_machine(edge + opening + self.wrong[1]) - first];
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
                    .flat_map(|(names, place)| [(names[0].as_str(), place[0]), (names[1].as_str(), place[1])]),
            );
        }
        call("CYCLE961", self.variant, &values)
    }

    /// P1 to P4: beside the edges, P2 and P4 as much further away as the angles are wrong.
    pub fn places(&self) -> [Point; 4] {
        let Real { corner, edge, opening } = self.real;
        let sense = opening.signum() * if self.outside() { -1.0 } else { 1.0 };
        let place = |edge: f64, sense: f64, way: f64, off: f64| {
            along(along(corner, unit(edge), way), unit(edge + 90.0 * sense), off)
        };
        let [first, second] = self.wrong.map(|wrong| 70.0 * wrong.abs().to_radians().tan());
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

/// Any of them.
pub fn cases() -> impl Strategy<Value = Case> {
    let frame = (prop::array::uniform3(-300.0..300.0_f64), -170.0..170.0_f64);
    let real = (prop::array::uniform2(-80.0..80.0_f64), -180.0..180.0_f64, 40.0..150.0_f64, any::<bool>());
    let wrong = prop::array::uniform2(-6.0..6.0_f64);
    (variants(), 0..3_usize, frame, real, wrong).prop_map(
        |(variant, plane, (coarse, turn), (corner, edge, opening, clockwise), wrong)| {
            let plane = PLANES[plane];
            let opening = if variant <= 106 { 90.0 } else { opening };
            Case {
                variant,
                plane,
                frame: Frame { coarse, rotation: Rpy(at(plane, [0.0, 0.0, turn])), ..Frame::default() },
                real: Real { corner, edge, opening: if clockwise { -opening } else { opening } },
                // both edges of a rectangle are wrong by the same angle
                wrong: if variant <= 106 { [wrong[0]; 2] } else { wrong },
            }
        },
    )
}

/// The machine after the call, which does not stop.
pub fn done(setup: &Setup, inputs: &Inputs) -> Sim {
    let mut sim = Sim::new(setup);
    assert_eq!(run(&mut sim, inputs), Ok(()), "{}", inputs.variant);
    sim
}

/// An angle of the results, which may differ by a whole turn.
pub fn close_angle(sim: &Sim, name: &str, angle: f64) {
    let gone = (sim.control.number(name) - angle + 180.0).rem_euclid(360.0) - 180.0;
    assert!(gone.abs() < 1e-9, "{name}: {gone} beside {angle}");
}
