//! `probewright check`, and how findings are printed.

use crate::file;
use crate::file::{Control, Problem};
use crate::joined::Joined;
use probewright_core::diagnostic::{Diagnostic, Severity};
use probewright_core::message::Message;
use probewright_core::syntax::position::Positions;
use probewright_core::words::Words;
use probewright_core::{app, program, syntax};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Arc;

/// What is checked.
#[derive(clap::Args)]
pub struct Arguments {
    #[arg(required = true)]
    files: Vec<PathBuf>,
    #[arg(long, conflicts_with = "setup")]
    control: Option<Control>,
    #[arg(long)]
    setup: Option<PathBuf>,
    #[arg(long, value_name = "FILES", num_args = 1..)]
    with: Vec<PathBuf>,
    #[arg(long)]
    json: bool,
}

/// Checks every file; 1 when there is an error in one of them, 2 when one cannot be read. The others are checked all
/// the same. With a setup they are held against its machine.
pub fn check(asked: &Arguments, words: &Words, out: &mut dyn Write) -> Result<ExitCode, Problem> {
    let machine = asked.setup.as_ref().map(|path| file::setup(path, asked.json, words, out)).transpose()?;
    let (mut errors, mut unread) = (0, false);
    let mut views = Vec::new();
    for path in &asked.files {
        let joined = match Joined::read(path, &asked.with, asked.control) {
            Ok(joined) => joined,
            Err(problem) => {
                file::complain_about(&problem, words);
                unread = true;
                continue;
            }
        };
        let found = match &machine {
            Some(setup) => {
                let macros = &setup.control.definitions.macros;
                let program = syntax::read_held(setup.control.dialect, &joined.text, macros, &mut |_| {});
                program::findings_on(&program, setup.control.clone())
            }
            None => program::findings(&syntax::read_held(joined.dialect, &joined.text, &Arc::default(), &mut |_| {})),
        };
        errors += found.iter().filter(|finding| finding.severity == Severity::Error).count();
        for (path, source, found) in joined.files(&found) {
            if asked.json {
                let name = path.display().to_string();
                views.push(serde_json::json!({ "file": name, "diagnostics": app::findings(&found, source) }));
            } else {
                print_all(path, source, &found, words, out)?;
            }
        }
    }
    if asked.json {
        file::print_json(views.into(), words, out)?;
    }
    Ok(match (unread, errors) {
        (true, _) => ExitCode::from(2),
        (_, 0) => ExitCode::SUCCESS,
        _ => ExitCode::FAILURE,
    })
}

/// Findings that are printed for one file: more of them is another sort of file, not a program with mistakes.
const PRINTED: usize = 200;

/// Prints findings as `file:line:col: error[61307]: …`.
pub fn print_all(
    path: &Path,
    source: &[u8],
    found: &[Diagnostic],
    words: &Words,
    out: &mut dyn Write,
) -> std::io::Result<()> {
    if found.is_empty() {
        return Ok(());
    }
    let positions = Positions::new(source);
    print_placed(path, &|place| positions.line_column(place), found, words, out)
}

/// Findings of a file that are printed, by their places.
pub fn printed(found: &[Diagnostic]) -> impl Iterator<Item = u32> {
    found.iter().take(PRINTED).filter_map(|finding| Some(finding.span?.start))
}

/// Prints findings, with line and column of each place.
pub fn print_placed(
    path: &Path,
    position: &dyn Fn(u32) -> (u32, u32),
    found: &[Diagnostic],
    words: &Words,
    out: &mut dyn Write,
) -> std::io::Result<()> {
    for finding in found.iter().take(PRINTED) {
        let place = finding.span.map_or(String::new(), |span| {
            let (line, column) = position(span.start);
            format!("{line}:{column}: ")
        });
        let text = one_line(finding, words);
        writeln!(out, "{}:{place}{text}", path.display())?;
    }
    let more = found.len().saturating_sub(PRINTED);
    if more > 0 {
        let more = Message::new("terminal-more").number("count", more as f64);
        writeln!(out, "{}: {}", path.display(), words.text(&more))?;
    }
    Ok(())
}

/// How bad a finding is, as programs read it.
pub fn severity(severity: Severity) -> &'static str {
    match severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
        Severity::Note => "note",
    }
}

/// `error[61307]: cause. cure`, without a place.
pub fn one_line(finding: &Diagnostic, words: &Words) -> String {
    format!("{}[{}]: {}", severity(finding.severity), finding.code, told(finding, words))
}

/// What a finding says: parameter, cause and cure.
pub fn told(finding: &Diagnostic, words: &Words) -> String {
    let mut line = String::new();
    let cause = words.text(&finding.message);
    if let Some(param) = finding.param.filter(|param| !cause.starts_with(param.as_str())) {
        line.push_str(&param);
        line.push_str(": ");
    }
    line.push_str(&cause);
    if let Some(hint) = &finding.hint {
        let ends = line.ends_with(['.', '。', '!', '?', ':', '：']);
        line.push_str(if ends { " " } else { ". " });
        line.push_str(&words.text(hint));
    }
    line
}
