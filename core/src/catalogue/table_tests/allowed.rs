//! The language in which the tables say what is allowed: `>0`, `0..359.5`, `1,2,3`, `0,1..99,1000`; behind it in
//! brackets the alarm for what is not.

use crate::diagnostic::Code;

/// What a cell allows.
#[derive(Debug, PartialEq)]
pub enum Allowed {
    /// Numbers and closed ranges.
    Ranges(Vec<(f64, f64)>),
    /// Above the number; with it or not.
    From(f64, bool),
    /// Any number but this one.
    AnyBut(f64),
    /// Any number.
    Any,
}

/// Reads a cell, and the alarm behind it; none where numbers do not say it.
pub fn allowed(cell: &str) -> Option<(Allowed, Option<Code>)> {
    let (values, alarm) = cell.split_once(" (").unwrap_or((cell, ""));
    let alarm = alarm.strip_suffix(')').map(|number| Code::Alarm(number.parse().unwrap()));
    let number = |text: &str| -> f64 { text.parse().unwrap_or_else(|_| panic!("{cell}")) };
    let range = |one: &str| match one.split_once("..") {
        Some((from, to)) => (number(from), number(to)),
        None => (number(one), number(one)),
    };
    let allowed = match values {
        "-" => return None,
        "any" => Allowed::Any,
        _ if values.starts_with("<>") => Allowed::AnyBut(number(&values[2..])),
        _ if values.starts_with(">=") => Allowed::From(number(&values[2..]), true),
        _ if values.starts_with('>') => Allowed::From(number(&values[1..]), false),
        _ => Allowed::Ranges(values.split(',').map(range).collect()),
    };
    Some((allowed, alarm))
}

impl Allowed {
    /// Values at the end of what is allowed.
    pub fn right(&self) -> Vec<f64> {
        match self {
            Allowed::Ranges(ranges) => ranges.iter().flat_map(|(from, to)| [*from, *to]).collect(),
            Allowed::From(least, true) => vec![*least],
            Allowed::From(_, false) => vec![],
            Allowed::AnyBut(one) => vec![one - 1.0, one + 1.0],
            Allowed::Any => vec![-1.0, 0.0],
        }
    }

    /// Values just outside of it.
    pub fn wrong(&self) -> Vec<f64> {
        match self {
            Allowed::Ranges(ranges) => {
                let beside = ranges.iter().flat_map(|(from, to)| [from - 1.0, to + 1.0]);
                beside.filter(|value| !self.holds(*value)).collect()
            }
            Allowed::From(least, true) => vec![least - 1.0],
            Allowed::From(least, false) => vec![*least, least - 1.0],
            Allowed::AnyBut(one) => vec![*one],
            Allowed::Any => vec![],
        }
    }

    fn holds(&self, value: f64) -> bool {
        match self {
            Allowed::Ranges(ranges) => ranges.iter().any(|(from, to)| (*from..=*to).contains(&value)),
            _ => true,
        }
    }
}

#[test]
fn cells_are_understood() {
    // oracle: hand
    let ranges = |ranges: &[(f64, f64)]| Allowed::Ranges(ranges.to_vec());
    for (cell, meaning, alarm) in [
        (">0 (61318)", Allowed::From(0.0, false), Some(61318)),
        (">=1", Allowed::From(1.0, true), None),
        ("any", Allowed::Any, None),
        ("<>0", Allowed::AnyBut(0.0), None),
        ("0..359.5", ranges(&[(0.0, 359.5)]), None),
        ("-360..360", ranges(&[(-360.0, 360.0)]), None),
        ("3", ranges(&[(3.0, 3.0)]), None),
        ("3,4 (61317)", ranges(&[(3.0, 3.0), (4.0, 4.0)]), Some(61317)),
        ("0,1..99,1000", ranges(&[(0.0, 0.0), (1.0, 99.0), (1000.0, 1000.0)]), None),
    ] {
        assert_eq!(allowed(cell), Some((meaning, alarm.map(Code::Alarm))), "{cell}");
    }
    assert_eq!(allowed("-"), None);
    let (gap, _) = allowed("0,1..99,1000").unwrap();
    assert_eq!(gap.wrong(), [-1.0, 100.0, 999.0, 1001.0]);
}
