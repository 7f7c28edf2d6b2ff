//! CYCLE998 drawn: the surface along the offset axis with its points. Of two angles both sections are drawn, beside
//! each other. Short distances are drawn longer than they are, small angles wider, and the workpiece zero stands where
//! the drawing has room.

use super::params::{AT_ANGLE, DIFFERENTIAL, TWO};
use crate::entry::Inputs;
use crate::entry::names;
use crate::picture::figures::{arc, arrow, circle, dimension, line, polygon};
use crate::picture::{Picture, PictureShape, ShapeKind, View};

/// Steepest angle that is drawn, degree.
const STEEP: f64 = 45.0;

/// A way between two points, drawn with the offset axis to the right and the measuring axis up. The first point lies at
/// 0.
struct Leg {
    /// Names of angle and distance.
    fields: [&'static str; 2],
    /// Name of the second point.
    point: &'static str,
    /// Angle of the surface as drawn, counter-clockwise, degree.
    angle: f64,
    /// Safe area as drawn, degree.
    area: f64,
    /// Distance of the points, mm.
    distance: f64,
    /// Measuring path, mm.
    path: f64,
    /// Ball radius, mm.
    ball: f64,
    /// Direction of measuring: 1 up, -1 down.
    direction: f64,
    /// Whether the probe follows the angle from point to point.
    at_angle: bool,
}

impl Leg {
    fn slope(&self) -> f64 {
        self.angle.to_radians().tan()
    }

    /// Height of the surface.
    fn surface(&self, along: f64) -> f64 {
        along * self.slope()
    }

    /// Height of the ball centre where it touches: it meets an oblique surface beside its own axis.
    fn stop(&self, along: f64) -> f64 {
        self.surface(along) - self.direction * self.ball / self.angle.to_radians().cos()
    }

    /// Height of the ball centre before a touch.
    fn start(&self, along: f64) -> f64 {
        let first = self.stop(0.0) - self.direction * self.path;
        if !self.at_angle {
            return first;
        }
        let way = self.angle - self.direction * self.area;
        first + along * way.to_radians().tan()
    }
}

/// The picture.
pub fn picture(inputs: &Inputs) -> Picture {
    if TWO.holds(inputs) {
        return Picture { view: View::Section, shapes: two(inputs) };
    }
    let axes = inputs.integer(names::MA);
    let (offset, measuring) = (axes / 100, axes % 10);
    let view = if offset == 3 || measuring == 3 { View::Section } else { View::Plane };
    let mut shapes = one(inputs, measuring == 3);
    if offset > measuring {
        shapes.iter_mut().for_each(stand);
    }
    Picture { view, shapes }
}

/// Exchanges the axes of the drawing: the offset axis points up.
fn stand(shape: &mut PictureShape) {
    let centres = shape.circle.iter_mut().map(|(centre, _)| centre);
    for [x, y] in shape.points.iter_mut().chain(centres) {
        std::mem::swap(x, y);
    }
}

/// One angle. The probe comes from below in the plane, from above in the applicate, or as `_MD` says.
fn one(inputs: &Inputs, from_above: bool) -> Vec<PictureShape> {
    let distance = inputs.positive(names::ID, 40.0);
    let leg = Leg {
        fields: [names::STA1, names::ID],
        angle: drawn(inputs, names::STA1) * sense(inputs.integer(names::MA)),
        ..leg(inputs, distance, distance, from_above)
    };
    let mut shapes = section(&leg, from_above);
    if DIFFERENTIAL.holds(inputs) {
        let turn = circle(ShapeKind::Axis, [0.0, leg.start(0.0)], leg.ball * 1.8);
        shapes.push(turn.text("180°/0°").of(names::MVAR));
    }
    set_position(inputs, &leg, &mut shapes);
    corrected(inputs, &leg, &mut shapes);
    shapes
}

/// Counter-clockwise about the third axis is counter-clockwise on the paper with some axes, clockwise with others
/// (B:7512-7514).
fn sense(axes: i64) -> f64 {
    match axes {
        103 | 201 | 302 => -1.0,
        _ => 1.0,
    }
}

/// Two angles: about the ordinate from P1 to P2, about the abscissa from P1 to P3 (B:7636-7640).
fn two(inputs: &Inputs) -> Vec<PictureShape> {
    let distances = [names::ID, names::SETV0].map(|name| inputs.positive(name, 40.0));
    let longest = distances[0].max(distances[1]);
    let [first, second] = distances.map(|distance| distance.max(longest * 0.4));
    let second_leg = Leg {
        fields: [names::INCA, names::ID],
        angle: -drawn(inputs, names::INCA),
        ..leg(inputs, first, longest, true)
    };
    let third_leg = Leg {
        fields: [names::STA1, names::SETV0],
        point: "P3",
        angle: drawn(inputs, names::STA1),
        ..leg(inputs, second, longest, true)
    };
    let mut shapes = section(&second_leg, true);
    set_position(inputs, &second_leg, &mut shapes);
    let mut beside = section(&third_leg, true);
    let aside = first + longest * 1.3;
    for shape in &mut beside {
        let centres = shape.circle.iter_mut().map(|(centre, _)| centre);
        for [x, _] in shape.points.iter_mut().chain(centres) {
            *x += aside;
        }
    }
    shapes.extend(beside);
    shapes
}

fn drawn(inputs: &Inputs, angle: &str) -> f64 {
    inputs.number(angle).clamp(-STEEP, STEEP)
}

/// What the ways have in common; `unit`: what short distances are measured by.
fn leg(inputs: &Inputs, distance: f64, unit: f64, from_above: bool) -> Leg {
    let direction = match inputs.given(names::MD) {
        Some(0.0) => 1.0,
        Some(_) => -1.0,
        None if from_above => -1.0,
        None => 1.0,
    };
    Leg {
        fields: [names::STA1, names::ID],
        point: "P2",
        angle: 0.0,
        area: inputs.positive(names::TSA, 2.0).clamp(4.0, 20.0),
        distance,
        path: inputs.positive(names::FA, 2.0).clamp(unit * 0.15, unit * 0.3),
        ball: unit * 0.06,
        direction,
        at_angle: AT_ANGLE.holds(inputs),
    }
}

/// The surface and the two points of a way.
fn section(leg: &Leg, cut: bool) -> Vec<PictureShape> {
    let mut shapes = part(leg, cut);
    angle(leg, &mut shapes);
    let starts = [0.0, leg.distance].map(|along| [along, leg.start(along)]);
    shapes.push(line(ShapeKind::Path, starts.to_vec()).of(names::MVAR));
    touch(leg, 0.0, "P1", &mut shapes);
    touch(leg, leg.distance, leg.point, &mut shapes);
    let [_, distance] = leg.fields;
    let lowest = starts[0][1] * leg.direction;
    let level = lowest.min(starts[1][1] * leg.direction) - leg.ball * 2.5;
    let at = |along: f64| [along, level * leg.direction];
    shapes.push(dimension(distance, at(0.0), at(leg.distance)));
    let aside = -leg.ball * 3.0;
    let ends = [leg.start(0.0), leg.stop(0.0)].map(|height| [aside, height]);
    shapes.push(dimension(names::FA, ends[0], ends[1]));
    shapes
}

/// Material behind the surface.
fn part(leg: &Leg, cut: bool) -> Vec<PictureShape> {
    let (left, right) = ends(leg);
    let depth = leg.direction * leg.ball * 7.0;
    let at = |along: f64| [along, leg.surface(along)];
    let behind = |along: f64| [along, leg.surface(along) + depth];
    let kind = if cut { ShapeKind::Cut } else { ShapeKind::Material };
    let [name, _] = leg.fields;
    vec![
        polygon(kind, vec![at(left), at(right), behind(right), behind(left)]),
        line(ShapeKind::Edge, vec![at(left), at(right)]).of(name),
    ]
}

/// Ends of the drawn surface along the offset axis.
fn ends(leg: &Leg) -> (f64, f64) {
    (-leg.ball * 5.0, leg.distance + leg.ball * 5.0)
}

/// The set angle from the offset axis, with its safe area to both sides.
fn angle(leg: &Leg, shapes: &mut Vec<PictureShape>) {
    let (_, right) = ends(leg);
    let [name, _] = leg.fields;
    let at = |degrees: f64, distance: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        [distance * cos, distance * sin]
    };
    let mut wedge = vec![[0.0; 2]];
    let (low, high) = (leg.angle - leg.area, leg.angle + leg.area);
    wedge.extend(arc([0.0; 2], right, low, high));
    shapes.push(polygon(ShapeKind::Tolerance, wedge).of(names::TSA));
    shapes.push(line(ShapeKind::Axis, vec![[0.0; 2], [right * 1.1, 0.0]]).of(names::MA));
    let sweep = arc([0.0; 2], right * 0.9, 0.0, leg.angle);
    shapes.push(line(ShapeKind::Path, sweep).of(name));
    let label = line(ShapeKind::Label, vec![at(leg.angle / 2.0, right * 1.02)]);
    shapes.push(label.text(name).of(name));
}

/// One touch: start of the measuring block, way, point.
fn touch(leg: &Leg, along: f64, point: &str, shapes: &mut Vec<PictureShape>) {
    let (start, stop) = ([along, leg.start(along)], [along, leg.stop(along)]);
    shapes.push(line(ShapeKind::Path, vec![start, stop]).of(names::FA));
    shapes.push(arrow(ShapeKind::Path, start, stop, leg.ball).of(names::MD));
    shapes.push(circle(ShapeKind::Probe, start, leg.ball).of(names::PRNUM));
    // a ball beside an oblique surface touches it along the normal
    let (sin, cos) = leg.angle.to_radians().sin_cos();
    let reach = leg.direction * leg.ball;
    let contact = [along - reach * sin, stop[1] + reach * cos];
    shapes.push(circle(ShapeKind::Touch, contact, leg.ball * 0.3).of(names::NMSP));
    let behind = [along, leg.surface(along) + leg.direction * leg.ball * 2.0];
    shapes.push(line(ShapeKind::Label, vec![behind]).text(point).of(names::NMSP));
}

/// Where the first point is expected, from the workpiece zero.
fn set_position(inputs: &Inputs, leg: &Leg, shapes: &mut Vec<PictureShape>) {
    if !leg.at_angle {
        return;
    }
    let (left, right) = ends(leg);
    // a positive position lies beyond zero, a negative one before it
    let sign = if inputs.number(names::SETVAL) < 0.0 { 1.0 } else { -1.0 };
    let zero = sign * (leg.ball * 4.0 + leg.path + leg.distance * leg.slope().abs());
    let place = left * 1.2;
    shapes.push(line(ShapeKind::Axis, vec![[place, zero], [right, zero]]).text("0"));
    shapes.push(line(ShapeKind::Axis, vec![[place, 0.0], [0.0, 0.0]]).of(names::SETVAL));
    shapes.push(dimension(names::SETVAL, [place, zero], [place, 0.0]));
}

/// What takes the angle: the rotary table around the part, or the axes that turn with the surface.
fn corrected(inputs: &Inputs, leg: &Leg, shapes: &mut Vec<PictureShape>) {
    let reach = leg.distance * 0.5 + leg.ball * 9.0;
    if inputs.integer(names::RA) > 0 {
        let middle = leg.distance / 2.0;
        let centre = [middle, leg.surface(middle) + leg.direction * leg.ball * 3.5];
        shapes.push(circle(ShapeKind::Axis, centre, reach).of(names::RA));
        return;
    }
    let (sin, cos) = leg.angle.to_radians().sin_cos();
    let size = reach * 0.3;
    for tip in [[cos * size, sin * size], [-sin * size, cos * size]] {
        shapes.push(line(ShapeKind::Axis, vec![[0.0; 2], tip]).of(names::RA));
        shapes.push(arrow(ShapeKind::Axis, [0.0; 2], tip, leg.ball).of(names::RA));
    }
}
