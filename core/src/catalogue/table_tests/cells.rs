//! The language in which the tables name variants: `all`, `1..6, 101`, `xx0x08`, `d1=1,d6=0; 0,10`.

/// Whether a cell of the tables means this variant.
pub fn covers(cell: &str, variant: i64) -> bool {
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
        ("0,10; d1=1,d6=0", 12_101, 112_101),
        ("0xxx", 105, 1005),
        ("0 with _MA=3", 0, 3),
        ("all measuring variants", 102, 10),
        ("1; 2 outside", 1, 2),
        ("d1=1,d5=1; d1=8,d5=1", 10_008, 10_000),
    ] {
        assert!(covers(cell, inside), "{cell} {inside}");
        assert!(outside < 0 || !covers(cell, outside), "{cell} {outside}");
    }
    assert_eq!(with_condition("x1x1x9 and _KNUM>0"), ("x1x1x9", "_KNUM>0"));
    assert_eq!(with_condition("2,4 and all 1xxx"), ("2,4 and all 1xxx", ""));
}
