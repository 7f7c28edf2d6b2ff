//! The npm package `probewright` in `pkg/`: what the page imports, with types, for programs of others.

use crate::tools::{command, npm, root, run};
use anyhow::{Context, Result};
use std::fs;
use std::path::Path;

/// Written by hand, in `web/npm/`.
const SOURCES: [&str; 4] = ["index.ts", "package.json", "README.md", "tsconfig.json"];
/// Types of questions and answers, which the page has too.
const TYPES: &str = "wire.ts";
const LICENCES: [&str; 2] = ["LICENSE-MIT", "LICENSE-APACHE"];

/// Compiles and packs `pkg/`, which holds the modules already: `pkg/probewright-VERSION.tgz`.
pub fn pack() -> Result<()> {
    let pkg = root().join("pkg");
    let folders = [("web/npm", &SOURCES[..]), ("www/src", &[TYPES][..]), (".", &LICENCES[..])];
    for (folder, names) in folders {
        names.iter().try_for_each(|name| copy(&root().join(folder).join(name), &pkg))?;
    }
    run(command("node").arg("www/node_modules/typescript/bin/tsc").args(["-p", "pkg"]))?;
    remove(&pkg, &|name| name.ends_with(".tgz") || name == ".gitignore")?;
    let folders = fs::read_dir(&pkg)?.filter_map(|entry| Some(entry.ok()?.path()));
    for folder in folders.filter(|path| path.is_dir()) {
        remove(&folder, &|name| name == ".gitignore")?; // npm would leave out what it names
    }
    run(npm().arg("pack").args(["--silent", "--pack-destination", "."]).current_dir(&pkg))
}

fn copy(file: &Path, folder: &Path) -> Result<()> {
    let name = file.file_name().context("a file has a name")?;
    fs::copy(file, folder.join(name)).with_context(|| file.display().to_string())?;
    Ok(())
}

fn remove(folder: &Path, which: &dyn Fn(&str) -> bool) -> Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.file_name().and_then(|name| name.to_str()).is_some_and(which) {
            fs::remove_file(&path).with_context(|| path.display().to_string())?;
        }
    }
    Ok(())
}
