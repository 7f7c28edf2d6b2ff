//! What the values of a form mean, drawn: plain figures in mm of the working plane (or of a section through it),
//! each with the parameter that it explains. The page draws them; no colour and no pixel is decided here.

pub mod figures;

use crate::name::Name;
/// From where the drawing is seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum View {
    /// Onto the working plane: abscissa to the right, ordinate up.
    Plane,
    /// Section: measuring axis to the right, applicate up.
    Section,
}

/// What a figure stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShapeKind {
    /// Material, seen from above.
    Material,
    /// Material, cut by the section plane.
    Cut,
    /// Edge of the part to be measured.
    Edge,
    /// Protection zone.
    Zone,
    /// The probe's ball.
    Probe,
    /// Way of the ball centre.
    Path,
    /// Dimension line between its two points.
    Dimension,
    /// Text at its point.
    Label,
    /// Tolerance band or other permitted area.
    Tolerance,
    /// Axis of the coordinate system.
    Axis,
    /// Point to be touched.
    Touch,
}

/// One figure.
#[derive(Clone, Debug, PartialEq)]
pub struct PictureShape {
    /// What it stands for.
    pub kind: ShapeKind,
    /// Polyline, or polygon when `closed`, mm; a dimension: its two ends.
    pub points: Vec<[f64; 2]>,
    /// Circle: centre and radius, mm.
    pub circle: Option<([f64; 2], f64)>,
    /// A round opening in it: centre and radius, mm.
    pub opening: Option<([f64; 2], f64)>,
    /// Whether the last point joins the first.
    pub closed: bool,
    /// Name of a parameter or a number; never a sentence.
    pub text: Option<String>,
    /// Parameter that it explains.
    pub field: Option<Name>,
    /// Parameters without a figure of their own that are shown here too.
    pub also: Vec<Name>,
}

/// A drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// From where.
    pub view: View,
    /// Figures, those in front last.
    pub shapes: Vec<PictureShape>,
}

impl Picture {
    /// Whether any figure explains the parameter.
    pub fn explains(&self, name: Name) -> bool {
        self.shapes.iter().any(|shape| shape.field == Some(name))
    }
}
