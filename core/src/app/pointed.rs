//! What is told of a place of a program where the pointer rests, from its line alone: an argument of a list of newer
//! controls, a parameter of a control that is read and not run.

use crate::catalogue::newer::arguments::Argument;
use crate::diagnostic::Span;
use crate::dialect::Dialect;
use crate::foreign;
use crate::message::Message;
use crate::program::lists::list_calls;
use crate::syntax;
use crate::syntax::position::Positions;
use serde::{Deserialize, Serialize};

/// Longest line that is looked at, bytes.
const LONGEST: usize = 10_000;

/// A place of a line.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct PointedRequest {
    /// Control.
    pub control: Dialect,
    /// The line.
    pub line: String,
    /// The place, UTF-16 units.
    pub at: u32,
}

/// What is told of it.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct PointedView {
    /// First unit of what it is about.
    pub from: u32,
    /// One past its end.
    pub to: u32,
    /// Its name; empty: none is published.
    pub name: String,
    /// What it means.
    pub meaning: Message,
    /// More about that, where there are words for it.
    pub help: Message,
    /// What else is known, a line each.
    pub about: Vec<Message>,
}

/// What is told of a place; none: nothing.
pub fn pointed(asked: &PointedRequest) -> Option<PointedView> {
    let line = asked.line.as_str();
    if line.len() > LONGEST {
        return None;
    }
    let at = byte(line, asked.at);
    let of_list = (asked.control == Dialect::Sinumerik).then(|| argument(line, at)).flatten();
    let (span, name, meaning, about) = of_list.or_else(|| parameter(line, at))?;
    let positions = Positions::new(line.as_bytes());
    Some(PointedView {
        from: positions.utf16(span.start),
        to: positions.utf16(span.end),
        name,
        help: Message::new(format!("{meaning}-help")),
        meaning: Message::new(meaning),
        about,
    })
}

/// Place, name, key of the meaning, what else is known.
type Told = (Span, String, String, Vec<Message>);

fn argument(line: &str, at: u32) -> Option<Told> {
    let program = syntax::read(Dialect::Sinumerik, line.as_bytes());
    let one = list_calls(&program).into_iter().find_map(|call| {
        let index = call.arguments.iter().position(|one| one.place.start <= at && at <= one.place.end)?;
        call.arguments.into_iter().nth(index)
    })?;
    let Argument { place, list, name, .. } = one.argument;
    let place = Message::new("argument-place").number("place", place as f64).text("cycle", list.name);
    let about = std::iter::once(place).chain(one.argument.about()).collect();
    Some((one.place, name.to_owned(), one.argument.meaning(), about))
}

fn parameter(line: &str, at: u32) -> Option<Told> {
    let (control, parameter, span) = foreign::parameter_at(line.as_bytes(), at)?;
    let about = Message::new("foreign-of").text("control", control.name).text("text", parameter.text);
    Some((span, parameter.name.to_owned(), parameter.key.to_owned(), vec![about]))
}

/// The byte of a place in UTF-16 units.
fn byte(line: &str, at: u32) -> u32 {
    let mut units = 0;
    let found = line.char_indices().find(|(_, one)| {
        units += one.len_utf16() as u32;
        units > at
    });
    found.map_or(line.len(), |(at, _)| at) as u32
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::app::ReadRequest;

    fn at(line: &str, at: u32) -> Option<PointedView> {
        pointed(&PointedRequest { control: Dialect::Sinumerik, line: line.into(), at })
    }

    // oracle: peer (published lists: argument 5 of CYCLE977 is S_SETV, 4 of CYCLE996 the diameter of the ball)
    #[test]
    fn an_argument_is_told_by_its_place() {
        let line = "N10 CYCLE977(101,10001,,1,50,,,2,5)";
        let told = at(line, line.find("50").unwrap() as u32).unwrap();
        assert_eq!((told.name.as_str(), &line[told.from as usize..told.to as usize]), ("S_SETV", "50"));
        let line = "CYCLE996(1,,1,24.99)";
        assert_eq!(at(line, 14).unwrap().meaning.key, "argument-ball");
        assert_eq!(at(line, 2), None);
        assert_eq!(at("_SETVAL=50", 9), None);
        // a text counts in its own units
        let line = "MSG(\"ü𝄞\") CYCLE977(101)";
        let place = line.encode_utf16().count() as u32 - 2;
        let told = at(line, place).unwrap();
        assert_eq!((told.name.as_str(), told.to), ("S_MVAR", place + 1));
    }

    // oracle: peer (published lists have cycles that the older control lacks); self: in the order of the text
    #[test]
    fn calls_without_a_form_are_read() {
        let read = |text: &str| {
            let asked = ReadRequest { control: Dialect::Sinumerik, text: text.into(), setup: None, with: None };
            let others = crate::app::read(asked, &mut |_| {}).unwrap().others.into_iter();
            others.map(|one| (one.cycle, one.title.key.into_owned(), one.line)).collect::<Vec<_>>()
        };
        let found = read("G0 X0\nCYCLE977(101,1,,1,50)\nCYCLE996(1,,1,24.99)\nCYCLE150(10,,1)\nM30\n");
        let wanted = [("CYCLE996", "newer-cycle996", 3), ("CYCLE150", "newer-cycle150", 4)];
        assert_eq!(found, wanted.map(|(cycle, key, line)| (cycle.to_owned(), key.to_owned(), line)));
        let found = read("0 BEGIN PGM A MM\n1 TCH PROBE 427 MEASURE COORDINATE ~\n  Q263=+1\n2 END PGM A MM\n");
        assert_eq!(found, [("TCH PROBE 427".to_owned(), "tnc-427-title".to_owned(), 2)]);
    }

    // oracle: manual (iTNC 530, cycle programming, p. 362)
    #[test]
    fn a_parameter_of_another_control_is_told() {
        let told = at("  Q262=+12 ;NOMINAL DIAMETER ~", 4).unwrap();
        assert_eq!((told.name.as_str(), &*told.meaning.key, told.from, told.to), ("Q262", "tnc-q262", 2, 10));
        assert_eq!(at("Q999=1", 2), None);
        // in DIN/ISO they stand behind the function; whichever control is chosen
        let line = "N30 G421 Q273=+50 Q274=+50 *".to_owned();
        let told = pointed(&PointedRequest { control: Dialect::Nct, line, at: 20 }).unwrap();
        assert_eq!((told.name.as_str(), told.from, told.to), ("Q274", 18, 26));
        assert_eq!(at("G1 Q262=5", 5), None);
    }
}
