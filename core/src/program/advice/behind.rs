//! What happens behind a call: a corrected frame is in force only when it is programmed again (B:1965).

use super::{Seen, at, with_line_behind};
use crate::catalogue::{Kind, names};
use crate::check::{Finding, Target, target, warning};
use crate::diagnostic::{Code, Diagnostic};
use crate::evaluate::knum::{self, ZeroCode};
use crate::message::Message;
use crate::program::fold::{self, Known};
use crate::program::tree::{Program, Word, WordKind};

/// Motion or measuring in the old frame after it was corrected.
pub fn look(seen: &Seen, found: &mut Vec<Diagnostic>) {
    let Some(frame) = corrected(seen).filter(|frame| seen.modal.frame == Some(*frame)) else {
        return;
    };
    let behind = seen
        .program
        .words
        .partition_point(|word| word.span.start < seen.site.span.end);
    let words = seen.program.words.get(behind..).unwrap_or_default();
    let next = seen.sites.get(seen.index + 1).map(|site| site.span);
    let first = words
        .iter()
        .find_map(|word| match what(seen.program, word) {
            What::Other if Some(word.span) == next => Some(true),
            What::Other => None,
            What::Motion => Some(true),
            What::Frame | What::End => Some(false),
        });
    let moves = first.unwrap_or(false);
    if moves {
        let name = format!("G{frame}");
        let message = Message::new("advice-frame").text("frame", name.as_str());
        let hint = Message::new("advice-frame-hint").text("frame", name.as_str());
        let finding = warning(Code::Own(137), message).hint(hint);
        found.push(at(with_line_behind(finding, seen, &name), seen.site.span));
    }
}

/// Number of the G function of the settable frame that the call corrects.
fn corrected(seen: &Seen) -> Option<u16> {
    let param = seen.site.cycle.param(names::KNUM)?;
    param.need(&seen.inputs)?;
    if !matches!(param.kind, Kind::Knum) || target(param, &seen.inputs) != Target::Zero {
        return None;
    }
    match knum::zero(seen.inputs.given(names::KNUM)? as i64) {
        Ok(Some(ZeroCode::Settable(number))) => u16::try_from(number).ok().map(|number| {
            if number < 5 {
                53 + number
            } else {
                500 + number
            }
        }),
        _ => None,
    }
}

/// What a word says about frames.
enum What {
    /// A frame is chosen.
    Frame,
    /// The program ends.
    End,
    /// An axis moves.
    Motion,
    /// Nothing.
    Other,
}

fn what(program: &Program, word: &Word) -> What {
    let WordKind::Address { name, value, .. } = &word.kind else {
        return What::Other;
    };
    let number = fold::number(program, *value, &Known::new()).unwrap_or(-1.0);
    match program.name(*name).as_str() {
        "G" if matches!(number as i64, 53..=57 | 500 | 505..=599) => What::Frame,
        "M" if matches!(number as i64, 2 | 17 | 30) => What::End,
        "X" | "Y" | "Z" => What::Motion,
        _ => What::Other,
    }
}
