//! The fuzz targets on the project's own programs with pieces of them changed: a short run of what
//! `cargo xtask fuzz` does for long.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use probewright_fuzz::{Extent, seeds};
use proptest::prelude::*;
use proptest::sample::{Index, select};
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// The programs that fuzzing starts from.
fn programs() -> Vec<Vec<u8>> {
    seeds::programs(&root()).unwrap()
}

// oracle: self: what was joined is split; PROBEWRIGHT_UPDATE=1 makes the file anew from the programs of the tests
#[test]
fn the_seeds_are_pieces_of_programs() {
    let file = root().join("fuzz/seeds");
    if std::env::var_os("PROBEWRIGHT_UPDATE").is_some() {
        std::fs::write(&file, seeds::joined(&programs())).unwrap();
    }
    let all = std::fs::read(&file).unwrap();
    let pieces = seeds::split(&all);
    assert!(pieces.len() > 100 && pieces.iter().all(|piece| piece.len() < 1000 && !piece.is_empty()));
    assert_eq!(seeds::joined(&pieces), all);
    for piece in pieces {
        probewright_fuzz::read(&piece, Extent::Drawn);
        probewright_fuzz::run(&piece, Extent::Drawn);
    }
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
    let programs = programs();
    assert!(programs.len() > 100, "the programs are found");
    for seed in programs {
        probewright_fuzz::read(&seed, Extent::All);
        probewright_fuzz::run(&seed, Extent::All);
    }
}

// oracle: self (the targets demand it)
proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn changed_programs_pass(
        seed in select(programs()),
        changes in proptest::collection::vec((any::<Index>(), 0..12_usize, proptest::collection::vec(any::<u8>(),
        0..6)), 1..6),
    ) {
        let program = changes.iter().fold(seed, |program, (at, length, bytes)| splice(&program, *at, *length, bytes));
        probewright_fuzz::read(&program, Extent::All);
        probewright_fuzz::run(&program, Extent::All);
    }
}
