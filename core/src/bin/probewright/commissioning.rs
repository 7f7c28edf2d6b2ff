//! `probewright commissioning`: the steps by which measuring cycles come to a machine.

use crate::file::{Problem, wrong};
use probewright_core::message::Message;
use probewright_core::report::commissioning::{steps, ways};
use probewright_core::words::Words;
use std::io::Write;
use std::process::ExitCode;

/// Prints the ways, or the steps of one.
pub fn commissioning(way: Option<&str>, words: &Words, out: &mut dyn Write) -> Result<ExitCode, Problem> {
    let text = way.map_or_else(|| ways(words), |way| steps(way, words));
    if text.is_empty() {
        return Err(wrong(Message::new("terminal-name").text("name", way.unwrap_or_default())));
    }
    write!(out, "{text}")?;
    Ok(ExitCode::SUCCESS)
}
