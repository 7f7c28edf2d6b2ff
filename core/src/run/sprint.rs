//! `SPRINT("SIZE %9.3F, %D PARTS", R1, N)`: values in a text, each where the pattern has a place for it.

use super::Datum;

/// A place for a value: `%-9.3F`.
struct Place {
    left: bool,
    zeros: bool,
    sign: bool,
    width: usize,
    decimals: Option<usize>,
    kind: char,
}

/// Widest place, characters.
const WIDEST: usize = 200;

/// The pattern with the values at its places; none: they do not fit.
pub fn filled(pattern: &str, values: &[Datum]) -> Option<String> {
    let (mut text, mut rest, mut values) = (String::new(), pattern.chars().peekable(), values.iter());
    while let Some(one) = rest.next() {
        match one {
            '%' if rest.next_if_eq(&'%').is_some() => text.push('%'),
            '%' => text.push_str(&place(&mut rest)?.with(values.next()?)?),
            one => text.push(one),
        }
    }
    values.next().is_none().then_some(text)
}

fn place(rest: &mut std::iter::Peekable<std::str::Chars>) -> Option<Place> {
    let mut place = Place { left: false, zeros: false, sign: false, width: 0, decimals: None, kind: ' ' };
    while let Some(flag) = rest.next_if(|one| "-0+ #".contains(*one)) {
        match flag {
            '-' => place.left = true,
            '0' => place.zeros = true,
            '+' => place.sign = true,
            _ => {}
        }
    }
    place.width = number(rest).unwrap_or(0).min(WIDEST);
    if rest.next_if_eq(&'.').is_some() {
        place.decimals = Some(number(rest).unwrap_or(0).min(WIDEST));
    }
    rest.next_if(|one| "lLh".contains(*one));
    place.kind = rest.next()?.to_ascii_uppercase();
    Some(place)
}

fn number(rest: &mut std::iter::Peekable<std::str::Chars>) -> Option<usize> {
    let mut digits = String::new();
    while let Some(digit) = rest.next_if(char::is_ascii_digit) {
        digits.push(digit);
    }
    digits.parse().ok()
}

impl Place {
    fn with(&self, value: &Datum) -> Option<String> {
        let text = match self.kind {
            'F' => self.signed(value.number()?, |number| format!("{number:.*}", self.decimals.unwrap_or(6))),
            'E' => self.signed(value.number()?, |number| exponent(number, self.decimals.unwrap_or(6))),
            'G' | 'P' => self.signed(value.number()?, |number| Datum::Number(number).shown()),
            'D' | 'I' | 'U' => self.signed(value.number()?.round(), |number| format!("{number:.0}")),
            'X' => format!("{:X}", value.number()? as i64),
            'B' => (if value.number()? == 0.0 { "FALSE" } else { "TRUE" }).to_owned(),
            'C' => value.character()?.to_string(),
            'S' | 'A' => {
                let text = value.shown();
                text.chars().take(self.decimals.unwrap_or(text.len())).collect()
            }
            _ => return None,
        };
        Some(self.padded(&text))
    }

    fn signed(&self, number: f64, show: impl Fn(f64) -> String) -> String {
        let shown = show(number);
        if self.sign && !shown.starts_with('-') { format!("+{shown}") } else { shown }
    }

    fn padded(&self, text: &str) -> String {
        let width = self.width;
        let zeros = self.zeros && !self.left && "FEGPDIUX".contains(self.kind);
        match text.strip_prefix(['-', '+']).filter(|_| zeros) {
            _ if self.left => format!("{text:<width$}"),
            Some(digits) => {
                let (sign, width) = (&text[..1], width.saturating_sub(1));
                format!("{sign}{digits:0>width$}")
            }
            None if zeros => format!("{text:0>width$}"),
            None => format!("{text:>width$}"),
        }
    }
}

/// `1.5E+003` as the control writes it.
fn exponent(number: f64, decimals: usize) -> String {
    let text = format!("{number:.decimals$E}");
    let (mantissa, power) = text.split_once('E').unwrap_or((&text, "0"));
    let power: i32 = power.parse().unwrap_or(0);
    format!("{mantissa}E{}{:03}", if power < 0 { '-' } else { '+' }, power.abs())
}

#[cfg(test)]
mod tests {
    use super::*;

    // oracle: hand
    #[test]
    fn each_place_takes_its_value() {
        let number = Datum::Number;
        for (pattern, values, text) in [
            ("X=%9.3F;", vec![number(12.3456)], "X=   12.346;"),
            (
                "%-6.1f|%+d|%05d|%05d",
                vec![number(2.0), number(3.0), number(-4.0), number(5.0)],
                "2.0   |+3|-0004|00005",
            ),
            ("%s: %x %c 100%%", vec![Datum::Text("A".into()), number(255.0), Datum::Char(66)], "A: FF B 100%"),
            ("%.1E", vec![number(1500.0)], "1.5E+003"),
            ("%B", vec![number(1.0)], "TRUE"),
        ] {
            assert_eq!(filled(pattern, &values).as_deref(), Some(text), "{pattern}");
        }
        for (pattern, values) in
            [("%d", vec![]), ("", vec![number(1.0)]), ("%F", vec![Datum::Text("A".into())]), ("%", vec![number(1.0)])]
        {
            assert_eq!(filled(pattern, &values), None, "{pattern}");
        }
    }
}
