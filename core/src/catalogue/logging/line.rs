//! What is in `_PROTVAL[2]` to `_PROTVAL[5]`: fields parted by commas, whatever separates them in the log
//! (B:11375); and the columns in which they are printed.

use crate::control::{Control, variables::AXES};

/// A field of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Field<'a> {
    /// The time, `hh:mm:ss`.
    Time,
    /// Name of an axis: that of `_MA`, or the one with this place in the plane.
    Axis(Option<usize>),
    /// A number: a result or an R parameter.
    Number(&'a str),
    /// A text in `_TXT[]`.
    Text(&'a str),
    /// A text that is printed as it stands.
    Comment(&'a str),
    /// A datum that no log can show: alarm 61361.
    Unknown(&'a str),
}

/// Fields of `_OVR[]` (B:2380).
pub const RESULTS: usize = 32;
/// Texts of `_TXT[]` (B:11360).
const TEXTS: usize = 100;
/// Characters of the time.
const TIME: usize = 8;
/// Width of a column where the titles give none, characters (A:15945).
const FIXED: usize = 12;
/// Most decimals that are printed: more than a number has.
const DECIMALS: usize = 15;

impl Field<'_> {
    /// Characters that it needs, where they are known.
    pub fn width(&self) -> Option<usize> {
        match self {
            Field::Time => Some(TIME),
            Field::Comment(text) => Some(text.chars().count()),
            Field::Axis(_) | Field::Number(_) | Field::Text(_) | Field::Unknown(_) => None,
        }
    }
}

/// The fields of a line.
pub fn fields(line: &str) -> impl Iterator<Item = Field<'_>> {
    line.split(',').map(|text| field(text.trim()))
}

/// Widths of the columns, characters.
#[derive(Clone, Debug, PartialEq)]
pub struct Columns {
    /// One by one, as the first title line has them.
    titled: Vec<usize>,
    /// All others.
    fixed: usize,
}

impl Columns {
    /// Each as wide as this number; 0: as many characters as between the commas of the title (B:11437).
    pub fn new(width: f64, title: &str) -> Columns {
        let titled = if width >= 1.0 || title.is_empty() { Vec::new() } else { widths(title).collect() };
        Columns { titled, fixed: if width >= 1.0 { width as usize } else { FIXED } }
    }

    /// Width of a column, from 0.
    pub fn width(&self, column: usize) -> usize {
        self.titled.get(column).copied().unwrap_or(self.fixed)
    }

    /// Width of the columns of this line.
    pub fn total(&self, line: &str) -> usize {
        (0..fields(line).count()).map(|column| self.width(column)).fold(0, usize::saturating_add)
    }

    /// Texts in their columns. As in the sample of the manual a blank stands behind the separator where the column has
    /// room for it (B:11521-11528); a text that is wider has its column wider (B:11437), and the last one ends.
    pub fn line(&self, texts: &[String], separator: &str) -> String {
        let mut line = String::new();
        for (column, text) in texts.iter().enumerate() {
            let (width, count) = (self.width(column), text.chars().count());
            if column > 0 {
                line.push_str(separator);
                line.push_str(if count < width { " " } else { "" });
            }
            line.push_str(text);
            if column + 1 < texts.len() {
                let led = usize::from(column > 0 && count < width);
                line.extend(std::iter::repeat_n(' ', width.saturating_sub(count + led).min(LONGEST)));
            }
        }
        line
    }

    /// Whether a text is wider than its column.
    pub fn narrow(&self, column: usize, text: &str) -> bool {
        text.chars().count() > self.width(column)
    }
}

/// Longest line of a log, characters (A:15947).
pub const LONGEST: usize = 200;

/// Widths of the columns that a title line makes where they are not fixed: characters between its commas (B:11437).
pub fn widths(title: &str) -> impl Iterator<Item = usize> {
    title.split(',').map(|text| text.chars().count())
}

/// A number with so many decimals, exact halves away from 0. A 0 has no sign.
pub fn rounded(value: f64, decimals: f64) -> String {
    let decimals = decimals.clamp(0.0, DECIMALS as f64) as usize;
    let value = if is_half(value, decimals) { away(value) } else { value };
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(zero) if zero.bytes().all(|byte| matches!(byte, b'0' | b'.')) => zero.to_owned(),
        _ => text,
    }
}

/// Whether a text is a number with so many decimals as [`rounded`] makes it.
pub fn is_printed(text: &str, decimals: f64) -> bool {
    let decimals = decimals.clamp(0.0, DECIMALS as f64) as usize;
    let text = text.strip_prefix('-').unwrap_or(text);
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit());
    match text.split_once('.') {
        None => decimals == 0 && digits(text),
        Some((whole, behind)) => behind.len() == decimals && digits(whole) && digits(behind),
    }
}

/// Whether a number lies exactly between two with so many decimals: it then has one decimal more, and as many binary
/// places as that.
fn is_half(value: f64, decimals: usize) -> bool {
    let scaled = value * (1_u64 << (decimals + 1)) as f64;
    scaled.fract() == 0.0 && (scaled % 2.0).abs() == 1.0
}

/// The next number that is farther from 0.
fn away(value: f64) -> f64 {
    if value < 0.0 { value.next_down() } else { value.next_up() }
}

/// What a field prints on this control; none: it cannot be printed.
pub fn printed(field: Field, control: &Control, time: &str) -> Option<String> {
    let axis = |place: usize| AXES.get(control.plane.axes().get(place).copied()?).map(|name| (*name).to_owned());
    Some(match field {
        Field::Time => time.to_owned(),
        Field::Axis(Some(place)) => axis(place)?,
        Field::Axis(None) => {
            let digit = control.number("_MA") as i64 % 10; // a digit before it is the offset axis (B:1862-1868)
            usize::try_from(digit - 1).ok().and_then(axis).unwrap_or_default()
        }
        Field::Number(name) => {
            rounded(control.number(&name.to_ascii_uppercase()), control.number(super::names::DIGITS.as_str()))
        }
        Field::Text(name) => control.text(&name.to_ascii_uppercase()).to_owned(),
        Field::Comment(text) => text.to_owned(),
        Field::Unknown(_) => return None,
    })
}

/// Names of user data begin with `_`; of these the log knows the following (B:11377-11400).
pub fn field(text: &str) -> Field<'_> {
    let upper = text.to_ascii_uppercase();
    match upper.as_str() {
        "_TIME" => Field::Time,
        "_AXIS" => Field::Axis(None),
        "_AXIS1" => Field::Axis(Some(0)),
        "_AXIS2" => Field::Axis(Some(1)),
        "_AXIS3" => Field::Axis(Some(2)),
        _ if result(&upper).is_some() => Field::Number(text),
        _ if element(&upper, "_TXT").is_some_and(|index| index < TEXTS) => Field::Text(text),
        _ if register(&upper) => Field::Number(text),
        _ if upper.starts_with(['_', '$']) => Field::Unknown(text),
        _ => Field::Comment(text),
    }
}

/// Place of a result: 4 of `_OVR[4]`, in capitals; none: it is another datum.
pub fn result(upper: &str) -> Option<usize> {
    element(upper, "_OVR").filter(|index| *index < RESULTS)
}

/// Index of `_OVR[4]`; written without blanks and zeros before it, as the control's own names are.
fn element(text: &str, array: &str) -> Option<usize> {
    let digits = text.strip_prefix(array)?.strip_prefix('[')?.strip_suffix(']')?;
    plain(digits).then(|| digits.parse().ok()).flatten()
}

/// `R27`.
fn register(text: &str) -> bool {
    plain(text.strip_prefix('R').unwrap_or_default())
}

/// A number as a name has it.
fn plain(digits: &str) -> bool {
    let number = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
    number && (digits == "0" || !digits.starts_with('0'))
}

#[cfg(test)]
mod tests {
    use super::*;

    // oracle: hand: decimal arithmetic, halves away from 0; 1.005 is below its half as a binary number
    #[test]
    fn exact_halves_are_rounded_away_from_zero() {
        let texts = [
            (2.5, 0.0, "3"),
            (0.5, 0.0, "1"),
            (-0.5, 0.0, "-1"),
            (1.5, 0.0, "2"),
            (0.125, 2.0, "0.13"),
            (-0.125, 2.0, "-0.13"),
            (0.0625, 3.0, "0.063"),
            (0.0625, 4.0, "0.0625"),
            (0.499, 0.0, "0"),
            (-0.25, 0.0, "0"),
            (1.005, 2.0, "1.00"),
            (1e22, 1.0, "10000000000000000000000.0"),
        ];
        for (value, decimals, text) in texts {
            assert_eq!(rounded(value, decimals), text, "{value} {decimals}");
        }
        // each multiple of 1/128 against whole numbers: 10^n/128 with its rest decides
        for (count, decimals) in (0..1000_u64).flat_map(|count| (0..5_u32).map(move |decimals| (count, decimals))) {
            let units = (count * 10_u64.pow(decimals) + 64) / 128;
            let whole = 10_u64.pow(decimals);
            let text = match decimals {
                0 => units.to_string(),
                _ => format!("{}.{:0width$}", units / whole, units % whole, width = decimals as usize),
            };
            assert_eq!(rounded(count as f64 / 128.0, f64::from(decimals)), text, "{count}/128");
        }
    }

    #[test]
    fn the_examples_of_the_manual() {
        // oracle: manual B:11408-11411
        let kinds: Vec<Field> = fields("_AXIS,_OVR[1],_axis2,R27,_TXT[99],_TIME, INCH,").collect();
        let expected = [
            Field::Axis(None),
            Field::Number("_OVR[1]"),
            Field::Axis(Some(1)),
            Field::Number("R27"),
            Field::Text("_TXT[99]"),
            Field::Time,
            Field::Comment("INCH"),
            Field::Comment(""),
        ];
        assert_eq!(kinds, expected);
        for unknown in ["_OVI[2]", "_OVR[32]", "_SETVAL", "$AA_IW[X]", "_TXT[100]"] {
            let first = fields(unknown).next();
            assert_eq!(first, Some(Field::Unknown(unknown)));
        }
        assert_eq!(widths("Meas. , Axis").collect::<Vec<_>>(), [6, 5]);
    }

    // oracle: manual B:11296-11320 (rounded, a zero before the point), hand (no sign at a zero)
    #[test]
    fn numbers_are_rounded() {
        let pi = std::f64::consts::PI;
        let texts = [100.0 / pi, 0.1 / pi, 1.0 / pi, 10.0 / pi].map(|value| rounded(value, 3.0));
        assert_eq!(texts, ["31.831", "0.032", "0.318", "3.183"]);
        assert_eq!([rounded(-0.0004, 3.0), rounded(-0.6, 0.0), rounded(2.0, -1.0)], ["0.000", "-1", "2"]);
    }

    // oracle: manual B:11437 (widths), B:11521-11528 (the blank behind the separator)
    #[test]
    fn texts_stand_in_their_columns() {
        let texts = ["1", "X", "64.000", "12345"].map(str::to_owned);
        assert_eq!(Columns::new(6.0, "").line(&texts, ","), "1     , X    ,64.000, 12345");
        assert_eq!(Columns::new(0.0, "ab,c,d,e").line(&texts, ";"), "1 ;X;64.000;12345");
        let twelve = Columns::new(0.0, "");
        assert_eq!((twelve.width(7), twelve.total("a,b")), (12, 24));
        assert!(Columns::new(5.0, "").narrow(2, "64.000") && !twelve.narrow(2, "64.000"));
    }
}
