//! What a task does, step by step: which of how many it is at, and how long each took.

use anyhow::{Context, Result};
use std::fmt::Write;
use std::time::{Duration, Instant};

/// The steps of one task.
pub struct Steps {
    total: usize,
    start: Instant,
    done: Vec<Done>,
}

/// A step that came to its end, well or not.
struct Done {
    name: String,
    took: Duration,
}

impl Steps {
    /// A task of so many steps begins now.
    pub fn of(total: usize) -> Steps {
        Steps { total, start: Instant::now(), done: Vec::new() }
    }

    /// Does one named step; says before which it is, and after how long it took.
    pub fn run<T>(&mut self, name: &str, work: impl FnOnce() -> Result<T>) -> Result<T> {
        let at = self.done.len() + 1;
        let since = clock(self.start.elapsed());
        eprintln!("▸ {at} of {}: {name}  (begun {since} ago)", self.total.max(at));
        let start = Instant::now();
        let outcome = work().with_context(|| name.to_owned());
        let took = start.elapsed();
        let mark = if outcome.is_ok() { "✓" } else { "✗" };
        eprintln!("{mark} {name}  {}", clock(took));
        self.done.push(Done { name: name.to_owned(), took });
        outcome
    }

    /// How long each step took, a line each, and all of them.
    pub fn times(&self) -> String {
        let mut lines = String::new();
        for Done { name, took } in &self.done {
            let _ = writeln!(lines, "{:>8}  {name}", clock(*took)); // writing to a text does not fail
        }
        let _ = write!(lines, "{:>8}  in all", clock(self.start.elapsed()));
        lines
    }
}

/// Minutes and seconds: `2:05`.
fn clock(time: Duration) -> String {
    let seconds = time.as_secs_f64().round() as u64;
    format!("{}:{:02}", seconds / 60, seconds % 60)
}

#[cfg(test)]
mod tests {
    use super::*;
    use anyhow::bail;

    // oracle: hand
    #[test]
    fn a_time_is_minutes_and_seconds() {
        assert_eq!(clock(Duration::from_millis(400)), "0:00");
        assert_eq!(clock(Duration::from_millis(59_600)), "1:00");
        assert_eq!(clock(Duration::from_secs(3_725)), "62:05");
    }

    // oracle: hand
    #[test]
    fn every_step_has_its_line_failed_or_not() {
        let mut steps = Steps::of(2);
        assert_eq!(steps.run("first", || Ok(7)).ok(), Some(7));
        assert!(steps.run("second", || -> Result<()> { bail!("broken") }).is_err());
        assert_eq!(steps.times(), "    0:00  first\n    0:00  second\n    0:00  in all");
    }
}
