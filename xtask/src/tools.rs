//! Programs that the tasks call: where they are, how they are run, what to do when one is missing.

use anyhow::{Context, Result, bail};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Instant;

/// The wasm target of the page.
pub const WASM: &str = "wasm32-unknown-unknown";
/// Vite needs at least this version of Node.
const NODE: (u32, u32) = (20, 19);

/// The root of the repository.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().map_or_else(|| PathBuf::from("."), Path::to_path_buf)
}

/// Does one named piece of work and tells how long it took.
pub fn step<T>(name: &str, work: impl FnOnce() -> Result<T>) -> Result<T> {
    eprintln!("▸ {name}");
    let start = Instant::now();
    let outcome = work().with_context(|| name.to_owned());
    let mark = if outcome.is_ok() { "✓" } else { "✗" };
    eprintln!("{mark} {name}  {:.1} s", start.elapsed().as_secs_f64());
    outcome
}

/// A command in the root of the repository.
pub fn command(program: &str) -> Command {
    let mut command = Command::new(program);
    command.current_dir(root()).stdin(Stdio::null());
    command
}

/// The cargo that started this task, with arguments written as one would type them.
pub fn cargo(arguments: &str) -> Command {
    let mut cargo = command(&std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned()));
    cargo.args(arguments.split_whitespace());
    cargo
}

/// npm, which is a script with another name on Windows.
pub fn npm() -> Command {
    command(if cfg!(windows) { "npm.cmd" } else { "npm" })
}

/// Runs a command to its end; a failure names the command.
pub fn run(command: &mut Command) -> Result<()> {
    let status = command.status().with_context(|| shown(command))?;
    if !status.success() {
        bail!("{} failed ({status})", shown(command));
    }
    Ok(())
}

/// First line that a command prints; `None` when there is no such program or it fails.
pub fn answer(command: &mut Command) -> Option<String> {
    let output = command.stderr(Stdio::null()).output().ok()?;
    let text = String::from_utf8(output.stdout).ok()?;
    output.status.success().then(|| text.lines().next().unwrap_or("").trim().to_owned())
}

/// The command as one would type it.
pub fn shown(command: &Command) -> String {
    std::iter::once(command.get_program())
        .chain(command.get_args())
        .map(|part| part.to_string_lossy())
        .collect::<Vec<_>>()
        .join(" ")
}

/// Looks a program up in PATH.
pub fn find(program: &str) -> Option<PathBuf> {
    let path = std::env::var_os("PATH")?;
    std::env::split_paths(&path)
        .map(|folder| folder.join(format!("{program}{}", std::env::consts::EXE_SUFFIX)))
        .find(|candidate| candidate.is_file())
}

/// Gets the standard library of the wasm target, unless the compiler has it already.
pub fn wasm_target() -> Result<()> {
    let libraries = answer(command("rustc").args(["--print", "target-libdir", "--target", WASM]));
    if libraries.is_some_and(|folder| Path::new(&folder).is_dir()) {
        return Ok(());
    }
    if find("rustup").is_none() {
        bail!("the Rust target {WASM} is missing: install Rust with rustup (https://rustup.rs)");
    }
    step("wasm target", || run(command("rustup").args(["target", "add", WASM])))
}

/// Gets a component of the toolchain (`rustfmt`, `clippy`), unless it is there.
pub fn component(name: &str, subcommand: &str) -> Result<()> {
    if answer(cargo(subcommand).arg("--version")).is_some() {
        return Ok(());
    }
    if find("rustup").is_none() {
        bail!("{name} is missing: install Rust with rustup (https://rustup.rs)");
    }
    step(name, || run(command("rustup").args(["component", "add", name])))
}

/// Says in one line what to do when Node or npm is missing or too old.
pub fn node() -> Result<()> {
    let Some(version) = answer(command("node").arg("--version")) else {
        bail!("Node.js is missing: install Node 20 (https://nodejs.org)");
    };
    if version_of(&version).is_none_or(|found| found < NODE) {
        bail!("Node.js {version} is too old: install Node 20.19 or newer (https://nodejs.org)");
    }
    if answer(npm().arg("--version")).is_none() {
        bail!("npm is missing: it comes with Node.js (https://nodejs.org)");
    }
    Ok(())
}

/// Major and minor number of `v20.19.1`.
fn version_of(text: &str) -> Option<(u32, u32)> {
    let mut numbers = text.trim_start_matches('v').split('.');
    Some((numbers.next()?.parse().ok()?, numbers.next()?.parse().ok()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    // oracle: hand
    #[test]
    fn versions_of_node_are_compared_as_numbers() {
        assert_eq!(version_of("v20.19.5"), Some((20, 19)));
        assert!(version_of("v9.11.2") < Some(NODE));
        assert!(version_of("v22.1.0") > Some(NODE));
        assert_eq!(version_of("none"), None);
    }
}
