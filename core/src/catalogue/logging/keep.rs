//! What CYCLE106 does: it deletes old files, writes header and blocks of values, begins pages and files that follow
//! (B:11194-11200, B:11253, B:11435). Where the machine does not report, none of it is done.

use super::contents::{Subject, block, first_page, header};
use super::names::{FILE, PAGE};
use super::state::State;
use super::{SIZE, refused};
use crate::catalogue::operator_messages::{LOG_NAME, NEW_LOG};
use crate::machine::files::{self, Fault, length};
use crate::machine::{Machine, Step, Stop};
use crate::message::Message;

/// Bytes of a kilobyte of MD11420.
const KILOBYTE: f64 = 1024.0;
/// What was logged before is deleted with its file.
pub const LOG_DELETED: &str = "evaluate-log-deleted";
/// No file of the log has room.
pub const LOG_FULL: &str = "evaluate-log-full";
/// Empty lines between two blocks of values (B:11521-11528).
const BETWEEN: usize = 2;

/// Switched on: the log is made anew, with its header (B:11229).
pub fn open(machine: &mut dyn Machine) -> Result<(), Stop> {
    if !machine.reports() {
        return Ok(());
    }
    let name = name(machine)?;
    let mut state = begun(machine, name);
    print_header(machine, &mut state);
    state.keep(machine.control());
    Ok(())
}

/// A header where the program wants one (CYCLE106(1)).
pub fn write_header(machine: &mut dyn Machine) -> Result<(), Stop> {
    if !machine.reports() {
        return Ok(());
    }
    let mut state = current(machine)?;
    print_header(machine, &mut state);
    state.keep(machine.control());
    Ok(())
}

/// A block of values; on a new page and below a header where one is due.
pub fn write_values(machine: &mut dyn Machine, subject: &Subject) -> Result<(), Stop> {
    if !machine.reports() {
        return Ok(());
    }
    let mut state = current(machine)?;
    let lines = block(machine, subject)?;
    let page = machine.control().number(PAGE.as_str());
    let beyond = page >= 1.0 && state.block && state.lines.saturating_add(gap(&state) + lines.len()) as f64 > page;
    if beyond || state.page < first_page(machine.control()) {
        print_header(machine, &mut state);
    }
    print_block(machine, &mut state, lines);
    Ok(())
}

/// Contents alone (CYCLE105), for the log that was begun last; where none was, they are printed nowhere.
pub fn write_contents(machine: &mut dyn Machine, subject: Option<&Subject>) -> Result<(), Stop> {
    if !machine.reports() {
        return Ok(());
    }
    let lines = subject.map(|subject| block(machine, subject)).transpose()?;
    let mut state = State::of(machine.control());
    if !begun_here(machine, &state) {
        machine.record(Step::Decision { message: Message::new("evaluate-log-none") });
        return Ok(());
    }
    match lines {
        Some(lines) => print_block(machine, &mut state, lines),
        None => {
            print_header(machine, &mut state);
            state.keep(machine.control());
        }
    }
    Ok(())
}

/// The name of the log, or the alarm that its file raises (A:15894-15898).
fn name(machine: &mut dyn Machine) -> Result<String, Stop> {
    let name = files::named(machine.control().text(FILE.as_str())).map_err(|fault| refused(alarm_of(fault)))?;
    if !name.ends_with(".MPF") {
        return Err(refused(alarm_of(Fault::Type)));
    }
    if machine.files().in_use(&name) {
        return Err(refused(alarm_of(Fault::InUse)));
    }
    Ok(name)
}

/// Number of the alarm to what is wrong with a file.
pub const fn alarm_of(fault: Fault) -> u32 {
    match fault {
        Fault::Path => 61352,
        Fault::NoName => 61354,
        Fault::Type => 61355,
        Fault::InUse => 61356,
    }
}

/// The log of the name that is given now; another name than before begins another log.
fn current(machine: &mut dyn Machine) -> Result<State, Stop> {
    let name = name(machine)?;
    let state = State::of(machine.control());
    Ok(if state.log == name && begun_here(machine, &state) { state } else { begun(machine, name) })
}

/// Whether a log was begun, and in this run.
fn begun_here(machine: &mut dyn Machine, state: &State) -> bool {
    !state.log.is_empty() && machine.files().lines(&state.log).is_some()
}

/// A log of this name without a line.
fn begun(machine: &mut dyn Machine, log: String) -> State {
    let page = first_page(machine.control()) - 1;
    make(machine, &log);
    State { log, page, ..State::default() }
}

/// An empty file; what this run has already logged under its name is deleted (B:11229), and that is told.
fn make(machine: &mut dyn Machine, file: &str) {
    let lines = machine.files().lines(file).map_or(0, <[String]>::len);
    if lines > 0 {
        let told = Message::new(LOG_DELETED).text("file", file).number("lines", lines as f64);
        machine.record(Step::Decision { message: told });
    }
    machine.create_file(file);
}

/// A header, with which a page begins.
fn print_header(machine: &mut dyn Machine, state: &mut State) {
    let next = state.page.saturating_add(1);
    let lines = header(machine, next);
    if needed(&lines) > room(machine, state) && !follow(machine, state) {
        return;
    }
    state.page = next;
    state.lines = 0;
    state.block = false;
    write(machine, state, lines.into_iter());
}

/// A block of values: whole in the present file, or below a header in the next one.
fn print_block(machine: &mut dyn Machine, state: &mut State, lines: Vec<String>) {
    let fits = needed(&lines).saturating_add(gap(state)) <= room(machine, state);
    if fits || follow(machine, state) {
        if !fits {
            print_header(machine, state);
        }
        let empty = vec![String::new(); gap(state)];
        write(machine, state, empty.into_iter().chain(lines));
        state.block = true;
    }
    state.keep(machine.control());
}

/// Lines one by one: what is longer than a file goes on in the next one.
fn write(machine: &mut dyn Machine, state: &mut State, lines: impl Iterator<Item = String>) {
    for line in lines {
        if length(&line) > room(machine, state) && !follow(machine, state) {
            return;
        }
        machine.write_file(&state.file(), line);
        state.lines = state.lines.saturating_add(1);
    }
}

/// Characters of lines.
fn needed(lines: &[String]) -> usize {
    lines.iter().map(|line| length(line)).sum()
}

/// Empty lines above the next block of values.
fn gap(state: &State) -> usize {
    if state.block { BETWEEN } else { 0 }
}

/// Characters for which the present file has room; an empty one takes any line.
fn room(machine: &mut dyn Machine, state: &State) -> usize {
    let size = (machine.control().number(SIZE).max(1.0) * KILOBYTE) as usize;
    let used = machine.files().size(&state.file());
    match used {
        _ if state.full() => 0,
        0 => usize::MAX,
        _ => size.saturating_sub(used),
    }
}

/// Goes on in the next file (B:11194-11200); false: there is none, the control waits for another name.
fn follow(machine: &mut dyn Machine, state: &mut State) -> bool {
    if !state.full() {
        state.number += 1;
        if state.full() {
            machine.record(Step::Message { text: LOG_NAME.to_owned(), waits: true });
            // told once: what comes later is left out as well
            machine.record(Step::Decision { message: Message::new(LOG_FULL).text("file", &state.log) });
        }
    }
    if state.full() {
        return false;
    }
    make(machine, &state.file());
    machine.record(Step::Message { text: NEW_LOG.to_owned(), waits: false });
    true
}
