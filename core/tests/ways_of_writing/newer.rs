//! Calls in the lists of newer controls: what is written, read, checked, changed and converted.

use super::convert::converted;
use super::{cycle, first_example, sites, written};
use probewright_core::catalogue::CYCLES;
use probewright_core::catalogue::example::example;
use probewright_core::check;
use probewright_core::control::delivery;
use probewright_core::diagnostic::{Code, Severity};
use probewright_core::dialect::Dialect;
use probewright_core::entry::{Arg, ArgumentList, Cycle, Style, Typed};
use probewright_core::name::Name;
use probewright_core::program::calls::calls;
use probewright_core::program::change::change;
use probewright_core::program::convert::convert;
use probewright_core::program::findings;
use probewright_core::syntax::read;
use proptest::prelude::*;
use proptest::test_runner::TestCaseResult;
use std::collections::BTreeMap;

/// The cycles that have such a list, with it.
pub fn lists() -> impl Iterator<Item = (&'static Cycle, &'static ArgumentList)> {
    CYCLES.iter().filter_map(|cycle| {
        let mut lists = cycle.lists.iter();
        Some((*cycle, lists.find(|list| list.style == Style::Operate)?))
    })
}

/// What is said of a program: severity, key of the message.
fn said(text: &str) -> Vec<(Severity, String)> {
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let found = findings(&program).into_iter();
    found.map(|one| (one.severity, one.message.key.to_string())).collect()
}

/// Whether this stands in every program that nothing was said before.
fn of_surroundings(key: &str) -> bool {
    key.starts_with("advice-")
}

/// Keys of what is said about the calls themselves.
pub fn of_calls(text: &str) -> Vec<(Severity, String)> {
    let all = said(text).into_iter();
    all.filter(|(_, key)| !of_surroundings(key)).collect()
}

fn keys(written: &probewright_core::program::write::Written) -> Vec<String> {
    let found = written.findings.iter();
    found.map(|one| one.message.key.to_string()).collect()
}

// oracle: peer (calls in published programs and generators for newer controls: jakvok/Siemens_probing for a Grob,
// mikejg/CamHelper for a Hermle; they run there)
#[test]
fn programs_that_run_on_newer_controls_are_not_refused() {
    for call in [
        "CYCLE977(1101,10001,,1,32,,,7,5,11,16,5,,,1,\"\",,0,1.01,1.01,-1.01,0.34,1,0,,1,11,-3,15)",
        "CYCLE977(101,9000,,1,32,,,10,5,0,1,1,,,1,\"\",,0,0.2,0.1,-0.1,0.34,1,0,,1,1)",
        "CYCLE977(104,10005,,1,32,,,10,5,0,8,1,,2,1,\"\",,0,0.2,0.1,-0.1,0.34,1,0,,1,1)",
        "CYCLE978(0,,,1,-55,15,5,1,2,1,\"\",,0,1.01,1.01,-1.01,,,,,1,1)",
        "CYCLE978(100,9000,,1,0,10,5,3,2,1,\"\",,0,1.01,1.01,-1.01,0.34,1,0,,1,1)",
    ] {
        assert_eq!(of_calls(&format!("{call}\nM30\n")), [], "{call}");
    }
    let turned = "CYCLE998(100105,9000,6,1,1,0,,10,5,102,2,20,,,,,1,0,1,)\nM30\n";
    let found = of_calls(turned);
    assert_eq!(found, [(Severity::Note, "newer-open".to_owned())], "{turned}");
}

// oracle: peer (the published lists: argument 1 is the variant in each of them)
#[test]
fn argument_1_of_each_list_is_the_variant() {
    for (cycle, list) in lists() {
        let text = format!("{}(7,,,1)\nM30\n", cycle.name);
        let site = &sites(&text)[0];
        assert_eq!(site.list.map(|one| one.name), Some(list.name));
        assert_eq!(site.values["_MVAR"], "7");
        assert_eq!(of_calls(&text), [(Severity::Note, "newer-open".to_owned())], "{text}");
    }
}

// oracle: peer (a generator of machine users asks for a probing angle from -359 to 359; published programs have 1 in
// _DMODE, 1 or 11 in _AMODE, 102, 103 and 201 in S_MA of CYCLE998, 1 and 2 in S_MD)
#[test]
fn a_number_that_no_program_has_is_told() {
    let hole = |angle: &str, plane: &str, mode: &str, centre: &str| {
        format!("CYCLE977(101,1,,1,50,,,2,5,{angle},,,,,1,,,,,,,,,,,{plane},{mode},{centre})\nM30\n")
    };
    let angle = |axis: &str, side: &str| format!("CYCLE998(105,1,,1,1,0,,10,5,{axis},{side},20)\nM30\n");
    let open = [(Severity::Note, "newer-open".to_owned())];
    for known in
        [hole("359", "1", "1", ","), hole("-359", "", "", ","), hole("", "0", "11", "-3,15"), angle("201", "1")]
    {
        assert_eq!(of_calls(&known), [], "{known}");
    }
    for other in [
        hole("360", "1", "1", ","),
        hole("400", "1", "1", ","),
        hole("-359.5", "1", "1", ","),
        hole("", "9", "1", ","),
        hole("", "1", "7", ","),
        angle("301", "1"),
    ] {
        assert_eq!(of_calls(&other), open, "{other}");
    }
    // a lost argument may have put the 7 at the direction there, and nothing proves it
    let lost = (Severity::Note, "newer-lost-perhaps".to_owned());
    assert_eq!(of_calls(&angle("102", "7")), [open[0].clone(), lost]);
    let (same, why) = converted(&angle("301", "1"), 0, Style::Direct);
    assert_eq!((same, why), (angle("301", "1"), vec!["convert-newer".to_owned()]));
    for (centre, mode, key) in [(",", "11", "newer-centre-missing"), ("-3,", "1", "newer-centre-unused")] {
        assert_eq!(of_calls(&hole("", "1", mode, centre)), [(Severity::Warning, key.to_owned())]);
    }
    assert_eq!(of_calls(&hole("", "1", "1", "0,0")), [], "that is the place where the probe starts");
}

// oracle: peer (newer controls name CYCLE116 and CYCLE119 among their measuring cycles, and no list of theirs is
// published); manual B:2422 (the older control takes variables)
#[test]
fn a_list_that_is_not_published_is_not_held_against_the_older_control() {
    for call in ["CYCLE116(1,2)", "CYCLE119(1)"] {
        let text = format!("{call}\nM30\n");
        assert_eq!(of_calls(&text), [(Severity::Warning, "newer-no-list".to_owned())], "{call}");
    }
    let variables = "DEF INT _ALM\n_ALM=0\nCYCLE116(_DATE,_ALM)\nM30\n";
    assert!(of_calls(variables).iter().all(|(_, key)| key != "newer-no-list"), "{variables}");
}

// oracle: peer (the published lists of CYCLE971 and CYCLE982 end with an argument without a name)
#[test]
fn an_argument_without_a_name_is_told_and_changed_by_its_place() {
    for (name, commas, place) in [("CYCLE971", 22, "23"), ("CYCLE982", 18, "19")] {
        let text = format!("{name}(1{}7)\nM30\n", ",".repeat(commas));
        let site = &sites(&text)[0];
        assert_eq!(site.values[place], "7");
        let program = read(Dialect::Sinumerik, text.as_bytes());
        let edits = change(&program, site, place, "8");
        let changed = probewright_core::program::change::apply(text.as_bytes(), &edits);
        assert_eq!(String::from_utf8(changed).unwrap(), text.replace("7)", "8)"));
    }
}

// oracle: peer (61328 on a newer control asks to check S_KNUM1, argument 3; argument 2 is the number of a zero offset)
#[test]
fn a_tool_target_is_never_written_into_argument_2() {
    for name in ["CYCLE977", "CYCLE978"] {
        let mut values = first_example(name);
        let refused = written(name, &values, Style::Operate);
        assert_eq!((refused.text.as_str(), keys(&refused)), ("", vec!["write-newer-tool".to_owned()]));
        for open in ["R5", "_DNUM"] {
            values.insert("_KNUM".into(), open.into());
            assert_eq!(written(name, &values, Style::Operate).text, "", "{name} {open}");
        }
        values.insert("_KNUM".into(), "0".into());
        let measured = written(name, &values, Style::Operate).text;
        assert!(measured.starts_with(name), "{measured}");
        let site = &sites(&measured)[0];
        let program = read(Dialect::Sinumerik, measured.as_bytes());
        assert_eq!(change(&program, site, "_KNUM", "2001"), [], "{measured}");
        assert_ne!(change(&program, site, "_KNUM", "10001"), [], "a zero offset is written, and told: {measured}");
        let direct = format!("{}{name}\n", assigned(cycle(name).example()));
        let (same, why) = converted(&direct, 0, Style::Operate);
        assert_eq!((same, why), (direct, vec!["write-newer-tool".to_owned()]));
    }
    let read_so = "CYCLE977(1,2001,,1,132,,,2,1)\n";
    assert_eq!(of_calls(read_so), [(Severity::Warning, "newer-target".to_owned())]);
    for style in [Style::Direct, Style::Indirect] {
        let (same, why) = converted(read_so, 0, style);
        assert_eq!((same.as_str(), why), (read_so, vec!["convert-newer".to_owned()]));
    }
}

fn assigned(values: impl Iterator<Item = (Name, &'static str)>) -> String {
    values.map(|(name, value)| format!("{name}={value}\n")).collect()
}

// oracle: peer (numbers of zero offsets that published programs write: 1 to 99, and 9999 for the active one)
#[test]
fn a_zero_offset_is_written_where_its_number_means_the_same() {
    let mut values = first_example("CYCLE978");
    values.insert("_MVAR".into(), "100".into());
    values.insert("S_MD".into(), "2".into());
    for (code, fits) in [("1", true), ("99", true), ("9999", true), ("1011", false), ("2000", false)] {
        values.insert("_KNUM".into(), code.into());
        let written = written("CYCLE978", &values, Style::Operate);
        let wanted: &[String] = if fits { &[] } else { &["write-newer-zero".to_owned()] };
        assert_eq!(keys(&written), wanted, "{code}");
        assert_eq!(written.text.is_empty(), !fits, "{code}");
    }
    values.insert("_MVAR".into(), "R1".into());
    values.insert("_KNUM".into(), "1".into());
    assert_eq!(keys(&written("CYCLE978", &values, Style::Operate)), ["write-variant-open"]);
    values.insert("_MVAR".into(), "1100".into());
    let differential = written("CYCLE978", &values, Style::Operate);
    assert_eq!(keys(&differential), ["write-unpublished-variant"], "no number is published for it");
}

// oracle: peer (published programs: which sign of the infeed leads down differs; 61313 on newer controls asks for a
// probe from 1 to 12)
#[test]
fn what_means_something_else_there_is_not_written() {
    let mut values = first_example("CYCLE977");
    for (name, value) in [("_MVAR", "102"), ("_KNUM", "1"), ("_ID", "-20")] {
        values.insert(name.into(), value.into());
    }
    assert_ne!(written("CYCLE977", &values, Style::Operate).text, "");
    for (name, value) in [("_ID", "20"), ("_PRNUM", "101")] {
        let mut other = values.clone();
        other.insert(name.into(), value.into());
        let refused = written("CYCLE977", &other, Style::Operate);
        assert_eq!(refused.text, "", "{name}");
        assert_eq!(keys(&refused), ["write-newer"], "{name}");
    }
}

// oracle: hand (an omitted argument is 0, whatever an earlier call left in the data; what the older control has no
// parameter for is told)
#[test]
fn a_list_is_written_otherwise_with_all_that_it_means() {
    let text = "_FA=9 _KNUM=2001 _TNUM=3\nCYCLE977(1,,,1,132,,,2,1,,,,,,1,,,0.05,1,1,-1)\n";
    let (direct, why) = converted(text, 0, Style::Direct);
    assert_eq!(why, Vec::<String>::new(), "{direct}");
    let values = &sites(&direct)[0].values;
    for (name, value) in [("_KNUM", "0"), ("_FA", "2"), ("_TZL", "0.05"), ("_TSA", "1"), ("_EVNUM", "0")] {
        assert_eq!(values[name], value, "{name} in {direct}");
    }
    let centre = "CYCLE977(101,1,,1,132,,,2,1,11,,,,,1,,,,,,,,,,,1,11,-3,15)\n";
    let (direct, why) = converted(centre, 0, Style::Direct);
    assert_eq!(why, ["convert-lost"], "{direct}");
    for foreign in [
        "CYCLE977(101,10001,,1,132,,,2,1)\n", // coarse
        "CYCLE977(101,1,2001,1,132,,,2,1)\n", // a tool target
        "CYCLE977(102,1,,1,132,,,2,1,,16)\n", // an infeed whose sign the older control reads as upwards
        "CYCLE977(101,1,,7,132,,,2,1)\n",     // a probe that the older control does not have
        "CYCLE977(201,1,,1,132,,,2,1)\n",     // a variant that is not published
        "CYCLE979(101,1,,1,132,2,1,0,0,0,90)\n",
    ] {
        let (same, why) = converted(foreign, 0, Style::Direct);
        assert_eq!((same.as_str(), why), (foreign, vec!["convert-newer".to_owned()]));
    }
}

// oracle: hand (an omitted argument is 0 there; the older control needs the infeed)
#[test]
fn an_omitted_argument_is_named_as_0() {
    for text in ["CYCLE998(105,1,,1,1,,,5)\n", "CYCLE977(1103,1,,1,132,,,2,1)\n"] {
        let program = read(Dialect::Sinumerik, text.as_bytes());
        let found = convert(&program, 0, Style::Direct, &delivery(Dialect::Sinumerik)).findings;
        let words = ["param", "value"].map(|name| found[0].message.word(name));
        assert_eq!((&*found[0].message.key, words), ("convert-newer", [Some("_ID"), Some("0")]), "{text}");
    }
}

/// Random numbers for arguments: whether one is given, its value.
pub type Numbers = Vec<(bool, u32)>;

/// Forty of them.
pub fn numbers() -> impl Strategy<Value = Numbers> {
    proptest::collection::vec((any::<bool>(), 1..999_u32), 40)
}

/// The worked values of a variant, some of them others that are valid as well, and a target.
pub fn valid(cycle: &'static Cycle, variant: i64, numbers: &Numbers) -> Typed {
    let worked = cycle.variants.iter().find(|one| one.number == variant).unwrap();
    let mut values = example(cycle, worked);
    for ((name, text), (other, number)) in values.iter_mut().zip(numbers) {
        let scaled = f64::from(*number);
        match name.as_str() {
            _ if !other => {}
            "_FA" => *text = (2.0 + scaled / 100.0).to_string(),
            "_SETVAL" | "_SETV[0]" | "_SETV[1]" if cycle.name != "CYCLE998" => {
                *text = (120.0 + scaled / 8.0).to_string();
            }
            "_TUL" => *text = (scaled / 1e4).to_string(),
            "_TLL" => *text = (-scaled / 1e4).to_string(),
            "_NMSP" => *text = (1 + number % 9).to_string(),
            "_PRNUM" => *text = (1 + number % 3).to_string(),
            _ => {}
        }
    }
    let zero = if variant / 100 % 10 == 1 { 1 + numbers[0].1 % 99 } else { 0 };
    values.insert("_KNUM".into(), zero.to_string());
    values.retain(|name, _| !["_TNUM", "_TNAME", "_TENV", "_DLNUM"].contains(&name.as_str()));
    values
}

/// Whether an argument takes the parameter of this name.
fn takes(list: &ArgumentList, name: &str) -> bool {
    list.args.iter().any(|arg| arg.param().is_some_and(|param| param == name))
}

/// What the list takes of values is read back from the text.
fn reads_back(text: &str, list: &ArgumentList, values: &Typed) -> TestCaseResult {
    let found = calls(&read(Dialect::Sinumerik, text.as_bytes()));
    prop_assert_eq!(found.len(), 1, "{}", text);
    for (name, value) in values.iter().filter(|(name, _)| takes(list, name)) {
        prop_assert_eq!(found[0].values.get(name), Some(value), "{} of {}", name, text);
    }
    Ok(())
}

/// The errors of a text are those of the part and of the probe, whichever control measures.
fn no_error_of_the_older_control(text: &str) -> TestCaseResult {
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let errors = findings(&program).into_iter().filter(|one| one.severity == Severity::Error);
    let errors: BTreeMap<_, _> = errors.map(|one| (one.message.key.to_string(), one.code)).collect();
    let same = |code: &Code| matches!(code, Code::Alarm(61308 | 61313 | 61334));
    prop_assert!(errors.values().all(same), "{} {:?}", text, errors);
    Ok(())
}

/// A list whose arguments are these values, whatever their variant means there.
pub fn as_list(list: &ArgumentList, values: &Typed) -> String {
    let argument = |arg: &Arg| match arg {
        Arg::Newer(_, Some(name)) => values.get(name.as_str()).cloned().unwrap_or_default(),
        _ => String::new(),
    };
    let all: Vec<String> = list.args.iter().map(argument).collect();
    format!("{}({})\n", list.name, all.join(","))
}

// oracle: self (writing and reading are inverse), peer (the tool target has an argument of its own)
proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    #[test]
    fn lists_are_written_checked_and_read_back(numbers in numbers(), target in 1..9999_u32) {
        let control = delivery(Dialect::Sinumerik);
        for (cycle, list) in lists() {
            for variant in cycle.variants {
                let values = valid(cycle, variant.number, &numbers);
                let there = written(cycle.name, &values, Style::Operate);
                if list.is_written() && !there.text.is_empty() {
                    no_error_of_the_older_control(&there.text)?;
                    let inputs = check::read(cycle, &values, &control, &mut Vec::new());
                    let mut used = values.clone();
                    used.retain(|name, _| cycle.param(name).is_some_and(|param| inputs.uses(param.name)));
                    reads_back(&there.text, list, &used)?;
                } else {
                    prop_assert!(keys(&there)[0].starts_with("write-unpublished"));
                }
                let text = as_list(list, &values);
                no_error_of_the_older_control(&text)?;
                reads_back(&text, list, &values)?;
                let corrects = variant.number / 100 % 10 == 0 && list.is_written();
                let mut tool = values.clone();
                tool.insert("_KNUM".into(), target.to_string());
                if corrects && cycle.param("_TNUM").is_some() {
                    tool.insert("_TNUM".into(), "20".into());
                    let refused = written(cycle.name, &tool, Style::Operate);
                    prop_assert_eq!(refused.text, "", "{} {:?}", cycle.name, tool);
                    prop_assert!(!refused.findings.is_empty());
                }
            }
        }
    }

    #[test]
    fn a_value_of_a_list_survives_in_the_other_ways(numbers in numbers()) {
        for (cycle, list) in lists().filter(|(_, list)| list.is_written()) {
            for variant in cycle.variants {
                let mut values = valid(cycle, variant.number, &numbers);
                values.insert("_ID".into(), if cycle.name == "CYCLE998" { "40" } else { "-12" }.into());
                let text = written(cycle.name, &values, Style::Operate).text;
                if text.is_empty() {
                    continue;
                }
                for style in [Style::Direct, Style::Indirect] {
                    let (other, why) = converted(&format!("_FA=99 _TSA=99\n{text}"), 0, style);
                    let told = ["write-beside", "write-zero", "convert-unused", "convert-infeed", "convert-rotary"];
                    prop_assert!(why.iter().all(|key| told.contains(&&**key)), "{:?}", why);
                    let (before, after) = (&sites(&text)[0].values, &sites(&other)[0].values);
                    let control = delivery(Dialect::Sinumerik);
                    let mean = |typed: &Typed| {
                        let inputs = check::read(cycle, typed, &control, &mut Vec::new());
                        let named = list.args.iter().filter_map(|arg| match arg {
                            Arg::Newer(_, Some(name)) if inputs.uses(*name) => Some((*name, inputs.value(*name))),
                            _ => None,
                        });
                        named.collect::<BTreeMap<_, _>>()
                    };
                    prop_assert_eq!(mean(before), mean(after), "{}{}", text, other);
                }
            }
        }
    }
}
