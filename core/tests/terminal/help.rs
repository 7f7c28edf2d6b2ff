//! Help pages and wrong arguments in every language.

use super::{err, out, probewright};
use probewright_core::words::LANGUAGES;

const COMMANDS: [&str; 13] = [
    "cycles", "explain", "alarms", "check", "write", "read", "run", "test", "jog", "machine", "braking", "older",
    "definitions",
];

/// English of the parser of the command line, which no other language shows.
const ITS_OWN: [&str; 7] = ["Usage", "Options", "Arguments", "Commands", "Print", "possible", "OPTIONS"];

// oracle: hand: a message that is missing shows its key
#[test]
fn every_help_page_speaks_its_language() {
    for language in LANGUAGES.iter().map(|language| language.code) {
        let whole = [vec!["--help"], vec!["-h"], vec![]];
        let each = COMMANDS.iter().flat_map(|one| [vec![*one, "--help"], vec!["help", *one]]);
        for arguments in whole.into_iter().chain(each) {
            let apart = format!("--lang={language}");
            let output = probewright(&[&[apart.as_str()], &arguments[..]].concat());
            let page = out(&output) + &err(&output);
            assert!(!page.contains("terminal-"), "{arguments:?}: {page}");
            assert!(language == "en" || !ITS_OWN.iter().any(|word| page.contains(word)), "{arguments:?}: {page}");
        }
    }
}

// oracle: hand
#[test]
fn wrong_arguments_are_told_in_the_language_asked() {
    for (arguments, told) in [
        (&["--lang", "de", "chek"][..], "Fehler: Es gibt keinen Befehl chek\nÄhnlich: check\n"),
        (&["chek", "--lang", "de"], "Fehler: Es gibt keinen Befehl chek\nÄhnlich: check\n"),
        (&["--lang", "de"], "Fehler: Ein Befehl fehlt\n"),
        (&["--lang", "zh", "check", "--all"], "错误: 没有参数 --all\n"),
        (
            &["--lang", "de", "check"],
            "Fehler: Es fehlt: <DATEIEN>...\nAufruf: probewright check [OPTIONEN] <DATEIEN>...\n",
        ),
        (&["--lang", "de", "run", "a", "--setup"], "Fehler: Ein Wert fehlt: --setup <DATEI>\n"),
        (&["explain", "CYCLE977", "x"], "error: “x” is not a number: [VARIANT]\n"),
        (
            &["--lang", "zh", "write", "CYCLE977", "--style", "x"],
            "错误: --style <书写方式> 不允许“x”；允许：direct, indirect, operate\n",
        ),
        (
            &["run", "a", "--setup", "b", "--control", "nct"],
            "error: --setup <SETUP> and --control <CONTROL> exclude each other\n",
        ),
    ] {
        let output = probewright(arguments);
        assert_eq!((output.status.code(), out(&output)), (Some(2), String::new()), "{arguments:?}");
        assert!(err(&output).starts_with(told) && err(&output).ends_with("--help\n"), "{}", err(&output));
    }
}
