//! The terminal program as a user runs it.
#![cfg(feature = "cli")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, missing_docs)]

mod around;
mod encodings;
mod explained;
mod files;
mod help;
mod jog;
mod programs;
mod scenarios;
mod wrong_use;

use std::process::{Command, Output};

fn probewright(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_probewright"))
        .env("LC_ALL", "C")
        .args(arguments)
        .output()
        .expect("the program starts")
}

fn out(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).unwrap()
}

fn err(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

fn file(name: &str, text: &[u8]) -> String {
    let folder = std::env::temp_dir().join(format!("probewright-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join(name);
    // whole at once: another test may be reading the file of that name
    let new = folder.join(format!("{name}-{:?}", std::thread::current().id()));
    std::fs::write(&new, text).unwrap();
    std::fs::rename(&new, &path).unwrap();
    path.to_str().unwrap().to_owned()
}

fn example_setup() -> String {
    format!("{}/../docs/setup.example.json", env!("CARGO_MANIFEST_DIR"))
}

/// The measured hole of the readme: 0.03 mm too big, radius of T20 D1 to be corrected.
const HOLE: &str = "N10 G54 G17 G90 T9 D1\nN20 M6\nN30 G0 X180 Y130\nN40 Z20\nN50 _CHBIT[4]=1\n\
    N60 _TUL=0.1 _TLL=-0.1 _TZL=0.001 _TMV=0.02 _TDIF=0.2 _TSA=1 _FA=2\n\
    N61 _MVAR=1 _SETVAL=132 _TNUM=20 _KNUM=2001\nN70 CYCLE977\nN80 G0 Z160\nN90 M2\n";
