//! Warnings about whole programs: what is active at a call, along the calls of subprograms and past branches.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod corrected;
mod inherited;
mod loops;
mod tools;
mod unsaid;
mod ways;

use probewright_core::diagnostic::Code::Own;
use probewright_core::diagnostic::{Code, Diagnostic};
use probewright_core::dialect::Dialect;
use probewright_core::program::findings;
use probewright_core::syntax::read;

/// A hole that is only measured, and its call.
const HOLE: &str = "_MVAR=1 _SETVAL=132 _KNUM=0 _PRNUM=1 _FA=2 _TSA=2\nCYCLE977\n";
/// The same at the tool probe: length of the tool in use.
const LENGTH: &str = "_MVAR=1 _MA=3 _ID=20 _PRNUM=1 _FA=10 _TSA=5\nCYCLE971\n";
/// A turning tool is measured.
const TURNED: &str = "_MVAR=1 _MA=1 _PRNUM=1 _FA=10 _TSA=5\nCYCLE972\n";

const COMPENSATION: Code = Own(130);
const PLANE: Code = Own(131);
const EDGE: Code = Own(133);
const SPINDLE: Code = Own(134);
const CALIBRATION: Code = Own(135);
const DIAMETER: Code = Own(132);
const FRAME: Code = Own(137);
const INHERITED: Code = Own(136);
const LEVEL: Code = Own(138);
const OPEN: Code = Own(145);
const COMPENSATION_LATER: Code = Own(146);
const NO_TOOL: Code = Own(147);
const RADIUS: Code = Own(148);
const OVERWRITTEN: Code = Own(150);
const OUTSIDE: Code = Own(310);

fn found(text: &str) -> Vec<Diagnostic> {
    findings(&read(Dialect::Sinumerik, text.as_bytes()))
}

fn tells(text: &str, code: Code) -> bool {
    found(text).iter().any(|finding| finding.code == code)
}

/// A main program and a subprogram `L5` with the call of the hole, or what is given.
fn called(main: &str, sub: &str) -> String {
    format!("%_N_MAIN_MPF\n{main}\nM30\n%_N_L5_SPF\n{sub}\nM17\n")
}
