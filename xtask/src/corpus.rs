//! `cargo xtask corpus`: the reader, the checks and the interpreter on programs that others wrote.

use crate::tools::{cargo, run};
use anyhow::Result;
use std::path::PathBuf;

/// Options of `cargo xtask corpus`.
#[derive(clap::Args)]
pub struct Options {
    /// Programs, also in folders below it
    folder: PathBuf,
}

/// Prints what came of them; fails where a file is not read back to the byte.
pub fn corpus(options: &Options) -> Result<()> {
    let example = "run --locked --quiet --profile xtask -p probewright-core --features cli --example corpus --";
    run(cargo(example).arg(std::path::absolute(&options.folder)?))
}
