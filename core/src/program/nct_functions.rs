//! G functions of NCT that a run does not drive: what each leaves unknown, and what makes it known again. The manuals
//! here describe none of them (C uses G0, G17 to G19, G40, G41, G43, G49, G53 to G59, G65, G90 only); what they are is
//! common to controls with this language, and nothing more than that is made of it.

use crate::control::{AXES, Plane};
use crate::diagnostic::Span;
use std::collections::BTreeMap;

/// What a G function does that is not simulated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Effect {
    /// It tunes the motion, or ends what did; nothing that is measured depends on it.
    Tunes,
    /// Its addresses are data, nothing moves.
    Describes,
    /// Its axes go where only the machine knows.
    Moves,
    /// A place or a length is not known from here on. With these addresses beside it:
    Opens(Beside),
    /// What the function with this number, in tenths, opened counts no more.
    Closes(u16),
    /// From here on the tool goes into the part at each position.
    Drills,
    /// It does so no more.
    DrillsNoMore,
}

/// What the axis words beside a function are that opens something.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Beside {
    /// Targets, in what it opened.
    Targets,
    /// Its data.
    Data,
    /// Its data, each for its axis.
    EachAxis,
}

use Beside::{Data, EachAxis, Targets};
use Effect::{Closes, Describes, Drills, DrillsNoMore, Moves, Opens, Tunes};

/// The functions, by tenths of their numbers: threads, reference points, offsets, mirrors, scales, rotations, polar and
/// cylindrical coordinates, settings of the control, drilling cycles.
const ROWS: &[(u16, Effect)] = &[
    (51, Tunes),        // several blocks ahead
    (71, Opens(Data)),  // cylindrical interpolation
    (80, Tunes),        // contour control
    (100, Opens(Data)), // data input: offsets, registers
    (110, Tunes),       // its end
    (121, Opens(Data)), // polar interpolation
    (131, Closes(121)),
    (150, Closes(160)),
    (160, Opens(Targets)), // polar coordinates
    (220, Describes),      // stroke check
    (230, Tunes),
    (270, Moves), // reference point: check, to it, back, to another one
    (280, Moves),
    (290, Moves),
    (300, Moves),
    (330, Moves),          // thread
    (370, Opens(Targets)), // tool length measurement
    (380, Moves),          // radius compensation: the vector stays
    (390, Describes),      // radius compensation: an arc at a corner
    (430, Closes(440)),
    (440, Opens(Targets)), // length, subtracted
    (450, Moves),          // lengthened or shortened by a radius
    (460, Moves),
    (470, Moves),
    (480, Moves),
    (490, Closes(440)),
    (500, Closes(510)),
    (501, Closes(511)),
    (510, Opens(Data)),     // scale
    (511, Opens(EachAxis)), // mirror
    (520, Opens(EachAxis)), // local coordinate system
    (540, Closes(541)),
    (541, Opens(Targets)), // additional work offsets
    (550, Closes(541)),
    (560, Closes(541)),
    (570, Closes(541)),
    (580, Closes(541)),
    (590, Closes(541)),
    (620, Tunes), // override
    (630, Tunes),
    (660, Tunes),       // modal macro call
    (661, Opens(Data)), // the same of each block, whose words are its arguments
    (670, Closes(661)),
    (680, Opens(Data)), // rotation
    (690, Closes(680)),
    (730, Drills),
    (740, Drills),
    (760, Drills),
    (800, DrillsNoMore),
    (810, Drills),
    (820, Drills),
    (830, Drills),
    (840, Drills),
    (842, Drills),
    (843, Drills),
    (850, Drills),
    (860, Drills),
    (870, Drills),
    (880, Drills),
    (890, Drills),
    (920, Opens(EachAxis)), // the position is said anew
    (980, Tunes),           // return of drilling cycles
    (990, Tunes),
];

/// G0 to G3, which end drilling too.
const MOTIONS: std::ops::RangeInclusive<u16> = 0..=30;
/// G4: its axis word is a time.
const DWELL: u16 = 40;
/// G53: in machine coordinates.
const MACHINE: u16 = 530;
/// G52, whose zeros end it.
const LOCAL: u16 = 520;

/// A function by its number in tenths.
pub fn effect(tenths: u16) -> Option<Effect> {
    ROWS.iter().find(|(row, _)| *row == tenths).map(|(_, effect)| *effect)
}

/// The number of a function in tenths; none: it has more decimals, or there is none with such a number.
pub fn tenths(code: f64) -> Option<u16> {
    let tenths = (code * 10.0).round();
    ((tenths - code * 10.0).abs() < 1e-6 && (0.0..10_000.0).contains(&tenths)).then_some(tenths as u16)
}

/// How a function is written.
fn word(tenths: u16) -> String {
    format!("G{}", f64::from(tenths) / 10.0)
}

/// What a block says that counts here.
pub struct Said<'a> {
    /// G functions in tenths, with their places.
    pub codes: &'a [(u16, Span)],
    /// Axis words: their place and, where it is known, their value.
    pub axes: [Option<(Option<f64>, Span)>; 3],
    /// G90.
    pub absolute: bool,
    /// Working plane.
    pub plane: Plane,
}

/// What is not known, by the names of the words that would say it: `X`, `G68`, `G52 Y`.
pub type Unknown = BTreeMap<String, Span>;

/// What a program left unknown so far.
pub struct Left<'a> {
    /// The words that left something unknown.
    pub unknown: &'a mut Unknown,
    /// The drilling cycle that is active.
    pub drilling: &'a mut Option<Span>,
}

/// Where the axes of a block go.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Course {
    /// Where they are written.
    There,
    /// Somewhere else.
    Elsewhere,
    /// Nowhere: the words are data.
    Nowhere,
}

/// Takes in a block.
pub fn pass(said: &Said, left: &mut Left) -> Course {
    let (mut data, mut moves) = (false, false);
    for (code, span) in said.codes {
        match effect(*code) {
            Some(Opens(beside)) => {
                open(*code, beside, *span, said, left.unknown);
                data |= beside != Targets;
            }
            Some(Closes(opened)) => data |= close(opened, said, left.unknown),
            Some(Drills) => *left.drilling = Some(*span),
            Some(DrillsNoMore) => *left.drilling = None,
            Some(Describes) => data = true,
            Some(Moves) => moves = true,
            Some(Tunes) => {}
            None if MOTIONS.contains(code) => *left.drilling = None,
            None => data |= *code == DWELL,
        }
    }
    match said.axes {
        _ if data => Course::Nowhere,
        [None, None, None] => Course::There,
        _ => goes(said, left, moves),
    }
}

/// Takes in the axis words of a block that moves.
fn goes(said: &Said, left: &mut Left, moves: bool) -> Course {
    let in_machine = said.codes.iter().any(|(code, _)| *code == MACHINE);
    let (concerned, mixes) = if in_machine { ([false; 3], false) } else { concerned(left.unknown, said.plane) };
    let written = |axis: usize| said.axes[axis].map(|(_, span)| span);
    let elsewhere = (0..3).any(|axis| concerned[axis] && written(axis).is_some());
    if !(moves || left.drilling.is_some() || elsewhere) {
        for axis in (0..3).filter(|axis| (said.absolute || in_machine) && written(*axis).is_some()) {
            left.unknown.remove(AXES[axis]);
        }
        return Course::There;
    }
    let first = (0..3).find_map(written);
    for axis in 0..3 {
        let also = elsewhere && mixes && concerned[axis];
        let deep = left.drilling.is_some() && axis == said.plane.axes()[2];
        if let Some(span) = written(axis).or(first.filter(|_| also || deep)) {
            left.unknown.insert(AXES[axis].to_owned(), span);
        }
    }
    Course::Elsewhere
}

fn open(code: u16, beside: Beside, span: Span, said: &Said, unknown: &mut Unknown) {
    let name = word(code);
    if beside != EachAxis {
        unknown.insert(name, span);
        return;
    }
    for (axis, written) in said.axes.iter().enumerate() {
        let key = format!("{name} {}", AXES[axis]);
        match written {
            Some((Some(0.0), _)) if code == LOCAL => drop(unknown.remove(&key)),
            Some(_) => drop(unknown.insert(key, span)),
            None => {}
        }
    }
}

/// Ends what a function opened, for some axes where that is so; true: the axis words of the block say which.
fn close(opened: u16, said: &Said, unknown: &mut Unknown) -> bool {
    let name = word(opened);
    if effect(opened) != Some(Opens(EachAxis)) {
        unknown.remove(&name);
        return false;
    }
    let all = said.axes.iter().all(Option::is_none);
    for axis in (0..3).filter(|axis| all || said.axes[*axis].is_some()) {
        unknown.remove(&format!("{name} {}", AXES[axis]));
    }
    !all
}

/// Whether a name is that of a function which left something unknown.
pub fn is_open(name: &str) -> bool {
    let number = name.strip_prefix('G').and_then(|rest| rest.split(' ').next()?.parse().ok());
    number.and_then(tenths).and_then(effect).is_some_and(|effect| matches!(effect, Opens(_)))
}

/// Which axes go to places that are not known, and whether one of them moves with the word of another one.
fn concerned(unknown: &Unknown, plane: Plane) -> ([bool; 3], bool) {
    let (mut axes, mut mixes) = ([false; 3], false);
    let [a, o, p] = plane.axes();
    for name in unknown.keys().filter(|name| is_open(name)) {
        match name.as_str() {
            "G68" | "G16" => {
                (axes[a], axes[o]) = (true, true);
                mixes = true;
            }
            "G44" | "G37" => axes[p] = true,
            name => match name.split_once(' ').and_then(|(_, one)| AXES.iter().position(|axis| *axis == one)) {
                Some(axis) => axes[axis] = true,
                None => {
                    axes = [true; 3];
                    mixes |= ["G7.1", "G12.1"].contains(&name);
                }
            },
        }
    }
    (axes, mixes)
}

#[cfg(test)]
mod tests {
    use super::*;

    // oracle: self (the table in order, each row once, what closes closes something)
    #[test]
    fn the_table_is_in_order() {
        assert!(ROWS.is_sorted_by(|one, next| one.0 < next.0));
        for (code, effect) in ROWS {
            if let Closes(opened) = effect {
                assert!(matches!(super::effect(*opened), Some(Opens(_))), "{}", word(*code));
            }
        }
    }

    // oracle: hand
    #[test]
    fn numbers_have_one_decimal() {
        assert_eq!(
            [54.0, 54.1, 84.3, 54.12, -1.0, 1000.0].map(tenths),
            [Some(540), Some(541), Some(843), None, None, None]
        );
        assert_eq!((word(541), word(520)), ("G54.1".to_owned(), "G52".to_owned()));
        assert!(is_open("G52 Y") && is_open("G68") && !is_open("G54") && !is_open("X") && !is_open("G69"));
    }
}
