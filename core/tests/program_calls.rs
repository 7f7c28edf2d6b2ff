//! Measuring calls read from programs, and changes of one value.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use probewright_core::catalogue::{CYCLES, find};
use probewright_core::control::delivery;
use probewright_core::dialect::Dialect;
use probewright_core::entry::{Kind, Style, Typed};
use probewright_core::program::calls::{CallSite, calls};
use probewright_core::program::change::{apply, change};
use probewright_core::program::write::snippet;
use probewright_core::syntax::{Program, read};
use proptest::prelude::*;

fn sinumerik(text: &str) -> (Program, Vec<CallSite>) {
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let sites = calls(&program);
    (program, sites)
}

fn value<'a>(site: &'a CallSite, name: &str) -> &'a str {
    site.values.get(name).map_or("", String::as_str)
}

fn changed(text: &str, call: usize, name: &str, value: &str) -> String {
    let (program, sites) = sinumerik(text);
    let edits = change(&program, &sites[call], name, value);
    String::from_utf8(apply(&program.source, &edits)).unwrap()
}

// oracle: hand: a program has no exponent `e`; the value is read again as it was meant, and may be changed once more
#[test]
fn an_exponent_is_written_out() {
    let text = "_MVAR=1 _SETVAL=50 _KNUM=0\nCYCLE977\n";
    for (typed, written) in [("1e3", "1000"), ("2,5E-1", "0.25"), ("1.5EX2", "150"), ("51,5", "51.5"), ("R2", "R2")] {
        let once = changed(text, 0, "_SETVAL", typed);
        assert_eq!(once, text.replace("50", written), "{typed}");
        assert_eq!(changed(&once, 0, "_SETVAL", "50"), text, "{typed}");
    }
}

// oracle: manual B 5.4.3.2 (hole 132, radius wear of T20)
#[test]
fn a_call_has_the_values_of_all_its_lines() {
    let (program, sites) = sinumerik(include_str!("programs/hole.mpf"));
    assert_eq!(sites.len(), 1);
    let site = &sites[0];
    assert_eq!((site.cycle.name, site.first_line + 1, site.line + 1), ("CYCLE977", 8, 10));
    assert_eq!(program.text(site.span), b"CYCLE977");
    for (name, expected) in [("_MVAR", "1"), ("_SETVAL", "132"), ("_TLL", "-0.03"), ("_KNUM", "2001"), ("_TSA", "1")] {
        assert_eq!(value(site, name), expected);
        assert_eq!(program.text(site.places[name]), expected.as_bytes());
    }
}

// oracle: hand (user data stays until it is overwritten)
#[test]
fn values_of_earlier_calls_persist_and_the_newest_counts() {
    let (program, sites) = sinumerik("_MVAR=100 _SETVAL=0 _MA=1 _FA=4\nCYCLE978\n\n_MA=2\ncycle978\nCYCLE978\n");
    let lines: Vec<_> = sites.iter().map(|site| (site.first_line, site.line, value(site, "_MA"))).collect();
    assert_eq!(lines, [(0, 1, "1"), (3, 4, "2"), (5, 5, "2")]);
    assert!(sites.iter().all(|site| value(site, "_FA") == "4" && value(site, "_MVAR") == "100"));
    assert_eq!(program.line_of(sites[2].places["_MA"].start), 3);
}

// oracle: hand
#[test]
fn constant_expressions_are_worked_out_and_others_stay_as_text() {
    let text = "R5=10\n_MVAR=1 _SETVAL=110.5 _FA=_SETVAL/2 _TSA=R5*2-1 _ID=R99+1\n_TNUM = 3 _VMS=-(2+3)\nCYCLE977\n";
    let (_, sites) = sinumerik(text);
    let shown = ["_FA", "_TSA", "_ID", "_TNUM", "_VMS"].map(|name| value(&sites[0], name));
    assert_eq!(shown, ["55.25", "19", "R99+1", "3", "-5"]);
}

// oracle: hand
#[test]
fn a_variable_that_a_loop_changes_is_not_taken_for_constant() {
    let (_, sites) = sinumerik("R1=5\nBACK: _TSA=R1 _MVAR=1\nCYCLE977\nR1=R1+1\nIF R1<9 GOTOB BACK\n");
    assert_eq!(value(&sites[0], "_TSA"), "R1");
}

// oracle: hand
#[test]
fn elements_of_a_list_are_values_with_their_own_places() {
    let (_, open) = sinumerik("R1=4\n_MVAR=105 _SETV[0]=SET((1+R1)*2, SIN(R1))\nCYCLE977\n");
    assert_eq!(open[0].expressions["_SETV[0]"], "(1+R1)*2");
    assert_eq!(open[0].expressions["_SETV[1]"], "SIN(R1)");
    assert_eq!(open[0].values["_SETV[1]"], "0.06975647374413"); // sin 4°
    let text = "_MVAR=105 _SETV[0]=SET(100, -20.5)\nCYCLE977\n";
    let (program, sites) = sinumerik(text);
    assert_eq!((value(&sites[0], "_SETV[0]"), value(&sites[0], "_SETV[1]")), ("100", "-20.5"));
    assert_eq!(program.text(sites[0].places["_SETV[1]"]), b"-20.5");
    assert_eq!(changed(text, 0, "_SETV[1]", "30"), text.replace("-20.5", "30"));
}

// oracle: hand (SET and REP fill an array; values stay until they are overwritten)
#[test]
fn repeated_values_persist_to_the_call() {
    let text = "_MVAR=105\n_SETV=REP(20)\n_SETV[1]=SET(25)\nR5=1\nCYCLE977\n_SETV=SET(30,35)\nCYCLE977\n";
    let (_, sites) = sinumerik(text);
    let pair = |index: usize| ["_SETV[0]", "_SETV[1]"].map(|name| value(&sites[index], name));
    assert_eq!(pair(0), ["20", "25"]);
    assert_eq!(pair(1), ["30", "35"]);
    let (_, sites) = sinumerik("DEF REAL A[2,2]=SET(1,2,3)\n_SETVAL=A[1,0]+A[0,1] _MVAR=1\nCYCLE977\n");
    assert_eq!(value(&sites[0], "_SETVAL"), "5");
}

// oracle: hand (REP stays as it is for the others; the new value stands behind it)
#[test]
fn one_of_repeated_values_is_written_anew() {
    let text = "_MVAR=105 _SETV=REP(20) ; both\nCYCLE977\n";
    assert_eq!(changed(text, 0, "_SETV[1]", "25"), "_MVAR=105 _SETV=REP(20) _SETV[1]=25 ; both\nCYCLE977\n");
    assert_eq!(changed(text, 0, "_MVAR", "106"), text.replace("105", "106"));
}

// oracle: manual C:58 (parameters 9041 to 9050: O9010 is G101, O9019 is G110)
#[test]
fn a_macro_called_by_its_program_number_is_a_call_like_others() {
    let text = "%O0110\r\nN10 G17 G65 P9019 D50 S6 (bore)\r\nG65 P9010 X10 F#1\r\nG65 P9500 X1\r\nN40 G110 D30\r\n";
    let program = read(Dialect::Nct, text.as_bytes());
    let sites = calls(&program);
    let found: Vec<_> = sites.iter().map(|site| (site.cycle.name, site.line)).collect();
    assert_eq!(found, [("G110", 1), ("G101", 2), ("G110", 4)]);
    assert_eq!(program.text(sites[0].span), b"G65 P9019");
    assert_eq!((value(&sites[0], "D"), value(&sites[1], "F")), ("50", "#1"));
    let edited = |name: &str, value: &str| {
        let edits = change(&program, &sites[0], name, value);
        String::from_utf8(apply(&program.source, &edits)).unwrap()
    };
    assert_eq!(edited("D", "60,5"), text.replace("D50", "D60.5"));
    assert_eq!(edited("S", ""), text.replace(" S6", ""));
    assert_eq!(edited("H", "0.1"), text.replace("S6", "S6 H0.1"));
    let bare = read(Dialect::Nct, b"G65 P9019\n");
    let edits = change(&bare, &calls(&bare)[0], "D", "50");
    assert_eq!(apply(&bare.source, &edits), b"G65 P9019 D50\n");
}

// oracle: hand
#[test]
fn calls_that_are_skipped_or_wrong_are_listed_with_places() {
    let (program, sites) = sinumerik("GOTOF OVER\n/N5 _MVAR=1 _SETVAL=-5\n/N6 CYCLE977\nOVER: M30\n");
    assert_eq!(sites.len(), 1);
    assert!(!sites[0].diagnostics.is_empty());
    for finding in &sites[0].diagnostics {
        let place = program.text(finding.span.unwrap());
        assert!(
            place == b"CYCLE977"
                || finding.param.is_some_and(|name| value(&sites[0], name.as_str()).as_bytes() == place)
        );
    }
}

// oracle: manual C:1048 (addresses of the G110 block), hand
#[test]
fn addresses_of_an_nct_block_are_the_values() {
    let program = read(Dialect::Nct, include_bytes!("programs/bore.nc"));
    let sites = calls(&program);
    let bores: Vec<_> = sites.iter().filter(|site| site.cycle.name == "G110").collect();
    assert_eq!(bores.len(), 2);
    assert_eq!((value(bores[0], "S"), value(bores[1], "D"), value(bores[1], "H")), ("6", "50.", ".3"));
    let edits = change(&program, bores[1], "H", "0,2");
    let text = String::from_utf8(apply(&program.source, &edits)).unwrap();
    assert_eq!(text, include_str!("programs/bore.nc").replace("H.3", "H0.2"));
    let edits = change(&program, bores[1], "Q", "12");
    let text = String::from_utf8(apply(&program.source, &edits)).unwrap();
    assert_eq!(calls(&read(Dialect::Nct, text.as_bytes())).iter().filter(|site| value(site, "Q") == "12").count(), 1);
    let edits = change(&program, bores[1], "H", "");
    let text = String::from_utf8(apply(&program.source, &edits)).unwrap();
    assert_eq!(text, include_str!("programs/bore.nc").replace(" H.3", ""));
}

const PROGRAM: &str =
    "N10 _MVAR=100  _SETVAL = 12.50 ;set\r\n  N20 _FA=1\t_TSA=2 ;more\r\n N30 CYCLE978 ;go\r\n N40 CYCLE978\r\n";

// oracle: hand
#[test]
fn a_change_replaces_the_value_and_nothing_else() {
    assert_eq!(changed(PROGRAM, 0, "_SETVAL", "13,25"), PROGRAM.replace("12.50", "13.25"));
    assert_eq!(changed(PROGRAM, 0, "_FA", "3"), PROGRAM.replace("_FA=1", "_FA=3"));
    assert_eq!(changed(PROGRAM, 0, "_FA", "1"), PROGRAM);
    assert_eq!(changed(PROGRAM, 0, "_NO_PARAMETER", "1"), PROGRAM);
}

// oracle: hand
#[test]
fn a_new_value_follows_the_last_one_of_the_call() {
    assert_eq!(changed(PROGRAM, 0, "_VMS", "200"), PROGRAM.replace("_TSA=2", "_TSA=2 _VMS=200"));
}

// oracle: hand
#[test]
fn a_value_shared_with_an_earlier_call_is_written_anew_before_this_call() {
    assert_eq!(changed(PROGRAM, 1, "_FA", "5"), PROGRAM.replace(" N40", " N35 _FA=5\r\n N40"));
    let full = PROGRAM.replace("N40", "N31");
    assert_eq!(changed(&full, 1, "_FA", "5"), full.replace(" N31", " _FA=5\r\n N31"));
    assert_eq!(changed(PROGRAM, 1, "_FA", ""), PROGRAM);
}

// oracle: hand
#[test]
fn taking_a_value_away_takes_its_blank_along() {
    assert_eq!(changed(PROGRAM, 0, "_TSA", ""), PROGRAM.replace("\t_TSA=2", ""));
    assert_eq!(changed(PROGRAM, 0, "_SETVAL", " "), PROGRAM.replace("  _SETVAL = 12.50", ""));
}

fn typed_values() -> impl Strategy<Value = (usize, Typed)> {
    let numbers = proptest::collection::vec((any::<bool>(), -9_999_999..9_999_999_i32, any::<usize>()), 24);
    (0..CYCLES.len(), numbers).prop_map(|(index, numbers)| {
        let cycle = CYCLES[index];
        let mut typed = Typed::new();
        for (param, (given, number, pick)) in cycle.params.iter().zip(numbers) {
            let text = match param.kind {
                Kind::Variant(_) => cycle.variants[pick % cycle.variants.len()].number.to_string(),
                Kind::Real if given => (f64::from(number) / 1000.0).to_string(),
                Kind::Text(_) if given => format!("T{}", number.unsigned_abs() % 100),
                _ if given => (number / 1000).to_string(),
                _ => continue,
            };
            typed.insert(param.name.into(), text);
        }
        (index, typed)
    })
}

// oracle: self (writing and reading are inverse)
proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn what_is_written_is_read_back_and_one_change_changes_one_value((index, typed) in typed_values(),
    other in 1..1000_u32) {
        let cycle = CYCLES[index];
        prop_assert!(find(cycle.dialect, cycle.name).is_some());
        let text = snippet(cycle, &typed, &delivery(cycle.dialect), Style::Direct, None).text;
        let program = read(cycle.dialect, text.as_bytes());
        prop_assert!(program.errors.is_empty(), "{}", text);
        let sites = calls(&program);
        prop_assert_eq!(sites.len(), 1);
        for (name, read) in &sites[0].values {
            prop_assert_eq!(read.parse::<f64>().ok(), typed[name].parse::<f64>().ok(), "{} in {}", name, text);
        }
        let written = sites[0].values.len();
        if cycle.dialect == Dialect::Sinumerik {
            let arguments = sites[0].list.map_or(0, |list| {
                let written = |name: &str| sites[0].values.contains_key(name);
                list.args.iter().filter(|arg| arg.param().is_some_and(|name| written(name.as_str()))).count()
            });
            prop_assert_eq!(written, text.matches('=').count() + arguments, "every value is read: {}", text);
        }
        for param in cycle.params.iter().filter(|param| !matches!(param.kind, Kind::Text(_))) {
            let edits = change(&program, &sites[0], param.name.as_str(), &other.to_string());
            let after = read(cycle.dialect, &apply(text.as_bytes(), &edits));
            let again = calls(&after);
            let had = sites[0].values.contains_key(param.name.as_str());
            prop_assert_eq!(again.len(), 1);
            prop_assert_eq!(value(&again[0], param.name.as_str()), other.to_string());
            prop_assert_eq!(again[0].values.len(), written + usize::from(!had));
            for (name, read) in sites[0].values.iter().filter(|(name, _)| param.name != name.as_str()) {
                prop_assert_eq!(value(&again[0], name), read);
            }
            if let (true, [edit]) = (had, &edits[..]) {
                prop_assert_eq!(edit.span, sites[0].places[param.name.as_str()], "only the value's place");
            }
        }
    }
}

// oracle: hand. Anything but one value would reach into the words behind it.
#[test]
fn what_is_no_value_changes_nothing() {
    for value in ["12x", "5 M30", "5;", "R1+", "(((", "1,2,3", "5\n_FA=9", "NaN", "1e5x", "-"] {
        assert_eq!(changed(PROGRAM, 0, "_SETVAL", value), PROGRAM, "{value}");
    }
    assert_eq!(changed(PROGRAM, 0, "_SETVAL", "R1 + 2"), PROGRAM.replace("12.50", "R1 + 2"));
    for name in ["A\"B", "\"A\" M30 \"", "A\nB"] {
        assert_eq!(changed(PROGRAM, 0, "_TNAME", name), PROGRAM, "{name}");
    }
}

// oracle: hand: on each way that the program can come to the call, the new value counts
#[test]
fn a_new_value_counts_on_every_way_to_the_call() {
    let values = "_MVAR=1 _SETVAL=30 _KNUM=0\n";
    for (between, written) in [
        ("G0 X5\n", ""),
        ("FOR R1=1 TO 4\nG0 X=R1\n", "FOR R1=1 TO 4\nG0 X=R1\n_FA=7\n"),
        ("/ _PRNUM=1\n", "/ _PRNUM=1\n_FA=7\n"),
        ("IF R1==1\n_PRNUM=1\nENDIF\n", "IF R1==1\n_PRNUM=1\nENDIF\n_FA=7\n"),
        ("IF R1==1 GOTOF A\nG0 X5\nN40 A: ", "IF R1==1 GOTOF A\nG0 X5\nN40 A: _FA=7\n"),
    ] {
        let text = format!("{values}{between}CYCLE977\nM30\n");
        let after = changed(&text, 0, "_FA", "7");
        let expected = match written {
            "" => text.replace("_KNUM=0", "_KNUM=0 _FA=7"),
            written => format!("{values}{written}CYCLE977\nM30\n"),
        };
        assert_eq!(after, expected);
        assert_eq!(value(&sinumerik(&after).1[0], "_FA"), "7", "{after}");
    }
}

// oracle: hand: an element can be written only of an array that the call names
#[test]
fn what_is_no_array_gets_no_elements() {
    for argument in ["R1", "5", "_X+1"] {
        let text = format!("CYCLE116({argument},_ALM)\nM30\n");
        assert_eq!(changed(&text, 0, "_DATE[0]", "3"), text);
    }
    let text = "CYCLE116(_POINTS,_ALM)\nM30\n";
    assert_eq!(changed(text, 0, "_DATE[0]", "3"), format!("_POINTS[0]=3\n{text}"));
}
