//! Something that is wrong with a machine, with all that is known of the datum.

use super::ExportedFile;
use super::read::{Exported, Odd, Place};
use crate::catalogue::alarms;
use crate::control::machine_data::{MACHINE_DATA, MachineDatum};
use crate::control::needs::mask;
use crate::control::{arrays, gud};
use crate::diagnostic::{Code, Severity};
use crate::manual::Cited;
use crate::message::Message;
use serde::Serialize;

/// Something that is wrong with a machine.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct MachineFault {
    /// How bad it is.
    pub severity: Severity,
    /// The datum: `MD18120`, `_CBIT[3]`.
    pub name: String,
    /// Its identifier, where it is a machine datum and the manual prints it.
    pub identifier: &'static str,
    /// The channel that it is of.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub channel: Option<u32>,
    /// Its value, as a control writes it; empty: it has none.
    pub value: String,
    /// What is wrong.
    pub message: Message,
    /// What follows from it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub effect: Option<Message>,
    /// The alarm that follows: number and, in words, meaning.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub alarm: Option<Message>,
    /// What it has to be, by each place that says so.
    pub limits: Vec<MachineLimit>,
    /// As delivered, with system software up to 59 and from 63 on; the same once.
    pub delivered: Vec<String>,
    /// Where it stands.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub place: Option<MachinePlace>,
    /// Place in the manual.
    pub source: Cited,
    /// The line that mends it, as a control reads it; empty: none does.
    pub change: String,
    /// The datum and its new value, for the file of the lines.
    #[serde(skip)]
    pub mended: Option<Mended>,
    /// The name by which the control of the export calls a machine datum, without index; empty: it says none.
    #[serde(skip)]
    pub spelled: String,
}

/// A value that a datum has to be or to reach.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct MachineLimit {
    /// How bad it is to miss it.
    pub severity: Severity,
    /// The value, as a control writes it.
    pub value: String,
    /// Place in the manual.
    pub source: Cited,
}

/// A line of a file.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct MachinePlace {
    /// Name of the file.
    pub file: String,
    /// Line, from 1.
    pub line: u32,
}

/// A datum with the value that it should have.
#[derive(Clone, Debug, PartialEq)]
pub struct Mended {
    /// The value.
    pub value: f64,
    /// How it comes from another: bits that are set and cleared; none: it is this value.
    pub bits: Option<[u32; 2]>,
}

/// The files that were read.
pub struct Files<'a> {
    /// In their order.
    pub files: &'a [ExportedFile],
}

impl Files<'_> {
    /// A place as it is told.
    pub fn told(&self, place: Place) -> MachinePlace {
        let file = self.files.get(place.file).map(|file| crate::message::printable(&file.name));
        MachinePlace { file: file.unwrap_or_default(), line: place.line }
    }
}

impl MachineFault {
    /// A datum with what is wrong.
    pub fn new(severity: Severity, name: impl Into<String>, message: Message, source: &'static str) -> MachineFault {
        let name = name.into();
        let datum = machine_datum(&name);
        MachineFault {
            severity,
            identifier: datum.map_or("", |datum| datum.identifier),
            channel: None,
            value: String::new(),
            message,
            effect: None,
            alarm: None,
            limits: Vec::new(),
            delivered: datum.map_or_else(Vec::new, delivered),
            place: None,
            source: Cited(source),
            change: String::new(),
            mended: None,
            spelled: String::new(),
            name,
        }
    }

    /// In this channel; 0: none is said.
    pub fn channel(self, channel: u32) -> MachineFault {
        MachineFault { channel: (channel > 0).then_some(channel), ..self }
    }

    /// With the value as it is.
    pub fn value(self, value: String) -> MachineFault {
        MachineFault { value, ..self }
    }

    /// In this line.
    pub fn at(self, place: Option<MachinePlace>) -> MachineFault {
        MachineFault { place, ..self }
    }

    /// With what follows.
    pub fn effect(self, key: &str) -> MachineFault {
        MachineFault { effect: Some(Message::new(format!("machine-need-{key}"))), ..self }
    }

    /// With the alarm that follows; 0: none.
    pub fn alarm(self, number: u32) -> MachineFault {
        let alarm = (number > 0).then(|| Message::new(alarms::key(Code::Alarm(number))));
        MachineFault { alarm, ..self }
    }

    /// By the name that the control of the export uses.
    pub fn spelled(self, spelled: &str) -> MachineFault {
        MachineFault { spelled: spelled.to_owned(), ..self }
    }

    /// The datum as a line to change names it: as the export does, else as the manual does.
    pub fn line_name(&self) -> String {
        let (stem, index) = self.name.split_at(arrays::stem(&self.name).len());
        if self.spelled.is_empty() { format!("{}{index}", spelled(stem)) } else { format!("{}{index}", self.spelled) }
    }

    /// With the value that mends it.
    pub fn mended(mut self, value: f64) -> MachineFault {
        self.mend(value);
        self
    }

    /// Takes a value that mends it.
    pub fn mend(&mut self, value: f64) {
        self.change = format!("{}={}", self.line_name(), written(&self.name, value));
        self.mended = Some(Mended { value, bits: None });
    }

    /// With the bits that mend it.
    pub fn bits(self, value: f64, [set, clear]: [u32; 2]) -> MachineFault {
        let mended = self.mended(value);
        MachineFault { mended: Some(Mended { value, bits: Some([set, clear]) }), ..mended }
    }
}

/// Lines that cannot be read, data with the number of another or another identifier, and data that are given twice.
pub fn odd(given: &Exported, files: &Files) -> Vec<MachineFault> {
    let fault = |severity, key: &'static str, odd: &Odd| fault_of(severity, key, odd, files);
    let unlike = given.unlike.iter().map(|odd| fault(Severity::Warning, "machine-check-unlike", odd));
    let renamed = given.renamed.iter().map(|odd| fault(Severity::Note, "machine-check-renamed", odd));
    let twice = given.twice.iter().map(|odd| fault(Severity::Warning, "machine-check-twice", odd));
    unread(given, files).into_iter().chain(unlike).chain(renamed).chain(twice).collect()
}

/// Lines of which a value or a size cannot be read, or of which values have no element.
pub fn unread(given: &Exported, files: &Files) -> Vec<MachineFault> {
    let all = [
        (Severity::Error, "machine-check-unread", &given.unread),
        (Severity::Error, "machine-check-text", &given.texts),
        (Severity::Error, "machine-check-number", &given.numbers),
        (Severity::Error, "machine-check-unread-size", &given.unsized_arrays),
        (Severity::Warning, "machine-check-many", &given.beyond),
    ];
    let faults = |(severity, key, odd): (Severity, &'static str, &Vec<Odd>)| -> Vec<MachineFault> {
        odd.iter().map(|odd| fault_of(severity, key, odd, files)).collect()
    };
    all.into_iter().flat_map(faults).collect()
}

/// What is wrong with a line.
fn fault_of(severity: Severity, key: &'static str, odd: &Odd, files: &Files) -> MachineFault {
    let source = gud::place(&odd.name).and_then(|(gud, at)| gud.element(&at)).map(|element| element.source);
    let source = source.or_else(|| machine_datum(&odd.name).map(|datum| datum.source)).unwrap_or_default();
    let message = Message::new(key).text("value", &odd.texts[0]).text("before", &odd.texts[1]);
    MachineFault::new(severity, &odd.name, message, source).channel(odd.channel).at(Some(files.told(odd.place)))
}

fn delivered(datum: &MachineDatum) -> Vec<String> {
    let mut values: Vec<String> =
        datum.standard.iter().filter(|one| !one.is_empty()).map(ToString::to_string).collect();
    values.dedup();
    values
}

/// The machine datum of a name with or without index.
pub fn machine_datum(name: &str) -> Option<&'static MachineDatum> {
    MACHINE_DATA.iter().find(|datum| datum.number == arrays::stem(name))
}

/// `MD18120 MM_NUM_GUD_NAMES_NCK`
pub fn identified(number: &str) -> String {
    match machine_datum(number) {
        Some(datum) if !datum.identifier.is_empty() => format!("{number} {}", datum.identifier),
        _ => number.to_owned(),
    }
}

/// A name as a control reads it: `N18120 $MN_MM_NUM_GUD_NAMES_NCK`. Where the manual prints no name, its number stands.
pub fn spelled(name: &str) -> String {
    let Some(datum) = machine_datum(name).filter(|datum| !datum.identifier.is_empty()) else { return name.to_owned() };
    let (index, digits) = (&name[datum.number.len()..], &datum.number[2..]);
    let area = match (&datum.number[..2], digits.parse().unwrap_or(0_u32)) {
        ("SD", _) => "$SC_",
        (_, ..10_000) => "$MM_",
        (_, 10_000..20_000) => "$MN_",
        (_, 20_000..30_000) => "$MC_",
        _ => "$MA_",
    };
    format!("N{digits} {area}{}{index}", datum.identifier)
}

/// A value as a control writes it: a mask in hexadecimal digits.
pub fn written(name: &str, value: f64) -> String {
    match mask(value).filter(|_| masked(name)) {
        Some(bits) => format!("'H{bits:X}'"),
        None => value.to_string(),
    }
}

/// Whether a datum is a mask of bits.
fn masked(name: &str) -> bool {
    let number = arrays::stem(name);
    crate::control::needs::NEEDS.iter().any(|need| need.number == number && need.mask())
}
