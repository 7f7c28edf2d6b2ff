//! Counting: what the test programs say in their closing lines.

use crate::steps::Steps;
use crate::tools::shown;
use anyhow::{Context, Result, bail};
use std::collections::BTreeSet;
use std::io::{BufRead, BufReader};
use std::path::PathBuf;
use std::process::{Command, Stdio};

/// So many files of tests may fail and be run once more: with more of them it is no matter of a loaded machine.
pub const AGAIN: usize = 3;

/// Tests and checks so far.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    pub passed: u32,
    pub failed: u32,
    /// Of the passed ones, those that passed only when they were run once more, alone.
    pub unsteady: u32,
}

/// What a test program told while it ran.
#[derive(Default)]
struct Told {
    counts: Counts,
    /// The files that hold a failed test, as far as it names them.
    failed: BTreeSet<PathBuf>,
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
        let told = self.told(name, command);
        self.add(told.counts);
    }

    /// As [`Tally::suite`], of files of tests. The few that fail run once more, with nothing beside them: a browser
    /// that shares its cores may answer later than a test waits. What then passes is counted, and said to be unsteady.
    pub fn files(&mut self, name: &str, files: &[PathBuf], command: impl Fn(&[PathBuf]) -> Command) {
        let first = self.told(name, &mut command(files));
        let again: Vec<PathBuf> = first.failed.into_iter().collect();
        if again.is_empty() || again.len() > AGAIN {
            return self.add(first.counts);
        }
        let second = self.told(&format!("{name}, once more"), &mut command(&again)).counts;
        self.add(first.counts.then(second));
    }

    /// Runs a test program as one step.
    fn told(&mut self, name: &str, command: &mut Command) -> Told {
        let mut told = Told::default();
        let outcome = self.steps.run(name, || {
            if !watched(command, &mut told)? {
                bail!("{} failed", shown(command));
            }
            if told.counts == Counts::default() {
                bail!("{} ran no test", shown(command));
            }
            Ok(())
        });
        if let Err(error) = outcome {
            eprintln!("error: {error:#}");
            told.counts.failed = told.counts.failed.max(1);
        }
        eprintln!("  {}", told.counts.line());
        told
    }

    fn add(&mut self, found: Counts) {
        self.counts.passed += found.passed;
        self.counts.failed += found.failed;
        self.counts.unsteady += found.unsteady;
    }
}

impl Counts {
    /// `12 passed, 0 failed`, and how many of the passed ones are unsteady.
    pub fn line(self) -> String {
        let unsteady = if self.unsteady == 0 { String::new() } else { format!(", {} unsteady", self.unsteady) };
        format!("{} passed, {} failed{unsteady}", self.passed, self.failed)
    }

    /// What stands after the files with a failed test ran once more.
    fn then(self, again: Counts) -> Counts {
        let unsteady = self.failed.saturating_sub(again.failed);
        Counts { passed: self.passed + unsteady, failed: again.failed, unsteady }
    }
}

fn watched(command: &mut Command, told: &mut Told) -> Result<bool> {
    let mut child = command.stdout(Stdio::piped()).spawn().with_context(|| shown(command))?;
    if let Some(output) = child.stdout.take() {
        for line in BufReader::new(output).split(b'\n') {
            let line = line?;
            let line = String::from_utf8_lossy(&line);
            println!("{line}");
            add(&mut told.counts, &line);
            told.failed.extend(failed_file(&line));
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

/// The file of a failed test, as Node names it below: `test at tests/e2e/page.spec.mjs:225:3`.
fn failed_file(line: &str) -> Option<PathBuf> {
    let place = line.strip_prefix("test at ")?;
    let end = place.find(".mjs:")? + ".mjs".len();
    Some(PathBuf::from(&place[..end]))
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
        assert_eq!(counted(&[rust, rust]), Counts { passed: 24, failed: 4, unsteady: 0 });
        let node = ["ℹ tests 4", "ℹ pass 3", "ℹ fail 1", "ℹ skipped 0"];
        assert_eq!(counted(&node), Counts { passed: 3, failed: 1, unsteady: 0 });
        assert_eq!(counted(&["pass 7", "12 passed", "running 3 tests"]), Counts::default());
    }

    // oracle: hand
    #[test]
    fn a_program_that_does_not_start_is_a_failure() {
        let mut tally = Tally::of(1);
        tally.suite("absent", &mut Command::new("no-such-program-anywhere"));
        assert_eq!(tally.counts, Counts { passed: 0, failed: 1, unsteady: 0 });
    }

    /// A test program that prints what is given and fails if that says so.
    #[cfg(unix)]
    fn says(lines: &str) -> Command {
        let mut shell = Command::new("sh");
        shell.args(["-c", "printf '%s\\n' \"$1\"; case \"$1\" in *'ℹ fail 0'*) exit 0;; esac; exit 1", "sh", lines]);
        shell
    }

    // oracle: hand
    #[cfg(unix)]
    #[test]
    fn a_file_that_fails_runs_once_more_and_what_then_passes_is_unsteady() {
        let all = [PathBuf::from("tests/e2e/a.spec.mjs"), PathBuf::from("tests/e2e/b.spec.mjs")];
        let first = "ℹ pass 8\nℹ fail 2\ntest at tests/e2e/b.spec.mjs:5:3\ntest at tests/e2e/b.spec.mjs:9:3";
        let run = |again: &'static str| {
            let mut tally = Tally::of(1);
            tally.files("page", &all, |files| {
                if files.len() == 2 { says(first) } else { says(if files == &all[1..] { again } else { first }) }
            });
            tally.counts
        };
        assert_eq!(run("ℹ pass 4\nℹ fail 0"), Counts { passed: 10, failed: 0, unsteady: 2 });
        assert_eq!(run("ℹ pass 3\nℹ fail 1"), Counts { passed: 9, failed: 1, unsteady: 1 });
        assert_eq!(run("ℹ pass 2\nℹ fail 2"), Counts { passed: 8, failed: 2, unsteady: 0 });
    }

    // oracle: hand
    #[cfg(unix)]
    #[test]
    fn more_than_a_few_files_that_fail_are_not_run_again() {
        let first = ["a", "b", "c", "d"].map(|name| format!("test at tests/e2e/{name}.spec.mjs:1:1")).join("\n");
        let mut tally = Tally::of(1);
        tally.files("page", &[], |_| says(&format!("ℹ pass 1\nℹ fail 4\n{first}")));
        assert_eq!(tally.counts, Counts { passed: 1, failed: 4, unsteady: 0 });
    }
}
