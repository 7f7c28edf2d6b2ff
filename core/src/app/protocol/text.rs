//! The lines of a protocol in fields, and the figures in them, whatever wrote it: the log of a control, a table.

use crate::catalogue::log::{self, Layout, Unmarked};
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
    /// Why its fields are none, or may be others: the key of what is told, where nothing else says what they are.
    pub fault: Option<Fault>,
    /// What parts its fields; none: blanks.
    pub parted: Option<char>,
    /// Units of the calls in one unit of its figures.
    pub factor: f64,
    /// Smallest and largest permissible value where the log has them, in the unit of the calls.
    pub limits: Option<[f64; 2]>,
    /// Whether it is of a log that the cycles of the control wrote.
    pub own: bool,
}

/// A figure with as many decimals as it has.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Figure {
    /// Value.
    pub value: f64,
    /// Half of its last digit.
    pub half: f64,
}

/// Why the fields of a line are not what they seem.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// A quote is opened and not closed.
    Quote,
    /// What parts its fields could be the comma of its decimals.
    Comma,
}

/// Most lines in which a field in quotes goes on.
const GOES_ON: usize = 50;
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
    let own = log::is_log(text) || text.lines().any(|line| of_heading(line).is_some());
    let physical: Vec<&str> = text.lines().collect();
    let (mut read, mut at) = (Vec::new(), 0);
    while at < physical.len() {
        let (number, whole) = (at as u32 + 1, record(&physical[at..], parted));
        at += whole.lines;
        if whole.text.contains(char::is_alphanumeric) {
            let fault = if whole.is_open { Some(Fault::Quote) } else { is_cut(&whole, parted).then_some(Fault::Comma) };
            let Record { text, fields, .. } = whole;
            read.push(Line { file, number, text, fields, fault, parted, factor: 1.0, limits: None, own });
        }
    }
    read
}

/// A line of a table, which goes on in further lines of the file where a field in quotes has a line break.
struct Record {
    text: String,
    fields: Vec<String>,
    lines: usize,
    is_open: bool,
}

/// The first record of these lines. One whose quote is not closed is its first line alone, so that no other is lost.
fn record(lines: &[&str], parted: Option<char>) -> Record {
    let first = lines.first().copied().unwrap_or_default();
    let mut text = first.to_owned();
    let split = |text: &str| match parted {
        Some(sign) if text.contains('"') => of_quotes(text, sign),
        Some(sign) => Split::Whole(text.split(sign).map(|field| field.trim().to_owned()).collect()),
        None => Split::Whole(text.split_whitespace().map(str::to_owned).collect()),
    };
    for count in 1..=GOES_ON.min(lines.len()) {
        match split(&text) {
            Split::Whole(fields) => return Record { text, fields, lines: count, is_open: false },
            Split::Open => text.extend(lines.get(count).map(|next| format!("\n{next}"))),
            Split::Wrong => break,
        }
    }
    let fields = fields(first, parted);
    Record { text: first.to_owned(), fields, lines: 1, is_open: true }
}

/// Whether the figures of a line may be cut at the comma of their decimals: whole numbers, with nothing but a comma
/// between two of them, and none with a decimal point.
fn is_cut(record: &Record, parted: Option<char>) -> bool {
    let figures = || record.fields.iter().filter(|field| Figure::of(field).is_some());
    let digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
    let tight = |(at, _): (usize, &str)| {
        digit(record.text[..at].chars().next_back()) && digit(record.text[at + 1..].chars().next())
    };
    parted == Some(',')
        && record.text.match_indices(',').any(tight)
        && figures().count() > 1
        && !figures().any(|field| field.contains('.') || field.contains(','))
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
    let signs = [Some(';'), Some('\t'), Some('|'), Some(','), None].map(|sign| (sign, several(sign)));
    let most = signs.iter().map(|(_, count)| *count).max().unwrap_or_default();
    if let Some((sign, _)) = signs.into_iter().find(|(_, count)| most > 0 && *count == most) {
        return sign;
    }
    [';', '\t', '|', ','].into_iter().find(|sign| {
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
    let (text, parted) = (fields.join(" "), Some(';'));
    Line { file, number: row.line, text, fields, fault: None, parted, factor, limits, own: false }
}

/// A mark that no number has (B:11355).
const MARK: char = '#';

impl Line {
    /// The same, where its log has marks of its own: with the same one behind each number that has one.
    pub fn marked_alike(&self, layout: &Layout) -> Line {
        let alike = |field: &String| match layout.unmarked(field) {
            Unmarked::Before(number) => format!("{number}{MARK}"),
            Unmarked::Plain | Unmarked::Either => field.clone(),
        };
        Line { fields: self.fields.iter().map(alike).collect(), ..self.clone() }
    }

    /// A field as a figure in the unit of the calls; none: it is none.
    pub fn figure(&self, field: &str) -> Option<Figure> {
        Figure::of(field).map(|figure| figure.times(self.factor))
    }

    /// The fields that are figures, in the unit of the calls.
    pub fn figures(&self) -> impl Iterator<Item = Figure> {
        self.fields.iter().filter_map(|field| self.figure(field))
    }
}

/// The fields of a line, in quotes or not; without a sign between them blanks part them.
fn fields(line: &str, parted: Option<char>) -> Vec<String> {
    let Some(sign) = parted else { return line.split_whitespace().map(str::to_owned).collect() };
    match of_quotes(line, sign) {
        Split::Whole(fields) => fields,
        Split::Open | Split::Wrong => line.split(sign).map(|field| field.trim().to_owned()).collect(),
    }
}

/// A text in fields.
enum Split {
    Whole(Vec<String>),
    /// Its end is within quotes.
    Open,
    /// Something else than the end of the field stands behind the closing quote.
    Wrong,
}

/// The fields of a text in which quotes stand around some, and are written twice within them (RFC 4180, 2).
fn of_quotes(text: &str, sign: char) -> Split {
    let mut fields = Vec::new();
    let mut rest = text;
    loop {
        let behind = rest.trim_start_matches(|c: char| c.is_whitespace() && c != sign);
        let end = if let Some(quoted) = behind.strip_prefix('"') {
            let Some((field, end)) = closed(quoted) else { return Split::Open };
            fields.push(field.trim().to_owned());
            let end = end.trim_start_matches(|c: char| c.is_whitespace() && c != sign);
            if !(end.is_empty() || end.starts_with(sign)) {
                return Split::Wrong;
            }
            end
        } else {
            let (field, end) = rest.split_at(rest.find(sign).unwrap_or(rest.len()));
            fields.push(field.trim().to_owned());
            end
        };
        let Some(next) = end.strip_prefix(sign) else { return Split::Whole(fields) };
        rest = next;
    }
}

/// What stands before the closing quote, and what behind it.
fn closed(quoted: &str) -> Option<(String, &str)> {
    let mut field = String::new();
    let mut rest = quoted;
    loop {
        let (part, behind) = rest.split_once('"')?;
        field.push_str(part);
        let Some(next) = behind.strip_prefix('"') else { return Some((field, behind)) };
        field.push('"');
        rest = next;
    }
}

impl Figure {
    /// The figure that a field is: with a sign, a decimal point or comma, a sign between thousands where only one
    /// reading is possible, and behind it a unit or the mark of a value beyond its limits (B:11439-11441).
    pub fn of(field: &str) -> Option<Figure> {
        let plain = field.trim_start_matches(['Ø', '\'', '+']).trim_start();
        let (sign, plain) = plain.strip_prefix(['-', '−']).map_or((1.0, plain), |plain| (-1.0, plain));
        let run = plain.find(|c: char| !(c.is_ascii_digit() || is_between(c))).unwrap_or(plain.len());
        // a point belongs to the figure, any other sign behind its last digit does not
        let run = plain[..run].trim_end_matches(|c| is_between(c) && c != '.');
        let behind = plain[run.len()..].trim();
        let marked = behind.chars().count() == 1 && !behind.contains(char::is_alphanumeric) && behind != ":";
        if !(behind.is_empty() || marked || UNITS.contains(&behind)) || !run.contains(|c: char| c.is_ascii_digit()) {
            return None;
        }
        let (whole, decimals) = parts(run)?;
        let value = format!("{whole}.{decimals}").parse().ok().filter(|value: &f64| *value < 1e9)?;
        Some(Figure { value: sign * value, half: 0.5 * 0.1_f64.powi(decimals.len().min(12) as i32) })
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

/// Signs that stand between the digits of a figure: of its decimals, or of its thousands.
fn is_between(c: char) -> bool {
    ".,'’ \u{a0}\u{202f}\u{2009}".contains(c)
}

/// The digits of a figure before and behind its decimal sign; none: it could be read in two ways, or in none. Thousands
/// are parted by a sign that is no decimal sign, or beside one that is another: `1'132`, `1.132,015`, `1 132,015`.
fn parts(run: &str) -> Option<(String, &str)> {
    let decimal = |c: char| c == '.' || c == ',';
    let signs: Vec<char> = run.chars().filter(|c| is_between(*c)).collect();
    let last = run.char_indices().rev().find(|(_, c)| is_between(*c));
    let (whole, decimals) = match (last, signs.as_slice()) {
        (Some((at, sign)), [before @ .., _]) if decimal(sign) && !before.contains(&sign) => {
            (&run[..at], &run[at + 1..])
        }
        _ => (run, ""),
    };
    let thousands = whole.chars().find(|c| is_between(*c));
    let Some(sign) = thousands else { return Some((whole.to_owned(), decimals)) };
    let groups: Vec<&str> = whole.split(sign).collect();
    let even = groups.iter().enumerate().all(|(at, group)| {
        let digits = group.len() == 3 || at == 0 && (1..3).contains(&group.len());
        digits && group.chars().all(|c| c.is_ascii_digit())
    });
    let one_way = matches!(sign, '\'' | '’') || !decimals.is_empty();
    (even && one_way).then(|| (groups.concat(), decimals))
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
