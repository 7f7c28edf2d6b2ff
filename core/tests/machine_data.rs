//! The forms of all cycles are held against what the machine has.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use probewright_core::catalogue::CYCLES;
use probewright_core::catalogue::example::worked;
use probewright_core::check::check;
use probewright_core::control::{Control, delivery};
use probewright_core::diagnostic::Severity;
use probewright_core::dialect::Dialect;
use probewright_core::entry::Cycle;

/// Parameter that numbers something, and the data that tell how many there are.
type Numbered = (&'static str, &'static [&'static str]);

// manual: B:13345-13348 (_CVAL), B:13717-13718 (_EVMVNUM)
const NUMBERED: [Numbered; 3] = [
    ("_PRNUM", &["_CVAL[0]", "_CVAL[1]", "_CVAL[3]"]),
    ("_EVNUM", &["_EVMVNUM[0]", "_EVMVNUM[1]"]),
    ("_CALNUM", &["_CVAL[2]"]),
];

/// How many of its variants refuse this number of the parameter.
fn refusing(cycle: &'static Cycle, param: &str, number: &str, control: &Control) -> usize {
    let refuses = |variant: i64| {
        let mut typed = worked(cycle);
        typed.insert("_MVAR".to_owned(), variant.to_string());
        typed.insert(param.to_owned(), number.to_owned());
        let found = check(cycle, &typed, control).diagnostics;
        found.iter().any(|one| one.severity == Severity::Error && one.param.is_some_and(|at| at == param))
    };
    let variants = cycle.variants.iter();
    variants.filter(|one| refuses(one.number)).count()
}

#[test]
fn what_is_numbered_is_there_on_the_machine() {
    for (param, counts) in NUMBERED {
        let mut few = delivery(Dialect::Sinumerik);
        let mut many = few.clone();
        for count in counts {
            few.set(*count, 1.0);
            many.set(*count, 2.0);
        }
        let cycles = CYCLES.iter().filter(|cycle| {
            let params = cycle.params.iter();
            cycle.dialect == Dialect::Sinumerik && params.clone().any(|one| one.name == param)
        });
        for cycle in cycles {
            let (first, second) = (refusing(cycle, param, "2", &few), refusing(cycle, param, "2", &many));
            assert!(first > second, "{} {param}: {first}, {second}", cycle.name);
        }
    }
}
