//! A solid taken apart into faces, edges and corners, in its own frame (origin at the upper face, Z up).

pub(super) mod frustum;

use self::frustum::{Frustum, quad, reversed};
use super::free::FreeSurface;
use super::{PartErrors, Shape, Solid};
use crate::geometry::circle::Circle;
use crate::geometry::extent::Extent;
use crate::geometry::feature::Bound;
use crate::geometry::lobed::{LobedWall, Lobes};
use crate::geometry::quad::{Quad, Trim};
use crate::geometry::segment::Segment;
use crate::geometry::wall::Wall;
use crate::geometry::{Feature, V3};
use nalgebra::IsometryMatrix3;
use std::sync::Arc;

/// Material beside and below an inner element, and plate around an outer one, mm.
const MARGIN: f64 = 20.0;
/// Thickness of a floor or plate, mm.
const FLOOR: f64 = 10.0;

/// Boundary and inside of a solid.
#[derive(Clone, Debug)]
pub(crate) struct Body {
    /// Own frame → machine.
    pub place: IsometryMatrix3<f64>,
    /// Boundary.
    pub features: Vec<Feature>,
    /// Triangles of a free surface.
    pub free: Option<Arc<FreeSurface>>,
    /// Where each of them is.
    pub bounds: Vec<Bound>,
    /// The same as boxes.
    pub extents: Vec<Extent>,
    /// Where all of them are.
    pub extent: Extent,
    material: Vec<Piece>,
    cavity: Option<Piece>,
}

/// A convex piece of space.
#[derive(Clone, Debug)]
enum Piece {
    Frustum(Frustum),
    Round { lobes: Lobes, depth: f64 },
    Ball { radius: f64 },
}

impl Body {
    /// Takes a solid apart, its errors applied.
    pub fn new(solid: &Solid) -> Body {
        let mut body = Body {
            place: solid.place(),
            features: Vec::new(),
            free: None,
            bounds: Vec::new(),
            extents: Vec::new(),
            extent: Extent::empty(),
            material: Vec::new(),
            cavity: None,
        };
        body.make(&solid.shape, &solid.errors);
        body.bounds = body.features.iter().map(Bound::around).collect();
        body.extents = body.features.iter().map(Extent::around).collect();
        body.extent = match &body.free {
            Some(free) => Extent::of(free.bounds().map(V3::from)),
            None => {
                let extents = body.extents.iter();
                extents.fold(Extent::empty(), |all, one| all.with(one))
            }
        };
        body
    }

    /// Boundary and inside of a shape with these errors.
    fn make(&mut self, shape: &Shape, errors: &PartErrors) {
        match *shape {
            Shape::Free(ref surface) => self.free = Some(Arc::clone(surface)),
            Shape::Hole { diameter, depth } => self.hole(diameter, depth, errors),
            Shape::Shaft { diameter, height } => self.shaft(diameter, height, errors),
            Shape::Groove { width, depth, length } => self.groove([width, length], depth, errors),
            Shape::Pocket { length, depth } => {
                let length = length.map(|l| l + errors.size);
                self.pocket(Frustum::tapered(length, depth, errors.taper));
            }
            Shape::Web { width, height, length } => {
                self.island(Frustum::tapered([width + errors.size, length], height, errors.taper));
            }
            Shape::Island { length, height } => {
                let length = length.map(|l| l + errors.size);
                self.island(Frustum::tapered(length, height, errors.taper));
            }
            Shape::Block { size: [x, y, z] } => {
                let length = [x + errors.size, y + errors.size];
                self.block(Frustum::tapered(length, z, errors.taper));
            }
            Shape::OuterCorner { angle, length, height } => self.block(Frustum::corner(angle, length, height, errors)),
            Shape::InnerCorner { angle, length, depth } => self.pocket(Frustum::corner(angle, length, depth, errors)),
            Shape::Turned { diameter, length, bore } => self.turned(diameter, length, bore, errors),
            Shape::Chuck { diameter, length, .. } => self.turned(diameter, length, [0.0; 2], errors),
            Shape::Sphere { diameter } => {
                let radius = (diameter + errors.size) / 2.0;
                self.features.push(Feature::Sphere(radius));
                self.material.push(Piece::Ball { radius });
            }
        }
    }

    /// Whether a point lies in the material.
    pub fn inside(&self, p: &V3) -> bool {
        if let Some(free) = &self.free {
            return free.mesh.covers(p);
        }
        self.material.iter().any(|piece| piece.contains(p))
            && !self.cavity.as_ref().is_some_and(|piece| piece.contains(p))
    }

    fn hole(&mut self, diameter: f64, depth: f64, errors: &PartErrors) {
        let lobes = lobes(diameter, errors);
        let half = widest(&lobes, depth) + MARGIN;
        let block = Frustum::upright([half, half], 0.0, -depth - FLOOR);
        let mut lid = block.lid();
        lid.trim = Trim::Outside(lobes);
        let mut floor = Frustum::upright([half, half], -depth, -depth - FLOOR).lid();
        floor.trim = Trim::Within(lobes);
        self.add(&block.walls(), true);
        self.add(&[lid, block.base()], true);
        self.add(&[floor], false);
        self.round(lobes, depth, true);
        self.material.push(Piece::Frustum(block));
        self.cavity = Some(Piece::Round { lobes, depth });
    }

    fn shaft(&mut self, diameter: f64, height: f64, errors: &PartErrors) {
        let lobes = lobes(diameter, errors);
        let half = widest(&lobes, height) + MARGIN;
        let mut lid = Frustum::upright([half, half], 0.0, -height).lid();
        lid.trim = Trim::Within(lobes);
        self.add(&[lid], false);
        self.round(lobes, height, false);
        self.material.push(Piece::Round { lobes, depth: height });
        let plate = self.plate([half, half], -height);
        self.add(&[Quad { trim: Trim::Outside(lobes), ..plate.lid() }], false);
    }

    fn turned(&mut self, diameter: f64, length: f64, [bore, depth]: [f64; 2], errors: &PartErrors) {
        let outer = lobes(diameter, errors);
        let face = |z: f64, trim: Trim| {
            let half = diameter + MARGIN;
            let mut face = Frustum::upright([half, half], z, z - FLOOR).lid();
            face.trim = trim;
            face
        };
        let mut front = Trim::Within(outer);
        if bore > 0.0 {
            let inner = lobes(bore, errors);
            front = Trim::Between(inner, outer);
            self.add(&[face(-depth, Trim::Within(inner))], false);
            self.round(inner, depth, true);
            self.cavity = Some(Piece::Round { lobes: inner, depth });
        }
        let back = reversed(face(-length, Trim::Within(outer)));
        self.add(&[face(0.0, front), back], false);
        self.round(outer, length, false);
        self.rim(outer, -length);
        self.material.push(Piece::Round { lobes: outer, depth: length });
    }

    fn round(&mut self, lobes: Lobes, depth: f64, inner: bool) {
        if lobes.amplitude != 0.0 && lobes.count > 0 {
            self.features.push(Feature::Lobed(LobedWall { lobes, depth }));
        } else {
            let radius = lobes.radius + lobes.amplitude;
            self.features.push(Feature::Wall(Wall { radius, slope: lobes.slope, depth, inner }));
        }
        self.rim(lobes, 0.0);
    }

    /// Edge of a round wall at this height; a wall with lobes has it already.
    fn rim(&mut self, lobes: Lobes, z: f64) {
        if lobes.amplitude == 0.0 || lobes.count == 0 {
            let radius = lobes.radius + lobes.amplitude - lobes.slope * z;
            self.features.push(Feature::Circle(Circle { radius, z }));
        }
    }

    fn island(&mut self, block: Frustum) {
        self.add(&block.walls(), true);
        self.add(&[block.lid()], false);
        let half = [0, 1].map(|i| block.above[i].max(block.below[i]) + MARGIN);
        let bottom = block.bottom;
        self.material.push(Piece::Frustum(block));
        let plate = self.plate(half, bottom);
        self.add(&between(plate.ring(true), block.ring(false)), false);
    }

    /// A plate but for its upper face, of which what stands on it leaves a part.
    fn plate(&mut self, half: [f64; 2], top: f64) -> Frustum {
        let plate = Frustum::upright(half, top, top - FLOOR);
        self.add(&plate.walls(), true);
        self.add(&[plate.base()], false);
        self.material.push(Piece::Frustum(plate));
        plate
    }

    fn block(&mut self, block: Frustum) {
        self.add(&block.walls(), true);
        self.add(&[block.lid(), block.base()], true);
        self.material.push(Piece::Frustum(block));
    }

    fn pocket(&mut self, cavity: Frustum) {
        let block = cavity.around(MARGIN, FLOOR);
        self.add(&block.walls(), true);
        self.add(&[block.base()], false);
        self.add(&cavity.walls().map(reversed), true);
        self.add(&between(block.ring(true), cavity.ring(true)), false);
        self.add(&[quad(cavity.ring(false))], false);
        self.material.push(Piece::Frustum(block));
        self.cavity = Some(Piece::Frustum(cavity));
    }

    fn groove(&mut self, [width, length]: [f64; 2], depth: f64, errors: &PartErrors) {
        let mut cavity = Frustum::tapered([width + errors.size, length], depth, errors.taper);
        cavity.below[1] = cavity.above[1];
        let half = [cavity.above[0].max(cavity.below[0]) + MARGIN, length / 2.0];
        let block = Frustum::upright(half, 0.0, -depth - FLOOR);
        let [a, b, c, d] = block.ring(true);
        let [i, j, k, l] = cavity.ring(true);
        let [_, east, _, west] = block.walls();
        let [_, wall_east, _, wall_west] = cavity.walls();
        self.add(&[east, west, block.base()], true);
        self.add(&[reversed(wall_east), reversed(wall_west)], true);
        self.add(&[quad([a, i, l, d]), quad([j, b, c, k])], true);
        self.add(&[quad(cavity.ring(false))], true);
        self.groove_ends(&block, &cavity);
        self.material.push(Piece::Frustum(block));
        self.cavity = Some(Piece::Frustum(cavity));
    }

    /// The U-shaped end faces: beside the opening left and right, and below it.
    fn groove_ends(&mut self, block: &Frustum, cavity: &Frustum) {
        let mut floor = *block;
        floor.top = cavity.bottom;
        let [south, _, north, _] = floor.walls();
        let at = |half: f64, side: f64, z: f64| V3::new(side * half, -block.above[1], z);
        let end = |side: f64| {
            let (low, high) = (cavity.bottom, cavity.top);
            let [outer, top, bottom] = [block.above[0], cavity.above[0], cavity.below[0]];
            [at(bottom, side, low), at(outer, side, low), at(outer, side, high), at(top, side, high)]
        };
        let mirrored = |corners: [V3; 4]| corners.map(|p| V3::new(p.x, -p.y, p.z));
        let (right, left) = (end(1.0), end(-1.0));
        let faces = [quad(right), reversed(quad(left)), reversed(quad(mirrored(right))), quad(mirrored(left))];
        self.add(&faces, false);
        self.add(&[south, north], false);
    }

    /// Adds faces and, with `rims`, their edges and corners, each once. Faces come first in the list.
    fn add(&mut self, quads: &[Quad], rims: bool) {
        for (at, quad) in quads.iter().enumerate() {
            self.features.insert(at, Feature::Quad(*quad));
            if !rims {
                continue;
            }
            for (a, b) in quad.edges() {
                self.add_once(Feature::Segment(Segment { a, b }), Feature::Segment(Segment { a: b, b: a }));
                self.add_once(Feature::Point(a), Feature::Point(a));
            }
        }
    }

    fn add_once(&mut self, feature: Feature, same: Feature) {
        if !self.features.contains(&feature) && !self.features.contains(&same) {
            self.features.push(feature);
        }
    }
}

impl Piece {
    fn contains(&self, p: &V3) -> bool {
        match self {
            Piece::Frustum(frustum) => frustum.contains(p),
            Piece::Round { lobes, depth } => p.z <= 0.0 && p.z >= -depth && p.xy().norm() <= lobes.radius_at(p),
            Piece::Ball { radius } => p.norm() <= *radius,
        }
    }
}

fn lobes(diameter: f64, errors: &PartErrors) -> Lobes {
    let (amplitude, count) = errors.out_of_round;
    Lobes { radius: (diameter + errors.size) / 2.0, slope: errors.taper / 2.0, amplitude, count }
}

/// Greatest radius of a wall, mm.
fn widest(lobes: &Lobes, depth: f64) -> f64 {
    lobes.radius + (lobes.slope * depth).max(0.0) + lobes.amplitude.abs()
}

/// The upper face between an outer and an inner ring of corners.
fn between([a, b, c, d]: [V3; 4], [i, j, k, l]: [V3; 4]) -> [Quad; 4] {
    [[a, b, j, i], [b, c, k, j], [c, d, l, k], [d, a, i, l]].map(quad)
}
