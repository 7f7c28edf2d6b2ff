//! Counting: what the test programs say in their closing lines.

use crate::steps::Steps;
use crate::tools::shown;
use anyhow::{Context, Result, bail};
use std::io::{BufRead, BufReader};
use std::process::{Command, Stdio};

/// Tests and checks so far.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    pub passed: u32,
    pub failed: u32,
}

/// The steps of a run of tests, and what they counted.
pub struct Tally {
    pub steps: Steps,
    pub counts: Counts,
}

impl Tally {
    /// A run of so many steps begins now.
    pub fn of(steps: usize) -> Tally {
        Tally { steps: Steps::of(steps), counts: Counts::default() }
    }

    /// A check is one test: it passes when the work succeeds.
    pub fn check(&mut self, name: &str, work: impl FnOnce() -> Result<()>) {
        let outcome = self.steps.run(name, work);
        self.one(outcome);
    }

    /// Counts work of several steps as one test; whether it succeeded.
    pub fn one(&mut self, outcome: Result<()>) -> bool {
        match &outcome {
            Ok(()) => self.counts.passed += 1,
            Err(error) => {
                eprintln!("error: {error:#}");
                self.counts.failed += 1;
            }
        }
        outcome.is_ok()
    }

    /// Runs a test program, shows what it prints and counts its tests. A program that fails without naming a failed
    /// test (it did not compile, say), or that ran none, is one failure.
    pub fn suite(&mut self, name: &str, command: &mut Command) {
        let mut found = Counts::default();
        let outcome = self.steps.run(name, || {
            if !watched(command, &mut found)? {
                bail!("{} failed", shown(command));
            }
            if found == Counts::default() {
                bail!("{} ran no test", shown(command));
            }
            Ok(())
        });
        if let Err(error) = outcome {
            eprintln!("error: {error:#}");
            found.failed = found.failed.max(1);
        }
        eprintln!("  {}", found.line());
        self.counts.passed += found.passed;
        self.counts.failed += found.failed;
    }
}

impl Counts {
    /// `12 passed, 0 failed`.
    pub fn line(self) -> String {
        format!("{} passed, {} failed", self.passed, self.failed)
    }
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
        let mut tally = Tally::of(1);
        tally.suite("absent", &mut Command::new("no-such-program-anywhere"));
        assert_eq!(tally.counts, Counts { passed: 0, failed: 1 });
    }
}
