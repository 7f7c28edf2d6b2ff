//! The lines of blocks as text.

use super::pattern::{Bound, Free, Piece, filled, given, pieces};
use super::values::{completed, value};
use super::{Block, Line};
use crate::entry::{Inputs, Typed};
use crate::syntax::Grammar;

/// The words of a key.
pub type Words<'a> = &'a dyn Fn(&str) -> String;

/// Lines of a block, ended by LF.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Lines {
    /// Before the call.
    pub before: String,
    /// Behind it.
    pub after: String,
}

/// The lines of a block with these values; `taken` is the text of the program, whose labels and variables are not
/// used again; `comments`: each line says what it is for.
pub fn write(block: &Block, typed: &Typed, inputs: &Inputs, taken: &str, words: Words, comments: bool) -> Lines {
    let mut free: Vec<Bound> = Vec::new();
    let taken = taken.to_ascii_uppercase();
    let typed = &completed(block, typed, &taken);
    let taken = taken + &own_variables(block, typed, inputs, words);
    for name in block.before.iter().chain(block.after).flat_map(|line| pieces(line.code)).filter_map(hole) {
        let known = free.iter().any(|bound| bound.name == name);
        if let Some(kind) = Free::of(name).filter(|_| !known) {
            let text = unused(kind, inputs, &taken, &free);
            free.push(Bound { name, text, places: Vec::new() });
        }
    }
    let of = |name: &str| {
        let bound = free.iter().find(|bound| bound.name == name).map(|bound| bound.text.clone());
        let entered = || Some(value(block.field(name)?, typed, inputs, words));
        bound.or_else(|| given(name, inputs)).or_else(entered).unwrap_or_default()
    };
    let lines = |lines: &[Line]| lines.iter().map(|line| text(line, inputs, &of, words, comments)).collect();
    Lines { before: lines(block.before), after: lines(block.after) }
}

fn hole(piece: Piece<'static>) -> Option<&'static str> {
    if let Piece::Hole(name) = piece { Some(name) } else { None }
}

/// The variables that the block itself writes, so that none of them is used twice.
fn own_variables(block: &Block, typed: &Typed, inputs: &Inputs, words: Words) -> String {
    let number = |name: &str| block.field(name).map(|field| value(field, typed, inputs, words));
    number("variable").map_or_else(String::new, |number| format!("\nR{number}\n#{number}\n"))
}

fn text(line: &Line, inputs: &Inputs, of: &dyn Fn(&str) -> String, words: Words, comments: bool) -> String {
    let code = filled(line.code, of);
    let says = if comments && !line.says.is_empty() { words(line.says) } else { String::new() };
    if says.is_empty() {
        return code + "\n";
    }
    format!("{code} {}", (Grammar::of(inputs.cycle.dialect).commented)(&says))
}

/// Of each kind the first that the program does not have; where it has all of them, the last.
fn unused(kind: Free, inputs: &Inputs, taken: &str, others: &[Bound]) -> String {
    let by_address = Grammar::of(inputs.cycle.dialect).by_address;
    let (mut numbers, before): (Box<dyn Iterator<Item = u32>>, &str) = match kind {
        Free::Label => (Box::new(1..10_000), "PW"),
        Free::Number => (Box::new(9001..10_000), ""),
        Free::Variable if by_address => (Box::new((1..34).rev()), "#"),
        Free::Variable => (Box::new((0..100).rev()), "R"),
    };
    let is_free = |number: &u32| {
        let other = others.iter().any(|bound| Free::of(bound.name) == Some(kind) && bound.text == number.to_string());
        !other && !holds(taken, &format!("{before}{number}"))
    };
    let number = numbers.find(is_free).unwrap_or(1);
    if kind == Free::Label { format!("{before}{number}") } else { number.to_string() }
}

/// Whether a text has this word, without a digit behind it and a letter or digit before it.
fn holds(text: &str, word: &str) -> bool {
    let named = word.starts_with(|one: char| one.is_ascii_alphabetic());
    text.match_indices(word).any(|(at, _)| {
        let before = text[..at].bytes().next_back().unwrap_or(b' ');
        let behind = text[at + word.len()..].bytes().next().unwrap_or(b' ');
        let joined =
            before.is_ascii_digit() || named && (before.is_ascii_alphabetic() || before == b'_' || before == b'$');
        !joined && !behind.is_ascii_digit()
    })
}
