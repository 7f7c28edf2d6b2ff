//! What a mask calculates from its points: the results that it shows, in the WCS that was active while measuring, and
//! what of it goes into the zero offset (B:3009-3674).

use super::evaluate::{self, Flat, Found, Side};
use super::mask::{Mask, Task};
use super::offset::{Correction, Turn, rotary};
use super::stylus::{Stylus, Touch};
use super::values::{ROTATION, Values};
use crate::control::{AXES, Control};
use crate::evaluate::zero_offset::Measured;
use crate::geometry::{Degrees, V3, Wcs};

/// A point of a mask as it was stored.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Point {
    /// A touch along an axis.
    Touch(Touch),
    /// An element that four touches found.
    Element(Found),
}

/// What a measurement came to.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Outcome {
    /// Results by their names, mm or degree, in the order of the mask.
    pub results: Vec<(&'static str, f64)>,
    /// What is written; none: nothing can be.
    pub correction: Option<Correction>,
}

/// Why nothing comes of the points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unfit {
    /// The control raises this alarm.
    Alarm(u32),
    /// It cannot be calculated, as this key says.
    Told(&'static str),
}

/// Two points are one (A:15911).
const SAME_POINTS: Unfit = Unfit::Alarm(61367);
/// Edges or diagonals are parallel (A:15912).
const PARALLEL: Unfit = Unfit::Alarm(61368);
/// There is no circle through the points (A:15857).
const NO_CIRCLE: Unfit = Unfit::Alarm(61316);
/// Both points of an edge lie at one place of the reference axis.
const SAME_PLACE: Unfit = Unfit::Told("jog-same-place");
/// Three points of a plane lie in a line, or the plane stands upright.
const IN_LINE: Unfit = Unfit::Told("jog-in-line");

/// Directions of travel of a corner by its position, 1 to 4 counter-clockwise from the lower left: along the ordinate
/// at P1 and P2, along the abscissa at P3 and P4, outside; inside the other way.
const POSITIONS: [[f64; 2]; 4] = [[1.0, 1.0], [1.0, -1.0], [-1.0, -1.0], [-1.0, 1.0]];

/// How the edges of a corner are touched: the first along the ordinate, the second along the abscissa.
pub fn corner_sides(values: &Values) -> [Side; 2] {
    let position = values.word("pos").parse::<usize>().unwrap_or(1).clamp(1, 4) - 1;
    let turn = if values.word("corner") == "inside" { -1.0 } else { 1.0 };
    let [first, second] = POSITIONS[position];
    [Side { axis: 1, sign: turn * first }, Side { axis: 0, sign: turn * second }]
}

/// The axis X Y Z of a field.
pub fn axis(values: &Values, name: &str) -> usize {
    AXES.iter().position(|axis| *axis == values.word(name)).unwrap_or_default()
}

/// Evaluates the points of a mask.
///
/// # Errors
/// Why they make nothing.
pub fn calculate(
    control: &Control,
    mask: &Mask,
    values: &Values,
    stylus: &Stylus,
    points: &[Point],
) -> Result<Outcome, Unfit> {
    let of = Points { control, values, stylus };
    match (mask.task, points) {
        (Task::Edge, [Point::Touch(touch)]) => Ok(of.edge(touch)),
        (Task::EdgeAngle, [Point::Touch(first), Point::Touch(second)]) => of.edge_angle([first, second]),
        (Task::Distance, [Point::Touch(first), Point::Touch(second)]) => Ok(of.distance([first, second])),
        (Task::Corner, points) => of.corner(points),
        (Task::Element(element), [Point::Element(found)]) => Ok(of.element(element.round, found)),
        (Task::Centres(_), points) => of.centres(points),
        (Task::Plane, points) => of.plane(points),
        _ => Ok(Outcome::default()),
    }
}

struct Points<'a> {
    control: &'a Control,
    values: &'a Values,
    stylus: &'a Stylus,
}

impl Points<'_> {
    /// Puts a set position in an axis X Y Z of what was measured at a point.
    fn place(&self, at: Wcs, set: &[(usize, f64)]) -> Measured {
        let mut measured = Measured::at(at.0);
        for (axis, set) in set {
            measured.put(*axis, *set, at[*axis]);
        }
        measured
    }

    /// A point of the plane at a height, with the set positions of two fields.
    fn in_plane(&self, at: Flat, height: f64, set: [&str; 2]) -> Measured {
        let [abscissa, ordinate, applicate] = self.stylus.plane.axes();
        let mut point = Wcs::default();
        (point[abscissa], point[ordinate], point[applicate]) = (at[0], at[1], height);
        let set = set.map(|name| self.values.number(name));
        self.place(point, &[(abscissa, set[0]), (ordinate, set[1])])
    }

    /// Where the ball was, the surface along the axis of the touch.
    fn touched(&self, touch: &Touch) -> Wcs {
        let mut at = self.stylus.ball(touch);
        at[touch.axis] = self.stylus.surface(touch);
        at
    }

    fn edge(&self, touch: &Touch) -> Outcome {
        let at = self.touched(touch);
        let measured = self.place(at, &[(touch.axis, self.values.number("x0"))]);
        Outcome { results: vec![("meas_x0", at[touch.axis])], correction: Some(Correction::Place(measured)) }
    }

    fn edge_angle(&self, touches: [&Touch; 2]) -> Result<Outcome, Unfit> {
        let (measuring, reference) = (axis(self.values, "axis"), axis(self.values, "ref_axis"));
        let points = touches.map(|touch| [self.stylus.surface(touch), touch.at[reference]]);
        let angle = evaluate::angle(measuring, reference, points).ok_or(SAME_PLACE)?;
        let set = Degrees(self.values.number("spec_angle"));
        let sense = if (reference + 1) % 3 == measuring { 1.0 } else { -1.0 };
        let (sine, cosine) = (angle.radians() * sense).sin_cos();
        let mut along = V3::zeros();
        (along[reference], along[measuring]) = (cosine, sine);
        let turn = Turn::Angle {
            along: along.into(),
            axes: [reference, measuring],
            // a positive angle is right-handed about the third axis, whichever of the two it begins at
            set: set * sense,
            directed: false,
        };
        let about = if sense > 0.0 { [reference, measuring] } else { [measuring, reference] };
        let correction = self.turned(turn, None, angle, set, about);
        Ok(Outcome { results: vec![("alpha", angle.0)], correction: Some(correction) })
    }

    /// Into the rotation, or into the translation of the rotary axis that was chosen.
    fn turned(&self, turn: Turn, at: Option<Measured>, angle: Degrees, set: Degrees, axes: [usize; 2]) -> Correction {
        let chosen = self.values.word("angle_offset");
        match self.control.rotary_axis(chosen).filter(|_| chosen != ROTATION) {
            Some(axis) => rotary(self.control, axis, axes, angle - set),
            None => Correction::Turn(turn, at),
        }
    }

    fn distance(&self, touches: [&Touch; 2]) -> Outcome {
        let [first, second] = touches.map(|touch| self.touched(touch));
        let axis = touches[0].axis;
        let (length, middle) = evaluate::distance(first[axis], second[axis]);
        let mut at: Wcs = Wcs(std::array::from_fn(|axis| (first[axis] + second[axis]) / 2.0));
        at[axis] = middle;
        let measured = self.place(at, &[(axis, self.values.number("x0"))]);
        let results = vec![("meas_l", length), ("meas_x0", middle)];
        Outcome { results, correction: Some(Correction::Place(measured)) }
    }

    fn corner(&self, points: &[Point]) -> Result<Outcome, Unfit> {
        let touches = points.iter().filter_map(|point| match point {
            Point::Touch(touch) => Some(self.stylus.ball(touch)),
            Point::Element(_) => None,
        });
        let balls: Vec<Wcs> = touches.collect();
        let flat: Vec<Flat> = balls.iter().map(|ball| self.stylus.in_plane(*ball)).collect();
        let one = |pair: &[Flat]| matches!(pair, [a, b] if a == b);
        if flat.chunks(2).any(one) {
            return Err(SAME_POINTS);
        }
        let corner = evaluate::corner(&flat, corner_sides(self.values), self.stylus.radius).ok_or(PARALLEL)?;
        let height = balls.first().map_or(0.0, |ball| ball[self.stylus.plane.axes()[2]]);
        let turn = self.in_plane_turn(corner.angle, Degrees(0.0), false);
        let place = self.in_plane(corner.at, height, ["x0", "y0"]);
        let [x, y] = corner.at;
        let results = vec![("meas_x0", x), ("meas_y0", y), ("alpha", corner.angle.0)];
        Ok(Outcome { results, correction: Some(Correction::Turn(turn, Some(place))) })
    }

    /// A turn about the applicate by which a direction of the plane gets a set angle.
    fn in_plane_turn(&self, angle: Degrees, set: Degrees, directed: bool) -> Turn {
        let [abscissa, ordinate, _] = self.stylus.plane.axes();
        let mut along = V3::zeros();
        (along[ordinate], along[abscissa]) = angle.sin_cos();
        Turn::Angle { along: along.into(), axes: [abscissa, ordinate], set, directed }
    }

    fn element(&self, round: bool, found: &Found) -> Outcome {
        let [x, y] = found.centre;
        let mut results = match round {
            true => vec![("diameter", found.size[0])],
            false => vec![("meas_l", found.size[0]), ("meas_w", found.size[1])],
        };
        results.extend([("meas_x0", x), ("meas_y0", y)]);
        let place = self.in_plane(found.centre, found.height, ["x0", "y0"]);
        Outcome { results, correction: Some(Correction::Place(place)) }
    }

    fn centres(&self, points: &[Point]) -> Result<Outcome, Unfit> {
        let elements = points.iter().filter_map(|point| match point {
            Point::Element(found) => Some(found),
            Point::Touch(_) => None,
        });
        let elements: Vec<&Found> = elements.collect();
        let centres: Vec<Flat> = elements.iter().map(|found| found.centre).collect();
        let [first, second, ..] = centres[..] else { return Err(SAME_POINTS) };
        let angle = evaluate::directed(first, second).ok_or(SAME_POINTS)?;
        let at = match centres[..] {
            [_, _] => first,
            [a, b, c] => evaluate::circle([a, b, c]).ok_or(NO_CIRCLE)?,
            [a, b, c, d] => evaluate::diagonals([a, b, c, d]).ok_or(PARALLEL)?,
            _ => return Err(SAME_POINTS),
        };
        let results = vec![("alpha", angle.0), ("meas_x0", at[0]), ("meas_y0", at[1])];
        let height = elements.first().map_or(0.0, |found| found.height);
        let correction = if centres.len() == 2 { self.two(at, height, angle) } else { self.more(at, height, angle) };
        Ok(Outcome { results, correction: Some(correction) })
    }

    /// Two centres: the rotation, on demand with the set place of P1; or a rotary axis.
    fn two(&self, at: Flat, height: f64, angle: Degrees) -> Correction {
        let set = Degrees(self.values.number("spec_angle"));
        let place = (self.values.word("set_p1") == "yes").then(|| self.in_plane(at, height, ["x1", "y1"]));
        let [abscissa, ordinate, _] = self.stylus.plane.axes();
        self.turned(self.in_plane_turn(angle, set, true), place, angle, set, [abscissa, ordinate])
    }

    /// Three and four centres: the place, on demand with the rotation.
    fn more(&self, at: Flat, height: f64, angle: Degrees) -> Correction {
        let place = self.in_plane(at, height, ["x0", "y0"]);
        if self.values.word("angle_offset") != "yes" {
            return Correction::Place(place);
        }
        let set = Degrees(self.values.number("spec_angle"));
        Correction::Turn(self.in_plane_turn(angle, set, true), Some(place))
    }

    fn plane(&self, points: &[Point]) -> Result<Outcome, Unfit> {
        let [Point::Touch(a), Point::Touch(b), Point::Touch(c)] = points else { return Err(SAME_POINTS) };
        let balls = [a, b, c].map(|touch| self.stylus.ball(touch));
        let plane = self.stylus.plane;
        let (normal, tilt) = evaluate::level(plane, balls).ok_or(IN_LINE)?;
        let [abscissa, ordinate, _] = plane.axes();
        let results = vec![("alpha", tilt[abscissa]), ("beta", tilt[ordinate])];
        Ok(Outcome { results, correction: Some(Correction::Turn(Turn::Level(normal), None)) })
    }
}
