//! Values that a conversion names as added, lost or changed are those that differ between both calls, and no others.

use super::sites;
use probewright_core::catalogue::CYCLES;
use probewright_core::catalogue::example::example;
use probewright_core::control::delivery;
use probewright_core::dialect::Dialect;
use probewright_core::entry::{Cycle, Style, Typed};
use probewright_core::program::calls::CallSite;
use probewright_core::program::change::apply;
use probewright_core::program::compared::ComparedValue;
use probewright_core::program::convert::{Converted, convert, convert_all};
use probewright_core::program::write::snippet;
use probewright_core::syntax::read;
use std::collections::BTreeMap;

const STYLES: [Style; 3] = [Style::Direct, Style::Indirect, Style::Operate];

/// By the name of a parameter: before and after.
type Differing = BTreeMap<String, (Option<String>, Option<String>)>;

fn after(text: &str, done: &Converted) -> String {
    String::from_utf8(apply(text.as_bytes(), &done.edits)).unwrap()
}

fn program_of(cycle: &'static Cycle, values: &Typed, style: Style) -> String {
    snippet(cycle, values, &delivery(Dialect::Sinumerik), style, None).text
}

/// The values of a call as a program has them; what only a list has says nothing that another style could.
fn values(site: &CallSite) -> BTreeMap<String, String> {
    let own = site.values.iter().chain(&site.expressions);
    let own = own.filter(|(name, _)| site.cycle.param(name).is_some());
    own.map(|(name, value)| (name.clone(), value.clone())).collect()
}

/// What differs between two calls, worked out from their values alone.
fn differing(one: &CallSite, other: &CallSite) -> Differing {
    let (before, after) = (values(one), values(other));
    let same = |left: &str, right: &str| match (left.parse::<f64>(), right.parse::<f64>()) {
        (Ok(left), Ok(right)) => left == right,
        _ => left == right,
    };
    let mut names: Vec<&String> = before.keys().chain(after.keys()).collect();
    names.sort();
    names.dedup();
    let pairs = names.into_iter().map(|name| (name.clone(), (before.get(name).cloned(), after.get(name).cloned())));
    pairs
        .filter(|(_, pair)| match pair {
            (Some(left), Some(right)) => !same(left, right),
            _ => true,
        })
        .collect()
}

fn named(values: &[ComparedValue]) -> Differing {
    values.iter().map(|one| (one.param.clone(), (one.before.clone(), one.after.clone()))).collect()
}

// oracle: self (the calls as they are read before and afterwards), for every cycle, variant and pair of styles
#[test]
fn what_a_conversion_names_is_what_differs() {
    let mut seen = [0; 3];
    for cycle in CYCLES.iter().filter(|cycle| cycle.dialect == Dialect::Sinumerik) {
        for variant in cycle.variants {
            for (from, to) in STYLES.iter().flat_map(|from| STYLES.map(|to| (*from, to))) {
                let call = program_of(cycle, &example(cycle, variant), from);
                if from == to || call.is_empty() {
                    continue;
                }
                // an earlier call leaves data behind that the second one may rely on
                let text = format!("_VMS=77 _NMSP=2 _EVNUM=3\nCYCLE978\n{call}M30\n");
                let program = read(Dialect::Sinumerik, text.as_bytes());
                let done = convert(&program, 1, to, &delivery(Dialect::Sinumerik));
                let now = after(&text, &done);
                let expected = differing(&sites(&text)[1], &sites(&now)[1]);
                assert_eq!(named(&done.values), expected, "{text}{now}");
                assert_eq!(done.values.len(), expected.len(), "each once: {text}");
                for one in &done.values {
                    seen[usize::from(one.before.is_some())
                        + usize::from(one.after.is_some() && one.before.is_some())] += 1;
                    let line = text.lines().count() as u32 - 1;
                    assert_eq!((one.line, one.cycle), (line, cycle.name));
                }
            }
        }
    }
    assert!(seen[0] > 0 && seen[1] > 0, "some are added, some are lost: {seen:?}");
}

// oracle: hand (an argument without a parameter on the older control)
#[test]
fn arguments_of_newer_controls_are_named_as_lost() {
    let text = "CYCLE977(1,0,,1,132,,,2,1,7,,,,,1,\"T7\",,0.01,0.06,0.03,-0.03,0.02,3)\n";
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let done = convert(&program, 0, Style::Direct, &delivery(Dialect::Sinumerik));
    let lost = done.values.iter().filter(|one| one.after.is_none());
    let names: Vec<String> = lost.map(|one| format!("{} = {}", one.param, one.before.as_deref().unwrap())).collect();
    let told = done.findings.iter().find(|one| one.message.key == "convert-lost").unwrap();
    let said = format!("{:?}", told.message.args);
    assert!(names.iter().any(|name| said.contains(name)), "{names:?} {said}");
}

// oracle: self (each call by itself)
#[test]
fn all_calls_of_a_program_are_converted_as_each_by_itself() {
    for style in [Style::Indirect, Style::Operate] {
        let call = |cycle: &&'static Cycle| {
            let mut all = cycle.variants.iter().map(|variant| example(cycle, variant));
            let values = all.find(|values| !program_of(cycle, values, style).is_empty())?;
            Some(program_of(cycle, &values, Style::Direct))
        };
        let cycles = CYCLES.iter().filter(|cycle| cycle.dialect == Dialect::Sinumerik && cycle.lists.len() > 1);
        let text: String = cycles.filter_map(call).collect::<String>() + "M30\n";
        let program = read(Dialect::Sinumerik, text.as_bytes());
        let control = delivery(Dialect::Sinumerik);
        let all = convert_all(&program, style, &control);
        let now = sites(&after(&text, &all));
        let mut done = 0;
        for (index, site) in now.iter().enumerate() {
            let alone = convert(&program, index, style, &control);
            let own = &sites(&after(&text, &alone))[index];
            assert_eq!(site.list.map(|list| list.name), own.list.map(|list| list.name), "{}", site.cycle.name);
            done += alone.calls;
        }
        assert_eq!(all.calls, done);
        assert!(done > 1, "{style:?}: {done}");
        let again = read(Dialect::Sinumerik, after(&text, &all).as_bytes());
        assert_eq!(convert_all(&again, style, &control).calls, 0);
    }
}
