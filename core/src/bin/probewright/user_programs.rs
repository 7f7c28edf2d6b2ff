//! `probewright user-programs`: CYCLE198 and CYCLE199 with lines of the user.

use crate::file;
use crate::file::Problem;
use probewright_core::app::{self, CYCLE, UserBranch, UserProgramsRequest};
use probewright_core::json;
use probewright_core::message::Message;
use probewright_core::program::user_programs::callers;
use probewright_core::words::Words;
use std::io::Write;
use std::process::ExitCode;

/// Which cycles get which lines.
#[derive(clap::Args)]
pub struct Arguments {
    #[arg(long, value_name = "CYCLES", value_delimiter = ',')]
    cycles: Vec<String>,
    #[arg(long, value_name = "LINES", default_value = "", hide_default_value = true)]
    before: String,
    #[arg(long, value_name = "LINES", default_value = "", hide_default_value = true)]
    behind: String,
    #[arg(long, value_name = "VARIABLE")]
    case: Option<String>,
    #[arg(long)]
    json: bool,
}

/// Writes both programs.
pub fn user_programs(asked: &Arguments, words: &Words, out: &mut dyn Write) -> Result<ExitCode, Problem> {
    let all = || callers().map(|cycle| cycle.name.to_owned()).collect();
    let cycles: Vec<String> = if asked.cycles.is_empty() { all() } else { asked.cycles.clone() };
    let branch = |cycle: String| UserBranch { cycle, before: asked.before.clone(), behind: asked.behind.clone() };
    let said = |key: &'static str| (key.to_owned(), words.text(&Message::new(key).text("cycle", CYCLE)));
    let request = UserProgramsRequest {
        branches: cycles.into_iter().map(branch).collect(),
        variable: asked.case.clone(),
        words: Some(["user-program-before-line", "user-program-behind-line"].map(said).into()),
    };
    let view = app::user_programs(request).map_err(|refused| file::wrong(refused.message))?;
    if asked.json {
        file::print_json(json::document(&view), words, out)?;
        return Ok(ExitCode::SUCCESS);
    }
    for (name, text) in [("CYCLE198", &view.before), ("CYCLE199", &view.behind)] {
        writeln!(out, ";{name}\n{text}")?;
    }
    for note in &view.notes {
        file::complain(&words.text(note));
    }
    Ok(ExitCode::SUCCESS)
}
