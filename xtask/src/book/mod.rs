//! `cargo xtask book`: the pages of `docs/` as a handbook of HTML files, which a browser shows from a server or a disk.

mod check;
mod markdown;
mod outline;
mod page;
mod search;
mod sources;
mod words;

use crate::page as npm;
use crate::tools::{root, step};
use anyhow::{Context, Result, bail};
use serde_json::json;
use sources::{Language, Sources};
use std::collections::BTreeMap;
use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};

/// Options of `cargo xtask book`.
#[derive(clap::Args)]
pub struct Options {
    /// Folder of the handbook; what it holds is replaced
    #[arg(default_value = "dist/book")]
    folder: PathBuf,
}

/// `cargo xtask book`.
pub fn book(options: &Options) -> Result<()> {
    npm::packages()?;
    let folder = root().join(&options.folder);
    step("handbook", || build(&folder))?;
    println!("{}", folder.join("index.html").display());
    Ok(())
}

/// Every handbook has it.
const SCRIPT: &str = "book.js";

/// The files of the handbook, by their paths in its folder.
type Files = BTreeMap<String, Vec<u8>>;

/// Writes the handbook into a folder, with its script and style. Needs the npm packages.
pub fn build(folder: &Path) -> Result<()> {
    clear(folder)?;
    npm::book(folder)?;
    let sources = Sources::read(&root())?;
    let mut shared = read(folder)?;
    shared.insert("icon.svg".to_owned(), fs::read(root().join("www/public/icon.svg"))?);
    let files = files(&sources, &shared)?;
    for (name, bytes) in &files {
        let path = folder.join(name);
        fs::create_dir_all(path.parent().context("a folder")?)?;
        fs::write(&path, bytes).with_context(|| path.display().to_string())?;
    }
    Ok(())
}

/// Removes a handbook that was made before; a folder with anything else is left as it is.
fn clear(folder: &Path) -> Result<()> {
    if !folder.exists() {
        return Ok(());
    }
    let empty = fs::read_dir(folder).with_context(|| folder.display().to_string())?.next().is_none();
    if !empty && !folder.join(SCRIPT).is_file() {
        bail!("{} holds something else than a handbook", folder.display());
    }
    fs::remove_dir_all(folder).with_context(|| folder.display().to_string())
}

/// What the build of the page left in the folder: script, style and type.
fn read(folder: &Path) -> Result<Files> {
    let entries = fs::read_dir(folder).with_context(|| folder.display().to_string())?;
    entries
        .map(|entry| {
            let path = entry?.path();
            let name = path.file_name().context("a name")?.to_string_lossy().into_owned();
            Ok((name, fs::read(&path)?))
        })
        .collect()
}

/// All files of the handbook; `shared`: those that each page uses.
fn files(sources: &Sources, shared: &Files) -> Result<Files> {
    let mut files = shared.clone();
    for language in &sources.languages {
        let own = of_language(sources, language)?;
        let name = format!("{}.json", language.code);
        let drawn = sources.beside.iter().filter(|(name, _)| sources::is_drawn(name));
        let list = list(own.iter().chain(shared).chain(drawn));
        files.extend(own);
        files.insert(name, list.into_bytes());
    }
    files.insert("index.html".to_owned(), page::languages(sources)?.into_bytes());
    files.extend(sources.beside.clone());
    let linked = check::links(&files)?;
    files.retain(|name, _| !sources.beside.contains_key(name) || linked.contains(name));
    Ok(files)
}

/// Pages and search index of a language.
fn of_language(sources: &Sources, language: &Language) -> Result<Files> {
    let made = language.pages().map(|source| {
        let made = markdown::html(sources, language, source).with_context(|| format!("docs: {}", source.title))?;
        Ok((source, made))
    });
    let made = made.collect::<Result<Vec<_>>>()?;
    let mut files = Files::new();
    for (source, made) in &made {
        files.insert(source.file(language), page::page(sources, language, source, made)?.into_bytes());
    }
    files.insert(format!("{}/index.html", language.code), page::start(sources, language, &made)?.into_bytes());
    files.insert(format!("search-{}.js", language.code), search::index(&made).into_bytes());
    Ok(files)
}

/// What the page keeps for use without a network: names, and a number that changes with what they hold.
fn list<'a>(files: impl Iterator<Item = (&'a String, &'a Vec<u8>)>) -> String {
    let mut hasher = DefaultHasher::new();
    let names: Vec<&String> = files
        .map(|(name, bytes)| {
            (name, bytes).hash(&mut hasher);
            name
        })
        .collect();
    json!({ "revision": format!("{:016x}", hasher.finish()), "files": names }).to_string()
}

/// Text in HTML, in quotation marks too.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// The way from one file to another, both named from the same folder.
fn relative(from: &str, to: &str) -> String {
    let folder: Vec<&str> = from.split('/').collect();
    let target: Vec<&str> = to.split('/').collect();
    let folder = &folder[..folder.len() - 1];
    let common = folder.iter().zip(&target[..target.len() - 1]).take_while(|(one, other)| one == other).count();
    let up = folder[common..].iter().map(|_| "..");
    up.chain(target[common..].iter().copied()).collect::<Vec<_>>().join("/")
}

#[cfg(test)]
mod tests;
