//! `cargo xtask bench`: speed native and in Chromium, and sizes over the wire; with `--peers` beside other programs.

use crate::steps::Steps;
use crate::tools::{cargo, command, root, run};
use crate::wasm::Make;
use crate::{browser, dist, peers, serve};
use anyhow::{Context, Result};
use flate2::Compression;
use flate2::write::GzEncoder;
use std::collections::BTreeMap;
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};

/// Options of `cargo xtask bench`.
#[derive(clap::Args)]
pub struct Options {
    /// Beside other programs that draw and run part programs, which are fetched into target/
    #[arg(long)]
    peers: bool,
}

/// Measures; nothing fails when a goal is missed, the table says so.
pub fn bench(options: &Options) -> Result<()> {
    if options.peers {
        return peers::bench();
    }
    let mut steps = Steps::of(dist::STEPS + 2);
    dist::build(&mut steps, Make::Small)?;
    let browser = browser::browser()?;
    steps.run("native", || run(&mut cargo("bench --locked -p probewright-core --all-features --benches")))?;
    let address = serve::in_background()?;
    steps.run("in Chromium", || {
        run(command("node")
            .arg("tests/e2e/bench.mjs")
            .env("CHROME", &browser.chrome)
            .env("PROBEWRIGHT_URL", format!("http://{address}/")))
    })?;
    sizes(&root().join("dist"))
}

/// Prints every file of a folder with its size as it is and gzipped; of the handbook the sum of each of its folders.
fn sizes(folder: &Path) -> Result<()> {
    let mut files = Vec::new();
    collect(folder, &mut files)?;
    let mut sizes: BTreeMap<&Path, (usize, usize)> = BTreeMap::new();
    for path in &files {
        let bytes = fs::read(path)?;
        let name = path.strip_prefix(folder).unwrap_or(path);
        let of_book = name.starts_with("book") && name.components().count() > 2;
        let line = if of_book { name.ancestors().nth(name.components().count() - 2).unwrap_or(name) } else { name };
        let (plain, packed) = sizes.entry(line).or_default();
        *plain += bytes.len();
        *packed += gzipped(&bytes)?;
    }
    println!("{:>12} {:>12}  file", "bytes", "gzipped");
    for (name, (plain, packed)) in sizes {
        println!("{plain:>12} {packed:>12}  {}", name.display());
    }
    Ok(())
}

fn collect(folder: &Path, files: &mut Vec<PathBuf>) -> Result<()> {
    for entry in fs::read_dir(folder).with_context(|| folder.display().to_string())? {
        let path = entry?.path();
        if path.is_dir() {
            collect(&path, files)?;
        } else {
            files.push(path);
        }
    }
    Ok(())
}

/// Bytes that a server which compresses would send.
fn gzipped(bytes: &[u8]) -> Result<usize> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::best());
    encoder.write_all(bytes)?;
    Ok(encoder.finish()?.len())
}
