//! Programs that never end: those that come back to what was before are told at once, where they jump back; others by
//! limits that leave room for long programs.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

mod running;

use probewright_core::control::Plane;
use probewright_core::dialect::Dialect;
use probewright_core::geometry::{Mcs, Rpy};
use probewright_core::machine::trace::Step;
use probewright_core::machine::{Setup, Stop};
use probewright_core::run::{Limits, Outcome, Session, run};
use probewright_core::syntax::read;
use probewright_core::workpiece::Shape;
use running::{clean_on, go_on, machine};

const CALL: &str = "_MVAR=100 _KNUM=0 _MA=3 _SETVAL=0 _FA=5 _TSA=4 _TUL=3 _TLL=-3\n";

/// A block with its face at 0, the probe 5 mm above it.
fn measuring() -> Setup {
    let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    setup.workpiece.solids.push(running::block());
    setup.position = Mcs([0.0, 0.0, 5.0]);
    setup
}

fn ran(setup: &Setup, dialect: Dialect, text: &str, limits: Limits) -> Outcome {
    run(&read(dialect, text.as_bytes()), setup, limits)
}

fn key(outcome: &Outcome) -> &str {
    match &outcome.stop {
        Some(Stop::Fault(message)) => &message.key,
        other => panic!("{other:?}"),
    }
}

/// Text of the block at which a program that never ends is told, and how many steps it recorded.
fn proved(setup: &Setup, dialect: Dialect, text: &str) -> (String, usize) {
    let outcome = ran(setup, dialect, text, Limits::default());
    assert_eq!(key(&outcome), "run-endless", "{text}");
    let found = outcome.diagnostics.last().unwrap();
    let span = found.span.unwrap();
    let place = text[span.start as usize..span.end as usize].trim().to_owned();
    (place, outcome.trace.entries.len())
}

fn calls(outcome: &Outcome) -> usize {
    let entries = outcome.trace.entries.iter();
    entries.filter(|entry| matches!(entry.step, Step::CallBegin { .. })).count()
}

// oracle: hand: a counted loop ends; whoever permits the work has it done, also with a record of that length
#[test]
fn a_counted_loop_goes_on_as_long_as_is_permitted() {
    let text = "FOR R1=1 TO 12\nCYCLE101\nENDFOR\nM30";
    let limits = Limits { calls: 10, ..Limits::default() };
    assert_eq!(key(&ran(&machine(), Dialect::Sinumerik, text, limits)), "run-repeated");
    let permitted = limits.permitted(Some(1_000_000));
    assert!(ran(&machine(), Dialect::Sinumerik, text, permitted).finished());
    assert_eq!((permitted.steps, permitted.trace), (Some(1_000_000), 1_000_000));
    assert_eq!(limits.permitted(None), limits);
}

// oracle: hand: nothing changes from one pass to the next, or it swings
#[test]
fn what_comes_back_is_told_where_it_jumps_back() {
    for (text, place) in [
        ("R1=1\nA: R2=R1\nGOTOB A\nM30", "GOTOB A"),
        ("LOOP\nG0 X1\nG0 X2\nENDLOOP", "ENDLOOP"),
        ("R1=5\nWHILE R1>0\nG0 Z=R1\nENDWHILE\nM30", "ENDWHILE"),
        ("REPEAT\nR1=1-R1\nUNTIL R1>2", "UNTIL R1>2"),
        ("A:\nIF R1==3\nR1=0\nENDIF\nR1=R1+1\nGOTOB A", "GOTOB A"),
        ("%_N_MAIN_MPF\nA: UP(R1)\nGOTOB A\nM30\n%_N_UP_SPF\nPROC UP(REAL Q)\nG0 X=Q\nM17", "GOTOB A"),
    ] {
        let (found, recorded) = proved(&machine(), Dialect::Sinumerik, text);
        assert_eq!(found, place, "{text}");
        assert!(recorded < 100, "{recorded}");
    }
    for (text, place) in [("N1 #600=1\nGOTO 1", "GOTO 1"), ("WHILE [1 EQ 1] DO1\n#600=1-#600\nEND1", "END1")] {
        let setup = Setup::calibrated(Dialect::Nct, Plane::G17);
        assert_eq!(proved(&setup, Dialect::Nct, text).0, place);
    }
}

// oracle: hand: the same face gives the same results; a corrected zero offset comes to rest
#[test]
fn measuring_again_and_again_is_told_soon() {
    for text in [format!("{CALL}A: CYCLE978\nGOTOB A"), format!("G54\n{CALL}_KNUM=1\nA: CYCLE978\nG54\nG0 Z5\nGOTOB A")]
    {
        let outcome = go_on(&measuring(), &text);
        assert_eq!(key(&outcome), "run-endless", "{text}: {:?}", outcome.diagnostics);
        assert!(calls(&outcome) < 60, "{}", calls(&outcome));
    }
}

// oracle: hand: the scatter never comes back, the counter goes on
#[test]
fn what_changes_for_ever_is_stopped_by_the_number_of_its_calls() {
    let mut scattering = measuring();
    scattering.probe.repeatability.0 = 0.001;
    for (setup, text) in [
        (&scattering, format!("{CALL}A: CYCLE978\nGOTOB A")),
        (&measuring(), format!("{CALL}A: CYCLE978\nR1=R1+1\nGOTOB A")),
    ] {
        let limits = Limits { calls: 300, ..Limits::default() };
        let outcome = ran(setup, Dialect::Sinumerik, &text, limits);
        assert_eq!(key(&outcome), "run-repeated");
        assert_eq!(calls(&outcome), 300);
        let found = outcome.diagnostics.last().unwrap();
        let span = found.span.unwrap();
        assert!(text[span.start as usize..].starts_with("CYCLE978"), "{span:?}");
    }
}

// oracle: hand: a thousand points, counted, from one place of the program and from two
#[test]
fn a_thousand_points_are_measured() {
    let text = format!("{CALL}WHILE R1<1000\nCYCLE978\nR1=R1+1\nENDWHILE\nFOR R2=1 TO 1000\nCYCLE978\nENDFOR\nM30");
    let outcome = go_on(&measuring(), &text);
    assert_eq!((outcome.stop.as_ref(), calls(&outcome)), (None, 2000));
}

// oracle: hand: programs that end, however often they stand where they stood
#[test]
fn what_ends_is_not_called_endless() {
    for text in [
        "A: G0 X1\nG0 X2\nR1=R1+1\nIF R1<50 GOTOB A\nM30",
        "A: R1=1\nR2=R2+0.1\nIF R2<3 GOTOB A\nM30",
        "A: G0 X1\nG0 X2\nREPEAT A P=90\nM30",
        "%_N_MAIN_MPF\nUP P50\nUP P50\nM30\n%_N_UP_SPF\nA: G0 X1\nG0 X2\nREPEAT A P=3\nM17",
        "FOR R1=1 TO 3\nFOR R2=1 TO 40\nG0 X0\nENDFOR\nENDFOR\nM30",
    ] {
        clean_on(&machine(), text);
    }
    // a program that waits for the clock ends when it is late enough
    let setup = Setup::calibrated(Dialect::Nct, Plane::G17);
    let waiting = "#3001=0\nWHILE [#3001 LT 200] DO1\nEND1\nM30";
    let outcome = ran(&setup, Dialect::Nct, waiting, Limits::default());
    assert_eq!(outcome.stop, None);
}

/// A hole of 40 mm that leans by 0.1 degree, the ball 0.1 mm from its wall: no bound tells a whole circle free there.
fn leaning() -> Setup {
    let mut setup = measuring();
    let mut hole = running::block();
    hole.shape = Shape::Hole { diameter: 40.0, depth: 30.0 };
    hole.errors.tilt = Rpy([0.1, 0.0, 0.0]);
    setup.workpiece.solids = vec![hole];
    setup.position = Mcs([16.9, 0.0, -10.0]);
    setup
}

// oracle: hand: three blocks a pass, and the circle counts as more; without a loop as many as before may be driven
// twice
#[test]
fn circles_close_to_a_wall_count_as_several_blocks_in_a_loop() {
    let circle = "G2 X=IC(0) Y=IC(0) I-16.9 J0 F1000\n";
    let limits = Limits { steps: Some(1_000), ..Limits::default() };
    let again = |text: &str| ran(&leaning(), Dialect::Sinumerik, text, limits);
    let outcome = again(&format!("A: R1=R1+1\n{circle}GOTOB A"));
    assert_eq!(key(&outcome), "run-steps");
    let circles = outcome.trace.entries.len() / 2;
    assert!((20..170).contains(&circles), "{circles}");
    let once = again(&format!("{}M30", circle.repeat(2 * circles)));
    assert_eq!(once.stop, None);
}

// oracle: definition: a run in pieces is the run
#[test]
fn a_run_in_pieces_tells_the_same() {
    let text = format!("{CALL}A: CYCLE978\nGOTOB A");
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let mut session = Session::new(program, &measuring(), Limits::default());
    while !session.advance(1) {}
    let outcome = session.outcome();
    assert_eq!(key(&outcome), "run-endless");
}

// oracle: hand: these would turn for hours; a whole circle of the table passes everything that there is
#[test]
fn what_turns_very_often_is_over_at_once() {
    let setup = measuring();
    let outcome = clean_on(&setup, "G0 Z200\nC=555555555555\nC=-1EX30\nM30");
    assert_eq!(outcome.control.rotary[2].0, -1e30);
    let outcome = go_on(&setup, "G0 Z200\nG2 X0 Y0 I10 J0 TURN=1000000 F100\nM30");
    assert_eq!(key(&outcome), "run-range");
}

// oracle: hand: no count of blocks ends a program that ends by itself, in a loop or without one
#[test]
fn however_long_it_takes_a_program_comes_to_its_end() {
    for (text, value) in [
        ("R1=0\nWHILE R1<60000\nR1=R1+1\nENDWHILE\nM30".to_owned(), 60_000.0),
        ("FOR R1=1 TO 150000\nR2=R2+1\nENDFOR\nR1=R2\nM30".to_owned(), 150_000.0),
        (format!("{}M30", "R1=R1+1\n".repeat(250_000)), 250_000.0),
    ] {
        let outcome = ran(&machine(), Dialect::Sinumerik, &text, Limits::default());
        assert_eq!((outcome.stop.as_ref(), outcome.control.number("R1")), (None, value));
        assert_eq!(outcome.written().get("R1"), Some(&value));
    }
}

// oracle: hand: what nobody watches ends soon in a loop that goes on, and not before the end of what has none
#[test]
fn what_nobody_watches_is_given_up_in_loops_only() {
    let program = read(Dialect::Sinumerik, "G0 X1\nG0 X2\n".repeat(100_000).as_bytes());
    let limits = Limits::unwatched(program.blocks.len());
    assert_eq!(run(&program, &machine(), limits).stop, None);
    let outcome = ran(&machine(), Dialect::Sinumerik, "A: R1=R1+1\nGOTOB A", Limits::unwatched(2));
    assert_eq!(key(&outcome), "run-steps");
}

// oracle: hand: the first steps are recorded, which is told once; the others are driven all the same
#[test]
fn what_is_not_recorded_is_driven() {
    let limits = Limits { own: 5, told: 10, ..Limits::default() };
    let text = "G90\nWHILE R1<100\nR1=R1+1\nG0 X=R1\nENDWHILE\nM30";
    let outcome = ran(&machine(), Dialect::Sinumerik, text, limits);
    assert_eq!((outcome.stop.as_ref(), outcome.trace.entries.len(), outcome.end().0[0]), (None, 11, 100.0));
    let told = outcome.diagnostics.iter().filter(|found| found.message.key == "run-trace-full");
    assert_eq!(told.count(), 1);
    let few = ran(&machine(), Dialect::Sinumerik, text, Limits { own: 10, told: 5, ..limits });
    assert_eq!((few.trace.entries.len(), few.end()), (10, outcome.end()));
    let silent = ran(&machine(), Dialect::Sinumerik, text, limits.unrecorded());
    assert_eq!((silent.diagnostics.len(), silent.trace.entries.len(), silent.end()), (0, 0, outcome.end()));
    assert_eq!(silent.written().get("R1"), Some(&100.0));
}
