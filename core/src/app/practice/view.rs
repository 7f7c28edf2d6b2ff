//! Practising to measure in JOG: what is asked, and what is on the screen and under the hand then.

use crate::app::ahead::JogAhead;
use crate::app::changes::Change;
use crate::app::help::HelpSection;
use crate::app::jog::JogPoint;
use crate::app::outcome::Raised;
use crate::app::start::Machine;
use crate::dialect::Dialect;
use crate::geometry::Degrees;
use crate::jog::State;
use crate::jog::chance::Truth;
use crate::jog::practice::Piece;
use crate::jog::values::Value;
use crate::message::Message;
use serde::{Deserialize, Serialize};

/// A session of measuring in JOG.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct PracticeRequest {
    /// Control.
    pub control: Dialect,
    /// Machine with its part; absent, and where it has no part or turns: one to practise on.
    pub setup: Option<Machine>,
    /// What lies on the table of the machine to practise on; absent: a block.
    pub piece: Option<Piece>,
    /// What was done, a line a thing.
    pub script: String,
    /// The part lies as chance puts it by this seed; absent: as `part` says.
    pub seed: Option<u32>,
    /// How the part lies; absent: as in the setup.
    pub part: Option<PracticePart>,
    /// Nobody is to know yet how the part lies: what the next key would do is told as far as the call says it.
    #[serde(default)]
    pub hides: bool,
}

/// How a part lies, mm and degree.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize)]
#[serde(default, rename_all = "camelCase")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct PracticePart {
    /// Displacement along X of the machine.
    pub dx: f64,
    /// Along Y.
    pub dy: f64,
    /// Along Z.
    pub dz: f64,
    /// Added to every diameter, width and length.
    pub size: f64,
    /// Turned about the applicate.
    pub tilt: Degrees,
    /// About the abscissa.
    pub lean_abscissa: Degrees,
    /// About the ordinate.
    pub lean_ordinate: Degrees,
}

/// A face of the part in front of which the probe is put.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct PracticeFace {
    /// The session so far.
    pub practice: PracticeRequest,
    /// A point of the face, X Y Z of the machine, mm.
    pub at: [f64; 3],
    /// Direction out of the part there, X Y Z of the machine.
    pub normal: [f64; 3],
}

/// How the probe gets in front of a face.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct PracticeApproach {
    /// The line of a script that moves it there; absent, where nothing is refused: it is there.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub line: Option<String>,
    /// Why it cannot get there.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub refused: Option<Message>,
}

/// What is on the screen and under the hand.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct PracticeView {
    /// The functions as the softkeys have them.
    pub areas: Vec<PracticeArea>,
    /// What is on the screen.
    pub state: State,
    /// The line at which it ended, as it did nothing.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub refused: Option<PracticeRefusal>,
    /// The alarm that is pending, or what was hit.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub raised: Option<Raised>,
    /// What the user should know of the last touch.
    pub notes: Vec<Message>,
    /// The mask that is open.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mask: Option<PracticeMask>,
    /// The activation screen.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub activation: Option<PracticeActivation>,
    /// Keys that do something now.
    pub keys: PracticeKeys,
    /// P1 to P4, where the mask has softkeys for them.
    pub points: Vec<PracticePoint>,
    /// Bits 0 to 7 of the PLC.
    pub plc: [bool; 8],
    /// The machine.
    pub machine: PracticeMachine,
    /// The piece of the machine to practise on; absent: the machine is the user's.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub piece: Option<Piece>,
    /// What the next key would do.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ahead: Option<JogAhead>,
    /// How the part lies.
    pub truth: Truth,
    /// How far the zero offset that the mask wrote is from where it should be.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub deviation: Option<PracticeDeviation>,
    /// What the mask wrote last.
    pub changes: Vec<Change>,
    /// The first entry of the trace that belongs to the last line.
    pub from: usize,
}

/// A softkey of the vertical bar.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct PracticeArea {
    /// What it says.
    pub label: Message,
    /// The masks that it offers.
    pub masks: Vec<PracticeChoice>,
}

/// A mask that can be opened.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct PracticeChoice {
    /// Name in a script.
    pub name: &'static str,
    /// Title.
    pub label: Message,
    /// The piece on which it can be practised.
    pub piece: Piece,
}

/// A line that was not carried out.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct PracticeRefusal {
    /// Its number, from 1.
    pub line: u32,
    /// Why.
    pub message: Message,
    /// What helps.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub hint: Option<Message>,
    /// Lines behind it, which were not carried out either.
    pub left: u32,
}

/// A mask with its values.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct PracticeMask {
    /// Name in a script.
    pub name: &'static str,
    /// Title.
    pub label: Message,
    /// Fields that are shown, in their order.
    pub fields: Vec<PracticeField>,
    /// Whether the user stores each point after its touch; then none is rejected, by the PLC neither.
    pub stores: bool,
    /// Lines of the left part, in their order.
    pub shows: Vec<PracticeShow>,
    /// What to do: sections of its help, in order.
    pub help: Vec<HelpSection>,
}

/// A field of a mask or of the activation screen.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct PracticeField {
    /// Name in a script.
    pub name: &'static str,
    /// What it is called.
    pub label: Message,
    /// `mm` or `deg` of a number, else empty.
    pub unit: &'static str,
    /// What it holds.
    pub value: Value,
    /// What can be chosen; none: it takes a number.
    pub choices: Vec<PracticeWord>,
    /// What is wrong with it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub wrong: Option<Message>,
}

/// A choice.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct PracticeWord {
    /// As a script has it.
    pub word: String,
    /// What it is called; absent: as it is.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub label: Option<Message>,
}

/// A line of the left part.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct PracticeShow {
    /// What it is called.
    pub label: Message,
    /// Name of a zero offset, where the line has one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub offset: Option<String>,
    /// Numbers, each with the letter of its axis; of a result without one.
    pub figures: Vec<PracticeFigure>,
}

/// A number.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct PracticeFigure {
    /// Letter of its axis, or empty.
    pub axis: &'static str,
    /// mm or degree.
    pub value: f64,
    /// `mm` or `deg`.
    pub unit: &'static str,
}

/// The activation screen.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct PracticeActivation {
    /// Its lines.
    pub lines: Vec<Message>,
    /// Its fields.
    pub fields: Vec<PracticeField>,
}

/// Which keys do something.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct PracticeKeys {
    /// NC start.
    pub start: bool,
    /// RESET.
    pub reset: bool,
    /// Calculate.
    pub calculate: bool,
    /// `<<`.
    pub back: bool,
    /// Another mode.
    pub mode: bool,
}

/// A softkey P1 to P4.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct PracticePoint {
    /// `P1`.
    pub name: String,
    /// What is stored; absent: the softkey is grey.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stored: Option<JogPoint>,
    /// Whether it was touched and waits to be stored.
    pub waits: bool,
    /// The line of a script that presses it.
    pub line: String,
}

/// The machine.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct PracticeMachine {
    /// Position X Y Z in the WCS of the measurement, mm.
    pub wcs: [f64; 3],
    /// Position X Y Z of the machine, mm.
    pub mcs: [f64; 3],
    /// The zero offset that is active.
    pub active: String,
    /// Letters of the axes of the plane in which is measured.
    pub axes: [&'static str; 2],
    /// Versions of the measuring cycles by which the masks are: from SW 6.3, up to SW 6.2.
    pub versions: Vec<PracticeUse>,
    /// Planes in which can be measured.
    pub planes: Vec<PracticeUse>,
    /// Zero offsets that can be in use while measuring.
    pub offsets: Vec<PracticeUse>,
    /// Whether one is offered because it was activated: no other can be chosen until the area is left.
    pub offered: bool,
    /// What can be in the spindle.
    pub tools: Vec<PracticeUse>,
    /// Whether it is a probe.
    pub probe: bool,
}

/// Something that can be in use.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct PracticeUse {
    /// Its name: `G54`; empty: an empty spindle.
    pub name: String,
    /// The line of a script that brings it into use.
    pub line: String,
    /// Whether it is.
    pub used: bool,
}

/// How far a zero offset is from where it should be.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct PracticeDeviation {
    /// Its name.
    pub offset: String,
    /// Along the axes, mm, then about them, degree.
    pub figures: Vec<PracticeFigure>,
}
