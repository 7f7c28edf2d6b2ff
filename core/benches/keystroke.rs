//! What happens at every keystroke: the request of the page as JSON text in, the answer as JSON text out.
//! Percentiles count here, not the mean: a slow keystroke is felt. Runs without a harness of its own kind because
//! the usual ones report no 99th percentile. Names as arguments measure these cycles alone.

use probewright_core::catalogue::CYCLES;
use probewright_core::catalogue::example::worked;
use probewright_core::{app, json};
use serde_json::{Value, json as object};
use std::hint::black_box;
use std::time::Instant;

const RUNS: usize = 2000;
/// Goals in milliseconds, at the 99th percentile.
const FORM_GOAL: f64 = 1.0;
const PREDICT_GOAL: f64 = 5.0;

fn main() {
    println!("{:<44} {:>9} {:>9} {:>9}  goal  99 % / goal", "ms", "50 %", "95 %", "99 %");
    let named: Vec<String> = std::env::args().skip(1).filter(|argument| !argument.starts_with("--")).collect();
    for cycle in CYCLES.iter().filter(|cycle| named.is_empty() || named.iter().any(|name| name == cycle.name)) {
        let control = cycle.dialect;
        let form = object!({ "control": control, "cycle": cycle.name, "values": worked(cycle) });
        measure(&format!("{} form, check, write", cycle.name), &form, FORM_GOAL);
        let mut predict = form;
        predict["predict"] = Value::Bool(true);
        measure(&format!("{} the same and simulate", cycle.name), &predict, PREDICT_GOAL);
    }
}

fn measure(name: &str, request: &Value, goal: f64) {
    let request = request.to_string();
    let mut times: Vec<f64> = (0..RUNS)
        .map(|_| {
            let start = Instant::now();
            black_box(json::answer(black_box(&request), app::form).ok());
            start.elapsed().as_secs_f64() * 1e3
        })
        .collect();
    times.sort_by(f64::total_cmp);
    let at = |percent: usize| times[(RUNS - 1) * percent / 100];
    let verdict = if at(99) < goal { "met" } else { "missed" };
    println!("{name:<44} {:>9.3} {:>9.3} {:>9.3}  < {goal}  {:.2} {verdict}", at(50), at(95), at(99), at(99) / goal);
}
