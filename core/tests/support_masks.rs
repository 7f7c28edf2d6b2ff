//! Forms and code with the settings of the control's own support, and what is said when a program is read back under
//! other ones (B:12412-12558).
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use probewright_core::catalogue::{
    CYCLES, Cycle, Dialect, ProbeUse, Style, example::example, find,
};
use probewright_core::check::{self, Parsed, Typed, parse};
use probewright_core::control::{Control, delivery};
use probewright_core::diagnostic::{Code, Diagnostic};
use probewright_core::form::{Entry, fields};
use probewright_core::program::calls::calls_on;
use probewright_core::program::change::apply;
use probewright_core::program::write::{Written, snippet};
use probewright_core::program::{findings_on, read};
use probewright_core::support::{self, Support};
use proptest::prelude::*;

/// As delivered (B:12501-12539).
const DELIVERED: [u8; 8] = [1, 0, 0, 0, 0, 0, 0, 0];

fn machine(mask: [u8; 8]) -> Control {
    let mut control = delivery(Dialect::Sinumerik);
    control.set(support::FORMS, 1.0);
    for (entry, value) in mask.into_iter().enumerate() {
        control.set(support::name(entry), f64::from(value));
    }
    control
}

/// The delivered mask with one entry.
fn with(entry: usize, value: u8) -> Control {
    let mut mask = DELIVERED;
    mask[entry] = value;
    machine(mask)
}

fn cycle(name: &str) -> &'static Cycle {
    find(Dialect::Sinumerik, name).unwrap()
}

fn typed(pairs: &str) -> Typed {
    let pair = |word: &str| {
        let (name, value) = word.split_once('=').unwrap();
        (name.to_owned(), value.to_owned())
    };
    pairs.split_whitespace().map(pair).collect()
}

/// The worked measurement of a variant of a cycle.
fn values(name: &str, variant: i64) -> Typed {
    let variants = cycle(name).variants.iter();
    let variant = variants.into_iter().find(|one| one.number == variant);
    example(cycle(name), variant.unwrap())
}

fn written(name: &str, values: &Typed, control: &Control, style: Style) -> Written {
    snippet(cycle(name), values, control, style, None)
}

fn code(name: &str, values: &Typed, control: &Control) -> String {
    written(name, values, control, Style::Direct).text
}

/// Assignments of a text, in order.
fn words(text: &str) -> Vec<String> {
    let lines = text.lines().filter(|line| !line.starts_with(';'));
    let words = lines.flat_map(str::split_whitespace);
    words.map(str::to_owned).collect()
}

fn has(text: &str, word: &str) -> bool {
    words(text).iter().any(|one| one == word)
}

fn shown(name: &str, values: &Typed, control: &Control) -> Vec<&'static str> {
    let entered = Support::of(cycle(name), control).map(|support| {
        let mut control = control.clone();
        let entered = support.entered(cycle(name), values, &control);
        entered.write(&mut control);
        fields(cycle(name), &entered.values, &control)
    });
    let fields = entered.unwrap_or_else(|| fields(cycle(name), values, control));
    fields.iter().map(|field| field.name).collect()
}

fn entry(name: &str, values: &Typed, control: &Control, field: &str) -> Entry {
    let all = fields(cycle(name), values, control);
    all.into_iter().find(|one| one.name == field).unwrap().entry
}

fn said(text: &str, control: &Control) -> Vec<Diagnostic> {
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let mut found = findings_on(&program, control.clone());
    found.retain(|one| matches!(one.code, Code::Own(140..=143)));
    found
}

fn codes(text: &str, control: &Control) -> Vec<Code> {
    said(text, control).iter().map(|one| one.code).collect()
}

/// A row of the manual's table: cycle and variant, entry, its value, fields that are there, fields that are not, words
/// that are written.
type Row = (
    (&'static str, i64),
    (usize, u8),
    &'static [&'static str],
    &'static [&'static str],
    &'static [&'static str],
);

// oracle: manual B:12467-12558, row by row
const ROWS: &[Row] = &[
    (
        ("CYCLE977", 1),
        (2, 0),
        &["_FA"],
        &["_VMS", "_NMSP"],
        &["_VMS=0", "_NMSP=1"],
    ),
    (
        ("CYCLE977", 1),
        (2, 1),
        &["_VMS", "_NMSP"],
        &[],
        &["_VMS=200", "_NMSP=3"],
    ),
    (
        ("CYCLE971", 1),
        (2, 0),
        &["_FA"],
        &["_VMS", "_NMSP"],
        &["_VMS=0", "_NMSP=1"],
    ),
    (("CYCLE977", 1), (3, 0), &[], &["_EVNUM"], &["_EVNUM=0"]),
    (
        ("CYCLE977", 1),
        (3, 1),
        &["_EVNUM"],
        &["_TMV", "_K"],
        &["_EVNUM=10", "_CHBIT[4]=0", "_K=1"],
    ),
    (
        ("CYCLE971", 1),
        (3, 0),
        &["_TDIF"],
        &["_EVNUM"],
        &["_EVNUM=0"],
    ),
    (("CYCLE971", 1), (3, 1), &["_EVNUM"], &[], &["_EVNUM=10"]),
    (
        ("CYCLE971", 1),
        (4, 1),
        &["_TDIF"],
        &["_EVNUM"],
        &["_EVNUM=0"],
    ),
    (
        ("CYCLE977", 1),
        (4, 0),
        &["_TUL"],
        &["_TMV", "_K", "_EVNUM"],
        &["_K=1", "_EVNUM=0", "_CHBIT[4]=0", "_TMV=0.02"],
    ),
    (
        ("CYCLE977", 1),
        (4, 1),
        &["_TMV", "_K", "_EVNUM"],
        &[],
        &["_K=2", "_EVNUM=10", "_CHBIT[4]=1", "_TMV=0.5"],
    ),
    (
        ("CYCLE974", 0),
        (4, 0),
        &["_TUL"],
        &["_TMV", "_K", "_EVNUM"],
        &["_CHBIT[4]=0"],
    ),
    (
        ("CYCLE977", 101),
        (4, 0),
        &["_TSA"],
        &["_TMV", "_K", "_EVNUM"],
        &["_FA=2"],
    ),
    (
        ("CYCLE977", 1),
        (5, 0),
        &["_PRNUM"],
        &["_CORA"],
        &["_PRNUM=1"],
    ),
    (
        ("CYCLE977", 1),
        (5, 1),
        &["_PRNUM", "_CORA"],
        &[],
        &["_PRNUM=101", "_CORA=3"],
    ),
    (
        ("CYCLE971", 1),
        (5, 1),
        &["_PRNUM"],
        &["_CORA"],
        &["_PRNUM=1"],
    ),
    (
        ("CYCLE971", 2),
        (7, 0),
        &["_MA"],
        &["_MFS[0]", "_MFS[5]"],
        &["_CBIT[12]=0"],
    ),
    (
        ("CYCLE971", 2),
        (7, 1),
        &["_MFS[0]", "_MFS[5]"],
        &[],
        &["_CBIT[12]=1", "_MFS[0]=800", "_MFS[5]=0"],
    ),
];

/// What is typed in every row.
const TYPED: &str = "_FA=2 _VMS=200 _NMSP=3 _EVNUM=10 _K=2 _TMV=0.5 _TUL=0.03 _TLL=-0.03 _CORA=3 _PRNUM=1 _MFS[0]=800";

#[test]
fn each_entry_decides_fields_and_code_as_the_manual_says() {
    for ((name, variant), (entry, value), there, absent, code_words) in ROWS {
        let control = with(*entry, *value);
        let mut values = values(name, *variant);
        values.extend(typed(TYPED));
        let what = format!("{name} {variant} _MZ_MASK[{entry}]={value}");
        let shown = shown(name, &values, &control);
        let text = code(name, &values, &control);
        for field in *there {
            assert!(shown.contains(field), "{what}: no {field} in {shown:?}");
        }
        for field in *absent {
            assert!(!shown.contains(field), "{what}: {field}");
        }
        for word in *code_words {
            assert!(has(&text, word), "{what}: no {word} in {text}");
        }
    }
}

// oracle: manual B:12518-12532 (automatic tool offset), B:12537-12539 (tool measurement)
#[test]
fn the_bits_are_written_only_where_they_count() {
    let control = machine(DELIVERED);
    for (name, variant, bit, there) in [
        ("CYCLE977", 1, "_CHBIT[4]=0", true),
        ("CYCLE977", 101, "_CHBIT[4]=0", false),
        ("CYCLE998", 105, "_CHBIT[4]=0", false),
        ("CYCLE971", 1, "_CHBIT[4]=0", false),
        ("CYCLE971", 1, "_CBIT[12]=0", true),
        ("CYCLE971", 0, "_CBIT[12]=0", false),
        ("CYCLE977", 1, "_CBIT[12]=0", false),
    ] {
        let text = code(name, &values(name, variant), &control);
        assert_eq!(has(&text, bit), there, "{name} {variant} {bit}\n{text}");
    }
}

// oracle: manual B:12501-12502
#[test]
fn the_first_entry_chooses_the_way_of_writing() {
    let style = |name: &str, value| {
        let control = with(0, value);
        Support::of(cycle(name), &control)
            .unwrap()
            .style(cycle(name))
    };
    assert_eq!(style("CYCLE977", 0), Style::Indirect);
    assert_eq!(style("CYCLE977", 1), Style::Direct);
    // oracle: manual B:11708 (no parameterizing call)
    assert_eq!(style("CYCLE982", 0), Style::Direct);
    let text = written(
        "CYCLE977",
        &values("CYCLE977", 1),
        &with(0, 0),
        Style::Indirect,
    )
    .text;
    let lines: Vec<&str> = text.lines().filter(|line| !line.starts_with(';')).collect();
    let [.., auxiliary, call] = lines.as_slice() else {
        panic!("{text}");
    };
    assert!(auxiliary.starts_with("CYCLE_PARA("), "{text}");
    assert!(call.starts_with("CYCLE_977_979A(977,"), "{text}");
}

fn numbers(entry: Entry) -> Vec<i64> {
    match entry {
        Entry::Choice(choices) => choices.iter().map(|one| one.value).collect(),
        Entry::Digits(groups) => {
            let choices = groups.iter().flat_map(|group| &group.choices);
            choices.map(|one| one.value).collect()
        }
        _ => Vec::new(),
    }
}

// oracle: manual B:12503-12504
#[test]
fn the_second_entry_limits_the_targets() {
    let zero = |value| {
        let values = values("CYCLE977", 101);
        numbers(entry("CYCLE977", &values, &with(1, value), "_KNUM"))
    };
    assert_eq!(zero(0), (0..=99).chain([1000]).collect::<Vec<i64>>());
    for code in [9999, 1011, 1051, 2000] {
        assert!(zero(1).contains(&code), "{code}");
    }
    let kinds = |name, variant, value| {
        let values = values(name, variant);
        numbers(entry(name, &values, &with(1, value), "_KNUM"))
    };
    assert_eq!(kinds("CYCLE977", 1, 0), [2], "radius");
    assert_eq!(kinds("CYCLE974", 0, 0), [0], "length in the measuring axis");
    assert!(kinds("CYCLE977", 1, 1).len() > 10);
    let knum = |name: &str, number: &str| {
        let mut values = typed(&format!("_KNUM={number} _TNUM=1"));
        values.insert("_MVAR".into(), "0".into());
        if name == "CYCLE977" {
            values.insert("_MVAR".into(), "1".into());
        }
        let text = code(name, &values, &with(1, 0));
        let word = words(&text)
            .into_iter()
            .find(|word| word.starts_with("_KNUM="));
        word.unwrap()["_KNUM=".len()..].to_owned()
    };
    for (name, number, after) in [
        ("CYCLE977", "2002", "2002"),
        ("CYCLE977", "12003", "2003"),
        ("CYCLE977", "1102004", "2004"),
        ("CYCLE977", "0", "0"),
        ("CYCLE974", "12003", "3"),
        ("CYCLE974", "1003", "1003"), // the same as 3 (B:1907)
    ] {
        assert_eq!(knum(name, number), after, "{name} {number}");
    }
}

// oracle: manual B:2009-2029 (five digits of the edge), B:12503
#[test]
fn flat_edges_have_the_same_choice() {
    let mut control = with(1, 0);
    control.set("MD18102", 1.0);
    let values = typed("_MVAR=1 _SETVAL=50 _KNUM=1212345 _TNUM=1");
    let text = code("CYCLE977", &values, &control);
    assert!(has(&text, "_KNUM=212345"), "{text}");
    let kinds = numbers(entry("CYCLE977", &values, &control, "_KNUM"));
    assert_eq!(kinds, [2]);
}

/// The manual's sample, repaired as in the tables: B:12414-12423, A:13686-13701.
const SAMPLE: &str = "_MVAR=1001 _SETVAL=100.000 _PRNUM=101
    _KNUM=2002 _FA=2 _TSA=0.23
    _VMS=0 _NMSP=1 _ID=-20.000 _SZA=50.000
    _CORA=0.03 _TZL=0.01 _TDIF=0.2 _TUL=0.065
    _TLL=-0.065 _CHBIT[4]=0 _K=1 _EVNUM=2 _TNUM=1
    CYCLE977";

/// A word with its number as it is worth.
fn plain(word: &str) -> String {
    match word.split_once('=') {
        Some((name, value)) => format!("{name}={}", value.parse::<f64>().unwrap()),
        None => word.to_owned(),
    }
}

// oracle: manual B:12414-12423. The sample lacks _TMV, which B:12523 wants; the screens show where it stands (B:12160).
#[test]
fn the_manuals_sample_is_written() {
    let mut mask = DELIVERED;
    for entry in [1, 3, 5] {
        mask[entry] = 1; // _KNUM, _EVNUM=2, _PRNUM=101 with _CORA
    }
    let control = machine(mask);
    let sample: Vec<String> = SAMPLE.split_whitespace().map(plain).collect();
    let (_, assignments) = sample.split_last().unwrap();
    let mut typed = typed(&assignments.join(" "));
    typed.retain(|name, _| !["_VMS", "_NMSP", "_CHBIT[4]", "_K"].contains(&&**name));
    let text = code("CYCLE977", &typed, &control);
    let mut ours = words(&text);
    let limit = ours
        .iter()
        .position(|word| word.starts_with("_TMV="))
        .unwrap();
    assert_eq!(ours.remove(limit), "_TMV=0.043333"); // hand: 0.13 / 3
    assert_eq!(ours, sample);
    assert_eq!(ours[limit - 1], "_CHBIT[4]=0", "position as on the screens");
}

// oracle: manual B:12154-12163: block ends and all words of the screens, the cut-off _TMV completed (0.5 / 3)
#[test]
fn the_block_of_the_screens_is_written() {
    let values = typed(
        "_MVAR=1 _SETVAL=100 _PRNUM=1 _KNUM=2002 _FA=2 _TSA=0.23 _TZL=0.1 _TDIF=0.02 _TUL=0.25 _TLL=-0.25 _TNUM=1",
    );
    let text = code("CYCLE977", &values, &machine(DELIVERED));
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(
        lines,
        [
            "; _MZ_MASK=1,0,0,0,0,0,0,0 MD18102=0 MD18080=256",
            // _KNUM=2 there; the radius, which is all that is offered, is 2002 (B:12503, B:1911)
            "_MVAR=1 _SETVAL=100 _PRNUM=1 _KNUM=2002 _FA=2 _TSA=0.23 _VMS=0 _NMSP=1",
            "_TZL=0.1 _TDIF=0.02 _TUL=0.25 _TLL=-0.25 _CHBIT[4]=0 _TMV=0.166667 _K=1 _EVNUM=0 _TNUM=1",
            "CYCLE977",
        ]
    );
}

// oracle: manual B:12523 (the formula, where the limits are known at run time only)
#[test]
fn limits_of_the_program_make_a_formula() {
    let mut values = values("CYCLE977", 1);
    values.insert("_TUL".into(), "R1".into());
    let text = code("CYCLE977", &values, &machine(DELIVERED));
    assert!(has(&text, "_TMV=ABS(_TUL-_TLL)/3"), "{text}");
}

// oracle: hand (nothing changes for who did not choose it)
#[test]
fn without_the_choice_the_mask_decides_nothing() {
    let mut control = machine([0, 0, 0, 0, 0, 1, 0, 1]);
    control.set(support::FORMS, 0.0);
    let plain = delivery(Dialect::Sinumerik);
    for cycle in CYCLES
        .iter()
        .filter(|cycle| cycle.dialect == Dialect::Sinumerik)
    {
        for variant in cycle.variants {
            let values = example(cycle, variant);
            let text = |control| snippet(cycle, &values, control, Style::Direct, None).text;
            assert_eq!(text(&control), text(&plain), "{}", cycle.name);
            let ours = fields(cycle, &values, &control);
            assert_eq!(ours, fields(cycle, &values, &plain), "{}", cycle.name);
        }
    }
}

// oracle: manual B:12549-12553
#[test]
fn a_call_that_the_settings_would_change_is_told_and_mended() {
    let control = machine(DELIVERED);
    for (added, name, change) in [
        ("_VMS=200", "CYCLE977", "_VMS=200 → 0"),
        ("_CHBIT[4]=1", "CYCLE977", "_CHBIT[4]=1 → 0"),
        ("_EVNUM=7", "CYCLE977", "_EVNUM=7 → 0"),
        ("_PRNUM=102", "CYCLE977", "_PRNUM=102 → 2"),
        ("_KNUM=102002", "CYCLE977", "_KNUM=102002 → 2002"),
        ("_CBIT[12]=1", "CYCLE971", "_CBIT[12]=1 → 0"),
    ] {
        let values = values(name, 1);
        let own = code(name, &values, &control);
        assert_eq!(codes(&own, &control), [], "{own}");
        let (before, call) = own.trim_end().rsplit_once('\n').unwrap();
        let text = format!("{before}\n{added}\n{call}\n");
        let said = said(&text, &control);
        let [finding] = said.as_slice() else {
            panic!("{added}: {said:?}");
        };
        assert_eq!(finding.code, Code::Own(140));
        let told = format!("{:?}", finding.message);
        assert!(told.contains(change), "{told}");
        let mended = apply(text.as_bytes(), &finding.cure.as_ref().unwrap().edits);
        let mended = String::from_utf8(mended).unwrap();
        assert_eq!(codes(&mended, &control), [], "{mended}");
    }
}

// oracle: manual B:12549-12558
#[test]
fn a_change_between_writing_and_reading_back_is_told() {
    let text = code("CYCLE977", &values("CYCLE977", 1), &machine(DELIVERED));
    let mean = with(4, 1);
    let said_now = said(&text, &mean);
    let list: Vec<Code> = said_now.iter().map(|one| one.code).collect();
    assert_eq!(list, [Code::Own(141), Code::Own(140)]);
    let told = format!("{:?}", said_now[0].message);
    assert!(told.contains("_MZ_MASK[4]: 0 → 1"), "{told}");
    let taken = apply(text.as_bytes(), &said_now[1].cure.as_ref().unwrap().edits);
    assert_eq!(codes(&String::from_utf8(taken).unwrap(), &mean), []);
    // a field more, and nothing else to write
    let feed = with(2, 1);
    let said_now = said(&text, &feed);
    assert_eq!(said_now.len(), 1);
    let noted = apply(text.as_bytes(), &said_now[0].cure.as_ref().unwrap().edits);
    assert_eq!(codes(&String::from_utf8(noted).unwrap(), &feed), []);
    for (datum, value) in [("MD18102", 1.0), ("MD18080", 3.0)] {
        let mut control = machine(DELIVERED);
        control.set(datum, value);
        assert!(codes(&text, &control).contains(&Code::Own(142)), "{datum}");
        control.set(support::FORMS, 0.0);
        assert_eq!(codes(&text, &control), [Code::Own(142)], "{datum}");
    }
}

// oracle: hand (a call that says nothing is not this support's, nor is one of newer controls)
#[test]
fn other_programs_are_left_alone() {
    let mut control = machine([1, 1, 1, 1, 1, 0, 0, 1]);
    assert_eq!(codes("G17\nT1 D1\n_MVAR=105\nCYCLE998\n", &control), []);
    control.set(support::FORMS, 0.0);
    assert_eq!(
        codes("_MVAR=1 _VMS=200 _KNUM=12003\nCYCLE977\n", &control),
        []
    );
}

// oracle: manual B:12503 (targets), hand
#[test]
fn a_target_that_is_not_offered_is_told() {
    let text = "_MVAR=101 _SETVAL=50 _KNUM=9999\nCYCLE977\n";
    assert_eq!(codes(text, &with(1, 0)), [Code::Own(143)]);
    assert_eq!(codes(text, &with(1, 1)), []);
}

fn measuring() -> Vec<(&'static Cycle, i64)> {
    let cycles = CYCLES.iter().copied();
    let cycles = cycles.filter(|cycle| {
        cycle.dialect == Dialect::Sinumerik && cycle.purpose.probe != ProbeUse::None
    });
    let variants =
        cycles.flat_map(|cycle| cycle.variants.iter().map(move |one| (cycle, one.number)));
    variants.collect()
}

fn same(one: &str, other: &str) -> bool {
    match (parse(one), parse(other)) {
        (Parsed::Number(one), Parsed::Number(other)) => (one - other).abs() < 1e-6,
        _ => one == other,
    }
}

proptest! {
    // oracle: self
    #[test]
    fn what_is_written_is_read_and_nothing_is_said(
        which in 0usize..1000, mask: [bool; 8], indirect: bool, feed in 0u32..500, tolerance in 1u32..100, memory in 0u32..20, mono: bool,
    ) {
        let all = measuring();
        let (cycle, variant) = all[which % all.len()];
        let control = machine(mask.map(u8::from));
        let mut typed = values(cycle.name, variant);
        typed.extend(self::typed(&format!("_VMS={feed} _TUL=0.{tolerance:02} _TLL=-0.{tolerance:02} _EVNUM={memory} _PRNUM={}", 1 + 100 * u32::from(mono))));
        let style = if indirect { Style::Indirect } else { Style::Direct };
        let text = snippet(cycle, &typed, &control, style, None).text;
        prop_assume!(!text.is_empty());
        let program = read(Dialect::Sinumerik, text.as_bytes());
        let sites = calls_on(&program, control.clone());
        prop_assert_eq!(sites.len(), 1);
        let support = Support::of(cycle, &control).unwrap();
        let entered = support.entered(cycle, &typed, &control);
        let inputs = check::read(cycle, &entered.values, &control, &mut Vec::new());
        for param in cycle.params.iter().filter(|param| param.need(&inputs).is_some()) {
            let Some(value) = entered.values.get(param.name).filter(|text| !text.is_empty()) else { continue };
            let back = sites[0].values.get(param.name).map_or("", String::as_str);
            prop_assert!(same(value, back), "{} {} {value} {back}\n{text}", cycle.name, param.name);
        }
        for (name, on) in &entered.bits {
            let back = sites[0].bits.iter().find(|(one, ..)| one == name);
            prop_assert_eq!(back.map(|(_, text, _)| &**text), Some(if *on { "1" } else { "0" }));
        }
        let said = codes(&text, &control);
        prop_assert!(said.iter().all(|code| *code == Code::Own(143)), "{said:?}\n{text}");
    }
}
