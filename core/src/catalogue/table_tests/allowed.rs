//! The language in which the tables say what is allowed: `>0`, `0..359.5`, `1, 2, 3`, `0,1..99,1000`.

/// What a cell allows, as far as numbers say it. What stands in words beside them (other parameters, alarms) is passed
/// over.
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

/// Reads a cell; none where it says in words what is allowed.
pub fn allowed(cell: &str) -> Option<Allowed> {
    let outside = without_brackets(cell);
    let first = outside.split(';').next()?.trim();
    let first = first.split(" accuracy").next()?.trim().trim_end_matches(',');
    match first.split([' ', ',']).next()? {
        "any" | "signed" => return Some(Allowed::Any),
        "<>0" => return Some(Allowed::AnyBut(0.0)),
        _ => {}
    }
    if let Some(least) = first.strip_prefix(">=") {
        return Some(match range_in_brackets(cell) {
            Some(range) => Allowed::Ranges(vec![range]),
            None => Allowed::From(number(least)?, true),
        });
    }
    if let Some(least) = first.strip_prefix('>') {
        return Some(Allowed::From(number(least)?, false));
    }
    // `0; 1..99; 1000`: each part is numbers again. `0 none; 1..9999: number of the memory` says the rest in words.
    let parts: Vec<Vec<(f64, f64)>> = outside.split(';').map(|part| items(part.trim())).collect();
    let all: Vec<(f64, f64)> = if parts.iter().all(|part| !part.is_empty()) { parts.concat() } else { items(first) };
    let worded = parts.len() > 1 && all.len() == 1 && all.iter().all(|(from, to)| from == to);
    (!all.is_empty() && !worded).then_some(Allowed::Ranges(all))
}

/// `1 abscissa, 2 ordinate`, `0 plus, 1 minus`, `3 only`, `3 or 4`, `0..359.5`; empty where a part is none of these.
fn items(text: &str) -> Vec<(f64, f64)> {
    let text = text.replace(" or ", ",");
    let text = text.split(", else").next().unwrap_or_default();
    let each: Option<Vec<(f64, f64)>> = text.split(',').map(|one| item(one.trim())).collect();
    each.unwrap_or_default()
}

fn item(text: &str) -> Option<(f64, f64)> {
    if let Some((from, to)) = text.split_once("..") {
        return Some((number(from)?, number(to)?));
    }
    let (value, word) = text.split_once(' ').unwrap_or((text, ""));
    let named = word.chars().all(|c| c.is_ascii_alphabetic() || c == ' ');
    let value = number(value).filter(|_| named)?;
    Some((value, value))
}

fn number(text: &str) -> Option<f64> {
    let text = text.trim();
    let digits = text.trim_start_matches(['+', '-']);
    let plain = digits.bytes().all(|byte| byte.is_ascii_digit() || byte == b'.');
    // A code with digits left out (`0xy`) or leading zeros is no number.
    (plain && !digits.is_empty()).then(|| text.parse().ok()).flatten()
}

fn range_in_brackets(cell: &str) -> Option<(f64, f64)> {
    let inner = cell.split_once('(')?.1.split_once(')')?.0;
    inner.contains("..").then(|| item(inner)).flatten()
}

fn without_brackets(cell: &str) -> String {
    let mut depth = 0;
    let kept = cell.chars().filter(|c| {
        depth += i32::from(*c == '(');
        let outside = depth == 0;
        depth -= i32::from(*c == ')');
        outside
    });
    kept.collect()
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
    let ranges = |ranges: &[(f64, f64)]| Some(Allowed::Ranges(ranges.to_vec()));
    let list = |numbers: &[f64]| ranges(&numbers.iter().map(|one| (*one, *one)).collect::<Vec<_>>());
    for (cell, meaning) in [
        (">0 (0 gives 61318)", Some(Allowed::From(0.0, false))),
        (">=0; 0: 150/300", Some(Allowed::From(0.0, true))),
        (">=0 (0..6)", ranges(&[(0.0, 6.0)])),
        (">=1", Some(Allowed::From(1.0, true))),
        ("signed, any", Some(Allowed::Any)),
        ("<>0; sign = direction", Some(Allowed::AnyBut(0.0))),
        ("0..359.5", ranges(&[(0.0, 359.5)])),
        ("-360..+360 (A.1 type column: 0..360)", ranges(&[(-360.0, 360.0)])),
        ("-179.5..+179.5 (lost), 0 gives 61347, accuracy <10 deg", None),
        ("1 abscissa, 2 ordinate", list(&[1.0, 2.0])),
        ("0 positive, 1 negative; else alarm 61326", list(&[0.0, 1.0])),
        ("3 only", list(&[3.0])),
        ("3 or 4 (else 61317)", list(&[3.0, 4.0])),
        ("0,1..99,1000", ranges(&[(0.0, 0.0), (1.0, 99.0), (1000.0, 1000.0)])),
        ("0; 1..99; 1000", ranges(&[(0.0, 0.0), (1.0, 99.0), (1000.0, 1000.0)])),
        ("0..6, else alarm 61406", ranges(&[(0.0, 6.0)])),
        ("0 none; 1..9999: number of the memory", None),
        ("xy or 1xy", None),
        ("tool name", None),
        ("-", None),
    ] {
        assert_eq!(allowed(cell), meaning, "{cell}");
    }
    let gap = allowed("0,1..99,1000").unwrap();
    assert_eq!(gap.wrong(), [-1.0, 100.0, 999.0, 1001.0]);
}
