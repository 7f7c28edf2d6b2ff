//! What several tests need: where things are in the repository.

pub mod rust;

use std::path::{Path, PathBuf};

/// The root of the repository.
#[must_use]
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().map_or_else(PathBuf::new, Path::to_path_buf)
}

/// What is built, fetched or written by a test (`wire.ts`), which nobody reads as a source.
const MADE: [&str; 6] = ["target", "node_modules", "dist", "pkg", ".git", "wire.ts"];

/// The files below a folder whose names end so (without the dot).
///
/// # Panics
/// The folder cannot be read.
#[must_use]
#[allow(clippy::expect_used)]
pub fn files(folder: &Path, endings: &[&str]) -> Vec<PathBuf> {
    let made = |path: &Path| path.file_name().is_some_and(|name| MADE.iter().any(|made| *made == name));
    let known = |path: &Path| path.extension().is_some_and(|own| endings.iter().any(|ending| *ending == own));
    let entries = std::fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path());
    let below = entries.filter(|path| !made(path)).flat_map(|path| match path.is_dir() {
        true => files(&path, endings),
        false => Some(path).filter(|path| known(path)).into_iter().collect(),
    });
    below.collect()
}
