//! Which elements an array has on the control of the export.

use super::fault::{Files, MachineFault, machine_datum};
use super::read::{Exported, Given, shown};
use super::user::COUNTS;
use crate::control::gud::Gud;
use crate::control::needs::NEEDS;
use crate::control::{arrays, gud};
use crate::diagnostic::Severity::Error;
use crate::message::Message;
use crate::program::write::definition_files::{is_sized, sized};

/// Most probes (B:929, B:947).
pub const MOST: usize = 99;

/// Where an element of a user datum is.
#[derive(Clone, Debug, PartialEq)]
pub enum Room {
    /// In the array, at these indices.
    Inside(Vec<usize>),
    /// Nowhere: the array has these sizes.
    Beyond(Vec<usize>),
    /// Nowhere: there are fewer fields than this, so says the datum that counts them.
    Uncounted(usize),
    /// Nowhere: the definition of the array is a comment.
    Removed,
}

impl Room {
    /// The place of an element as a channel sees it: in the array as it is defined, else by the datum that counts its
    /// fields, else in the largest one that there is.
    pub fn of(given: &Exported, gud: &Gud, name: &str, channel: u32) -> Room {
        let defined = given.sizes.get(gud.name).map(|(sizes, _)| sizes.as_slice());
        if defined.is_none() && given.removed.contains_key(gud.name) {
            return Room::Removed;
        }
        let largest = || largest(gud);
        let sizes = defined.map_or_else(largest, <[usize]>::to_vec);
        let at = arrays::split(name).map(|(_, at)| at).unwrap_or_default();
        let inside = at.len() == sizes.len() && at.iter().zip(&sizes).all(|(index, size)| index < size);
        let count = COUNTS.iter().find(|(_, array, ..)| *array == gud.name).map(|(count, ..)| *count);
        let counted = || count.filter(|_| defined.is_none()).and_then(|count| given.number(count, channel));
        match at.first() {
            _ if !inside => Room::Beyond(sizes),
            Some(first) => match counted().map(|count| count.max(0.0) as usize).filter(|count| count <= first) {
                Some(count) => Room::Uncounted(count),
                None => Room::Inside(at),
            },
            None => Room::Inside(at),
        }
    }
}

/// The sizes of the largest array that there is. Those of measuring in JOG have an element for each tool probe
/// (B:14217-14225).
fn largest(gud: &Gud) -> Vec<usize> {
    let mut sizes = gud.sizes.to_vec();
    if let Some(first) = sizes.first_mut().filter(|_| is_sized(gud)) {
        *first = (*first).max(MOST);
    }
    sizes
}

/// How many probes there are: as the array is defined, which the lines to change follow, else as counted.
pub fn probes(given: &Exported, count: &str, array: &str, channel: u32) -> Option<usize> {
    let defined = given.sizes.get(array).and_then(|(sizes, _)| sizes.first().copied());
    let counted = || given.number(count, channel).map(|count| count.max(0.0) as usize);
    defined.or_else(counted).map(|probes| probes.min(MOST))
}

/// Values of elements that no array has.
pub fn faults(given: &Exported, files: &Files) -> Vec<MachineFault> {
    let fault = |((name, channel), one): (&(String, u32), &Given)| {
        let (message, source) = missing(given, name, *channel)?;
        let fault = MachineFault::new(Error, name, message, source).channel(*channel);
        Some(fault.value(shown(&one.value)).at(Some(files.told(one.place))))
    };
    given.data.iter().filter_map(fault).collect()
}

/// Why there is no such element; none: there is.
fn missing(given: &Exported, name: &str, channel: u32) -> Option<(Message, &'static str)> {
    let Some(gud) = gud::find(arrays::stem(name)) else { return beyond_machine_datum(name) };
    let message = match Room::of(given, gud, name, channel) {
        Room::Inside(_) => return None,
        Room::Beyond(sizes) => no_element(gud, &sizes).number("count", 1.0),
        Room::Uncounted(count) => {
            Message::new("machine-check-no-field").text("other", gud.counted).number("most", count as f64)
        }
        Room::Removed => Message::new("machine-check-no-array").text("array", gud.name),
    };
    Some((message, gud.elements.first().map_or("", |element| element.source)))
}

/// That an array of these sizes has no such element, or not so many of them as the count, which is to be added.
pub fn no_element(gud: &Gud, sizes: &[usize]) -> Message {
    if sizes.is_empty() {
        return Message::new("machine-check-no-index").text("name", gud.name);
    }
    let definition = sized(gud, sizes);
    let array = definition.rsplit(' ').next().unwrap_or_default();
    Message::new("machine-check-no-element").text("array", array)
}

/// The same of a machine datum that something is needed of.
fn beyond_machine_datum(name: &str) -> Option<(Message, &'static str)> {
    let (stem, at) = arrays::split(name)?;
    let needed = |number: &str| NEEDS.iter().any(|need| need.number == number);
    let datum = machine_datum(stem).filter(|datum| datum.elements > 0 && needed(datum.number))?;
    let array = format!("{stem}[{}]", datum.elements);
    let message = Message::new("machine-check-no-element").text("array", array).number("count", 1.0);
    at.first().filter(|at| **at >= datum.elements).map(|_| (message, datum.source))
}

/// Whether there is such an element of a machine datum.
pub fn exists(name: &str) -> bool {
    beyond_machine_datum(name).is_none()
}

/// Whether a check holds a datum against something: user data in their arrays, machine data that something is needed
/// of.
pub fn is_compared(given: &Exported, name: &str, channel: u32) -> bool {
    match gud::find(arrays::stem(name)) {
        Some(gud) => matches!(Room::of(given, gud, name, channel), Room::Inside(_)),
        None => super::data::is_needed(arrays::stem(name)) && exists(name),
    }
}
