//! `probewright explain`.

use crate::alarms;
use crate::file::{Problem, wrong};
use probewright_core::catalogue::CYCLES;
use probewright_core::entry::Cycle;
use probewright_core::jog::masks;
use probewright_core::message::Message;
use probewright_core::report::commissioning::{connection, named};
use probewright_core::report::explain::{arguments, cycle, datum, list, older, setting_datum, variant};
use probewright_core::report::findings::finding;
use probewright_core::report::foreign;
use probewright_core::report::guides;
use probewright_core::report::jog::explained;
use probewright_core::report::terms;
use probewright_core::words::Words;
use std::io::Write;
use std::process::ExitCode;

/// The help page of a variant of a cycle, or of a mask of measuring in JOG; else what a finding, an alarm, a parameter,
/// a result or a datum of the machine means, a connection, or a guide; `guides` lists these.
pub fn explain(name: &str, number: Option<i64>, words: &Words, out: &mut dyn Write) -> Result<ExitCode, Problem> {
    if name.eq_ignore_ascii_case("guides") {
        write!(out, "{}", guides::list(words))?;
        return Ok(ExitCode::SUCCESS);
    }
    let found = CYCLES.iter().find(|one| one.name.eq_ignore_ascii_case(name));
    let text = match (found, masks::find(name)) {
        (Some(found), _) => page(found, number, words)?,
        (None, Some(mask)) => explained(mask, words),
        (None, None) => {
            let newer = arguments(name, words) + &list(name, words) + &setting_datum(name, words);
            let foreign = foreign::cycle(name, words) + &foreign::parameter(name, words);
            datum(name, words)
                + &finding(name, words)
                + &newer
                + &older(name, words)
                + &foreign
                + &terms::explained(name, words)
                + &connection(name, words)
                + &guides::explained(name, words)
        }
    };
    let text = if text.is_empty() { guides::found(name, words) + &named(name, words) } else { text };
    if text.is_empty() {
        return alarms::alarms(Some(name), false, words, out)
            .map_err(|_| wrong(Message::new("terminal-name").text("name", name)));
    }
    write!(out, "{text}")?;
    Ok(ExitCode::SUCCESS)
}

fn page(found: &'static Cycle, number: Option<i64>, words: &Words) -> Result<String, Problem> {
    let Some(number) = number else {
        let list = list(found.name, words);
        return Ok(if list.is_empty() { cycle(found, words) } else { cycle(found, words) + "\n" + &list });
    };
    let chosen = found.variants.iter().find(|one| one.number == number);
    let none = Message::new("terminal-variant").text("cycle", found.name).number("number", number as f64);
    let chosen = chosen.ok_or_else(|| wrong(none))?;
    Ok(variant(found, chosen, words))
}
