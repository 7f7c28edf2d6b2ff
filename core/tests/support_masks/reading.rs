//! What is said when a program is read back, and what is left alone.

use super::{DELIVERED, code, codes, machine, said, typed, values, with};
use probewright_core::catalogue::CYCLES;
use probewright_core::catalogue::example::example;
use probewright_core::check::{Parsed, parse};
use probewright_core::control::delivery;
use probewright_core::diagnostic::Code;
use probewright_core::dialect::Dialect;
use probewright_core::entry::{Cycle, ProbeUse, Style};
use probewright_core::form::fields;
use probewright_core::program::calls::calls_on;
use probewright_core::program::change::apply;
use probewright_core::program::write::snippet;
use probewright_core::support::Support;
use probewright_core::syntax::read;
use probewright_core::{check, support};
use proptest::prelude::*;

// oracle: hand (nothing changes for who did not choose it)
#[test]
fn without_the_choice_the_mask_decides_nothing() {
    let mut control = machine([0, 0, 0, 0, 0, 1, 0, 1]);
    control.set(support::FORMS, 0.0);
    let plain = delivery(Dialect::Sinumerik);
    for cycle in CYCLES.iter().filter(|cycle| cycle.dialect == Dialect::Sinumerik) {
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
    assert_eq!(codes("_MVAR=1 _VMS=200 _KNUM=12003\nCYCLE977\n", &control), []);
}

fn measuring() -> Vec<(&'static Cycle, i64)> {
    let cycles = CYCLES.iter().copied();
    let cycles = cycles.filter(|cycle| cycle.dialect == Dialect::Sinumerik && cycle.purpose.probe != ProbeUse::None);
    let variants = cycles.flat_map(|cycle| cycle.variants.iter().map(move |one| (cycle, one.number)));
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
        which in 0usize..1000, mask: [bool; 8], indirect: bool, feed in 0u32..500, tolerance in 1u32..100,
        memory in 0u32..20, mono: bool,
    ) {
        let all = measuring();
        let (cycle, variant) = all[which % all.len()];
        let control = machine(mask.map(u8::from));
        let mut typed = values(cycle.name, variant);
        let probe = 1 + 100 * u32::from(mono);
        let band = format!("_TUL=0.{tolerance:02} _TLL=-0.{tolerance:02}");
        typed.extend(self::typed(&format!("_VMS={feed} {band} _EVNUM={memory} _PRNUM={probe}")));
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
            let Some(value) = entered.values.get(param.name.as_str()).filter(|text| !text.is_empty()) else { continue };
            let back = sites[0].values.get(param.name.as_str()).map_or("", String::as_str);
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
