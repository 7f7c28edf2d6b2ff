//! `cargo xtask test`: every check and every test, counted.

use crate::counts::{Counts, check, suite};
use crate::tools::{WASM, cargo, command, component, root, run, wasm_target};
use crate::{browser, dist, page, serve};
use anyhow::{Context, Result};
use std::path::PathBuf;

/// Options of `cargo xtask test`.
#[derive(clap::Args)]
pub struct Options {
    /// Run only these parts
    #[arg(long, value_delimiter = ',')]
    only: Vec<Part>,
    /// Test what `dist/` holds, without building it
    #[arg(long)]
    no_build: bool,
}

/// The parts, in the order in which they run: what fails fast comes first.
#[derive(Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Part {
    /// Formatting
    Fmt,
    /// Clippy, native and wasm, warnings as errors
    Clippy,
    /// Rust tests on this machine
    Native,
    /// Rust tests in headless Chromium
    Wasm,
    /// The built page in headless Chromium, and the types of its sources
    Page,
}

/// Packages that run in the browser.
const IN_THE_BROWSER: [&str; 2] = ["probewright-web", "probewright-preview"];

/// Runs the parts; true when nothing failed. The last line is the sum.
pub fn test(options: &Options) -> Result<bool> {
    let wanted = |part| options.only.is_empty() || options.only.contains(&part);
    wasm_target()?;
    let runner = runner()?; // now: building the tests of this program may replace its file
    let mut counts = Counts::default();
    if wanted(Part::Fmt) {
        formatting(&mut counts)?;
    }
    if wanted(Part::Clippy) {
        clippy(&mut counts)?;
    }
    if wanted(Part::Native) {
        native(&mut counts);
    }
    if wanted(Part::Wasm) {
        wasm(&mut counts, &runner)?;
    }
    if wanted(Part::Page) {
        in_the_page(&mut counts, options.no_build)?;
    }
    println!("{} passed, {} failed", counts.passed, counts.failed);
    Ok(counts.failed == 0)
}

fn formatting(counts: &mut Counts) -> Result<()> {
    component("rustfmt", "fmt")?;
    check(counts, "formatting", || run(&mut cargo("fmt --all --check")));
    Ok(())
}

fn clippy(counts: &mut Counts) -> Result<()> {
    component("clippy", "clippy")?;
    check(counts, "clippy", || {
        let all = "clippy --locked --workspace --all-targets --all-features -- -D warnings";
        run(&mut cargo(all))
    });
    check(counts, "clippy for wasm", || {
        let mut clippy = cargo("clippy --locked --all-targets --all-features --target");
        clippy.arg(WASM).args(in_the_browser());
        run(clippy.args(["--", "-D", "warnings"]))
    });
    Ok(())
}

/// The packages that run in the browser, as arguments of cargo.
fn in_the_browser() -> impl Iterator<Item = &'static str> {
    IN_THE_BROWSER.iter().flat_map(|package| ["-p", package])
}

/// The task program itself is tested in the profile in which it was built, so that it is not built twice.
fn native(counts: &mut Counts) {
    let all = "test --locked --workspace --exclude xtask --all-features --no-fail-fast -- -q";
    suite(counts, "native tests", &mut cargo(all));
    let own = "test --locked --profile xtask -p xtask -- -q";
    suite(counts, "tests of xtask", &mut cargo(own));
}

fn wasm(counts: &mut Counts, runner: &str) -> Result<()> {
    let surroundings = browser::surroundings(&browser::browser()?)?;
    let mut tests = cargo("test --locked --all-features --no-fail-fast --target");
    tests.arg(WASM).args(in_the_browser());
    tests.envs(surroundings).env("CARGO_PROFILE_DEV_DEBUG", "0").env(runner_variable(), runner);
    suite(counts, "wasm tests in Chromium", &mut tests);
    Ok(())
}

fn runner_variable() -> String {
    format!("CARGO_TARGET_{}_RUNNER", WASM.to_uppercase().replace('-', "_"))
}

/// This program, already built.
fn runner() -> Result<String> {
    let program = std::env::current_exe()?;
    let program = program.to_str().context("the path of this program is not Unicode")?;
    Ok(format!("{program} test-runner"))
}

fn in_the_page(counts: &mut Counts, built: bool) -> Result<()> {
    let browser = browser::browser()?;
    if !built && !check(counts, "build", dist::build) {
        return Ok(());
    }
    page::packages()?;
    check(counts, "types of the page", page::types);
    let address = serve::in_background()?;
    let mut node = command("node");
    node.args(["--test", "--test-reporter=spec", "--test-concurrency=1"]).args(specs()?);
    node.env("CHROME", browser.chrome).env("PROBEWRIGHT_URL", format!("http://{address}/"));
    suite(counts, "the page in Chromium", &mut node);
    Ok(())
}

/// The browser tests, in order of their names.
fn specs() -> Result<Vec<PathBuf>> {
    let folder = root().join("tests/e2e");
    let mut found: Vec<PathBuf> = std::fs::read_dir(&folder)
        .context("tests/e2e")?
        .filter_map(|entry| Some(entry.ok()?.path()))
        .filter(|path| path.to_string_lossy().ends_with(".spec.mjs"))
        .collect();
    found.sort();
    Ok(found)
}
