//! All findings of one kind cured at once.

use super::calls::calls_on;
use super::change::{Edit, apply};
use super::findings::findings_of;
use crate::control::Control;
use crate::diagnostic::{Diagnostic, Span};
use crate::syntax::Program;

/// Looks at the program that may be taken: a cure may need one for itself.
const LOOKS: usize = 64;

/// What curing all findings of a kind does to a program.
#[derive(Debug, Default)]
pub struct Cured {
    /// The only places that change.
    pub edits: Vec<Edit>,
    /// Findings of this kind that are gone.
    pub gone: usize,
    /// Findings of this kind with a cure that are left.
    pub left: usize,
}

/// Cures the findings with this number and this sentence of a program that starts on a control in this state.
///
/// One cure may mend several findings: a line before the first call is in force at those behind it. Therefore the first
/// one is done alone; as long as each mends its own finding only, twice as many are done at once.
pub fn cure_all(program: &Program, code: &str, key: &str, control: &Control) -> Cured {
    let mut text = program.source.to_vec();
    let mut pieces = vec![Piece::Kept(Span { start: 0, end: text.len() as u32 })];
    let mut open = cures(program, code, key, control);
    let all = open.len();
    let (mut many, mut passed) = (1, 0);
    for _ in 0..LOOKS {
        let step = apart(open.get(passed..).unwrap_or_default().iter().take(many));
        if step.is_empty() {
            break;
        }
        let next_text = apply(&text, &step);
        let next = cures(&program.again(&next_text), code, key, control);
        let gone = open.len().saturating_sub(next.len());
        if many > 1 && gone != many.min(open.len() - passed) {
            many = 1; // they touch each other: one by one
            continue;
        }
        if gone == 0 {
            passed += 1; // it stays, whatever is done
            continue;
        }
        many = if gone == many { many * 2 } else { 1 };
        pieces = edited(pieces, &step);
        (text, open) = (next_text, next);
    }
    Cured { edits: edits_of(pieces, program.source.len() as u32), gone: all - open.len().min(all), left: open.len() }
}

/// The edits of each finding of this kind that has a cure.
fn cures(program: &Program, code: &str, key: &str, control: &Control) -> Vec<Vec<Edit>> {
    let sites = calls_on(program, control.clone());
    let of_kind = |one: &Diagnostic| one.message.key == key && one.code.to_string() == code;
    let found = findings_of(program, &sites, control).into_iter().filter(of_kind);
    found.filter_map(|one| Some(one.cure?.edits)).collect()
}

/// Edits of those of several cures that do not meet, in the order of the text.
fn apart<'a>(cures: impl Iterator<Item = &'a Vec<Edit>>) -> Vec<Edit> {
    let first = |cure: &&Vec<Edit>| cure.iter().map(|edit| edit.span.start).min();
    let mut cures: Vec<&Vec<Edit>> = cures.collect();
    cures.sort_by_key(first);
    cures.dedup();
    let mut end = 0;
    let free = cures.into_iter().filter(|cure| {
        let fits = first(cure) >= Some(end);
        end = cure.iter().map(|edit| edit.span.end).chain([end]).max().unwrap_or(end);
        fits
    });
    let mut edits: Vec<Edit> = free.flatten().cloned().collect();
    edits.sort_by_key(|edit| (edit.span.start, edit.span.end));
    edits
}

/// A piece of a text that was changed: of what stood there first, or new.
enum Piece {
    Kept(Span),
    New(String),
}

impl Piece {
    fn len(&self) -> u32 {
        match self {
            Piece::Kept(span) => span.end - span.start,
            Piece::New(text) => text.len() as u32,
        }
    }

    /// The part between two places of it.
    fn part(&self, from: u32, to: u32) -> Piece {
        match self {
            Piece::Kept(span) => Piece::Kept(Span { start: span.start + from, end: span.start + to }),
            Piece::New(text) => Piece::New(text.get(from as usize..to as usize).unwrap_or_default().to_owned()),
        }
    }
}

/// The pieces after edits of the text that they make, which are in its order.
fn edited(pieces: Vec<Piece>, edits: &[Edit]) -> Vec<Piece> {
    let mut result = Vec::with_capacity(pieces.len() + 2 * edits.len());
    let mut edits = edits.iter().peekable();
    let (mut begin, mut gone) = (0, 0); // of the piece; up to where the text is taken out
    for piece in pieces {
        let end = begin + piece.len();
        let mut at = begin.max(gone).min(end);
        while let Some(edit) = edits.next_if(|edit| edit.span.start < end) {
            let start = edit.span.start.max(at);
            result.push(piece.part(at - begin, start - begin));
            result.push(Piece::New(edit.insert.clone()));
            gone = edit.span.end.max(gone);
            at = gone.clamp(start, end);
        }
        result.push(piece.part(at - begin, end - begin));
        begin = end;
    }
    result.extend(edits.map(|edit| Piece::New(edit.insert.clone())));
    result.retain(|piece| piece.len() > 0);
    result
}

/// The edits that make these pieces of a text of this length.
fn edits_of(pieces: Vec<Piece>, length: u32) -> Vec<Edit> {
    let mut edits = Vec::new();
    let (mut at, mut insert) = (0, String::new());
    let last = Piece::Kept(Span { start: length, end: length });
    for piece in pieces.into_iter().chain([last]) {
        match piece {
            Piece::New(text) => insert.push_str(&text),
            Piece::Kept(span) => {
                if span.start > at || !insert.is_empty() {
                    edits.push(Edit { span: Span { start: at, end: span.start }, insert: std::mem::take(&mut insert) });
                }
                at = span.end;
            }
        }
    }
    edits
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic)]
mod tests {
    use super::*;
    use crate::control::delivery;
    use crate::dialect::Dialect;
    use crate::syntax::read;

    // oracle: hand (edits one after the other, and all of them at once)
    #[test]
    fn steps_are_one_list_of_edits() {
        let text = b"0123456789";
        let first = [Edit::replace(Span { start: 2, end: 4 }, "ab"), Edit::insert(10, "!")];
        let second = [Edit::replace(Span { start: 3, end: 6 }, "XYZW"), Edit::remove(8, 9)];
        let in_turn = apply(&apply(text, &first), &second);
        let pieces = edited(vec![Piece::Kept(Span { start: 0, end: 10 })], &first);
        let edits = edits_of(edited(pieces, &second), 10);
        assert_eq!(String::from_utf8(apply(text, &edits)).unwrap(), String::from_utf8(in_turn).unwrap());
    }

    fn cured(text: &str, key: &str, code: &str) -> (String, usize, usize) {
        let program = read(Dialect::Sinumerik, text.as_bytes());
        let done = cure_all(&program, code, key, &delivery(Dialect::Sinumerik));
        (String::from_utf8(apply(text.as_bytes(), &done.edits)).unwrap(), done.gone, done.left)
    }

    // oracle: hand (full width comma and minus are characters that the control does not have)
    #[test]
    fn each_finding_of_a_kind_is_cured_where_it_is() {
        let text = "X\u{2212}5\n".repeat(100);
        let program = read(Dialect::Sinumerik, text.as_bytes());
        let found = super::super::findings(&program);
        let [first, ..] = &found[..] else { panic!("nothing found") };
        let (after, gone, left) = cured(&text, &first.message.key, &first.code.to_string());
        assert_eq!(after, "X-5\n".repeat(100));
        assert_eq!((gone, left), (100, 0));
    }
}
