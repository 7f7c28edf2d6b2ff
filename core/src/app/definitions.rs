//! The definition files of a machine: the lines that differ from delivery, the program that assigns its values, the
//! memory that both need; and values read back from them.

use super::Error;
use super::machine::{MachineField, MachineView, with_values};
use super::machine_check::{Exported, ExportedFile, Files, Given, MachineFault, Place, TO_ENTER, no_element, unread};
use super::start::{Machine, start};
use crate::control::arrays::{split, stem};
use crate::control::gud::{self, Block, Gud};
use crate::control::needs::{GUD_MEMORY, GUD_MEMORY_SOURCE, GUD_VALUES, NEEDS, Test, Use};
use crate::control::{
    BASIC_SYSTEM, CALIBRATED, Control, GENERATION, UNITS_OF_CHANNEL, UNITS_OF_CONTROL, Units, Value, delivery_in,
    setting_data as data,
};
use crate::diagnostic::Severity;
use crate::dialect::Dialect;
use crate::entry::Typed;
use crate::manual::Cited;
use crate::message::Message;
use crate::program::write::definition_files::{
    FILES, MEMORIES, TOOL_PROBES, as_delivered, as_written, bytes, counter, elements, is_sized, lines, size, sized,
    values,
};
use crate::program::write::setting_data;
use crate::refused::Path;
use crate::syntax::definitions::definitions as definitions_of;
use serde::{Deserialize, Serialize};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// A machine, and how many channels measure on it.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(default)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct DefinitionsRequest {
    /// Machine; absent: the core's own as it is.
    pub setup: Option<Machine>,
    /// Channels; absent: one.
    pub channels: Option<u32>,
    /// Whether it measures in JOG too; absent: it does.
    pub jog: Option<bool>,
}

/// What goes into the files of a machine.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct DefinitionsView {
    /// The files of which lines differ, and behind them the program of value assignments.
    pub files: Vec<DefinitionsText>,
    /// Memory of each array whose size is chosen.
    pub memory: Vec<MemoryShare>,
    /// What the machine data for it have to be, for these channels.
    pub needs: Vec<MemoryNeed>,
    /// In which order it is done, and what should be known.
    pub notes: Vec<Message>,
}

/// Lines for a file.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct DefinitionsText {
    /// The file on the control.
    pub name: &'static str,
    /// Name under which the lines are saved.
    pub saved: &'static str,
    /// The lines.
    pub text: String,
}

/// Memory of an array.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct MemoryShare {
    /// Name and sizes, `_TP[2,10]`.
    pub name: String,
    /// Whether each channel needs it.
    pub channel: bool,
    /// Bytes of its values.
    pub bytes: usize,
    /// Bytes as delivered.
    pub delivered: usize,
}

/// A machine datum for the memory of user data.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct MemoryNeed {
    /// Its number, `MD18150`.
    pub number: &'static str,
    /// The least value for the measuring cycles alone.
    pub value: f64,
    /// Place in the manual.
    pub source: Cited,
}

/// Channels that a control has at most.
const CHANNELS: u32 = 10;

/// The lines, the program and the memory.
///
/// # Errors
/// The machine has no such G function of units, or there are no such channels.
pub fn definitions(asked: DefinitionsRequest) -> Result<DefinitionsView, Error> {
    let channels = asked.channels.unwrap_or(1);
    if !(1..=CHANNELS).contains(&channels) {
        return Err(Error::new("definitions-channels", Path::of(&["channels"])).number("most", f64::from(CHANNELS)));
    }
    let control = start(Dialect::Sinumerik, asked.setup)?.setup.control;
    let jog = asked.jog.unwrap_or(true);
    let saved = |name: &str| SAVED.iter().find(|(of, _)| *of == name).map_or("", |(_, saved)| saved);
    let text = |name, text| DefinitionsText { name, saved: saved(name), text };
    let mut files = Vec::new();
    let (mut sizes, mut least) = (Vec::new(), Vec::new());
    if control.has_setting_data() {
        let delivered = delivery_in(Dialect::Sinumerik, control.basic_units);
        files.push(text(SETTINGS, setting_data::lines(&control, &delivered)));
    } else {
        let (control, delivered) = (as_written(&control), as_delivered(&control));
        // definition files of user data are of the first generation
        let wanted = FILES.iter().filter(|file| jog || file.block != Block::Gud7);
        files.extend(wanted.map(|file| text(file.name, lines(file, &control, &delivered))));
        files.push(text(PROGRAM, values(&control, &delivered)));
        sizes = memory(&control, &delivered, jog);
        least = needs(&sizes, channels, jog);
    }
    files.retain(|file| !file.text.is_empty());
    let mut notes = notes(&files, channels);
    if jog {
        notes.extend(to_enter(&control));
    }
    Ok(DefinitionsView { notes, files, memory: sizes, needs: least })
}

/// That sizes of tool probes are still to be entered before measuring in JOG (B:14294-14296, 61230).
fn to_enter(control: &Control) -> Option<Message> {
    if control.has_setting_data() || control.number(TOOL_PROBES) < 1.0 {
        return None;
    }
    let names = TO_ENTER.iter().filter_map(|name| gud::find(name)).flat_map(|gud| elements(control, gud));
    let missing: Vec<String> = names.filter(|name| control.number(name) == 0.0).collect();
    (!missing.is_empty()).then(|| Message::new("definitions-enter").text("names", missing.join(", ")))
}

/// The program of value assignments.
const PROGRAM: &str = "PW_MEAS_VALUES.MPF";
/// The lines of setting and machine data.
const SETTINGS: &str = "PW_MEAS.TEA";
/// Names under which lines are saved: no name of a delivered file, which they do not replace.
const SAVED: [(&str, &str); 5] = [
    ("GUD5.DEF", "GUD5-lines.txt"),
    ("GUD6.DEF", "GUD6-lines.txt"),
    ("GUD7_MC.DEF", "GUD7_MC-lines.txt"),
    (PROGRAM, PROGRAM),
    (SETTINGS, SETTINGS),
];

/// The file with the data of measuring in JOG: it is loaded, and GUD7.DEF, which takes it along, is activated
/// (B:14577-14604; A:15584 activates both).
const OF_JOG: &str = "GUD7_MC.DEF";

/// What is to be done, in its order (B:13262-13292, B:14157-14168, B:14532-14604).
fn notes(files: &[DefinitionsText], channels: u32) -> Vec<Message> {
    if files.iter().any(|file| file.name == SETTINGS) {
        return vec![Message::new("definitions-settings").number("channels", f64::from(channels))];
    }
    let names: Vec<&str> = files.iter().map(|file| file.name).filter(|name| *name != PROGRAM).collect();
    let mut notes = Vec::new();
    if !names.is_empty() {
        notes.push(Message::new("definitions-insert").text("files", names.join(", ")));
        notes.push(Message::new("definitions-save"));
    }
    let activated: Vec<&str> = names.iter().copied().filter(|name| *name != OF_JOG).collect();
    if !activated.is_empty() {
        notes.push(Message::new("definitions-activate").text("files", activated.join(", ")));
    }
    if names.contains(&OF_JOG) {
        notes.push(Message::new("definitions-load"));
        notes.push(Message::new("definitions-older"));
    }
    if !names.is_empty() {
        notes.push(Message::new("definitions-reset"));
    }
    if files.iter().any(|file| file.name == PROGRAM) {
        notes.push(Message::new("definitions-program").text("name", PROGRAM).number("channels", f64::from(channels)));
    }
    notes
}

/// The arrays whose size is chosen, in the order of the files.
fn memory(control: &Control, delivered: &Control, jog: bool) -> Vec<MemoryShare> {
    let wanted = |gud: &&Gud| {
        let own = is_sized(gud) || gud.of_machine() && size(control, gud) != size(delivered, gud);
        own && bytes(gud.kind) > 0 && (jog || gud.block != Block::Gud7)
    };
    let share = |gud: &Gud| {
        let sizes = size(control, gud);
        let index: Vec<String> = sizes.iter().map(usize::to_string).collect();
        let of = |sizes: &[usize]| sizes.iter().product::<usize>() * bytes(gud.kind);
        let delivered = of(&size(delivered, gud));
        let name = format!("{}[{}]", gud.name, index.join(","));
        MemoryShare { name, channel: gud.channel, bytes: of(&sizes), delivered }
    };
    gud::all().filter(wanted).map(share).collect()
}

/// What machine data have to be. The manual's figures are those of delivery: arrays that are larger come on top,
/// smaller ones are not taken off, as the figures are approximate (B:12959).
fn needs(memory: &[MemoryShare], channels: u32, jog: bool) -> Vec<MemoryNeed> {
    let more = |channel: bool| {
        let shares = memory.iter().filter(|share| share.channel == channel);
        let (bytes, delivered) = shares.fold((0, 0), |sum, share| (sum.0 + share.bytes, sum.1 + share.delivered));
        bytes.saturating_sub(delivered) as f64 / 1024.0
    };
    let channels = f64::from(channels);
    let [control, each, of_jog] = GUD_MEMORY;
    let each = each + if jog { of_jog } else { 0.0 } + more(true);
    let values = (control + more(false) + channels * each).ceil();
    let of_need = |number: &'static str| {
        let least = NEEDS.iter().filter(|need| need.number == number && need.test == Test::AtLeast);
        let limits = least.flat_map(|need| need.limits);
        let counts = limits.filter(|limit| limit.severity == Severity::Error && (jog || limit.of != Use::Jog));
        let largest = counts.max_by(|one, other| one.value.total_cmp(&other.value))?;
        Some(MemoryNeed { number, value: largest.value, source: Cited(largest.source) })
    };
    let mut needs: Vec<MemoryNeed> = ["MD18118", "MD18120", "MD18130"].into_iter().filter_map(of_need).collect();
    needs.push(MemoryNeed { number: GUD_VALUES, value: values, source: Cited(GUD_MEMORY_SOURCE) });
    needs
}

/// The generation of a machine whose files have setting data, where it is not told: that of the published tables.
const GENERATION_OF_SETTINGS: &str = "3";

/// Files of a control whose values a machine is to have.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct ReadBackRequest {
    /// Machine; absent: the core's own as it is.
    pub setup: Option<Machine>,
    /// Definition files, programs of value assignments, start-up files.
    pub files: Vec<ExportedFile>,
}

/// A machine with the values of files.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct ReadBack {
    /// The machine now; values that it cannot have are its problems.
    pub machine: MachineView,
    /// Data of the machine that the files give.
    pub read: usize,
    /// How many of them are another value than before.
    pub changed: usize,
    /// Lines of definition files that the machine keeps: what it had, and the sizes of arrays that the files give.
    pub definitions: Vec<String>,
    /// Arrays whose size no datum counts and that is another one than is delivered; absent: none.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub sizes: Option<Message>,
    /// Lines of which a value or a size cannot be read: the machine keeps what it has there.
    pub unread: Vec<MachineFault>,
    /// In words.
    pub ending: Message,
}

/// Gives a machine the values of files; those of the first channel where there are several.
///
/// # Errors
/// Nothing of it is a datum of the machine.
pub fn read_back(asked: ReadBackRequest) -> Result<ReadBack, Error> {
    let mut given = Exported::default();
    for (file, one) in asked.files.iter().enumerate() {
        given.add(file, &one.text);
    }
    // where the definition leaves it at 0, calibration is still to come, as on the machine without these files; what is
    // in the memories belongs to the user
    let of_use = |name: &str| stem(name) == CALIBRATED || MEMORIES.contains(&stem(name));
    let later = |name: &str, one: &Given| one.defined && of_use(name) && one.value == Value::Number(0.0);
    let of_first = given.data.keys().filter(|(_, channel)| *channel < 2);
    let of_first = of_first.filter_map(|(name, _)| Some((name, given.get(name, 1)?)));
    let own = of_first.filter(|(name, one)| !later(name, one));
    let mut typed: Typed = own.map(|(name, one)| (name.clone(), text(&one.value))).collect();
    typed.extend(counts(&given, &typed));
    let told: BTreeSet<String> = typed.keys().cloned().collect();
    typed.extend(behind_lists(&given, later));
    let basic = basic(&given);
    let before = with_values(asked.setup.clone(), None, &[])?;
    let is_newer = typed.keys().any(|name| data::find(stem(name)).is_some());
    let mut control = start(Dialect::Sinumerik, asked.setup.clone())?.setup.control;
    let was_newer = control.has_setting_data();
    let becomes_newer = is_newer && !was_newer;
    if becomes_newer {
        typed.insert(GENERATION.to_owned(), GENERATION_OF_SETTINGS.to_owned());
    }
    // how many there are comes first: it decides which others there are
    let mut times = vec![typed.clone(); 2];
    if becomes_newer {
        times.push(typed.clone());
    }
    let mut machine = with_values(asked.setup, basic, &times)?;
    control.basic_units = machine.basic;
    for (name, value) in &machine.data {
        control.data.insert(name.clone(), value.clone());
    }
    let (definitions, sizes) = kept(&given, &control);
    let there: BTreeSet<&str> =
        machine.groups.iter().flat_map(|group| &group.fields).map(|field| field.setting.name.as_str()).collect();
    let of_files = |name: &&String| !becomes_newer || *name != GENERATION;
    let on = Read { given: &given, control: &control, told: &told, there: &there };
    let memories = on.memories();
    let read = on.told.iter().filter(|name| there.contains(name.as_str())).count() + memories.len();
    let files = Files { files: &asked.files };
    let mut unread = unread(&given, &files);
    let mut refused = machine.problems.len() + unread.len();
    for left in on.left_out() {
        refused += left.values;
        unread.push(left.fault(&files));
    }
    for (name, number) in memories {
        if number == 0.0 {
            machine.data.remove(&name)
        } else {
            machine.data.insert(name, Value::Number(number))
        };
    }
    if read == 0 && given.sizes.is_empty() && unread.is_empty() {
        return Err(Error::new("machine-check-nothing", Path::default()));
    }
    let (had, has, rebuilt) = (shown(&before), shown(&machine), before.basic != machine.basic);
    let differs =
        |name: &str| before.data.get(name) != machine.data.get(name) || rebuilt && had.get(name) != has.get(name);
    let changed = typed.keys().filter(of_files).filter(|name| differs(name)).count();
    let ending = Message::new(if becomes_newer { "definitions-read-newer" } else { "definitions-read" })
        .number("read", read as f64)
        .number("changed", changed as f64)
        .number("problems", refused as f64);
    Ok(ReadBack { unread, read, changed, definitions, sizes, ending, machine })
}

/// What files give a machine, and what of it there is.
struct Read<'a> {
    given: &'a Exported,
    /// The machine now.
    control: &'a Control,
    /// Data of the first channel that the files give.
    told: &'a BTreeSet<String>,
    /// Data that the form of the machine has.
    there: &'a BTreeSet<&'a str>,
}

/// Values that the machine does not take, of one datum or channel.
struct LeftOut {
    severity: Severity,
    /// The first of them.
    name: String,
    message: Message,
    place: Place,
    values: usize,
}

impl LeftOut {
    fn fault(self, files: &Files) -> MachineFault {
        let source = gud::named(&self.name).and_then(|gud| gud.elements.first()).map_or("", |element| element.source);
        let message = self.message.number("count", self.values as f64);
        MachineFault::new(self.severity, self.name, message, source).at(Some(files.told(self.place)))
    }
}

impl Read<'_> {
    /// Memories behind those that the form shows.
    fn memories(&self) -> Vec<(String, f64)> {
        let behind = self.told.iter().filter(|name| !self.there.contains(name.as_str()) && self.has(name));
        let memories = behind.filter(|name| MEMORIES.contains(&stem(name)));
        memories.filter_map(|name| Some((name.clone(), self.given.number(name, 1)?))).collect()
    }

    /// Whether the machine has an element of an array.
    fn has(&self, name: &str) -> bool {
        let Some((stem, at)) = split(name) else { return false };
        let Some(sizes) = gud::find(stem).map(|gud| self.sizes(gud)) else { return false };
        at.len() == sizes.len() && at.iter().zip(&sizes).all(|(index, size)| index < size)
    }

    /// Sizes of an array: as the files have them, but for fields that are counted.
    fn sizes(&self, gud: &Gud) -> Vec<usize> {
        let defined = self.given.sizes.get(gud.name).map(|(sizes, _)| sizes).filter(|_| counter(gud).is_none());
        defined.cloned().unwrap_or_else(|| size(self.control, gud))
    }

    /// Values that the machine does not take: those of other channels, and those of data that it does not have.
    fn left_out(&self) -> Vec<LeftOut> {
        let mut all: Vec<LeftOut> = Vec::new();
        let first = |found: &&LeftOut, name: &str| stem(&found.name) == stem(name);
        for name in self.told.iter().filter(|name| !self.there.contains(name.as_str())) {
            let Some((severity, message)) = self.why_not(name) else { continue };
            let Some(place) = self.given.get(name, 1).map(|one| one.place) else { continue };
            match all.iter_mut().find(|found| first(&&**found, name)) {
                Some(found) => found.values += 1,
                None => all.push(LeftOut { severity, name: name.clone(), message, place, values: 1 }),
            }
        }
        let others = self.given.data.iter().filter(|((_, channel), _)| *channel > 1);
        for ((_, channel), one) in others.filter(|((name, _), _)| self.there.contains(name.as_str())) {
            let name = format!("CHANDATA({channel})");
            match all.iter_mut().find(|found| found.name == name) {
                Some(found) => {
                    found.values += 1;
                    found.place = found.place.min(one.place);
                }
                None => {
                    let message = Message::new("definitions-other-channel");
                    all.push(LeftOut { severity: Severity::Warning, name, message, place: one.place, values: 1 });
                }
            }
        }
        all
    }

    /// Why the machine does not take a value that its form does not have; none: it is no setting of a machine, or a
    /// memory, which needs no form.
    fn why_not(&self, name: &str) -> Option<(Severity, Message)> {
        let missing = || Some((Severity::Warning, Message::new("definitions-not-there")));
        let Some(gud) = gud::find(stem(name)) else { return data::find(stem(name)).and_then(|_| missing()) };
        if !gud.of_machine() || MEMORIES.contains(&gud.name) && self.has(name) {
            return None;
        }
        let of_cycles = |at: &[usize]| gud.element(at).is_none_or(|element| element.internal);
        match gud::place(name) {
            Some((_, at)) if self.has(name) && of_cycles(&at) => None,
            _ if self.has(name) => missing(),
            _ => Some((Severity::Error, no_element(gud, &self.sizes(gud)))),
        }
    }
}

/// The basic system of the control that wrote the files: MD 10240 says it, else the switches that follow it, which say
/// in which system the data stand (B:13594-13598, B:14059-14061). None: nothing says it, or one against the other.
fn basic(given: &Exported) -> Option<Units> {
    // what a list leaves out says nothing of units
    let said = |name: &str| [1, 0].iter().find_map(|channel| given.data.get(&(name.to_owned(), *channel)));
    let system = |one: &Given| if one.value == Value::Number(0.0) { Units::Inch } else { Units::Metric };
    let of = |name: &str| said(name).map(system);
    let switches = [UNITS_OF_CONTROL, UNITS_OF_CHANNEL].map(of);
    of(BASIC_SYSTEM).or(match switches {
        [Some(one), Some(other)] if one != other => None,
        [one, other] => one.or(other),
    })
}

/// Elements that a list leaves at 0, of the first channel.
fn behind_lists(given: &Exported, later: impl Fn(&str, &Given) -> bool) -> Typed {
    let number = |one: &Given| matches!(one.value, Value::Number(_));
    let all = given.behind_lists().filter(|(name, channel, one)| *channel < 2 && number(one) && !later(name, one));
    all.filter(|(name, ..)| !given.data.contains_key(&(name.clone(), 1)))
        .map(|(name, _, one)| (name, text(&one.value)))
        .collect()
}

/// The data of a machine as they count, by name.
fn shown(machine: &MachineView) -> BTreeMap<&str, String> {
    let fields = machine.groups.iter().flat_map(|group| &group.fields);
    let value = |field: &MachineField| if field.value.is_empty() { &field.fallback } else { &field.value }.clone();
    fields.map(|field| (field.setting.name.as_str(), value(field))).collect()
}

/// The data that count the fields of arrays, where only the sizes of these are given: `_EV[40]` is `_EVMVNUM[0]` = 40.
fn counts(given: &Exported, typed: &Typed) -> Typed {
    let defined = given.sizes.iter().filter_map(|(name, (sizes, _))| Some((name, *sizes.first()?)));
    let all = defined.chain(given.removed.keys().map(|name| (name, 0)));
    let of_array = |(name, size): (&String, usize)| {
        let counter = counter(gud::find(name)?).filter(|counter| !typed.contains_key(*counter))?;
        Some((counter.to_owned(), size.to_string()))
    };
    all.filter_map(of_array).collect()
}

/// The lines of a machine with the sizes of arrays that files give, and the arrays that these are, in words. A size
/// that the machine has anyway needs no line.
fn kept(given: &Exported, control: &Control) -> (Vec<String>, Option<Message>) {
    let of_cycles = |line: &str| {
        let found = definitions_of(line.as_bytes()).definitions;
        let own = found.data.is_empty() && found.macros.is_empty() && !found.sizes.is_empty();
        own && found.sizes.keys().all(|name| given.sizes.contains_key(name))
    };
    let mut lines: Vec<String> = control.definitions.lines.iter().filter(|line| !of_cycles(line)).cloned().collect();
    let mut without = control.clone();
    Arc::make_mut(&mut without.definitions).sizes.retain(|name, _| !given.sizes.contains_key(name));
    let mut names = Vec::new();
    for (name, (sizes, _)) in &given.sizes {
        let Some(gud) = gud::find(name).filter(|gud| gud.sizes.len() == sizes.len() && bytes(gud.kind) > 0) else {
            continue;
        };
        let counted = usize::from(counter(gud).is_some());
        if size(&without, gud).iter().zip(sizes).skip(counted).any(|(one, other)| one != other) {
            let line = sized(gud, sizes);
            names.extend(line.rsplit(' ').next().map(str::to_owned));
            lines.push(line);
        }
    }
    let told = (!names.is_empty()).then(|| Message::new("definitions-sizes").text("names", names.join(", ")));
    (lines, told)
}

/// A value as it is typed.
fn text(value: &Value) -> String {
    match value {
        Value::Number(number) => number.to_string(),
        Value::Text(text) => text.clone(),
    }
}

#[cfg(all(test, feature = "json"))]
mod tests {
    #![allow(clippy::unwrap_used, clippy::panic)]
    use super::*;
    use crate::app::machine_check::{MachineCheckRequest, machine_check};
    use crate::app::start::Machine;
    use crate::form::machine::{Entry, Setting};
    use proptest::prelude::*;
    use serde_json::json;

    fn own(data: serde_json::Value) -> Option<Machine> {
        Some(serde_json::from_value(json!({ "own": { "data": data } })).unwrap())
    }

    fn view(data: serde_json::Value, channels: u32, jog: bool) -> DefinitionsView {
        definitions(DefinitionsRequest { setup: own(data), channels: Some(channels), jog: Some(jog) }).unwrap()
    }

    fn memory(view: &DefinitionsView) -> f64 {
        view.needs.iter().find(|need| need.number == GUD_VALUES).unwrap().value
    }

    // oracle: manual B:12971-12974 (7 + 2 * 4 + 2 * 0.5 KB), hand (9999 memories of 8 bytes instead of 20, a channel)
    #[test]
    fn memory_is_that_of_the_manual_and_of_larger_arrays() {
        let delivered = view(json!({}), 2, true);
        assert!(delivered.files.is_empty());
        assert_eq!(memory(&delivered), 16.0);
        assert_eq!(memory(&view(json!({}), 1, false)), 11.0);
        let large = view(json!({ "_EVMVNUM[0]": 9999 }), 2, true);
        assert_eq!(memory(&large), (16.0_f64 + 2.0 * (9999.0 - 20.0) * 8.0 / 1024.0).ceil());
        let share = large.memory.iter().find(|share| share.name == "_EV[9999]").unwrap();
        assert_eq!((share.channel, share.bytes, share.delivered), (true, 79_992, 160));
        // fewer arrays are not taken off: the manual's figure is approximate
        assert_eq!(memory(&view(json!({ "_CVAL[2]": 0 }), 2, true)), 16.0);
        assert!(definitions(DefinitionsRequest { channels: Some(0), ..DefinitionsRequest::default() }).is_err());
    }

    // oracle: self (what is written and read back is the machine that wrote it)
    #[test]
    fn what_is_written_is_read_back() {
        let data = json!({
            "_CVAL[0]": 1, "_CVAL[1]": 5, "_EVMVNUM[0]": 30, "_TP[0,6]": 20, "_WP[4,0]": 5.9, "_CBIT[14]": 1,
            "_SPEED[0]": 80, "_PROTNAME[1]": "LOG1", "E_MESS_FM": 400, "_DIGIT": 4
        });
        let before = with_values(own(data.clone()), None, &[]).unwrap().data;
        let written = view(data, 1, true).files;
        assert_eq!(written.len(), 4);
        let files =
            written.into_iter().map(|one| ExportedFile { name: one.saved.to_owned(), text: one.text }).collect();
        let back = read_back(ReadBackRequest { setup: None, files }).unwrap();
        assert_eq!(back.machine.problems, []);
        assert_eq!(back.machine.data, before);
        assert_eq!(back.changed, before.len());
        let nothing = ExportedFile { name: "x".to_owned(), text: "G0 X1".to_owned() };
        assert!(read_back(ReadBackRequest { setup: None, files: vec![nothing] }).is_err());
    }

    fn files(view: DefinitionsView) -> Vec<ExportedFile> {
        view.files.into_iter().map(|one| ExportedFile { name: one.saved.to_owned(), text: one.text }).collect()
    }

    /// A value that a field of the form takes.
    fn allowed(setting: &Setting, seed: u32) -> serde_json::Value {
        let range = setting.range;
        let within = |value: f64| {
            if range.contains(value) {
                value
            } else if range.contains(1.0) {
                1.0
            } else {
                range.max
            }
        };
        match setting.entry {
            Entry::Choice { choices } => json!(choices[seed as usize % choices.len()]),
            Entry::Integer => json!(within(f64::from(seed))),
            Entry::Real => json!(within(f64::from(seed) / 8.0)),
            Entry::Text => json!(format!("T{seed}")),
        }
    }

    /// What files are to prevent: arrays and counts that differ, erasing, converting.
    const PREVENTED: [&str; 7] = ["count", "no-array", "fields", "units", "erases", "ratios", "unread"];

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]
        // oracle: self (a machine of any sizes, units, switches and values: its files give it back, and the check of
        // a machine finds nothing in them that they are to prevent)
        #[test]
        fn any_machine_is_written_and_read_back(
            counts in prop::collection::vec(0_u32..9, 4),
            memories in prop::collection::vec(1_u32..40, 2),
            inch in any::<bool>(),
            chosen in prop::collection::vec((any::<prop::sample::Index>(), 0_u32..2000), 0..25),
        ) {
            let basic = if inch { "inch" } else { "mm" };
            let machine = |data: &serde_json::Value| -> Machine {
                serde_json::from_value(json!({ "own": { "basic": basic, "data": data } })).unwrap()
            };
            let mut data = json!({ "_EVMVNUM[0]": memories[0], "_EVMVNUM[1]": memories[1] });
            for (at, count) in counts.iter().enumerate() {
                data[format!("_CVAL[{at}]")] = json!(count);
            }
            let form = with_values(Some(machine(&data)), None, &[]).unwrap();
            let control = start(Dialect::Sinumerik, Some(machine(&data))).unwrap().setup.control;
            let of_files = |name: &str| {
                let kept = ["_CVAL", "_EVMVNUM", "_EV", "_MV"].contains(&stem(name));
                let system = [UNITS_OF_CONTROL, UNITS_OF_CHANNEL, "_CBIT[13]"].contains(&name);
                // arrays of measuring in JOG have an element for each tool probe
                let there = gud::named(name).is_some_and(|gud| elements(&control, gud).iter().any(|one| one == name));
                there && !kept && !system
            };
            let fields = form.groups.iter().flat_map(|group| &group.fields).map(|field| &field.setting);
            let fields: Vec<&Setting> = fields.filter(|setting| of_files(&setting.name)).collect();
            for (index, seed) in chosen {
                let setting = index.get(&fields);
                data[&setting.name] = allowed(setting, seed);
            }
            let before = with_values(Some(machine(&data)), None, &[]).unwrap();
            let asked = DefinitionsRequest { setup: Some(machine(&data)), ..DefinitionsRequest::default() };
            let mut files = files(definitions(asked).unwrap());
            if files.is_empty() {
                prop_assert!(before.data.is_empty());
                return Ok(());
            }
            let back = read_back(ReadBackRequest { setup: None, files: files.clone() }).unwrap();
            prop_assert_eq!((back.machine.basic, &back.machine.problems), (before.basic, &vec![]));
            prop_assert_eq!(&back.machine.data, &before.data, "{:#?}", files);
            let metric = format!("MD10240={}", u8::from(!inch));
            files.push(ExportedFile { name: "PW.TEA".to_owned(), text: metric });
            let (without, large, deflection) = (Vec::new(), false, None);
            let view = machine_check(MachineCheckRequest { files, without, large, deflection }).unwrap();
            for fault in view.faults {
                let key = fault.message.key.trim_start_matches("machine-check-").to_owned();
                let own = data.get(&fault.name).and_then(serde_json::Value::as_f64) == Some(0.0);
                prop_assert!(!PREVENTED.contains(&&key[..]) && (key != "depth" || own), "{:?}", fault);
            }
        }
    }

    // oracle: manual B:12920-12927 (7, at most 9)
    #[test]
    fn what_is_needed_is_the_least() {
        let view = view(json!({}), 1, true);
        let needs: Vec<(&str, f64)> = view.needs.iter().map(|need| (need.number, need.value)).collect();
        assert_eq!(needs, [("MD18118", 7.0), ("MD18120", 20.0), ("MD18130", 90.0), ("MD18150", 12.0)]);
    }

    // oracle: manual B:13279, B:13240 (what is delivered for each probe), A:15891 (61349 without a depth)
    #[test]
    fn more_probes_have_what_is_delivered_for_each() {
        let files = files(view(json!({ "_CVAL[0]": 5, "_CVAL[1]": 5, "_CVAL[3]": 4 }), 1, true));
        let all: String = files.iter().map(|file| file.text.as_str()).collect();
        for text in ["_TP[4,7]=133 _TP[4,8]=0 _TP[4,9]=2", "_TPW[3,7]=133", "_MC_MTL[5]=(33.3,33.3,33.3,33.3,33.3)"] {
            assert!(all.contains(text), "{text}\n{all}");
        }
    }

    // oracle: manual B:14294-14296 (these have to be entered, one for each tool probe)
    #[test]
    fn sizes_that_are_to_be_entered_are_named() {
        let names = |data, jog| {
            let notes = view(data, 1, jog).notes;
            let note = notes.into_iter().find(|note| note.key == "definitions-enter");
            note.map(|note| note.word("names").unwrap().to_owned())
        };
        let two = names(json!({ "_CVAL[0]": 2, "E_MESS_MT_DL[0]": 20 }), true);
        assert_eq!(two.as_deref(), Some("E_MESS_MT_DL[1], E_MESS_MT_DR[0], E_MESS_MT_DR[1]"));
        assert_eq!(names(json!({ "_CVAL[0]": 2 }), false), None);
        let all = json!({ "_CVAL[0]": 1, "E_MESS_MT_DL[0]": 20, "E_MESS_MT_DR[0]": 20 });
        assert_eq!(names(all, true), None);
    }

    // oracle: manual B:13594-13598, B:14059-14061 (MD10240 is the system, the switches say in which the data stand)
    #[test]
    fn an_export_in_inch_makes_a_machine_in_inch() {
        for text in [
            "N10240 $MN_SCALING_SYSTEM_IS_METRIC=0\n_CBIT[3]=0\nCHANDATA(1)\n_CHBIT[24]=0\n_SPEED[1]=40",
            "CHANDATA(1)\n_SPEED[1]=40\n_CHBIT[24]=0\n_CBIT[3]=0",
            "_SPEED[1]=40\nMD10240=0",
        ] {
            let file = ExportedFile { name: "INITIAL.INI".to_owned(), text: text.to_owned() };
            let back = read_back(ReadBackRequest { setup: None, files: vec![file] }).unwrap();
            assert_eq!((back.machine.basic, back.machine.problems), (Units::Inch, vec![]), "{text}");
            assert_eq!(back.machine.data, [("_SPEED[1]".to_owned(), Value::Number(40.0))].into(), "{text}");
            assert_eq!(back.changed, back.read, "{text}");
        }
        let other = json!({ "own": { "basic": "mm", "data": { "MD10240": 0 } } });
        let request = DefinitionsRequest { setup: Some(serde_json::from_value(other).unwrap()), ..Default::default() };
        assert_eq!(definitions(request).unwrap_err().message.key, "setup-basic");
    }

    // oracle: manual B:13278-13282 (a comment takes an array away), B:14228-14234 (behind a list 0 stands)
    #[test]
    fn short_lists_and_comments_are_read_as_a_control_has_them() {
        let text = "N10 DEF NCK INT _CVAL[4]=(2,2)\n;N13 DEF NCK REAL _KB[1,7]\nDEF NCK BOOL _CBIT[17]=(0,1)\n\
                    DEF NCK REAL _MFS[6]\n";
        let set = json!({ "data": { "_MFS[3]": 8 } });
        let (back, _) = read_and_written(text, set);
        for name in ["_CVAL[2]", "_CVAL[3]", "_CBIT[3]", "_CBIT[8]", "_CBIT[16]"] {
            assert_eq!(back.machine.data.get(name), Some(&Value::Number(0.0)), "{name}");
        }
        assert_eq!(back.machine.basic, Units::Metric);
        assert_eq!(back.machine.data.get("_MFS[3]"), None);
        let (back, _) = read_and_written(";N111 DEF NCK REAL _TPW[3,10]\n_DIGIT=4", json!({}));
        assert_eq!(back.machine.data.get("_CVAL[3]"), Some(&Value::Number(0.0)));
    }

    /// The machine that reads these lines, and what it writes then.
    fn read_and_written(text: &str, had: serde_json::Value) -> (ReadBack, Vec<String>) {
        let setup = || Some(serde_json::from_value(json!({ "own": had })).unwrap());
        let files = vec![ExportedFile { name: "GUD6.DEF".to_owned(), text: text.to_owned() }];
        let back = read_back(ReadBackRequest { setup: setup(), files }).unwrap();
        let own = json!({ "own": { "data": back.machine.data, "definitions": back.definitions } });
        let setup = Some(serde_json::from_value(own).unwrap());
        let view = definitions(DefinitionsRequest { setup, ..DefinitionsRequest::default() }).unwrap();
        let lines = view.files.iter().filter(|file| file.name != PROGRAM).flat_map(|file| file.text.lines());
        let lines = lines.map(str::to_owned).collect();
        (back, lines)
    }

    // oracle: self (the size that a file has is that which is written again); manual B:2316-2321 (_EVMVNUM counts _EV)
    #[test]
    fn sizes_of_arrays_are_kept_and_written_again() {
        let (back, lines) = read_and_written("DEF NCK BOOL _CBIT[17]\nDEF CHAN REAL _EV[40]\n", json!({}));
        assert_eq!(back.definitions, ["DEF NCK BOOL _CBIT[17]"]);
        assert_eq!(back.machine.data["_EVMVNUM[0]"], Value::Number(40.0));
        assert!(lines.iter().any(|line| line.starts_with("DEF NCK BOOL _CBIT[17]")), "{lines:?}");
        assert!(lines.iter().any(|line| line == "DEF CHAN REAL _EV[40]"), "{lines:?}");
        // fields are counted, the other dimension is that of the file
        let (back, lines) = read_and_written("N12 DEF NCK REAL _WP[5,12]\n", json!({}));
        assert_eq!(back.machine.data["_CVAL[1]"], Value::Number(5.0));
        assert!(lines.iter().any(|line| line.starts_with("N12 DEF NCK REAL _WP[5,12]")), "{lines:?}");
        let (back, lines) = read_and_written("N12 DEF NCK REAL _WP[5,11]\n", json!({}));
        assert_eq!((back.definitions.len(), back.sizes), (0, None));
        assert!(lines.iter().any(|line| line.starts_with("N12 DEF NCK REAL _WP[5,11]")), "{lines:?}");
    }

    // oracle: self
    #[test]
    fn a_size_that_is_read_again_takes_the_place_of_the_earlier_one() {
        let had = json!({ "definitions": ["DEF NCK REAL LIMIT[2]", "DEF NCK BOOL _CBIT[17]"] });
        let (back, lines) = read_and_written("DEF NCK BOOL _CBIT[16]\n", had.clone());
        assert_eq!(back.definitions, ["DEF NCK REAL LIMIT[2]", "DEF NCK BOOL _CBIT[16]"]);
        assert!(lines.iter().any(|line| line.starts_with("DEF NCK BOOL _CBIT[16]")), "{lines:?}");
        let (back, lines) = read_and_written("DEF NCK BOOL _CBIT[30]=(0,0,0,1,0,0,0,0,1,0,0,0,0,0,0,0,1)\n", had);
        assert_eq!(back.definitions, ["DEF NCK REAL LIMIT[2]"]);
        assert!(lines.iter().all(|line| !line.contains("_CBIT")), "{lines:?}");
    }

    // oracle: self (what is written and read back is the machine that wrote it); peer (published tables: MD51600 counts
    // the workpiece probes, SD54600 their balls, SD55634 the speed in the plane, of the channel)
    #[test]
    fn setting_data_are_written_and_read_back() {
        let data = json!({
            "PW-GENERATION": 3, "MD51600": 5, "SD54600[0]": 5.9, "SD54600[4]": 3.5, "SD55634": 700, "SD54740": 5
        });
        let before = with_values(own(data.clone()), None, &[]).unwrap();
        let written = view(data, 1, true);
        let [file] = &written.files[..] else { panic!("{:?}", written.files) };
        assert_eq!(
            file.text,
            "N51600 $MNS_MEA_CAL_WP_NUM=5\nN54600 $SNS_MEA_WP_BALL_DIAM[0]=5.9\nN54600 $SNS_MEA_WP_BALL_DIAM[4]=3.5\n\
             N54740 $SNS_MEA_FUNCTION_MASK=5\nCHANDATA(1)\nN55634 $SCS_MEA_FEED_PLANE_VALUE=700\n"
        );
        assert!(before.assignments.starts_with("$SNS_MEA_WP_BALL_DIAM[0]=5.9\n"), "{}", before.assignments);
        assert_eq!((written.memory.len(), written.needs.len()), (0, 0));
        let files = || vec![ExportedFile { name: file.saved.to_owned(), text: file.text.clone() }];
        let back = read_back(ReadBackRequest { setup: None, files: files() }).unwrap();
        assert_eq!((back.machine.problems, back.ending.key.as_ref()), (vec![], "definitions-read-newer"));
        assert_eq!((back.read, back.changed), (5, 5));
        assert_eq!(back.machine.data, before.data);
        let setup = own(json!({ "PW-GENERATION": 2 }));
        let back = read_back(ReadBackRequest { setup, files: files() }).unwrap();
        assert_eq!(back.machine.data["PW-GENERATION"], Value::Number(2.0));
    }

    // oracle: hand (four times 1; the line that cannot be read leaves the machine as it is)
    #[test]
    fn repeated_values_are_taken_and_unreadable_ones_are_told() {
        let text = "DEF NCK INT _CVAL[4]=REP(1)\nDEF CHAN REAL _SPEED[4]=(50,abc)\nDEF NCK REAL _TP[1+1,10]\n";
        let (back, _) = read_and_written(text, json!({ "data": { "_SPEED[1]": 700 } }));
        let counts = ["_CVAL[0]", "_CVAL[3]", "_SPEED[1]"].map(|name| back.machine.data.get(name).cloned());
        assert_eq!(counts, [1.0, 1.0, 700.0].map(|number| Some(Value::Number(number))));
        let told: Vec<_> = back.unread.iter().map(|one| (&*one.name, one.place.as_ref().unwrap().line)).collect();
        assert_eq!((told, back.machine.problems.len()), (vec![("_SPEED", 2), ("_TP", 3)], 0));
        let ending = Message::new("definitions-read").number("read", 4.0).number("changed", 4.0);
        assert_eq!(back.ending, ending.number("problems", 2.0));
    }

    // oracle: hand (two values of a second channel, six of no element, two texts for numbers; a memory that the form
    // does not show is taken)
    #[test]
    fn no_value_is_dropped_without_a_word() {
        let text = "CHANDATA(1)\n_SPEED[1]=900\nCHANDATA(2)\n_CHBIT[16]=1\n_SPEED[0]=77\n";
        let (back, _) = read_and_written(text, json!({}));
        let ending = |read: f64, changed: f64, problems: f64| {
            let message = Message::new("definitions-read").number("read", read);
            message.number("changed", changed).number("problems", problems)
        };
        assert_eq!(back.ending, ending(1.0, 1.0, 2.0));
        let told = |back: &ReadBack| {
            let one =
                |one: &MachineFault| (one.name.clone(), one.message.key.to_string(), one.place.clone().unwrap().line);
            back.unread.iter().map(one).collect::<Vec<_>>()
        };
        let owned = |(name, key, line): (&str, &str, u32)| (name.to_owned(), key.to_owned(), line);
        assert_eq!(told(&back), [owned(("CHANDATA(2)", "definitions-other-channel", 4))]);
        // the second channel alone is a file too
        let (back, _) = read_and_written("CHANDATA(2)\n_SPEED[0]=77\n", json!({}));
        assert_eq!((back.ending, back.machine.data.len()), (ending(0.0, 0.0, 1.0), 0));

        let text = "_CBIT[99]=1\n_TP[50,1]=3\n_SPEED[9]=5\n_SPEED[1]=\"abc\"\n_CBIT[0]=\"1\"\n\
                    _EVMVNUM[0]=200 _EV[150]=0.3\n\
                    _EV[300]=1\n_DIGIT[1]=2\n_CBIT[16]=0\nDEF NCK BOOL _CBIT[16]\n_VMS=300\n_TXT[3]=\"a\"";
        let (back, lines) = read_and_written(text, json!({}));
        let wanted = [
            ("_SPEED[1]", "machine-check-text", 4),
            ("_CBIT[0]", "machine-check-text", 5),
            ("_CBIT[99]", "machine-check-no-element", 1),
            ("_DIGIT[1]", "machine-check-no-index", 8),
            ("_EV[300]", "machine-check-no-element", 7),
            ("_SPEED[9]", "machine-check-no-element", 3),
            ("_TP[50,1]", "machine-check-no-element", 2),
        ];
        assert_eq!(told(&back), wanted.map(owned));
        assert_eq!(back.machine.data["_EV[150]"], Value::Number(0.3));
        assert!(lines.iter().any(|line| line == "DEF CHAN REAL _EV[200]"), "{lines:?}");
        let words = crate::words::Words::english();
        assert!(back.unread.iter().all(|one| words.find(&one.message).is_some()));
    }

    // oracle: manual B:14532-14604 (GUD7_MC is loaded, GUD7 activated), B:13262-13292; without JOG nothing of them
    #[test]
    fn files_are_activated_in_their_order() {
        let keys = |data, jog| {
            let notes = view(data, 1, jog).notes;
            let files = |note: &Message| note.word("files").unwrap_or_default().to_owned();
            notes.iter().map(|note| (note.key.to_string(), files(note))).collect::<Vec<_>>()
        };
        let all = json!({ "_EVMVNUM[0]": 10, "E_MESS_FM": 400, "_CVAL[0]": 0 });
        let owned = |notes: &[(&str, &str)]| -> Vec<(String, String)> {
            notes.iter().map(|(key, files)| (format!("definitions-{key}"), (*files).to_owned())).collect()
        };
        let wanted = [
            ("insert", "GUD5.DEF, GUD6.DEF, GUD7_MC.DEF"),
            ("save", ""),
            ("activate", "GUD5.DEF, GUD6.DEF"),
            ("load", ""),
            ("older", ""),
            ("reset", ""),
            ("program", ""),
        ];
        assert_eq!(keys(all.clone(), true), owned(&wanted));
        let wanted = [
            ("insert", "GUD5.DEF, GUD6.DEF"),
            ("save", ""),
            ("activate", "GUD5.DEF, GUD6.DEF"),
            ("reset", ""),
            ("program", ""),
        ];
        assert_eq!(keys(all, false), owned(&wanted));
        let words = crate::words::Words::english();
        let about = |notes: Vec<Message>| notes.iter().map(|note| words.text(note)).collect::<String>();
        let without = about(view(json!({ "_CVAL[0]": 2, "E_MESS_FM": 400 }), 2, false).notes);
        assert!(!without.contains("GUD7"), "{without}");
        let only_jog = keys(json!({ "E_MESS_FM": 400 }), true);
        assert!(only_jog.iter().all(|(key, _)| key != "definitions-activate"), "{only_jog:?}");
    }

    // oracle: manual B:13726 (_SPEED[0] is a percentage)
    #[test]
    fn a_value_that_cannot_be_is_told() {
        let file = ExportedFile { name: "x".to_owned(), text: "_SPEED[0]=120 _DIGIT=4".to_owned() };
        let back = read_back(ReadBackRequest { setup: None, files: vec![file] }).unwrap();
        assert_eq!((back.read, back.changed), (2, 1));
        assert_eq!(back.machine.problems.len(), 1);
    }
}
