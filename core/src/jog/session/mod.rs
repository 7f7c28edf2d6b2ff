//! A session at the machine: what is pressed, what is measured, what is written. Whatever happens, nothing of it is
//! lost: a refused input leaves everything as it was.

mod measuring;
mod writing;

use self::measuring::TouchedIn;
use super::activation::Activation;
use super::calculate::{self, Outcome, Point};
use super::counterpart::Taken;
use super::mask::{self, Kind, Mask, Task};
use super::states::{Does, Key, Row, State, When, row_of};
use super::stylus::Stylus;
use super::values::{Value, Values};
use super::{masks, offset, settings};
use crate::control::{AXES, Control, Store};
use crate::geometry::Mcs;
use crate::machine::{Setup, Sim, Step, Stop};
use crate::message::Message;
use std::collections::BTreeMap;

/// What the user does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Input<'a> {
    /// Softkey of a function: the name of its mask.
    Function(&'a str),
    /// Enters a text into a field of the mask or of the activation screen.
    Field(&'a str, &'a str),
    /// NC start.
    Start,
    /// RESET.
    Reset,
    /// Softkey P1 to P4, from 1.
    Point(usize),
    /// Bit of the PLC that rejects a point, from 1, set or reset.
    Plc(usize, bool),
    /// Calculate.
    Calculate,
    /// `<<`.
    Back,
    /// Another mode.
    Mode,
}

/// So many points make a right-angled corner (A:3200).
const ENOUGH: usize = 3;

/// The axes as the user moves them: along those of the WCS that is active while measuring.
#[derive(Clone, Debug)]
pub struct Axes(Control);

impl Axes {
    /// Where an axis X Y Z stands at a coordinate, or so much further, mm.
    pub fn along(&self, from: Mcs, axis: usize, value: f64, further: bool) -> Mcs {
        let mut at = self.0.to_workpiece(from);
        at[axis] = if further { at[axis] + value } else { value };
        self.0.to_machine(at)
    }
}

/// The machine and the screen.
#[derive(Clone, Debug)]
pub struct Session {
    /// The machine, and all that happened on it.
    pub sim: Sim,
    state: State,
    mask: Option<&'static Mask>,
    values: Values,
    /// Values of masks that were left.
    last: BTreeMap<&'static str, Values>,
    /// P1 to P4; those that were not stored are grey.
    points: Vec<Option<Point>>,
    /// Where P1 to P4 were touched last, also once the result is calculated.
    taken: Vec<Option<Taken>>,
    /// The probe with which they were touched.
    stylus: Option<Stylus>,
    /// What was measured last in this mask.
    outcome: Outcome,
    /// Where in the machine that lies what got its set position.
    measured_at: Option<Mcs>,
    /// In what the stored points were touched.
    touched_in: Option<TouchedIn>,
    /// The point that is being measured, and what it came to.
    measured: Option<Point>,
    activation: Option<Activation>,
    /// The zero offset that was activated last, offered for the next measurement until the area is left.
    offered: Option<usize>,
    /// Bits of the PLC that reject points.
    rejects: [bool; 4],
    /// Why the machine stopped.
    stopped: Option<Stop>,
}

impl Session {
    /// A machine as set up, nothing open.
    pub fn new(setup: &Setup) -> Session {
        let mut sim = Sim::new(setup);
        sim.in_jog = true;
        let mut session = Session {
            sim,
            state: State::Menu,
            mask: None,
            values: Values::default(),
            last: BTreeMap::new(),
            points: Vec::new(),
            taken: Vec::new(),
            stylus: None,
            outcome: Outcome::default(),
            measured_at: None,
            touched_in: None,
            measured: None,
            activation: None,
            offered: None,
            rejects: [false; 4],
            stopped: None,
        };
        session.take_plane();
        session
    }

    /// What is on the screen.
    pub fn state(&self) -> State {
        self.state
    }

    /// The mask that is open.
    pub fn mask(&self) -> Option<&'static Mask> {
        self.mask
    }

    /// Its values.
    pub fn values(&self) -> &Values {
        &self.values
    }

    /// P1 to P4 as they are stored.
    pub fn points(&self) -> &[Option<Point>] {
        &self.points
    }

    /// Where P1 to P4 were touched last.
    pub fn taken(&self) -> &[Option<Taken>] {
        &self.taken
    }

    /// What was measured last in this mask.
    pub fn outcome(&self) -> &Outcome {
        &self.outcome
    }

    /// Where in the machine that lies which got its set position by it.
    pub fn measured_at(&self) -> Option<Mcs> {
        self.measured_at
    }

    /// The activation screen.
    pub fn activation(&self) -> Option<&Activation> {
        self.activation.as_ref()
    }

    /// Why the machine stopped; none: nothing is pending.
    pub fn stopped(&self) -> Option<&Stop> {
        self.stopped.as_ref()
    }

    /// Bits of the PLC: 0 to 3, which reject, and 4 to 7, a point is stored and its softkey is on the screen
    /// (B:2783-2817).
    pub fn plc(&self) -> [bool; 8] {
        let softkeys = matches!(self.state, State::Mask | State::Ready | State::Busy);
        let several = self.mask.is_some_and(|mask| !mask.at_once() && !mask.by_hand());
        std::array::from_fn(|bit| match bit {
            0..4 => self.rejects[bit],
            _ => softkeys && several && self.points.get(bit - 4).is_some_and(Option::is_some),
        })
    }

    /// The settable frame that is active while measuring: the one activated last, else that of the set-up.
    pub fn measuring(&self) -> usize {
        self.offered.unwrap_or_else(|| settings::measuring(&self.sim.control))
    }

    /// Carries out an input, which a running measurement or activation follows to its end; see [`Session::press`].
    ///
    /// # Errors
    /// Why it does nothing here.
    pub fn carry_out(&mut self, input: Input) -> Result<(), Message> {
        self.press(input)?;
        if matches!(self.state, State::Busy | State::Moving) {
            self.advance();
        }
        Ok(())
    }

    /// Carries out an input; a measurement or activation that it begins runs with [`Session::advance`].
    ///
    /// # Errors
    /// Why it does nothing here.
    pub fn press(&mut self, input: Input) -> Result<(), Message> {
        let key = match input {
            Input::Function(_) => Key::Function,
            Input::Field(..) => Key::Field,
            Input::Start => Key::Start,
            Input::Reset => Key::Reset,
            Input::Point(_) => Key::Point,
            Input::Plc(number, set) => return self.plc_bit(number, set),
            Input::Calculate => Key::Calculate,
            Input::Back => Key::Back,
            Input::Mode => Key::Mode,
        };
        let row = self.row(key)?;
        self.act(row, input)
    }

    /// Lets the measurement or activation that runs come to its end.
    pub fn advance(&mut self) {
        let outcome = match self.state {
            State::Busy => self.measure(),
            State::Moving => self.activate(),
            _ => return,
        };
        let key = if outcome.is_ok() { Key::Done } else { Key::Failed };
        self.stopped = outcome.err();
        if let Ok(row) = self.row(key)
            && let Err(message) = self.act(row, Input::Start)
        {
            // what was touched makes no result: the control tells it as an alarm
            self.stopped = Some(Stop::Fault(message));
            self.state = State::Alarm;
        }
    }

    /// Whether a key does something now.
    pub fn takes(&self, key: Key) -> bool {
        self.row(key).is_ok()
    }

    /// Whether a zero offset that was activated is offered for the next measurement.
    pub fn offers(&self) -> bool {
        self.offered.is_some()
    }

    /// Is where another session is that came the same way on another part: screen, activation and active zero offset.
    pub(super) fn become_like(&mut self, other: &Session) {
        self.state = other.state;
        self.activation.clone_from(&other.activation);
        self.offered = other.offered;
        self.stopped = None;
        self.values = other.values.clone();
        self.sim.control.activate(other.sim.control.settable);
    }

    /// The row that an input takes.
    fn row(&self, key: Key) -> Result<&'static Row, Message> {
        row_of(self.state, key, |when| self.holds(when)).ok_or_else(|| self.refusal(key))
    }

    fn holds(&self, when: When) -> bool {
        let at_once = self.mask.is_some_and(Mask::at_once);
        match when {
            When::Always => true,
            When::Measurable => {
                let valid = self.mask.is_some_and(|mask| self.values.missing(mask).is_none());
                valid && !self.lacks_g500() && (at_once || self.points.iter().any(Option::is_none))
            }
            When::More => self.points.iter().filter(|point| point.is_none()).count() > 1,
            When::Complete => at_once && !self.to_activate(),
            When::Inactive => at_once && self.to_activate(),
            When::ToActivate => self.to_activate(),
            When::ByHand => self.kept_by_hand(),
            When::Enough => self.kept_by_hand() && self.stored() >= ENOUGH,
        }
    }

    /// Whether the mask is one whose points the user stores.
    pub fn kept_by_hand(&self) -> bool {
        self.mask.is_some_and(Mask::by_hand)
    }

    /// How many points are stored.
    fn stored(&self) -> usize {
        self.points.iter().flatten().count()
    }

    /// Whether a touched point waits to be stored by the user.
    pub fn waits(&self) -> bool {
        self.kept_by_hand() && self.measured.is_some()
    }

    /// Whether the basic reference is to be corrected and another zero offset than G500 is active while measuring,
    /// which it must be up to SW 6.2 (A:2950-2952).
    fn lacks_g500(&self) -> bool {
        let older = settings::older(&self.sim.control);
        older && self.measuring() != 0 && self.chosen() == Some(Store::System)
    }

    /// Why an input does nothing.
    fn refusal(&self, key: Key) -> Message {
        let wrong = self.mask.and_then(|mask| self.values.missing(mask));
        match (key, self.state) {
            (Key::Start, State::Mask) if wrong.is_some() => wrong.map_or(Message::new("jog-refused"), |(_, why)| why),
            (Key::Start, State::Mask) if self.lacks_g500() => Message::new("jog-older-g500"),
            (Key::Start, State::Ready) => Message::new("jog-all-stored"),
            (Key::Start, State::Mask) if self.kept_by_hand() => Message::new("jog-older-stored"),
            (Key::Start, State::Menu) => Message::new("jog-no-mask"),
            (Key::Mode, state) if state != State::Menu => Message::new("jog-mode"),
            (Key::Function, State::Mask | State::Ready) => Message::new("jog-open"),
            (_, State::Alarm) => Message::new("jog-pending"),
            (Key::Calculate, State::Mask) if self.mask.is_some_and(Mask::at_once) => Message::new("jog-at-once"),
            (Key::Calculate, State::Mask) => Message::new("jog-missing").text("points", self.grey()),
            _ => Message::new("jog-refused"),
        }
    }

    /// Names of the points that are missing: `P1, P3`.
    fn grey(&self) -> String {
        let needed = if self.kept_by_hand() { ENOUGH } else { self.points.len() };
        let missing = self.points.iter().enumerate().take(needed).filter(|(_, point)| point.is_none());
        missing.map(|(number, _)| format!("P{}", number + 1)).collect::<Vec<_>>().join(", ")
    }

    fn act(&mut self, row: &Row, input: Input) -> Result<(), Message> {
        match row.does {
            Does::Open => self.open(input)?,
            Does::Change => {
                if self.change(input)? {
                    self.state = State::Mask;
                    return Ok(());
                }
            }
            Does::Measure => self.begin(),
            Does::Store => self.store(),
            Does::Hold => {}
            Does::Keep => self.keep(input)?,
            Does::Write => self.write()?,
            Does::Cancel => {
                self.measured = None;
                self.activation = None;
            }
            Does::Raise => self.activation = None,
            Does::Acknowledge => self.stopped = None,
            Does::Reject => self.reject(input)?,
            Does::Leave => self.leave(),
            Does::Toggle => self.toggle(input)?,
            Does::Activate => {}
            Does::Offer => self.offer(),
            Does::Close => self.activation = None,
            Does::Quit => self.offered = None,
        }
        self.state = if row.does == Does::Write { self.written(row) } else { row.to };
        Ok(())
    }

    /// Behind a write, whether the screen is shown was known before it only for what would be written.
    fn written(&self, row: &Row) -> State {
        if self.activation.is_some() { State::Activate } else { row.to }
    }

    /// Opens a mask with its last values; what a datum presets, as it says; the zero offset that is active while
    /// measuring, which G500 is none of.
    fn open(&mut self, input: Input) -> Result<(), Message> {
        let Input::Function(name) = input else { return Ok(()) };
        let control = &self.sim.control;
        let Some(mask) = masks::opened(control, name) else {
            let known = masks::offered(control).iter().flat_map(|function| function.masks);
            let known = known.map(|mask| mask.name).collect::<Vec<_>>().join(", ");
            return Err(Message::new("jog-no-function").text("name", name).text("known", known));
        };
        let mut values = self.last.get(mask.name).cloned().unwrap_or_else(|| Values::first(mask, control));
        for field in mask.fields {
            if let Some(preset) = settings::preset(control, field.name) {
                values.put(field.name, Value::Number(preset));
            }
            if matches!(field.kind, Kind::Offset { .. }) {
                let measuring = Some(self.measuring()).filter(|number| *number > 0);
                let name = measuring.map(|number| offset::name(control, Store::Settable(number)));
                values.put(field.name, Value::Word(name.unwrap_or_else(|| offset::NONE.to_owned())));
            }
        }
        if mask.by_hand() {
            values.put("corner", Value::Word("outside".to_owned())); // the mask has no other (A:3141-3145)
        }
        self.values = values;
        self.mask = Some(mask);
        self.points = vec![None; mask.points];
        self.taken = vec![None; mask.points];
        self.outcome = Outcome::default();
        Ok(())
    }

    /// Enters a value; whether all points are rejected by it.
    fn change(&mut self, input: Input) -> Result<bool, Message> {
        let (Input::Field(name, text), Some(mask)) = (input, self.mask) else { return Ok(false) };
        let known = mask.fields.iter().filter(|field| self.values.shown(field));
        let Some(field) = known.clone().find(|field| field.name.eq_ignore_ascii_case(name)) else {
            let known = known.map(|field| field.name).collect::<Vec<_>>().join(", ");
            return Err(Message::new("jog-no-field").text("field", name).text("known", known));
        };
        let before = self.values.clone();
        self.values.enter(mask, field, text, &self.sim.control)?;
        let rejects = field.touches && self.values != before && !mask.at_once();
        if rejects {
            self.reject_all();
        }
        if field.touches && self.values != before {
            self.taken.fill(None);
        }
        Ok(rejects)
    }

    /// Leaves the mask; its values stay for the next time.
    fn leave(&mut self) {
        if let Some(mask) = self.mask.take() {
            self.last.insert(mask.name, std::mem::take(&mut self.values));
        }
        self.points.clear();
        self.taken.clear();
        self.outcome = Outcome::default();
        self.measured = None;
        self.stopped = None;
    }

    /// The plane of the set-up is that of the machine at once: the probe is drawn and the position is shown as NC start
    /// takes them, the spindle nose stays where it is. Points that were touched in another plane do not count.
    pub(super) fn take_plane(&mut self) {
        let plane = settings::plane(&self.sim.control);
        if plane == self.sim.control.plane {
            return;
        }
        self.sim.with_length(|control| control.plane = plane);
        self.reject_all();
    }

    /// Follows the data of the control, which changed: the plane, the WCS of the measurement and the probe, and a mask
    /// that the control does not have any more.
    pub fn settle(&mut self) {
        self.take_plane();
        self.compare();
        let offered = |mask: &Mask| masks::opened(&self.sim.control, mask.name).is_some();
        if self.mask.is_some_and(|mask| !offered(mask)) {
            self.activation = None;
            self.leave();
            self.state = State::Menu;
        }
    }

    /// The words of a field or result of the mask; the letters of the axes are those of the plane, of an edge that of
    /// the measuring axis.
    pub fn label(&self, kind: &str, name: &str) -> Message {
        let [abscissa, ordinate, applicate] = settings::plane(&self.sim.control).axes();
        let along = match self.mask.map(|mask| mask.task) {
            Some(Task::Edge | Task::Distance) => calculate::axis(&self.values, "axis"),
            _ => abscissa,
        };
        let axis = match name {
            "y0" | "y1" | "w" | "meas_y0" | "meas_w" => ordinate,
            "z0" | "dz" => applicate,
            _ => along,
        };
        Message::new(mask::key(kind, name)).text("axis", AXES[axis])
    }

    /// Lets the user move the machine: by the WCS of the measurement, or as he likes. What is hit stops it.
    ///
    /// # Errors
    /// A measurement runs, or an alarm is pending.
    pub fn by_hand(&mut self, go: impl FnOnce(&mut Sim, &Axes) -> Result<(), Stop>) -> Result<(), Message> {
        if matches!(self.state, State::Busy | State::Moving) {
            return Err(Message::new("jog-refused"));
        }
        let mut control = self.sim.control.clone();
        control.activate(self.measuring());
        self.stopped = match go(&mut self.sim, &Axes(control)) {
            Ok(()) if self.state == State::Alarm => self.stopped.take(),
            outcome => outcome.err(),
        };
        Ok(())
    }

    /// Records what the user did beside the mask: a tool is taken into the spindle.
    ///
    /// # Errors
    /// There is no such tool or edge, or no room for it where the spindle stands.
    pub fn take_tool(&mut self, tool: i64, edge: i64) -> Result<(), Message> {
        let there = tool == 0 || edge == 0 || self.sim.control.edge_of(tool, edge).is_some();
        if !there || tool != 0 && !self.sim.control.tools.contains_key(&tool) {
            let none = Message::new("jog-no-tool").number("tool", tool as f64);
            return Err(none.number("edge", edge as f64));
        }
        let edge = if tool == 0 { 0 } else { edge };
        let take = |sim: &mut Sim| {
            sim.with_length(|control| (control.tool, control.edge, control.location) = (tool, edge, 0));
        };
        // on a copy, since a tool becomes real as soon as it is looked at
        let mut tried = self.sim.clone();
        let stuck = tried.reaches_in();
        take(&mut tried);
        if !stuck && tried.reaches_in() {
            let none = Message::new("jog-tool-room").number("tool", tool as f64);
            return Err(none.number("edge", edge as f64));
        }
        take(&mut self.sim);
        self.sim.note(Step::Tool { tool, edge });
        self.compare();
        Ok(())
    }
}
