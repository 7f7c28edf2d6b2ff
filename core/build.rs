//! Writes down what stands in folders, so that nobody has to: the languages with their message files, and the cycles.

use std::error::Error;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::{env, fs};

type Outcome<T> = Result<T, Box<dyn Error>>;

fn main() -> Outcome<()> {
    let root = PathBuf::from(env::var("CARGO_MANIFEST_DIR")?);
    let out = PathBuf::from(env::var("OUT_DIR")?);
    fs::write(out.join("languages.rs"), languages(&root.join("messages"))?)?;
    fs::write(out.join("cycles.rs"), cycles(&root.join("src/catalogue"))?)?;
    Ok(())
}

/// A `&[Language]`: each folder of messages with the name and text of each of its files, in order.
fn languages(folder: &Path) -> Outcome<String> {
    let mut text = String::from("&[");
    for language in names(folder)?.iter().filter(|name| !name.contains('.')) {
        let folder = folder.join(language);
        write!(text, "Language {{ code: {language:?}, files: &[")?;
        for name in names(&folder)?.iter().filter(|name| name.ends_with(".ftl")) {
            write!(text, "({name:?}, include_str!({:?})),", folder.join(name))?;
        }
        text.push_str("] },");
    }
    Ok(text + "]")
}

/// A `&[&Cycle]`: the entry of each module of the catalogue that holds one, `CYCLE977` of `cycle977`, in the order in
/// which `mod.rs` names them.
fn cycles(folder: &Path) -> Outcome<String> {
    watch(folder);
    let source = fs::read_to_string(folder.join("mod.rs"))?;
    let mut text = String::from("&[");
    for module in source.lines().filter_map(|line| line.strip_prefix("pub mod ")?.strip_suffix(';')) {
        let entry = module.to_uppercase();
        let files = [folder.join(module).join("mod.rs"), folder.join(module).with_extension("rs")];
        let code: String = files.iter().filter_map(|file| fs::read_to_string(file).ok()).collect();
        if code.contains(&format!("pub static {entry}: Cycle")) {
            write!(text, "&{module}::{entry},")?;
        }
    }
    Ok(text + "]")
}

/// What a folder holds, in order of the names.
fn names(folder: &Path) -> Outcome<Vec<String>> {
    watch(folder);
    let entries = fs::read_dir(folder)?.map(|entry| Ok(entry?.file_name().to_string_lossy().into_owned()));
    let mut names = entries.collect::<Outcome<Vec<String>>>()?;
    names.sort();
    Ok(names)
}

/// The script runs again when something in the folder changed.
fn watch(folder: &Path) {
    println!("cargo::rerun-if-changed={}", folder.display());
}
