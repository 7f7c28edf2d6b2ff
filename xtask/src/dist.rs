//! The whole page as a folder of files.

use crate::{page, tools, wasm};
use anyhow::Result;

/// Gets what is missing and builds `dist/`.
pub fn build() -> Result<()> {
    tools::wasm_target()?;
    page::packages()?;
    wasm::build()?;
    page::build()
}

/// `cargo xtask dist`.
pub fn dist() -> Result<()> {
    build()?;
    println!("{} is ready for any static file server", tools::root().join("dist").display());
    Ok(())
}
