//! Reads requests as JSON lines, writes forms' pictures as JSON lines.
use std::io::{BufRead, Write};
fn main() {
    let mut out = std::io::stdout().lock();
    for line in std::io::stdin().lock().lines() {
        let line = line.unwrap();
        let text = match probewright_core::json::form(&line) {
            Ok(view) => view["picture"].to_string(),
            Err(error) => format!("\"{error:?}\""),
        };
        writeln!(out, "{text}").unwrap();
    }
}
