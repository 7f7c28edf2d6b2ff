//! Reading files, and which control a program is for.

use clap::ValueEnum;
use probewright_core::catalogue::Dialect;
use std::path::Path;

/// Control as named on the command line.
#[derive(Clone, Copy, ValueEnum)]
pub enum Control {
    /// SINUMERIK 840D/840Di/810D
    Sinumerik,
    /// NCT
    Nct,
}

/// Why a command did not work, as a line.
pub type Problem = Box<dyn std::error::Error>;

/// Bytes of a file; the error names the file.
pub fn bytes(path: &Path) -> Result<Vec<u8>, Problem> {
    std::fs::read(path).map_err(|error| format!("{}: {error}", path.display()).into())
}

/// Text of a file; the error names the file.
pub fn text(path: &Path) -> Result<String, Problem> {
    String::from_utf8(bytes(path)?)
        .map_err(|_| format!("{}: not UTF-8 text", path.display()).into())
}

/// The control that was asked for, else the one that the program is written for: NCT programs begin with `%O` or `O`
/// and a number (C:1159), everything else is taken for SINUMERIK.
pub fn dialect(control: Option<Control>, source: &[u8]) -> Dialect {
    match control {
        Some(Control::Sinumerik) => Dialect::Sinumerik,
        Some(Control::Nct) => Dialect::Nct,
        None if names_nct_program(source) => Dialect::Nct,
        None => Dialect::Sinumerik,
    }
}

fn names_nct_program(source: &[u8]) -> bool {
    let rest = source.trim_ascii_start();
    let rest = rest.strip_prefix(b"%").unwrap_or(rest).trim_ascii_start();
    matches!(rest, [b'O' | b'o', digit, ..] if digit.is_ascii_digit())
}
