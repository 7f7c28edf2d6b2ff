//! What a user reads: every finding has words, names its values with units, and says the remedy.
#![cfg(feature = "cli")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod every_finding;

use probewright_core::catalogue::example::worked;
use probewright_core::catalogue::{CYCLES, find};
use probewright_core::check::check;
use probewright_core::control::{Control, Units, delivery};
use probewright_core::diagnostic::Diagnostic;
use probewright_core::dialect::Dialect;
use probewright_core::form::{Choice, Entry, fields};
use probewright_core::geometry::{Dir, Mcs};
use probewright_core::machine::trace::{Entry as TraceEntry, Step};
use probewright_core::scene::frames::{Frame, UNITS};
use probewright_core::scene::labels::{self, Label};
use probewright_core::words::{LANGUAGES, Words};
use probewright_core::workpiece::feeler::Touching;

fn findings(name: &str, values: &[(&str, &str)], control: &Control) -> Vec<Diagnostic> {
    let cycle = find(Dialect::Sinumerik, name).unwrap();
    let mut typed = worked(cycle);
    typed.extend(values.iter().map(|(name, value)| (name.to_string(), value.to_string())));
    check(cycle, &typed, control).diagnostics
}

/// Cause and remedy of the findings at a parameter.
fn told(values: &[(&str, &str)], param: &str, control: &Control) -> String {
    let words = Words::english();
    let found = findings("CYCLE977", values, control);
    let these = found.iter().filter(|finding| finding.param.is_some_and(|at| at == param));
    these
        .map(|finding| {
            let hint = finding.hint.as_ref().map_or(String::new(), |hint| words.text(hint));
            format!("{} {hint}\n", words.text(&finding.message))
        })
        .collect()
}

/// Bits that have no effect unless another one or a parameter has this value, and where the manual says so.
const DEPENDENT_BITS: [(&str, &[&str]); 8] = [
    ("cbit-1", &["_CBIT[0]=1"]),                     // B:13576
    ("chbit-6", &["_CHBIT[8]=0"]),                   // B:13937-13939, of additive and setup offsets
    ("chbit-11", &["_CHBIT[10]=1", "_CHBIT[18]=0"]), // B:13962
    ("chbit-14", &["_CHBIT[13]=1"]),                 // B:13983
    ("chbit-16", &["_CHBIT[2]=1"]),                  // B:14007
    ("chbit-17", &["_FA", "1\u{a0}mm"]),             // B:13772
    ("chbit-18", &["_CHBIT[10]=1", "_CHBIT[11]=0"]), // B:13971
    ("chbit-22", &["_CBIT[12]=0"]),                  // B:14043
];

// oracle: manual (the lines above)
#[test]
fn a_bit_says_what_its_effect_depends_on() {
    for language in LANGUAGES {
        let words = Words::of(language.code).unwrap();
        for (bit, conditions) in DEPENDENT_BITS {
            let help = words.key(format!("datum-{bit}.help"));
            assert!(conditions.iter().all(|one| help.contains(one)), "{} {bit}: {help}", language.code);
        }
    }
}

// oracle: hand
#[test]
fn causes_and_cures_name_values_with_units() {
    let metric = delivery(Dialect::Sinumerik);
    let mut inch = metric.clone();
    inch.active_units = Units::Inch;
    for (values, param, control, text) in [
        (&[("_SETVAL", "-5")][..], "_SETVAL", &metric, "_SETVAL cannot be -5\u{a0}mm. Enter a value above 0\u{a0}mm."),
        (&[("_SETVAL", "-5")], "_SETVAL", &inch, "_SETVAL cannot be -5\u{a0}inch. Enter a value above 0\u{a0}inch."),
        (&[("_FA", "0,5")], "_FA", &metric, "0.5\u{a0}mm is unusual for _FA. Usual range: 1 to 100\u{a0}mm."),
        (&[("_VMS", "5000")], "_VMS", &metric, "5000\u{a0}mm/min is unusual"),
        (
            &[("_PRNUM", "101"), ("_CORA", "400")],
            "_CORA",
            &metric,
            "_CORA cannot be 400°. Enter a value from 0 to 360°.",
        ),
        (&[("_PRNUM", "101")], "_CORA", &metric, "_CORA is not set: the default 0° applies."),
        (
            &[("_TUL", "-1"), ("_TLL", "0,5")],
            "_TUL",
            &metric,
            "-1\u{a0}mm, is below the lower tolerance, 0.5\u{a0}mm. Swap",
        ),
        (&[("_TUL", "0,3"), ("_TLL", "-0,3")], "_TDIF", &metric, "0.3\u{a0}mm, is larger than _TDIF, 0.06\u{a0}mm"),
        (&[("_TZL", "0,5")], "_TMV", &metric, "_TZL, 0.5\u{a0}mm, is larger than _TMV, 0.02\u{a0}mm"),
        (&[("_TDIF", "3")], "_TSA", &metric, "_TDIF, 3\u{a0}mm, is larger than _TSA, 1\u{a0}mm"),
        (&[("_SETVAL", "5,5")], "_SETVAL", &metric, "The probe ball, 6\u{a0}mm, does not fit inside."),
        (&[("_FA", "127")], "_FA", &metric, "only 126\u{a0}mm of travel. Reduce _FA below 126\u{a0}mm."),
        (
            &[("_MVAR", "1001"), ("_ID", "-20"), ("_SZA", "140")],
            "_SZA",
            &metric,
            "The protection zone, 140\u{a0}mm, is not smaller than the element, 132\u{a0}mm. \
             Reduce the protection zone below 120\u{a0}mm",
        ),
        (&[("_MVAR", "2"), ("_ID", "20")], "_ID", &metric, "The infeed, 20\u{a0}mm, does not move the probe down"),
        (
            &[("_MVAR", "101")],
            "_KNUM",
            &metric,
            "2001 is not the code of a zero offset. This is the code of a tool offset.",
        ),
        (&[("_K", "0")], "_K", &metric, "_K cannot be 0. Enter a value above 0."),
    ] {
        let found = told(values, param, control);
        assert!(found.contains(text), "{values:?}: {found}");
    }
}

// oracle: hand (the text is held against values at and beyond the limit of each condition)
#[test]
fn a_finding_is_true_of_every_value_that_raises_it() {
    let tool = [("_MVAR", "2"), ("_MA", "3"), ("_ID", "0")];
    for (cycle, values, datum, text) in [
        ("CYCLE971", &[("_FA", "0")][..], ("_CHBIT[3]", 0.0), "The measuring path is 0: "),
        ("CYCLE971", &[("_FA", "0")], ("_CHBIT[3]", 0.0), "Enter _FA above 0"),
        ("CYCLE971", &[("_FA", "-1")], ("_CHBIT[3]", 0.0), "The measuring path is negative"),
        ("CYCLE971", &[("_MVAR", "10000"), ("_FA", "0")], ("_CHBIT[3]", 0.0), "with minus for the minus direction"),
        ("CYCLE971", &tool, ("_CM[0]", 0.0), "_CM[0] is 0 or less"),
        ("CYCLE971", &tool, ("_CM[0]", -5.0), "_CM[0] is 0 or less"),
        ("CYCLE971", &tool, ("_MFS[0]", 0.0), "_MFS[0] is 0 or less"),
        ("CYCLE971", &tool, ("_MFS[0]", -5.0), "_MFS[0] is 0 or less"),
        ("CYCLE971", &tool, ("_MFS[2]", -5.0), "_MFS[2] is 0 or less"),
        ("CYCLE994", &[], ("_WP[0,0]", -1.0), "_WP[0,0], but it is 0 or less"),
        ("CYCLE977", &[("_MVAR", "101"), ("_KNUM", "2000")], ("MD28082", 0.0), "no system frame $P_SETFR, which 2000"),
        (
            "CYCLE977",
            &[("_MVAR", "1001"), ("_ID", "-20"), ("_SETVAL", "10"), ("_SZA", "9")],
            ("_CHBIT[3]", 0.0),
            "No protection zone fits inside",
        ),
        (
            "CYCLE979",
            &[("_STA1", "-300"), ("_INCA", "31")],
            ("_CHBIT[3]", 0.0),
            "without their signs, is 362°, more than 360°",
        ),
    ] {
        let mut control = delivery(Dialect::Sinumerik);
        control.set("_CBIT[12]", f64::from(u8::from(datum.0.starts_with("_MFS"))));
        control.set("_MFS[4]", 100.0);
        control.set("_CHBIT[7]", 1.0);
        control.set(datum.0, datum.1);
        let words = Words::english();
        let found = findings(cycle, values, &control);
        let told = found.iter().flat_map(|one| std::iter::once(&one.message).chain(&one.hint));
        let told: Vec<String> = told.map(|message| words.text(message)).collect();
        assert!(told.iter().any(|one| one.contains(text)), "{values:?} {datum:?}: {told:#?}");
    }
}

/// What can be chosen for a field, in all its groups of digits.
fn choices(entry: Entry) -> Vec<Choice> {
    match entry {
        Entry::Choice { choices } => choices,
        Entry::Digits { digits: groups } => groups.into_iter().flat_map(|group| group.choices).collect(),
        _ => Vec::new(),
    }
}

// oracle: hand (whoever shows a choice writes its number before the name)
#[test]
fn the_name_of_a_choice_does_not_repeat_its_number() {
    for language in LANGUAGES {
        let words = Words::of(language.code).unwrap();
        for cycle in CYCLES {
            for variant in cycle.variants {
                let mut typed = worked(cycle);
                if let Some(name) = cycle.variant_param() {
                    typed.insert(name.to_string(), variant.number.to_string());
                }
                let fields = fields(cycle, &typed, &delivery(cycle.dialect));
                for choice in fields.into_iter().flat_map(|field| choices(field.entry)) {
                    let text = words.find(&choice.label).unwrap();
                    let begins_with_name = !text.starts_with(|first: char| first.is_ascii_digit());
                    assert!(begins_with_name, "{}: {} {text}", cycle.name, choice.value);
                }
            }
        }
    }
}

// oracle: hand
#[test]
fn what_is_written_beside_a_drawing_has_words() {
    let words = Words::english();
    let [real, off] = labels::dimension([0.0; 3], true, [40.0, 39.9], None, Units::Metric);
    let said = |label: &Label| words.text(&label.text[0]);
    assert_eq!([said(&real), said(&off)], ["Ø39.900", "Ø40.000 −0.100"]);
    let at = |moved| Frame { name: "G54".to_owned(), at: [0.0; 3], axes: UNITS, moved };
    for (moved, wanted) in [(None, "G54"), (Some("before"), "G54 before"), (Some("after"), "G54 after")] {
        assert_eq!(said(&labels::frames(&[at(moved)])[0]), wanted);
    }
    let crash = Step::Crash { point: Mcs([0.0; 3]), normal: Dir::default(), by: Touching::Stylus };
    let entries = [TraceEntry { line: None, step: crash, in_use: 0 }].into_iter().collect();
    assert_eq!(said(&labels::collisions(&entries)[0]), "Crash: stylus");
}
