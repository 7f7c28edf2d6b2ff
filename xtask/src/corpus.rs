//! `cargo xtask corpus`: the reader, the checks and the interpreter on programs that others wrote.

use crate::tools::{cargo, run};
use anyhow::Result;
use std::path::PathBuf;

/// Options of `cargo xtask corpus`.
#[derive(clap::Args)]
pub struct Options {
    /// Programs of one machine each, also in folders below it
    #[arg(required = true, value_name = "FOLDER")]
    folders: Vec<PathBuf>,
}

/// Prints what came of each; fails where a file is not read back to the byte.
pub fn corpus(options: &Options) -> Result<()> {
    let example = "run --locked --quiet --profile xtask -p probewright-core --features cli --example corpus --";
    let mut command = cargo(example);
    for folder in &options.folders {
        command.arg(std::path::absolute(folder)?);
    }
    run(&mut command)
}
