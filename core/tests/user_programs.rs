//! CYCLE198 and CYCLE199: the user's programs before and after each measurement.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use probewright_core::catalogue::example::worked;
use probewright_core::catalogue::find;
use probewright_core::check::check;
use probewright_core::control::Plane;
use probewright_core::dialect::Dialect;
use probewright_core::machine::Setup;
use probewright_core::run::{Limits, Outcome, run};
use probewright_core::syntax::read;

/// A run of two measurements of a surface, with these programs behind the main program.
fn outcome(programs: &str) -> Outcome {
    let cycle = find(Dialect::Sinumerik, "CYCLE978").unwrap();
    let mut typed = worked(cycle);
    typed.insert("_KNUM".into(), "0".into());
    let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    let checked = check(cycle, &typed, &setup.control);
    let proposal = (cycle.work().unwrap().propose)(&checked.inputs.unwrap(), &setup.control);
    setup.workpiece = proposal.workpiece;
    setup.position = setup.control.to_machine(proposal.start);
    let values = typed.iter().map(|(name, value)| match value.parse::<f64>() {
        Ok(_) => format!("{name}={value}\n"),
        Err(_) => format!("{name}=\"{value}\"\n"),
    });
    let text =
        format!("%_N_MAIN_MPF\n{}R1=R1+1 CYCLE978\nR5=R3\nCYCLE978\nM30\n{programs}", values.collect::<String>());
    run(&read(Dialect::Sinumerik, text.as_bytes()), &setup, Limits::default())
}

fn numbers(outcome: &Outcome) -> [f64; 4] {
    assert_eq!(outcome.stop, None, "{:?}", outcome.diagnostics);
    ["R1", "R2", "R3", "R5"].map(|name| outcome.control.number(name))
}

// oracle: manual B:2476-2508 (called at the beginning and when complete; from the label of the cycle to M17)
#[test]
fn they_run_around_each_measurement() {
    let programs = "%_N_CYCLE198_SPF\nR9=R8\n_M974: R2=100\nM17\n_M978: R2=R2+1\nM17\n\
        %_N_CYCLE199_SPF\nR3=R3+10*R2\nM17\n";
    let outcome = outcome(programs);
    // once before and once behind each of two; the block of the first call was carried out once
    assert_eq!(numbers(&outcome), [1.0, 2.0, 30.0, 10.0]);
}

// oracle: manual B:2488-2490 (empty by default)
#[test]
fn without_them_nothing_happens() {
    let plain = outcome("");
    assert_eq!(numbers(&plain), [1.0, 0.0, 0.0, 0.0]);
    let called = "CYCLE198\nR1=1\nCYCLE199\nM30\n";
    let setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    let outcome = run(&read(Dialect::Sinumerik, called.as_bytes()), &setup, Limits::default());
    assert_eq!((outcome.stop, outcome.diagnostics.len()), (None, 0));
}

// oracle: hand (a user's program that measures does not call itself; its M30 ends it only)
#[test]
fn a_measurement_inside_of_one_ends() {
    let outcome = outcome("%_N_CYCLE198_SPF\nR2=R2+1\nCYCLE978\nM30\n");
    assert_eq!(numbers(&outcome)[1], 2.0);
}
