//! The versions that must agree do agree.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use probewright_tests::root;

fn version_of(manifest: &str, dependency: &str) -> String {
    let text = std::fs::read_to_string(root().join(manifest)).unwrap();
    let line = text
        .lines()
        .find(|line| line.starts_with(dependency) && line[dependency.len()..].starts_with(" ="))
        .unwrap_or_else(|| panic!("{manifest} has no {dependency}"));
    line.split('"').find(|part| part.starts_with('=')).unwrap().to_owned()
}

// oracle: hand (wasm-bindgen refuses a module made by another version of its macro)
#[test]
fn wasm_bindgen_and_its_generator_have_one_version() {
    assert_eq!(version_of("Cargo.toml", "wasm-bindgen"), version_of("xtask/Cargo.toml", "wasm-bindgen-cli"));
}

// oracle: hand (who installs a package by its version gets the module of that version)
#[test]
fn the_packages_have_the_version_of_the_workspace() {
    let version = format!("\"version\": \"{}\"", env!("CARGO_PKG_VERSION"));
    for file in ["web/npm/package.json", "editors/vscode/package.json"] {
        let package = std::fs::read_to_string(root().join(file)).unwrap();
        assert!(package.contains(&version), "{file}: {version}");
    }
}
