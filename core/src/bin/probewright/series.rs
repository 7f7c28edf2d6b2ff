//! `probewright series`.

use crate::file;
use crate::file::Problem;
use crate::joined::Joined;
use probewright_core::app::{
    self, Certain, CertainChances, OfCall, SeriesCall, SeriesFigure, SeriesShare, SeriesSpread, SeriesView,
    WholeCertainty,
};
use probewright_core::json;
use probewright_core::machine::series::MOST_RUNS;
use probewright_core::message::{Message, printable};
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
    runs: Option<String>,
    #[arg(long, value_name = "NUMBER")]
    seed: Option<String>,
    #[arg(long, value_name = "FILES", num_args = 1..)]
    with: Vec<PathBuf>,
    #[arg(long, value_name = "NAME")]
    program: Option<String>,
    #[arg(long, conflicts_with = "csv")]
    certainty: bool,
    #[arg(long)]
    json: bool,
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
}

/// Fewest runs that tell how certain something is: one alone does not spread.
const FEWEST: u64 = 2;

/// A whole number from here to there, as an argument of this name gives it.
fn whole(text: Option<&str>, name: &str, [min, max]: [u64; 2]) -> Result<Option<u64>, Problem> {
    let Some(text) = text else { return Ok(None) };
    let message = || Message::new("terminal-whole").text("value", printable(text)).text("name", name);
    let range = |message: Message| message.text("min", min.to_string()).text("max", max.to_string());
    let number = text.trim().parse().ok().filter(|number| (min..=max).contains(number));
    number.map(Some).ok_or_else(|| file::wrong(range(message())))
}

/// Runs a program many times; 1 when not one run reached its end.
pub fn series(arguments: &Arguments, words: &Words, out: &mut dyn Write) -> Result<ExitCode, Problem> {
    let fewest = if arguments.certainty { FEWEST } else { 1 };
    let runs = whole(arguments.runs.as_deref(), "--runs", [fewest, u64::from(MOST_RUNS)])?.map(|runs| runs as u32);
    let seed = whole(arguments.seed.as_deref(), "--seed", [0, u64::MAX])?;
    let mut setup = file::setup(&arguments.setup, arguments.json, words, out)?;
    setup.series.runs = runs.unwrap_or(setup.series.runs);
    setup.series.seed = seed.unwrap_or(setup.series.seed);
    setup.varies().map_err(|refused| file::wrong(refused.message))?;
    let joined = Joined::read(&arguments.file, &arguments.with, None)?.of(setup.control.dialect);
    let macros = Arc::clone(&setup.control.definitions.macros);
    let program = Rc::new(syntax::read_held(joined.dialect, &joined.text, &macros, &mut |_| {}));
    let main = arguments.program.clone();
    let prepared = app::Prepared { setup, program, main };
    prepared.begins().map_err(|refused| file::wrong_file(&arguments.file, refused.message))?;
    if arguments.certainty {
        let view = app::whole_certainty(&prepared, runs, seed, &mut |_| {});
        return certain(&joined, &view, arguments.json, words, out);
    }
    let view = app::series(&prepared, &mut |_| {});
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

/// How certain each measurement is; 1 where none is known.
fn certain(
    joined: &Joined,
    view: &WholeCertainty,
    json: bool,
    words: &Words,
    out: &mut dyn Write,
) -> Result<ExitCode, Problem> {
    if json {
        file::print_json(json::document(view), words, out)?;
    } else {
        if view.stopped > 0.0 {
            let stopped = Message::new("certainty-stopped").number("share", percent(view.stopped));
            writeln!(out, "{}", words.text(&stopped))?;
        }
        for call in &view.calls {
            writeln!(out, "{}{}", place(joined, call.call), call.call.cycle.unwrap_or_default())?;
            for figure in &call.figures {
                writeln!(out, "  {} = {}", figure.name, told(figure, words))?;
            }
        }
        let runs = || Message::new("certainty-runs").number("runs", f64::from(view.runs));
        writeln!(out, "{}", words.text(&view.nothing.clone().unwrap_or_else(runs)))?;
    }
    Ok(if view.calls.iter().any(|call| !call.figures.is_empty()) { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// A chance that is smaller is not told as none.
const LEAST: f64 = 0.0005;

/// A value with its expanded uncertainty, what it proves, and what makes most of it.
fn told(figure: &Certain, words: &Words) -> String {
    let rounded = |value: f64| format!("{value:.*}", figure.decimals as usize);
    let value = Message::new("certainty-value")
        .text("value", rounded(figure.value))
        .text("expanded", rounded(figure.expanded))
        .text("unit", figure.unit)
        .number("coverage", figure.coverage)
        .text("label", words.text(&figure.label));
    let proof = figure.proof.map(|proof| Message::new(proof.key()));
    let chances = figure.chances.map(|chances| shares(&chances, words));
    let largest = figure.budget.first().map(|part| {
        let source = words.text(&part.source);
        Message::new("certainty-largest").text("source", source).number("share", percent(part.share))
    });
    let said = |message: Option<Message>| message.map(|message| words.text(&message));
    let parts = [said(Some(value)), said(proof), chances, said(largest)];
    parts.into_iter().flatten().collect::<Vec<_>>().join("  ")
}

/// The chances of a part: beyond the limits is rework or scrap where it is known which.
fn shares(chances: &CertainChances, words: &Words) -> String {
    let CertainChances { good, rework, scrap, beyond } = *chances;
    let known = [("certainty-rework", rework), ("certainty-scrap", scrap)];
    let unknown = [("certainty-beyond", beyond)];
    let rest = if beyond > 0.0 || rework + scrap == 0.0 { &unknown[..] } else { &known[..] };
    let told = |(key, share): (&'static str, f64)| {
        let message = Message::new(key);
        words.text(&match share {
            ..LEAST => message.text("share", "< 0.1"),
            _ if share > 1.0 - LEAST => message.text("share", "> 99.9"),
            _ => message.number("share", (share * 1000.0).round() / 10.0),
        })
    };
    let all = std::iter::once(("certainty-good", good)).chain(rest.iter().copied());
    all.map(told).collect::<Vec<_>>().join(", ")
}

/// File and line of a call.
fn place(joined: &Joined, call: OfCall) -> String {
    call.line.map_or(String::new(), |line| {
        let (path, line) = joined.line(line - 1);
        format!("{}:{}: ", path.display(), line + 1)
    })
}

fn print(joined: &Joined, view: &SeriesView, words: &Words, out: &mut dyn Write) -> std::io::Result<()> {
    let count = |key: &'static str| Message::new(key).number("runs", f64::from(view.runs));
    let seed = count("series-runs").text("seed", view.seed.to_string()).number("finished", view.finished as f64);
    writeln!(out, "{}", words.text(&seed))?;
    if let Some(more) = &view.more {
        writeln!(out, "{}", words.text(more))?;
    }
    for call in &view.calls {
        let place = place(joined, call.call);
        let cycle = call.call.cycle.unwrap_or_default();
        writeln!(out, "{place}{cycle}: {}", words.text(&call.feature))?;
        for line in lines(call, words) {
            writeln!(out, "  {line}")?;
        }
    }
    for alarm in &view.alarms {
        let name = words.text(&Message::new("terminal-raised").text("alarm", &alarm.raised.code));
        let named = if alarm.raised.code.is_empty() { String::new() } else { format!("{name}: ") };
        let share = words.text(&alarm.told);
        writeln!(out, "{share}: {named}{}", words.text(&alarm.raised.message))?;
    }
    if view.calls.is_empty() {
        writeln!(out, "{}", words.key("series-nothing"))?;
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
        let message =
            spread(["series-corrected", "series-corrected-one"], &one.spread, one.unit).text("target", target);
        lines.push(words.text(&message.number("count", one.spread.count as f64)));
    }
    let share = |one: &SeriesShare| format!("{}: {}", words.text(&one.told), words.text(&one.words));
    lines.extend(call.verdicts.iter().map(share));
    if !call.uncorrected.is_empty() {
        lines.push(words.key("series-uncorrected"));
        lines.extend(call.uncorrected.iter().map(|one| format!("  {}", share(one))));
    }
    lines
}

fn of_figure(figure: &SeriesFigure, words: &Words) -> Message {
    spread(["series-figure", "series-figure-one"], &figure.spread, figure.unit).text("label", words.text(&figure.label))
}

/// A message about numbers that spread, which has their mean and the like as arguments; the second one where there is
/// one number alone.
fn spread([several, one]: [&'static str; 2], spread: &SeriesSpread, unit: &'static str) -> Message {
    let numbers = [
        ("mean", spread.mean),
        ("deviation", spread.deviation),
        ("low", spread.low),
        ("high", spread.high),
        ("min", spread.min),
        ("max", spread.max),
    ];
    let key = if spread.count > 1 { several } else { one };
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

/// In percent, to the hundredth.
fn percent(share: f64) -> f64 {
    (share * 10_000.0).round() / 100.0
}
