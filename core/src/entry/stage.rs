//! A cycle at work, laid out for a picture: what an entry says about it before, and what it finds then to put its
//! dimensions at. A picture is not to scale where short ways would be too short to be seen: the cycle is carried out
//! with values that are drawn well, and all that is drawn follows from that.

use super::{Inputs, names};
use crate::control::{Edge, Plane};
use crate::entry::address;
use crate::name::Name;
use crate::picture::figures::{circle, dimension, line, polygon, rectangle};
use crate::picture::{PictureShape, ShapeKind, figures};

/// Longest size of what is measured, mm: sizes count in parts of it.
pub const SIZE: f64 = 100.0;
/// Ball radius, mm.
pub const BALL: f64 = 4.5;

/// From where the work is seen, and how much of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Look {
    /// To the right on the paper; abscissa, ordinate, applicate; a unit vector.
    pub right: [f64; 3],
    /// Upwards on the paper.
    pub up: [f64; 3],
    /// Whether the part is cut open.
    pub cut: bool,
    /// The touches that are shown, a bit each, the first one the lowest; all bits: each. The ways end with the last.
    pub touches: u32,
    /// After how many touches the ways begin.
    pub since: usize,
    /// Whether it stands below the first view instead of beside the last.
    pub below: bool,
    /// Whether the balls are shown.
    pub balls: bool,
    /// Whether touches along the line of sight are shown.
    pub flat: bool,
    /// Whether the ball is shown where it stands at the call.
    pub called: bool,
    /// Whether what holds the part is shown too.
    pub held: bool,
    /// Parameter that the tool before the first touch explains; none: it is not shown.
    pub tool: Option<Name>,
    /// Parameter that the ways between the touches explain; none: the ways are left out.
    pub way: Option<Name>,
    /// Letters at the ends of both axes of the paper where they are drawn.
    pub axes: [usize; 2],
}

impl Look {
    /// Onto the working plane: all touches, without the ways between them.
    pub const ABOVE: Look = Look {
        right: [1.0, 0.0, 0.0],
        up: [0.0, 1.0, 0.0],
        cut: false,
        touches: u32::MAX,
        since: 0,
        below: false,
        balls: true,
        flat: false,
        called: true,
        held: false,
        tool: None,
        way: None,
        axes: [0, 1],
    };

    /// A section along an axis of the plane (0 abscissa, 1 ordinate), the applicate up.
    pub const fn section(axis: usize) -> Look {
        let right = if axis == 0 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
        Look { right, up: [0.0, 0.0, 1.0], cut: true, axes: [axis, 2], ..Look::ABOVE }
    }

    /// A look with the ways, which explain this parameter.
    pub const fn ways(self, field: Name) -> Look {
        Look { way: Some(field), ..self }
    }

    /// A look with some of the touches, a bit each.
    pub const fn touching(self, touches: u32) -> Look {
        Look { touches, ..self }
    }

    /// Whether it shows a touch, counted from 0.
    pub const fn shows(&self, touch: usize) -> bool {
        self.touches == u32::MAX || touch < u32::BITS as usize && self.touches >> touch & 1 == 1
    }

    /// How many touches are carried out for it.
    pub const fn until(&self) -> usize {
        if self.touches == u32::MAX { usize::MAX } else { (u32::BITS - self.touches.leading_zeros()) as usize }
    }
}

/// Parameters that the figures explain which every picture of a sort has.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Fields {
    /// The touched edges, in the order in which they are touched; the last one counts for the rest.
    pub edges: &'static [Name],
    /// Way of a measuring block.
    pub path: Option<Name>,
    /// Way on a circle.
    pub arc: Option<Name>,
    /// Ball at the start of a measuring block.
    pub probe: Option<Name>,
    /// Touched point.
    pub touch: Option<Name>,
    /// Protection zone; none: it is not drawn.
    pub zone: Option<Name>,
    /// Whether the room beyond the zone is forbidden, not that in it.
    pub beyond: bool,
    /// Whether the names of the touches stand at the start of their measuring blocks instead of at the points.
    pub at_start: bool,
    /// Names of the touches in their order; what stands before the number of any other one; none: no name.
    pub marks: &'static [&'static str],
    /// What stands before the number of a touch without a name; none: nothing is written.
    pub mark: Option<&'static str>,
}

impl Fields {
    /// Of a cycle on SINUMERIK.
    pub const CYCLE: Fields = Fields {
        edges: &[names::SETVAL],
        path: Some(names::FA),
        arc: Some(names::RF),
        probe: Some(names::PRNUM),
        touch: Some(names::NMSP),
        zone: Some(names::SZA),
        mark: Some(""),
        ..Fields::MACRO
    };
    /// Of a macro on NCT.
    pub const MACRO: Fields = Fields {
        edges: &[address::D],
        path: None,
        arc: None,
        probe: None,
        touch: None,
        zone: None,
        beyond: false,
        at_start: false,
        marks: &[],
        mark: None,
    };
}

/// What is carried out for a picture.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Staging {
    /// Values in place of those of the call; mm and degree.
    pub values: Vec<(Name, f64)>,
    /// Values of the call that are left out.
    pub left_out: Vec<Name>,
    /// Whether retracting and looking for nothing are ways too, as of a scan.
    pub all_ways: bool,
    /// Variant that is carried out instead of the one called; none: that one.
    pub variant: Option<i64>,
    /// Variant whose part is proposed; none: that one too.
    pub proposed: Option<i64>,
    /// Cutting edge position of a turning machine's probe; none: that of the one in use.
    pub tip: Option<i64>,
    /// The edge in use, but for its radius; none: that of the machine.
    pub tool: Option<Edge>,
    /// Plane of the call on a turning machine; none: that of turning.
    pub plane: Option<Plane>,
    /// Data of the control that differ, lengths in mm.
    pub data: Vec<(String, f64)>,
    /// What is carried out besides; its views stand beside the others.
    pub then: Option<Box<Staging>>,
    /// mm of the picture for a mm of the call.
    pub scale: f64,
    /// Ball radius, mm.
    pub ball: f64,
    /// Views, one beside the other.
    pub looks: Vec<Look>,
    /// What the figures explain.
    pub fields: Fields,
}

impl Staging {
    /// With the values of the call.
    pub fn new(look: Look, fields: Fields) -> Staging {
        Staging { scale: 1.0, ball: BALL, looks: vec![look], fields, ..Staging::default() }
    }

    /// With another value of a parameter.
    pub fn with(mut self, name: Name, value: f64) -> Staging {
        self.values.push((name, value));
        self
    }

    /// With these sizes of the call, the longest as long as the picture has it, none too short for the ball.
    pub fn sized(mut self, inputs: &Inputs, names: &[Name]) -> Staging {
        let sizes = names.iter().map(|name| (*name, inputs.number(*name).abs()));
        let longest = sizes.clone().fold(0.0_f64, |longest, (_, size)| longest.max(size));
        self.scale = if longest > 0.0 { SIZE / longest } else { 1.0 };
        let scale = self.scale;
        self.values.extend(sizes.map(|(name, size)| (name, (size * scale).clamp(0.4 * SIZE, SIZE))));
        self
    }

    /// With a short way of the call so long that it can be seen: least and most, mm.
    pub fn short(self, inputs: &Inputs, name: Name, [least, most]: [f64; 2]) -> Staging {
        let way = inputs.any(name).unwrap_or(0.0);
        let length = (way.abs() * self.scale).clamp(least, most);
        self.with(name, length.copysign(way))
    }

    /// With a ball of this radius, mm.
    pub fn ball(self, ball: f64) -> Staging {
        Staging { ball, ..self }
    }

    /// With the angle of a parameter, less than a whole turn.
    pub fn angle(self, inputs: &Inputs, name: Name) -> Staging {
        self.with(name, inputs.degrees(name).within_turn().0)
    }

    /// The value that is drawn.
    pub fn value(&self, name: Name) -> f64 {
        self.values.iter().rev().find(|(known, _)| *known == name).map_or(0.0, |(_, value)| *value)
    }

    /// With one more view where it is wanted.
    pub fn beside(mut self, wanted: bool, look: Look) -> Staging {
        self.looks.extend(wanted.then_some(look));
        self
    }
}

/// A touch on the paper, mm.
#[derive(Clone, Copy, Debug)]
pub struct Touched {
    /// Number of the touch, from 1.
    pub number: usize,
    /// The point of the part.
    pub at: [f64; 2],
    /// Centre of the ball there.
    pub ball: [f64; 2],
    /// Centre of the ball where its measuring block begins.
    pub start: [f64; 2],
}

impl Touched {
    /// Direction out of the part, of length 1.
    pub fn out(&self) -> [f64; 2] {
        unit(self.at, self.ball)
    }
}

/// Direction from a point to another, of length 1.
pub fn unit(from: [f64; 2], to: [f64; 2]) -> [f64; 2] {
    let [x, y] = [to[0] - from[0], to[1] - from[1]];
    let length = x.hypot(y).max(1e-9);
    [x / length, y / length]
}

/// A view of the work as it lies on the paper: places for dimensions and other marks, mm.
#[derive(Clone, Debug, Default)]
pub struct Seen {
    /// Touches in their order, those only that this view shows.
    pub touches: Vec<Touched>,
    /// Touched edges.
    pub edges: Vec<PictureShape>,
    /// Lower left and upper right corner of what they enclose.
    pub part: [[f64; 2]; 2],
    /// Lower left and upper right corner of each protection zone.
    pub zones: Vec<[[f64; 2]; 2]>,
    /// Centre of the ball at the call.
    pub start: [f64; 2],
    /// The zero point.
    pub zero: [f64; 2],
    /// Lower left and upper right corner of all that is drawn.
    pub extent: [[f64; 2]; 2],
    /// Ball radius.
    pub ball: f64,
    /// Letters of the axes of the paper.
    pub letters: [&'static str; 2],
}

impl Seen {
    /// A dimension between two touched points, moved aside.
    pub fn between(&self, field: Name, touches: [usize; 2], aside: [f64; 2]) -> Option<PictureShape> {
        let [from, to] = touches.map(|index| self.touches.get(index).map(|touch| add(touch.at, aside)));
        Some(dimension(field, from?, to?))
    }

    /// The measuring path of a touch as a dimension above or to the right of it, so many ball radii away.
    pub fn path(&self, field: Name, touch: usize, away: f64) -> Option<PictureShape> {
        let touch = self.touches.get(touch)?;
        let [x, y] = touch.out().map(|part| part * away * self.ball);
        let aside = if x > 0.0 || x == 0.0 && y < 0.0 { [-y, x] } else { [y, -x] };
        Some(dimension(field, add(touch.start, aside), add(touch.ball, aside)))
    }

    /// The ways of the measuring blocks as arrows.
    pub fn arrows(&self, field: Name, size: f64) -> impl Iterator<Item = PictureShape> {
        self.touches.iter().map(move |touch| figures::arrow(ShapeKind::Path, touch.start, touch.ball, size).of(field))
    }

    /// Centre of what is touched.
    pub fn middle(&self) -> [f64; 2] {
        let [low, high] = self.part;
        [0, 1].map(|axis| (low[axis] + high[axis]) / 2.0)
    }

    /// Whether the ball comes from outside to what is touched.
    pub fn outside(&self) -> bool {
        let [low, high] = self.part;
        let beyond = |ball: [f64; 2]| (0..2).any(|axis| ball[axis] < low[axis] || ball[axis] > high[axis]);
        self.touches.first().is_some_and(|touch| beyond(touch.ball))
    }

    /// The size of what is touched along an axis of the paper: below or to the left of it, inside of an opening.
    pub fn size(&self, field: Name, axis: usize) -> PictureShape {
        let [low, high] = self.part;
        let across = 1 - axis;
        let at = match self.outside() {
            true => low[across] - 0.12 * SIZE,
            false => self.middle()[across] - 0.2 * (high[across] - low[across]),
        };
        self.along(field, axis, self.part, at)
    }

    /// The way up or down from the call to the first measuring block, beside that.
    pub fn infeed(&self, field: Name) -> Option<PictureShape> {
        let touch = self.touches.first()?;
        let side = (touch.start[0] - touch.ball[0]).signum();
        Some(self.along(field, 1, [self.start, touch.start], touch.start[0] + 2.2 * side * self.ball))
    }

    /// The limits of the difference about the touched edges, those that the call uses; or the safe area of a centre.
    /// They are drawn wider than they are.
    pub fn limits(&self, inputs: &Inputs, centre: Option<[f64; 2]>) -> Vec<PictureShape> {
        let unit = 0.017 * (0..2).map(|axis| self.extent[1][axis] - self.extent[0][axis]).fold(0.0, f64::max);
        if let Some(centre) = centre {
            return vec![rectangle(ShapeKind::Tolerance, centre, [8.0 * unit; 2]).of(names::TSA)];
        }
        let bands =
            [(names::TSA, -2.6, 2.6), (names::TDIF, -1.8, 1.8), (names::TUL, 0.0, 1.0), (names::TLL, -1.0, 0.0)];
        let used = bands.into_iter().filter(|(name, ..)| inputs.uses(*name));
        let used: Vec<_> = used.map(|(name, from, to)| (name, from * unit, to * unit)).collect();
        self.bands(ShapeKind::Tolerance, &used)
    }

    /// A length behind a touched point as a dimension, beside the way of the ball.
    pub fn behind(&self, field: Name, touch: usize, length: f64) -> Option<PictureShape> {
        let touch = self.touches.get(touch)?;
        let [x, y] = touch.out();
        let from = add(touch.at, [-y * 4.0 * self.ball, x * 4.0 * self.ball]);
        Some(dimension(field, from, add(from, [-x * length, -y * length])))
    }

    /// Bands about the touched edges: parameter, and how far it is drawn into the material (negative) and out of it.
    pub fn bands(&self, kind: ShapeKind, bands: &[(Name, f64, f64)]) -> Vec<PictureShape> {
        let edges = |band| self.edges.iter().enumerate().map(move |(index, edge)| (index, edge, band));
        let all = bands.iter().flat_map(edges);
        all.filter_map(|(index, edge, (field, from, to))| Some(self.band(kind, index, edge, [*from, *to])?.of(*field)))
            .collect()
    }

    fn band(&self, kind: ShapeKind, index: usize, edge: &PictureShape, [from, to]: [f64; 2]) -> Option<PictureShape> {
        if let Some((centre, radius)) = edge.circle {
            let touch = self.touches.first()?;
            let side = if distance(touch.ball, centre) > radius { 1.0 } else { -1.0 };
            let [inner, outer] = if side > 0.0 { [from, to] } else { [-to, -from] };
            return Some(ring(kind, centre, radius + inner, radius + outer));
        }
        let [a, b] = edge.points[..] else { return None };
        let [x, y] = self.touches.get(index).or(self.touches.last())?.out();
        let along = unit(a, b);
        let across = [-along[1], along[0]];
        let side = if across[0] * x + across[1] * y < 0.0 { -1.0 } else { 1.0 };
        let at = |point: [f64; 2], out: f64| add(point, across.map(|part| part * side * out));
        Some(polygon(kind, vec![at(a, from), at(b, from), at(b, to), at(a, to)]))
    }

    /// The axes of the paper through a point, over the whole view and a little more, with their letters, and what
    /// they explain.
    pub fn axes(&self, through: [f64; 2], fields: [Option<Name>; 2]) -> [PictureShape; 2] {
        [0, 1].map(|axis| {
            let [mut low, mut high] = [through; 2];
            let beyond = 0.06 * SIZE;
            (low[axis], high[axis]) = (self.extent[0][axis] - beyond, self.extent[1][axis] + beyond);
            let axis_of = line(ShapeKind::Axis, vec![high, low]).text(self.letters[axis]);
            PictureShape { field: fields[axis], ..axis_of }
        })
    }

    /// A set position: the line of zero across an axis of the paper, and the dimension from there to the first touch.
    pub fn position(&self, field: Name, axis: usize, zero: Option<Name>) -> Vec<PictureShape> {
        let Some(touch) = self.touches.first() else { return Vec::new() };
        let across = 1 - axis;
        let end = |index: usize| {
            let mut end = self.zero;
            end[across] = self.extent[index][across];
            end
        };
        let line_of_zero = PictureShape { field: zero, ..line(ShapeKind::Axis, vec![end(0), end(1)]).text("0") };
        let at = (touch.at[across] + 2.0 * self.extent[0][across]) / 3.0;
        vec![line_of_zero, self.along(field, axis, [self.zero, touch.at], at)]
    }

    /// The axis of the paper through the first touch, from zero over the part.
    pub fn measuring_axis(&self, field: Name, axis: usize) -> Option<PictureShape> {
        let through = self.touches.first()?.at;
        let (mut low, mut high) = (through, through);
        low[axis] = self.extent[0][axis].min(self.zero[axis]);
        high[axis] = self.extent[1][axis].max(self.zero[axis]);
        Some(line(ShapeKind::Axis, vec![low, high]).of(field))
    }

    /// Both axes from the zero point, with their dimensions to a centre.
    pub fn centre(&self, centre: [f64; 2], fields: [Name; 2], zero: Option<Name>) -> Vec<PictureShape> {
        let [_, high] = self.extent;
        let mut shapes = Vec::new();
        for (axis, field) in fields.into_iter().enumerate() {
            let across = 1 - axis;
            let (mut end, mut from, mut to) = (self.zero, centre, centre);
            end[axis] = high[axis];
            (from[across], to[across]) = (self.zero[across], high[across]);
            let from_zero = line(ShapeKind::Axis, vec![self.zero, end]).text(if axis == 0 { "0" } else { "" });
            shapes.push(PictureShape {
                field: zero,
                text: from_zero.text.clone().filter(|text| !text.is_empty()),
                ..from_zero
            });
            shapes.push(line(ShapeKind::Axis, vec![from, to]).of(field));
            shapes.push(self.along(field, axis, [self.zero, centre], self.zero[across] + 0.08 * SIZE));
        }
        shapes.push(line(ShapeKind::Touch, vec![centre]).of(fields[0]));
        shapes
    }

    /// An angle about a point, from one direction to another, degree: its arc with its name.
    pub fn angle(&self, field: Name, about: [f64; 2], radius: f64, [from, to]: [f64; 2]) -> [PictureShape; 2] {
        figures::swept(field, radius, from, to).map(|mut shape| {
            shape.shift(about);
            shape
        })
    }

    /// The height of the touches in a section, from the line of zero, to the left of all.
    pub fn depth(&self, field: Name) -> Vec<PictureShape> {
        let ([low, high], Some(touch)) = (self.extent, self.touches.first()) else { return Vec::new() };
        let left = low[0].min(self.zero[0]) - 0.08 * SIZE;
        vec![
            line(ShapeKind::Axis, vec![[left, self.zero[1]], [high[0], self.zero[1]]]).text("0"),
            self.along(field, 1, [self.zero, touch.at], left),
        ]
    }

    /// A dimension along an axis of the paper (0 right, 1 up) between the places of two points, at `at` of the other.
    pub fn along(&self, field: Name, axis: usize, ends: [[f64; 2]; 2], at: f64) -> PictureShape {
        let [from, to] = ends.map(|mut end| {
            end[1 - axis] = at;
            end
        });
        dimension(field, from, to)
    }
}

/// A ring between two radii, mm.
pub fn ring(kind: ShapeKind, centre: [f64; 2], inner: f64, outer: f64) -> PictureShape {
    PictureShape { opening: Some((centre, inner.max(0.0))), ..circle(kind, centre, outer) }
}

/// The least and the most of each coordinate of some points.
pub fn ends(points: &[[f64; 2]]) -> [(f64, f64); 2] {
    [0, 1].map(|axis| {
        let values = points.iter().map(|point| point[axis]);
        (values.clone().fold(f64::INFINITY, f64::min), values.fold(f64::NEG_INFINITY, f64::max))
    })
}

/// The sum of two vectors.
pub fn add(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] + b[0], a[1] + b[1]]
}

/// The distance of two points.
pub fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}
