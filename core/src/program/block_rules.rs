//! What a block of SINUMERIK may not say although each of its words is understood.

use crate::catalogue::list::unmatched;
use crate::check::listed::count;
use crate::diagnostic::{Diagnostic, Span};
use crate::own;
use crate::own::Own;
use crate::syntax::fold::NOTHING;
use crate::syntax::{Block, Program, Word, WordKind, fold};

/// Addresses that a block takes once, so that it says one thing: all that are no function, no block number, no
/// parameter and no repetition. With an extension (`S1=500`) they are others.
const ONCE: &[u8] = b"ABCDFIJKSTUVWXYZ";

/// Axes that every machine has: no variable takes their names.
const AXES: [&str; 3] = ["X", "Y", "Z"];

pub(super) fn block_rules(program: &Program) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    for block in &program.blocks {
        let mut seen = 0_u32;
        for word in program.words_of(block) {
            if let Some((place, span)) = once(program, word) {
                if seen & (1 << place) != 0 {
                    found.push(at(&own::BLOCK_TWICE, program, span, word.span));
                }
                seen |= 1 << place;
            } else if let WordKind::Declare { name, .. } = word.kind
                && AXES.iter().any(|axis| program.is(name, axis))
            {
                found.push(at(&own::BLOCK_AXIS_NAME, program, name, name));
            } else if let WordKind::Declare { name, .. } = word.kind
                && defines(program, block)
                && is_address(program.text(name))
            {
                found.push(at(&own::BLOCK_LETTER_NAME, program, name, name));
            } else if let WordKind::Call { name, ref args, .. } = word.kind {
                let given: Vec<_> = args.iter().map(|id| program.given(*id)).collect();
                let number = |index: usize| {
                    let id = given.get(index).copied().flatten();
                    id.map_or(Some(0.0), |id| fold::number(program, id, NOTHING))
                };
                let finding = unmatched(&program.name(name), count(&given), number);
                found.extend(finding.map(|finding| finding.on(word.span)));
            }
        }
    }
    found
}

fn defines(program: &Program, block: &Block) -> bool {
    program.words_of(block).first().is_some_and(|word| program.is_keyword(word, &["DEF"]))
}

/// Whether a name is that of an address, `M` or `M1`: the name of a variable begins with two letters or underscores
/// (840D sl, Fundamentals, "Naming variables").
fn is_address(name: &[u8]) -> bool {
    name.first().is_some_and(u8::is_ascii_alphabetic) && name.get(1).is_none_or(u8::is_ascii_digit)
}

/// The place in `ONCE` of an address, and its letter.
fn once(program: &Program, word: &Word) -> Option<(usize, Span)> {
    let WordKind::Address { name, extension: None, .. } = word.kind else { return None };
    let [letter] = program.text(name) else { return None };
    let place = ONCE.iter().position(|one| letter.eq_ignore_ascii_case(one));
    place.map(|place| (place, name))
}

fn at(sentence: &Own, program: &Program, name: Span, span: Span) -> Diagnostic {
    sentence.finding().text("word", program.name(name)).on(span)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dialect::Dialect;
    use crate::syntax::read;

    // oracle: hand (the control takes an address once a block, functions and extended addresses as often as they say
    // something else; a variable has no name of an axis)
    #[test]
    fn what_a_block_may_not_say_is_told_at_its_place() {
        let told = |text: &str| {
            let program = read(Dialect::Sinumerik, text.as_bytes());
            let found = block_rules(&program).into_iter();
            let place = |one: Diagnostic| {
                let span = one.span.unwrap_or_default();
                let text = String::from_utf8_lossy(program.text(span)).into_owned();
                (one.code, text)
            };
            found.map(place).collect::<Vec<_>>()
        };
        for (text, sentence, word) in [
            ("G0 X1 Y2 X3", own::BLOCK_TWICE, "X3"),
            ("N10 G1 X=R1 x=IC(5)", own::BLOCK_TWICE, "x=IC(5)"),
            ("T1 D1 T2", own::BLOCK_TWICE, "T2"),
            ("DEF REAL X", own::BLOCK_AXIS_NAME, "X"),
            ("DEF INT _A, y=3", own::BLOCK_AXIS_NAME, "y"),
            ("DEF REAL M[3]", own::BLOCK_LETTER_NAME, "M"),
            ("DEF CHAN INT _1, I1=5", own::BLOCK_LETTER_NAME, "I1"),
        ] {
            assert_eq!(told(text), [(sentence.code(), word.to_owned())], "{text}");
        }
        for text in [
            "G0 G90 M3 M8 X1 Y2", "S1=500 S2=300 S700", "R1=1 R1=2", "X1\nX2", "POS[X]=1 POS[Y]=2",
            "DEF REAL XY, _X, I_, _1", "PROC L10(REAL A)",
        ] {
            assert_eq!(told(text), [], "{text}");
        }
    }
}
