//! Programs and logs of other controls.
#![allow(clippy::unwrap_used, clippy::panic)]

use super::findings::of_program;
use super::*;
use crate::diagnostic::{Diagnostic, Severity};
use proptest::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

/// As a published post processor writes it (Autodesk, revision 42300), with the numbers of blocks.
const PROGRAM: &str = "0 BEGIN PGM CHECK MM\n1 TOOL CALL 30 Z\n2 TCH PROBE 421 MEASURE HOLE ~\n  \
    Q273=+50 ;CENTER IN 1ST AXIS ~\n  Q274=+65 ;CENTER IN 2ND AXIS ~\n  Q262=+12 ;NOMINAL DIAMETER ~\n  \
    Q325=+0 ;STARTING ANGLE ~\n  Q247=+90 ;STEPPING ANGLE ~\n  Q261=-5 ;MEASURING HEIGHT ~\n  \
    Q320=+0 ;SET-UP CLEARANCE ~\n  Q260=+20 ;CLEARANCE HEIGHT ~\n  Q301=+1 ;MOVE TO CLEARANCE ~\n  \
    Q275=+12.045 ;MAXIMUM DIMENSION ~\n  Q276=+12 ;MINIMUM DIMENSION ~\n  Q279=+0.1 ;TOLERANCE 1ST CENTER ~\n  \
    Q280=+0.1 ;TOLERANCE 2ND CENTER ~\n  Q281=+1 ;MEASURING LOG ~\n  Q309=+0 ;PGM-STOP IF ERROR ~\n  \
    Q330=+0 ;TOOL NUMBER\n3 L Z+100 R0 FMAX\n4 END PGM CHECK MM\n";

/// The figures of the published log of cycle 421 (TNC7, 81762x-19).
const LOG: &str = "Measuring log for touch probe cycle 421 Hole measuring\n\nDate: 30-06-2005\nTime: 6:55:04\n\
    Measuring program: TNC:\\GEH35712\\CHECK1.H\nType of dimension (0 = MM / 1 = INCH): 0\n\n\
    Nominal values:\nCenter in reference axis:            50.0000\nCenter in minor axis:                65.0000\n\
    Diameter:                            12.0000\n\nGiven limit values:\n\
    Maximum limit for center in reference axis: 50.1000\nMinimum limit for center in reference axis: 49.9000\n\
    Maximum limit for center in minor axis: 65.1000\nMinimum limit for center in minor axis: 64.9000\n\
    Maximum dimension for hole: 12.0450\nMinimum dimension for hole: 12.0000\n\nActual values:\n\
    Center in reference axis: 50.0810\nCenter in minor axis: 64.9530\nDiameter: 12.0259\n\nDeviations:\n\
    Center in reference axis: 0.0810\nCenter in minor axis: -0.0470\nDiameter: 0.0259\n";

fn keys(found: &[Diagnostic]) -> Vec<&str> {
    found.iter().map(|one| &*one.message.key).collect()
}

fn cycle(name: &str) -> &'static ForeignCycle {
    find(name).unwrap().1
}

// oracle: manual (TNC 320 9/2016, p. 396, and the text that the control writes beside each value)
#[test]
fn a_call_is_read_with_the_places_of_its_values() {
    let control = control_of(PROGRAM.as_bytes()).unwrap();
    let calls = (control.calls)(PROGRAM.as_bytes());
    let [call] = &calls[..] else { panic!("{}", calls.len()) };
    assert_eq!((call.name.as_str(), call.line), ("TCH PROBE 421", 2));
    let known = call.cycle.unwrap();
    let names: Vec<&str> = call.values.iter().map(|one| one.name.as_str()).collect();
    assert_eq!(names, known.parameters.iter().map(|one| one.name).collect::<Vec<_>>());
    let placed = |span: Span| &PROGRAM[span.start as usize..span.end as usize];
    assert_eq!(placed(call.span), "TCH PROBE 421");
    for one in &call.values {
        assert_eq!(placed(one.span), format!("{}={}", one.name, one.text));
        assert_eq!(placed(one.name_span), one.name);
        let behind = &PROGRAM[one.span.end as usize..];
        let text = behind.lines().next().unwrap().trim_matches([' ', ';', '~']);
        assert_eq!(known.parameter(&one.name).unwrap().text, text);
    }
    assert_eq!(call.values[9].number(), Some(12.045));
    let found = of_program(PROGRAM.as_bytes()).unwrap();
    assert_eq!(keys(&found), ["foreign-program", "tnc-421-title"]);
}

// oracle: hand: older programs have no `~`, and some editors write small letters, CRLF and no numbers
#[test]
fn every_way_of_writing_is_the_same_call() {
    let of = |text: &str| {
        let calls = (tnc::CONTROL.calls)(text.as_bytes()).into_iter();
        calls
            .map(|call| (call.name, call.values.into_iter().map(|one| (one.name, one.text)).collect::<Vec<_>>()))
            .collect::<Vec<_>>()
    };
    let first = of(PROGRAM);
    for other in [
        PROGRAM.replace(" ~", ""),
        PROGRAM.replace(" ~", "~"),
        PROGRAM.replace('\n', "\r\n"),
        PROGRAM.replace('\n', "\r"),
        PROGRAM.replace("TCH PROBE", "tch probe").replace("Q2", "q2"),
        PROGRAM.replace("2 TCH", "/2 TCH"),
    ] {
        assert_eq!(of(&other), first, "{other}");
    }
}

// oracle: hand: a direction is 1 or -1, an axis and a selection a whole number, everything else a number or a parameter
#[test]
fn a_value_that_says_nothing_is_told() {
    let told = |name: &str, value: &str| {
        let text = format!("0 BEGIN PGM A MM\n1 TCH PROBE 427 Q263=+1 Q264=+2 {name}={value}\n");
        let found = of_program(text.as_bytes()).unwrap();
        let of_value = ["foreign-value", "foreign-no-such", "foreign-range"];
        let words = crate::words::Words::english();
        for said in found.iter().flat_map(|one| std::iter::once(&one.message).chain(&one.hint)) {
            assert!(!words.text(said).contains("{$"), "a word is missing: {}", words.text(said));
        }
        found.into_iter().map(|one| one.message.key).filter(|key| of_value.contains(&&**key)).collect::<Vec<_>>()
    };
    for (name, value) in [("Q261", ""), ("Q261", "abc"), ("Q261", "\"T\"")] {
        assert_eq!(told(name, value), ["foreign-value"], "{name}={value}");
    }
    for (name, value) in [("Q267", "0"), ("Q267", "+0.5"), ("Q272", "1.5"), ("Q281", "0.5")] {
        assert_eq!(told(name, value), ["foreign-no-such"], "{name}={value}");
    }
    let right =
        [("Q261", "-5.25"), ("Q261", "+Q5"), ("Q261", "-QL12"), ("Q267", "-1"), ("Q272", "3"), ("Q330", "\"T\"")];
    for (name, value) in right {
        assert_eq!(told(name, value), Vec::<String>::new(), "{name}={value}");
    }
}

// oracle: self: what is written reads back, and lacks nothing
#[test]
fn what_is_written_reads_back() {
    let mut seen = 0;
    for one in tnc::CONTROL.cycles.iter().filter(|one| one.is_written()) {
        let typed: BTreeMap<String, String> = one
            .parameters
            .iter()
            .zip(1..)
            .map(|(known, at)| (known.name.to_owned(), wanted(known, at).to_string()))
            .collect();
        let text = written(&tnc::CONTROL, one, &typed).unwrap();
        let calls = (tnc::CONTROL.calls)(text.as_bytes());
        let [call] = &calls[..] else { panic!("{text}") };
        let read = call.values.iter().map(|value| (value.name.clone(), value.number().unwrap().to_string()));
        assert_eq!(read.collect::<BTreeMap<_, _>>(), typed, "{text}");
        let found = of_program(text.as_bytes()).unwrap();
        assert!(found.iter().all(|one| one.severity == Severity::Note), "{text} {:?}", keys(&found));
        seen += 1;
    }
    assert_eq!(seen, 5);
}

/// A value inside the range, a limit above its partner.
fn wanted(parameter: &Parameter, at: i32) -> f64 {
    match parameter.value {
        Value::Maximum(_) => 50.5,
        Value::Minimum(_) => 49.25,
        _ if parameter.range.max <= 3.0 => 1.0,
        _ => f64::from(at) + 0.125,
    }
}

// oracle: hand: nothing is written of a cycle whose page is not published, and no value is made up
#[test]
fn what_is_not_known_is_not_written() {
    let none = BTreeMap::new();
    let write = |name: &str, values: &BTreeMap<String, String>| written(&tnc::CONTROL, cycle(name), values);
    for (name, key, names) in [
        ("TCH PROBE 422", "foreign-unwritten-values", Some("Q277, Q278")),
        ("TCH PROBE 424", "foreign-unwritten-order", None),
        ("TCH PROBE 430", "foreign-unwritten-lacks", Some("Q281, Q309, Q330")),
        ("TCH PROBE 415", "foreign-unwritten-nothing", None),
    ] {
        let Err(Unwritten::Unpublished(why)) = write(name, &none) else { panic!("{name}") };
        assert_eq!((&*why.key, why.word("cycle"), why.word("names")), (key, Some(name), names));
        let read = format!("{name} X ~\n  Q263=+1 ;X\n");
        let found = of_program(read.as_bytes()).unwrap();
        assert!(found.iter().any(|one| one.hint.as_ref() == Some(&why)), "{name}");
        let lacks = found.iter().any(|one| one.message.key == "foreign-missing");
        assert_eq!(lacks, name != "TCH PROBE 415");
    }
    let Err(Unwritten::Missing(names)) = write("TCH PROBE 423", &none) else { panic!() };
    assert_eq!(names, ["Q273", "Q274", "Q282", "Q283", "Q261", "Q260"]);
    let with = |name: &str, value: &str| BTreeMap::from([(name.to_owned(), value.to_owned())]);
    assert_eq!(write("TCH PROBE 423", &with("Q999", "1")), Err(Unwritten::Unknown("Q999".into())));
    assert_eq!(write("TCH PROBE 423", &with("Q282", "x")), Err(Unwritten::NoNumber("Q282")));
}

// oracle: peer (the post processor writes Q288 twice in 425, so that the lower limit is lost)
#[test]
fn a_parameter_written_twice_is_told_and_cured() {
    let typed: BTreeMap<String, String> =
        cycle("TCH PROBE 425").parameters.iter().map(|one| (one.name.to_owned(), wanted(one, 1).to_string())).collect();
    let right = written(&tnc::CONTROL, cycle("TCH PROBE 425"), &typed).unwrap();
    let wrong = right.replace("Q289", "Q288");
    let found = of_program(wrong.as_bytes()).unwrap();
    assert_eq!(keys(&found), ["foreign-program", "tnc-425-title", "foreign-twice"]);
    let cure = found[2].cure.clone().unwrap();
    let mut text = wrong;
    for edit in cure.edits {
        text.replace_range(edit.span.start as usize..edit.span.end as usize, &edit.insert);
    }
    assert_eq!(text, right);
}

// oracle: hand
#[test]
fn faults_of_a_call_are_told() {
    for (from, to, key) in [
        ("  Q276=+12 ;MINIMUM DIMENSION ~\n", "", "foreign-missing"),
        ("Q276=+12 ", "Q276=+13 ", "foreign-limits"),
        ("Q301=+1", "Q301=+7", "foreign-range"),
        ("Q330=+0 ", "Q498=+0 ", "foreign-surplus"),
        ("PROBE 421", "PROBE 999", "foreign-unknown"),
    ] {
        let found = of_program(PROGRAM.replace(from, to).as_bytes()).unwrap();
        assert!(keys(&found).contains(&key), "{key} {:?}", keys(&found));
    }
    // a value that only the run knows is no fault
    let found = of_program(PROGRAM.replace("Q301=+1", "Q301=QL1").as_bytes()).unwrap();
    assert_eq!(keys(&found).len(), 2);
}

// oracle: manual (TNC 410 ISO programming, p. 283: a cycle of DIN/ISO up to its `*`; TNC 320 9/2016, p. 396: G423)
#[test]
fn a_call_in_din_iso_is_the_same_call() {
    let values: String =
        PROGRAM.lines().filter_map(|line| Some(format!(" {}", line.trim().split_once(" ;")?.0))).collect();
    let one_line =
        format!("%CHECK G71 *\nN10 T30 G17 *\nN20 G421{values} *\nN30 G00 Z+100 *\nN99999999 %CHECK G71 *\n");
    let lines = one_line.replace(" Q260", "\nQ260").replace(" *\nN30", "*\nN30");
    let [wanted] = &(tnc::CONTROL.calls)(PROGRAM.as_bytes())[..] else { panic!() };
    for text in [&one_line, &lines, &lines.replace('\n', "\r\n"), &one_line.replace("N20 G421", "g421")] {
        assert!(control_of(text.as_bytes()).is_some(), "{text}");
        let calls = (tnc::CONTROL.calls)(text.as_bytes());
        let [call] = &calls[..] else { panic!("{text}") };
        assert_eq!((call.name.as_str(), call.cycle.unwrap().name), ("G421", "TCH PROBE 421"));
        let plain =
            |call: &ForeignCall| call.values.iter().map(|one| (one.name.clone(), one.number())).collect::<Vec<_>>();
        assert_eq!(plain(call), plain(wanted), "{text}");
        for one in &call.values {
            assert_eq!(text[one.span.start as usize..one.span.end as usize], format!("{}={}", one.name, one.text));
        }
        assert_eq!(keys(&of_program(text.as_bytes()).unwrap()), ["foreign-program", "tnc-421-title"]);
    }
    assert_eq!(find("g421").unwrap().1.name, "TCH PROBE 421");
}

// oracle: manual (TNC7, 81762x-19, log of cycle 421)
#[test]
fn a_log_is_read() {
    let row = |line, label: &str, figures: [&str; 5]| {
        let [nominal, minimum, maximum, actual, deviation] = figures.map(str::to_owned);
        LogRow { line, label: label.to_owned(), nominal, maximum, minimum, actual, deviation }
    };
    let (control, found) = logs(LOG).unwrap();
    assert_eq!((control.name, found.len()), ("HEIDENHAIN TNC", 1));
    let log = &found[0];
    assert_eq!((log.cycle.as_str(), log.date.as_str(), log.time.as_str()), ("TCH PROBE 421", "30-06-2005", "6:55:04"));
    assert_eq!((log.program.as_str(), log.is_inch), ("TNC:\\GEH35712\\CHECK1.H", false));
    let wanted = [
        row(22, "Center in reference axis", ["50.0000", "49.9000", "50.1000", "50.0810", "0.0810"]),
        row(23, "Center in minor axis", ["65.0000", "64.9000", "65.1000", "64.9530", "-0.0470"]),
        row(24, "Diameter", ["12.0000", "12.0000", "12.0450", "12.0259", "0.0259"]),
    ];
    assert_eq!(log.rows, wanted);
    // a value may stand in the line below its name, and a second log behind the first
    let below = LOG.replace(": ", ":\n");
    let twice = logs(&format!("{below}{LOG}")).unwrap().1;
    let plain = |rows: &[LogRow]| rows.iter().map(|row| LogRow { line: 0, ..row.clone() }).collect::<Vec<_>>();
    assert_eq!(twice.len(), 2);
    assert_eq!(plain(&twice[0].rows), plain(&wanted));
    assert!(logs("_MVAR=1\nDiameter: 12\n").is_none());
    let old = logs(&LOG.replace('\n', "\r")).unwrap().1.remove(0);
    assert_eq!(plain(&old.rows), plain(&wanted));
}

// oracle: self (the same log with the decimal sign of another language); hand: what is no figure is told by its line
#[test]
fn a_log_with_decimal_commas_is_the_same() {
    let commas: Vec<String> = LOG
        .lines()
        .map(|line| match line.rsplit_once(": ") {
            Some((label, figure)) if figure.parse::<f64>().is_ok() => format!("{label}: {}", figure.replace('.', ",")),
            _ => line.to_owned(),
        })
        .collect();
    let of = |text: &str| logs(text).unwrap().1.remove(0);
    let values = |log: &Log| -> Vec<Option<f64>> {
        let all =
            log.rows.iter().flat_map(|row| [&row.nominal, &row.minimum, &row.maximum, &row.actual, &row.deviation]);
        all.map(|text| figure(text)).collect()
    };
    let comma = of(&commas.join("\n"));
    assert_eq!(values(&comma), values(&of(LOG)));
    assert!(comma.unread.is_empty() && values(&comma).iter().all(Option::is_some));
    let wrong = of(&LOG.replace("Diameter: 12.0259", "Diameter: 12.0.259"));
    assert_eq!(wrong.unread, [24]);
}

// oracle: self (a log is none of a program, and a program none of a log)
#[test]
fn a_log_is_told_by_its_content() {
    let found = crate::program::findings(&crate::syntax::read(crate::dialect::Dialect::Sinumerik, LOG.as_bytes()));
    assert_eq!(keys(&found), ["foreign-is-log"], "nothing else is told of it");
    assert!(log_of(LOG.as_bytes()).is_some() && log_of(format!("\u{feff}{LOG}").as_bytes()).is_some());
    for program in [PROGRAM, "G0 X0 ; Measuring log for touch probe cycle 421\nM30\n", ""] {
        assert!(log_of(program.as_bytes()).is_none(), "{program}");
    }
}

// oracle: hand (no size is within crossed limits; 0 is no limit)
#[test]
fn crossed_limits_are_not_written() {
    let (control, cycle) = find("TCH PROBE 421").unwrap();
    let write = |most: &str, least: &str| {
        let usual = ["Q273", "Q274", "Q325", "Q261", "Q260"].map(|name| (name.to_owned(), "0".to_owned()));
        let own = [("Q262", "75"), ("Q247", "90"), ("Q320", "0"), ("Q301", "1"), ("Q275", most), ("Q276", least)];
        let own = own.map(|(name, value)| (name.to_owned(), value.to_owned()));
        written(control, cycle, &usual.into_iter().chain(own).collect())
    };
    assert_eq!(write("74", "76").unwrap_err(), Unwritten::Limits("Q275", "Q276"));
    for (most, least) in [("76", "74"), ("0", "74"), ("0", "0")] {
        assert!(write(most, least).is_ok(), "{most} {least} {:?}", write(most, least));
    }
}

// oracle: self: a table names each parameter once, and every word is there
#[test]
fn the_tables_are_whole() {
    for control in CONTROLS {
        for cycle in control.cycles {
            let names: BTreeSet<&str> = cycle.parameters.iter().map(|one| one.name).collect();
            assert_eq!(names.len(), cycle.parameters.len(), "{}", cycle.name);
            assert_eq!(cycle.source.is_empty(), cycle.page == Page::Nothing, "{}", cycle.name);
        }
        let tasks: Vec<_> = control.cycles.iter().flat_map(|cycle| cycle.tasks).collect();
        let once = tasks.iter().enumerate().all(|(at, task)| !tasks[..at].contains(task));
        assert!(once, "two cycles do the same");
    }
}

// oracle: self: nothing of the controls that are run is taken for another's
#[test]
fn programs_of_the_known_controls_stay_theirs() {
    for text in [
        "N10 _MVAR=1\nCYCLE977\nM30\n", "%O1234\nG110 D50\nM30\n", "", "; TCH PROBE 421\nG0 X0\n", "N10 G421\n",
        "G421 Q1\n", "G42 Q1=5\n", "G4212 Q1=2\n",
    ] {
        assert!(control_of(text.as_bytes()).is_none(), "{text}");
    }
}

proptest! {
    // oracle: self: no text stops reading, and every place lies in it
    #[test]
    fn any_text_is_read(bytes in prop::collection::vec(prop::sample::select(
        b"TCH PROBE 421 Q2=~;\n\r+-.9/\xff".to_vec()), 0..400)) {
        let mut source = b"TCH PROBE 421 X ~\n".to_vec();
        source.extend(&bytes);
        let found = of_program(&source).unwrap();
        for span in found.iter().filter_map(|one| one.span) {
            prop_assert!(span.start <= span.end && span.end as usize <= source.len());
        }
        let _ = logs(&format!("{}{}", LOG, String::from_utf8_lossy(&bytes)));
    }
}
