//! What a conversion does to the rest of a program: other statements read what they read before, no value goes without
//! a word, and a call that would not keep this stays as it is.

use super::newer::{Numbers, lists, numbers, valid};
use super::{sites, written};
use probewright_core::check::{Parsed, parse};
use probewright_core::control::delivery;
use probewright_core::diagnostic::{Diagnostic, Severity};
use probewright_core::dialect::Dialect;
use probewright_core::entry::{Arg, Style, Typed};
use probewright_core::program::change::apply;
use probewright_core::program::convert::convert;
use probewright_core::syntax::read;
use probewright_core::words::Words;
use proptest::prelude::*;
use proptest::test_runner::TestCaseResult;
use std::collections::BTreeMap;

const VALUES: &str = "_MVAR=101 _SETVAL=50 _KNUM=1 _PRNUM=1 _FA=10 _TSA=5 _VMS=0 _NMSP=1";
const LIST: &str = "CYCLE977(101,1,,1,50,,,10,5,,,,,,1)";

/// The program with its first call in this style, and what is said.
fn told(text: &str, style: Style) -> (String, Vec<Diagnostic>) {
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let done = convert(&program, 0, style, &delivery(Dialect::Sinumerik));
    let words = Words::english();
    for said in done.findings.iter().flat_map(|one| std::iter::once(&one.message).chain(&one.hint)) {
        assert!(!words.text(said).contains("{$"), "a word is missing: {}", words.text(said));
    }
    (String::from_utf8(apply(text.as_bytes(), &done.edits)).unwrap(), done.findings)
}

/// The text after a conversion, and each key with the names that it tells.
fn names(text: &str, style: Style) -> (String, BTreeMap<String, String>) {
    let (after, found) = told(text, style);
    let word = |one: &Diagnostic| one.message.word("names").or(one.message.word("name")).unwrap_or_default().to_owned();
    (after, found.iter().map(|one| (one.message.key.to_string(), word(one))).collect())
}

/// The program stays as it is, and says why.
fn stays(text: &str, style: Style, key: &str) {
    let (after, said) = names(text, style);
    assert_eq!((after.as_str(), said.keys().map(String::as_str).collect()), (text, vec![key]));
}

// oracle: hand (each argument that the older control does not use in this variant is named, none is cut off)
#[test]
fn every_argument_that_a_list_loses_is_named() {
    let text = "CYCLE977(101,1,,1,50,,,10,5,0,16,20,,,1,\"BOHRER\",2,0.005,0.2,0.1,-0.1,0.34,1,3,,1,1,,,,7)\nM30\n";
    for style in [Style::Direct, Style::Indirect] {
        let (after, said) = names(text, style);
        assert_ne!(after, text);
        for name in ["S_ID=16", "S_SZA=20", "S_TNAME=BOHRER", "S_DLNUM=2", "S_TUL=0.1", "S_TZL=0.005", "S_EVNUM=3"] {
            assert!(said["convert-unused"].contains(name), "{name}: {said:?}");
        }
        assert_eq!(said["convert-lost"], "31 = 7");
    }
}

// oracle: hand (a subprogram whose caller assigns everything; a call that leaves two values to what ran before it)
#[test]
fn what_no_assignment_gives_is_not_written_in_silence() {
    for text in ["PROC SUB\nCYCLE977\nM17\n", "_SETVAL=50 _KNUM=1\nCYCLE977()\nM30\n"] {
        for style in [Style::Operate, Style::Indirect] {
            stays(text, style, "convert-no-variant");
        }
    }
    let call = "_MVAR=101 _SETVAL=50 _KNUM=1 _PRNUM=1 _NMSP=1\nCYCLE977\n";
    for (text, severity) in [(format!("{call}M30\n"), Severity::Note), (format!("{call}M17\n"), Severity::Warning)] {
        let (_, found) = told(&text, Style::Operate);
        let added = found.iter().find(|one| one.message.key == "convert-added").expect("told");
        assert_eq!(added.severity, severity, "{text}");
        let names: Vec<&str> = added.message.word("names").unwrap().split(", ").collect();
        assert!(names.contains(&"_FA = 2") && names.contains(&"_TSA = 2"), "{names:?}");
        assert!(names.iter().all(|name| !name.starts_with("_SETVAL") && !name.ends_with("= 0")), "{names:?}");
    }
}

// oracle: hand (practice disagrees about the sign; which number is which axis is not published)
#[test]
fn what_is_not_sure_in_a_list_is_told_on_the_way_back() {
    let infeed = "CYCLE977(104,,,1,50,,,10,5,,-10,,,1,1,\"\",,0,1.01,1.01,-1.01,,,0,,1,1)\nM30\n";
    let rotary = "CYCLE998(105,1,4,1,1,0,,10,5,102,2,20,,,,,1,0,1,1)\nM30\n";
    for (text, key) in [(infeed, "convert-infeed"), (rotary, "convert-rotary")] {
        let (after, said) = names(text, Style::Direct);
        assert!(after == text || said.contains_key(key), "{after} {said:?}");
        assert!(said.contains_key(key) || said.contains_key("convert-newer"), "{said:?}");
    }
    assert!(names(rotary, Style::Direct).1.contains_key("convert-rotary"));
    let plain = "CYCLE977(101,1,,1,50,,,10,5,,,,,1,1)\nM30\n";
    let (_, said) = names(plain, Style::Direct);
    assert!(!said.contains_key("convert-rotary") && !said.contains_key("convert-infeed"), "{said:?}");
}

// oracle: hand (they read the assignment, which is gone if it goes with the call)
#[test]
fn an_assignment_that_another_statement_reads_stays() {
    for reader in ["R5=_SETVAL", "MSG(\"D\"<<_SETVAL)", "IF _SETVAL==50\nENDIF", "X=_SETVAL", "R5=R[_SETVAL]"] {
        for text in [format!("{VALUES}\n{reader}\nCYCLE977\nM30\n"), format!("{VALUES}\nCYCLE977\n{reader}\nM30\n")] {
            let (after, said) = names(&text, Style::Operate);
            assert!(after.starts_with("_SETVAL=50\n") && after.contains("CYCLE977(101,1,,1,50,"), "{after}");
            let line = text.lines().position(|line| line.contains("SETVAL") && line != VALUES).unwrap() + 1;
            assert_eq!(said["convert-read"], format!("_SETVAL ({line})"), "{text}");
        }
    }
    let text = "CYCLE_PARA(3)\nCYCLE_978(0,100,1,20,,0)\nX=_FA\nM30\n";
    let (after, _) = names(text, Style::Operate);
    assert!(after.starts_with("_FA=3\nCYCLE978("), "{after}");
}

// oracle: hand
#[test]
fn a_call_stays_where_something_between_may_read_or_change_its_values() {
    for between in ["L100", "CHECK(1)", "PCALL CHECK", "CALL \"CHECK\"", "EXTCALL(\"CHECK\")"] {
        stays(&format!("{VALUES}\n{between}\nCYCLE977\nM30\n"), Style::Operate, "convert-called");
    }
    let inner = format!("%_N_MAIN_MPF\n{VALUES}\nOWN\nCYCLE977\nM30\n%_N_OWN_SPF\nL100\nM17\n");
    stays(&inner, Style::Operate, "convert-called");
    let known = inner.replace("L100", "R1=1");
    assert!(names(&known, Style::Operate).0.contains("CYCLE977(101,"));
    let before = format!("L100\n{VALUES}\nCYCLE977\nL100\nM30\n");
    assert!(names(&before, Style::Operate).0.contains("L100\nCYCLE977(101,"));
}

// oracle: manual B:2460 (a block behind a slash is skipped), hand
#[test]
fn what_a_slash_skips_is_not_written_into_a_call_that_always_runs() {
    let (all, rest) = VALUES.split_once(" _SETVAL=50").unwrap();
    let text = format!("{all}{rest}\n/ _SETVAL=50\nCYCLE977\nM30\n");
    for style in [Style::Indirect, Style::Operate] {
        stays(&text, style, "convert-skip-block");
    }
    // a call that is skipped takes its assignments along
    for (slash, label) in [("/ ", ""), ("/2 ", ""), ("/ ", "A: ")] {
        let (after, _) = names(&format!("{slash}{label}{LIST}\nM30\n"), Style::Direct);
        let lines: Vec<&str> = after.lines().collect();
        assert!(lines.len() > 2 && lines[..lines.len() - 1].iter().all(|line| line.starts_with(slash)), "{after}");
    }
}

// oracle: hand
#[test]
fn a_variable_that_the_call_reads_itself_is_told() {
    let text = format!("{VALUES}\nIF R1==1\n_SETVAL=60\nELSE\n_SETVAL=70\nENDIF\nCYCLE977\nM30\n");
    let (after, said) = names(&text, Style::Operate);
    assert!(after.contains("CYCLE977(101,1,,1,_SETVAL,"), "{after}");
    assert_eq!(said["convert-variable"], "_SETVAL");
}

// oracle: hand
#[test]
fn a_variable_of_the_program_is_not_assigned_by_a_list_that_becomes_a_call() {
    for text in [format!("_FA=3\nX=_FA\n{LIST}\nM30\n"), format!("_FA=3\n{LIST}\nX=_FA\nM30\n")] {
        for style in [Style::Direct, Style::Indirect] {
            stays(&text, style, "convert-overwrites");
        }
    }
}

// oracle: hand (a plane is named by one argument, of which only the number 1 is published)
#[test]
fn a_plane_that_no_program_shows_is_told() {
    for (plane, unknown) in [("G17", false), ("G18", true), ("G19", true)] {
        let (after, said) = names(&format!("{plane}\n{VALUES}\nCYCLE977\nM30\n"), Style::Operate);
        assert!(after.contains("CYCLE977(101,"), "{after}");
        assert_eq!(said.contains_key("write-plane"), unknown, "{plane}: {said:?}");
    }
    let kept = "G18\nCYCLE977(101,1,,1,50,,,10,5,,,,,,1,,,,,,,,,,,2,1)\nM30\n";
    stays(kept, Style::Direct, "convert-newer");
}

/// What stands in the arguments of a list on one line.
fn arguments(text: &str) -> Vec<&str> {
    let inside = text.split_once('(').unwrap().1.rsplit_once(')').unwrap().0;
    inside.split(',').collect()
}

/// Whether an argument says something.
fn says(text: &str) -> bool {
    !text.is_empty() && text != "\"\"" && parse(text) != Parsed::Number(0.0)
}

/// A list with random numbers in some arguments of a call that is understood.
fn random_list(text: &str, numbers: &Numbers) -> String {
    let name = text.split('(').next().unwrap();
    let list = lists().map(|(_, list)| list).find(|list| list.name == name).unwrap();
    let mut all: Vec<String> = arguments(text).into_iter().map(str::to_owned).collect();
    all.resize(list.args.len(), String::new());
    for ((arg, text), (given, number)) in list.args.iter().zip(&mut all).zip(numbers.iter().rev()) {
        let Arg::Newer(name, _) = arg else { continue };
        let fixed = ["S_MVAR", "S_KNUM1", "S_PRNUM", "S_MD", "S_MA", "S_RA", "_DMODE", "_AMODE", "S_MCBIT", "_DP"];
        if *given && !fixed.contains(name) && !text.starts_with('"') && text.is_empty() {
            *text = if *name == "S_TNAME" { "\"BOHRER\"".to_owned() } else { number.to_string() };
        }
    }
    format!("{name}({})\n", all.join(","))
}

/// Each argument arrives at the call as it is written now, or is named.
fn all_arrive(list: &str, style: Style) -> TestCaseResult {
    let (after, found) = told(list, style);
    if after == list {
        prop_assert!(!found.is_empty(), "refused in silence: {}", list);
        return Ok(());
    }
    let site = &sites(&after)[0];
    let before = &sites(list)[0];
    let names: Vec<String> =
        found.iter().filter_map(|one| one.message.word("names")).flat_map(|all| all.split(", ")).map(plain).collect();
    for (arg, text) in before.list.unwrap().args.iter().zip(arguments(list)).filter(|(_, text)| says(text)) {
        let Arg::Newer(name, param) = arg else { continue };
        let usual = ["_DMODE", "_AMODE"].contains(name) && text == "1";
        let there = param.is_some_and(|param| site.values.get(param.as_str()).is_some_and(|now| alike(now, text)));
        let named = names.contains(&plain(&format!("{name}={}", text.trim_matches('"'))));
        prop_assert!(there || named || usual, "{} = {} of {}{}{:?}", name, text, list, after, names);
    }
    Ok(())
}

fn plain(text: &str) -> String {
    text.chars().filter(|one| !one.is_whitespace()).collect()
}

fn alike(one: &str, other: &str) -> bool {
    one.trim_matches('"') == other.trim_matches('"') || parse(one) == parse(other)
}

/// The variables of a program of assignments, statements that read, and one call; how each reads.
#[derive(Default)]
struct Followed {
    /// What each statement reads, in the order of the text.
    read: Vec<(String, Option<String>)>,
    values: BTreeMap<String, String>,
}

impl Followed {
    /// Follows a text from its beginning; a call of an older control leaves its values in the data.
    fn of(text: &str) -> Followed {
        let mut all = Followed::default();
        for line in text.lines() {
            let line = line.trim_start_matches(['/', ' ']);
            let reader = ["R5=", "MSG(", "X=", "IF "].into_iter().find(|start| line.starts_with(start));
            if reader.is_some() {
                let names = line.split(|one: char| !one.is_ascii_alphanumeric() && one != '_');
                let name = names.into_iter().find(|name| name.starts_with('_')).unwrap();
                all.read.push((line.to_owned(), all.values.get(name).cloned()));
            } else if line.starts_with("CYCLE_9") {
                let now = sites(text)[0].values.clone();
                all.values.extend(now.into_iter().filter(|(_, text)| says(text)));
            } else if line.starts_with('_') {
                let words = line.split(' ').filter_map(|word| word.split_once('='));
                all.values.extend(words.map(|(name, value)| (name.to_owned(), value.to_owned())));
            }
        }
        all
    }
}

/// A program of the older control with statements that read its values between and behind.
fn random_program(values: &Typed, cycle: &str, readers: &[(u8, usize, usize)], rare: u8) -> String {
    let lines: Vec<String> = values.iter().map(|(name, value)| format!("{name}={value}")).collect();
    let names: Vec<&str> = values.keys().map(String::as_str).filter(|name| !name.contains('[')).collect();
    let mut text: Vec<String> = lines;
    if rare == 0 {
        text[0].insert_str(0, "/ ");
    }
    text.push(cycle.to_owned());
    for (sort, name, at) in readers {
        let name = names[name % names.len()];
        let line = match sort % 4 {
            0 => format!("R5={name}"),
            1 => format!("MSG(\"a\"<<{name})"),
            2 => format!("X={name}"),
            _ => format!("IF {name}==1 R1=2"),
        };
        text.insert(at % (text.len() + 1), line);
    }
    if rare == 1 {
        let at = text.iter().position(|line| line == cycle).unwrap();
        text.insert(at, "L100".to_owned());
    }
    text.join("\n") + "\nM30\n"
}

fn reads_the_same(text: &str, style: Style, rare: u8) -> TestCaseResult {
    let (after, found) = told(text, style);
    if after == text {
        prop_assert!(!found.is_empty(), "refused in silence: {}", text);
        return Ok(());
    }
    prop_assert!(rare > 1, "{}{}", text, after);
    let (before, now) = (Followed::of(text), Followed::of(&after));
    prop_assert_eq!(before.read.len(), now.read.len());
    for ((line, was), (other, is)) in before.read.iter().zip(&now.read) {
        prop_assert_eq!(line, other);
        let same = was == is || was.as_ref().zip(is.as_ref()).is_some_and(|(was, is)| alike(was, is));
        prop_assert!(same, "{} read {:?}, reads {:?}:\n{}{}", line, was, is, text, after);
    }
    let (site, there) = (&sites(text)[0], &sites(&after)[0]);
    let told: Vec<&str> =
        found.iter().flat_map(|one| ["name", "names"].map(|key| one.message.word(key))).flatten().collect();
    for (name, value) in site.values.iter().filter(|(_, value)| says(value)) {
        if ["_DMODE", "_AMODE"].contains(&name.as_str()) {
            continue; // the same in every program
        }
        let same = there.values.get(name).is_some_and(|now| alike(now, value));
        let named = told.iter().any(|names| names.contains(name.as_str()));
        prop_assert!(same || named, "{} of\n{}{}{:?}", name, text, after, told);
    }
    Ok(())
}

// oracle: hand (the rules of the properties above)
proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]

    #[test]
    fn no_argument_of_a_list_goes_in_silence(numbers in numbers()) {
        for (cycle, _) in lists().filter(|(_, list)| list.is_written()) {
            for variant in cycle.variants {
                let text = written(cycle.name, &valid(cycle, variant.number, &numbers), Style::Operate).text;
                if !text.is_empty() {
                    let list = random_list(&text, &numbers);
                    for style in [Style::Direct, Style::Indirect] {
                        all_arrive(&text, style)?;
                        all_arrive(&list, style)?;
                    }
                }
            }
        }
    }

    #[test]
    fn other_statements_read_what_they_read(
        numbers in numbers(),
        readers in proptest::collection::vec((any::<u8>(), 0..99_usize, 0..99_usize), 0..5),
        rare in 0..8_u8,
    ) {
        for (cycle, _) in lists().filter(|(_, list)| list.is_written()) {
            for variant in cycle.variants {
                let text = random_program(&valid(cycle, variant.number, &numbers), cycle.name, &readers, rare);
                for style in [Style::Indirect, Style::Operate] {
                    reads_the_same(&text, style, rare)?;
                }
                let (list, _) = told(&text, Style::Operate);
                for style in [Style::Direct, Style::Indirect] {
                    reads_the_same(&list, style, 9)?;
                }
            }
        }
    }
}
