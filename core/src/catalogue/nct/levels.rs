//! How deep a macro of an NCT control goes: a call needs these levels beside those of the programs that lead to it.

use crate::entry::Cycle;

/// Levels that a macro calls itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Levels {
    /// Of macros below it.
    pub macros: usize,
    /// Of subprograms.
    pub subprograms: usize,
    /// Place in the manual.
    pub source: &'static str,
}

/// Entry, macros below it, subprograms, place.
const TABLE: &[(&str, usize, usize, &str)] = &[
    ("G101", 0, 2, "C:142-144"),
    ("G102", 1, 2, "C:216-218"),
    ("G103", 1, 2, "C:345"),
    ("G104", 1, 2, "C:419"),
    ("G105", 1, 2, "C:551"),
    ("G106", 1, 2, "C:674"),
    ("G107", 2, 2, "C:766"),
    ("G108", 2, 2, "C:849"),
    ("G109", 2, 2, "C:999"),
    ("G110", 2, 2, "C:1157"),
    // it calls itself as a subprogram, one level deep
    ("G65 P9920", 0, 1, "C:1189"),
    ("G65 P9969", 1, 2, "C:1276-1355"),
];

/// Levels of this macro; none: the manual does not print them.
pub fn levels(cycle: &Cycle) -> Option<Levels> {
    let row = TABLE.iter().find(|(name, ..)| *name == cycle.name);
    row.map(|(_, macros, subprograms, source)| Levels { macros: *macros, subprograms: *subprograms, source })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::catalogue::CYCLES;
    use crate::dialect::Dialect;
    use crate::manual::Cited;

    // oracle: manual: what the help page of a macro says of its levels is in the table too
    #[test]
    fn every_macro_has_the_levels_of_its_help() {
        let macros: Vec<_> = CYCLES.iter().filter(|cycle| cycle.dialect == Dialect::Nct).collect();
        assert_eq!(macros.len(), TABLE.len());
        for cycle in macros {
            let found = levels(cycle);
            assert!(found.is_some_and(|one| !Cited(one.source).to_string().is_empty()), "{}", cycle.name);
            let told = cycle.help.lines().find_map(|line| line.key.strip_prefix("help-levels-"));
            let number = told.map(|word| match word {
                "none" => (0, 2),
                "one" => (1, 2),
                _ => (2, 2),
            });
            let table = found.map(|one| (one.macros, one.subprograms));
            assert!(number.is_none() || number == table, "{}: {table:?}", cycle.name);
        }
    }
}
