//! What stays active until it is programmed anew.

use super::contour::Outside;
use super::transformed::Axes;
use crate::control::Transverse;
use crate::diagnostic::Span;

/// Modal functions of a program.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Modal {
    /// G0, G1, G2, G3.
    pub motion: Motion,
    /// G90 or G91.
    pub absolute: bool,
    /// F as programmed, in the unit of that moment.
    pub feed: f64,
    /// mm in a unit of F.
    pub feed_factor: f64,
    pub feed_type: FeedType,
    /// S of the main spindle, revolutions a minute.
    pub speed: f64,
    /// LIMS: greatest speed of the spindle with G96, revolutions a minute.
    pub speed_limit: Option<f64>,
    /// The pole of polar coordinates: abscissa and ordinate of the WCS, mm.
    pub pole: [f64; 2],
    /// RNDM: radius of all corners between lines, mm; 0: none.
    pub rounding: f64,
    /// FRCM: feed of corners, as F is written; 0: that of the block.
    pub corner_feed: f64,
    /// T that is waiting for M6.
    pub prepared: Option<i64>,
    /// D programmed with T and before M6.
    pub waiting_edge: Option<i64>,
    /// G40, G41 or G42.
    pub compensation: Compensation,
    /// G450 or G451: how compensation goes round the outside of a corner.
    pub outside: Outside,
    /// OFFN: what is left of the contour beside the radius, mm.
    pub allowance: f64,
    /// Whether axis words move anything: not between TRANSMIT and TRAFOOF.
    pub axes: Axes,
    /// NCT: the drilling cycle that is active.
    pub drilling: Option<Span>,
    /// NCT: register of the tool radius (D).
    pub radius: i64,
    /// How X is written by itself and by the channel.
    pub diameters: Diameters,
}

/// What counts for X is in the control; this is what stands behind it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Diameters {
    /// What the channel has while X has a mode of its own (`DIAMONA[X]`); none: X has that of the channel.
    pub channel: Option<Transverse>,
    /// DIAMCYCOF is the last of the channel's functions.
    pub cycles: bool,
}

/// How a block with axis words moves, up to CIP in the order in which the control counts these functions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Motion {
    /// G0.
    #[default]
    Rapid,
    /// G1.
    Line,
    /// G2: clockwise, seen against the applicate.
    Clockwise,
    /// G3.
    Counter,
    /// CIP: through an intermediate point.
    Through,
    /// A spline or polynomial, of which only the programmed points are passed.
    Spline,
    /// CT: an arc of the plane that goes on as the last motion ended.
    Tangential,
}

impl Motion {
    /// Whether a block is driven on a straight line.
    pub fn is_straight(self) -> bool {
        matches!(self, Motion::Rapid | Motion::Line | Motion::Spline)
    }
}

/// What F means: G94 a way a minute, G95 (and G96, G97) a way a revolution, G93 blocks a minute.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum FeedType {
    /// mm or inch a minute.
    #[default]
    Minute,
    /// Parts of the block a minute (G93): 1 by the time in which it is driven.
    Inverse,
    /// mm or inch a revolution of the spindle.
    Revolution,
    /// mm or inch a revolution of a spindle with a constant cutting speed (G96), m or feet a minute.
    Cutting,
    /// mm or inch a minute, beside a constant cutting speed (G961).
    CuttingMinute,
}

/// Side on which the tool stands, in the order of the G functions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Compensation {
    /// G40: the tool centre goes on the programmed path.
    #[default]
    Off,
    /// G41: left of the path.
    Left,
    /// G42: right of it.
    Right,
}
