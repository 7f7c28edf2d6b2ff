//! Each datum of the machine's form is read by something, or the form says that nothing reads it.
#![allow(clippy::unwrap_used)]

use probewright_core::control::delivery;
use probewright_core::dialect::Dialect;
use probewright_core::form::machine::groups;
use std::collections::HashSet;
use std::path::{Path, PathBuf};

/// Code that names data without reading them for the simulation: their tables, the check of a machine, what writes its
/// definition files and the programs that test a probe, what tells how a call differs from JOG, and tests.
const OTHER: [&str; 9] = [
    "control/gud", "machine_data/table.rs", "control/needs.rs", "control/idle.rs", "control/versions.rs",
    "app/definitions.rs", "app/machine_check", "app/repeat.rs", "jog/counterpart/data.rs",
];

fn entry_name(path: &Path) -> String {
    path.file_name().unwrap().to_string_lossy().into_owned()
}

fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let whole = path.to_string_lossy().replace('\\', "/");
        let name = entry_name(&path);
        match path.is_dir() {
            _ if OTHER.iter().any(|one| whole.ends_with(one)) || name.contains("test") || name == "bin" => {}
            true => sources(&path, found),
            false => found.push(path),
        }
    }
}

/// The code that may read a datum: without tests and comments.
fn code() -> String {
    let mut files = Vec::new();
    sources(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), &mut files);
    let mut code = String::new();
    for file in files {
        let text = std::fs::read_to_string(file).unwrap();
        let text = text.split("\n#[cfg(test)]\nmod tests {").next().unwrap();
        let lines =
            text.lines().map(|line| line.split("// ").next().unwrap()).filter(|line| !line.trim().starts_with("//"));
        lines.for_each(|line| code.push_str(&format!("{line}\n")));
    }
    code
}

/// Code without the settings of the entries, which name what a form shows and read nothing.
fn without_settings(code: &str) -> String {
    let mut parts = code.split("settings: &[");
    let first = parts.next().unwrap().to_owned();
    parts.fold(first, |code, part| code + part.split_once("],").unwrap().1)
}

/// What stands in quotation marks; of a name with an index that is put together (`_WP[{i},0]`) the array.
fn quoted(code: &str) -> HashSet<&str> {
    code.split('"').flat_map(|text| [Some(text), text.split_once("[{").map(|(stem, _)| stem)]).flatten().collect()
}

/// Whether code names a datum: itself, or its array.
fn named(quoted: &HashSet<&str>, name: &str) -> bool {
    quoted.contains(name) || name.split_once('[').is_some_and(|(stem, _)| quoted.contains(stem))
}

// oracle: self (the list of what has no effect against the code)
#[test]
fn no_datum_is_without_effect_in_silence() {
    let code = without_settings(&code());
    let quoted = quoted(&code);
    let control = delivery(Dialect::Sinumerik);
    let settings = groups(&control).into_iter().flat_map(|group| group.settings);
    let (mut silent, mut read) = (Vec::new(), Vec::new());
    for setting in settings {
        match (named(&quoted, &setting.name), setting.idle) {
            (false, false) => silent.push(setting.name),
            (true, true) => read.push(setting.name),
            _ => {}
        }
    }
    assert!(silent.is_empty(), "nothing reads these, and the form does not say so: {silent:?}");
    assert!(read.is_empty(), "something reads these, and the form says that nothing does: {read:?}");
}
