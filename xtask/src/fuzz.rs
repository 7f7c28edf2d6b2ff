//! `cargo xtask fuzz`: libFuzzer on the reader or the interpreter, with the stable compiler and nothing installed.

use crate::tools::{answer, cargo, command, find, root, run};
use anyhow::{Context, Result, bail};
use std::fs;
use std::path::PathBuf;
use std::process::Command;

/// Options of `cargo xtask fuzz`.
#[derive(clap::Args)]
pub struct Options {
    /// What to feed with random programs
    target: Target,
    /// How long, in seconds
    #[arg(long, default_value_t = 600)]
    seconds: u32,
}

#[derive(Clone, Copy, clap::ValueEnum)]
enum Target {
    /// Reading, finding calls, changing values
    Read,
    /// Running
    Run,
}

/// What makes the compiled program tell libFuzzer where it has been: the passes that cargo-fuzz asks for,
/// without a sanitizer, which only a nightly compiler has and code without `unsafe` does not need.
const COVERAGE: [&str; 7] = [
    "-Cpasses=sancov-module",
    "-Cllvm-args=-sanitizer-coverage-level=4",
    "-Cllvm-args=-sanitizer-coverage-inline-8bit-counters",
    "-Cllvm-args=-sanitizer-coverage-pc-table",
    "-Cllvm-args=-sanitizer-coverage-trace-compares",
    "-Cdebug-assertions",
    "-Ccodegen-units=1",
];

/// An input that runs longer (seconds) or takes more memory (MB) is a defect.
const LONGEST: u32 = 5;
const LARGEST: u32 = 512;

/// Bytes of an input at most: what lines do together shows in a few of them.
const LONGEST_INPUT: u32 = 512;
/// Pieces of programs to start from, in one file, and the line between them (`fuzz/src/seeds.rs`).
const SEEDS: &str = "fuzz/seeds";
const BETWEEN: &str = "\n-- seed --\n";

/// Looks for a program that breaks the target; fails when it finds one and keeps it in `fuzz/artifacts/`.
pub fn fuzz(options: &Options) -> Result<()> {
    let name = match options.target {
        Target::Read => "read",
        Target::Run => "run",
    };
    let corpus = folder(&format!("fuzz/corpus/{name}"))?;
    let artifacts = folder(&format!("fuzz/artifacts/{name}"))?;
    run(&mut build(name)?)?;
    let mut engine = command(&format!("fuzz/target/{}/release/{name}", host()?));
    engine.arg(corpus).arg(seeds()?);
    engine.args([
        format!("-artifact_prefix={}/", artifacts.display()),
        format!("-max_total_time={}", options.seconds),
        format!("-max_len={LONGEST_INPUT}"),
        format!("-timeout={LONGEST}"),
        format!("-rss_limit_mb={LARGEST}"),
        "-dict=fuzz/words.dict".to_owned(),
        // which input is changed next: weighing the rarest of 40,000 features takes twice the time of the inputs
        "-entropic=0".to_owned(),
        "-print_final_stats=1".to_owned(),
    ]);
    run(&mut engine)
}

/// A folder with the pieces to start from, a file each.
fn seeds() -> Result<PathBuf> {
    let folder = folder("fuzz/target/seeds")?;
    let all = fs::read(root().join(SEEDS)).context(SEEDS)?;
    let mut rest = &all[..];
    for number in 0.. {
        let end = rest.windows(BETWEEN.len()).position(|place| place == BETWEEN.as_bytes());
        fs::write(folder.join(number.to_string()), &rest[..end.unwrap_or(rest.len())])?;
        let Some(end) = end else { break };
        rest = &rest[end + BETWEEN.len()..];
    }
    Ok(folder)
}

/// `--target` keeps the flags away from build scripts.
fn build(name: &str) -> Result<Command> {
    if ["c++", "g++", "clang++", "cl"].iter().all(|program| find(program).is_none()) {
        bail!("a C++ compiler is missing: install one (Debian: apt-get install g++), libFuzzer is built with it");
    }
    let mut cargo = cargo("build --release --manifest-path fuzz/Cargo.toml --features engine");
    cargo.args(["--bin", name, "--target", &host()?]);
    cargo.env("CARGO_ENCODED_RUSTFLAGS", COVERAGE.join("\u{1f}"));
    cargo.env("CARGO_TARGET_DIR", root().join("fuzz/target"));
    Ok(cargo)
}

fn folder(path: &str) -> Result<PathBuf> {
    let path = root().join(path);
    fs::create_dir_all(&path).with_context(|| path.display().to_string())?;
    Ok(path)
}

/// The machine's own target.
fn host() -> Result<String> {
    answer(command("rustc").args(["--print", "host-tuple"])).context("rustc does not name its host")
}
