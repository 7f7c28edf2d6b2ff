//! `probewright series`.

use crate::file;
use crate::file::Problem;
use crate::joined::Joined;
use probewright_core::app::{self, SeriesCall, SeriesFigure, SeriesShare, SeriesSpread, SeriesView};
use probewright_core::json;
use probewright_core::message::Message;
use probewright_core::run::Session;
use probewright_core::series::spread::unseen;
use probewright_core::syntax;
use probewright_core::words::Words;
use std::io::Write;
use std::path::PathBuf;
use std::process::ExitCode;
use std::rc::Rc;
use std::sync::Arc;

/// What is run how often, and where what comes out goes.
#[derive(clap::Args)]
pub struct Arguments {
    file: PathBuf,
    #[arg(long)]
    setup: PathBuf,
    #[arg(long, value_name = "NUMBER")]
    runs: Option<u32>,
    #[arg(long, value_name = "NUMBER")]
    seed: Option<u64>,
    #[arg(long, value_name = "FILES", num_args = 1..)]
    with: Vec<PathBuf>,
    #[arg(long, value_name = "NAME")]
    program: Option<String>,
    #[arg(long)]
    json: bool,
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
}

/// Runs a program many times; 1 when not one run reached its end.
pub fn series(arguments: &Arguments, words: &Words, out: &mut dyn Write) -> Result<ExitCode, Problem> {
    let mut setup = file::setup(&arguments.setup, arguments.json, words, out)?;
    setup.series.runs = arguments.runs.unwrap_or(setup.series.runs);
    setup.series.seed = arguments.seed.unwrap_or(setup.series.seed);
    setup.varies().map_err(|refused| file::wrong(refused.message))?;
    let joined = Joined::read(&arguments.file, &arguments.with, None)?.of(setup.control.dialect);
    let macros = Arc::clone(&setup.control.definitions.macros);
    let program = Rc::new(syntax::read_held(joined.dialect, &joined.text, &macros, &mut |_| {}));
    let main = arguments.program.clone();
    let view = app::series(&app::Prepared { setup, program, main }, &mut |_| {});
    if let Some(path) = &arguments.csv {
        file::write(path, std::iter::once(app::series_csv(&view)))?;
    }
    if arguments.json {
        file::print_json(json::document(&view), words, out)?;
    } else {
        print(&joined, &view, words, out)?;
    }
    Ok(if view.finished > 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

fn print(joined: &Joined, view: &SeriesView, words: &Words, out: &mut dyn Write) -> std::io::Result<()> {
    let count = |key: &'static str| Message::new(key).number("runs", f64::from(view.runs));
    let seed = count("series-runs").text("seed", view.seed.to_string()).number("finished", view.finished as f64);
    writeln!(out, "{}", words.text(&seed))?;
    for call in &view.calls {
        let place = call.call.line.map_or(String::new(), |line| {
            let (path, line) = joined.line(line - 1);
            format!("{}:{}: ", path.display(), line + 1)
        });
        let cycle = call.call.cycle.unwrap_or_default();
        writeln!(out, "{place}{cycle}: {}", words.text(&call.feature))?;
        for line in lines(call, words) {
            writeln!(out, "  {line}")?;
        }
    }
    for alarm in &view.alarms {
        let name = words.text(&Message::new("terminal-raised").text("alarm", &alarm.raised.code));
        let named = if alarm.raised.code.is_empty() { String::new() } else { format!("{name}: ") };
        let share = words.text(&shared(alarm.count, alarm.share, alarm.error));
        writeln!(out, "{share}: {named}{}", words.text(&alarm.raised.message))?;
    }
    if view.alarms.is_empty() && view.runs > 0 {
        let most = count("series-no-alarm").number("most", percent(unseen(view.runs as usize)));
        writeln!(out, "{}", words.text(&most))?;
    }
    Ok(())
}

/// What a call came to over all runs.
fn lines(call: &SeriesCall, words: &Words) -> Vec<String> {
    let mut lines = Vec::new();
    for figure in &call.measured {
        lines.push(format!("{} = {}", figure.name, words.text(&of_figure(figure, words))));
        lines.extend(capability(figure).map(|message| format!("  {}", words.text(&message))));
    }
    for one in &call.corrected {
        let target = format!("{} {}", words.text(&one.target), one.part);
        let message = spread("series-corrected", &one.spread, one.unit).text("target", target);
        lines.push(words.text(&message.number("count", one.spread.count as f64)));
    }
    let share = |one: &SeriesShare| {
        format!("{}: {}", words.text(&shared(one.count, one.share, one.error)), words.text(&one.words))
    };
    lines.extend(call.verdicts.iter().map(share));
    if !call.uncorrected.is_empty() {
        lines.push(words.key("series-uncorrected"));
        lines.extend(call.uncorrected.iter().map(|one| format!("  {}", share(one))));
    }
    lines
}

fn of_figure(figure: &SeriesFigure, words: &Words) -> Message {
    spread("series-figure", &figure.spread, figure.unit).text("label", words.text(&figure.label))
}

/// A message about numbers that spread, which has their mean and the like as arguments.
fn spread(key: &'static str, spread: &SeriesSpread, unit: &'static str) -> Message {
    let numbers = [
        ("mean", spread.mean),
        ("deviation", spread.deviation),
        ("low", spread.low),
        ("high", spread.high),
        ("min", spread.min),
        ("max", spread.max),
    ];
    let message = Message::new(key).text("unit", unit);
    numbers.into_iter().fold(message, |message, (name, value)| message.number(name, value))
}

fn capability(figure: &SeriesFigure) -> Option<Message> {
    let capability = figure.capability?;
    let round = |value: f64| (value * 100.0).round() / 100.0;
    let [low, high] = capability.cpk_interval.map(round);
    let message = Message::new("series-capability").number("cp", round(capability.cp));
    Some(message.number("cpk", round(capability.cpk)).number("low", low).number("high", high))
}

/// In how many runs something happened.
fn shared(count: usize, share: f64, error: f64) -> Message {
    let message = Message::new("series-share").number("count", count as f64);
    message.number("share", percent(share)).number("error", percent(error))
}

/// In percent, to the hundredth.
fn percent(share: f64) -> f64 {
    (share * 10_000.0).round() / 100.0
}
