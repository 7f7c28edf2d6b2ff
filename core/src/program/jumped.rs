//! Block numbers that a program names somewhere else: a jump, a repetition or a `CASE` leads there.

use super::flow::structure::target;
use crate::dialect::Dialect;
use crate::syntax::targets::canonical;
use crate::syntax::{Block, Program};
use std::collections::BTreeSet;

/// The block numbers to which something may lead.
pub(super) struct Jumped {
    /// A target that only a run knows may be any.
    any: bool,
    named: BTreeSet<String>,
}

impl Jumped {
    /// Of a program: whatever reads like a number of a block behind the number of a block itself.
    pub fn of(program: &Program) -> Jumped {
        let computed = |block: &Block| program.words_of(block).iter().any(|word| target(program, word) == Some(None));
        let any = program.dialect == Dialect::Nct || program.blocks.iter().any(computed);
        let mut named = BTreeSet::new();
        for block in &program.blocks {
            let text = program.written(block.span).to_ascii_uppercase();
            let own = block.number.map_or(0, |number| (number.end - block.span.start) as usize);
            let words = text.get(own..).unwrap_or_default().split(|c: char| !c.is_alphanumeric() && !"_:$".contains(c));
            named.extend(words.filter(|word| is_number(word)).map(canonical));
        }
        Jumped { any, named }
    }

    /// Whether something may lead to this block by its number.
    pub fn has(&self, program: &Program, block: &Block) -> bool {
        let named = |number: String| self.any || self.named.contains(&canonical(&number.to_ascii_uppercase()));
        block.number.is_some_and(|number| named(program.written(number)))
    }
}

/// `N20`, `:20`.
fn is_number(word: &str) -> bool {
    let digits = word.strip_prefix(['N', ':']).unwrap_or_default();
    !digits.is_empty() && digits.bytes().all(|digit| digit.is_ascii_digit())
}
