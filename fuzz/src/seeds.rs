//! The programs that fuzzing starts from: those of the tests in pieces of some lines, each once, in one file of the
//! tree. A short input is tried many times as often as a long one, and what lines do together shows in a few.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// Folders of programs, from the root of the repository.
const FOLDERS: [&str; 4] = ["tests/cases", "tests/right", "tests/wrong", "core/tests/programs"];
/// What else lies there: descriptions and expectations.
const NO_PROGRAMS: [&str; 2] = ["json", "txt"];
/// Bytes of a piece, up to the end of a line.
const PIECE: usize = 300;
/// The line between two of them.
const BETWEEN: &[u8] = b"\n-- seed --\n";

/// Every program of the tests.
///
/// # Errors
/// A file or folder cannot be read.
pub fn programs(root: &Path) -> std::io::Result<Vec<Vec<u8>>> {
    let mut folders: Vec<PathBuf> = FOLDERS.iter().map(|folder| root.join(folder)).collect();
    let mut found = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in std::fs::read_dir(folder)? {
            let path = entry?.path();
            let ending = path.extension().unwrap_or_default().to_string_lossy().into_owned();
            if path.is_dir() {
                folders.push(path);
            } else if !NO_PROGRAMS.contains(&ending.as_str()) {
                found.push(std::fs::read(path)?);
            }
        }
    }
    Ok(found)
}

/// Programs as one file of pieces.
pub fn joined(programs: &[Vec<u8>]) -> Vec<u8> {
    let pieces: BTreeSet<Vec<u8>> = programs.iter().flat_map(|program| pieces(program)).collect();
    pieces.into_iter().collect::<Vec<_>>().join(BETWEEN)
}

/// The pieces of such a file.
pub fn split(file: &[u8]) -> Vec<Vec<u8>> {
    let mut all = vec![Vec::new()];
    let mut at = 0;
    while let Some(rest) = file.get(at..).filter(|rest| !rest.is_empty()) {
        if rest.starts_with(BETWEEN) {
            all.push(Vec::new());
            at += BETWEEN.len();
            continue;
        }
        if let Some(last) = all.last_mut() {
            last.extend(rest.first());
        }
        at += 1;
    }
    all
}

fn pieces(program: &[u8]) -> Vec<Vec<u8>> {
    let mut all: Vec<Vec<u8>> = Vec::new();
    for line in program.split_inclusive(|byte| *byte == b'\n') {
        match all.last_mut() {
            Some(last) if last.len() + line.len() <= PIECE => last.extend(line),
            _ => all.push(line.to_vec()),
        }
    }
    all
}
