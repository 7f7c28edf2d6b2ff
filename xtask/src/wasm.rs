//! Rust → wasm → modules in `pkg/` that the page imports.

use crate::steps::Steps;
use crate::tools::{WASM, cargo, command, root, run, step};
use anyhow::{Result, anyhow};
use std::path::{Path, PathBuf};
use std::thread::JoinHandle;

/// How the modules are made.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Make {
    /// In a few minutes, to look at the page while one works on it.
    Quick,
    /// As small and fast as they get: what is handed out.
    Small,
}

/// One wasm module of the page.
struct Module {
    /// Folder below `pkg/`.
    folder: &'static str,
    /// Base name of its files.
    name: &'static str,
    package: &'static str,
    /// Cargo profile it is handed out in.
    profile: &'static str,
    features: &'static str,
    /// Level of `wasm-opt` where it is worth its time: it barely helps the large WebGL module.
    optimise: Option<&'static str>,
}

const MODULES: [Module; 3] = [
    Module {
        folder: "core",
        name: "core",
        package: "probewright-web",
        profile: "release",
        features: "",
        optimise: Some("-O3"),
    },
    Module {
        folder: "preview-webgpu",
        name: "preview",
        package: "probewright-preview",
        profile: "preview",
        features: "webgpu",
        optimise: Some("-Oz"),
    },
    Module {
        folder: "preview-webgl",
        name: "preview",
        package: "probewright-preview",
        profile: "preview",
        features: "webgl",
        optimise: None,
    },
];

/// The cargo profile of modules that are made quickly.
const QUICK: &str = "quick";

/// What Rust's compiler emits for the target by default; nothing newer may be introduced.
const WASM_FEATURES: [&str; 6] = [
    "--enable-bulk-memory",
    "--enable-multivalue",
    "--enable-mutable-globals",
    "--enable-nontrapping-float-to-int",
    "--enable-reference-types",
    "--enable-sign-ext",
];

/// Of how many steps [`build`] is.
pub const STEPS: usize = MODULES.len();

/// Builds all modules. Needs the wasm target and the npm packages.
pub fn build(steps: &mut Steps, make: Make) -> Result<()> {
    MODULES.iter().try_for_each(|module| steps.run(&format!("wasm {}", module.folder), || build_module(module, make)))
}

/// Builds all modules, small, beside what else is done: optimising the core takes one processor ten minutes. Needs what
/// [`build`] does.
pub fn build_beside() -> JoinHandle<Result<()>> {
    let one = |module: &Module| step(&format!("wasm {}, beside", module.folder), || build_module(module, Make::Small));
    std::thread::spawn(move || MODULES.iter().try_for_each(one))
}

fn build_module(module: &Module, make: Make) -> Result<()> {
    let profile = if make == Make::Quick { QUICK } else { module.profile };
    compile(module, profile)?;
    let out = root().join("pkg").join(module.folder);
    bind(&compiled(module, profile), &out, module.name)?;
    match module.optimise {
        Some(level) if make == Make::Small => optimise(&out.join(format!("{}_bg.wasm", module.name)), level),
        _ => Ok(()),
    }
}

/// As `cdylib` only: with an `rlib` beside it, link-time optimisation is silently off.
fn compile(module: &Module, profile: &str) -> Result<()> {
    let mut cargo = cargo("rustc --locked --lib --crate-type cdylib --no-default-features");
    cargo.args(["--target", WASM]);
    cargo.args(["-p", module.package, "--profile", profile]);
    cargo.args(["--features", module.features]);
    run(&mut cargo)
}

/// Where cargo puts the compiled module.
fn compiled(module: &Module, profile: &str) -> PathBuf {
    target().join(WASM).join(profile).join(format!("{}.wasm", module.package.replace('-', "_")))
}

/// Cargo's folder for what it builds.
pub fn target() -> PathBuf {
    std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), PathBuf::from)
}

/// Makes the JavaScript module and its types.
fn bind(wasm: &Path, out: &Path, name: &str) -> Result<()> {
    let text = |path: &Path| -> Result<String> {
        path.to_str().map(str::to_owned).ok_or_else(|| anyhow!("{} is not Unicode", path.display()))
    };
    wasm_bindgen_cli::wasm_bindgen::run_cli_with_args([
        "wasm-bindgen".to_owned(),
        "--target=web".to_owned(),
        "--remove-name-section".to_owned(),
        "--remove-producers-section".to_owned(),
        format!("--out-name={name}"),
        format!("--out-dir={}", text(out)?),
        text(wasm)?,
    ])
}

/// Rewrites a module smaller or faster, with npm's `binaryen`.
fn optimise(wasm: &Path, level: &str) -> Result<()> {
    let mut node = command("node");
    node.arg("www/node_modules/binaryen/bin/wasm-opt");
    node.arg(level).args(WASM_FEATURES);
    run(node.arg(wasm).arg("-o").arg(wasm))
}
