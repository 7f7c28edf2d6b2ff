//! The targets that are offered.

use super::{code, codes, entry, has, typed, values, with, words};
use probewright_core::diagnostic::Code;
use probewright_core::form::Entry;

fn numbers(entry: Entry) -> Vec<i64> {
    match entry {
        Entry::Choice { choices } => choices.iter().map(|one| one.value).collect(),
        Entry::Digits { digits: groups } => {
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
        let word = words(&text).into_iter().find(|word| word.starts_with("_KNUM="));
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

// oracle: manual B:12503 (targets), hand
#[test]
fn a_target_that_is_not_offered_is_told() {
    let text = "_MVAR=101 _SETVAL=50 _KNUM=9999\nCYCLE977\n";
    assert_eq!(codes(text, &with(1, 0)), [Code::Own(143)]);
    assert_eq!(codes(text, &with(1, 1)), []);
}
