//! Programs that grow: how long it takes to find what is wrong in one of twice the blocks, or to run it, as a ratio to
//! the half. In each of them something once took time with the square of the length; what is linear doubles.

use probewright_core::control::Plane;
use probewright_core::dialect::Dialect;
use probewright_core::machine::Setup;
use probewright_core::program::findings;
use probewright_core::run::{Limits, Session};
use probewright_core::syntax::read;
use std::time::Instant;

/// Repetitions of a pattern in the smaller program.
const TIMES: usize = 3200;
/// What doubles, with room for the noise of a computer that does other things.
const GOAL: f64 = 2.5;

/// A program by the number of its repetitions.
struct Growing {
    name: &'static str,
    text: fn(usize) -> String,
    work: fn(&str),
}

const ALL: [Growing; 9] = [
    Growing { name: "conditional jumps, each to a label of its own", text: jumps_apart, work: check },
    Growing { name: "conditional jumps to one label", text: jumps_together, work: check },
    Growing { name: "IF with ELSE", text: choices, work: check },
    Growing { name: "programs of one archive", text: archive, work: check },
    Growing { name: "jumps backward", text: backward, work: check },
    Growing { name: "FOR loops", text: loops, work: check },
    Growing { name: "CASE with several targets", text: cases, work: check },
    Growing { name: "measuring calls", text: calls, work: check },
    Growing { name: "values of a log, run", text: logged, work: run },
];

fn main() {
    for growing in &ALL {
        let (once, twice) = (least(growing, TIMES), least(growing, 2 * TIMES));
        let ratio = twice / once;
        let verdict = if ratio < GOAL { "met" } else { "missed" };
        println!(
            "{:<60} {twice:>9.3} ms  x {ratio:.2}  < {GOAL}  {verdict}",
            format!("{} x {}", 2 * TIMES, growing.name)
        );
    }
}

/// Least of several times, ms.
fn least(growing: &Growing, times: usize) -> f64 {
    let text = (growing.text)(times);
    let taken = (0..5).map(|_| {
        let begun = Instant::now();
        (growing.work)(&text);
        begun.elapsed().as_secs_f64() * 1e3
    });
    taken.fold(f64::INFINITY, f64::min)
}

fn check(text: &str) {
    std::hint::black_box(findings(&read(Dialect::Sinumerik, text.as_bytes())));
}

fn run(text: &str) {
    let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    setup.control.set("MD11420", 1e6);
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let outcome = Session::new(program, &setup, Limits::default()).complete();
    assert!(outcome.finished(), "{:?}", outcome.stop);
}

fn each(times: usize, block: impl Fn(usize) -> String) -> String {
    (0..times).map(block).collect()
}

fn jumps_apart(times: usize) -> String {
    let jumps = each(times, |at| format!("IF R{}==7 GOTOF L{at}\n_V{at}={at}\n", at % 100));
    jumps + &each(times, |at| format!("L{at}: _W{at}=_V{at}\nRET\n"))
}

fn jumps_together(times: usize) -> String {
    each(times, |at| format!("IF R{}==7 GOTOF L\n_V{at}={at}\n", at % 100)) + "L: X1\nM30\n"
}

fn choices(times: usize) -> String {
    each(times, |at| format!("IF R1==7\n_V{at}={at}\nELSE\n_W{at}={at}\nENDIF\n")) + "M30\n"
}

fn archive(times: usize) -> String {
    let main = each(times, |at| format!("S{at}\n")) + "M30\n";
    main + &each(times, |at| format!("%_N_S{at}_SPF\n_V{at}=_V{}+1\nM17\n", at * 7 % times))
}

fn backward(times: usize) -> String {
    each(times, |at| format!("_V{at}={at}\nL{at}: _W{at}=_V{at}\nIF _V{at}>3 GOTOB L{at}\n")) + "M30\n"
}

fn loops(times: usize) -> String {
    each(times, |at| format!("FOR R1=0 TO 3\n_V{at}=_V{at}+R1\nENDFOR\n")) + "M30\n"
}

fn cases(times: usize) -> String {
    let case =
        |at| format!("CASE R1 OF 1 GOTOF L{at} 2 GOTOF M{at} DEFAULT GOTOF K\n_V{at}=1\nL{at}:\n_V{at}=2\nM{at}:\n");
    each(times, case) + "K:\nM30\n"
}

fn calls(times: usize) -> String {
    let call = |at| format!("_V{at}={at}\n_MVAR=1 _SETVAL=_V{at} _PRNUM=1 _FA=2 _TSA=2 _KNUM=0\nCYCLE977\n");
    each(times, call) + "M30\n"
}

fn logged(times: usize) -> String {
    let begin = "_PROTNAME[0]=\"PART\" _PROTNAME[1]=\"LOG_1\" _PROTVAL[0]=\"What\" _PROTVAL[2]=\"R1\"\nCYCLE100\n";
    begin.to_owned() + &each(times, |_| "CYCLE106(2)\n".into()) + "CYCLE101\nM30\n"
}
