//! What the values of a form mean, drawn: plain figures in mm of the working plane (or of a section through it),
//! each with the parameter that it explains. The page draws them; no colour and no pixel is decided here.

pub mod figures;

use crate::name::Name;
use serde::{Serialize, Serializer};

/// From where the drawing is seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum View {
    /// Onto the working plane: abscissa to the right, ordinate up.
    Plane,
    /// Section: measuring axis to the right, applicate up.
    Section,
    /// All three axes, from beside and above.
    Space,
}

/// What a figure stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(test, derive(ts_rs::TS))]
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
    /// Point to be touched, or to which positions refer.
    Touch,
    /// Working plane, as it lies in space.
    Plane,
}

/// One figure.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct PictureShape {
    /// What it stands for.
    pub kind: ShapeKind,
    /// Polyline, or polygon when `closed`, mm; a dimension: its two ends.
    pub points: Vec<[f64; 2]>,
    /// Circle: centre and radius, mm.
    #[serde(skip_serializing_if = "Option::is_none", serialize_with = "circle")]
    #[cfg_attr(test, ts(optional, type = "{ x: number, y: number, r: number }"))]
    pub circle: Option<([f64; 2], f64)>,
    /// A round opening in it: centre and radius, mm.
    #[serde(skip_serializing_if = "Option::is_none", serialize_with = "circle")]
    #[cfg_attr(test, ts(optional, type = "{ x: number, y: number, r: number }"))]
    pub opening: Option<([f64; 2], f64)>,
    /// Whether the last point joins the first.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    #[cfg_attr(test, ts(optional, as = "Option<bool>"))]
    pub closed: bool,
    /// Name of a parameter or a number; never a sentence.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub text: Option<String>,
    /// Parameter that it explains.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub field: Option<Name>,
    /// Parameters without a figure of their own that are shown here too.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[cfg_attr(test, ts(optional, as = "Option<Vec<Name>>"))]
    pub also: Vec<Name>,
}

/// A drawing.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Picture {
    /// From where.
    pub view: View,
    /// Figures, those in front last.
    pub shapes: Vec<PictureShape>,
}

fn circle<S: Serializer>(circle: &Option<([f64; 2], f64)>, to: S) -> Result<S::Ok, S::Error> {
    let members = circle.iter().flat_map(|([x, y], r)| [("x", x), ("y", y), ("r", r)]);
    to.collect_map(members)
}

impl Picture {
    /// With coordinates far finer than a pixel and no finer: a third less text at every keystroke.
    pub fn rounded(mut self) -> Picture {
        let points = self.shapes.iter().flat_map(|shape| &shape.points);
        let largest = points.flatten().fold(0.0_f64, |most, value| most.max(value.abs()));
        let parts = 10_f64.powi(6 - largest.max(1e-9).log10().ceil() as i32);
        let near = |value: &mut f64| *value = (*value * parts).round() / parts;
        for shape in &mut self.shapes {
            shape.points.as_flattened_mut().iter_mut().for_each(near);
            for ([x, y], r) in shape.circle.iter_mut().chain(&mut shape.opening) {
                [x, y, r].into_iter().for_each(near);
            }
        }
        self
    }

    /// Whether any figure explains the parameter.
    pub fn explains(&self, name: Name) -> bool {
        self.shapes.iter().any(|shape| shape.field == Some(name))
    }
}
