//! The fuzz targets on the project's own programs with pieces of them changed: a short run of what
//! `cargo xtask fuzz` does for long.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use probewright_fuzz::Extent;
use proptest::prelude::*;
use proptest::sample::{Index, select};
use std::path::{Path, PathBuf};

/// Every file below a folder.
fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path());
    entries.flat_map(|path| if path.is_dir() { files(&path) } else { vec![path] }).collect()
}

/// The programs that fuzzing starts from.
fn seeds() -> Vec<Vec<u8>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    ["tests/cases", "tests/right", "tests/wrong", "core/tests/programs"]
        .iter()
        .flat_map(|folder| files(&root.join(folder)))
        .filter(|path| path.extension().is_none_or(|ending| ending != "json"))
        .map(|path| std::fs::read(path).unwrap())
        .collect()
}

/// Puts bytes over a stretch of a program.
fn splice(program: &[u8], at: Index, length: usize, bytes: &[u8]) -> Vec<u8> {
    let from = at.index(program.len() + 1);
    let to = (from + length).min(program.len());
    [&program[..from], bytes, &program[to..]].concat()
}

// oracle: self (the targets demand it)
#[test]
fn the_programs_themselves_pass() {
    let seeds = seeds();
    assert!(seeds.len() > 6, "the seeds are found");
    for seed in seeds {
        probewright_fuzz::read(&seed, Extent::All);
        probewright_fuzz::run(&seed, Extent::All);
    }
}

// oracle: self (the targets demand it)
proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn changed_programs_pass(
        seed in select(seeds()),
        changes in proptest::collection::vec((any::<Index>(), 0..12_usize, proptest::collection::vec(any::<u8>(),
        0..6)), 1..6),
    ) {
        let program = changes.iter().fold(seed, |program, (at, length, bytes)| splice(&program, *at, *length, bytes));
        probewright_fuzz::read(&program, Extent::All);
        probewright_fuzz::run(&program, Extent::All);
    }
}
