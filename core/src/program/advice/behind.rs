//! What happens behind a call: a corrected frame that is only stored counts when it is programmed again (B:1965).

use super::{Seen, behind_call};
use crate::check::{Target, target};
use crate::control::Store;
use crate::diagnostic::Diagnostic;
use crate::entry::{Kind, ProbeUse, names};
use crate::evaluate::knum::{self, ZeroCode};
use crate::own;
use crate::program::calls::CallSite;
use crate::program::flow;
use crate::program::flow::{Follow, Meet, Mode};
use crate::program::of_control::{SWIVEL, is_frame};
use crate::syntax::programs::Programs;
use crate::syntax::{Block, Plain, Program, Word, WordKind};
use std::collections::BTreeMap;

/// A frame that a call corrects where it is stored, and the one active there.
#[derive(Clone, Debug, PartialEq)]
pub struct Corrected {
    /// G function that takes it; none: a basic or system frame, which each of them takes.
    function: Option<u16>,
    active: Mode<u16>,
    /// The function that brings it into effect, where it is known.
    cure: Option<u16>,
}

impl Corrected {
    /// Whether the program moves in it before it is taken anew.
    fn in_force(&self) -> bool {
        self.function.as_ref().is_none_or(|function| self.active.is() == Some(function))
    }
}

/// What the call corrects; none where nothing is, or where it counts at once (`_KNUM` = 9999).
pub fn corrected(seen: &Seen) -> Option<Corrected> {
    let param = seen.site.cycle.param(names::KNUM.as_str())?;
    param.need(&seen.inputs)?;
    if !matches!(param.kind, Kind::Knum) || target(param, &seen.inputs) != Target::Zero {
        return None;
    }
    let code = knum::zero(seen.inputs.given(names::KNUM)? as i64).ok()??;
    let active = seen.force.frame.clone();
    let function = match code {
        ZeroCode::Stored(Store::Settable(number)) => Some(function(u16::try_from(number).ok()?)),
        _ => None,
    };
    let cure = match code {
        ZeroCode::Active => return None,
        ZeroCode::LastBasic => Some(500), // calculated for it, B:1945
        _ => function.or(active.is().copied()),
    };
    Some(Corrected { function, active, cure })
}

/// G54 to G57, G505 to G599.
fn function(number: u16) -> u16 {
    if number < 5 { 53 + number } else { 500 + number }
}

/// The program never takes a frame that a call corrected. Between two calls that may be meant: one axis each.
pub fn look(
    program: &Program,
    programs: &Programs,
    sites: &[CallSite],
    corrected: &BTreeMap<usize, Corrected>,
    found: &mut Vec<Diagnostic>,
) {
    if corrected.is_empty() {
        return;
    }
    let mut rules = Rules { program, sites, corrected, forgotten: BTreeMap::new() };
    flow::follow(program, programs, &mut rules);
    for (index, waiting) in rules.forgotten {
        if let Some((site, frame)) = sites.get(index).zip(corrected.get(&index)) {
            found.push(finding(program, site, frame, &waiting));
        }
    }
}

fn finding(program: &Program, site: &CallSite, frame: &Corrected, waiting: &Waiting) -> Diagnostic {
    let known = frame.cure.map(|code| format!("G{code}"));
    let word = known.clone().unwrap_or("G500, G54 …".to_owned());
    let finding = match (frame.function, waiting.other) {
        (None, _) => own::ADVICE_FRAME_BASIC.finding(),
        (_, Some(other)) => own::ADVICE_FRAME_OTHER.finding().text("other", format!("G{other}")),
        _ => own::ADVICE_FRAME.finding(),
    };
    let finding = finding.text("frame", word.as_str()).hint_text("frame", word.as_str()).on(site.span);
    match known {
        Some(word) => behind_call(finding, program, site, &word),
        None => finding,
    }
}

/// Corrected frames that were not taken yet, by the call.
type Pending = BTreeMap<usize, Waiting>;

/// What happened since the correction.
#[derive(Clone, Debug, Default, PartialEq)]
struct Waiting {
    /// An axis moved.
    moved: bool,
    /// Another frame was taken instead.
    other: Option<u16>,
}

struct Rules<'a> {
    program: &'a Program,
    sites: &'a [CallSite],
    corrected: &'a BTreeMap<usize, Corrected>,
    forgotten: Pending,
}

impl Rules<'_> {
    /// A frame is taken: G500, G54 and so on.
    fn take(&self, pending: &mut Pending, code: u16) {
        pending.retain(|index, waiting| {
            let Some(corrected) = self.corrected.get(index) else { return false };
            match corrected.function {
                // Who leaves the old one moves in it no more; who never was in it may have taken the wrong one.
                Some(function) if function != code => {
                    waiting.other = (code != 500).then_some(code).or(waiting.other);
                    !corrected.in_force()
                }
                _ => false,
            }
        });
    }

    /// What moved the axes, in frames that were corrected and not taken.
    fn use_all(&self, pending: &mut Pending) {
        for (index, waiting) in pending {
            waiting.moved |= waiting.other.is_some() || self.corrected.get(index).is_some_and(Corrected::in_force);
        }
    }
}

impl Follow for Rules<'_> {
    type State = Pending;

    fn block(&mut self, pending: &mut Pending, words: &[Word]) {
        if pending.is_empty() {
            return;
        }
        for code in words.iter().filter_map(|word| self.program.constant(word, "G")) {
            if matches!(code as i64, 54..=57 | 500 | 505..=599) {
                self.take(pending, code as u16);
            }
        }
        if words.iter().any(|word| sets_frame(self.program, word)) {
            pending.clear();
        } else if moves(self.program, words) {
            self.use_all(pending);
        }
    }

    fn motion(&mut self, pending: &mut Pending, block: &Block) {
        let axis = |motion: Plain| motion.parts().any(|part| b"XYZ".contains(&part.letter));
        if !pending.is_empty() && self.program.plain(block).is_some_and(axis) {
            self.use_all(pending);
        }
    }

    fn call(&mut self, pending: &mut Pending, word: &Word) {
        let Some(name) = word.called() else { return };
        let Ok(index) = self.sites.binary_search_by_key(&word.span.start, |site| site.span.start) else {
            if is_machining(&self.program.name(name)) {
                self.use_all(pending);
            }
            return;
        };
        let site = self.sites.get(index);
        if site.is_none_or(|site| site.cycle.purpose.probe != ProbeUse::Workpiece) {
            return;
        }
        let now = self.corrected.get(&index);
        pending.retain(|before, _| now.is_none() || self.corrected.get(before) != now);
        self.use_all(pending);
        if now.is_some() {
            pending.insert(index, Waiting::default());
        }
    }

    fn elsewhere(&self, pending: &mut Pending) {
        pending.clear();
    }

    fn end(&mut self, pending: &Pending) {
        let moved = pending.iter().filter(|(_, waiting)| waiting.moved);
        self.forgotten.extend(moved.map(|(index, waiting)| (*index, waiting.clone())));
    }
}

impl Meet for Pending {
    fn meet(&self, other: &Pending) -> Pending {
        let both = self.iter().filter_map(|(index, waiting)| {
            let there = other.get(index)?;
            let frame = waiting.other.filter(|_| waiting.other == there.other);
            Some((*index, Waiting { moved: waiting.moved && there.moved, other: frame }))
        });
        both.collect()
    }
}

/// G functions beside which an axis word moves nothing in the active frame: of the machine, or writing a frame.
const BESIDE: [f64; 6] = [53.0, 58.0, 59.0, 74.0, 75.0, 153.0];

/// Whether an axis moves in the active frame.
fn moves(program: &Program, words: &[Word]) -> bool {
    let axis = |word: &Word| ["X", "Y", "Z"].iter().any(|axis| program.address(word, axis).is_some());
    let beside = |word: &Word| match word.called() {
        Some(name) => program.is(name, "SUPA") || is_frame(&program.name(name)),
        None => program.constant(word, "G").is_some_and(|code| BESIDE.contains(&code)),
    };
    words.iter().any(axis) && !words.iter().any(beside)
}

/// Whether a frame in effect is written: `$P_IFRAME=…`, `$P_CHBFRAME[0]=…`.
fn sets_frame(program: &Program, word: &Word) -> bool {
    const IN_EFFECT: [&str; 4] = ["$P_IFRAME", "$P_CHBFRAME", "$P_NCBFRAME", "$P_SETFRAME"];
    let WordKind::Assign { name, .. } = word.kind else { return false };
    IN_EFFECT.iter().any(|known| program.is(name, known))
}

/// Whether a call that measures nothing moves the axes: `CYCLE81` and so on, not the cycles that only swivel or set.
fn is_machining(name: &str) -> bool {
    let digits = name.strip_prefix("CYCLE").unwrap_or_default();
    digits.starts_with(|first: char| first.is_ascii_digit()) && ![SWIVEL, "CYCLE832"].contains(&name)
}
