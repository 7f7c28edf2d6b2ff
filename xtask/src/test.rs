//! `cargo xtask test`: every check and every test, counted.

use crate::counts::{AGAIN, Tally};
use crate::tools::{WASM, cargo, command, component, root, run, wasm_target};
use crate::wasm::{Make, build_beside, target};
use crate::{browser, dist, editor, page, serve};
use anyhow::{Context, Result, bail};
use std::path::PathBuf;
use std::process::Command;
use std::thread::JoinHandle;

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
    /// Biome over TypeScript, CSS and JSON, warnings as errors
    Biome,
    /// Clippy, native and wasm, warnings as errors
    Clippy,
    /// `cargo doc`, warnings as errors
    Doc,
    /// Rust tests on this machine
    Native,
    /// Rust tests in headless Chromium
    Wasm,
    /// The built page in headless Chromium, and the types of its sources
    Page,
}

/// Packages that run in the browser.
const IN_THE_BROWSER: [&str; 3] = ["probewright-web", "probewright-preview", "probewright-seam"];

impl Part {
    /// All of them.
    const ALL: [Part; 7] = [Part::Fmt, Part::Biome, Part::Clippy, Part::Doc, Part::Native, Part::Wasm, Part::Page];

    /// Of how many steps it is.
    fn steps(self, built: bool) -> usize {
        match self {
            Part::Fmt | Part::Biome | Part::Doc | Part::Wasm => 1,
            Part::Clippy => 3,
            Part::Native => 2,
            Part::Page => 3 + if built { 0 } else { 1 + dist::AROUND },
        }
    }
}

/// Runs the parts; true when nothing failed. At the end stands how long each step took; the last line is the sum.
pub fn test(options: &Options) -> Result<bool> {
    let wanted = Part::ALL.into_iter().filter(|part| options.only.is_empty() || options.only.contains(part));
    let wanted: Vec<Part> = wanted.collect();
    wasm_target()?;
    let runner = runner()?; // now: building the tests of this program may replace its file
    let mut tally = Tally::of(wanted.iter().map(|part| part.steps(options.no_build)).sum());
    let mut modules = match wanted.contains(&Part::Page) && !options.no_build {
        true => Some(modules_beside()?),
        false => None,
    };
    for part in wanted {
        match part {
            Part::Fmt => formatting(&mut tally)?,
            Part::Biome => biome(&mut tally),
            Part::Clippy => clippy(&mut tally)?,
            Part::Doc => documentation(&mut tally),
            Part::Native => native(&mut tally),
            Part::Wasm => wasm(&mut tally, &runner)?,
            Part::Page => in_the_page(&mut tally, modules.take())?,
        }
    }
    println!("{}", tally.steps.times());
    println!("{}", tally.counts.line());
    Ok(tally.counts.failed == 0)
}

fn formatting(tally: &mut Tally) -> Result<()> {
    component("rustfmt", "fmt")?;
    tally.check("formatting", || run(&mut cargo("fmt --all --check")));
    Ok(())
}

fn biome(tally: &mut Tally) {
    tally.check("biome", || {
        page::packages()?;
        page::lint()
    });
}

/// The task program is looked at in the profile in which it was built, and apart: with its dependencies beside them the
/// other packages would be built with other features than for their tests, and so twice.
fn clippy(tally: &mut Tally) -> Result<()> {
    component("clippy", "clippy")?;
    let strict = |mut clippy: Command| run(clippy.args(["--", "-D", "warnings"]));
    let all = "clippy --locked --workspace --exclude xtask --exclude probewright-seam --all-targets --all-features";
    tally.check("clippy", || strict(cargo(all)));
    tally.check("clippy of xtask", || strict(cargo("clippy --locked --profile xtask -p xtask --all-targets")));
    tally.check("clippy for wasm", || {
        let mut clippy = cargo("clippy --locked --all-targets --all-features --target");
        clippy.arg(WASM).args(in_the_browser());
        strict(clippy)
    });
    Ok(())
}

/// The documentation of the core, as a stranger reads it.
fn documentation(tally: &mut Tally) {
    tally.check("documentation", || {
        let mut doc = cargo("doc --locked --no-deps -p probewright-core --lib --all-features");
        run(doc.env("RUSTDOCFLAGS", "-D warnings"))
    });
}

/// The packages that run in the browser, as arguments of cargo.
fn in_the_browser() -> impl Iterator<Item = &'static str> {
    IN_THE_BROWSER.iter().flat_map(|package| ["-p", package])
}

/// The task program itself is tested in the profile in which it was built, so that it is not built twice.
fn native(tally: &mut Tally) {
    let all =
        "test --locked --workspace --exclude xtask --exclude probewright-seam --all-features --no-fail-fast -- -q";
    tally.suite("native tests", &mut cargo(all));
    let own = "test --locked --profile xtask -p xtask -- -q";
    tally.suite("tests of xtask", &mut cargo(own));
}

/// Of the bindings: the preview has no tests here, and building its graphics library for none takes minutes.
fn wasm(tally: &mut Tally, runner: &str) -> Result<()> {
    let surroundings = browser::surroundings(&browser::browser()?)?;
    let mut tests = cargo("test --locked --no-fail-fast -p probewright-seam --target");
    tests.arg(WASM);
    tests
        .envs(surroundings)
        .env("CARGO_PROFILE_DEV_DEBUG", "0")
        .env("CARGO_PROFILE_DEV_OPT_LEVEL", "1")
        .env(runner_variable(), runner);
    tally.suite("wasm tests in Chromium", &mut tests);
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

/// The modules of the page, while the parts before it run.
fn modules_beside() -> Result<JoinHandle<Result<()>>> {
    dist::prepare()?;
    Ok(build_beside())
}

/// `modules`: under way for a page that is not built yet.
fn in_the_page(tally: &mut Tally, modules: Option<JoinHandle<Result<()>>>) -> Result<()> {
    let browser = browser::browser()?;
    if let Some(modules) = modules {
        let rest = || modules.join().unwrap_or_else(|_| bail!("the modules were not built"));
        let made = tally.steps.run("wasm modules, the rest", rest);
        let outcome = made.and_then(|()| dist::build_around(&mut tally.steps, Make::Small));
        if !tally.one(outcome) {
            return Ok(());
        }
    }
    page::packages()?;
    tally.check("types of the page", page::types);
    tally.check("language server", || {
        editor::packages()?;
        run(&mut cargo("build --locked --profile test -p probewright-core --all-features --bin probewright"))
    });
    let address = serve::in_background()?;
    tally.files("the page in Chromium", &specs()?, |files| {
        let mut node = command("node");
        node.args(["--test", "--test-reporter=spec"]).arg(format!("--test-concurrency={}", at_once(files.len())));
        node.args(files).env("CHROME", &browser.chrome).env("PROBEWRIGHT_URL", format!("http://{address}/"));
        node.env("PROBEWRIGHT_SERVER", target().join("debug/probewright"));
        node
    });
    Ok(())
}

/// How many browsers run beside each other: a page takes a bit more than one core while it starts, then less. With more
/// of them than two the software that draws for them makes all of them wait. A few files run one after another: they
/// run once more, to see whether they fail with nothing beside them.
fn at_once(files: usize) -> usize {
    let most = if files > AGAIN { 2 } else { 1 };
    std::thread::available_parallelism().map_or(1, |cores| cores.get().clamp(1, most))
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
