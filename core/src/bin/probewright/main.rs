//! Measuring cycles from a terminal: the same catalogue, checks, reader and simulation as the page.

mod alarms;
mod braking;
mod check;
mod commissioning;
mod convert;
mod cycles;
mod definitions;
mod document;
mod explain;
mod file;
mod foreign;
mod help;
mod jog;
mod joined;
mod log;
mod lsp;
mod machine;
mod older;
mod progress;
mod protocol;
mod read;
mod record;
mod repeat;
mod run;
mod scan;
mod series;
mod stream;
mod test;
mod user_programs;
mod write;

use clap::{Parser, Subcommand};
use file::Problem;
use probewright_core::message::Message;
use probewright_core::words::{LANGUAGES, Words};
use std::io::{BufWriter, Write};
use std::process::ExitCode;

/// What the help says about each is a message: `terminal-…-about` of a command, `terminal-…-text` of an argument.
#[derive(Parser)]
#[command(name = "probewright", version, hide_possible_values = true)]
struct Arguments {
    #[arg(long, global = true)]
    lang: Option<String>,
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    Cycles {
        #[arg(long)]
        json: bool,
    },
    Explain {
        name: String,
        variant: Option<i64>,
    },
    Alarms {
        number: Option<String>,
        #[arg(long)]
        json: bool,
    },
    Check(check::Arguments),
    Write(write::Arguments),
    Convert(convert::Arguments),
    Read(read::Arguments),
    Run(Box<run::Arguments>),
    Series(series::Arguments),
    Test(test::Arguments),
    Jog(jog::Arguments),
    Machine(machine::Arguments),
    Braking(braking::Arguments),
    Repeat(repeat::Arguments),
    UserPrograms(user_programs::Arguments),
    Older(older::Arguments),
    Definitions(definitions::Arguments),
    Commissioning(commissioning::Arguments),
    Lsp,
}

fn main() -> ExitCode {
    let Ok(Arguments { lang, command }) = help::arguments() else { return help::answer() };
    let mut out = BufWriter::new(std::io::stdout().lock());
    let (words, known) = match words(lang.as_deref()) {
        Ok(words) => (words, Ok(())),
        Err(problem) => (Words::english(), Err(problem)),
    };
    let result = known
        .and_then(|()| run_command(command, lang.as_deref(), &words, &mut out))
        .and_then(|code| out.flush().map(|()| code).map_err(Problem::from));
    match result {
        Ok(code) => code,
        // whoever reads the output (head, a pager) has seen enough
        Err(problem) if is_closed(&problem) => ExitCode::SUCCESS,
        Err(problem) => {
            file::complain_about(&problem, &words);
            ExitCode::from(2)
        }
    }
}

/// In the language that was asked for, else that of the environment where it is known.
fn words(asked: Option<&str>) -> Result<Words, Problem> {
    let Some(code) = asked else {
        let set = |name: &&str| std::env::var(name).is_ok_and(|value| !value.is_empty());
        let first = ["LC_ALL", "LC_MESSAGES", "LANG"].into_iter().find(set);
        let wanted = first.and_then(|name| std::env::var(name).ok());
        return Ok(wanted.and_then(|code| Words::of(&code)).unwrap_or_else(Words::english));
    };
    Words::of(code).ok_or_else(|| {
        let known: Vec<&str> = LANGUAGES.iter().map(|language| language.code).collect();
        file::wrong(Message::new("terminal-language").text("code", code).text("known", known.join(", ")))
    })
}

fn run_command(command: Command, lang: Option<&str>, words: &Words, out: &mut dyn Write) -> Result<ExitCode, Problem> {
    match command {
        Command::Alarms { number, json } => alarms::alarms(number.as_deref(), json, words, out),
        Command::Explain { name, variant } => explain::explain(&name, variant, words, out),
        Command::Cycles { json } => cycles::cycles(json, words, out),
        Command::Check(asked) => check::check(&asked, words, out),
        Command::Write(asked) => write::write(&asked, words, out),
        Command::Convert(asked) => convert::convert_file(&asked, words, out),
        Command::Read(asked) => read::read(&asked, words, out),
        Command::Run(asked) => run::run(&asked, words, out),
        Command::Series(asked) => series::series(&asked, words, out),
        Command::Test(asked) => test::test(&asked, words, out),
        Command::Jog(asked) => jog::jog(&asked, words, out),
        Command::UserPrograms(asked) => user_programs::user_programs(&asked, words, out),
        Command::Definitions(asked) => definitions::definitions(&asked, words, out),
        Command::Older(asked) => older::older(&asked, words, out),
        Command::Repeat(asked) => repeat::repeat(&asked, words, out),
        Command::Braking(asked) => braking::braking(&asked, words, out),
        Command::Machine(asked) => machine::machine(&asked, words, out),
        Command::Commissioning(asked) => commissioning::commissioning(&asked, words, out),
        // words of its own: the client may ask for another language
        Command::Lsp => lsp::serve(self::words(lang)?, out),
    }
}

fn is_closed(problem: &Problem) -> bool {
    let kind = |error: &std::io::Error| error.kind() == std::io::ErrorKind::BrokenPipe;
    problem.downcast_ref().is_some_and(kind)
}
