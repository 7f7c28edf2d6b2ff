//! `cargo xtask bench --peers`: the same programs in Probewright and in its peers. They are fetched from npm and PyPI
//! into `target/peers`, by version, and are no part of the product.

use crate::steps::Steps;
use crate::tools::{answer, cargo, command, find, npm, run};
use crate::wasm::{self, Make, target};
use crate::{browser, page, tools};
use anyhow::{Context, Result, bail};
use std::fs;
use std::path::{Path, PathBuf};

/// Draws a path; it brings the version of three.js that it was made for.
const PREVIEW: &str = "gcode-preview@2.18.0";
/// Runs programs of SINUMERIK.
const RUN: &str = "nc-gcode-interpreter==0.1.9";

/// Prints both figures and their ratio; nothing fails when a peer is faster.
pub fn bench() -> Result<()> {
    let browser = browser::browser()?;
    let folder = target().join("peers");
    tools::wasm_target()?;
    page::packages()?;
    let mut steps = Steps::of(wasm::STEPS + 4);
    wasm::build(&mut steps, Make::Small)?;
    steps.run("terminal program", || {
        run(&mut cargo("build --locked --release -p probewright-core --features cli --bin probewright"))
    })?;
    steps.run(PREVIEW, || preview(&folder.join("preview")))?;
    steps.run(RUN, || interpreter(&folder.join("run")))?;
    let program = target().join("release").join(format!("probewright{}", std::env::consts::EXE_SUFFIX));
    steps.run("beside each other", || {
        run(command("node")
            .arg("tests/e2e/peers.mjs")
            .env("CHROME", &browser.chrome)
            .env("PROBEWRIGHT_PROGRAM", &program)
            .env("PEER_PREVIEW", folder.join("preview/node_modules"))
            .env("PEER_PYTHON", own_python(&folder.join("run"))))
    })
}

/// Fetches the one that draws, unless it is there.
fn preview(folder: &Path) -> Result<()> {
    if is_there(folder, PREVIEW) {
        return Ok(());
    }
    fs::create_dir_all(folder).with_context(|| folder.display().to_string())?;
    run(npm().args(["install", "--no-audit", "--no-fund", "--no-save", "--prefix"]).arg(folder).arg(PREVIEW))?;
    mark(folder, PREVIEW)
}

/// Fetches the one that runs into an environment of its own, unless it is there.
fn interpreter(folder: &Path) -> Result<()> {
    if is_there(folder, RUN) {
        return Ok(());
    }
    let Some(python) = python() else { bail!("Python is missing: install Python 3 (https://www.python.org)") };
    run(command(&python).args(["-m", "venv"]).arg(folder))?;
    run(command(&own_python(folder).to_string_lossy()).args(["-m", "pip", "install", "--quiet", RUN]))?;
    mark(folder, RUN)
}

/// That of an environment.
fn own_python(folder: &Path) -> PathBuf {
    folder.join(if cfg!(windows) { "Scripts/python.exe" } else { "bin/python" })
}

fn python() -> Option<String> {
    ["python3", "python"]
        .into_iter()
        .find(|name| find(name).is_some() && answer(command(name).arg("--version")).is_some())
        .map(str::to_owned)
}

/// Whether just this version was installed there to its end.
fn is_there(folder: &Path, what: &str) -> bool {
    fs::read_to_string(installed(folder)).is_ok_and(|known| known == what)
}

fn mark(folder: &Path, what: &str) -> Result<()> {
    fs::write(installed(folder), what).with_context(|| folder.display().to_string())
}

fn installed(folder: &Path) -> PathBuf {
    folder.join(".installed")
}
