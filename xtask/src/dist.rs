//! The whole page as a folder of files.

use crate::steps::Steps;
use crate::wasm::Make;
use crate::{book, editor, package, page, tools, wasm};
use anyhow::Result;

/// Of how many steps [`build`] is.
pub const STEPS: usize = 1 + wasm::STEPS + AROUND;
/// Of how many steps [`build_around`] is.
pub const AROUND: usize = 4;

/// Gets what is missing and builds `dist/`.
pub fn build(steps: &mut Steps, make: Make) -> Result<()> {
    steps.run("what is missing", prepare)?;
    wasm::build(steps, make)?;
    build_around(steps, make)
}

/// Gets what is missing.
pub fn prepare() -> Result<()> {
    tools::wasm_target()?;
    page::packages()
}

/// Builds `dist/` around the modules in `pkg/`.
pub fn build_around(steps: &mut Steps, make: Make) -> Result<()> {
    steps.run("page", page::build)?;
    steps.run("handbook", || book::build(&tools::root().join("dist/book")))?;
    steps.run("npm package", || if make == Make::Small { package::pack() } else { Ok(()) })?;
    steps.run("extension", || if make == Make::Small { editor::pack() } else { Ok(()) })
}

/// `cargo xtask dist`.
pub fn dist() -> Result<()> {
    build(&mut Steps::of(STEPS), Make::Small)?;
    println!("{} is ready for any static file server", tools::root().join("dist").display());
    println!("{} holds the npm package and the extension for Visual Studio Code", tools::root().join("pkg").display());
    Ok(())
}
