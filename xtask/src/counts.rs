//! Counting: what the test programs say in their closing lines.

use crate::tools::shown;
use anyhow::{Context, Result};
use std::io::{BufRead, BufReader};
use std::process::{Command, Stdio};
use std::time::Instant;

/// Tests and checks so far.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    pub passed: u32,
    pub failed: u32,
}

/// A check is one test: it passes when the work succeeds.
pub fn check(counts: &mut Counts, name: &str, work: impl FnOnce() -> Result<()>) -> bool {
    match crate::tools::step(name, work) {
        Ok(()) => {
            counts.passed += 1;
            true
        }
        Err(error) => {
            eprintln!("error: {error:#}");
            counts.failed += 1;
            false
        }
    }
}

/// Runs a test program, shows what it prints and counts its tests. A program that fails without naming a failed
/// test (it did not compile, say), or that ran none, is one failure.
pub fn suite(counts: &mut Counts, name: &str, command: &mut Command) {
    eprintln!("▸ {name}");
    let start = Instant::now();
    let mut found = Counts::default();
    let succeeded = watched(command, &mut found).unwrap_or_else(|error| {
        eprintln!("error: {error:#}");
        false
    });
    if (!succeeded && found.failed == 0) || found == Counts::default() {
        found.failed += 1;
    }
    counts.passed += found.passed;
    counts.failed += found.failed;
    let mark = if found.failed == 0 { "✓" } else { "✗" };
    let seconds = start.elapsed().as_secs_f64();
    eprintln!("{mark} {name}: {} passed, {} failed  {seconds:.1} s", found.passed, found.failed);
}

fn watched(command: &mut Command, found: &mut Counts) -> Result<bool> {
    let mut child = command.stdout(Stdio::piped()).spawn().with_context(|| shown(command))?;
    if let Some(output) = child.stdout.take() {
        for line in BufReader::new(output).split(b'\n') {
            let line = line?;
            let line = String::from_utf8_lossy(&line);
            println!("{line}");
            add(found, &line);
        }
    }
    Ok(child.wait()?.success())
}

/// Adds what a closing line says: `test result: ok. 3 passed; 0 failed; …` of Rust's test programs,
/// `ℹ pass 3` and `ℹ fail 0` of Node's.
fn add(found: &mut Counts, line: &str) {
    if let Some(rest) = line.trim().strip_prefix("test result: ") {
        found.passed += number_before(rest, " passed");
        found.failed += number_before(rest, " failed");
    }
    let rest = line.trim().trim_start_matches(['ℹ', '#']).trim_start();
    if rest.len() == line.trim().len() {
        return;
    }
    if let Some(number) = rest.strip_prefix("pass ") {
        found.passed += number.trim().parse().unwrap_or(0);
    }
    if let Some(number) = rest.strip_prefix("fail ") {
        found.failed += number.trim().parse().unwrap_or(0);
    }
}

fn number_before(text: &str, word: &str) -> u32 {
    text.find(word).and_then(|end| text[..end].rsplit(' ').next()).and_then(|number| number.parse().ok()).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn counted(lines: &[&str]) -> Counts {
        let mut found = Counts::default();
        lines.iter().for_each(|line| add(&mut found, line));
        found
    }

    // oracle: hand (closing lines as the programs print them)
    #[test]
    fn closing_lines_are_added_up() {
        let rust = "test result: FAILED. 12 passed; 2 failed; 0 ignored; 0 measured; 0 filtered out; finished in 0.1s";
        assert_eq!(counted(&[rust, rust]), Counts { passed: 24, failed: 4 });
        let node = ["ℹ tests 4", "ℹ pass 3", "ℹ fail 1", "ℹ skipped 0"];
        assert_eq!(counted(&node), Counts { passed: 3, failed: 1 });
        assert_eq!(counted(&["pass 7", "12 passed", "running 3 tests"]), Counts::default());
    }

    // oracle: hand
    #[test]
    fn a_program_that_does_not_start_is_a_failure() {
        let mut counts = Counts::default();
        suite(&mut counts, "absent", &mut Command::new("no-such-program-anywhere"));
        assert_eq!(counts, Counts { passed: 0, failed: 1 });
    }
}
