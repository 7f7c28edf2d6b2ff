//! A run of a program of a million blocks in the terminal: its time, and the most memory that it takes.

use std::fmt::Write;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// Blocks of the program.
const BLOCKS: u32 = 1_000_000;
/// Seconds and MB.
const GOALS: [(&str, f64); 2] = [("s", 1.0), ("MB", 300.0)];
/// Between two looks at the memory.
const BETWEEN: Duration = Duration::from_millis(2);

fn main() {
    let path = std::env::temp_dir().join("probewright-large.mpf");
    if let Err(error) = std::fs::write(&path, program()) {
        println!("{}: {error}", path.display());
        return;
    }
    for way in ["in pieces", "held whole"] {
        let Some(runs) = (0..3).map(|_| run(&path, way)).collect::<Option<Vec<_>>>() else {
            println!("the program cannot be run {way}");
            continue;
        };
        let least = runs.iter().copied().fold([f64::INFINITY; 2], |least, run| [0, 1].map(|at| least[at].min(run[at])));
        for ((unit, goal), taken) in GOALS.into_iter().zip(least).filter(|(_, taken)| *taken > 0.0) {
            let verdict = if taken < goal { "met" } else { "missed" };
            let what = format!("run of {BLOCKS} blocks, {way}");
            println!("{what:<60} {taken:>9.3} {unit}  x {:.2}  < {goal}  {verdict}", taken / goal);
        }
    }
    for file in [&path, &path.with_extension("spf")] {
        drop(std::fs::remove_file(file));
    }
}

/// Straight motions.
fn program() -> String {
    let mut text = "G17 G90 G54\nT1 D1\nM3 S1000\n".to_owned();
    for block in 0..BLOCKS {
        let along = f64::from(block % 1000);
        let (x, y, z) = (along / 7.0, -along / 11.0, f64::from(block % 97) / 13.0);
        _ = writeln!(text, "N{} G1 X{x:.3} Y{y:.3} Z{z:.4} F1200", u64::from(block) * 10);
    }
    text + "M30\n"
}

/// Seconds and MB of one run; 0 MB where the system does not tell.
fn run(path: &Path, way: &str) -> Option<[f64; 2]> {
    let mut command = Command::new(env!("CARGO_BIN_EXE_probewright"));
    command.arg("run").arg(path).stdout(Stdio::null()).stderr(Stdio::null());
    if way != "in pieces" {
        command.arg("--with").arg(path.with_extension("spf"));
        std::fs::write(path.with_extension("spf"), "M17\n").ok()?;
    }
    let begun = Instant::now();
    let mut child = command.spawn().ok()?;
    let mut most: f64 = 0.0;
    while child.try_wait().ok()?.is_none() {
        most = most.max(memory(&child).unwrap_or(0.0));
        std::thread::sleep(BETWEEN);
    }
    let taken = begun.elapsed().as_secs_f64();
    child.wait().ok()?.success().then_some([taken, most])
}

/// The most memory that a process has taken so far, MB, where the system tells it as Linux does.
fn memory(child: &Child) -> Option<f64> {
    let status = std::fs::read_to_string(format!("/proc/{}/status", child.id())).ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    Some(line.trim().trim_end_matches("kB").trim().parse::<f64>().ok()? / 1000.0)
}
