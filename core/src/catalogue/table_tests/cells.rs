//! The language in which the tables name variants: `all`, `1..6, 101`, `xx0x08`, `d1=1,d6=0; 0,10`.

/// Cells that say in words what patterns cannot; as patterns.
const IN_WORDS: &[(&str, &str)] = &[
    ("xxx1x01, xx01x08 types with d3=1", "d3=1"),
    ("d5=1 (hole)", "d1=1,d5=1; d1=8,d5=1"),
    // which of them, the meaning of the row tells
    ("the calibrated axis/direction(s)", "all"),
    // compared without a value of _KNUM
    ("1 sphere, or _KNUM=0", "all"),
    ("3-sphere variants (d5=1)", "d5=1"),
];

/// Whether a cell of the tables means this variant. Text in brackets explains and is passed over.
pub fn covers(cell: &str, variant: i64) -> bool {
    let worded = IN_WORDS.iter().find(|(words, _)| *words == cell);
    let cell = without_brackets(worded.map_or(cell, |(_, patterns)| patterns));
    cell.split(';').any(|part| {
        // `0 with _MA=3`: the axis stands in the row's condition too.
        let part = part.split(" with ").next().unwrap().trim();
        if part.contains('=') {
            part.split(',').all(|digit| digit_is(digit.trim(), variant))
        } else {
            let numbers = part.replace(" and ", ",");
            numbers.split(',').any(|one| one_of(one.trim(), variant))
        }
    })
}

/// Cells that say in words what numbers cannot.
fn special(cell: &str, variant: i64) -> Option<bool> {
    match cell {
        "all" | "any" | "-" => Some(true),
        "all 1xxx" => Some(variant / 1000 == 1),
        "all measuring variants" => Some((1..=2).contains(&(variant % 10))),
        _ => None,
    }
}

fn without_brackets(cell: &str) -> String {
    let mut depth = 0;
    let mut text = String::new();
    for c in cell.chars() {
        match c {
            '(' => depth += 1,
            ')' => depth -= 1,
            _ if depth == 0 => text.push(c),
            _ => {}
        }
    }
    text.trim().to_owned()
}

/// `d6=0`: the sixth digit from the right.
fn digit_is(text: &str, variant: i64) -> bool {
    let (place, value) = text.trim_start_matches('d').split_once('=').unwrap();
    let place: u32 = place.parse().unwrap();
    variant / 10_i64.pow(place - 1) % 10 == value.parse::<i64>().unwrap()
}

/// A number, a range, or a pattern whose x stand for any digit.
fn one_of(text: &str, variant: i64) -> bool {
    if let Some(known) = special(text, variant) {
        return known;
    }
    if let Some((from, to)) = text.split_once("..") {
        let last = |end: &str| end.trim_start_matches('x').parse::<i64>().unwrap();
        let compared = if from.starts_with('x') { variant % 10 } else { variant };
        return (last(from)..=last(to)).contains(&compared);
    }
    if text.contains('x') {
        return text.bytes().rev().enumerate().all(|(place, sign)| {
            let digit = variant / 10_i64.pow(place as u32) % 10;
            sign == b'x' || i64::from(sign - b'0') == digit
        });
    }
    text.parse() == Ok(variant)
}

/// `x1x1x9 and _KNUM>0`: variants, and a condition on a parameter; empty where there is none.
pub fn with_condition(cell: &str) -> (&str, &str) {
    match cell.split_once(" and _") {
        Some((variants, condition)) => (variants, &cell[cell.len() - condition.len() - 1..]),
        None => (cell, ""),
    }
}

#[test]
fn cells_are_understood() {
    // oracle: hand
    for (cell, inside, outside) in [
        ("all", 5, -1),
        ("1..6, 1001..1006", 1003, 7),
        ("xxx5, xxx6", 1105, 1104),
        ("xx0x08", 110_108, 101_008),
        ("0,10; d1=1,d6=0 (24 values)", 12_101, 112_101),
        ("0xxx (1..6,101..106)", 105, 1005),
        ("0 with _MA=3", 0, 3),
        ("all measuring variants (d1=1 or 2)", 102, 10),
        ("1; 2 outside", 1, 2),
        ("d5=1 (hole)", 10_008, 10_000),
    ] {
        assert!(covers(cell, inside), "{cell} {inside}");
        assert!(outside < 0 || !covers(cell, outside), "{cell} {outside}");
    }
    assert_eq!(with_condition("x1x1x9 and _KNUM>0"), ("x1x1x9", "_KNUM>0"));
    assert_eq!(with_condition("2,4 and all 1xxx"), ("2,4 and all 1xxx", ""));
}
