#![allow(clippy::unwrap_used)]
use super::*;
use crate::diagnostic::{Code, Diagnostic};
use crate::entry::{ProbeUse, names};
use crate::program::change::apply;
use crate::program::findings;
use crate::syntax::read;
use proptest::prelude::*;

fn program(text: &str) -> Program {
    read(Dialect::Sinumerik, text.as_bytes())
}

/// The text after the cure of the only finding with this key.
fn cured(text: &str, key: &str) -> Option<String> {
    let program = program(text);
    let found: Vec<Diagnostic> = findings(&program).into_iter().filter(|one| one.message.key == key).collect();
    assert_eq!(found.len(), 1, "{key} of {text}");
    let cure = found.into_iter().next()?.cure?;
    Some(String::from_utf8(apply(&program.source, &cure.edits)).unwrap())
}

/// Keys of errors and warnings of the calls.
fn faults(text: &str) -> Vec<String> {
    let found = findings(&program(text)).into_iter();
    let found = found.filter(|one| one.severity != crate::diagnostic::Severity::Note);
    found.map(|one| one.message.key.to_string()).filter(|key| !key.starts_with("advice-")).collect()
}

/// Calls of published programs and generators, with the numbers of their arguments at which something stands.
const PUBLISHED: &[&str] = &[
    "CYCLE977(1101,10001,,1,32,,,7,5,11,16,5,,,1,\"\",,0,1.01,1.01,-1.01,0.34,1,0,,1,11,-3,15)",
    "CYCLE977(101,9000,,1,32,,,10,5,0,1,1,,,1,\"\",,0,0.2,0.1,-0.1,0.34,1,0,,1,1)",
    "CYCLE977(103,9000,,1,32,,,10,5,0,1,1,,2,1,\"\",,0,1.01,1.01,-1.01,0.34,1,0,,1,1)",
    "CYCLE977(104,9000,,1,32,,,10,5,0,8,1,,1,1,\"\",,0,1.01,1.01,-1.01,0.34,1,0,,1,1)",
    "CYCLE978(0,,,1,-55,15,5,1,2,1,\"\",,0,1.01,1.01,-1.01,,,,,1,1)",
    "CYCLE978(100,9000,,1,0,10,5,3,2,1,\"\",,0,1.01,1.01,-1.01,0.34,1,0,,1,1)",
    "CYCLE977(101,10001,,1,60,,,2,1,0,-8,,,,1,\"PROBE\",,0,1.01,1.01,-1.01,0.34,1,0,,1,1)",
    "CYCLE998(100105,9000,6,1,1,0,,10,5,102,2,20,,,,,1,0,1,)",
    "CYCLE998(100105,9000,6,1,1,0,,10,5,201,1,20,,,,,1,0,1,)",
];

// oracle: peer (jakvok/Siemens_probing, mikejg/CamHelper: argument by argument with the published lists)
#[test]
fn arguments_of_published_calls_have_their_names() {
    let named = |call: &str| -> Vec<(String, String)> {
        let program = program(call);
        let call = &list_calls(&program)[0];
        let said = call.arguments.iter().filter(|one| !one.text.is_empty());
        said.map(|one| (one.argument.name.to_owned(), one.text.clone())).collect()
    };
    let wanted = |pairs: &[(&str, &str)]| -> Vec<(String, String)> {
        pairs.iter().map(|(name, text)| ((*name).to_owned(), (*text).to_owned())).collect()
    };
    assert_eq!(
        named(PUBLISHED[0]),
        wanted(&[
            ("S_MVAR", "1101"),
            ("S_KNUM", "10001"),
            ("S_PRNUM", "1"),
            ("S_SETV", "32"),
            ("S_FA", "7"),
            ("S_TSA", "5"),
            ("S_STA1", "11"),
            ("S_ID", "16"),
            ("S_SZA", "5"),
            ("S_NMSP", "1"),
            ("S_TNAME", "\"\""),
            ("S_TZL", "0"),
            ("S_TDIF", "1.01"),
            ("S_TUL", "1.01"),
            ("S_TLL", "-1.01"),
            ("S_TMV", "0.34"),
            ("S_K", "1"),
            ("S_EVNUM", "0"),
            ("_DMODE", "1"),
            ("_AMODE", "11"),
            ("S_XM", "-3"),
            ("S_YM", "15"),
        ])
    );
    assert_eq!(
        named(PUBLISHED[4])[..8],
        wanted(&[
            ("S_MVAR", "0"),
            ("S_PRNUM", "1"),
            ("S_SETV", "-55"),
            ("S_FA", "15"),
            ("S_TSA", "5"),
            ("S_MA", "1"),
            ("S_MD", "2"),
            ("S_NMSP", "1"),
        ])
    );
    assert_eq!(
        named(PUBLISHED[7]),
        wanted(&[
            ("S_MVAR", "100105"),
            ("S_KNUM", "9000"),
            ("S_RA", "6"),
            ("S_PRNUM", "1"),
            ("S_SETV", "1"),
            ("S_STA1", "0"),
            ("S_FA", "10"),
            ("S_TSA", "5"),
            ("S_MA", "102"),
            ("S_MD", "2"),
            ("S_ID", "20"),
            ("S_NMSP", "1"),
            ("S_EVNUM", "0"),
            ("_DMODE", "1"),
        ])
    );
}

// oracle: peer (they run on machines as they stand)
#[test]
fn published_calls_have_no_fault() {
    for call in PUBLISHED {
        assert_eq!(faults(&format!("{call}\nM30\n")), Vec::<String>::new(), "{call}");
    }
}

// oracle: peer (the same call written out); self: a macro of several arguments is not cut in two
#[test]
fn a_call_in_a_macro_is_the_call_written_out() {
    let lost = "CYCLE977(101,1,1,132,,,2,1)";
    assert_eq!(faults(lost), ["newer-lost"]);
    let defined =
        |name: &str, text: &str, rest: &str| format!("%_N_UMAC_DEF\nDEFINE {name} AS {text}\n%_N_A_MPF\n{rest}\n");
    for (text, rest) in [(lost, "QQ"), ("132", "CYCLE977(101,1,1,QQ,,,2,1)"), ("1,1,132", "CYCLE977(101,QQ,,,2,1)")] {
        let named = defined("QQ", text, rest);
        assert_eq!(faults(&named), ["newer-lost"], "{named}");
        let parts = text.contains(',');
        assert_eq!(findings(&program(&named)).iter().any(|one| one.cure.is_some()), !parts, "{named}");
    }
    let call = list_calls(&program(&defined("QQ", "1,132", "CYCLE977(101,,QQ,,,2,1)")))[0].arguments.len();
    assert_eq!(call, 8);
}

// oracle: peer (posts in which an argument is missing, in which the path is multiplied by 25.4, in which 1003 corrects
// a zero offset); hand: what the call has to be
#[test]
fn published_faults_have_a_cure() {
    let right = "CYCLE977(101,1,,1,132,,,2,1,,,,,,1,\"\",,0,1.01,1.01,-1.01,0.34,1,0,,1,1)\n";
    let lost = right.replacen("1,,1,132", "1,1,132", 1);
    assert_eq!(cured(&lost, "newer-lost").as_deref(), Some(right));
    assert_eq!(faults(&lost), ["newer-lost"], "what follows from it is not told beside it");
    let many = right.replacen("1,,1,132", "1,,,1,132", 1);
    assert_eq!(cured(&many, "newer-many").as_deref(), Some(right));
    let name = right.replacen(",1,\"\",", ",\"\",", 1);
    assert_eq!(faults(&name), ["newer-lost-between"]);
    let open = right.replacen(")\n", " ; hole\n", 1);
    assert_eq!(cured(&open, "syntax-bracket").as_deref(), Some(&*right.replacen(")\n", ") ; hole\n", 1)));
    let inch = right.replacen("132,,,2,", "132,,,50.8,", 1);
    assert_eq!(cured(&inch, "newer-inch").as_deref(), Some(right));
    assert!(faults(&format!("G700\n{inch}")).iter().all(|key| key != "newer-inch"), "a program in inches");
    let zone = "CYCLE977(1003,10001,,1,60,,,2,1,0,-8,40,,2,1,\"\",,0,1.01,1.01,-1.01,0.34,1,0,,1,1)\n";
    assert_eq!(cured(zone, "newer-target").as_deref(), Some(&*zone.replacen("1003", "1103", 1)));
    let tool = "CYCLE978(0,2001,,1,100,2,1,1,2,1,\"DRILL\")\n";
    assert_eq!(cured(tool, "newer-target").as_deref(), Some(&*tool.replacen("2001", "", 1)));
}

// oracle: hand (an expression is the user's; a number that cannot be, or none, has the path as delivered for its cure)
#[test]
fn no_cure_puts_a_path_in_the_place_of_an_expression() {
    let alarm = |path: &str| {
        let text = format!("R24=-61\nCYCLE977(101,1,,1,50,,,{path},5)\n");
        let program = read(Dialect::Sinumerik, text.as_bytes());
        let mut found = findings(&program).into_iter().filter(|one| one.code == Code::Alarm(61308));
        found.next().map(|one| one.cure.is_some())
    };
    assert_eq!(["(1+R24)", "R24", "-60", ""].map(alarm), [Some(false), Some(false), Some(true), Some(true)]);
}

// oracle: hand (a tool target in S_KNUM1 is no argument too many; two ways to mend it are none)
#[test]
fn a_call_is_not_moved_on_suspicion() {
    for call in [
        "CYCLE977(201,,1,1,32,,,7,5,,,,,,1,\"\",,0,1.01,1.01,-1.01,0.34,1,0,,1,1)\n",
        "CYCLE977(101,1,R5,1,R6,,,R7,5)\n",
        "CYCLE979(101,1,,1,R6,7)\n",
        "CYCLE150(1,,1001)\n",
        "CYCLE996(3,1,1,25,,,,,,,,,5,3,1,,1,1)\n",
    ] {
        let found = findings(&program(call));
        assert!(found.iter().all(|one| one.code != crate::own::NEWER_LOST.code()), "{call}");
        // nor is a cycle that only newer controls have a program of the user that is missing
        assert!(found.iter().all(|one| one.message.key != "run-subprogram"), "{call}");
    }
}

/// Keys of everything said about the calls.
fn said(text: &str) -> Vec<String> {
    findings(&program(text)).into_iter().map(|one| one.message.key.to_string()).collect()
}

// oracle: peer (published calls): a text where a number belongs, and a number of a probe that none has, prove that an
// argument is missing; what no program has only suggests it. The places that are named have the true one among them.
#[test]
fn a_lost_argument_is_told_by_what_proves_it() {
    for (call, proven) in [
        ("CYCLE977(101,1,,1,50,,,10,5,0,1,1,,,1,\"\",,0,0.2,0.1,-0.1,0.34,1,0,,1,1)", 14),
        ("CYCLE978(100,1,,1,50,10,5,1,2,1,\"\",,0,1.01,1.01,-1.01,0.34,1,0,,1,1)", 9),
        ("CYCLE998(105,1,6,1,1,0,,10,5,102,1,20,,,,,1,0,1,)", 0),
    ] {
        let (head, rest) = call.split_once('(').unwrap();
        let arguments: Vec<&str> = rest.trim_end_matches(')').split(',').collect();
        let of_shift = |text: &str| -> Vec<Diagnostic> {
            let found = findings(&program(text)).into_iter();
            found
                .filter(|one| one.message.key.starts_with("newer-lost") || one.message.key.starts_with("newer-many"))
                .collect()
        };
        assert_eq!(of_shift(&format!("{call}\n")), [], "{call}");
        for at in 1..arguments.len() {
            let mut short = arguments.clone();
            short.remove(at);
            let text = format!("{head}({})\n", short.join(","));
            let found = of_shift(&text);
            let errors = found.iter().filter(|one| one.severity == crate::diagnostic::Severity::Error).count();
            assert_eq!(errors, usize::from(at <= proven), "{text}");
            let number = |one: &Diagnostic, name: &str| {
                one.message.args.iter().find_map(|(known, arg)| match arg {
                    crate::message::Arg::Number(number) if *known == name => Some(*number),
                    _ => None,
                })
            };
            for one in found.iter().filter(|one| one.message.key.starts_with("newer-lost")) {
                let (from, until) = (number(one, "place").unwrap(), number(one, "until").unwrap());
                let Some(cure) = &one.cure else {
                    assert!((from..=until).contains(&(at as f64 + 1.0)), "{text}: {from} to {until}");
                    continue;
                };
                let mut right = short.clone();
                right.insert(at, "");
                let after = String::from_utf8(apply(text.as_bytes(), &cure.edits)).unwrap();
                assert_eq!(after, format!("{head}({})\n", right.join(",")), "each stands where it stood");
            }
        }
        // one value that no program has is a wrong value
        for (at, value) in [(arguments.len() - 2, "7"), (3, "50")] {
            let mut wrong = arguments.clone();
            wrong[at] = value;
            let text = format!("{head}({})\n", wrong.join(","));
            assert!(said(&text).iter().all(|key| !key.starts_with("newer-lost")), "{text}");
        }
    }
}

// oracle: peer (remedies of 61308, 61313 and 61416: a path above 0, workpiece probes 1 to 12, tool probes 1 to 6)
#[test]
fn probe_and_path_are_checked_in_every_list() {
    for list in &LISTS {
        let Some(probe) = list.position(names::PRNUM) else { continue };
        let cycle = crate::catalogue::find(Dialect::Sinumerik, list.name);
        let tool = cycle.is_some_and(|cycle| cycle.purpose.probe == ProbeUse::Tool);
        let (most, alarm) = if tool { (6, 61416) } else { (12, 61313) };
        let told = |number: i32, path: &str| {
            let mut arguments = vec![String::new(); list.args.len()];
            arguments[0] = "1".to_owned();
            arguments[probe] = number.to_string();
            let at = list.position(names::FA).unwrap();
            arguments[at] = path.to_owned();
            let text = format!("G17 G54\n{}({})\nM30\n", list.name, arguments.join(","));
            let found = findings(&program(&text));
            let has = |alarm| found.iter().any(|one| one.code == crate::diagnostic::Code::Alarm(alarm));
            let moved = found
                .iter()
                .any(|one| one.message.key.starts_with("newer-lost") || one.message.key.starts_with("newer-many"));
            [has(alarm), has(61308), moved]
        };
        assert_eq!(told(most, "10"), [false; 3], "{}", list.name);
        let [number, path, moved] = told(most + 1, "10");
        assert!((number || moved) && !path, "{}", list.name);
        // tool cycles of the older control have a signed path
        let signed = cycle.and_then(|cycle| cycle.param("_FA")).is_some_and(|param| param.range.contains(-4.0));
        for (path, wrong) in [("0", true), ("-4", !signed)] {
            let [number, path, moved] = told(1, path);
            assert!((path == wrong || moved) && !number, "{}", list.name);
        }
    }
}

// oracle: hand: a cycle that only newer controls have leaves plane, tool and compensation as they are
#[test]
fn a_cycle_of_newer_controls_leaves_the_state_alone() {
    for list in LISTS.iter().filter(|list| crate::catalogue::newer::title(list).is_some()) {
        let call = "CYCLE977(101,1,,1,50,,,10,5,0,16,20,,,1,\"\",,0,1.01,1.01,-1.01,0.34,1,0,,1,1)";
        let text = format!("G17 G40 G54 T9 D1\n{}(1)\n{call}\nM30\n", list.name);
        assert!(!said(&text).contains(&"advice-open".to_owned()), "{text}");
    }
}

/// Errors of the calls in a text.
fn errors(text: &str) -> Vec<String> {
    let found = findings(&program(text)).into_iter();
    let found = found.filter(|one| one.severity == crate::diagnostic::Severity::Error);
    found.map(|one| one.message.key.to_string()).collect()
}

// oracle: peer (each set of values is of a program that runs; the published lists have 30, 23 and 20 arguments, and
// programs any tail): no length of a call is an error
#[test]
fn no_published_length_of_a_published_call_is_an_error() {
    for row in crate::test_data::rows(crate::test_data::data!("newer_calls.tsv")) {
        let list = LISTS.iter().find(|list| list.name == row[0]).unwrap();
        let arguments: Vec<&str> = row[1].split(',').collect();
        let shortest = Argument::all(list).position(|one| one.name == "_DMODE").unwrap();
        for length in shortest..=list.args.len() + 2 {
            for tail in ["", "0", "1"] {
                let mut all = arguments.clone();
                all.resize(length, "");
                if length > arguments.len() {
                    all[length - 1] = tail;
                }
                let text = format!("{}({})\nM30\n", row[0], all.join(","));
                assert_eq!(errors(&text), [""; 0], "{text}");
            }
        }
    }
}

// oracle: peer (61308: S_FA is above 0; an omitted argument is 0); the cure gives a path
#[test]
fn an_omitted_argument_is_0() {
    assert_eq!(errors("CYCLE977(101,2,,1,132)\n"), ["check-range"]);
    assert_eq!(errors("CYCLE977(101,2,,1,132,,,0,5)\n"), ["check-range"]);
    let found = findings(&program("CYCLE977(101,2,,1,132)\n"));
    let path = found.iter().find(|one| one.code == crate::diagnostic::Code::Alarm(61308)).unwrap();
    assert_eq!(path.message.word("param"), Some("S_FA"));
    let cured = apply(b"CYCLE977(101,2,,1,132)\n", &path.cure.as_ref().unwrap().edits);
    assert_eq!(String::from_utf8(cured).unwrap(), "CYCLE977(101,2,,1,132,,,2)\n");
    // a surface may lie at 0
    assert_eq!(errors("CYCLE978(100,1,,1,,10,5,1,2,1,\"\",,0,1.01,1.01,-1.01,0.34,1,0,,1,1)\n"), [""; 0]);
}

// oracle: peer (numbers of zero offsets in programs; the digits of a tool are not published)
#[test]
fn a_number_that_no_zero_offset_has_is_told_with_a_cure() {
    let call = "CYCLE977(101,2001,,1,50,,,10,5,0,1,1,,,1,\"\",,0,0.2,0.1,-0.1,0.34,1,0,,1,1)\n";
    assert_eq!(faults(call), [""; 0]);
    assert_eq!(cured(call, "newer-target-perhaps").as_deref(), Some(&*call.replacen("2001", "", 1)));
}

// oracle: peer (S_MD is 1 or 2; the published list of CYCLE977 has 30 arguments); a reader takes any tail
#[test]
fn a_direction_and_arguments_that_are_not_published_are_noted() {
    let noted = |text: &str| -> Vec<String> {
        let found = findings(&program(text)).into_iter().filter(|one| one.code == crate::own::NEWER_OPEN.code());
        found.map(|one| format!("{} {}", one.message.key, text_at(text, one.span.unwrap()))).collect()
    };
    let edge = "CYCLE978(100,1,,1,0,10,5,1,3,1,\"\",,0,1.01,1.01,-1.01,0.34,1,0,,1,1)\n";
    assert_eq!(noted(edge), ["newer-open 3"]);
    for right in ["1", "2", "", "R5"] {
        assert_eq!(noted(&edge.replacen(",1,3,1", &format!(",1,{right},1"), 1)), [""; 0], "{right}");
    }
    let hole = "CYCLE977(101,1,,1,60,,,2,1,,,,,,1,\"\",,0,1.01,1.01,-1.01,0.34,1,0,,1,1,,,";
    assert_eq!(noted(&format!("{hole},,7)\n")), ["newer-beyond 7"]);
    assert_eq!(noted(&format!("{hole},,,)\n")), [""; 0]);
}

fn text_at(text: &str, span: Span) -> &str {
    &text[span.start as usize..span.end as usize]
}

// oracle: hand
#[test]
fn one_argument_stays_one() {
    for (text, one) in [
        ("5", true),
        ("", true),
        ("MAX(R1,2)", true),
        ("\"A,B\"", true),
        ("5,6", false),
        ("5)", false),
        ("5;", false),
        ("\"A", false),
        ("1\n2", false),
        ("R[1", false),
    ] {
        assert_eq!(is_one_argument(text), one, "{text:?}");
    }
}

/// An argument as programs write it.
fn written() -> impl Strategy<Value = String> {
    prop_oneof![
        3 => Just(String::new()),
        3 => (-9999..99_999_i32).prop_map(|number| (f64::from(number) / 100.0).to_string()),
        1 => (0..99_u32).prop_map(|number| format!("R{number}")),
        1 => Just("$P_TOOLR+1".to_owned()),
        1 => Just("MAX(R1,R2)".to_owned()),
        1 => Just("\"PROBE,3\"".to_owned()),
        1 => Just(" 12 ".to_owned()),
    ]
}

// oracle: self (each argument is read where it stands; a change touches its own place only)
proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn no_optional_tail_is_an_error(
        which in 0..9_usize,
        tail in proptest::collection::vec(prop_oneof![2 => Just(0), 3 => -2..40_i32, 1 => 1000..9999_i32], 0..8),
    ) {
        let rows = crate::test_data::rows(crate::test_data::data!("newer_calls.tsv"));
        let row = &rows[which];
        let list = LISTS.iter().find(|list| list.name == row[0]).unwrap();
        let from = Argument::all(list).position(|one| one.name == "S_EVNUM").unwrap();
        let mut arguments: Vec<String> = row[1].split(',').take(from).map(str::to_owned).collect();
        arguments.extend(tail.iter().map(|number| if *number == 0 { String::new() } else { number.to_string() }));
        let text = format!("{}({})\nM30\n", row[0], arguments.join(","));
        prop_assert_eq!(errors(&text), [""; 0], "{}", text);
    }

    #[test]
    fn lists_of_each_length_are_read_and_changed_in_place(
        which in 0..LISTS.len(),
        texts in proptest::collection::vec(written(), 1..34),
        at in any::<prop::sample::Index>(),
        now in written(),
    ) {
        let list = &LISTS[which];
        let head = format!("N10 G54 ; Ø\r\n  {}(", list.name);
        let text = format!("{head}{}) ; end\r\nM30\r\n", texts.join(","));
        let program = program(&text);
        prop_assert_eq!(&*program.source, text.as_bytes());
        let calls = list_calls(&program);
        let blank = texts.iter().all(|one| one.trim().is_empty());
        if blank && texts.len() == 1 {
            return Ok(()); // the bare name
        }
        let read: Vec<&str> = calls[0].arguments.iter().map(|one| one.text.as_str()).collect();
        let wanted: Vec<&str> = texts.iter().map(|one| one.trim()).collect();
        prop_assert_eq!(&read, &wanted, "{}", text);
        let index = at.index(texts.len() + 2);
        let edits: Vec<Edit> = set(&program, &calls[0], index, &now).into_iter().collect();
        let after = apply(&program.source, &edits);
        let after_text = String::from_utf8(after).unwrap();
        prop_assert!(after_text.starts_with(&head) && after_text.ends_with(") ; end\r\nM30\r\n"), "{}", after_text);
        let again = self::program(&after_text);
        let calls = list_calls(&again);
        // the bare brackets, where the only argument is gone
        let read = calls.first().map_or(&[][..], |call| &call.arguments);
        let mut read: Vec<String> = read.iter().map(|one| one.text.clone()).collect();
        read.resize(read.len().max(1), String::new());
        let mut wanted: Vec<String> = wanted.into_iter().map(str::to_owned).collect();
        if index < wanted.len() || !now.trim().is_empty() {
            wanted.resize(wanted.len().max(index + 1), String::new());
            wanted[index] = now.trim().to_owned();
        }
        prop_assert_eq!(read, wanted, "{}", after_text);
    }
}
