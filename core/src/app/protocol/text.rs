//! The lines of a protocol in fields, and the figures in them, whatever wrote it: the log of a control, a table.

use crate::control::Units;
use crate::foreign::{self, Log, LogRow};

/// A line of a protocol.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Index of the file.
    pub file: usize,
    /// Number of the line, from 1.
    pub number: u32,
    /// As it is.
    pub text: String,
    /// Its fields without the blanks around them.
    pub fields: Vec<String>,
    /// Units of the calls in one unit of its figures.
    pub factor: f64,
    /// Smallest and largest permissible value where the log has them, in the unit of the calls.
    pub limits: Option<[f64; 2]>,
}

/// A figure with as many decimals as it has.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Figure {
    /// Value.
    pub value: f64,
    /// Half of its last digit.
    pub half: f64,
}

/// Lines from which it is told what parts the fields.
const LOOKED_AT: usize = 200;
/// Units that may stand behind a figure.
const UNITS: [&str; 5] = ["mm", "inch", "in", "°", "deg"];

/// The lines in which something stands; of the log of a control whose figures stand in groups, a line each quantity.
/// `units`: those of the calls.
pub fn lines(file: usize, text: &str, units: Units) -> Vec<Line> {
    let text = text.trim_start_matches('\u{feff}');
    if let Some((_, logs)) = foreign::logs(text) {
        return logs.into_iter().flat_map(|log| of_log(file, log, units)).collect();
    }
    let parted = parted(text);
    let numbered = text.lines().zip(1..).filter(|(line, _)| line.contains(char::is_alphanumeric));
    let read = |(line, number): (&str, u32)| {
        let (text, fields) = (line.to_owned(), fields(line, parted));
        Line { file, number, text, fields, factor: 1.0, limits: None }
    };
    numbered.map(read).collect()
}

/// What parts the fields, none: blanks. The sign at which most lines have several figures; where no line has, that of
/// more than half of the lines, a comma of any line.
fn parted(text: &str) -> Option<char> {
    if let Some(own) = text.lines().find_map(of_heading) {
        return own;
    }
    let lines = || text.lines().filter(|line| line.contains(char::is_alphanumeric)).take(LOOKED_AT);
    let several = |sign: Option<char>| {
        let figures = |line: &&str| fields(line, sign).iter().filter_map(|field| Figure::of(field)).count();
        lines().filter(|line| figures(line) > 1).count()
    };
    let signs = [Some(';'), Some('\t'), Some(','), None].map(|sign| (sign, several(sign)));
    let most = signs.iter().map(|(_, count)| *count).max().unwrap_or_default();
    if let Some((sign, _)) = signs.into_iter().find(|(_, count)| most > 0 && *count == most) {
        return sign;
    }
    [';', '\t', ','].into_iter().find(|sign| {
        let with = lines().filter(|line| line.contains(*sign)).count();
        2 * with > lines().count() || (*sign == ',' && with > 0)
    })
}

/// What parts the fields of a log of the control: it stands between cycle, `_MVAR` and its number (B:11486-11512).
/// Other lines have what their programmer wrote.
fn of_heading(line: &str) -> Option<Option<char>> {
    let (before, behind) = line.split_once("_MVAR")?;
    let (before, behind) = (before.trim_end(), behind.trim_start());
    let sign = behind.chars().next().filter(|sign| !sign.is_alphanumeric());
    let number = behind.strip_prefix(sign.unwrap_or(' ')).unwrap_or(behind).trim();
    let name = before.strip_suffix(sign.unwrap_or(' ')).or_else(|| sign.is_none().then_some(before))?.trim();
    let fits = number.parse::<i64>().is_ok() && !name.is_empty() && name.chars().all(char::is_alphanumeric);
    fits.then_some(sign)
}

/// The quantities of such a log, which says the unit of its lengths.
fn of_log(file: usize, log: Log, units: Units) -> Vec<Line> {
    let own = if log.is_inch { Units::Inch } else { Units::Metric };
    let lengths = own.factor() / units.factor();
    let of_row = |row: LogRow| of_row(file, row, lengths);
    log.rows.into_iter().map(of_row).collect()
}

/// A quantity of such a log: its name, set value, actual value and deviation.
fn of_row(file: usize, row: LogRow, lengths: f64) -> Line {
    let factor = if row.label.to_ascii_lowercase().contains("angle") { 1.0 } else { lengths };
    let limit = |text: &str| Some(Figure::of(text)?.times(factor).value);
    let limits = limit(&row.minimum).zip(limit(&row.maximum)).map(|(low, high)| [low, high]);
    let fields = vec![row.label, row.nominal, row.actual, row.deviation];
    Line { file, number: row.line, text: fields.join(" "), fields, factor, limits }
}

impl Line {
    /// A field as a figure in the unit of the calls; none: it is none.
    pub fn figure(&self, field: &str) -> Option<Figure> {
        Figure::of(field).map(|figure| figure.times(self.factor))
    }
}

/// The fields of a line, in quotes or not; without a sign between them blanks part them.
fn fields(line: &str, parted: Option<char>) -> Vec<String> {
    let Some(parted) = parted else { return line.split_whitespace().map(str::to_owned).collect() };
    let mut fields = vec![String::new()];
    let mut quoted = false;
    for c in line.chars() {
        match c {
            '"' => quoted = !quoted,
            _ if c == parted && !quoted => fields.push(String::new()),
            _ => {
                if let Some(last) = fields.last_mut() {
                    last.push(c);
                }
            }
        }
    }
    fields.into_iter().map(|field| field.trim().to_owned()).collect()
}

impl Figure {
    /// The figure that a field is: with a sign, a decimal point or comma, and behind it a unit or the mark of a value
    /// beyond its limits (B:11439-11441).
    pub fn of(field: &str) -> Option<Figure> {
        let plain = field.trim_start_matches(['Ø', '\'', '+']).trim_start().replace('−', "-").replace(',', ".");
        let digits = |c: char| c.is_ascii_digit() || c == '.';
        let signed = plain.strip_prefix('-').unwrap_or(&plain);
        let end = plain.len() - signed.len() + signed.find(|c| !digits(c)).unwrap_or(signed.len());
        let (number, behind) = plain.split_at_checked(end)?;
        let behind = behind.trim();
        let marked = behind.chars().count() == 1 && !behind.contains(char::is_alphanumeric) && behind != ":";
        if !(behind.is_empty() || marked || UNITS.contains(&behind)) || !number.contains(|c: char| c.is_ascii_digit()) {
            return None;
        }
        let decimals = number.split_once('.').map_or(0, |(_, decimals)| decimals.len());
        let value = number.parse().ok().filter(|value: &f64| value.abs() < 1e9)?;
        Some(Figure { value, half: 0.5 * 0.1_f64.powi(decimals.min(12) as i32) })
    }

    /// The same in another unit, with no more decimals than it says there.
    fn times(self, factor: f64) -> Figure {
        if factor == 1.0 {
            return self;
        }
        let half = self.half * factor;
        let digit = 10.0_f64.powf(half.log10().floor());
        Figure { value: (self.value * factor / digit).round() * digit, half: half + digit / 2.0 }
    }

    /// Whether this value, rounded to so many decimals, is the figure.
    pub fn is(self, value: f64) -> bool {
        (self.value - value).abs() <= self.half * 1.02 + 1e-9
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    // oracle: manual B:11437-11441 (a log as delivered: values parted by a semicolon, below titles and a header)
    #[test]
    fn the_lines_with_figures_say_what_parts_them() {
        let header = "Date : 2026/11/30\nProgram : HOLE\nPart number: 12\nSupervisor: A, B\nMeas. , Set , Act. value\n";
        for (text, sign) in [
            (format!("{header}132.000 ; 132.130# ; 0.130#\n"), Some(';')),
            ("call,set,actual\n1,132,132.13\n".to_owned(), Some(',')),
            ("call;set;actual\n1;132,000;132,130\n".to_owned(), Some(';')),
            ("132.000 132.130 0.130\n".to_owned(), None),
            ("a\t132.000\t132.130\n".to_owned(), Some('\t')),
            ("name;actual\nbore;132.1\n".to_owned(), Some(';')),
        ] {
            assert_eq!(parted(&text), sign, "{text}");
        }
    }
}
