//! `probewright commissioning`: the steps by which measuring cycles come to a machine.

use crate::file::{self, Problem, wrong};
use probewright_core::message::Message;
use probewright_core::report::commissioning::{steps, ways};
use probewright_core::words::Words;
use std::io::Write;
use std::path::PathBuf;
use std::process::ExitCode;

/// What is told.
#[derive(clap::Args)]
pub struct Arguments {
    #[arg(value_name = "NAME")]
    way: Option<String>,
    #[arg(long)]
    setup: Option<PathBuf>,
}

/// Prints the ways, or the steps of one.
pub fn commissioning(asked: &Arguments, words: &Words, out: &mut dyn Write) -> Result<ExitCode, Problem> {
    let machine = asked.setup.as_ref().map(|path| file::setup(path, false, words, out)).transpose()?;
    let control = machine.as_ref().map(|setup| &setup.control);
    let text = asked.way.as_ref().map_or_else(|| ways(words), |way| steps(way, control, words));
    if text.is_empty() {
        let name = asked.way.clone().unwrap_or_default();
        return Err(wrong(Message::new("terminal-name").text("name", name)));
    }
    write!(out, "{text}")?;
    Ok(ExitCode::SUCCESS)
}
