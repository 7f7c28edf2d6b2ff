//! The lines of the blocks: made from values, and found again in a program.

use crate::catalogue;
use crate::control::{AXES, Plane};
use crate::diagnostic::Span;
use crate::dialect::Dialect;
use crate::entry::{Inputs, address};
use crate::syntax::{Block, Grammar, Program};

/// First work offset of NCT in its variables, and how far they lie apart: #5201 the common one, #5221 G54.
const OFFSETS: i64 = 5201;
const APART: i64 = 20;
/// Work offsets that an address names: 0 the common one, 1 to 6 G54 to G59 (C:1079).
const NAMED: std::ops::RangeInclusive<f64> = 0.0..=6.0;

/// A name that only has to be free in the program.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Free {
    /// What the labels of a block begin with: `PW1`.
    Label,
    /// Number of an arithmetic parameter, NCT of a variable of the program level.
    Variable,
    /// Number of a block (NCT).
    Number,
}

impl Free {
    /// By its name in braces.
    pub fn of(name: &str) -> Option<Free> {
        match name {
            "label" => Some(Free::Label),
            "a" | "b" | "c" | "d" | "e" => Some(Free::Variable),
            "n1" | "n2" | "n3" => Some(Free::Number),
            _ => None,
        }
    }

    /// Whether a program may have this text there.
    fn is(self, text: &str) -> bool {
        let digits = if self == Free::Label { text.strip_prefix("PW").unwrap_or_default() } else { text };
        !digits.is_empty() && digits.len() < 6 && digits.bytes().all(|byte| byte.is_ascii_digit())
    }
}

/// A piece of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Piece<'a> {
    /// As it stands.
    Text(&'a str),
    /// A name in braces.
    Hole(&'a str),
}

/// The pieces of a line.
pub fn pieces(code: &str) -> Vec<Piece<'_>> {
    let mut found = Vec::new();
    for (at, part) in code.split(['{', '}']).enumerate() {
        match at % 2 {
            0 if part.is_empty() => {}
            0 => found.push(Piece::Text(part)),
            _ => found.push(Piece::Hole(part)),
        }
    }
    found
}

/// The work offset that a call of NCT names, 0 the common one.
pub fn offset(inputs: &Inputs) -> Option<i64> {
    let number = inputs.any(address::S).filter(|_| inputs.cycle.dialect == Dialect::Nct)?;
    (number.fract() == 0.0 && NAMED.contains(&number)).then_some(number as i64)
}

/// What lines name that stand around a call: they belong to a call that has the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// Work offset of NCT, 0 the common one; none: the call names none.
    pub offset: Option<i64>,
    /// Working plane.
    pub plane: Plane,
}

impl Place {
    /// That of a call.
    pub fn of(inputs: &Inputs) -> Place {
        Place { offset: offset(inputs), plane: inputs.plane }
    }

    /// Those of other calls.
    fn others(self, dialect: Dialect) -> Vec<Place> {
        let all: Vec<Place> = match dialect {
            Dialect::Sinumerik => [Plane::G17, Plane::G18, Plane::G19].map(|plane| Place { plane, ..self }).into(),
            Dialect::Nct => {
                let (first, last) = (*NAMED.start() as i64, *NAMED.end() as i64);
                (first..=last).map(|number| Place { offset: Some(number), ..self }).collect()
            }
        };
        all.into_iter().filter(|place| *place != self).collect()
    }
}

/// What the call gives: the variables of its work offset (`s1` to `s3`) and those of the one from which it is
/// calculated (`o1` to `o3`, #4014 is the G function of the active one), the result with the alarm, the cycles of the
/// log, the axes of the plane.
const GIVEN: [&str; 11] = ["alarm", "on", "off", "abscissa", "ordinate", "s1", "s2", "s3", "o1", "o2", "o3"];

/// Whether the call gives what has this name.
pub fn is_given(name: &str) -> bool {
    GIVEN.contains(&name)
}

/// One of these at a call.
pub fn given(name: &str, inputs: &Inputs) -> Option<String> {
    given_at(name, inputs, Place::of(inputs))
}

/// The place of which all that is given in these lines is; that of the call comes first.
pub fn place_of(bound: &[Bound], inputs: &Inputs) -> Option<Place> {
    let own = Place::of(inputs);
    let mut places = std::iter::once(own).chain(own.others(inputs.cycle.dialect));
    let mut given = bound.iter().filter(|bound| is_given(bound.name));
    places
        .find(|place| given.clone().all(|bound| given_at(bound.name, inputs, *place).as_ref() == Some(&bound.text)))
        .filter(|place| *place == own || given.next().is_some())
}

fn given_at(name: &str, inputs: &Inputs, place: Place) -> Option<String> {
    let offset = || place.offset;
    let axis_of = |index: usize| AXES[place.plane.axes()[index]].to_string();
    let axis = || name.get(1..).and_then(|digit| digit.parse::<i64>().ok()).map(|axis| axis - 1);
    match name {
        "alarm" => inputs.cycle.alarm_result().map(|field| field.name.to_owned()),
        "on" => Some(catalogue::log_switches()[0].to_owned()),
        "off" => Some(catalogue::log_switches()[1].to_owned()),
        "abscissa" => Some(axis_of(0)),
        "ordinate" => Some(axis_of(1)),
        "s1" | "s2" | "s3" => Some((OFFSETS + APART * offset()? + axis()?).to_string()),
        "o1" | "o2" | "o3" => Some(match offset()? {
            0 => (OFFSETS + axis()?).to_string(),
            _ => format!("[{}+{APART}*#4014]", OFFSETS - 53 * APART + axis()?),
        }),
        _ => None,
    }
}

/// A line with its values.
pub fn filled(code: &str, value: &dyn Fn(&str) -> String) -> String {
    let piece = |piece: Piece| match piece {
        Piece::Text(text) => text.to_owned(),
        Piece::Hole(name) => value(name),
    };
    pieces(code).into_iter().map(piece).collect()
}

/// A value that stands in lines of a program.
#[derive(Clone, Debug, PartialEq)]
pub struct Bound {
    /// Its name in the lines.
    pub name: &'static str,
    /// As it is written.
    pub text: String,
    /// Each place of it.
    pub places: Vec<Span>,
}

/// Characters of a line without blanks and in upper case, texts and comments as they are, each with its place.
struct Squeezed {
    bytes: Vec<u8>,
    places: Vec<u32>,
}

impl Squeezed {
    fn of(program: &Program, span: Span) -> Squeezed {
        let mut squeezed = Squeezed { bytes: Vec::new(), places: Vec::new() };
        let comment = Grammar::of(program.dialect).by_address;
        let mut inside = false;
        for (at, byte) in program.text(span).iter().enumerate() {
            inside = match byte {
                b'"' if !comment => !inside,
                b'(' if comment => true,
                b')' if comment => false,
                _ => inside,
            };
            if inside || !matches!(byte, b' ' | b'\t') {
                squeezed.bytes.push(if inside { *byte } else { byte.to_ascii_uppercase() });
                squeezed.places.push(span.start + at as u32);
            }
        }
        squeezed
    }

    fn span(&self, from: usize, to: usize) -> Option<Span> {
        Some(Span { start: *self.places.get(from)?, end: self.places.get(to.checked_sub(1)?)? + 1 })
    }
}

/// Whether a block of the program is this line; what stands in its braces is added to what is known.
pub fn matches(program: &Program, block: &Block, code: &'static str, inputs: &Inputs, known: &mut Vec<Bound>) -> bool {
    if block.skip.is_some() || block.plain {
        return false;
    }
    let numbered = code.starts_with("N{");
    let start = block.number.filter(|_| !numbered).map_or(block.span.start, |number| number.end);
    let end = block.comment.filter(|_| !code.contains('(') || !program.grammar().by_address);
    let end = end.map_or(block.span.end, |comment| comment.start);
    let line = Squeezed::of(program, Span { start, end: end.max(start) });
    fits(&line, &pieces(code), inputs, known).is_some()
}

fn fits(line: &Squeezed, pieces: &[Piece<'static>], inputs: &Inputs, known: &mut Vec<Bound>) -> Option<()> {
    let mut at = 0;
    for (index, piece) in pieces.iter().enumerate() {
        let rest = line.bytes.get(at..)?;
        let name = match piece {
            Piece::Text(text) => {
                let text = plain(text);
                at += rest.starts_with(&text).then_some(text.len())?;
                continue;
            }
            Piece::Hole(name) => *name,
        };
        if is_given(name) {
            let text = given_there(name, inputs, rest)?;
            let end = at + text.len();
            bind(known, name, text, line.span(at, end)?)?;
            at = end;
            continue;
        }
        let before = known.iter().find(|bound| bound.name == name).map(|bound| bound.text.len());
        let end = match pieces.get(index + 1) {
            _ if before.is_some() => at + before.unwrap_or_default(),
            Some(Piece::Text(next)) => {
                let next = plain(next);
                at + rest.windows(next.len()).position(|part| part == next).filter(|length| *length > 0)?
            }
            _ => line.bytes.len(),
        };
        let text = String::from_utf8_lossy(line.bytes.get(at..end).filter(|text| !text.is_empty())?).into_owned();
        bind(known, name, text, line.span(at, end)?)?;
        at = end;
    }
    (at == line.bytes.len()).then_some(())
}

/// What stands there of what the call gives, or another call would give.
fn given_there(name: &str, inputs: &Inputs, rest: &[u8]) -> Option<String> {
    let own = Place::of(inputs);
    let others = own.others(inputs.cycle.dialect).into_iter();
    let texts = std::iter::once(own).chain(others).filter_map(|place| given_at(name, inputs, place));
    texts.into_iter().find(|text| rest.starts_with(text.as_bytes()))
}

/// A text of a block, as a line is compared with it.
fn plain(text: &str) -> Vec<u8> {
    text.bytes().filter(|byte| *byte != b' ').map(|byte| byte.to_ascii_uppercase()).collect()
}

/// The same name is the same text everywhere.
fn bind(known: &mut Vec<Bound>, name: &'static str, text: String, place: Span) -> Option<()> {
    if Free::of(name).is_some_and(|free| !free.is(&text)) {
        return None;
    }
    match known.iter_mut().find(|bound| bound.name == name) {
        Some(bound) if bound.text == text => bound.places.push(place),
        Some(_) => return None,
        None => known.push(Bound { name, text, places: vec![place] }),
    }
    Some(())
}
