//! The reference of user and machine data in `docs/machine-data.md`, written from the tables and the message files.

use super::markdown::{line, table};
use super::said;
use crate::control::gud::{Block, Element, Gud, Initial, Kind, Subject, System, Unit};
use crate::control::machine_data::{MACHINE_DATA, MachineDatum};
use crate::control::nct_data::NctDatum;
use crate::control::{GENERATION, OLDER_JOG, gud, nct_data};
use crate::manual::Cited;
use crate::message::Message;
use crate::program::user_programs;
use crate::program::user_programs::UserProgram;
use crate::range::Range;
use crate::support;
use crate::words::Words;

/// The page, Markdown.
pub fn page(words: &Words) -> String {
    let mut text = String::new();
    line(&mut text, &format!("# {}", words.key("report-machine")));
    line(&mut text, &words.key("report-machine-intro"));
    for subject in gud::SUBJECTS {
        user_data(&mut text, subject, words);
    }
    machine_data(&mut text, words);
    user_programs(&mut text, words);
    for subject in nct_data::SUBJECTS {
        nct_subject(&mut text, subject, words);
    }
    text.trim_end().to_owned() + "\n"
}

fn user_data(text: &mut String, subject: &'static Subject, words: &Words) {
    let title = words.key(format!("machine-group-{}", subject.key));
    let columns = ["name", "meaning", "block", "type", "default", "unit", "range", "source"];
    let own = match subject.key {
        gud::MASKS => &OURS[..2],
        gud::JOG => &OURS[2..],
        _ => &[],
    };
    let own = own.iter().map(|one| ours(one, words));
    let of_datum = |gud: &'static Gud| gud.elements.iter().map(move |element| cells(gud, element, words));
    table(text, &title, columns, own.chain(subject.data.iter().flat_map(of_datum)), words);
}

/// A setting of ours: its name, key, and the numbers that it can be.
type Ours = (&'static str, &'static str, &'static [i64]);

/// Those of the masks, then that of measuring in JOG.
const OURS: [Ours; 3] = [
    (GENERATION, "datum-pw-generation", &[0, 1, 2, 3]),
    (support::FORMS, support::FORMS_KEY, &[0, 1]),
    (OLDER_JOG, "datum-pw-jog", &[0, 1]),
];

fn ours((name, key, choices): &Ours, words: &Words) -> [String; 8] {
    let (name, meaning) = (format!("`{name}`"), meaning(key, choices, words));
    [&name, &meaning, &words.key("report-own-setting"), "", "0", "", "", ""].map(str::to_owned)
}

fn cells(gud: &Gud, element: &Element, words: &Words) -> [String; 8] {
    [
        format!("`{}`", name(gud, element)),
        meaning(&gud.key(element), element.choices, words),
        block(gud, words),
        gud.kind.name().to_owned(),
        initial(gud, element),
        unit(element.unit, words),
        range(element.range, words),
        Cited(element.source).to_string(),
    ]
}

fn name(gud: &Gud, element: &Element) -> String {
    match element.index {
        "" => gud.name.to_owned(),
        index => format!("{}[{index}]", gud.name),
    }
}

/// Name, help and the values of a choice, in a cell of a table.
fn meaning(key: &str, choices: &[i64], words: &Words) -> String {
    lines(key, choices, words).join("<br>")
}

/// Name and help in one line, each value of a choice in one of its own.
fn lines(key: &str, choices: &[i64], words: &Words) -> Vec<String> {
    let label = words.key(key.to_owned());
    let first = match words.find(&Message::new(format!("{key}.help"))) {
        Some(help) => format!("{label}. {help}"),
        None => label,
    };
    let value = |value: &i64| format!("{value}: {}", words.key(format!("{key}.v{value}")));
    [first].into_iter().chain(choices.iter().map(value)).collect()
}

/// The data of the machine whose name is asked for: name, place in the manual, meaning. A machine datum is known by its
/// number and by its identifier.
pub fn told(asked: impl Fn(&str) -> bool, words: &Words) -> Vec<(String, &'static str, Vec<String>)> {
    let elements = gud::SUBJECTS
        .iter()
        .flat_map(|subject| subject.data)
        .flat_map(|gud| gud.elements.iter().map(move |element| (gud, element)))
        .map(|(gud, element)| {
            let key = gud.key(element);
            (name(gud, element), element.source, key, element.choices)
        });
    let machine = MACHINE_DATA.iter().filter(|datum| asked(datum.number) || asked(datum.identifier)).map(|datum| {
        let name = format!("{} {}", datum.number, datum.identifier);
        (name, datum.source, datum.key(), [].as_slice())
    });
    let nct = nct_data::SUBJECTS
        .iter()
        .flat_map(|subject| subject.data)
        .map(|datum| (datum.name.to_owned(), datum.element.source, datum.key(), datum.element.choices));
    let own = OURS.iter().map(|(name, key, choices)| ((*name).to_owned(), "", (*key).to_owned(), *choices));
    let named = elements.chain(nct).chain(own).filter(|(name, ..)| asked(name));
    named.chain(machine).map(|(name, source, key, choices)| (name, source, lines(&key, choices, words))).collect()
}

fn block(gud: &Gud, words: &Words) -> String {
    let of = if gud.block == Block::Gud6 && !gud.channel { "report-of-control" } else { "report-of-channel" };
    format!("{}, {}", format!("{:?}", gud.block).to_uppercase(), words.key(of))
}

/// Parameters of a call have their defaults on the pages of the cycles.
fn initial(gud: &Gud, element: &Element) -> String {
    match element.initial {
        Initial::Number(_) if !gud.of_machine() || matches!(gud.kind, Kind::Frame | Kind::Text) => String::new(),
        _ => delivered(element),
    }
}

fn delivered(element: &Element) -> String {
    match element.initial {
        Initial::Number(value) => value.to_string(),
        Initial::Text(text) => format!("`{text}`"),
    }
}

fn unit(unit: Unit, words: &Words) -> String {
    let key = match unit {
        Unit::None => "",
        Unit::Length(System::Active) => "report-unit-active",
        Unit::Length(System::Basic) => "report-unit-basic",
        Unit::Length(System::Metric) => "mm",
        Unit::Feed(System::Metric) => "mm/min",
        Unit::Feed(_) => "report-feed-basic",
        Unit::Speed(System::Metric) => "m/min",
        Unit::Speed(_) => "report-speed-basic",
        Unit::Degree => "°",
        Unit::Rpm => "report-unit-rpm",
        Unit::Percent => "%",
    };
    words.key(key) // signs of units have no words and show themselves
}

fn range(range: Range, words: &Words) -> String {
    match (range.min.is_finite(), range.max.is_finite()) {
        (true, true) => between(range.min, range.max, words),
        (true, false) if range.min_included => format!("≥ {}", range.min),
        (true, false) => format!("> {}", range.min),
        _ => String::new(),
    }
}

/// From one value to another.
fn between(from: impl ToString, to: impl ToString, words: &Words) -> String {
    said(words, "report-between", &[("from", from.to_string()), ("to", to.to_string())])
}

fn machine_data(text: &mut String, words: &Words) {
    let columns = ["number", "name", "meaning", "standard", "cycles", "jog", "bounds", "effective", "used", "source"];
    let rows = MACHINE_DATA.iter().map(|datum| machine_cells(datum, words));
    table(text, &words.key("machine-group-machine-data"), columns, rows, words);
}

fn machine_cells(datum: &MachineDatum, words: &Words) -> [String; 10] {
    let [old, new] = datum.standard;
    let both = [("old", old.to_owned()), ("new", new.to_owned())];
    let standard = if old == new { old.to_owned() } else { said(words, "report-standard", &both) };
    let [min, max] = datum.bounds;
    let bounds = if min.is_empty() { String::new() } else { between(min, max, words) };
    let names = datum.initial_names.iter().map(|name| (*name).to_owned());
    let taken: Vec<String> = datum.initial.iter().map(f64::to_string).chain(names).collect();
    [
        datum.number.to_owned(),
        datum.identifier.to_owned(),
        meaning(&datum.key(), &[], words),
        standard,
        datum.cycles.to_owned(),
        datum.jog.to_owned(),
        bounds,
        datum.effective.to_owned(),
        taken.join(", "),
        Cited(datum.source).to_string(),
    ]
}

/// Programs of the machine's user around each measurement.
fn user_programs(text: &mut String, words: &Words) {
    let cells = |program: &UserProgram| {
        [format!("`{}`", program.name), meaning(program.key, &[], words), Cited(program.source).to_string()]
    };
    let rows = user_programs::ALL.into_iter().map(cells);
    table(text, &words.key("machine-user-programs"), ["name", "called", "source"], rows, words);
}

/// Variables and parameters of an NCT control.
fn nct_subject(text: &mut String, subject: &Subject<NctDatum>, words: &Words) {
    let group = words.key(format!("machine-group-{}", subject.key));
    let columns = ["name", "meaning", "default", "unit", "range", "source"];
    let cells = |datum: &NctDatum| {
        let element = &datum.element;
        [
            format!("`{}`", datum.name),
            meaning(&datum.key(), element.choices, words),
            delivered(element),
            unit(element.unit, words),
            range(element.range, words),
            Cited(element.source).to_string(),
        ]
    };
    table(text, &format!("NCT: {group}"), columns, subject.data.iter().map(cells), words);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::held;

    // oracle: self. With PROBEWRIGHT_UPDATE=1 the page is written instead.
    #[test]
    fn the_pages_in_docs_are_those_of_the_tables() {
        held("machine-data.md", page);
    }
}
