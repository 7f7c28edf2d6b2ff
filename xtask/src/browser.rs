//! Chromium and its driver: found, or installed where that is possible, or named with the cure.

use crate::tools::{answer, command, find, run, step};
use crate::wasm::target;
use anyhow::{Context, Result, bail};
use std::path::{Path, PathBuf};
use std::process::Command;

const BROWSERS: [&str; 5] = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome"];
const ON_A_MAC: &str = "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome";
const PACKAGES: [&str; 2] = ["chromium", "chromium-driver"];

/// Without a GPU all of the last four are needed for WebGPU, or the canvas stays blank.
const FLAGS: [&str; 11] = [
    "--headless",
    "--no-sandbox",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--enable-unsafe-webgpu",
    "--enable-features=Vulkan",
    "--use-vulkan=swiftshader",
    "--use-angle=swiftshader",
];

/// A browser and the program that drives it.
pub struct Browser {
    /// Chromium or Chrome.
    pub chrome: PathBuf,
    /// `chromedriver` of the same version.
    pub driver: PathBuf,
}

/// The browser of this machine; on Debian as root it is installed when it is missing.
pub fn browser() -> Result<Browser> {
    if let Some(found) = installed() {
        return Ok(found);
    }
    if !(Path::new("/etc/debian_version").exists() && is_root()) {
        bail!(
            "a browser is missing: install Chromium (or Chrome) and chromedriver, \
             or set CHROME and CHROMEDRIVER to them"
        );
    }
    step("chromium", || {
        run(command("apt-get").args(["update", "-qq"]))?;
        run(command("apt-get")
            .args(["install", "-y", "-qq", "--no-install-recommends"])
            .args(PACKAGES)
            .env("DEBIAN_FRONTEND", "noninteractive"))
    })?;
    installed().context("chromium was installed and is still not found in PATH")
}

/// What the variables CHROME and CHROMEDRIVER name, else what is in PATH.
fn installed() -> Option<Browser> {
    Some(Browser {
        chrome: named("CHROME")
            .or_else(|| BROWSERS.iter().find_map(|name| find(name)))
            .or_else(|| Some(PathBuf::from(ON_A_MAC)).filter(|path| path.exists()))?,
        driver: named("CHROMEDRIVER").or_else(|| find("chromedriver"))?,
    })
}

fn named(variable: &str) -> Option<PathBuf> {
    std::env::var_os(variable).map(PathBuf::from).filter(|path| path.is_file())
}

fn is_root() -> bool {
    answer(command("id").arg("-u")).is_some_and(|id| id == "0")
}

/// Variables with which `wasm-bindgen-test` drives this browser.
pub fn surroundings(browser: &Browser) -> Result<Vec<(&'static str, PathBuf)>> {
    let file = target().join("webdriver.json");
    let wanted = serde_json::json!({
        "goog:chromeOptions": { "binary": browser.chrome, "args": FLAGS }
    });
    std::fs::write(&file, wanted.to_string()).with_context(|| file.display().to_string())?;
    Ok(vec![
        ("CHROMEDRIVER", browser.driver.clone()),
        ("WASM_BINDGEN_TEST_WEBDRIVER_JSON", file),
        ("WASM_BINDGEN_TEST_TIMEOUT", PathBuf::from("120")),
        ("WASM_BINDGEN_TEST_DRIVER_TIMEOUT", PathBuf::from("60")),
    ])
}

/// Cargo's runner for wasm test programs: this program once more, with the browser named in its surroundings.
pub fn run_wasm_tests(arguments: &[String]) -> Result<bool> {
    let mut again = Command::new(std::env::current_exe()?);
    again.arg("run-wasm-tests").args(arguments);
    if std::env::var_os("WASM_BINDGEN_TEST_WEBDRIVER_JSON").is_none() {
        again.envs(surroundings(&browser()?)?);
    }
    Ok(again.status()?.success())
}

/// Runs one wasm test program in the browser that the surroundings name.
pub fn wasm_tests(arguments: Vec<String>) -> Result<()> {
    let program = std::iter::once("wasm-bindgen-test-runner".to_owned());
    wasm_bindgen_cli::wasm_bindgen_test_runner::run_cli_with_args(program.chain(arguments))
}
