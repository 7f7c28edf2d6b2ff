//! Where jumps go: the blocks of labels and block numbers. A program of a million blocks numbers each of them, so that
//! a number takes 16 bytes here and no text.

use super::tree::{Program, Word};
use std::collections::BTreeMap;
use std::ops::Range;

/// The blocks of labels and block numbers.
#[derive(Debug, Default)]
pub struct Targets {
    /// Block numbers with their blocks, in this order.
    numbers: Vec<(u64, usize)>,
    /// Blocks of labels that are no number, by their text in upper case.
    labels: BTreeMap<String, Vec<usize>>,
}

impl Targets {
    /// Those of a whole text.
    pub fn of(program: &Program) -> Targets {
        Targets::within(program, 0..program.blocks.len())
    }

    /// Those of some blocks.
    pub fn within(program: &Program, blocks: Range<usize>) -> Targets {
        let mut found = Targets::default();
        for at in blocks {
            let Some(block) = program.blocks.get(at) else { break };
            for name in block.number.into_iter().chain(program.words_of(block).iter().filter_map(Word::label)) {
                match std::str::from_utf8(program.text(name)).ok().and_then(number) {
                    Some(number) => found.numbers.push((number, at)),
                    None => found.labels.entry(program.name(name)).or_default().push(at),
                }
            }
        }
        found.numbers.sort_unstable();
        found
    }

    /// The blocks of a label or a block number, in the order of the text.
    pub fn blocks(&self, name: &str) -> Vec<usize> {
        let Some(number) = number(name) else { return self.labels.get(name).cloned().unwrap_or_default() };
        let from = self.numbers.partition_point(|(other, _)| *other < number);
        let own = self.numbers.iter().skip(from).take_while(|(other, _)| *other == number);
        own.map(|(_, block)| *block).collect()
    }
}

/// The number of `N0100`, `:100` or `100`.
fn number(name: &str) -> Option<u64> {
    name.strip_prefix(['N', 'n', ':']).unwrap_or(name).parse().ok()
}

/// `N0100`, `:100` and `100` are the same place.
pub fn canonical(name: &str) -> String {
    number(name).map_or_else(|| name.to_owned(), |number| format!("N{number}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dialect::Dialect;
    use crate::syntax::read;

    // oracle: hand
    #[test]
    fn a_number_is_found_however_it_is_written() {
        let text = "N10 G0\nn0020 X1\n:20 X2\nAGAIN: X3\nN10 AGAIN: X4\nN20\n";
        let program = read(Dialect::Sinumerik, text.as_bytes());
        let targets = Targets::of(&program);
        for name in ["N20", "20", ":20", "N020"] {
            assert_eq!(targets.blocks(name), [1, 2, 5], "{name}");
        }
        assert_eq!((targets.blocks("N10"), targets.blocks("AGAIN")), (vec![0, 4], vec![3, 4]));
        assert_eq!((targets.blocks("N30"), targets.blocks("NOWHERE")), (vec![], vec![]));
        let own = Targets::within(&program, 2..5);
        assert_eq!((own.blocks("N20"), own.blocks("N10"), own.blocks("AGAIN")), (vec![2], vec![4], vec![3, 4]));
    }
}
