//! Writing and reading are inverse, for every variant with values in range; and a change touches its own place only.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use probewright_core::catalogue::CYCLES;
use probewright_core::check;
use probewright_core::check::{Parsed, parse};
use probewright_core::control::{Control, Plane, Units, delivery};
use probewright_core::dialect::Dialect;
use probewright_core::entry::{Cycle, Kind, Param, ProbeUse, Style, Typed, When};
use probewright_core::program::calls::{CallSite, calls};
use probewright_core::program::change::{apply, change};
use probewright_core::program::write::{Words, snippet};
use probewright_core::syntax::{Program, read};
use proptest::prelude::*;

/// How one value is chosen and typed.
type Choice = (bool, f64, bool);

/// A value in the range of its parameter, with up to nine decimals; `part` is from 0 to 1.
fn number(param: &Param, part: f64) -> f64 {
    let low = param.range.min.max(-5000.0);
    let high = param.range.max.min(5000.0).max(low);
    match &param.kind {
        Kind::Choice(choices) => {
            let index = (part * choices.len() as f64) as usize;
            choices[index.min(choices.len() - 1)].0 as f64
        }
        Kind::Real => {
            let value = low + (high - low) * part;
            let rounded = (value * 1e9).round() / 1e9;
            if param.range.contains(rounded) { rounded } else { high }
        }
        _ => (low + (high - low) * part).ceil().clamp(low.ceil(), high.floor()),
    }
}

/// As a person types it.
fn typed_as(value: f64, comma: bool) -> String {
    let text = value.to_string();
    if comma { text.replace('.', ",") } else { text }
}

/// Typed values of a variant: what it asks for, and some of what it allows.
fn values(cycle: &Cycle, variant: &[(String, String)], choices: &[Choice]) -> Typed {
    let mut typed: Typed = variant.iter().cloned().collect();
    for (param, (given, part, comma)) in cycle.params.iter().zip(choices) {
        if !given || typed.contains_key(param.name.as_str()) {
            continue;
        }
        let text = match param.kind {
            Kind::Text(_) => format!("TOOL {}", (part * 99.0) as u32),
            _ => typed_as(number(param, *part), *comma),
        };
        typed.insert(param.name.into(), text);
    }
    typed
}

/// Typed values that choose a variant.
fn choosing(cycle: &Cycle, index: usize, part: f64) -> Vec<(String, String)> {
    let variant = &cycle.variants[index % cycle.variants.len()];
    let by_number = cycle.params.iter().find(|param| matches!(param.kind, Kind::Variant(_)));
    let chosen = match by_number {
        Some(param) => Some((param.name, variant.number.to_string())),
        None => return by_address(cycle, variant.number, part),
    };
    chosen.into_iter().map(|(name, value)| (name.to_string(), value)).collect()
}

/// The addresses that choose a variant; one whose value is free gets any.
fn by_address(cycle: &Cycle, variant: i64, part: f64) -> Vec<(String, String)> {
    let mut chosen = cycle.params.iter().filter_map(|param| {
        let one = param.chooses.iter().find(|one| one.variant == variant)?;
        let free = matches!(one.when, When::Plane(_));
        let value = match free {
            true => number(param, part).to_string(),
            false => one.typed.to_owned(),
        };
        Some((param.name.to_string(), value))
    });
    match cycle.params.iter().any(|param| param.chooses.len() > 1) {
        true => chosen.collect(),
        false => chosen.next().into_iter().collect(),
    }
}

fn control(dialect: Dialect, plane: usize, inch: bool) -> Control {
    let mut control = delivery(dialect);
    control.plane = [Plane::G17, Plane::G18, Plane::G19][plane % 3];
    control.active_units = if inch { Units::Inch } else { Units::Metric };
    control
}

/// What the program is preceded by, so that the reader knows the same control.
fn prologue(control: &Control) -> String {
    let plane = match control.plane {
        Plane::G17 => "G17",
        Plane::G18 => "G18",
        Plane::G19 => "G19",
    };
    let units = match (control.dialect, control.active_units) {
        (Dialect::Sinumerik, Units::Inch) => "G70",
        (Dialect::Sinumerik, Units::Metric) => "G71",
        (Dialect::Nct, Units::Inch) => "G20",
        (Dialect::Nct, Units::Metric) => "G21",
    };
    format!("{plane} {units}\n")
}

/// The one call of a text.
fn only(dialect: Dialect, text: &str) -> (Program, CallSite) {
    let program = read(dialect, text.as_bytes());
    assert!(program.errors.is_empty(), "{:?} in {text}", program.errors);
    let mut sites = calls(&program);
    assert_eq!(sites.len(), 1, "{text}");
    let site = sites.remove(0);
    (program, site)
}

fn same(written: &str, read: &str) -> bool {
    match (parse(written), parse(read)) {
        (Parsed::Number(a), Parsed::Number(b)) => a == b,
        _ => written == read,
    }
}

fn choices() -> impl Strategy<Value = Vec<Choice>> {
    proptest::collection::vec((any::<bool>(), 0.0..=1.0_f64, any::<bool>()), 40)
}

// oracle: self (writing and reading are inverse)
proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn every_variant_is_read_back_as_it_was_written(
        choices in choices(), plane in 0..3_usize, inch: bool, comments: bool
    ) {
        for cycle in CYCLES {
            for index in 0..cycle.variants.len() {
                let control = control(cycle.dialect, plane, inch);
                let typed = values(cycle, &choosing(cycle, index, choices[0].1), &choices);
                let word = |name: &str, key: &str| format!("{key} of {name}; (12,5) \"x\" %");
                let words: Option<Words> = comments.then_some(&word);
                let snippet = snippet(cycle, &typed, &control, Style::Direct, words).text;
                let text = prologue(&control) + &snippet;
                let (_, site) = only(cycle.dialect, &text);
                prop_assert_eq!(site.cycle.name, cycle.name);
                let mut none = Vec::new();
                let inputs = check::read(cycle, &typed, &control, &mut none);
                for param in cycle.params {
                    let given = typed.get(param.name.as_str()).filter(|text| {
                        let of_log = cycle.purpose.probe == ProbeUse::Log;
                        let set = !of_log && param.is_machine_datum() && parse(text) != Parsed::Number(0.0);
                        set || param.need(&inputs).is_some()
                    });
                    let read = site.values.get(param.name.as_str());
                    let back = match (given, read) {
                        (Some(given), Some(read)) => same(given, read),
                        (None, None) => true,
                        _ => false,
                    };
                    prop_assert!(back, "{} {:?} {:?} in {}", param.name, given, read, text);
                }
                let again = check::read(cycle, &site.values, &control, &mut none);
                prop_assert_eq!(again.variant, inputs.variant, "{}", text);
            }
        }
    }

    /// A call in the middle of a program of other words, numbers, comments, blanks and line ends of either sort.
    #[test]
    fn a_change_touches_the_place_of_its_value_only(
        choices in choices(), variant in 0..24_usize,
        noise in proptest::collection::vec((0..7_usize, 0..5_usize, any::<bool>(), any::<bool>()), 40),
        target in any::<prop::sample::Index>(), value in -9_999_999..9_999_999_i32,
    ) {
        for cycle in CYCLES.iter().filter(|cycle| cycle.dialect == Dialect::Sinumerik) {
            let typed = values(cycle, &choosing(cycle, variant, 0.5), &choices);
            let mut text = String::from("%_N_TEST_MPF\r\n; _SETVAL=99 is no assignment\n");
            for (line, ((name, value), (before, behind, number, crlf))) in typed.iter().zip(&noise).enumerate() {
                if *number {
                    text += &format!("N{} ", 10 * line + 10);
                }
                text += ["", " ", "\t ", "G0 X1 ", "R1=2 ", "/", "MSG(\"_FA=7\") "][*before];
                let param = cycle.param(name).unwrap();
                let quoted = matches!(param.kind, Kind::Text(_));
                let value = if quoted { format!("\"{value}\"") } else { value.replace(',', ".") };
                let equals = if *behind == 1 { " = " } else { "=" };
                text += &format!("{name}{equals}{value}");
                text += ["", "  ", " ;set 12,5 ü測", " Y5", "\t"][*behind];
                text += if *crlf { "\r\n" } else { "\n" };
            }
            text += cycle.name;
            text += " ;go\r\nM30";
            let (program, site) = only(Dialect::Sinumerik, &text);
            let names: Vec<_> = site.places.keys().copied().collect();
            if names.is_empty() {
                continue; // CYCLE101 takes no values
            }
            let name = names[target.index(names.len())];
            let place = site.places[name.as_str()];
            let new = format!("{}", f64::from(value) / 1000.0);
            let edits = change(&program, &site, name.as_str(), &new);
            let changed = String::from_utf8(apply(&program.source, &edits)).unwrap();
            let (start, end) = (place.start as usize, place.end as usize);
            let kept = same(&new, &site.values[name.as_str()]);
            let expected = format!("{}{new}{}", &text[..start], &text[end..]);
            prop_assert!(changed == expected || (kept && changed == text), "{} {}", name, changed);
            let (_, again) = only(Dialect::Sinumerik, &changed);
            prop_assert!(same(&new, &again.values[name.as_str()]), "{} {}", name, changed);
            for other in names.iter().filter(|other| **other != name) {
                prop_assert_eq!(&again.values[other.as_str()], &site.values[other.as_str()]);
            }
        }
    }
}
