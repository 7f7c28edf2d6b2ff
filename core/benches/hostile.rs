//! The slowest prediction among those of many machines, parts and probes that nobody thinks of: one call of a form, as
//! text in and out. What takes longest is taken again, so that a pause of this computer does not count.

#[path = "../tests/hostile_setups/case.rs"]
#[allow(dead_code)] // the tests that share it call more of it
mod case;
#[path = "../tests/hostile_setups/draw.rs"]
mod draw;
#[path = "../tests/hostile_setups/setup.rs"]
mod setup;

use case::Case;
use std::time::Instant;

const CASES: u64 = 5000;
/// How many of the slowest are told.
const SLOWEST: usize = 5;
/// Goal in milliseconds.
const GOAL: f64 = 50.0;

fn main() {
    let mut all: Vec<(f64, u64)> = (0..CASES)
        .map(|number| {
            let case = Case::heavy(number);
            (time(&case).min(time(&case)), number)
        })
        .collect();
    all.sort_by(|a, b| b.0.total_cmp(&a.0));
    let again = all.iter().take(4 * SLOWEST).map(|(first, number)| {
        let case = Case::heavy(*number);
        let least = (0..4).fold(*first, |least, _| least.min(time(&case)));
        (least, case.name, number)
    });
    let mut again: Vec<_> = again.collect();
    again.sort_by(|a, b| b.0.total_cmp(&a.0));
    for (taken, name, number) in again.iter().take(SLOWEST) {
        let verdict = if *taken < GOAL { "met" } else { "missed" };
        println!(
            "{:<60} {taken:>9.3} ms  < {GOAL}  {verdict}",
            format!("slowest prediction of {CASES} hostile setups: {name} ({number})")
        );
    }
}

/// How long the answer takes, ms.
fn time(case: &Case) -> f64 {
    let begun = Instant::now();
    let answer = case.answer();
    let taken = begun.elapsed().as_secs_f64() * 1e3;
    drop(std::hint::black_box(answer.ok()));
    taken
}
