//! The comment with the settings that belongs to a call.

use super::calls::CallSite;
use crate::diagnostic::Span;
use crate::support::{BITS, Mark};
use crate::syntax::{Block, Program, Word, WordKind};

/// The comment with the settings and its place, on the line before the call's first; lines that set nothing but bits
/// for it may stand between.
pub fn mark_before(program: &Program, site: &CallSite) -> Option<(Mark, Span)> {
    let block = program.blocks.get(..site.first_line as usize)?.iter().rfind(|block| !sets_bits(program, block))?;
    let place = block.comment?;
    Some((Mark::read(std::str::from_utf8(program.text(place)).ok()?)?, place))
}

fn sets_bits(program: &Program, block: &Block) -> bool {
    let words = program.words_of(block);
    let is_bit = |word: &Word| match &word.kind {
        WordKind::Assign { value_span, .. } => {
            let target = Span { end: value_span.start, ..word.span };
            let text: String = program.name(target).chars().filter(|one| !one.is_whitespace()).collect();
            BITS.iter().any(|bit| text.strip_suffix('=') == Some(bit))
        }
        _ => false,
    };
    !words.is_empty() && block.comment.is_none() && words.iter().all(is_bit)
}
