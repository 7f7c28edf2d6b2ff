//! A measurement in JOG as the automatic cycle that does the same, and a call as its mask: a table both ways, what
//! follows from the places that were touched, and what is different.

mod back;
mod corner;
mod data;
mod lay;
mod value;

pub use crate::catalogue::in_jog::{Counterpart, Holds, Layout, Source, TABLE};
pub use back::{Masked, masked};

use super::mask::{Mask, Task};
use super::offset;
use super::session::Session;
use super::settings::{self, Settings};
use super::stylus::Stylus;
use super::values::Values;
use crate::catalogue;
use crate::control::{Control, Store};
use crate::entry::{Cycle, Typed};
use crate::geometry::{Mcs, Wcs};
use crate::message::Message;
use lay::{Laid, lay};

/// A call that does what a mask does.
#[derive(Clone, Debug)]
pub struct Call {
    /// The cycle.
    pub cycle: &'static Cycle,
    /// Its variant.
    pub variant: i64,
    /// Its values, as typed.
    pub values: Typed,
    /// The control as it is while the call measures, with its plane and settable frame.
    pub control: Control,
    /// Where the probe or the tool stands at the call, in the WCS then, mm.
    pub start: Wcs,
    /// What is different.
    pub differs: Vec<Message>,
}

/// Where a point was touched, in the machine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Taken {
    /// Where the probe stood at NC start.
    pub from: Mcs,
    /// The place on the surface, or the centre of the element.
    pub at: Mcs,
}

/// What a counterpart is made from.
struct Told<'a> {
    /// The control, with plane and zero offset of the measurement.
    control: Control,
    mask: &'a Mask,
    values: &'a Values,
    /// Results of the mask, as far as there are any.
    results: &'a [(&'static str, f64)],
    /// The points, once all were touched.
    points: Option<Vec<Point>>,
    /// Where the probe stands.
    here: Wcs,
    /// The zero offset that is corrected.
    target: Option<Store>,
}

/// A point in the WCS of the measurement, mm.
#[derive(Clone, Copy, Debug)]
struct Point {
    from: Wcs,
    at: Wcs,
}

impl<'a> Told<'a> {
    fn of(session: &'a Session, mask: &'static Mask) -> Told<'a> {
        let mut control = session.sim.control.clone();
        control.plane = settings::plane(&control);
        control.activate(session.measuring());
        let seen = |taken: &Taken| Point { from: control.to_workpiece(taken.from), at: control.to_workpiece(taken.at) };
        let points = taken(session, mask).iter().map(|taken| taken.as_ref().map(seen)).collect();
        Told {
            mask,
            values: session.values(),
            results: &session.outcome().results,
            points,
            here: control.to_workpiece(session.sim.position),
            target: session.chosen(),
            control,
        }
    }

    /// What the control knows of the probe.
    fn stylus(&self) -> Stylus {
        let (field, mono) = Settings::of(&self.control).probe;
        Stylus::of(&self.control, field, mono)
    }

    /// Whether a condition of the table holds.
    fn holds(&self, holds: &Holds) -> bool {
        match holds {
            Holds::Word(name, words) => words.contains(&self.values.word(name)),
            Holds::Zero(name, zero) => (self.values.number(name) == 0.0) == *zero,
            Holds::Wide(wide) => value::wide(&self.control) == *wide,
        }
    }
}

/// The mask that is open as a call.
///
/// # Errors
/// Why there is none: no cycle does the same, or points are missing that it needs.
pub fn call(session: &Session) -> Result<Call, Message> {
    let mask = session.mask().ok_or_else(|| Message::new("jog-no-mask"))?;
    if let Some((_, why)) = session.values().missing(mask) {
        return Err(why);
    }
    let told = Told::of(session, mask);
    let mut why = Message::new(none(mask));
    let name =
        if taken(session, mask).len() == 4 && mask.by_hand() { "corner_any" } else { mask.older.unwrap_or(mask.name) };
    for counterpart in TABLE.iter().filter(|one| one.mask == name) {
        if !counterpart.when.iter().all(|holds| told.holds(holds)) {
            continue;
        }
        match lay(&told, counterpart.layout) {
            Ok(laid) => return made(&told, counterpart, &laid),
            Err(key) => why = Message::new(key),
        }
    }
    Err(why)
}

/// Where was touched: of a corner whose points the user stores as many as there are, three at least.
fn taken<'a>(session: &'a Session, mask: &Mask) -> &'a [Option<Taken>] {
    match session.taken() {
        [three @ .., None] if mask.by_hand() => three,
        all => all,
    }
}

/// Why no cycle does what a mask does.
fn none(mask: &Mask) -> &'static str {
    match mask.task {
        Task::Centres(_) => "jog-program-centres",
        _ => "jog-program-none",
    }
}

fn made(told: &Told, counterpart: &Counterpart, laid: &Laid) -> Result<Call, Message> {
    let cycle = catalogue::find(told.control.dialect, counterpart.cycle);
    let cycle = cycle.ok_or_else(|| Message::new("jog-program-none"))?;
    let mut values = Typed::new();
    if let Some(name) = cycle.variant_param() {
        values.insert(name.to_string(), counterpart.variant.to_string());
    }
    for (name, source) in counterpart.values {
        let Some(param) = cycle.param(name.as_str()) else { continue };
        if let Some(value) = told.value(*source, laid) {
            values.insert(name.to_string(), value::typed(value, param.unit, &told.control));
        }
    }
    Ok(Call {
        cycle,
        variant: counterpart.variant,
        values,
        differs: told.differs(counterpart, laid),
        control: told.control.clone(),
        start: laid.start,
    })
}

impl Told<'_> {
    /// What is different: the way to the points, then what is written, then the data that both take.
    fn differs(&self, counterpart: &Counterpart, laid: &Laid) -> Vec<Message> {
        let path = self.control.number("E_MESS_D_M");
        let reach = self.value(Source::Reach, laid).unwrap_or(path);
        let reach = if counterpart.layout == Layout::Before { laid.numbers[0] } else { reach };
        let one = |key: &&'static str| Message::new(*key).number("path", path).number("reach", reach);
        let mut all: Vec<Message> = counterpart.differs.iter().map(one).collect();
        all.extend(self.written(counterpart).into_iter().map(Message::new));
        all.extend(self.data());
        all
    }

    /// What is written elsewhere, or otherwise.
    fn written(&self, counterpart: &Counterpart) -> Vec<&'static str> {
        let mut all = Vec::new();
        if self.mask.task.of_tool() {
            return all;
        }
        if counterpart.layout == Layout::Before && self.stylus().skew != [0.0; 2] {
            all.push("jog-differs-skew");
        }
        let Some(target) = self.target else { return all };
        let set = |name: &str| self.values.number(name) != 0.0;
        if matches!(counterpart.layout, Layout::Points { .. }) && (set("x0") || set("y0")) {
            all.push("jog-differs-corner-zero");
        }
        let fine = self.control.number("MD18600") != 0.0 && !self.control.bit("_CHBIT[21]");
        let moves = counterpart.values.iter().any(|(_, source)| matches!(source, Source::Rotary(_)));
        let rotary = moves && self.value(Source::Rotary("angle_offset"), &Laid::default()) != Some(0.0);
        if (counterpart.fine || rotary) && fine && target != Store::System {
            all.push("jog-differs-fine");
        }
        if matches!(target, Store::Settable(_)) {
            all.push("jog-differs-active");
        }
        all
    }
}

/// The code of `_KNUM` for a zero offset (B:1932-1965).
fn code(store: Store) -> f64 {
    match store {
        Store::Settable(number) => number as f64,
        Store::ChannelBasic(index) => 1011.0 + index as f64,
        Store::GlobalBasic(index) => 1051.0 + index as f64,
        Store::System => 2000.0,
    }
}

/// The zero offset of a mask for a code; none: measuring only.
fn word(control: &Control, code: i64, turned: bool) -> Option<String> {
    let store = match code {
        1..=99 => Store::Settable(code as usize),
        1011..=1026 => Store::ChannelBasic((code - 1011) as usize),
        1051..=1066 if !turned => Store::GlobalBasic((code - 1051) as usize),
        2000 => Store::System,
        9999 if control.settable > 0 => Store::Settable(control.settable),
        _ => return None,
    };
    let name = offset::name(control, store);
    offset::named(control, &name, turned).map(|_| name)
}
