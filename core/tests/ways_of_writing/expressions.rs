//! An expression of a program goes along as text, whatever is done with the call: what it is worth today never takes
//! its place.

use super::convert::converted;
use super::sites;
use probewright_core::catalogue::CYCLES;
use probewright_core::check::parse;
use probewright_core::control::{Control, delivery};
use probewright_core::dialect::Dialect;
use probewright_core::entry::{Cycle, Kind, Style, Typed};
use probewright_core::program::calls::CallSite;
use probewright_core::program::change::{apply, change};
use probewright_core::program::findings;
use probewright_core::program::revise::{Revision, revise};
use probewright_core::program::write::{Values, snippet_of};
use probewright_core::support;
use probewright_core::syntax::{Program, read};
use proptest::prelude::*;
use proptest::test_runner::TestCaseResult;
use std::collections::BTreeSet;

const STYLES: [Style; 3] = [Style::Direct, Style::Indirect, Style::Operate];

fn control() -> Control {
    delivery(Dialect::Sinumerik)
}

// oracle: hand (R2 is 50.02 today and may be another number tomorrow)
#[test]
fn an_expression_is_converted_as_it_is_written() {
    let text = "R2=50.02 R3=0.012\nN20 _MVAR=1 _SETVAL=R2 _PRNUM=1 _KNUM=0 _FA=2 _TSA=2*R3\nCYCLE977\n";
    let (indirect, said) = converted(text, 0, Style::Indirect);
    assert_eq!(indirect, "R2=50.02 R3=0.012\n_TSA=2*R3\nCYCLE_PARA(2)\nCYCLE_977_979A(977,1,R2,,,,,0,,,,,1)\n");
    assert_eq!(said, ["write-expression"], "CYCLE_PARA does not take a 0");
    let site = &sites(&indirect)[0];
    assert_eq!(site.values["_SETVAL"], "50.02");
    assert_eq!(site.expressions["_SETVAL"], "R2");
    let (back, _) = converted(&indirect, 0, Style::Direct);
    assert_eq!(sites(&back)[0].expressions, sites(text)[0].expressions);
    let (operate, _) = converted(text, 0, Style::Operate);
    let newer = &sites(&operate)[0];
    assert_eq!(newer.expressions, sites(text)[0].expressions, "{operate}");
}

/// The program stays as it is, and this is said.
fn refused(text: &str, style: Style, reason: &str) {
    let (after, said) = converted(text, 0, style);
    assert_eq!(after, text);
    assert_eq!(said, [reason], "{text}");
}

// oracle: hand
#[test]
fn a_call_stays_where_an_expression_cannot_go_along() {
    // worth 50 where it is written and 7 at the call
    let changed = "R2=50\n_MVAR=1 _SETVAL=R2 _PRNUM=1 _FA=2\nR2=7\nCYCLE977\n";
    refused(changed, Style::Indirect, "convert-expression");
    // what it is worth only the run tells, and the position is another one then
    let moved = "_MVAR=1 _SETVAL=$AA_IM[X] _PRNUM=1 _FA=2\nG0 X50\nCYCLE977\n";
    refused(moved, Style::Indirect, "convert-expression");
    let beside = moved.replace("\nG0 X50", "");
    assert!(converted(&beside, 0, Style::Indirect).0.contains("$AA_IM[X]"));
    // newer controls have no argument for the measuring feed
    let lost = "R7=120\n_MVAR=1 _SETVAL=50 _PRNUM=1 _KNUM=0 _VMS=R7 _FA=2\nCYCLE977\n";
    refused(lost, Style::Operate, "write-expression-lost");
    // selections make the variant
    let variant = "R5=1\n_MVAR=R5 _SETVAL=50 _FA=2 _PRNUM=1\nCYCLE976\n";
    refused(variant, Style::Indirect, "write-variant-open");
    let selected = "R5=1\nCYCLE_976(50,,R5,4,,,,,1)\n";
    refused(selected, Style::Direct, "convert-argument");
    let number = selected.replace("R5,4", "1,4"); // as the hint says
    assert!(converted(&number, 0, Style::Direct).0.contains("_MVAR="));
    // a selection that means the same stays when the variant changes
    let (after, ..) = revised(selected, "_MVAR", "12001");
    assert_eq!(after, selected.replace(",4,", ",2,"));
}

// oracle: hand: the caller's 40 is not the subprogram's number
#[test]
fn a_subprogram_keeps_what_its_caller_gives() {
    let text = "%_N_MAIN_MPF\nMEASURE(40)\nM30\n%_N_MEASURE_SPF\nPROC MEASURE(REAL _D)\n\
        _MVAR=1 _SETVAL=_D _PRNUM=1 _FA=2\nCYCLE977\nM17\n";
    let (indirect, _) = converted(text, 0, Style::Indirect);
    let call = indirect.lines().find(|line| line.starts_with("CYCLE_9"));
    assert!(call.unwrap().contains(",_D"), "{indirect}");
}

// oracle: hand (both signs: down is minus in the one list, and plus in the other)
#[test]
fn a_sign_that_is_turned_round_twice_is_gone_again() {
    for text in ["R1", "-R1", "SIN(R1)", "(R1+R2)*(R3)", "R1-(R2)", "-(R1)"] {
        let text = format!(
            "R1=5 R2=3 R3=1\n_MVAR=1001 _SETVAL=50 _ID={text} _SZA=80 _PRNUM=1 _FA=2 _TSA=1 _KNUM=0\nCYCLE977\n"
        );
        let (newer, _) = converted(&text, 0, Style::Operate);
        let (back, _) = converted(&newer, 0, Style::Direct);
        let (again, _) = converted(&back, 0, Style::Operate);
        let id = |text: &str| {
            let site = &sites(text)[0];
            (site.values["_ID"].clone(), site.expressions.clone())
        };
        assert_eq!(id(&again), id(&newer), "from {text} by {back}");
        let (back, _) = converted(&again, 0, Style::Direct);
        assert_eq!(converted(&back, 0, Style::Operate).0, again, "by {back}");
    }
}

// oracle: manual B:12505-12506 (measuring feed has no field there), hand
#[test]
fn no_cure_takes_an_expression_away() {
    let mut control = control();
    control.set(support::FORMS, 1.0);
    let text = "R4=300\n_MVAR=1 _SETVAL=50 _PRNUM=1 _KNUM=0 _FA=2 _TSA=1 _VMS=R4 _NMSP=1 _ID=0\nCYCLE977\nM30\n";
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let found = probewright_core::program::findings_on(&program, control);
    let back: Vec<_> = found.iter().filter(|one| one.message.key == "advice-read-back").collect();
    assert_eq!(back.len(), 1, "{found:?}");
    assert!(back[0].cure.is_none());
    assert!(format!("{:?}", back[0].message).contains("_VMS=R4"));
}

/// Which parameters are expressions, and of which sort; and whether an R parameter changes before the call.
type Choices = Vec<(bool, u8, i32)>;

/// A program with one call whose values are expressions, each of an R parameter of its own.
fn program_of(
    cycle: &'static Cycle,
    variant: i64,
    style: Style,
    choices: &Choices,
    between: Option<u8>,
) -> Option<String> {
    let (mut typed, mut expressions, mut head) = (Typed::new(), Typed::new(), String::new());
    for (at, (param, (given, sort, number))) in cycle.params.iter().zip(choices).enumerate() {
        let at = at + 10;
        let value = match param.kind {
            Kind::Variant(_) => variant,
            Kind::Text(_) => continue,
            _ if !given => continue,
            _ => i64::from(number % 100),
        };
        let (worth, text) = match sort % 6 {
            0 => (value.to_string(), format!("R{at}")),
            1 => (value.to_string(), format!("R{at}+0")),
            2 => ((value - 1).to_string(), format!("(1+R{at})")),
            3 => ((value * 2).to_string(), format!("R{at}/2")),
            4 => ((-value).to_string(), format!("-R{at}")),
            _ => {
                typed.insert(param.name.into(), value.to_string());
                continue;
            }
        };
        typed.insert(param.name.into(), value.to_string());
        head.push_str(&format!("R{at}={worth}\n"));
        expressions.insert(param.name.into(), text);
    }
    let values = Values { typed: &typed, expressions: &expressions };
    let written = snippet_of(cycle, &values, &control(), style, None).text;
    let (values, call) = written.trim_end().rsplit_once('\n').unwrap_or(("", &written));
    let between = between.map_or(String::new(), |at| format!("R{at}=R{at}+1\n"));
    let values = if values.is_empty() { String::new() } else { format!("{values}\n") };
    (!written.is_empty()).then(|| format!("{head}{values}{between}{}\n", call.trim_end()))
}

/// The R parameters that a text reads.
fn read_parameters(text: &str) -> BTreeSet<String> {
    let lines = text.lines();
    let calls = lines.flat_map(|line| match line.strip_prefix('R') {
        Some(rest) if rest.starts_with(|c: char| c.is_ascii_digit()) => Vec::new(),
        _ => line.split(|c: char| !c.is_ascii_alphanumeric() && c != '_').collect(),
    });
    let parameter = |word: &&str| {
        let number = word.strip_prefix('R').unwrap_or_default();
        !number.is_empty() && number.bytes().all(|byte| byte.is_ascii_digit())
    };
    calls.filter(parameter).map(str::to_owned).collect()
}

/// What arrives at the call where the program has an expression.
fn worth(site: &CallSite) -> Vec<(String, String)> {
    let pairs = site.expressions.keys();
    let pairs = pairs.map(|name| (name.clone(), format!("{:?}", parse(&site.values[name]))));
    pairs.map(|(name, value)| (name, value.replace("-0.0", "0.0"))).collect()
}

fn is_kept(before: &str, after: &str, by: &str) -> TestCaseResult {
    let all = read_parameters(before);
    prop_assert!(read_parameters(after).is_superset(&all), "{by}:\n{before}\n{after}");
    Ok(())
}

fn survives_all(cycle: &'static Cycle, text: &str, style: Style) -> TestCaseResult {
    let found = sites(text);
    prop_assert_eq!(found.len(), 1, "{}", text);
    for other in STYLES.into_iter().filter(|other| *other != style) {
        let (after, said) = converted(text, 0, other);
        is_kept(text, &after, "converted")?;
        if after == text {
            prop_assert!(!said.is_empty(), "refused in silence: {}", text);
            continue;
        }
        let before = worth(&found[0]);
        let there = worth(&sites(&after)[0]);
        let used = before.iter().filter(|(name, _)| there.iter().any(|(other, _)| other == name));
        for pair in used {
            prop_assert!(there.contains(pair), "{:?}\n{}\n{}", pair, text, after);
        }
        let (back, _) = converted(&after, 0, style);
        is_kept(text, &back, "converted back")?;
    }
    let program = read(Dialect::Sinumerik, text.as_bytes());
    for param in cycle.params.iter().filter(|param| found[0].expression(param.name.as_str()).is_none()) {
        let value = if matches!(param.kind, Kind::Text(_)) { "A" } else { "3" };
        let edits = change(&program, &found[0], param.name.as_str(), value);
        let after = String::from_utf8(apply(text.as_bytes(), &edits)).unwrap();
        is_kept(text, &after, param.name.as_str())?;
    }
    for one in findings(&program) {
        let edits = one.cure.map(|cure| cure.edits).unwrap_or_default();
        let after = String::from_utf8(apply(text.as_bytes(), &edits)).unwrap();
        is_kept(text, &after, "cured")?;
    }
    Ok(())
}

fn choices() -> impl Strategy<Value = Choices> {
    proptest::collection::vec((any::<bool>(), any::<u8>(), -9999..9999_i32), 40)
}

// oracle: self (no expression of the program is lost, and what arrives at the call stays the same)
proptest! {
    #![proptest_config(ProptestConfig::with_cases(4))]

    #[test]
    fn no_expression_is_lost(choices in choices(), between in proptest::option::of(10..30_u8)) {
        for cycle in CYCLES.iter().filter(|cycle| cycle.dialect == Dialect::Sinumerik) {
            for variant in cycle.variants {
                for style in STYLES {
                    let text = program_of(cycle, variant.number, style, &choices, between);
                    if let Some(text) = text {
                        survives_all(cycle, &text, style)?;
                    }
                }
            }
        }
    }
}

/// What [`revise`] does where every value fits.
fn fitting(program: &Program, index: usize, change: (&str, &str)) -> Option<Revision> {
    revise(program, index, change, &control(), &mut |_, _, _| Vec::new())
}

/// The program with a value of its first call changed as a form does it, and what was taken out and what stays.
fn revised(text: &str, name: &str, value: &str) -> (String, Vec<&'static str>, Vec<String>) {
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let done = fitting(&program, 0, (name, value)).unwrap();
    let after = done.steps.iter().fold(text.as_bytes().to_vec(), |text, edits| apply(&text, edits));
    let said = done.findings.iter().map(|one| one.message.key.to_string());
    (String::from_utf8(after).unwrap(), done.taken.iter().map(|name| name.as_str()).collect(), said.collect())
}

// oracle: manual B:5641-5667 (with a zero offset there is no tool, and no tolerance band)
#[test]
fn what_another_variant_does_not_know_leaves_the_call() {
    let text = "_MVAR=1 _KNUM=2001 _PRNUM=1 _SETVAL=132 _FA=2 _TSA=1\n\
        _TNUM=20 _TZL=0.01 _TDIF=0.06 _TUL=0.03 _TLL=-0.03 _TMV=0.02 _K=3 ; tool\nG0 X1 _EVNUM=2\nCYCLE977\n";
    let (after, taken, said) = revised(text, "_MVAR", "101");
    assert_eq!(after, "_MVAR=101 _KNUM=2001 _PRNUM=1 _SETVAL=132 _FA=2 _TSA=1\n; tool\nG0 X1\nCYCLE977\n",);
    assert!(taken.contains(&"_TNUM") && taken.contains(&"_TMV"), "{taken:?}");
    assert_eq!(said, ["revise-taken"]);
    // So does an expression: what went is told with its text.
    let program = read(Dialect::Sinumerik, text.replace("_TZL=0.01", "_TZL=R7").as_bytes());
    let done = fitting(&program, 0, ("_MVAR", "101")).unwrap();
    assert!(done.reaches && done.taken.iter().any(|name| name.as_str() == "_TZL"), "{:?}", done.taken);
    let told = format!("{:?}", done.findings);
    assert!(told.contains("_TZL=R7"), "{told}");
    // What an earlier call reads too stays.
    let shared = format!("{text}_MVAR=1\nCYCLE977\n");
    let program = read(Dialect::Sinumerik, shared.as_bytes());
    let done = fitting(&program, 1, ("_MVAR", "101")).unwrap();
    assert_eq!(done.taken, Vec::<&str>::new());
    // No other field does so, and no number on the way to the wanted one that is no variant.
    for (name, value) in [("_KNUM", "0"), ("_MVAR", "10")] {
        assert_eq!(revised(text, name, value).1, Vec::<&str>::new());
    }
}

// oracle: hand (data of the channel: what a call is given counts at those behind it)
#[test]
fn a_value_that_later_calls_read_is_theirs_too() {
    let text = "_MVAR=1 _KNUM=2001 _PRNUM=1 _SETVAL=132 _FA=2 _TSA=1 _TNUM=20 _TUL=0.03 _TLL=-0.03\nCYCLE977\n\
        _SETVAL=40\nCYCLE977\nM30\n";
    let done = |index, name, value| {
        let program = read(Dialect::Sinumerik, text.as_bytes());
        let done = fitting(&program, index, (name, value)).unwrap();
        let values = done.values.into_iter().map(|one| (one.line, one.param, one.before, one.after));
        (done.reaches, values.collect::<Vec<_>>())
    };
    let value =
        |line, before: &str, after: &str| (line, "_FA".to_owned(), Some(before.to_owned()), Some(after.to_owned()));
    assert_eq!(done(0, "_FA", "3"), (true, vec![value(2, "2", "3"), value(4, "2", "3")]));
    assert_eq!(done(1, "_FA", "3"), (false, vec![value(4, "2", "3")]));
    assert!(!done(0, "_SETVAL", "133").0);
    let (reaches, values) = done(0, "_MVAR", "101");
    assert!(reaches && values.iter().all(|(_, name, ..)| name == "_MVAR"), "{values:?}");
}

// oracle: manual B:9519 (the start angle is one of measuring a tool; with which one the program runs, nobody knows)
#[test]
fn what_only_another_tool_uses_leaves_the_call_too() {
    let text = "_MVAR=1 _MA=1 _STA1=15 _PRNUM=1 _FA=3 _TSA=3\nCYCLE982\nM30\n";
    assert_eq!(revised(text, "_MVAR", "0").0, text.replace("_MVAR=1", "_MVAR=0").replace(" _STA1=15", ""));
    assert_eq!(revised(text, "_MVAR", "1001").0, text.replace("_MVAR=1", "_MVAR=1001"));
}

// oracle: hand
#[test]
fn arguments_that_another_variant_does_not_know_are_emptied() {
    let direct = "_MVAR=1 _KNUM=2001 _PRNUM=1 _SETVAL=132 _FA=2 _TSA=1 _TNUM=20 _TZL=0.01 _TDIF=0.06 _TUL=0.03 \
        _TLL=-0.03 _TMV=0.02 _K=3 _EVNUM=2\nCYCLE977\n";
    let (indirect, _) = converted(direct, 0, Style::Indirect);
    let (after, taken, _) = revised(&indirect, "_MVAR", "101");
    assert!(taken.contains(&"_TZL"), "{taken:?}\n{indirect}");
    let site = &sites(&after)[0];
    assert_eq!(site.values.get("_TZL"), None, "{after}");
    assert_eq!(site.values["_FA"], "2");
    assert_eq!(site.values["_MVAR"], "101");
}

// oracle: hand
#[test]
fn a_change_says_which_lines_of_others_it_touches() {
    let text = "%_N_MAIN_MPF\nMEASURE(40) ; ring\nM30\n%_N_MEASURE_SPF\nPROC MEASURE(REAL _D)\n\
        _MVAR=1 _SETVAL=_D _PRNUM=1 _FA=2\nCYCLE977\nM17\n";
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let lines = fitting(&program, 0, ("_SETVAL", "41")).unwrap().elsewhere;
    let lines: Vec<_> = lines.iter().map(|one| (one.line, &*one.before, &*one.after)).collect();
    assert_eq!(lines, [(2, "MEASURE(40) ; ring", "MEASURE(41) ; ring")]);
    let own = fitting(&program, 0, ("_FA", "4")).unwrap();
    assert!(own.elsewhere.is_empty() && !own.steps.is_empty());
    let new = fitting(&program, 0, ("_VMS", "100")).unwrap();
    assert!(new.elsewhere.is_empty() && !new.steps.is_empty());
}
