//! Figures of a picture, put together.

use super::{PictureShape, ShapeKind};
use crate::name::Name;

/// Corners of a drawn circle; enough to look round.
const CORNERS: u32 = 72;

/// A polyline.
pub fn line(kind: ShapeKind, points: Vec<[f64; 2]>) -> PictureShape {
    PictureShape { kind, points, circle: None, opening: None, closed: false, text: None, field: None, also: Vec::new() }
}

/// A polygon.
pub fn polygon(kind: ShapeKind, points: Vec<[f64; 2]>) -> PictureShape {
    PictureShape { closed: true, ..line(kind, points) }
}

/// A circle.
pub fn circle(kind: ShapeKind, centre: [f64; 2], radius: f64) -> PictureShape {
    PictureShape { circle: Some((centre, radius)), closed: true, ..line(kind, Vec::new()) }
}

/// A rectangle about a centre.
pub fn rectangle(kind: ShapeKind, centre: [f64; 2], size: [f64; 2]) -> PictureShape {
    polygon(kind, corners(centre, size))
}

/// Corners of a rectangle, counter-clockwise.
pub fn corners([x, y]: [f64; 2], [width, height]: [f64; 2]) -> Vec<[f64; 2]> {
    let (w, h) = (width / 2.0, height / 2.0);
    vec![[x - w, y - h], [x + w, y - h], [x + w, y + h], [x - w, y + h]]
}

/// Points of an arc, from one angle to the other, degree.
pub fn arc([x, y]: [f64; 2], radius: f64, from: f64, to: f64) -> Vec<[f64; 2]> {
    let point = |index: u32| {
        let share = f64::from(index) / f64::from(CORNERS);
        let (sin, cos) = (from + (to - from) * share).to_radians().sin_cos();
        [x + radius * cos, y + radius * sin]
    };
    (0..=CORNERS).map(point).collect()
}

/// The point at a distance from the origin, in a direction counted from the abscissa, degree.
pub fn polar(angle: f64, distance: f64) -> [f64; 2] {
    let (sin, cos) = angle.to_radians().sin_cos();
    [distance * cos, distance * sin]
}

/// An angle of a parameter as an arc about the origin, with its name beside it; radius in mm, from and to in degree.
pub fn swept(field: Name, radius: f64, from: f64, to: f64) -> [PictureShape; 2] {
    let at = polar((from + to) / 2.0, radius * 1.12);
    [
        line(ShapeKind::Path, arc([0.0; 2], radius, from, to)).of(field),
        line(ShapeKind::Label, vec![at]).text(field).of(field),
    ]
}

/// Head of an arrow that ends at `tip`, coming from `from`.
pub fn arrow(kind: ShapeKind, from: [f64; 2], tip: [f64; 2], size: f64) -> PictureShape {
    let (dx, dy) = (tip[0] - from[0], tip[1] - from[1]);
    let length = dx.hypot(dy).max(f64::MIN_POSITIVE);
    let (x, y) = (dx / length * size, dy / length * size);
    let side = |sign: f64| [tip[0] - x - sign * y * 0.4, tip[1] - y + sign * x * 0.4];
    line(kind, vec![side(1.0), tip, side(-1.0)])
}

/// A turn about a point, from one angle to the other, degree: an arc with an arrow at its end.
pub fn turn(field: Name, about: [f64; 2], radius: f64, [from, to]: [f64; 2], size: f64) -> [PictureShape; 2] {
    let way = arc(about, radius, from, to);
    let [before, tip] = [way.len() - 2, way.len() - 1].map(|index| way[index]);
    [arrow(ShapeKind::Axis, before, tip, size).of(field), line(ShapeKind::Axis, way).of(field)]
}

/// An axis from a point, with an arrow at its tip.
pub fn ray(field: Name, from: [f64; 2], tip: [f64; 2], size: f64) -> [PictureShape; 2] {
    [line(ShapeKind::Axis, vec![from, tip]).of(field), arrow(ShapeKind::Axis, from, tip, size).of(field)]
}

/// One outline around another, as a single polygon that every fill rule fills alike.
pub fn frame(mut outer: Vec<[f64; 2]>, mut inner: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    if let (Some(first), Some(opening)) = (outer.first().copied(), inner.first().copied()) {
        outer.push(first);
        inner.push(opening);
        inner.reverse();
        outer.append(&mut inner);
        outer.push(first);
    }
    outer
}

impl PictureShape {
    /// Moves it.
    pub fn shift(&mut self, by: [f64; 2]) {
        let circles = self.circle.iter_mut().chain(&mut self.opening).map(|(centre, _)| centre);
        for [x, y] in self.points.iter_mut().chain(circles) {
            *x += by[0];
            *y += by[1];
        }
    }

    /// With a text.
    pub fn text(self, text: impl Into<String>) -> Self {
        Self { text: Some(text.into()), ..self }
    }

    /// For a parameter.
    pub fn of(self, field: Name) -> Self {
        Self { field: Some(field), ..self }
    }
}

/// A dimension line of a parameter, with its name.
pub fn dimension(field: Name, from: [f64; 2], to: [f64; 2]) -> PictureShape {
    line(ShapeKind::Dimension, vec![from, to]).text(field).of(field)
}
