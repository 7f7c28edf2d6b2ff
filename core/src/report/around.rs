//! The blocks around a measuring call as a person reads them: `docs/around.md` has each with its fields and its lines.

use crate::catalogue::{CYCLES, example::example};
use crate::check;
use crate::control::Plane;
use crate::dialect::Dialect;
use crate::entry::{Inputs, Typed};
use crate::machine::Setup;
use crate::program::around::{Block, Field, Kind, absent, block, blocks, choices, preset, write};
use crate::report::markdown::{line, rows};
use crate::words::Words;
use std::collections::BTreeMap;

const CONTROLS: [Dialect; 2] = [Dialect::Sinumerik, Dialect::Nct];

/// The page of all blocks, Markdown.
pub fn page(words: &Words) -> String {
    let mut text = String::new();
    line(&mut text, &format!("# {}", words.key("report-around")));
    line(&mut text, &words.key("report-around-intro"));
    line(&mut text, &words.key("report-generated"));
    for one in blocks(Dialect::Sinumerik) {
        section(&mut text, one, words);
    }
    text.trim_end().to_owned() + "\n"
}

fn section(text: &mut String, one: &Block, words: &Words) {
    line(text, &format!("## {}: `{}`", words.key(one.key()), one.name));
    line(text, &words.key(format!("{}-help", one.key())));
    let there: Vec<_> = CONTROLS.into_iter().filter_map(|dialect| Some((dialect, block(dialect, one.name)?))).collect();
    let mut fields: BTreeMap<&str, (usize, String, Vec<String>)> = BTreeMap::new();
    for &(dialect, block) in &there {
        for (at, field) in block.fields.iter().enumerate() {
            let (_, _, presets) = fields.entry(field.name).or_insert((at, words.key(field.key()), Vec::new()));
            presets.extend(shown(dialect, block, field, words).map(|value| format!("{value} ({})", dialect.name())));
        }
    }
    let mut cells: Vec<_> = fields.into_iter().collect();
    cells.sort_by_key(|(_, (at, ..))| *at);
    let cells = cells.into_iter().map(|(name, (_, label, presets))| [format!("`{name}`"), label, presets.join(", ")]);
    rows(text, ["name", "meaning", "default"], cells, words);
    for dialect in CONTROLS {
        if let Some(absent) = absent(dialect).iter().find(|absent| absent.name == one.name) {
            line(text, &format!("{}: {}", dialect.name(), words.key(absent.why)));
        }
    }
    for (dialect, block) in there {
        if let Some(lines) = sample(dialect, block, words) {
            line(text, &format!("{}:", dialect.name()));
            line(text, &format!("```\n{}\n```", lines.trim_end()));
        }
    }
}

/// What a field has where nothing is entered; none: it has to be entered.
fn shown(dialect: Dialect, block: &Block, field: &Field, words: &Words) -> Option<String> {
    let (inputs, _) = suited(dialect, block)?;
    let value = preset(field, &inputs);
    let value = if value.starts_with("around-") { words.key(value) } else { value };
    (!value.is_empty()).then(|| format!("`{value}`"))
}

/// The lines around the first call that it suits.
fn sample(dialect: Dialect, block: &Block, words: &Words) -> Option<String> {
    let (inputs, cycle) = telling(dialect, block).or_else(|| suited(dialect, block))?;
    let lines = write(block, &entered(block, &inputs), &inputs, "", &|key| words.key(key.to_owned()), true);
    Some(format!("{}{cycle} …\n{}", lines.before, lines.after))
}

/// What somebody could enter where nothing stands for a field by itself: for each what it takes.
fn entered(block: &Block, inputs: &Inputs) -> Typed {
    let nct = inputs.cycle.dialect == Dialect::Nct;
    let given = block.fields.iter().filter(|field| preset(field, inputs).is_empty());
    let value = |(at, field): (usize, &Field)| match field.kind {
        Kind::Program if nct => format!("{}", 110 + at),
        Kind::Program => format!("L{}", 110 + at),
        Kind::Target if nct => "500".to_owned(),
        Kind::Target => "SCRAP".to_owned(),
        _ => choices(field, inputs).first().map(|(choice, _)| (*choice).to_owned()).unwrap_or_default(),
    };
    given.enumerate().map(|(at, field)| (field.name.to_owned(), value((at, field)))).collect()
}

/// The first call of a control that its block suits and that has the difference which the block holds against a limit.
fn telling(dialect: Dialect, block: &Block) -> Option<(Inputs, &'static str)> {
    let differences = || block.fields.iter().filter(|field| matches!(field.kind, Kind::Deviation));
    calls(dialect, block).find(|(inputs, _)| differences().all(|field| !preset(field, inputs).is_empty()))
}

/// The first call of a control that its block suits.
fn suited(dialect: Dialect, block: &Block) -> Option<(Inputs, &'static str)> {
    calls(dialect, block).next()
}

/// The calls of a control that its block suits, measured without a correction where they have to be.
fn calls(dialect: Dialect, block: &Block) -> impl Iterator<Item = (Inputs, &'static str)> {
    let of_control = CYCLES.iter().filter(move |cycle| cycle.dialect == dialect);
    let calls = of_control.flat_map(|cycle| cycle.variants.iter().map(move |variant| (*cycle, variant)));
    calls.filter_map(move |(cycle, variant)| {
        let control = Setup::for_cycle(cycle, cycle.purpose.machine.plane().unwrap_or(Plane::G17)).control;
        [None, Some("0")].into_iter().find_map(|target| {
            let mut typed = example(cycle, variant);
            if let Some(target) = target {
                typed.insert("_KNUM".to_owned(), target.to_owned());
            }
            let inputs = check::read(cycle, &typed, &control, &mut Vec::new());
            block.suits(&inputs).then_some((inputs, cycle.name))
        })
    })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::program::around::problem;
    use crate::report::held;

    // oracle: hand: what the page shows can be entered; a result, a program and the target of a jump are three things
    #[test]
    fn every_sample_can_be_entered() {
        for (dialect, block) in CONTROLS.into_iter().flat_map(|one| blocks(one).iter().map(move |block| (one, block))) {
            let (inputs, _) = telling(dialect, block).or_else(|| suited(dialect, block)).unwrap();
            let typed = entered(block, &inputs);
            for field in block.fields {
                let wrong = problem(block, field, &typed, &inputs);
                assert_eq!(wrong, None, "{} {}: {typed:?}", block.name, field.name);
                let target = matches!(field.kind, Kind::Target);
                let programs = typed.values().filter(|value| value.starts_with('L') || value.starts_with("11"));
                assert!(!target || programs.count() == 0, "{}: {typed:?}", block.name);
            }
        }
    }

    // oracle: self
    #[test]
    fn the_page_is_the_generated_one() {
        held("around.md", super::page);
    }
}
