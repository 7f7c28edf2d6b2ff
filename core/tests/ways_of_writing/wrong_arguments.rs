//! Arguments that are wrong as such, in the parameterizing calls and in the lists of newer controls.

use super::convert::converted;
use super::newer::of_calls;
use probewright_core::catalogue::CYCLES;
use probewright_core::control::{Plane, delivery};
use probewright_core::diagnostic::Severity;
use probewright_core::dialect::Dialect;
use probewright_core::entry::{Style, names};
use probewright_core::machine::setup::Setup;
use probewright_core::program::convert::convert;
use probewright_core::run;
use probewright_core::run::Limits;
use probewright_core::syntax::read;

/// Keys of the errors of a run of this program on a machine with a calibrated probe.
fn errors_of_run(text: &str) -> Vec<String> {
    let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    setup.control.edge = 1;
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let outcome = run::run(&program, &setup, Limits::default());
    let errors = outcome.diagnostics.iter().filter(|one| one.severity == Severity::Error);
    errors.map(|one| one.message.key.to_string()).collect()
}

// oracle: hand (a parameter of type STRING takes a text, one of type INTEGER or REAL a number: the types of the tables
// B:11640-12133; selections have the choices printed there; a program takes no more arguments than it has parameters)
#[test]
fn check_and_run_say_the_same_of_a_wrong_argument() {
    for (call, key) in [
        ("CYCLE977(1,0,,1,132,,,2,1,,,,,,1,12)", "list-text-wanted"),
        ("CYCLE978(0,,,1,\"100\",2,1,1)", "list-number-wanted"),
        ("CYCLE979(101,1,,1,132,2,1,0,0,0,90,1,12)", "list-text-wanted"),
        ("CYCLE_978(0,100,1,20,12,2001)", "list-text-wanted"),
        ("CYCLE_978(0,\"100\",1)", "list-number-wanted"),
        ("CYCLE_974(0,40,1,20,12,,1)", "list-text-wanted"),
        ("CYCLE_978(0,100,1,20,\"D\",2001,7)", "list-arguments-many"),
        ("CYCLE_PARA(2,,,,,,,,,,,,,,7)", "list-arguments-many"),
        ("CYCLE972(0,1)", "list-arguments-many"),
        ("CYCLE_976(100,0,0,3,0,1,0,0,1,0)", "list-selection"),
        ("CYCLE_976(100)", "list-selection"),
        ("CYCLE_977_979A(976,1,100)", "list-selection"),
        ("CYCLE_CAL_PROBE(977,100)", "list-selection"),
    ] {
        let text = format!("{call}\nM30\n");
        let errors = of_calls(&text).into_iter();
        let errors: Vec<String> =
            errors.filter(|(severity, _)| *severity == Severity::Error).map(|(_, key)| key).collect();
        assert_eq!(errors, [key], "{call}");
        assert_eq!(errors_of_run(&text).first().map(String::as_str), Some(key), "{call}");
    }
    let assigned = "_MVAR=1 _SETVAL=132 _KNUM=2001 _TNAME=12\nCYCLE977\nM30\n";
    assert!(of_calls(assigned).contains(&(Severity::Error, "list-text-wanted".to_owned())));
    let unquoted = "CYCLE_978(0,100,1,20,DRILL,2001)\nM30\n";
    assert_eq!(of_calls(unquoted), [(Severity::Warning, "list-text-unquoted".to_owned())]);
    let declared = format!("DEF STRING[9] DRILL\n{unquoted}");
    assert_eq!(of_calls(&declared), []);
    let with_name = CYCLES
        .iter()
        .flat_map(|cycle| cycle.lists)
        .filter(|list| list.style != Style::Direct && list.position(names::TNAME).is_some());
    for list in with_name {
        let commas = ",".repeat(list.position(names::TNAME).unwrap());
        let text = format!("{}(977{commas}12)\nM30\n", list.name);
        let told = of_calls(&text);
        assert!(told.contains(&(Severity::Error, "list-text-wanted".to_owned())), "{text} {told:?}");
    }
}

// oracle: hand (a selection that only the run tells chooses a variant that only the run tells)
#[test]
fn a_selection_that_the_run_tells_is_no_missing_variant() {
    let text = "CYCLE_976(100,0,0,R1,0,1,0,0,1,0)\nM30\n";
    let found = of_calls(text);
    assert_eq!(found, [(Severity::Note, "check-expression".to_owned())]);
    let (same, why) = converted(text, 0, Style::Direct);
    assert_eq!((same.as_str(), why), (text, vec!["write-variant-open".to_owned()]));
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let found = convert(&program, 0, Style::Direct, &delivery(Dialect::Sinumerik)).findings;
    let hint = found[0].hint.as_ref().unwrap();
    assert_eq!((&*hint.key, hint.word("value")), ("convert-argument-hint", found[0].message.word("value")));
}

// oracle: peer (a trailing comma runs on newer controls), hand (an omitted argument says nothing)
#[test]
fn commas_at_the_end_are_no_arguments() {
    for call in ["CYCLE_978(0,100,1,,,0,)", "CYCLE_PARA(2,,,,,,,,,,,,,,,)", "CYCLE978(0,,,1,5,2,1,1,2,1,)"] {
        assert_eq!(of_calls(&format!("{call}\nM30\n")), [], "{call}");
    }
}
