//! What happens behind a call: a corrected frame is in force only when it is programmed again (B:1965).

use super::{Seen, at, with_line_behind};
use crate::catalogue::{Kind, names};
use crate::check::{Finding, Target, target, warning};
use crate::diagnostic::{Code, Diagnostic};
use crate::evaluate::knum::{self, ZeroCode};
use crate::message::Message;
use crate::program::calls::CallSite;
use crate::program::fold::{self, Known};
use crate::program::tree::{Program, Word, WordKind};

/// What comes behind a call until the program ends.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Ahead {
    /// A frame is chosen.
    frame: bool,
    /// An axis moves, and no measuring call comes first.
    motion: bool,
}

/// What comes behind each call, in their order.
pub fn ahead(program: &Program, sites: &[CallSite]) -> Vec<Ahead> {
    let mut found = vec![Ahead::default(); sites.len()];
    let mut now = Ahead::default();
    let mut rest = sites.len();
    for word in program.words.iter().rev() {
        while rest > 0
            && sites
                .get(rest - 1)
                .is_some_and(|site| site.span == word.span)
        {
            rest -= 1;
            if let Some(ahead) = found.get_mut(rest) {
                *ahead = now;
            }
            now.motion = false;
        }
        match what(program, word) {
            What::Frame => now.frame = true,
            What::Motion => now.motion = true,
            What::End => now = Ahead::default(),
            What::Other => {}
        }
    }
    found
}

/// The program goes on in the old frame behind its last measuring call. Between two calls the old frame may be meant:
/// they measure one axis each.
pub fn look(seen: &Seen, ahead: Ahead, found: &mut Vec<Diagnostic>) {
    let corrected = corrected(seen).filter(|frame| seen.force.frame.is() == Some(frame));
    if let Some(frame) = corrected.filter(|_| ahead.motion && !ahead.frame) {
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
