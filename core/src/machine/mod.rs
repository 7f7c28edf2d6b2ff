//! The simulated machine: what a cycle may do on it, what it starts from, what it records.

pub mod calibrated;
pub mod clock;
pub mod entries;
pub mod files;
pub mod in_use;
pub mod possible;
mod pretended;
pub mod route;
#[cfg(test)]
mod route_tests;
pub mod series;
pub mod setup;
pub mod sim;
pub mod temperature;
pub mod trace;

pub use clock::Clock;
pub use entries::Entries;
pub use files::Files;
pub use in_use::InUse;
pub use pretended::Pretended;
pub use route::Route;
pub use setup::{PROBE_TOOL, Setup, ideal_probe, probe_data, probe_place};
pub use sim::Sim;
pub use trace::{Entry, MotionKind, Step, Trace};

use crate::control::Control;
use crate::diagnostic::Code;
use crate::geometry::{Around, Degrees, Wcs};
use crate::message::Message;
use crate::scan::{Layout, Scanned, Sent};

/// Why a program does not go on.
#[derive(Clone, Debug, PartialEq)]
pub enum Stop {
    /// Alarm that needs NC RESET.
    Alarm(Code),
    /// The simulation's own limit or something unsupported, as a message.
    Fault(Message),
}

/// What a measuring cycle may do on the machine. Positions include the tool length (to where L1 refers), mm; mm/min.
pub trait Machine {
    /// State of the control; a cycle writes results and corrections here.
    fn control(&mut self) -> &mut Control;
    /// Present position.
    fn position(&self) -> Wcs;
    /// Straight positioning. With `monitored`, a probe signal on the way is alarm 61302 (NCT: PATH OBSTRUCTED, or
    /// FALSE TRIGGER where nothing is touched); without, contact is recorded as a crash. A target beyond a software
    /// limit switch is refused.
    ///
    /// # Errors
    /// What was hit or refused.
    fn travel(&mut self, to: Wcs, kind: MotionKind, feed: f64, monitored: bool) -> Result<(), Stop>;
    /// Positioning round an axis of the WCS.
    ///
    /// # Errors
    /// What was hit or refused.
    fn travel_around(
        &mut self,
        to: Wcs,
        around: &Around<Wcs>,
        kind: MotionKind,
        feed: f64,
        monitored: bool,
    ) -> Result<(), Stop>;
    /// Straight measuring motion of what is in use: the probe towards the part, any other tool towards the tool probes,
    /// with its highest edge where the spindle turns. Some: position latched at switching (delete distance-to-go);
    /// None: no signal up to `to`.
    ///
    /// # Errors
    /// Why the motion was refused, or what was hit.
    fn probe(&mut self, to: Wcs, feed: f64) -> Result<Option<Wcs>, Stop>;
    /// Whether the stylus is deflected where the machine stands (NCT looks at this before it moves).
    fn in_contact(&self) -> bool;
    /// Whether the signal that ended the last watched motion still stands; a false one is gone (C:98, C:125-138).
    fn signal_stands(&self) -> bool;
    /// Writes a datum of tools or frames, lengths in mm. Where it is the length in use, the spindle nose stays.
    fn correct(&mut self, name: &str, value: f64);
    /// Whether [`Machine::correct`] changes the data: some simulations of a control only measure (B:676-678).
    fn corrects(&self) -> bool;
    /// Whether it shows result screens and logs: those simulations do neither (B:676-678).
    fn reports(&self) -> bool;
    /// Applies the length of another edge of the tool in use (NCT: another register), 0 none; the spindle nose stays.
    fn select(&mut self, edge: i64);
    /// Turns the spindle to this angle where it stands.
    fn orient(&mut self, angle: Degrees);
    /// Lets the spindle turn, 1/min: positive as M3, negative as M4; 0 stops it.
    fn spin(&mut self, speed: f64);
    /// From now on nothing is recorded, or everything again.
    fn quiet(&mut self, on: bool);
    /// Points up to which a scan of a call is followed.
    fn point_limit(&self) -> usize;
    /// Takes what a scan sent to a computer, whole.
    fn send(&mut self, scan: Sent);
    /// Files that the run leaves on the control.
    fn files(&mut self) -> &mut Files;
    /// Date and time of the control.
    fn now(&self) -> Clock;
    /// Makes an empty file, and records that.
    fn create_file(&mut self, name: &str) {
        self.files().create(name);
        self.record(Step::File { name: name.to_owned(), text: None });
    }
    /// Adds a line to a file, and records it.
    fn write_file(&mut self, name: &str, line: String) {
        self.files().write(name, line.clone());
        self.record(Step::File { name: name.to_owned(), text: Some(line) });
    }
    /// Records something that is no motion: a result, a correction, a decision, an alarm that informs.
    fn record(&mut self, step: Step);
    /// Writes a datum as it stands on the control, and records it.
    fn write(&mut self, name: &str, after: f64) {
        let before = self.control().number(name);
        self.control().set(name, after);
        self.record(Step::Set { name: name.to_owned(), before, after });
    }
    /// Writes a datum of tools or frames as [`Machine::correct`] does, and records it; one that is not there is left.
    fn write_correction(&mut self, name: String, after: f64) {
        if !self.corrects() {
            return;
        }
        if let Some(before) = self.control().variable(&name) {
            self.correct(&name, after);
            self.record(Step::Set { name, before, after });
        }
    }
}

/// A cycle that scans, on its way.
pub trait Scanner {
    /// Goes to the next point; none: the scan is complete.
    ///
    /// # Errors
    /// Why the scan does not go on.
    fn next(&mut self, machine: &mut dyn Machine) -> Result<Option<Scanned>, Stop>;
    /// Which part of the surface is done, 0 to 1.
    fn share(&self) -> f64;
    /// What does not change on the way.
    fn layout(&self) -> &Layout;
}

/// More points than can be held.
pub fn too_many(limit: usize) -> Stop {
    Stop::Fault(Message::new("run-scan-limit").number("limit", limit as f64))
}
