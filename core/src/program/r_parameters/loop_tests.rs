//! Conversions read back: each call has the values of its own R parameters.
#![allow(clippy::unwrap_used, clippy::panic)]
use super::*;
use crate::catalogue::CYCLES;
use crate::catalogue::r_parameters::{is_printed, numbers, printed};
use crate::dialect::Dialect;
use crate::entry::names;
use crate::program::change::apply;
use crate::syntax::programs::programs;
use crate::syntax::read;

/// A cycle with the number of one of its variants.
type Case = (&'static Cycle, i64);

fn cases() -> impl Iterator<Item = Case> {
    let printed = CYCLES.iter().copied().filter(|cycle| is_printed(cycle));
    printed.flat_map(|cycle| cycle.variants.iter().map(move |variant| (cycle, variant.number)))
}

fn call((cycle, _): Case) -> String {
    cycle.name.replace("CYCLE", "L")
}

/// R parameters that have several names, or share one.
const SHARED: [u16; 6] = [19, 24, 26, 31, 32, 42];

/// R parameters, each with a number that nothing else has: `R19=19.5`.
fn given(numbers: impl Iterator<Item = u16>, without: u16, decimal: u16) -> String {
    let all = numbers.filter(|number| *number != VARIANT && *number != without);
    all.map(|number| format!(" R{number}={number}.{decimal}")).collect()
}

/// Answers to all that can be open: first or last of the names.
fn answers(last: bool) -> Answers {
    let [infeed, third] = if last { [names::SZA, names::RA] } else { [names::ID, names::MD] };
    [(19, infeed), (31, third)].into()
}

/// The program with the names of today; none: it is refused.
fn converted(text: &str, answers: &Answers) -> Option<String> {
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let older = find(&program, &programs(&program), answers);
    older.is_clear().then(|| String::from_utf8(apply(text.as_bytes(), &edits(&program, &older))).unwrap())
}

/// What the parameters hold at each call of a program of today without branches.
fn held(text: &str) -> Vec<BTreeMap<String, String>> {
    let (mut now, mut calls) = (BTreeMap::new(), Vec::new());
    for word in text.split_whitespace() {
        match word.split_once('=') {
            Some((name, value)) => drop(now.insert(name.to_owned(), value.to_owned())),
            None => calls.push(now.clone()),
        }
    }
    calls
}

/// The number of the R parameter that each parameter is of which a call takes a value.
fn own((cycle, variant): Case, without: u16, answers: &Answers) -> BTreeMap<Name, u16> {
    let called = Called::of(cycle, Some(variant as f64));
    let mut own = BTreeMap::new();
    for number in numbers().filter(|number| *number != without) {
        match (&called.meant(number)[..], answers.get(&number)) {
            ([], _) => {}
            ([name], _) => drop(own.insert(*name, number)),
            (names, Some(answer)) if names.contains(answer) => drop(own.insert(*answer, number)),
            (names, _) => panic!("{} R{number} is open: {}", cycle.name, names.len()),
        }
    }
    own
}

// oracle: manual, tests/data/r_parameters.tsv (by `Called::meant`, which is held against it); self (read back)
#[test]
fn each_variant_gets_the_names_of_its_table_and_no_other() {
    let mut seen = 0;
    for case in cases() {
        for (without, last) in [(SETPOINTS[0], false), (SETPOINTS[1], true)] {
            let answers = answers(last);
            let text = format!("R23={}{}\n{}\n", case.1, given(numbers(), without, 5), call(case));
            let today = converted(&text, &answers).unwrap_or_else(|| panic!("refused: {text}"));
            let mut wanted: BTreeMap<String, String> = own(case, without, &answers)
                .into_iter()
                .map(|(name, number)| (name.to_string(), format!("{number}.5")))
                .collect();
            wanted.insert("_MVAR".into(), case.1.to_string());
            assert_eq!(held(&today), [wanted], "{text}{today}");
            seen += 1;
        }
    }
    assert!(seen > 100, "{seen}");
}

/// A case for each way in which a call takes these.
fn kinds() -> Vec<Case> {
    let kind = |(cycle, variant): Case| {
        let called = Called::of(cycle, Some(variant as f64));
        SHARED.map(|number| called.meant(number).iter().map(|name| name.as_str()).collect::<Vec<_>>())
    };
    let kinds: BTreeMap<_, Case> = cases().map(|case| (kind(case), case)).collect();
    kinds.into_values().collect()
}

/// Two calls, and the decimal that the numbers have which come to the second.
struct Pair {
    cases: [Case; 2],
    text: String,
    decimal: u16,
}

impl Pair {
    /// Whether the program is converted; if so, each call has its own values and none of the other.
    fn is_converted(&self, without: u16, answers: &Answers) -> bool {
        let Some(today) = converted(&self.text, answers) else { return false };
        let held = held(&today);
        assert_eq!(held.len(), 2, "{today}");
        for ((case, held), decimal) in self.cases.iter().zip(held).zip([5, self.decimal]) {
            let own = own(*case, without, answers);
            let shared = |name: &Name| SHARED.iter().any(|number| printed(case.0, *number).any(|one| one == *name));
            for name in Called::of(case.0, Some(case.1 as f64)).read().filter(shared) {
                let wanted = own.get(&name).map(|number| format!("{number}.{decimal}"));
                assert_eq!(held.get(name.as_str()), wanted.as_ref(), "{name}\n{}{today}", self.text);
            }
        }
        true
    }
}

// oracle: self (read back: what a call reads is what its own R parameters held, or the program is refused)
#[test]
fn of_two_calls_in_a_row_each_has_its_own_values() {
    let kinds = kinds();
    let (mut right, mut refused) = (0, 0);
    for (first, second) in kinds.iter().flat_map(|first| kinds.iter().map(move |second| (*first, *second))) {
        for (without, last) in [(SETPOINTS[0], false), (SETPOINTS[1], true)] {
            let answers = answers(last);
            let given = |decimal| given(SHARED.into_iter(), without, decimal);
            let begin = format!("R23={}{}\n{}\nR23={}", first.1, given(5), call(first), second.1);
            let pair = |text, decimal| Pair { cases: [first, second], text, decimal };
            let kept = pair(format!("{begin}\n{}\n", call(second)), 5);
            let anew = pair(format!("{begin}{}\n{}\n", given(7), call(second)), 7);
            match kept.is_converted(without, &answers) {
                true => right += 1,
                false => refused += 1,
            }
            anew.is_converted(without, &answers);
        }
    }
    assert!(kinds.len() > 10 && right > refused && refused > 10, "{right} {refused}");
}
