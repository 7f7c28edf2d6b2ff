//! What becomes of measuring cycles where a program is not carried out in AUTOMATIC.
#![allow(clippy::unwrap_used)]

use super::mode::Mode;
use super::{Limits, Outcome, run};
use crate::check::upkeep::SCREEN;
use crate::control::Plane;
use crate::diagnostic::Code;
use crate::dialect::Dialect;
use crate::geometry::Mcs;
use crate::machine::{Setup, Step, Stop};
use crate::syntax::read;
use crate::workpiece::{Shape, Solid};

/// Line 4 measures a shaft of 70 mm that lies 0.01 mm off in X, and corrects G54.
const PROGRAM: &str = "G17 G90 G54 T9 D1\n\
    G0 X64 Y38 Z130 F1000\n\
    _MVAR=102 _SETVAL=70 _FA=2 _TSA=2 _ID=-20 _KNUM=1 _PRNUM=1 _VMS=0 _NMSP=1\n\
    CYCLE977\n\
    R1=$P_DRYRUN+2*$P_ISTEST+4*$P_SEARCH+8*$P_SIM+16*$A_PROTO\n\
    R2=$P_UIFR[1,X,TR]+$P_UIFR[1,X,FI]\n\
    M30\n";

fn ran(mode: Mode, target: u32, data: &[(&str, f64)]) -> Outcome {
    let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    let shaft = Shape::Shaft { diameter: 70.0, height: 40.0 };
    setup.workpiece.solids.push(Solid::new(shaft, Mcs([64.01, 38.0, 120.0])));
    setup.position = Mcs([70.0, 200.0, 500.0]);
    data.iter().for_each(|(name, value)| setup.control.set(*name, *value));
    let outcome =
        run(&read(Dialect::Sinumerik, PROGRAM.as_bytes()), &setup, Limits { mode, target, ..Limits::default() });
    assert!(outcome.finished(), "{:?}", outcome.diagnostics);
    outcome
}

/// Diameter, system variables as a sum, correction of G54, and the keys of what was told.
fn told(outcome: &Outcome) -> ([f64; 3], Vec<String>) {
    let number = |name: &str| (outcome.control.number(name) * 1e4).round() / 1e4;
    let keys = outcome.diagnostics.iter().map(|one| one.message.key.to_string()).filter(|key| key.starts_with("run-"));
    (["_OVR[4]", "R1", "R2"].map(number), keys.collect())
}

// oracle: manual B:660-668 (which modes skip the cycles, and the variables that tell the mode)
#[test]
fn measuring_cycles_are_skipped_and_results_stay() {
    assert_eq!(told(&ran(Mode::Automatic, 0, &[])), ([70.0, 0.0, 0.01], vec![]));
    for (mode, variables, key) in
        [(Mode::DryRun, 1.0, "run-skipped-dry-run"), (Mode::ProgramTest, 2.0, "run-skipped-program-test")]
    {
        let (found, keys) = told(&ran(mode, 0, &[("_OVR[4]", 12.5)]));
        assert_eq!((found, keys), ([12.5, variables, 0.0], vec![key.to_owned()]));
    }
}

// oracle: hand (where no axis moves nothing is hit; in a dry run the axes move)
#[test]
fn nothing_is_hit_where_no_axis_moves() {
    let program = "G17 G90 G54 T9 D1\nG0 X64 Y38 Z10\nG0 Z130\nM30\n";
    for (mode, target, hits) in [
        (Mode::Automatic, 0, true),
        (Mode::DryRun, 0, true),
        (Mode::ProgramTest, 0, false),
        (Mode::BlockSearch, 4, false),
        (Mode::BlockSearch, 2, true),
    ] {
        let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
        let shaft = Shape::Shaft { diameter: 70.0, height: 40.0 };
        setup.workpiece.solids.push(Solid::new(shaft, Mcs([64.0, 38.0, 120.0])));
        setup.position = Mcs([70.0, 200.0, 500.0]);
        let limits = Limits { mode, target, ..Limits::default() };
        let outcome = run(&read(Dialect::Sinumerik, program.as_bytes()), &setup, limits);
        assert_eq!(!outcome.finished(), hits, "{mode:?} {target}: {:?}", outcome.diagnostics);
    }
}

// oracle: manual B:666 (the search is over where its block is reached), hand
#[test]
fn a_block_search_skips_up_to_its_line() {
    assert_eq!(told(&ran(Mode::BlockSearch, 4, &[])), ([70.0, 0.0, 0.01], vec![]));
    let skipped = vec!["run-skipped-block-search".to_owned()];
    assert_eq!(told(&ran(Mode::BlockSearch, 5, &[])), ([0.0, 0.0, 0.0], skipped.clone()));
    let (found, keys) = told(&ran(Mode::BlockSearch, 99, &[]));
    assert_eq!((found, keys), ([0.0, 4.0, 0.0], [skipped, vec!["run-search-missed".to_owned()]].concat()));
}

// oracle: hand: where the searched blocks end is told at the block at which the search ends, in the program's units,
// once
#[test]
fn where_a_run_goes_on_after_a_search_is_told() {
    let told = |text: &str, target| {
        let setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
        let limits = Limits { mode: Mode::BlockSearch, target, ..Limits::default() };
        let outcome = run(&read(Dialect::Sinumerik, text.as_bytes()), &setup, limits);
        let found = outcome.diagnostics.into_iter().filter(|one| one.message.key == "search-ended");
        found.map(|one| (one.span.unwrap().start, one.message.word("position").unwrap().to_owned())).collect::<Vec<_>>()
    };
    let program = "G90 G0 X64 Y38 Z300\nX70.1234\nY0\nM30\n";
    assert_eq!(told(program, 3), [(29, "X70.123 Y38 Z300".to_owned())]);
    assert_eq!(told(program, 1), [(0, "X0 Y0 Z500".to_owned())]);
    assert_eq!(told(program, 99), []);
    assert_eq!(told("G70 G0 X1 Y2 Z20\nM0\nM30\n", 2), [(17, "X1 Y2 Z20".to_owned())]);
    let looping = "R1=0\nAGAIN: R1=R1+1\nG0 Z=300+R1\nIF R1<3 GOTOB AGAIN\nM30\n";
    assert_eq!(told(looping, 3).len(), 1);
}

// oracle: hand: what a program is told at its end, it is told where an alarm ends it
#[test]
fn a_program_that_stops_is_told_the_same() {
    let keys = |dialect, text: &[u8], mode, target| {
        let setup = Setup::calibrated(dialect, Plane::G17);
        let outcome = run(&read(dialect, text), &setup, Limits { mode, target, ..Limits::default() });
        outcome.diagnostics.iter().map(|one| one.message.key.to_string()).collect::<Vec<_>>()
    };
    for end in ["M30\n", "SETAL(65000)\nM30\n", "X=1/0\nM30\n", "GOTOF NOWHERE\n"] {
        let text = format!("G0 Z300\n{end}");
        let missed = keys(Dialect::Sinumerik, text.as_bytes(), Mode::BlockSearch, 999);
        assert!(missed.contains(&"run-search-missed".to_owned()), "{end}: {missed:?}");
        let none = keys(Dialect::Sinumerik, text.as_bytes(), Mode::BlockSearch, 0);
        assert!(none.contains(&"run-search-target".to_owned()), "{end}: {none:?}");
    }
    for end in ["M30\n", "#3000=5\nM30\n", "GOTO 99\n"] {
        let none = keys(Dialect::Nct, format!("G0 Z300\n{end}").as_bytes(), Mode::DryRun, 0);
        assert!(none.contains(&"run-mode-none".to_owned()), "{end}: {none:?}");
    }
}

// oracle: manual B:672-694, hand (touched from both sides 0.1 mm further in: 70 - 0.2 mm; an inch system gives inches)
#[test]
fn a_simulation_measures_with_its_deviation() {
    assert_eq!(told(&ran(Mode::Simulation, 0, &[])), ([70.0, 8.0, 0.01], vec![]));
    let (found, keys) = told(&ran(Mode::Simulation, 0, &[("_MC_SIMDIFF", 0.1)]));
    assert_eq!((found, keys), ([69.8, 8.0, 0.01], vec!["run-deviation".to_owned()]));
    let (found, keys) = told(&ran(Mode::Simulation, 0, &[("_MC_SIMSIM", 0.0)]));
    assert_eq!((found, keys), ([0.0, 8.0, 0.0], vec!["run-skipped-simulation".to_owned()]));
    // in AUTOMATIC neither counts
    assert_eq!(told(&ran(Mode::Automatic, 0, &[("_MC_SIMDIFF", 0.1), ("_MC_SIMSIM", 0.0)])).0, [70.0, 0.0, 0.01]);
}

// oracle: manual B:676-678 (measured, but no offset is corrected)
#[test]
fn jobshop_corrects_nothing() {
    assert_eq!(told(&ran(Mode::Jobshop, 0, &[])), ([70.0, 20.0, 0.0], vec!["run-jobshop".to_owned()]));
}

// oracle: manual B:676-678 (measured, but no offset is corrected): nothing says or records that one is
#[test]
fn jobshop_says_that_nothing_is_corrected() {
    let tool = PROGRAM.replace("_MVAR=102 ", "_MVAR=2 _TNUM=9 _TUL=0.02 _TLL=-0.02 _TDIF=1 ");
    let tool = tool.replace("_KNUM=1 ", "_KNUM=2001 "); // the radius of the tool
    for (text, automatic) in [(PROGRAM, "evaluate-not-activated"), (&tool[..], "evaluate-corrects-whole")] {
        let steps = |mode| {
            let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
            let shaft = Shape::Shaft { diameter: 70.1, height: 40.0 };
            setup.workpiece.solids.push(Solid::new(shaft, Mcs([64.01, 38.0, 120.0])));
            setup.position = Mcs([70.0, 200.0, 500.0]);
            let outcome = run(&read(Dialect::Sinumerik, text.as_bytes()), &setup, Limits { mode, ..Limits::default() });
            assert!(outcome.finished(), "{:?}", outcome.diagnostics);
            outcome.trace.entries.iter().map(|entry| entry.step.clone()).collect::<Vec<_>>()
        };
        let said = |steps: &[Step]| {
            let key = |step: &Step| match step {
                Step::Decision { message } => Some(message.word("follows").unwrap_or(&message.key).to_owned()),
                _ => None,
            };
            steps.iter().filter_map(key).collect::<Vec<_>>()
        };
        let sets = |steps: &[Step]| {
            let of_offset = |name: &str| name.starts_with("$TC_") || name.starts_with("$P_");
            steps.iter().filter(|step| matches!(step, Step::Set { name, .. } if of_offset(name))).count()
        };
        let (real, shown) = (steps(Mode::Automatic), steps(Mode::Jobshop));
        assert!(said(&real).contains(&automatic.to_owned()), "{:?}", said(&real));
        assert!(sets(&real) > 0 && sets(&shown) == 0, "{}", sets(&shown));
        let corrects = |key: &String| key.starts_with("evaluate-corrects") && key != "evaluate-corrects-simulated";
        assert!(!said(&shown).iter().any(|key| corrects(key) || key == automatic), "{:?}", said(&shown));
    }
}

// oracle: manual B:676-678 (neither measuring result display nor travel with collision monitoring nor logging)
#[test]
fn jobshop_neither_shows_nor_monitors_nor_logs() {
    let log = "_PROTNAME[0]=\"MAIN\" _PROTNAME[1]=\"LOGX\" _PROTVAL[2]=\"_OVR[0],_OVR[4]\"\nCYCLE100\n";
    let text = PROGRAM
        .replace("CYCLE977\n", "CYCLE977\nCYCLE106(2)\nCYCLE105(1)\nCYCLE101\n")
        .replace("_MVAR=102", &format!("{log}_MVAR=102"));
    let done = |mode, stands: bool| {
        let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
        let mut put = |shape, at| setup.workpiece.solids.push(Solid::new(shape, Mcs(at)));
        put(Shape::Shaft { diameter: 70.0, height: 40.0 }, [64.0, 38.0, 120.0]);
        if stands {
            put(Shape::Block { size: [6.0, 6.0, 30.0] }, [85.0, 38.0, 150.0]); // on the shaft, in the way to its side
        }
        setup.position = Mcs([64.0, 38.0, 500.0]);
        setup.control.set("_CHBIT[10]", 1.0);
        run(&read(Dialect::Sinumerik, text.as_bytes()), &setup, Limits { mode, ..Limits::default() })
    };
    let screens = |outcome: &Outcome| {
        let shows = |step: &Step| matches!(step, Step::Decision { message } if message.key == SCREEN);
        outcome.trace.entries.iter().filter(|entry| shows(&entry.step)).count()
    };
    let real = done(Mode::Automatic, false);
    assert!(real.finished() && real.files.iter().count() == 1 && screens(&real) == 1, "{:?}", real.diagnostics);
    assert_eq!(done(Mode::Automatic, true).stop, Some(Stop::Alarm(Code::Alarm(61302))));
    for stands in [false, true] {
        let shown = done(Mode::Jobshop, stands);
        assert!(shown.finished(), "{:?} {:?}", shown.stop, shown.diagnostics);
        assert_eq!((shown.files.iter().count(), screens(&shown), shown.control.number("_OVR[4]")), (0, 0, 70.0));
    }
}

// oracle: hand (SD 42100 as delivered): a slow feed is raised, a faster one and rapid traverse stay
#[test]
fn a_dry_run_is_driven_with_its_feed() {
    let program = b"G90 G0 Z300\nG1 X10 F200\nX20 F8000\nM30\n";
    let feeds = |mode| {
        let setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
        let outcome = run(&read(Dialect::Sinumerik, program), &setup, Limits { mode, ..Limits::default() });
        let feed = |step: &Step| match step {
            Step::Motion { feed, .. } => Some(*feed),
            _ => None,
        };
        outcome.trace.entries.iter().filter_map(|entry| feed(&entry.step)).collect::<Vec<_>>()
    };
    assert_eq!(feeds(Mode::Automatic)[1..], [200.0, 8000.0]);
    assert_eq!(feeds(Mode::DryRun)[1..], [5000.0, 8000.0]);
    assert_eq!(feeds(Mode::DryRun)[0], feeds(Mode::Automatic)[0]);
}

// oracle: hand: a mode that a control does not have is told, and changes nothing
#[test]
fn a_mode_of_the_other_control_is_told() {
    let setup = Setup::calibrated(Dialect::Nct, Plane::G17);
    let keys = |mode| {
        let outcome = run(&read(Dialect::Nct, b"G0 Z300\nM30\n"), &setup, Limits { mode, ..Limits::default() });
        outcome.diagnostics.iter().map(|one| one.message.key.to_string()).collect::<Vec<_>>()
    };
    assert!(keys(Mode::DryRun).contains(&"run-mode-none".to_owned()));
    assert!(!keys(Mode::Automatic).contains(&"run-mode-none".to_owned()));
}
