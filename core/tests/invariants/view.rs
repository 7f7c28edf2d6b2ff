//! The same machine seen otherwise: its axes renamed, in a looking-glass, or the part standing elsewhere. What a
//! measurement does has to follow.

use super::stand::Stand;
use nalgebra::{Matrix3, Rotation3, Vector3};
use probewright_core::control::{BasicFrames, Control, Frame, Plane, Value};
use probewright_core::geometry::rigid::{angles, rotation};
use probewright_core::geometry::{Degrees, Mcs, Rpy};
use probewright_core::machine::Setup;
use probewright_core::machine::setup::PROBE_TOOL;
use probewright_core::workpiece::{Shape, Solid};
use std::collections::BTreeMap;

/// What names of axes decide, by cycle: in which plane the probe was calibrated (B:13451), and by which angles a frame
/// is turned about its axes one after the other, which a frame counts from Z to X in every plane (B:7338-7342).
const BY_NAME: [(&str, &[&str]); 2] =
    [("CYCLE976", &["_WP[0,9]"]), ("CYCLE998", &["_OVR[21]", "_OVR[22]", "_OVR[23]"])];

/// How it is seen. Indices of axes are X 0, Y 1, Z 2.
#[derive(Clone, Copy, Debug)]
pub enum View {
    /// X is called Y, Y Z and Z X, so often.
    Renamed(usize),
    /// This machine axis counts the other way.
    Reflected(usize),
    /// Zero offset, part and probe turned about this axis, degree, and moved.
    Elsewhere { axis: usize, turn: f64, by: [f64; 3] },
}

impl View {
    /// Directions of the machine as they are seen.
    fn matrix(self) -> Matrix3<f64> {
        match self {
            View::Renamed(times) => {
                let mut matrix = Matrix3::zeros();
                (0..3).for_each(|axis| matrix[((axis + times) % 3, axis)] = 1.0);
                matrix
            }
            View::Reflected(axis) => {
                let mut matrix = Matrix3::identity();
                matrix[(axis, axis)] = -1.0;
                matrix
            }
            View::Elsewhere { axis, turn, .. } => *rotation(Rpy::about(axis, Degrees(turn))).matrix(),
        }
    }

    /// A point of the machine, mm.
    pub fn point(self, point: [f64; 3]) -> [f64; 3] {
        let by = match self {
            View::Elsewhere { by, .. } => by,
            _ => [0.0; 3],
        };
        let seen = self.direction(point);
        std::array::from_fn(|i| seen[i] + by[i])
    }

    fn direction(self, direction: [f64; 3]) -> [f64; 3] {
        (self.matrix() * Vector3::from(direction)).into()
    }

    /// A rotation of the machine, angles as a frame has them.
    fn turn(self, turn: Rpy) -> Rpy {
        let matrix = self.matrix();
        turned(matrix * rotation(turn).matrix() * matrix.transpose())
    }

    /// A frame between two systems that are both seen so.
    fn inner(self, frame: &Frame) -> Frame {
        Frame {
            coarse: self.direction(frame.coarse),
            fine: self.direction(frame.fine),
            rotation: self.turn(frame.rotation),
            mirror: match self {
                View::Renamed(times) => std::array::from_fn(|i| frame.mirror[(i + 3 - times % 3) % 3]),
                _ => frame.mirror,
            },
            ..*frame
        }
    }

    /// The outermost frame, which alone sees the machine.
    fn outer(self, frame: &Frame) -> Frame {
        let turn = *rotation(frame.rotation).matrix();
        match self {
            View::Renamed(_) => self.inner(frame),
            View::Reflected(axis) => {
                let mut seen = self.inner(frame);
                seen.mirror[axis] = !frame.mirror[axis];
                seen
            }
            View::Elsewhere { .. } => Frame {
                coarse: self.point(frame.coarse),
                fine: self.direction(frame.fine),
                rotation: turned(self.matrix() * turn),
                ..*frame
            },
        }
    }

    fn frames(self, frames: &BTreeMap<usize, Frame>) -> BTreeMap<usize, Frame> {
        let seen = |(number, frame): (&usize, &Frame)| (*number, self.within(frame));
        frames.iter().map(seen).collect()
    }

    /// A frame that is not the outermost one.
    fn within(self, frame: &Frame) -> Frame {
        match self {
            View::Renamed(_) => self.inner(frame),
            _ => *frame,
        }
    }

    /// The control of a milling machine.
    pub fn control(self, control: &Control) -> Control {
        let mut seen = control.clone();
        seen.plane = match self {
            View::Renamed(times) => renamed(control.plane, times),
            _ => control.plane,
        };
        seen.frames = self.frames(&control.frames);
        [seen.stored, seen.basic] = [&control.stored, &control.basic].map(|basic| BasicFrames {
            system: self.outer(&basic.system),
            global: self.frames(&basic.global),
            channel: self.frames(&basic.channel),
        });
        seen.active = self.within(&control.active);
        seen.program_frame = self.within(&control.program_frame);
        if let View::Reflected(axis) = self {
            reflect_probe_data(&mut seen, axis);
        }
        seen
    }

    /// Everything that a run starts from.
    pub fn stand(self, stand: &Stand) -> Stand {
        let Stand { setup, inputs } = stand;
        let mut seen = setup.clone();
        seen.control = self.control(&setup.control);
        seen.position = Mcs(self.point(setup.position.0));
        for solid in &mut seen.workpiece.solids {
            *solid = self.solid(solid);
        }
        if let View::Reflected(axis) = self {
            reflect_probe(&mut seen, axis);
        }
        let mut inputs = inputs.clone();
        inputs.plane = seen.control.plane;
        Stand { setup: seen, inputs }
    }

    fn solid(self, solid: &Solid) -> Solid {
        let mut seen = solid.clone();
        let turn = self.matrix() * rotation(solid.rotation).matrix();
        seen.at = Mcs(self.point(solid.at.0));
        seen.errors.shift = self.direction(solid.errors.shift);
        seen.errors.tilt = self.turn(solid.errors.tilt);
        seen.rotation = turned(turn);
        if let View::Reflected(_) = self {
            // a shape is its own image in the plane of its X and Z, but for corners, whose edges change places
            let mut own = Matrix3::from_diagonal(&Vector3::new(1.0, -1.0, 1.0));
            if let Shape::OuterCorner { angle, length, .. } | Shape::InnerCorner { angle, length, .. } = &mut seen.shape
            {
                length.reverse();
                own *= rotation(Rpy::about(2, -*angle)).matrix();
            }
            seen.rotation = turned(turn * own);
        }
        seen
    }
}

fn turned(matrix: Matrix3<f64>) -> Rpy {
    angles(&Rotation3::from_matrix_unchecked(matrix))
}

fn renamed(plane: Plane, times: usize) -> Plane {
    let [abscissa, ..] = plane.axes();
    [Plane::G17, Plane::G19, Plane::G18][(abscissa + times) % 3]
}

/// Trigger points and skew of a probe in a looking-glass: plus is minus with the other sign.
fn reflect_probe_data(control: &mut Control, axis: usize) {
    let axes = control.plane.axes();
    let place = axes.iter().position(|one| *one == axis).unwrap();
    let name = |field: usize| format!("_WP[0,{field}]");
    let [minus, plus, beside] = [1 + 2 * place, 2 + 2 * place, 7 + place].map(|field| control.number(&name(field)));
    for (field, value) in [(1 + 2 * place, -plus), (2 + 2 * place, -minus), (7 + place, -beside)] {
        control.data.insert(name(field), Value::Number(0.0 + value));
    }
}

fn reflect_probe(setup: &mut Setup, axis: usize) {
    assert_eq!(setup.control.tool, PROBE_TOOL);
    let [abscissa, ordinate, _] = setup.control.plane.axes();
    for (index, own) in [abscissa, ordinate].into_iter().enumerate() {
        if own == axis {
            setup.probe.skew[index] = -setup.probe.skew[index];
        }
    }
}

/// What differs between two controls after a call of this cycle; none: nothing.
pub fn differs(cycle: &str, a: &Control, b: &Control, tolerance: f64) -> Option<String> {
    let near = |what: &str, a: f64, b: f64| ((a - b).abs() > tolerance).then(|| format!("{what}: {a} {b}"));
    let frame = |what: String, a: &Frame, b: &Frame| {
        let places = [[0.0; 3], [100.0, 0.0, 0.0], [0.0, 100.0, 0.0], [0.0, 0.0, 100.0]];
        let seen = places.into_iter().flat_map(|point| a.outward(point).into_iter().zip(b.outward(point)));
        let fine = a.fine.into_iter().zip(b.fine);
        seen.chain(fine).find_map(|(one, other)| near(&what, one, other))
    };
    let maps = [
        ("$P_UIFR", &a.frames, &b.frames),
        ("$P_CHBFR", &a.stored.channel, &b.stored.channel),
        ("$P_NCBFR", &a.stored.global, &b.stored.global),
    ];
    for (what, a, b) in maps {
        for number in a.keys().chain(b.keys()) {
            let stored = |map: &BTreeMap<usize, Frame>| map.get(number).copied().unwrap_or_default();
            let differs = frame(format!("{what}[{number}]"), &stored(a), &stored(b));
            if differs.is_some() {
                return differs;
            }
        }
    }
    let single = [("$P_SETFR", &a.stored.system, &b.stored.system), ("active", &a.active, &b.active)];
    let frames = single.into_iter().find_map(|(what, a, b)| frame(what.to_owned(), a, b));
    let numbers = || {
        let by_name = |name: &str| BY_NAME.iter().any(|(own, names)| *own == cycle && names.contains(&name));
        let mut of_both = a.data.iter().filter(|(name, _)| !by_name(name));
        of_both.find_map(|(name, value)| match (value, b.data.get(name)) {
            (Value::Number(one), Some(Value::Number(other))) => near(name, *one, *other),
            (one, other) => (Some(one) != other).then(|| format!("{name}: {one:?} {other:?}")),
        })
    };
    let more = || b.data.keys().find(|name| !a.data.contains_key(name)).cloned();
    let tools = || {
        let mut of_tools = a.variables().filter(|(name, _)| name.starts_with("$TC"));
        of_tools.find_map(|(name, one)| near(&name, one, b.variable(&name)?))
    };
    frames.or_else(numbers).or_else(more).or_else(tools)
}
