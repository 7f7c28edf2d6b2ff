//! A protocol of a real machine, laid onto the calls of the program that is run.

use crate::file::{self, Problem};
use probewright_core::app::{ProtocolColumns, ProtocolView, laid, missing_file};
use probewright_core::machine::Setup;
use probewright_core::message::{Message, printable};
use probewright_core::run::Outcome;
use probewright_core::words::{Words, rounded};
use std::io::Write;
use std::path::PathBuf;

/// The protocol, and what stands in which of its columns.
#[derive(clap::Args)]
pub struct Named {
    #[arg(long, value_name = "FILE")]
    measured: Vec<PathBuf>,
    #[arg(long, value_name = "COLUMNS", num_args = 1.., requires = "measured")]
    columns: Vec<String>,
}

/// A protocol that was read.
pub struct Protocol {
    paths: Vec<PathBuf>,
    texts: Vec<String>,
    columns: Option<ProtocolColumns>,
}

/// A protocol laid onto the calls of a program.
pub struct Laid {
    paths: Vec<PathBuf>,
    pub view: ProtocolView,
}

impl Named {
    /// Whether a protocol is named.
    pub fn given(&self) -> bool {
        !self.measured.is_empty()
    }

    /// Reads the protocol, whatever it is written in.
    pub fn read(&self) -> Result<Option<Protocol>, Problem> {
        if self.measured.is_empty() {
            return Ok(None);
        }
        let texts = self.measured.iter().map(|path| file::text(path)).collect::<Result<Vec<String>, Problem>>()?;
        let mut columns = ProtocolColumns::default();
        for text in &self.columns {
            let wrong = || file::wrong(Message::new("terminal-column").text("text", printable(text)));
            let (name, column) = text.split_once('=').ok_or_else(wrong)?;
            let place = match name.trim() {
                "number" => &mut columns.number,
                "line" => &mut columns.line,
                "result" => &mut columns.result,
                "nominal" => &mut columns.nominal,
                "actual" => &mut columns.actual,
                "deviation" => &mut columns.deviation,
                _ => return Err(wrong()),
            };
            if place.replace(column.trim().to_owned()).is_some() {
                return Err(file::wrong(Message::new("terminal-column-twice").text("name", name.trim())));
            }
        }
        let columns = (!self.columns.is_empty()).then_some(columns);
        Ok(Some(Protocol { paths: self.measured.clone(), texts, columns }))
    }
}

impl Protocol {
    /// Lays it onto what a program measured in a run.
    pub fn laid(self, setup: &Setup, outcome: &Outcome) -> Result<Laid, Problem> {
        let view = laid(&self.texts, self.columns.as_ref(), setup, outcome);
        let view = view.map_err(|refused| file::wrong_file(&self.paths[0], refused.message))?;
        let names: Vec<String> = self.paths.iter().map(|path| path.display().to_string()).collect();
        Ok(Laid { paths: self.paths, view: ProtocolView { gap: missing_file(&names, outcome), ..view } })
    }
}

impl Laid {
    /// Says what each call came to, which lines fit none or are in doubt, and how many; whether something fits.
    pub fn print(&self, words: &Words, out: &mut dyn Write) -> std::io::Result<bool> {
        let shown = |file: usize| self.paths.get(file).map(|path| path.display().to_string()).unwrap_or_default();
        let path = shown(0);
        for answer in &self.view.answers {
            let of_call = &answer.answer;
            for figure in &of_call.figures {
                let (actual, by) = (rounded(figure.actual), figure.deviation.map(rounded).unwrap_or_default());
                let (line, cycle) = (answer.call.line.unwrap_or_default(), answer.call.cycle.unwrap_or_default());
                let (what, verdict) = (words.text(&figure.label), words.text(&of_call.verdict_words));
                writeln!(out, "{path}: {line}: {cycle}: {what} {actual} ({by:+}) {verdict}")?;
            }
        }
        for one in self.view.unfit.iter().chain(&self.view.doubtful) {
            writeln!(out, "{}:{}: {} | {}", shown(one.file), one.line, words.text(&one.why), one.text)?;
        }
        if let Some(gap) = &self.view.gap {
            writeln!(out, "{path}: {}", words.text(gap))?;
        }
        writeln!(out, "{path}: {}", words.text(&self.view.ending))?;
        Ok(self.view.fitted > 0)
    }
}
