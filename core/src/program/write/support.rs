//! The block that the support in the control's editor writes: what its form holds, in its order (B:12414-12423).

use super::{Lines, Source, value, word};
use crate::control::Control;
use crate::entry::names::{
    CORA, DLNUM, EVNUM, FA, ID, K, KNUM, MVAR, NMSP, PRNUM, SZA, SZO, TDIF, TENV, TLL, TMV, TNAME, TNUM, TSA, TUL, TZL,
    VMS,
};
use crate::entry::{Cycle, Style, Typed};
use crate::name::Name;
use crate::support::{MEAN_BIT, Mark, SPEEDS_BIT, Support, decimal};

const SPEEDS: Name = Name::new(SPEEDS_BIT);
const MEAN: Name = Name::new(MEAN_BIT);
/// Order of the first block, as in the example for a hole; fields of other forms stand behind the set size.
const FIRST: [Name; 13] = [MVAR, OTHERS, PRNUM, KNUM, FA, TSA, VMS, NMSP, ID, SZA, SZO, CORA, SPEEDS];
/// Order of the second block: tolerances, memories and the tool.
const SECOND: [Name; 12] = [TZL, TDIF, TUL, TLL, MEAN, TMV, K, EVNUM, TNUM, TNAME, DLNUM, TENV];
/// Where everything else stands.
const OTHERS: Name = Name::new("");

/// What a form with these settings writes. It leaves no field open: what was not typed counts as delivered. The lists
/// of newer controls are not of this support; what has no field is not among their values.
pub(super) fn source<'a>(
    support: Support,
    cycle: &'static Cycle,
    typed: &Typed,
    control: &'a Control,
    style: Style,
) -> Source<'a> {
    let entered = support.entered(cycle, typed, control);
    let mut source = super::source(cycle, &entered.values, control);
    if style == Style::Operate {
        source.values.retain(|(param, _)| !support.hides(param, &source.inputs));
        return source;
    }
    let used = cycle.params.iter().filter(|param| param.need(&source.inputs).is_some());
    source.values = used
        .filter_map(|param| {
            let typed = entered.values.get(param.name.as_str()).map_or("", |text| text.trim());
            let text = match typed {
                "" => param.fallback(control).map(decimal),
                typed => value(cycle.dialect, param, typed),
            };
            Some((param, text?))
        })
        .collect();
    Source { form: true, bits: entered.bits, ..source }
}

/// Assignments in two blocks and the call in one of its own.
pub(super) fn blocks(source: &Source) -> Lines {
    let values =
        source.values.iter().map(|(param, value)| (Some(param.name), word(&param.name, value), rank(&param.name)));
    let bits = source.bits.iter().map(|(name, on)| (None, bit(name, *on), rank(name)));
    let words: Vec<(Option<Name>, String, usize)> = values.chain(bits).collect();
    let mut text = Lines::default();
    let [first, second] = [FIRST.len(), FIRST.len() + SECOND.len()];
    for ranks in [0..first, first..second] {
        for (of, word, _) in ranks.flat_map(|rank| words.iter().filter(move |(_, _, own)| *own == rank)) {
            if text.width > 0 {
                text.push(" ");
            }
            text.word(*of, word);
        }
        if text.width > 0 {
            text.line_end();
        }
    }
    text.push(source.cycle.name);
    text.line_end();
    text
}

/// Place in the order, the second block behind the first.
fn rank(name: &str) -> usize {
    let place = |order: &[Name], name: &str| order.iter().position(|one| *one == name);
    let others = || place(&FIRST, &OTHERS).unwrap_or_default();
    let second = place(&SECOND, name).map(|place| FIRST.len() + place);
    second.or_else(|| place(&FIRST, name)).unwrap_or_else(others)
}

fn bit(name: &str, on: bool) -> String {
    word(name, if on { "1" } else { "0" })
}

/// What stands before the call: the settings, and for a call with arguments the bits, which no argument takes.
pub(super) fn head(source: &Source, style: Style) -> String {
    let mark = Mark::of(source.control).text();
    let mut text = Lines::default();
    text.push(&mark);
    text.line_end();
    if style == Style::Indirect {
        let bits: Vec<_> = source.bits.iter().map(|(name, on)| (None, bit(name, *on))).collect();
        text.assignments(&bits);
    }
    text.text
}
