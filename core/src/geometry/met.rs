//! Where something that moves touches, and how it stands before.

use super::V3;
use nalgebra::IsometryMatrix3;

/// Where something that moves touches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Met {
    /// Length of the way until then, mm; 0 where it touches at the start already.
    pub way: f64,
    /// Point touched.
    pub point: V3,
    /// Unit normal there, towards what moves.
    pub normal: V3,
}

impl Met {
    /// What is met in a system that stands there, seen from outside of it.
    pub fn placed(self, place: &IsometryMatrix3<f64>) -> Met {
        let point = place.transform_point(&self.point.into()).coords;
        Met { point, normal: place.rotation * self.normal, ..self }
    }
}

/// The earliest of several.
pub fn earliest(met: impl IntoIterator<Item = Met>) -> Option<Met> {
    met.into_iter().min_by(|a, b| a.way.total_cmp(&b.way))
}

/// How a ball stands at a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stand {
    /// Nothing is touched.
    Free,
    /// It reaches into the surface: nearest point, direction out, how deep, mm.
    Inside(V3, V3, f64),
    /// It touches and is to move into the surface: point and direction out.
    Pressed(V3, V3),
}
