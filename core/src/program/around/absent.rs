//! Blocks that one control has and the other cannot have, each with why: nothing is left out without a word.

use crate::dialect::Dialect;

/// A block that a control lacks.
pub struct Absent {
    /// Its name on the other control.
    pub name: &'static str,
    /// Key of the sentence that says why.
    pub why: &'static str,
}

const fn absent_block(name: &'static str, why: &'static str) -> Absent {
    Absent { name, why }
}

/// NCT: a text for the operator stops the program (#3000, #3006); the manual has no statement that shows one and goes
/// on, and none that writes a file: macros print at W with PRNT No. 9143 = 1 (C:60, C:1101). A half turn of the spindle
/// is an M function of the machine builder (C:74). O9920 alters the register of the tool and tells no deviation
/// (C:1196-1230).
const NCT: &[Absent] = &[
    absent_block("breakage", "around-absent-breakage"),
    absent_block("message", "around-absent-message"),
    absent_block("mean", "around-absent-mean"),
    absent_block("log", "around-absent-log"),
];

/// The blocks that a control lacks.
pub fn absent(dialect: Dialect) -> &'static [Absent] {
    match dialect {
        Dialect::Sinumerik => &[],
        Dialect::Nct => NCT,
    }
}

#[cfg(test)]
mod tests {
    use super::super::blocks;
    use super::*;

    // oracle: self (a block is on both controls, or it is said why not)
    #[test]
    fn no_block_is_missing_without_a_word() {
        let names = |dialect| blocks(dialect).iter().map(|block| block.name);
        let nct = names(Dialect::Nct).chain(absent(Dialect::Nct).iter().map(|one| one.name));
        let (mut here, mut there): (Vec<_>, Vec<_>) = (names(Dialect::Sinumerik).collect(), nct.collect());
        here.sort_unstable();
        there.sort_unstable();
        assert_eq!(here, there);
    }
}
