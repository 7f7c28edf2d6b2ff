//! The page: npm packages and Vite.

use crate::tools::{command, node, npm, root, run, step};
use anyhow::{Context, Result};
use std::fs;
use std::path::Path;
use std::process::Command;

/// Gets the npm packages, only when they are missing or the lock file changed since.
pub fn packages() -> Result<()> {
    node()?;
    let www = root().join("www");
    let lock = fs::read(www.join("package-lock.json")).context("www/package-lock.json")?;
    let installed = www.join("node_modules/.installed-lock.json");
    if fs::read(&installed).is_ok_and(|known| known == lock) {
        return Ok(());
    }
    step("npm packages", || {
        run(npm().args(["ci", "--no-audit", "--no-fund"]).current_dir(&www))?;
        fs::write(&installed, &lock).context("www/node_modules")
    })
}

/// Builds `dist/` from `www/` and `pkg/`.
pub fn build() -> Result<()> {
    run(&mut script("vite/bin/vite.js", &["build", "--logLevel", "warn"]))
}

/// Builds script, style and type of the handbook into its folder.
pub fn book(folder: &Path) -> Result<()> {
    let folder = folder.to_str().context("the path of the handbook is not Unicode")?;
    let options = ["build", "--config", "vite.book.config.ts", "--outDir", folder, "--logLevel", "warn"];
    run(&mut script("vite/bin/vite.js", &options))
}

/// Checks the types of the page's sources.
pub fn types() -> Result<()> {
    run(&mut script("typescript/bin/tsc", &["--noEmit"]))
}

/// Checks form and sense of TypeScript, CSS and JSON; `biome.jsonc` says by which rules.
pub fn lint() -> Result<()> {
    run(&mut script("@biomejs/biome/bin/biome", &["ci", "--error-on-warnings", ".."]))
}

/// A program of an npm package, run in `www/`.
fn script(path: &str, arguments: &[&str]) -> Command {
    let mut node = command("node");
    node.current_dir(root().join("www"));
    node.arg(format!("node_modules/{path}")).args(arguments);
    node
}
