//! Parametric parts with their errors, and the probe that touches them.

pub(crate) mod body;
pub mod chuck;
pub mod contact;
#[cfg(test)]
mod contact_tests;
pub mod feeler;
#[cfg(test)]
pub(crate) mod feeler_tests;
pub(crate) mod form;
pub mod free;
pub mod noise;
pub mod probe;
#[cfg(test)]
mod probe_tests;
mod reach;
pub mod seen;
mod table;
pub mod tool;
pub mod tool_probe;
#[cfg(test)]
mod tool_tests;

pub(crate) use body::Body;
pub use contact::{Boundary, Contact};
pub use feeler::{Feeler, Obstacle, Touching};
pub(crate) use form::{Column, Columns, Form, Material};
pub use free::{FreeSurface, Heights};
pub use noise::Noise;
pub use seen::{Drawn, Turret};
pub use tool::{Cut, Cutter, Nose, Spindle, Tool};
pub use tool_probe::ToolProbe;

use crate::geometry::{Degrees, Mcs, Rpy, V3, rigid};
use nalgebra::IsometryMatrix3;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// What can be touched. Nominal sizes in mm, in the part's own frame.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// Block with a cylindrical hole about Z, open at the top.
    Hole {
        /// Diameter, mm.
        diameter: f64,
        /// Depth of the flat bottom, mm.
        depth: f64,
    },
    /// Cylinder about Z standing on a plate.
    Shaft {
        /// Diameter, mm.
        diameter: f64,
        /// Height above the plate, mm.
        height: f64,
    },
    /// Groove between two walls facing each other along X.
    Groove {
        /// Distance of the walls, mm.
        width: f64,
        /// Depth of the floor, mm.
        depth: f64,
        /// Length along Y, mm; both ends are open.
        length: f64,
    },
    /// Web between two walls facing away along X.
    Web {
        /// Distance of the walls, mm.
        width: f64,
        /// Height above the plate, mm.
        height: f64,
        /// Length along Y, mm.
        length: f64,
    },
    /// Rectangular pocket, X × Y.
    Pocket {
        /// X and Y, mm.
        length: [f64; 2],
        /// Depth of the floor, mm.
        depth: f64,
    },
    /// Rectangular island, X × Y.
    Island {
        /// X and Y, mm.
        length: [f64; 2],
        /// Height above the plate, mm.
        height: f64,
    },
    /// Block with a corner of any angle at the origin. Its edges run from there along X and along a direction that is
    /// turned counter-clockwise from X; opposite walls are parallel.
    OuterCorner {
        /// Angle between the edges, between 0 and 180.
        angle: Degrees,
        /// Lengths of both edges, mm.
        length: [f64; 2],
        /// Z, mm.
        height: f64,
    },
    /// Pocket with a corner of any angle at the origin.
    InnerCorner {
        /// Angle between the edges, between 0 and 180.
        angle: Degrees,
        /// Lengths of both edges, mm.
        length: [f64; 2],
        /// Depth of the floor, mm.
        depth: f64,
    },
    /// Half space below Z = 0, bounded by a rectangle X × Y, thickness Z.
    Block {
        /// X, Y and thickness Z, mm.
        size: [f64; 3],
    },
    /// Cylinder about Z with its front face at the origin, with or without a bore there. The spindle of a turning
    /// machine turns it about its nominal axis. Steps of a turned part are such cylinders one behind the other.
    Turned {
        /// Diameter, mm.
        diameter: f64,
        /// Length, mm.
        length: f64,
        /// Diameter and depth of the bore, mm; diameter 0: none.
        bore: [f64; 2],
    },
    /// Chuck about Z that holds a turned part: its front at the top is that of the jaws, and what can be touched of it
    /// is what they sweep when it turns.
    Chuck {
        /// Diameter, mm.
        diameter: f64,
        /// Length, mm.
        length: f64,
        /// Diameter that the jaws grip, mm.
        grip: f64,
    },
    /// Sphere about the origin.
    Sphere {
        /// Diameter, mm.
        diameter: f64,
    },
    /// Any surface. Of the errors it has displacement and tilt.
    Free(Arc<FreeSurface>),
}

/// What is wrong with a part. All zero: nothing. A sphere has neither taper nor lobes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "camelCase", default)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct PartErrors {
    /// Displacement X Y Z, mm, machine axes.
    pub shift: [f64; 3],
    /// Added to every diameter, width and length, mm.
    pub size: f64,
    /// Turned about the machine's X Y Z (RPY) about the shape's origin, degree.
    pub tilt: Rpy,
    /// Diameter (width, length) grows by this per mm of depth (cone), mm/mm.
    pub taper: f64,
    /// Amplitude of the radius over the angle, mm, and number of lobes: `r + amplitude·cos(lobes·angle)`.
    pub out_of_round: (f64, u32),
}

/// One solid, placed in machine (basic) coordinates.
///
/// ```compile_fail
/// use probewright_core::geometry::Wcs;
/// use probewright_core::workpiece::{Shape, Solid};
/// let ball = Solid::new(Shape::Sphere { diameter: 30.0 }, Wcs([1.0, 2.0, 3.0]));
/// ```
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(test, derive(ts_rs::TS), ts(as = "crate::setup_file::SolidFile"))]
pub struct Solid {
    /// Shape. Its origin is the centre of the upper face (sphere: its own; corner: the corner), Z the depth axis.
    pub shape: Shape,
    /// Position of the origin.
    pub at: Mcs,
    /// Orientation about X Y Z (RPY), degree. G18/G19 elements are turned solids.
    pub rotation: Rpy,
    /// What is wrong with it.
    pub errors: PartErrors,
}

impl Solid {
    /// One without errors whose axes are those of the machine.
    pub fn new(shape: Shape, at: Mcs) -> Solid {
        Solid { shape, at, rotation: Rpy::default(), errors: PartErrors::default() }
    }

    /// From the frame of the solid to the machine, displacement and tilt included.
    pub fn place(&self) -> IsometryMatrix3<f64> {
        let turn = rigid::rotation(self.errors.tilt) * rigid::rotation(self.rotation);
        rigid::placed(V3::from(self.at) + V3::from(self.errors.shift), turn)
    }
}

/// The part: every solid can be touched.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Workpiece {
    /// Solids.
    pub solids: Vec<Solid>,
}

/// The probe as it is, not as the control believes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, rename_all = "camelCase")]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct Probe {
    /// Real ball radius, mm.
    pub radius: f64,
    /// Real length from the spindle nose to the ball centre, mm.
    pub length: f64,
    /// Ball centre minus spindle axis at spindle position 0, X Y, mm. In a turret: ball centre minus the point where L1
    /// and L2 end, abscissa and ordinate; the length does not count there.
    #[serde(default)]
    pub skew: [f64; 2],
    /// Travel after contact until the signal, mm: constant part and amplitude of the three-lobed part.
    #[serde(default)]
    pub pre_travel: (f64, f64),
    /// Delay of the signal, s; multiplies the feed.
    #[serde(default)]
    pub delay: f64,
    /// Standard deviation of the switching point along the travel, mm, and seed of the pseudo-random sequence.
    #[serde(default)]
    pub repeatability: (f64, u64),
    /// Way with the signal watched after which it comes once without contact, mm; none: never.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub false_signal: Option<f64>,
    /// Radius of the straight stylus between ball and body, mm; none: 0.45 of that of the ball; 0: not looked at, for a
    /// stylus of another shape. In a turret it is looked at where `body` tells how long it is.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stylus: Option<f64>,
    /// The body that holds the stylus; none: the stylus goes as far as the spindle.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub body: Option<ProbeBody>,
}

/// The body of a probe: a cylinder as far as the spindle.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct ProbeBody {
    /// Radius, mm.
    pub radius: f64,
    /// From the centre of the ball to its lower face, mm: how long the stylus is.
    pub distance: f64,
}

/// Radius of a stylus in radii of its ball, where nothing else is known.
const STYLUS: f64 = 0.45;

impl Probe {
    /// Radius of the stylus above the ball, mm.
    pub fn stylus_radius(&self) -> f64 {
        self.stylus.unwrap_or(STYLUS * self.radius)
    }

    /// From the centre of the ball to where the stylus is held, mm.
    pub fn held(&self) -> f64 {
        self.body.map_or(self.length, |body| body.distance)
    }
}
