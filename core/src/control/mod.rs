//! State of the control: plane, units, frames, tools, user data. Plain data with the manual's bookkeeping.

pub mod arrays;
pub mod braking;
mod calibration;
pub mod data;
pub mod definitions;
pub mod delivery;
pub mod environments;
mod frame;
pub mod frames;
pub mod gud;
pub mod idle;
pub mod limits;
pub mod machine_data;
mod machine_sort;
mod make;
pub mod nct_data;
pub mod needs;
pub mod probe;
pub mod rotary;
pub mod setting_data;
pub mod tools;
pub mod units;
pub mod variables;
pub mod versions;

pub use calibration::Calibration;
pub use data::{Data, FORMS, GENERATION, OF_LISTS, OLDER_JOG};
pub use definitions::{Definition, Definitions};
pub use delivery::{
    BASIC_SYSTEM, CALIBRATED, UNITS_OF_CHANNEL, UNITS_OF_CONTROL, delivery, delivery_in, more_fields, rebuilt,
};
pub use environments::Environment;
pub use frame::Frame;
pub use frames::Store;
pub use limits::Limits;
pub use machine_data::TOOL_LENGTH_TYPE;
pub use machine_sort::MachineSort;
pub use make::{FALSE_TRIGGER, Make, NCT, PATH_OBSTRUCTED};
pub use probe::upright;
pub use rotary::ROTARY;
pub use tools::{AS_TURNING_TOOL, LATHE_PROBE};
pub use units::UnitFunction;
pub use variables::AXES;

use crate::dialect::Dialect;
use crate::geometry::{Degrees, Mcs};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Working plane.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum Plane {
    /// X abscissa, Y ordinate, Z applicate.
    #[default]
    G17,
    /// Z abscissa, X ordinate, Y applicate.
    G18,
    /// Y abscissa, Z ordinate, X applicate.
    G19,
}

impl Plane {
    /// All of them.
    pub const ALL: [Plane; 3] = [Plane::G17, Plane::G18, Plane::G19];

    /// The plane of G17, G18 or G19; none: another function.
    pub fn of(code: u16) -> Option<Plane> {
        Plane::ALL.into_iter().nth(usize::from(code.checked_sub(17)?))
    }

    /// 17, 18 or 19.
    pub const fn code(self) -> u16 {
        17 + self as u16
    }

    /// Indices (X = 0, Y = 1, Z = 2) of abscissa, ordinate, applicate.
    pub const fn axes(self) -> [usize; 3] {
        match self {
            Plane::G17 => [0, 1, 2],
            Plane::G18 => [2, 0, 1],
            Plane::G19 => [1, 2, 0],
        }
    }
}

/// How the program gives positions of the transverse axis X of a lathe.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum Transverse {
    /// DIAMOF: radii.
    #[default]
    #[serde(rename = "DIAMOF")]
    Radius,
    /// DIAMON: diameters.
    #[serde(rename = "DIAMON")]
    Diameter,
    /// DIAM90: diameters where the position is absolute.
    #[serde(rename = "DIAM90")]
    AbsoluteDiameter,
}

impl Transverse {
    /// What a position is multiplied with when the program reads it.
    pub const fn shown(self) -> f64 {
        match self {
            Transverse::Radius => 1.0,
            Transverse::Diameter | Transverse::AbsoluteDiameter => 2.0,
        }
    }
}

/// System of units.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema))]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "BasicSystem"))]
pub enum Units {
    /// mm.
    #[default]
    #[serde(rename = "mm")]
    Metric,
    /// inch.
    #[serde(rename = "inch")]
    Inch,
}

/// The frames between machine and settable frame.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BasicFrames {
    /// System frame: `$P_SETFR`, in effect `$P_SETFRAME`.
    pub system: Frame,
    /// NCU-global: `$P_NCBFR[0..15]`, in effect `$P_NCBFRAME[0..15]`.
    pub global: BTreeMap<usize, Frame>,
    /// Of the channel: `$P_CHBFR[0..15]`, in effect `$P_CHBFRAME[0..15]`.
    pub channel: BTreeMap<usize, Frame>,
}

/// Cutting edge data of a tool.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Edge {
    /// `$TC_DP1` tool type: 710 3D probe, 120 end mill, 580 probe of a turning machine.
    pub kind: i64,
    /// `$TC_DP2` cutting edge position of a turning tool or lathe probe, 1 to 9; 0 of tools that have none.
    pub tip: i64,
    /// Geometry L1 L2 L3, mm.
    pub length: [f64; 3],
    /// Geometry radius, mm.
    pub radius: f64,
    /// Wear L1 L2 L3, mm.
    pub length_wear: [f64; 3],
    /// Wear of the radius, mm.
    pub radius_wear: f64,
    /// Additive offsets by DL number 1..6: L1 L2 L3 radius, mm.
    pub additive: BTreeMap<i64, [f64; 4]>,
    /// Setup offsets by DL number 1..6: L1 L2 L3 radius, mm.
    pub setup: BTreeMap<i64, [f64; 4]>,
    /// Tool data that are only kept: `$TC_DP7` to 11 and 16 to 25; 21 to 23, of the adapter, count with L1 L2 L3, mm.
    pub further: BTreeMap<usize, f64>,
}

/// A tool.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tool {
    /// Name under tool management.
    pub name: String,
    /// Edges by D number.
    pub edges: BTreeMap<i64, Edge>,
}

/// A value of user data.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
#[cfg_attr(feature = "cli", derive(schemars::JsonSchema), schemars(rename = "DatumFile"))]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "Datum"))]
pub enum Value {
    /// Number (REAL, INT, BOOL).
    Number(f64),
    /// STRING.
    Text(String),
}

/// The control; see [`delivery()`] for a new one.
#[derive(Clone, Debug, PartialEq)]
pub struct Control {
    /// Which one.
    pub dialect: Dialect,
    /// Basic system of units of the machine.
    pub basic_units: Units,
    /// Active system (G70/G71/G700/G710, G20/G21).
    pub active_units: Units,
    /// Whether feeds and the lengths that the control keeps (tools, frames, positions) count in the active system as
    /// well: with G700 and G710, and on NCT; with G70 and G71 they count in the basic one.
    pub data_follow: bool,
    /// Working plane.
    pub plane: Plane,
    /// How positions of X are given.
    pub transverse: Transverse,
    /// Whether a macro of NCT is called in incremental dimension, so that the addresses of G101 are ways (C:108).
    pub incremental: bool,
    /// Number of the active settable frame: 0 G500, 1..4 G54..G57, 5..99 G505..G599. NCT: 1..6 G54..G59.
    pub settable: usize,
    /// Settable frames by number (NCT: 0 common, 1..6).
    pub frames: BTreeMap<usize, Frame>,
    /// Basic frames as stored.
    pub stored: BasicFrames,
    /// Basic frames in effect: as stored when G500, G54.. was programmed last.
    pub basic: BasicFrames,
    /// Settable frame as activated by G54..; a correction becomes active only with the next G54...
    pub active: Frame,
    /// Programmed frame (TRANS, ROT and their additive forms), innermost.
    pub program_frame: Frame,
    /// Plane of CYCLE800, `$P_WPFRAME`, between settable and programmed frame.
    pub plane_frame: Frame,
    /// Frame of a swivel table, `$P_PARTFRAME`, outermost: how the table has turned the part (CYCLE800).
    pub part_frame: Frame,
    /// Tools by T number.
    pub tools: BTreeMap<i64, Tool>,
    /// Tool environments by name.
    pub environments: BTreeMap<String, Environment>,
    /// T number in the spindle, 0 none.
    pub tool: i64,
    /// Active D (NCT: H) number, 0 none.
    pub edge: i64,
    /// Active DL number, whose additive and setup offsets count with the edge; 0 none.
    pub location: i64,
    /// User data: GUD arrays and scalars (`_WP[0,1]`, `_CHBIT[4]`, `_OVR[4]`, `_EV[9]`, `_KNUM`), R parameters (`R10`),
    /// machine data (`MD18600`), NCT variables (`#500`); indices written without blanks.
    pub data: Data,
    /// User data that definition files add; shared, as a control is copied at every keystroke.
    pub definitions: Arc<Definitions>,
    /// Position of the spindle, positive as M3 turns it.
    pub spindle: Degrees,
    /// Speed of the spindle, 1/min: positive with M3, negative with M4; 0: it stands.
    pub spindle_speed: f64,
    /// Whether the spindle can be positioned with SPOS (B:864, B:6312).
    pub spindle_positions: bool,
    /// How far the workpiece probe may be deflected in the directions of measuring, mm; none: it is not known.
    pub deflection: Option<f64>,
    /// Where the rotary axes A B C stand, machine.
    pub rotary: [Degrees; 3],
    /// Point on the lines about which they turn, mm.
    pub rotary_centre: Mcs,
    /// Software limit switches.
    pub limits: Limits,
}

impl Control {
    /// How far what the spindle holds is turned from the abscissa to the ordinate. M3 turns a tool clockwise as
    /// seen from the spindle, so from the ordinate to the abscissa; the delivered sense of `_CHBIT[14]` is that one,
    /// 270 degree of the spindle for 90 of the coordinates (B:13985).
    pub fn turned(&self) -> Degrees {
        Degrees(0.0) - self.spindle
    }

    /// A datum as number; 0 where it was never set.
    pub fn number(&self, name: &str) -> f64 {
        match self.data.get(name) {
            Some(Value::Number(value)) => *value,
            _ => 0.0,
        }
    }

    /// A datum as text; empty where it was never set.
    pub fn text(&self, name: &str) -> &str {
        match self.data.get(name) {
            Some(Value::Text(value)) => value,
            _ => "",
        }
    }

    /// Writes a number. A 0 has no sign: what is calculated with it later, and what is shown, has none either.
    pub fn set(&mut self, name: impl Into<String>, value: f64) {
        self.data.insert(name.into(), Value::Number(value + 0.0));
    }

    /// Whether a bit of a machine datum (`MD28082`, bit 5) is 1.
    pub fn machine_bit(&self, name: &str, bit: u32) -> bool {
        (self.number(name) as i64) >> bit & 1 == 1
    }

    /// Whether a bit datum (`_CHBIT[4]`) is 1.
    pub fn bit(&self, name: &str) -> bool {
        self.number(name) == 1.0
    }
}
