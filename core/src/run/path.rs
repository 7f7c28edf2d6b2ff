//! What the axis words of a block ask for: the target, and how it is reached.

use crate::diagnostic::Span;
use crate::geometry::Degrees;

/// How a block measures its positions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Suppress {
    /// In the WCS.
    #[default]
    Nothing,
    /// G53: without settable and programmed frame.
    Settable,
    /// G153, SUPA: without any frame.
    All,
}

/// A coordinate as it is written, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coordinate {
    pub value: f64,
    /// AC (true) or IC (false); none: as usual for this address.
    pub absolute: Option<bool>,
    /// By its diameter (true) or radius (false), in this block alone; none: as is active for the axis.
    pub diameter: Option<bool>,
}

/// What a block says of a point by angle and distance.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Polar {
    /// AP: from the abscissa, degree.
    pub angle: Option<Coordinate>,
    /// RP: from the pole, mm.
    pub radius: Option<Coordinate>,
}

impl Polar {
    /// Whether it says anything.
    pub fn is_written(&self) -> bool {
        self.angle.is_some() || self.radius.is_some()
    }
}

/// From where a new pole counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pole {
    /// G110: from where the axes stand.
    Position,
    /// G111: from the zero of the WCS.
    Zero,
    /// G112: from the pole before.
    Before,
}

/// A measuring block.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Measure {
    /// Number of the input, sign for the edge.
    pub input: i64,
    /// MEAW: the motion goes on to its end behind the signal.
    pub goes_on: bool,
}

/// What stands between two lines instead of their corner, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Corner {
    /// RND, RNDM: an arc with this radius.
    Radius(f64),
    /// CHF: a chamfer of this length.
    Chamfer(f64),
    /// CHR: a chamfer that begins so far before the corner.
    Leg(f64),
}

impl Corner {
    /// How a block asks for it.
    pub fn word(self) -> &'static str {
        match self {
            Corner::Radius(_) => "RND",
            Corner::Chamfer(_) => "CHF",
            Corner::Leg(_) => "CHR",
        }
    }
}

/// Axis words of one block.
#[derive(Clone, Debug, Default)]
pub struct Path {
    pub axes: [Option<Coordinate>; 3],
    /// Where the rotary axes A B C go, machine.
    pub rotary: [Option<Degrees>; 3],
    /// Centre I J K, from the start unless absolute.
    pub centre: [Option<Coordinate>; 3],
    /// Intermediate point I1 J1 K1 of CIP.
    pub middle: [Option<Coordinate>; 3],
    /// AP and RP.
    pub polar: Polar,
    /// The block tells a new pole, and nothing moves.
    pub pole: Option<Pole>,
    /// CR or R: radius, negative for more than a half circle.
    pub radius: Option<f64>,
    /// AR: opening angle, degree.
    pub angle: Option<f64>,
    /// ANG: angle of a line from the abscissa, degree.
    pub slope: Option<f64>,
    /// TURN: whole turns before the end.
    pub turns: f64,
    /// Frames left out in this block.
    pub suppress: Suppress,
    /// MEAS or MEAW.
    pub measure: Option<Measure>,
    /// Whether F is a time (G4).
    pub dwell: bool,
    /// FB: feed of this block alone, as F is written.
    pub feed: Option<f64>,
    /// RND, CHF, CHR: the corner behind the block.
    pub corner: Option<Corner>,
    /// FRC: feed of that corner, as F is written.
    pub corner_feed: Option<f64>,
    /// Whether the axis words are no target of a motion.
    pub stays: bool,
    /// Whether the block moves all the same, to where only the machine knows.
    pub elsewhere: bool,
    pub span: Span,
}

impl Path {
    /// Whether the block moves.
    pub fn moves(&self) -> bool {
        let written = |list: &[Option<Coordinate>; 3]| list.iter().any(Option::is_some);
        let arc = self.radius.is_some() || self.angle.is_some();
        let polar = self.polar.is_written() || self.pole.is_some();
        let asked = written(&self.axes) || written(&self.centre) || written(&self.middle);
        !self.stays && (asked || arc || polar)
    }
}
