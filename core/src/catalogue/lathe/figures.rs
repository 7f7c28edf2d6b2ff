//! Figures of turned parts and of the probe that touches them: abscissa (G18: Z) to the right, ordinate (X) up. Parts
//! are drawn in one size; short distances are drawn longer than they are.

use crate::control::variables::AXES;
use crate::entry::Inputs;
use crate::entry::names;
use crate::picture::figures::{circle, dimension, line, polygon, rectangle};
use crate::picture::{PictureShape, ShapeKind};

/// Radius of the drawn part, mm.
pub const RADIUS: f64 = 22.0;
/// Where the drawn part ends to the left, at the chuck, and to the right, mm.
pub const ENDS: [f64; 2] = [-50.0, 10.0];
/// Radius of the drawn ball, mm.
pub const BALL: f64 = 3.0;
/// A point that is touched.
pub struct Touch {
    /// The point, mm.
    pub at: [f64; 2],
    /// Direction out of the material, of length 1.
    pub out: [f64; 2],
    /// Its number in the order of the touches.
    pub number: usize,
}

impl Touch {
    /// A place so far before the point, mm.
    pub fn before(&self, distance: f64) -> [f64; 2] {
        let [x, y] = self.at;
        [x + self.out[0] * distance, y + self.out[1] * distance]
    }

    /// Centre of the ball at the start of the measuring block, mm.
    pub fn start(&self, path: f64) -> [f64; 2] {
        self.before(BALL + path)
    }
}

/// Drawn length of the measuring path, mm.
pub fn path(inputs: &Inputs) -> f64 {
    let given = inputs.given(names::FA).filter(|path| *path > 0.0);
    given.unwrap_or(2.0).clamp(6.0, 12.0)
}

/// Start of the measuring block, way and point.
pub fn touch(touch: &Touch, path: f64) -> [PictureShape; 3] {
    let start = touch.start(path);
    [
        line(ShapeKind::Path, vec![start, touch.before(BALL)]).of(names::FA),
        circle(ShapeKind::Probe, start, BALL).of(names::PRNUM),
        circle(ShapeKind::Touch, touch.at, BALL * 0.3).text(touch.number.to_string()).of(names::NMSP),
    ]
}

/// The measuring path as a dimension, beside the way.
pub fn path_dimension(touch: &Touch, path: f64) -> PictureShape {
    let beside = |[x, y]: [f64; 2]| {
        let [u, v] = touch.out;
        [x - v.abs() * BALL * 2.5, y + u.abs() * BALL * 2.5]
    };
    let (from, to) = (touch.start(path), touch.before(BALL));
    dimension(names::FA, beside(from), beside(to))
}

/// Stylus and body of a probe whose ball is here, as the cutting edge position of the one in use says; where none is in
/// use, as that of position 7.
pub fn probe(inputs: &Inputs, ball: [f64; 2]) -> [PictureShape; 2] {
    stylus(ball, inputs.body.unwrap_or([1.0, 0.0]))
}

/// The same; `back`: direction from the ball to the body, of length 1.
pub fn stylus(ball: [f64; 2], back: [f64; 2]) -> [PictureShape; 2] {
    let along = |distance: f64| [ball[0] + back[0] * distance, ball[1] + back[1] * distance];
    let size = [6.0 + 6.0 * back[0].abs(), 6.0 + 6.0 * back[1].abs()];
    [
        line(ShapeKind::Probe, vec![along(BALL), along(18.0)]).of(names::PRNUM),
        rectangle(ShapeKind::Probe, along(24.0), size).of(names::PRNUM),
    ]
}

/// An axis of the coordinate system (0 abscissa, 1 ordinate, 2 applicate) with its letter at the second end.
pub fn axis(inputs: &Inputs, index: usize, ends: [[f64; 2]; 2]) -> [PictureShape; 2] {
    let letter = AXES[inputs.plane.axes()[index]];
    let [from, to] = ends;
    let way = |a: f64, b: f64| (b - a).signum() * if a == b { 0.0 } else { 3.5 };
    let beyond = [to[0] + way(from[0], to[0]), to[1] + way(from[1], to[1])];
    [line(ShapeKind::Axis, vec![from, to]), line(ShapeKind::Label, vec![beyond]).text(letter)]
}

/// A turned part in its chuck, from the side.
pub fn part() -> [PictureShape; 2] {
    let [left, right] = ENDS;
    let body = [(left + right) / 2.0, 0.0];
    [
        rectangle(ShapeKind::Material, body, [right - left, 2.0 * RADIUS]),
        rectangle(ShapeKind::Cut, [left - 5.0, 0.0], [10.0, 2.8 * RADIUS]),
    ]
}

/// Bands about a touched face: parameter, and how far it is drawn into the material (negative) and out of it, mm.
pub type Bands = &'static [(&'static str, f64, f64)];
/// Those of a measurement, wide ones first.
pub const MEASURED: Bands =
    &[(names::TSA, -3.2, 3.2), (names::TDIF, -2.2, 2.2), (names::TUL, 0.0, 1.2), (names::TLL, -1.2, 0.0)];

/// The bands that the call uses, about the face between two points.
pub fn bands(inputs: &Inputs, bands: Bands, face: [[f64; 2]; 2], out: [f64; 2]) -> Vec<PictureShape> {
    let used = |(name, _, _): &&(&'static str, f64, f64)| {
        let param = inputs.cycle.param(name);
        param.is_some_and(|param| param.need(inputs).is_some())
    };
    let band = |(name, from, to): &(&'static str, f64, f64)| {
        let [a, b] = face;
        let beside = |[x, y]: [f64; 2], distance: f64| [x + out[0] * distance, y + out[1] * distance];
        let corners = vec![beside(a, *from), beside(b, *from), beside(b, *to), beside(a, *to)];
        polygon(ShapeKind::Tolerance, corners).of(name)
    };
    bands.iter().filter(used).map(band).collect()
}
