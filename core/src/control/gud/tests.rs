//! The table against the manual's lists (`tests/data/`), row by row in both directions.
#![allow(clippy::unwrap_used)]
use super::*;
use crate::catalogue::CYCLES;
use crate::control::delivery::factor;
use crate::control::machine_data::{MACHINE_DATA, MachineDatum};
use crate::control::{delivery, machine_data};
use crate::dialect::Dialect;
use crate::message::Message;
use crate::test_data::{Row, data, rows};
use crate::words::Words;

fn elements() -> impl Iterator<Item = (&'static Gud, &'static Element)> {
    all().flat_map(|gud| gud.elements.iter().map(move |element| (gud, element)))
}

/// `_WP[k,0]`; arrays that are one row have no index in the lists, or `[]`, `[k]`, `[3]`.
fn printed(gud: &Gud, element: &Element) -> String {
    match element.index {
        "" | "k" => gud.name.to_owned(),
        index => format!("{}[{index}]", gud.name),
    }
}

fn listed(name: &str) -> &str {
    ["[]", "[k]"].iter().find_map(|end| name.strip_suffix(end)).unwrap_or(if name == "E_MESS[3]" {
        "E_MESS"
    } else {
        name
    })
}

// oracle: self (the counts that the lists had)
#[test]
fn nothing_is_lost() {
    assert_eq!(elements().count(), 245);
    assert_eq!(MACHINE_DATA.len(), 42);
}

// oracle: manual, tests/data/user_data.tsv
#[test]
fn every_element_is_in_the_list_and_the_other_way_round() {
    let rows = rows(data!("user_data.tsv"));
    let mut names: Vec<String> = elements().map(|(gud, one)| printed(gud, one)).collect();
    let mut wanted: Vec<&str> = rows.iter().map(|row| listed(row[0])).collect();
    names.sort();
    wanted.sort_unstable();
    assert_eq!(names, wanted);
    for row in &rows {
        let (gud, element) = elements().find(|(gud, one)| printed(gud, one) == listed(row[0])).unwrap();
        agrees(gud, element, row);
    }
}

/// Block, scope, type, size, unit, default and place of a row.
fn agrees(gud: &Gud, element: &Element, row: &Row) {
    let name = row[0];
    let block = match gud.block {
        Block::Gud5 => "GUD5",
        Block::Gud6 => "GUD6",
        Block::Gud7 => "GUD7",
    };
    assert!(row[1].starts_with(block), "{name}");
    assert_eq!(gud.channel, row[2] == "CHAN", "{name}");
    let kind: &[&str] = match gud.kind {
        Kind::Real if gud.name == "_MC_MTL" => &["INT"], // printed so, holds 33.3
        Kind::Real => &["REAL"],
        Kind::Integer => &["INT"],
        Kind::Bool => &["BOOL"],
        Kind::Text => &["STRING", "CHAR"],
        Kind::Frame => &["FRAME"],
    };
    assert!(kind.iter().any(|kind| row[3].starts_with(kind)), "{name}");
    size_agrees(gud, row[4], name);
    assert!(units(element.unit).contains(&row[6]), "{name}: {}", row[6]);
    if gud.block != Block::Gud5 {
        default_agrees(gud, element, row);
    }
    assert_eq!(row[9].split(';').next(), Some(element.source), "{name}");
}

/// Numbers in the list's size: those of the table, or fewer where fields are counted or an appendix says more.
fn size_agrees(gud: &Gud, text: &str, name: &str) {
    let bracket = text.split('[').nth(1).map(|rest| rest.split(']').next().unwrap());
    let printed: Vec<usize> =
        bracket.unwrap_or(text).split(',').filter_map(|size| size.parse().ok()).filter(|size| *size > 1).collect();
    if gud.text() && gud.sizes.is_empty() {
        return; // the list gives the length of the text
    }
    assert_eq!(printed.len(), gud.sizes.len(), "{name}: {text}");
    for (dimension, (size, most)) in printed.iter().zip(gud.sizes).enumerate() {
        let larger = dimension == 0 && (!gud.counted.is_empty() || gud.name == "_CBIT");
        assert!(size == most || larger && size < most, "{name}: {text}");
    }
}

fn units(unit: Unit) -> &'static [&'static str] {
    match unit {
        Unit::None => &["-", "coded"],
        Unit::Length(System::Active) => &["active system of units"],
        Unit::Length(System::Basic) => &["basic system", "mm/inch", "mm or inch"],
        Unit::Length(System::Metric) => &["mm ALWAYS", "mm"],
        Unit::Feed(System::Metric) => &["mm/min"],
        Unit::Feed(_) => &["mm/min or inch/min", "mm/min"],
        Unit::Speed(System::Metric) => &["m/min"],
        Unit::Speed(_) => &["m/min or feet/min", "m/min or ft/min"],
        Unit::Degree => &["degrees"],
        Unit::Rpm => &["rpm"],
        Unit::Percent => &["%"],
    }
}

fn default_agrees(gud: &Gud, element: &Element, row: &Row) {
    let printed = row[5].split([',', ' ']).next().unwrap();
    match element.initial {
        // A probe is calibrated by default: appendix A.1 (B:16259-16265).
        Initial::Number(value) if gud.name == "_WP" && value != 0.0 => {
            assert_eq!(row[8].parse(), Ok(value), "{}", row[0]);
        }
        Initial::Number(value) => {
            assert_eq!(printed.parse().unwrap_or(0.0), value, "{}", row[0]);
        }
        Initial::Text(text) => assert_eq!(printed.trim_matches('"'), text, "{}", row[0]),
    }
}

// oracle: manual, tests/data/machine_data.tsv
#[test]
fn every_machine_datum_is_in_the_list_and_the_other_way_round() {
    let rows = rows(data!("machine_data.tsv"));
    let numbers: Vec<&str> = MACHINE_DATA.iter().map(|datum| datum.number).collect();
    let wanted: Vec<String> = rows
        .iter()
        .map(|row| match row[0].strip_prefix("SD") {
            Some(_) => row[0].to_owned(),
            None => format!("MD{}", row[0]),
        })
        .collect();
    assert_eq!(numbers, wanted);
    for (datum, row) in MACHINE_DATA.iter().zip(&rows) {
        machine_datum_agrees(datum, row);
    }
}

fn machine_datum_agrees(datum: &MachineDatum, row: &Row) {
    let cell = |column: usize| match row[column] {
        "-" => "",
        text => text,
    };
    let name = row[1].split('[').next().unwrap();
    // a name in brackets is not printed at this place of the manual; another may have it
    let name = if name.starts_with('(') { datum.identifier } else { name };
    let found = [
        datum.identifier, datum.standard[0], datum.standard[1], datum.cycles, datum.jog, datum.bounds[0],
        datum.bounds[1], datum.effective, datum.unit,
    ];
    let wanted = [name, cell(2), cell(3), cell(4), cell(5), cell(6), cell(7), cell(8), cell(9)];
    assert_eq!(found, wanted, "{}", datum.number);
    assert_eq!(row[10].split(';').next(), datum.source.split(';').next());
}

// oracle: self
#[test]
fn everything_has_words_of_its_own() {
    let words = Words::english();
    let missing = |key: String| words.find(&Message::new(key.clone())).is_none().then_some(key);
    let mut lost: Vec<String> =
        SUBJECTS.iter().filter_map(|subject| missing(format!("machine-group-{}", subject.key))).collect();
    for (gud, element) in elements() {
        let key = gud.key(element);
        let values = element.choices.iter().map(|value| format!("{key}.v{value}"));
        lost.extend(values.filter_map(missing));
        lost.extend(missing(key));
    }
    lost.extend(MACHINE_DATA.iter().filter_map(|datum| missing(datum.key())));
    assert_eq!(lost, Vec::<String>::new());
}

// oracle: self
#[test]
fn a_name_is_found_with_its_index_only_inside_of_the_array() {
    for (name, found) in [
        ("_WP[0,1]", true),
        ("_WP[98,10]", true),
        ("_WP[99,0]", false),
        ("_WP[0]", false),
        ("_WP", false),
        ("_DIGIT", true),
        ("_DIGIT[0]", false),
        ("_CHBIT[29]", true),
        ("E_MESS_D_M", true),
        ("_NOTHING", false),
    ] {
        assert_eq!(named(name).is_some(), found, "{name}");
    }
    let gud = find("_MT_EC_R").unwrap();
    assert!(gud.element(&[0, 0]).is_none());
    // oracle: hand
    assert_eq!(gud.key(gud.element(&[3, 2]).unwrap()), "datum-mt-ec-r-1-1");
    assert_eq!(gud.places(gud.element(&[3, 2]).unwrap(), 0).len(), 20);
}

// oracle: self (every datum has one default, inside of what is allowed)
#[test]
fn what_is_delivered_is_allowed() {
    let control = delivery(Dialect::Sinumerik);
    for (gud, element) in elements().filter(|(gud, _)| gud.block != Block::Gud5) {
        let Initial::Number(value) = element.initial else {
            assert!(gud.text());
            continue;
        };
        assert!(element.range.contains(value), "{} {}", gud.name, element.index);
        let among = element.choices.is_empty() || element.choices.contains(&(value as i64));
        assert!(among, "{} {}", gud.name, element.index);
        for at in gud.places(element, 3) {
            let per = factor(element.unit, control.basic_units);
            assert_eq!(control.number(&gud.spelled(&at)) * per, value, "{}", gud.name);
        }
    }
}

// oracle: self: what the forms of the cycles know as parameter or result is a datum of the control
#[test]
fn the_catalogue_speaks_of_these_data() {
    for cycle in CYCLES
        .iter()
        .filter(|cycle| cycle.dialect == Dialect::Sinumerik)
        // What a helper is called with are variables of the program.
        .filter(|cycle| cycle.purpose.probe.measures())
    {
        let params = cycle.params.iter().map(|param| param.name.as_str());
        for name in params.chain(cycle.results.iter().map(|result| result.name)) {
            let own = name.starts_with('_');
            assert!(!own || named(name).is_some(), "{} {name}", cycle.name);
        }
    }
}

// oracle: hand
#[test]
fn machine_data_are_read_as_printed() {
    assert_eq!(machine_data::number("21H"), Some(33.0));
    assert_eq!(machine_data::number("07FFFH"), Some(32767.0));
    assert_eq!(machine_data::number(" TRUE "), Some(1.0));
    assert_eq!(machine_data::number("9"), Some(9.0));
    assert_eq!(machine_data::number("12/16"), None);
    let known = |name: &str| machine_data::MACHINE_DATA.iter().any(|datum| datum.names().iter().any(|one| one == name));
    assert!(known("MD20050[2]"));
    assert!(!known("MD20050"));
}
