//! The programs of a text: `%_N_NAME_SPF` begins one, a `PROC` behind blocks too, on NCT `O0110`; `%` alone the tape.

use super::tree::{Block, Program, Word, WordKind};
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

/// One program of a text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Unit {
    /// Blocks, header excluded.
    pub blocks: Range<usize>,
    /// The block of its `PROC`.
    pub signature: Option<usize>,
    /// Name of its file, as the header tells it.
    pub file: Option<String>,
}

/// All programs of a text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Programs {
    /// In the order of the text.
    pub units: Vec<Unit>,
    /// By name in upper case: of the header (`NAME` of `%_N_NAME_SPF`, `L10`; NCT `O110`), else of the `PROC`.
    pub names: BTreeMap<String, usize>,
    /// Names that an `EXTERN` declares.
    pub external: BTreeSet<String>,
    /// Blocks of the definition files in the text (`%_N_GUD4_DEF`), headers excluded: they are no programs.
    pub definitions: Vec<Range<usize>>,
}

impl Programs {
    /// Place in `units` of the program of a line, both from 0; none: the line of a header, or before the first one.
    pub fn of_line(&self, line: u32) -> Option<usize> {
        self.units.iter().position(|unit| unit.blocks.contains(&(line as usize)))
    }

    /// The program with this name, as a call writes it: `NAME`, `_N_NAME_SPF`.
    pub fn named(&self, name: &str) -> Option<&Unit> {
        self.units.get(self.place(name)?)
    }

    /// Place in `units` of the program with this name.
    pub fn place(&self, name: &str) -> Option<usize> {
        self.names.get(bare(name)).copied()
    }
}

/// Finds the programs of a text. There is always one.
pub fn programs(program: &Program) -> Programs {
    let mut found = Programs::default();
    let mut current = Unit::default();
    let mut empty = true;
    for (at, block) in program.blocks.iter().enumerate() {
        let header = header(program, block);
        let defines = header.as_ref().map_or(current.defines(), |name| is_definition(name));
        let procedure = declared(program, block, "PROC").filter(|_| !defines);
        let begins = header.is_some() || (procedure.is_some() && !empty);
        if begins {
            close(&mut found, &mut current, at, empty);
            let first = at + usize::from(header.is_some());
            current = Unit { blocks: first..first, file: header.clone(), ..Unit::default() };
        }
        // a call finds a program by its file; only where the text does not tell that, by its PROC
        let of_procedure = procedure.as_ref().filter(|_| current.file.is_none());
        if let Some(name) = header.as_ref().or(of_procedure).filter(|_| !defines) {
            found.names.entry(bare(name).to_owned()).or_insert(found.units.len());
        }
        if procedure.is_some() {
            current.signature = Some(at);
        }
        found.external.extend(declared(program, block, "EXTERN"));
        empty = header.is_some() || ((empty || begins) && says_nothing(program, block));
    }
    close(&mut found, &mut current, program.blocks.len(), false);
    if found.units.is_empty() {
        found.units.push(Unit { blocks: program.blocks.len()..program.blocks.len(), ..Unit::default() });
    }
    found
}

/// Ends a program; a stretch of empty lines before the first header is none.
fn close(found: &mut Programs, current: &mut Unit, end: usize, empty: bool) {
    if current.defines() {
        found.definitions.push(current.blocks.start..end);
    } else if !(found.units.is_empty() && found.names.is_empty() && empty) {
        current.blocks.end = end;
        found.units.push(current.clone());
    }
}

impl Unit {
    /// Whether it is no program, but a definition file.
    fn defines(&self) -> bool {
        self.file.as_deref().is_some_and(is_definition)
    }
}

/// Whether the name of a file is that of definitions: `GUD4_DEF`, `GUD4.DEF`.
pub fn is_definition(name: &str) -> bool {
    let end = name.len().checked_sub(4).and_then(|at| name.get(at..));
    end.is_some_and(|end| end.eq_ignore_ascii_case("_DEF") || end.eq_ignore_ascii_case(".DEF"))
}

/// Whether a block has no words, or on NCT the `%` of the tape alone.
fn says_nothing(program: &Program, block: &Block) -> bool {
    !block.plain && program.words_of(block).iter().all(|word| matches!(word.kind, WordKind::Header))
}

fn header(program: &Program, block: &Block) -> Option<String> {
    let mut words = program.words_of(block).iter();
    let word = words.find(|word| matches!(word.kind, WordKind::Header))?;
    let found = program.name(word.span);
    let name = found.trim_start_matches('%');
    if program.grammar().numbered { numbered(name.get(1..)?.parse().ok()?) } else { Some(bare(name).to_owned()) }
}

/// Name of the NCT program with this number: `O0110` and `:110` are `O110`.
pub fn numbered(number: f64) -> Option<String> {
    (number.fract() == 0.0 && number > 0.0).then(|| format!("O{number}"))
}

/// The name behind `PROC` or `EXTERN`.
fn declared(program: &Program, block: &Block, keyword: &str) -> Option<String> {
    let words = program.words_of(block);
    words.iter().find(|word| program.is_keyword(word, &[keyword]))?;
    words.iter().find_map(Word::declared).map(|name| program.name(name))
}

/// What may stand behind the name of a program, in upper case: as the control names its files, and as a PC does.
const ENDINGS: [&str; 4] = ["_SPF", "_MPF", ".SPF", ".MPF"];

/// `/_N_WKS_DIR/_N_PART_WPD/_N_NAME_SPF`, `C:\PART\NAME.SPF` without what is no part of the name.
pub fn bare(path: &str) -> &str {
    let name = path.trim().rsplit(['/', '\\', ':']).next().unwrap_or(path).trim_start_matches("_N_");
    ENDINGS.iter().find_map(|ending| name.strip_suffix(ending)).unwrap_or(name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::dialect::Dialect::Sinumerik;
    use crate::syntax::read;

    fn ranges(text: &str) -> Vec<(usize, usize)> {
        let found = programs(&read(Sinumerik, text.as_bytes()));
        let ends = |unit: &Unit| (unit.blocks.start, unit.blocks.end);
        found.units.iter().map(ends).collect()
    }

    // oracle: hand
    #[test]
    fn headers_and_procedures_begin_programs() {
        assert_eq!(ranges("G0\nG1"), [(0, 2)]);
        assert_eq!(ranges("\n%_N_A_MPF\nG0\n%_N_B_SPF\nPROC B\nM17"), [(2, 3), (4, 6)]);
        assert_eq!(ranges("PROC A\nG0\nPROC B(INT I)\nRET"), [(0, 2), (2, 4)]);
        assert_eq!(ranges("G0\n%_N_B_SPF\nM17"), [(0, 1), (2, 3)]);
        assert_eq!(ranges("").len(), 1);
    }

    // oracle: hand (a definition file holds no program, wherever it stands; a text without a program has an empty one)
    #[test]
    fn definition_files_are_no_programs() {
        let text = "%_N_GUD4_DEF\nDEF NCK INT A\nPROC NO\nM17\n%_N_A_MPF\nG0\n%_N_UGUD_DEF\nM17\n%_N_B_SPF\nM17";
        let found = programs(&read(Sinumerik, text.as_bytes()));
        assert_eq!(ranges(text), [(5, 6), (9, 10)]);
        assert_eq!(found.definitions, [1..4, 7..8]);
        assert_eq!(found.names.keys().collect::<Vec<_>>(), ["A", "B"]);
        assert_eq!(ranges("%_N_GUD4_DEF\nDEF NCK INT A"), [(2, 2)]);
    }

    // oracle: hand
    #[test]
    fn a_program_is_found_by_each_way_to_write_its_name() {
        let text = "EXTERN FAR(INT)\nM30\n%_N_NEAR_SPF\nM17";
        let found = programs(&read(Sinumerik, text.as_bytes()));
        assert_eq!(found.named("NEAR").map(|unit| unit.blocks.start), Some(3));
        assert_eq!(found.named("_N_NEAR_SPF"), found.named("NEAR"));
        let path = "/_N_WKS_DIR/_N_PART_WPD/_N_NEAR_SPF";
        assert_eq!(found.named(path), found.named("NEAR"));
        for way in ["NEAR.SPF", "NEAR_SPF", "_N_NEAR_MPF", "C:\\PART\\NEAR.MPF", "LOCAL_DRIVE:NEAR.SPF"] {
            assert_eq!(found.named(way), found.named("NEAR"), "{way}");
        }
        assert_eq!(found.named("FAR"), None);
        assert!(found.external.contains("FAR"));
    }
}
