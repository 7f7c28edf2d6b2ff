//! Each entry of the mask: the fields and the code that it decides.

use super::{DELIVERED, code, cycle, has, machine, shown, typed, values, with, written};
use probewright_core::entry::Style;
use probewright_core::support::Support;

/// A row of the manual's table: cycle and variant, entry, its value, fields that are there, fields that are not, words
/// that are written.
type Row =
    ((&'static str, i64), (usize, u8), &'static [&'static str], &'static [&'static str], &'static [&'static str]);

// oracle: manual B:12467-12558, row by row
const ROWS: &[Row] = &[
    (("CYCLE977", 1), (2, 0), &["_FA"], &["_VMS", "_NMSP"], &["_VMS=0", "_NMSP=1"]),
    (("CYCLE977", 1), (2, 1), &["_VMS", "_NMSP"], &[], &["_VMS=200", "_NMSP=3"]),
    (("CYCLE971", 1), (2, 0), &["_FA"], &["_VMS", "_NMSP"], &["_VMS=0", "_NMSP=1"]),
    (("CYCLE977", 1), (3, 0), &[], &["_EVNUM"], &["_EVNUM=0"]),
    (("CYCLE977", 1), (3, 1), &["_EVNUM"], &["_TMV", "_K"], &["_EVNUM=10", "_CHBIT[4]=0", "_K=1"]),
    (("CYCLE971", 1), (3, 0), &["_TDIF"], &["_EVNUM"], &["_EVNUM=0"]),
    (("CYCLE971", 1), (3, 1), &["_EVNUM"], &[], &["_EVNUM=10"]),
    (("CYCLE971", 1), (4, 1), &["_TDIF"], &["_EVNUM"], &["_EVNUM=0"]),
    (("CYCLE977", 1), (4, 0), &["_TUL"], &["_TMV", "_K", "_EVNUM"], &["_K=1", "_EVNUM=0", "_CHBIT[4]=0", "_TMV=0.02"]),
    (("CYCLE977", 1), (4, 1), &["_TMV", "_K", "_EVNUM"], &[], &["_K=2", "_EVNUM=10", "_CHBIT[4]=1", "_TMV=0.5"]),
    (("CYCLE974", 0), (4, 0), &["_TUL"], &["_TMV", "_K", "_EVNUM"], &["_CHBIT[4]=0"]),
    (("CYCLE977", 101), (4, 0), &["_TSA"], &["_TMV", "_K", "_EVNUM"], &["_FA=2"]),
    (("CYCLE977", 1), (5, 0), &["_PRNUM"], &["_CORA"], &["_PRNUM=1"]),
    (("CYCLE977", 1), (5, 1), &["_PRNUM", "_CORA"], &[], &["_PRNUM=101", "_CORA=3"]),
    (("CYCLE971", 1), (5, 1), &["_PRNUM"], &["_CORA"], &["_PRNUM=1"]),
    (("CYCLE971", 2), (7, 0), &["_MA"], &["_MFS[0]", "_MFS[5]"], &["_CBIT[12]=0"]),
    (("CYCLE971", 2), (7, 1), &["_MFS[0]", "_MFS[5]"], &[], &["_CBIT[12]=1", "_MFS[0]=800", "_MFS[5]=0"]),
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
        Support::of(cycle(name), &control).unwrap().style(cycle(name))
    };
    assert_eq!(style("CYCLE977", 0), Style::Indirect);
    assert_eq!(style("CYCLE977", 1), Style::Direct);
    // oracle: manual B:11708 (no parameterizing call)
    assert_eq!(style("CYCLE982", 0), Style::Direct);
    let text = written("CYCLE977", &values("CYCLE977", 1), &with(0, 0), Style::Indirect).text;
    let lines: Vec<&str> = text.lines().filter(|line| !line.starts_with(';')).collect();
    let [.., auxiliary, call] = lines.as_slice() else {
        panic!("{text}");
    };
    assert!(auxiliary.starts_with("CYCLE_PARA("), "{text}");
    assert!(call.starts_with("CYCLE_977_979A(977,"), "{text}");
}
