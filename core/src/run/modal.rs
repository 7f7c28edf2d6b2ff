//! What stays in force until it is programmed anew.

use super::contour::Outside;

/// Modal functions of a program.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Modal {
    /// G0, G1, G2, G3.
    pub motion: Motion,
    /// G90 or G91.
    pub absolute: bool,
    /// F as programmed, in the unit of that moment.
    pub feed: f64,
    /// mm in a unit of F.
    pub feed_factor: f64,
    /// What F means.
    pub feed_type: FeedType,
    /// S of the main spindle, revolutions a minute.
    pub speed: f64,
    /// LIMS: greatest speed of the spindle with G96, revolutions a minute.
    pub speed_limit: Option<f64>,
    /// The pole of polar coordinates: abscissa and ordinate of the WCS, mm.
    pub pole: [f64; 2],
    /// T that is waiting for M6.
    pub prepared: Option<i64>,
    /// D programmed after T and before M6.
    pub waiting_edge: Option<i64>,
    /// G40, G41 or G42.
    pub compensation: Compensation,
    /// G450 or G451: how compensation goes round the outside of a corner.
    pub outside: Outside,
    /// OFFN: what is left of the contour beside the radius, mm.
    pub allowance: f64,
    /// NCT: register of the tool radius (D).
    pub radius: i64,
}

impl Modal {
    /// What is in force before the first block, but for this motion; `factor`: mm in the unit of F.
    pub fn start(motion: Motion, factor: f64) -> Modal {
        Modal {
            motion,
            absolute: true,
            feed: 0.0,
            feed_factor: factor,
            feed_type: FeedType::Minute,
            speed: 0.0,
            speed_limit: None,
            pole: [0.0; 2],
            prepared: None,
            waiting_edge: None,
            compensation: Compensation::Off,
            outside: Outside::Circle,
            allowance: 0.0,
            radius: 0,
        }
    }
}

/// How a block with axis words moves, in the order in which the control counts these functions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Motion {
    /// G0.
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
}

/// What F means: G94 a way a minute, G95 (and G96, G97) a way a revolution.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FeedType {
    /// mm or inch a minute.
    Minute,
    /// mm or inch a revolution of the spindle.
    Revolution,
    /// The same, of a spindle that turns as fast as the cutting speed S wants at the diameter (G96): m or feet a
    /// minute.
    Cutting,
}

/// Side on which the tool stands, in the order of the G functions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Compensation {
    /// G40: the tool centre goes on the programmed path.
    Off,
    /// G41: left of the path.
    Left,
    /// G42: right of it.
    Right,
}
