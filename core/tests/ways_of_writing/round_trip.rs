//! Writing and reading are inverse: values of every variant are read back, converted and changed.

use super::convert::converted;
use super::sites;
use probewright_core::catalogue::CYCLES;
use probewright_core::check;
use probewright_core::control::delivery;
use probewright_core::dialect::Dialect;
use probewright_core::entry::{Arg, Cycle, Kind, Param, Style, Typed};
use probewright_core::program::calls::{CallSite, calls};
use probewright_core::program::change::{apply, change};
use probewright_core::program::write::snippet;
use probewright_core::syntax::{Program, read};
use proptest::prelude::*;
use proptest::test_runner::TestCaseResult;

/// Random numbers for the parameters of a call: whether one is given, its value.
type Numbers = Vec<(bool, i32)>;

fn numbers() -> impl Strategy<Value = Numbers> {
    proptest::collection::vec((any::<bool>(), -99_999..99_999_i32), 40)
}

/// Values of a call of this variant, whole numbers where they are codes.
fn values(cycle: &Cycle, variant: i64, numbers: &Numbers) -> Typed {
    let mut typed = Typed::new();
    for (param, (given, number)) in cycle.params.iter().zip(numbers) {
        let text = match param.kind {
            Kind::Variant(_) => variant.to_string(),
            Kind::Real if *given => (f64::from(*number) / 1000.0).to_string(),
            Kind::Text(_) if *given => format!("T{}", number.unsigned_abs() % 100),
            Kind::Knum if *given => (number.abs() % 9999).to_string(),
            _ if *given => (number / 1000).to_string(),
            _ => continue,
        };
        typed.insert(param.name.into(), text);
    }
    typed
}

/// The parameters that the variant of these values uses.
fn used(cycle: &'static Cycle, typed: &Typed) -> impl Iterator<Item = &'static Param> {
    let inputs = check::read(cycle, typed, &delivery(cycle.dialect), &mut Vec::new());
    cycle.params.iter().filter(move |param| param.need(&inputs).is_some())
}

/// Whether this call style says the parameter.
fn says(site: &CallSite, style: Style, name: &str) -> bool {
    let named = |arg: &Arg| arg.param().is_some_and(|param| param == name);
    style != Style::Operate
        || site.cycle.variant_param().is_some_and(|own| own == name)
        || site.list.is_some_and(|list| list.args.iter().any(named))
}

/// The one call of a program.
fn only(program: &Program) -> Result<CallSite, TestCaseError> {
    prop_assert!(program.errors.is_empty(), "{:?}", program.source);
    let mut found = calls(program);
    prop_assert_eq!(found.len(), 1);
    Ok(found.remove(0))
}

/// Each value that was written is read.
fn reads_back(site: &CallSite, typed: &Typed, style: Style, text: &str) -> TestCaseResult {
    for param in used(site.cycle, typed) {
        let said = typed.get(param.name.as_str()).filter(|_| says(site, style, param.name.as_str()));
        if let Some(value) = said {
            let read = site.values.get(param.name.as_str());
            prop_assert_eq!(read, Some(value), "{} in {}", param.name, text);
        }
    }
    Ok(())
}

/// Each value stays when the call is written in another way.
fn survives(site: &CallSite, typed: &Typed, other: Style, text: &str) -> TestCaseResult {
    let (after, _) = converted(text, 0, other);
    let again = sites(&after);
    prop_assert_eq!(again.len(), 1, "{}", &after);
    for param in used(site.cycle, typed) {
        let before = site.values.get(param.name.as_str());
        if let Some(before) = before.filter(|value| !value.is_empty()) {
            let value = again[0].values.get(param.name.as_str());
            prop_assert_eq!(value, Some(before), "{} of\n{}\n{}", param.name, text, &after);
        }
    }
    Ok(())
}

/// A new value of a parameter changes nothing else.
fn changes_alone(program: &Program, site: &CallSite, name: &str, value: &str) -> TestCaseResult {
    let edits = change(program, site, name, value);
    let again = only(&read(program.dialect, &apply(&program.source, &edits)))?;
    prop_assert_eq!(again.values[name].as_str(), value, "{}", name);
    for (other, read) in site.values.iter().filter(|(other, _)| *other != name) {
        prop_assert_eq!(&again.values[other], read, "{} with {}", other, name);
    }
    Ok(())
}

/// A call of this variant with these numbers, in this call style where it has one.
fn there_and_back(
    (cycle, variant): (&'static Cycle, i64),
    style: Style,
    numbers: &Numbers,
    other: u32,
) -> TestCaseResult {
    let typed = values(cycle, variant, numbers);
    let text = snippet(cycle, &typed, &delivery(cycle.dialect), style, None).text;
    if text.is_empty() {
        prop_assert!(style != Style::Direct, "{}", cycle.name);
        return Ok(());
    }
    let program = read(cycle.dialect, text.as_bytes());
    let site = only(&program)?;
    prop_assert_eq!(site.cycle.name, cycle.name);
    reads_back(&site, &typed, style, &text)?;
    if cycle.dialect == Dialect::Sinumerik && style != Style::Operate {
        let others = [Style::Direct, Style::Indirect].into_iter();
        for other in others.filter(|other| *other != style) {
            survives(&site, &typed, other, &text)?;
        }
    }
    let reals = cycle.params.iter();
    let reals = reals.filter(|param| matches!(param.kind, Kind::Real));
    for param in reals.filter(|param| says(&site, style, param.name.as_str())) {
        changes_alone(&program, &site, param.name.as_str(), &other.to_string())?;
    }
    Ok(())
}

// oracle: self (writing and reading are inverse)
proptest! {
    #![proptest_config(ProptestConfig::with_cases(8))]

    #[test]
    fn every_variant_is_read_back_in_every_way_of_writing(numbers in numbers(), other in 1..9000_u32) {
        for cycle in CYCLES {
            for variant in cycle.variants {
                for style in [Style::Direct, Style::Indirect, Style::Operate] {
                    there_and_back((cycle, variant.number), style, &numbers, other)?;
                }
            }
        }
    }
}
