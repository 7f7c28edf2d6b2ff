//! What a shape is made of, in its own frame (origin at the upper face, Z up): columns that go down from Z = 0, a ball,
//! or triangles. From this follow what is touched (`body`), what is drawn (`scene::solid`), the outline in a help
//! picture (`scene::plan_solid`), the diameters of a turned part (`scene::turned`) and the cap of a tool probe.

use super::{FreeSurface, PartErrors, Shape, Solid};
use crate::geometry::{Degrees, Lobes, Quad, Trim, V3};
use std::sync::Arc;

/// What a shape is made of.
#[derive(Clone, Debug)]
pub(crate) enum Form {
    /// A column, an opening, or both.
    Columns(Columns),
    /// A ball about the origin, by its radius in mm.
    Ball(f64),
    /// Triangles.
    Free(Arc<FreeSurface>),
}

/// A column with an opening in it; each of both may be missing.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Columns {
    /// What stands; none: material around the opening, as much as who asks wants.
    pub stands: Option<Column>,
    /// What is open at the top.
    pub opening: Option<Column>,
    /// Whether it stands on a plate.
    pub plate: bool,
    /// Whether the opening goes through along Y.
    pub through: bool,
}

/// What goes down from Z = 0: its section there, and how that grows with the depth.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Column {
    /// Within a closed curve about the Z axis, so deep, mm.
    Round(Lobes, f64),
    /// Over a rectangle or a parallelogram.
    Straight(Frustum),
}

/// Material around an opening: share of its half lengths and mm added to them, and the same of its depth.
pub(crate) struct Material {
    /// Half lengths.
    pub beside: [f64; 2],
    /// Depth.
    pub below: [f64; 2],
}

impl Solid {
    pub(crate) fn form(&self) -> Form {
        Form::of(&self.shape, &self.errors)
    }
}

impl Form {
    /// What a shape with these errors is made of.
    pub fn of(shape: &Shape, errors: &PartErrors) -> Form {
        let straight = |[x, y]: [f64; 2], depth: f64| {
            Column::Straight(Frustum::tapered([x + errors.size, y + errors.size], depth, errors.taper))
        };
        // its length is not measured
        let across =
            |width: f64, length: f64, depth: f64| Frustum::tapered([width + errors.size, length], depth, errors.taper);
        let askew = |angle, length, depth| Column::Straight(Frustum::corner(angle, length, depth, errors));
        let round = |diameter: f64, depth: f64| Column::Round(curve(diameter, errors), depth);
        let alone = |column| Columns { stands: Some(column), opening: None, plate: false, through: false };
        let on_plate = |column| Columns { plate: true, ..alone(column) };
        let open = |column| Columns { stands: None, opening: Some(column), plate: false, through: false };
        Form::Columns(match *shape {
            Shape::Hole { diameter, depth } => open(round(diameter, depth)),
            Shape::Shaft { diameter, height } => on_plate(round(diameter, height)),
            Shape::Groove { width, depth, length } => {
                let mut groove = across(width, length, depth);
                groove.below[1] = groove.above[1];
                Columns { through: true, ..open(Column::Straight(groove)) }
            }
            Shape::Web { width, height, length } => on_plate(Column::Straight(across(width, length, height))),
            Shape::Pocket { length, depth } => open(straight(length, depth)),
            Shape::Island { length, height } => on_plate(straight(length, height)),
            Shape::OuterCorner { angle, length, height } => alone(askew(angle, length, height)),
            Shape::InnerCorner { angle, length, depth } => open(askew(angle, length, depth)),
            Shape::Block { size: [x, y, z] } => alone(straight([x, y], z)),
            Shape::Turned { diameter, length, bore: [bore, depth] } => {
                Columns { opening: (bore > 0.0).then(|| round(bore, depth)), ..alone(round(diameter, length)) }
            }
            Shape::Chuck { diameter, length, .. } => alone(round(diameter, length)),
            Shape::Sphere { diameter } => return Form::Ball((diameter + errors.size) / 2.0),
            Shape::Free(ref surface) => return Form::Free(Arc::clone(surface)),
        })
    }
}

/// A round section; without lobes the amplitude is that of the angle 0 all round.
fn curve(diameter: f64, errors: &PartErrors) -> Lobes {
    let (radius, slope) = ((diameter + errors.size) / 2.0, errors.taper / 2.0);
    match errors.out_of_round {
        (amplitude, 0) => Lobes { radius: radius + amplitude, slope, amplitude: 0.0, count: 0 },
        (amplitude, count) => Lobes { radius, slope, amplitude, count },
    }
}

impl Columns {
    /// What stands, or the material around the opening.
    pub fn outer(&self, material: &Material) -> Column {
        let around = || {
            let opening = self.opening.map(|opening| opening.hull()).unwrap_or_default();
            let [share, more] = material.below;
            let mut block = Frustum { bottom: opening.bottom * share - more, ..opening.widened(material.beside) };
            if self.through {
                (block.above[1], block.below[1]) = (opening.above[1], opening.above[1]);
            }
            Column::Straight(block)
        };
        self.stands.unwrap_or_else(around)
    }
}

impl Column {
    /// The straight one that holds it.
    pub fn hull(&self) -> Frustum {
        match self {
            Column::Round(curve, depth) => Frustum::upright([curve.widest(*depth); 2], 0.0, -depth),
            Column::Straight(frustum) => *frustum,
        }
    }

    /// Point of the column that lies farthest in a direction, lobes aside.
    pub fn farthest(&self, direction: &V3) -> V3 {
        let farthest = |ends: &[V3]| {
            let ends = ends.iter().max_by(|a, b| a.dot(direction).total_cmp(&b.dot(direction)));
            ends.copied().unwrap_or_default()
        };
        match self {
            Column::Straight(frustum) => farthest([frustum.ring(true), frustum.ring(false)].as_flattened()),
            Column::Round(Lobes { radius, slope, .. }, depth) => {
                let out = V3::new(direction.x, direction.y, 0.0).try_normalize(0.0).unwrap_or_else(V3::zeros);
                farthest(&[out * *radius, out * (radius + slope * depth) - V3::z() * *depth])
            }
        }
    }

    /// Whether a point lies in it.
    pub fn contains(&self, p: &V3) -> bool {
        match self {
            Column::Straight(frustum) => frustum.contains(p),
            Column::Round(curve, depth) => p.z <= 0.0 && p.z >= -depth && p.xy().norm() <= curve.radius_at(p),
        }
    }

    /// The flat faces at its upper or lower end, looking up, less an opening that begins there.
    pub fn faces(&self, upper: bool, opening: Option<(&Column, bool)>) -> Vec<Quad> {
        let curve = |column: &Column| match column {
            Column::Round(curve, _) => Some(*curve),
            Column::Straight(_) => None,
        };
        let corners = match self {
            Column::Round(..) => self.hull().widened([1.0, 1.0]).ring(upper), // the curve decides
            Column::Straight(frustum) => frustum.ring(upper),
        };
        let trim = Trim { inner: opening.and_then(|(column, _)| curve(column)), outer: curve(self) };
        match opening {
            Some((column, upper)) if trim == Trim::default() => between(corners, column.hull().ring(upper)),
            _ => vec![Quad { corners, trim }],
        }
    }
}

/// Two pairs of walls, which may lean, a lid and a base, over a rectangle or a parallelogram. Lengths are counted along
/// the edges: the first along X, the second turned from X by the angle between them.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Frustum {
    /// Half lengths at the top, mm.
    pub above: [f64; 2],
    /// Half lengths at the bottom, mm.
    pub below: [f64; 2],
    /// Height of the upper face, mm.
    pub top: f64,
    /// Height of the lower face, mm.
    pub bottom: f64,
    /// Centre along both edges, mm.
    centre: [f64; 2],
    /// Sine and cosine of the angle between the edges.
    opening: (f64, f64),
}

impl Frustum {
    fn upright(half: [f64; 2], top: f64, bottom: f64) -> Frustum {
        Frustum { above: half, below: half, top, bottom, centre: [0.0; 2], opening: (1.0, 0.0) }
    }

    /// From Z = 0 downwards, lengths growing by `taper` mm per mm of depth.
    fn tapered(length: [f64; 2], depth: f64, taper: f64) -> Frustum {
        let above = length.map(|l| l / 2.0);
        Frustum { below: above.map(|l| l + taper * depth / 2.0), ..Frustum::upright(above, 0.0, -depth) }
    }

    /// From Z = 0 downwards with a corner at the origin, from which the edges run along X and, turned by `angle`,
    /// along a second direction. Each wall stands out by half of the error of size and of what the taper adds.
    fn corner(angle: Degrees, length: [f64; 2], depth: f64, errors: &PartErrors) -> Frustum {
        let opening = angle.sin_cos();
        let along = |across: f64| across / opening.0;
        let whole = length.map(|l| l + along(errors.size));
        Frustum { centre: length.map(|l| l / 2.0), opening, ..Frustum::tapered(whole, depth, along(errors.taper)) }
    }

    /// With upright walls around it, its half lengths times `share`, and `margin` mm away.
    fn widened(&self, [share, margin]: [f64; 2]) -> Frustum {
        let half = [0, 1].map(|i| self.above[i].max(self.below[i]) * share + margin / self.opening.0);
        Frustum { above: half, below: half, ..*self }
    }

    /// A plate below it that reaches so far beyond its walls, and so thick, mm.
    pub fn plate(&self, margin: f64, thick: f64) -> Frustum {
        Frustum { top: self.bottom, bottom: self.bottom - thick, ..self.widened([1.0, margin]) }
    }

    fn contains(&self, p: &V3) -> bool {
        let (sine, cosine) = self.opening;
        let second = p.y / sine;
        let place = [p.x - second * cosine, second];
        let part = (self.top - p.z) / (self.top - self.bottom);
        let within = |i: usize| {
            let half = self.above[i] + (self.below[i] - self.above[i]) * part;
            (place[i] - self.centre[i]).abs() <= half
        };
        (0.0..=1.0).contains(&part) && within(0) && within(1)
    }

    /// Corners of the upper or lower face, counter-clockwise from (−, −).
    pub fn ring(&self, upper: bool) -> [V3; 4] {
        let ([x, y], z) = if upper { (self.above, self.top) } else { (self.below, self.bottom) };
        let (sine, cosine) = self.opening;
        let [first, second] = self.centre;
        [[-x, -y], [x, -y], [x, y], [-x, y]].map(|[u, v]| {
            let (u, v) = (first + u, second + v);
            V3::new(u + v * cosine, v * sine, z)
        })
    }

    /// Walls −Y, +X, +Y, −X, facing outwards.
    pub fn walls(&self) -> [Quad; 4] {
        let (up, low) = (self.ring(true), self.ring(false));
        [0, 1, 2, 3].map(|i| {
            let next = (i + 1) % 4;
            Quad { corners: [low[i], low[next], up[next], up[i]], trim: Trim::default() }
        })
    }
}

/// The faces between an outer and an inner ring of corners, where there is room between them.
pub(super) fn between([a, b, c, d]: [V3; 4], [i, j, k, l]: [V3; 4]) -> Vec<Quad> {
    let all = [[a, b, j, i], [b, c, k, j], [c, d, l, k], [d, a, i, l]];
    let room = |[a, b, c, d]: &[V3; 4]| (c - a).cross(&(d - b)) != V3::zeros();
    all.into_iter().filter(room).map(|corners| Quad { corners, trim: Trim::default() }).collect()
}

impl Quad {
    /// A face seen from the other side.
    pub(super) fn reversed(self) -> Quad {
        let [a, b, c, d] = self.corners;
        Quad { corners: [d, c, b, a], ..self }
    }
}
