//! A solid taken apart into faces, edges and corners, in its own frame (origin at the upper face, Z up).

use super::{Column, Columns, Form, FreeSurface, Material, Solid, form::between};
use crate::geometry::{Circle, Dir, Extent, Feature, LobedWall, Lobes, Mcs, Quad, Segment, Trim, V3, Wall};
use nalgebra::{IsometryMatrix3, Point3};
use std::sync::Arc;

/// Material beside an inner element, and plate around an outer one, mm.
const MARGIN: f64 = 20.0;
/// Thickness of a floor or plate, mm.
const FLOOR: f64 = 10.0;
/// Material around an opening.
const AROUND: Material = Material { beside: [1.0, MARGIN], below: [1.0, FLOOR] };

/// Boundary and inside of a solid.
#[derive(Clone, Debug, Default)]
pub(crate) struct Body {
    /// Own frame → machine.
    pub place: IsometryMatrix3<f64>,
    /// Boundary.
    pub features: Vec<Feature>,
    /// Triangles of a free surface.
    pub free: Option<Arc<FreeSurface>>,
    /// Boxes around each of the features.
    pub extents: Vec<Extent>,
    /// Box around all of them.
    pub extent: Extent,
    /// What is full.
    pub material: Vec<Column>,
    /// What of that is open.
    pub cavity: Option<Column>,
}

impl Body {
    /// Takes a solid apart, its errors applied.
    pub fn new(solid: &Solid) -> Body {
        Body::of(solid.place(), solid.form())
    }

    pub fn of(place: IsometryMatrix3<f64>, form: Form) -> Body {
        let mut body = Body { place, ..Body::default() };
        match form {
            Form::Columns(columns) => body.columns(&columns),
            Form::Ball(radius) => body.features.push(Feature::Ball(V3::zeros(), radius)),
            Form::Free(surface) => {
                body.extent = Extent::of(surface.bounds().map(V3::from));
                body.free = Some(surface);
            }
        }
        // of what is touched at once, a face wins over its edges
        body.features.sort_by_key(|feature| !matches!(feature, Feature::Quad(_)));
        body.extents = body.features.iter().map(Extent::around).collect();
        body.extent = body.extents.iter().fold(body.extent, |all, one| all.with(one));
        body
    }

    /// How far the box around it reaches in a direction of the machine, mm.
    pub fn farthest(&self, direction: Dir<Mcs>) -> f64 {
        let (Extent { low, high }, direction) = (self.extent, V3::from(direction));
        let end = |corner: usize, axis: usize| if corner >> axis & 1 == 0 { low[axis] } else { high[axis] };
        let corners = (0..8).map(|corner| self.place * Point3::new(end(corner, 0), end(corner, 1), end(corner, 2)));
        corners.map(|corner| corner.coords.dot(&direction)).fold(f64::NEG_INFINITY, f64::max)
    }

    /// Whether a point lies in the material.
    pub fn inside(&self, p: &V3) -> bool {
        if let Some(free) = &self.free {
            return free.mesh.covers(p);
        }
        let within = |feature: &Feature| matches!(feature, Feature::Ball(_, radius) if p.norm() <= *radius);
        let full = self.material.iter().any(|column| column.contains(p)) || self.features.iter().any(within);
        full && !self.cavity.as_ref().is_some_and(|column| column.contains(p))
    }

    fn columns(&mut self, columns: &Columns) {
        let Columns { opening, plate, through, .. } = *columns;
        let outer = columns.outer(&AROUND);
        self.walls(&outer, false, through);
        self.add(outer.faces(true, opening.as_ref().map(|opening| (opening, true))), through);
        if let Some(opening) = &opening {
            self.walls(opening, true, through);
            self.add(opening.faces(false, None), through);
            if through {
                let [walls, inner] = [outer, *opening].map(|column| column.hull().walls());
                for side in [0, 2] {
                    self.add(between(walls[side].corners, inner[side].corners), false);
                }
            }
        }
        self.material.push(outer);
        self.cavity = opening;
        if plate {
            let plate = Column::Straight(outer.hull().plate(MARGIN, FLOOR));
            self.walls(&plate, false, false);
            self.add(plate.faces(true, Some((&outer, false))), false);
            self.base(&plate);
            self.material.push(plate);
        } else {
            self.base(&outer);
        }
    }

    /// The walls of a column with their edges; of one that goes through along Y those at its sides.
    fn walls(&mut self, column: &Column, inner: bool, through: bool) {
        match column {
            Column::Straight(frustum) => {
                let walls = frustum.walls().into_iter().enumerate().filter(|(side, _)| !through || side % 2 == 1);
                let walls = walls.map(|(_, wall)| if inner { wall.reversed() } else { wall });
                self.add(walls.collect(), true);
            }
            Column::Round(lobes, depth) => {
                let (lobes, depth) = (*lobes, *depth);
                let Lobes { radius, slope, amplitude, .. } = lobes;
                self.features.push(match amplitude == 0.0 {
                    true => Feature::Wall(Wall { radius, slope, depth, inner }),
                    false => Feature::Lobed(LobedWall { lobes, depth }),
                });
                self.rim(&lobes, 0.0);
            }
        }
    }

    /// Edge of a round wall at this height; a wall with lobes has it already.
    fn rim(&mut self, lobes: &Lobes, z: f64) {
        if lobes.amplitude == 0.0 {
            self.features.push(Feature::Circle(Circle { radius: lobes.radius - lobes.slope * z, z }));
        }
    }

    /// The lower face of a column with its edges.
    fn base(&mut self, column: &Column) {
        let faces = column.faces(false, None).into_iter().map(Quad::reversed);
        self.add(faces.collect(), true);
        if let Column::Round(lobes, depth) = column {
            self.rim(lobes, -depth);
        }
    }

    /// Adds faces and, with `rims`, the edges and corners of whole ones, each once.
    fn add(&mut self, quads: Vec<Quad>, rims: bool) {
        for quad in quads {
            self.features.push(Feature::Quad(quad));
            if !rims || quad.trim != Trim::default() {
                continue;
            }
            for (a, b) in quad.edges() {
                self.edge(a, b);
                self.corner(a);
            }
        }
    }

    fn edge(&mut self, a: V3, b: V3) {
        let same = |edge: &Segment| edge.a == a && edge.b == b || edge.a == b && edge.b == a;
        if !self.features.iter().any(|known| matches!(known, Feature::Segment(edge) if same(edge))) {
            self.features.push(Feature::Segment(Segment { a, b }));
        }
    }

    fn corner(&mut self, at: V3) {
        if !self.features.iter().any(|known| matches!(known, Feature::Ball(centre, _) if *centre == at)) {
            self.features.push(Feature::Ball(at, 0.0));
        }
    }
}
