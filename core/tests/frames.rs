//! Basic, system and settable frames of a program: what a correction writes, and from when it counts.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use probewright_core::catalogue::find;
use probewright_core::check::check;
use probewright_core::control::{Edge, Frame, Plane, Tool};
use probewright_core::diagnostic::Code;
use probewright_core::dialect::Dialect;
use probewright_core::geometry::Degrees;
use probewright_core::machine::trace::Step;
use probewright_core::machine::{Setup, Stop};
use probewright_core::run::{Limits, Outcome, run};
use probewright_core::syntax::read;

/// How far the measured face stands beside its setpoint position, mm.
const SHIFT: f64 = 0.3;

/// A machine with two channel basic frames, a global one and G54; T5 a mill.
fn machine() -> Setup {
    let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    let control = &mut setup.control;
    let along = |x: f64| Frame::translation([x, 0.0, 0.0]);
    control.stored.channel.insert(0, along(10.0));
    control.stored.channel.insert(1, along(20.0));
    control.stored.global.insert(0, along(40.0));
    control.frames.insert(1, along(80.0));
    let edge = Edge { kind: 120, length: [70.0, 0.0, 0.0], radius: 5.0, ..Edge::default() };
    let edges = [(1, edge.clone()), (2, edge)].into();
    let name = "MILL".into();
    control.tools.insert(5, Tool { name, edges });
    control.activate(0);
    setup
}

/// Runs a program with one call of CYCLE978 on the face X = 0, before which the probe stands.
fn measured(mut setup: Setup, before: &str, call: &str, after: &str) -> Outcome {
    let cycle = find(Dialect::Sinumerik, "CYCLE978").unwrap();
    let typed = [("_MVAR", "100"), ("_SETVAL", "0"), ("_MA", "1"), ("_KNUM", "0")]
        .map(|(name, value)| (name.to_owned(), value.to_owned()));
    let inputs = check(cycle, &typed.into(), &setup.control).inputs.unwrap();
    let proposal = (cycle.work().unwrap().propose)(&inputs, &setup.control);
    setup.workpiece = proposal.workpiece;
    setup.workpiece.solids[0].errors.shift[0] = SHIFT;
    setup.position = setup.control.to_machine(proposal.start);
    let text = format!("{before}\n_SETVAL=0 _MA=1 {call}\nCYCLE978\n{after}\nM30\n");
    run(&read(Dialect::Sinumerik, text.as_bytes()), &setup, Limits::default())
}

fn clean(outcome: Outcome) -> Outcome {
    assert_eq!((&outcome.stop, &outcome.diagnostics[..]), (&None, &[][..]));
    outcome
}

fn near(found: f64, expected: f64, what: &str) {
    assert!((found - expected).abs() < 1e-9, "{what}: {found} is not {expected}");
}

/// How far the WCS has moved after the call, and after the G function behind it.
fn moved(setup: Setup, code: i64, activation: &str) -> ([f64; 2], Outcome) {
    let origin = |n: u8| format!("R{n}=$AA_IM[X]-$AA_IW[X]");
    let after = format!("{}\n{activation}\n{}", origin(2), origin(3));
    let call = format!("_MVAR=100 _KNUM={code}");
    let outcome = clean(measured(setup, &origin(1), &call, &after));
    let at = |name: &str| outcome.control.number(name);
    ([at("R2") - at("R1"), at("R3") - at("R1")], outcome)
}

fn active(settable: usize) -> Setup {
    let mut setup = machine();
    setup.control.activate(settable);
    setup
}

// oracle: manual B:1965: active at once with 9999 only, otherwise when G500, G54.. is programmed
#[test]
fn a_corrected_frame_counts_from_the_next_activation() {
    for (code, changed) in [
        (1, "$P_UIFR[1,X,FI]"),
        (1011, "$P_CHBFR[0,X,FI]"),
        (1012, "$P_CHBFR[1,X,FI]"),
        (1051, "$P_NCBFR[0,X,FI]"),
        (2000, "$P_SETFR[X,TR]"),
        (9999, "$P_UIFR[1,X,FI]"),
    ] {
        let ([at_once, later], outcome) = moved(active(1), code, "G54");
        near(at_once, if code == 9999 { SHIFT } else { 0.0 }, changed);
        near(later, SHIFT, changed);
        let names: Vec<_> = outcome.changes().into_iter().map(|change| change.name).collect();
        assert_eq!(names, [changed], "{code}");
    }
}

// oracle: manual B:1938-1944, B:1960-1963
#[test]
fn without_a_settable_frame_the_last_basic_frame_of_the_mask_is_corrected() {
    for (mask, changed) in
        [(None, "$P_CHBFR[1,X,FI]"), (Some(3.0), "$P_CHBFR[1,X,FI]"), (Some(1.0), "$P_CHBFR[0,X,FI]")]
    {
        for (code, at_once) in [(9999, SHIFT), (1000, 0.0)] {
            let mut setup = active(0);
            if let Some(mask) = mask {
                setup.control.set("$P_CHBFRMASK", mask);
            }
            let ([behind, later], outcome) = moved(setup, code, "G500");
            near(behind, at_once, changed);
            near(later, SHIFT, changed);
            let names: Vec<_> = outcome.changes().into_iter().map(|change| change.name).collect();
            assert_eq!(names, [changed], "{code} {mask:?}");
        }
    }
}

// oracle: manual A:15931 (no channel basic frame for G500)
#[test]
fn no_basic_frame_is_an_alarm() {
    let outcome = measured(active(0), "$P_CHBFRMASK=0", "_MVAR=100 _KNUM=1000", "");
    assert_eq!(outcome.stop, Some(Stop::Alarm(Code::Alarm(61412))));
}

// oracle: hand, with B:1965: stored frames wait for G500 or G54, frames in effect count at once
#[test]
fn stored_frames_wait_and_active_ones_count_at_once() {
    let text = "G0 X0\nR1=$AA_IM[X]\n$P_CHBFR[0]=CTRANS(X,11)\n$P_NCBFR[0,X,TR]=42\n$P_SETFR=CTRANS(X,100)\nG0 X0\n\
        R2=$AA_IM[X]\nG500\nG0 X0\nR3=$AA_IM[X]\n$P_CHBFRAME[0]=CTRANS(X,0)\n$P_NCBFRAME[0,X,TR]=0\n\
        $P_SETFRAME[X,TR]=0\n\
        G0 X0\nR4=$AA_IM[X]\nR5=$P_CHBFRMASK\n$P_NCBFRMASK=0\n$P_CHBFRMASK=1\nG500\nG0 X0\nR6=$AA_IM[X]\nM30\n";
    let outcome = clean(run(&read(Dialect::Sinumerik, text.as_bytes()), &machine(), Limits::default()));
    for (name, expected) in [("R1", 70.0), ("R2", 70.0), ("R3", 173.0), ("R4", 20.0), ("R5", 3.0), ("R6", 111.0)] {
        near(outcome.control.number(name), expected, name);
    }
}

// oracle: manual B:2062-2102, B:2138-2146 (T and D of the environment; the length of the measuring axis in its plane)
#[test]
fn a_stored_tool_environment_is_corrected() {
    let before = "T5 M6\nD2\nG18\nTOOLENV(\"WZUMG2\")\nG17\nR9=TOOLENV(\"WZUMG1\")\nT9 M6";
    let values = "_MVAR=0 _TUL=1 _TLL=-1 _TSA=2 _TDIF=1.9 _TMV=0.1 _TZL=0.01";
    for (code, name, length) in [
        ("_TNUM=0 _KNUM=2100000 _TENV=\"WZUMG1\"", "$TC_DP12[5,2]", true),
        ("_TNUM=0 _KNUM=2000001 _TENV=\"WZUMG1\"", "$TC_DP14[5,1]", true), // X is the abscissa of G17: L3
        ("_TNUM=0 _KNUM=2000001 _TENV=\"WZUMG2\"", "$TC_DP13[5,1]", true), // X is the ordinate of G18: L2
        ("_TNUM=0 _KNUM=2002000 _TENV=\"WZUMG2\"", "$TC_DP15[5,2]", false),
    ] {
        let outcome = clean(measured(active(0), before, &format!("{values} {code}"), ""));
        let changes = outcome.changes();
        let [change] = &changes[..] else { panic!("{code}: {changes:?}") };
        assert_eq!(change.name, name, "{code}");
        near(change.after.abs(), SHIFT, name);
        assert_eq!(change.after < 0.0, length, "{code}");
        assert_eq!(outcome.control.number("R9"), 0.0);
    }
    let outcome = measured(active(0), before, &format!("{values} _KNUM=2100000 _TENV=\"NONE\""), "");
    assert_eq!(outcome.stop, Some(Stop::Alarm(Code::Alarm(61405))));
}

#[test]
fn a_rotary_axis_turns_the_part_and_its_offset_counts_when_the_frame_is_called() {
    // oracle: manual B:7490-7494 (the changed translation of C counts with the next G54), hand
    let program = "G54\n\
        G0 C30\n\
        $P_UIFR[1,C,TR]=$P_UIFR[1,C,TR]+2\n\
        C=IC(5)\n\
        G54 C0\n\
        G91 C-1\n\
        M30\n";
    let program = read(Dialect::Sinumerik, program.as_bytes());
    let outcome = run(&program, &machine(), Limits::default());
    assert_eq!((&outcome.stop, outcome.diagnostics.as_slice()), (&None, &[][..]));
    let turned = outcome.trace.entries.iter().filter_map(|entry| match entry.step {
        Step::Table { axis, to, .. } => Some((axis, to.0)),
        _ => None,
    });
    let wanted = [(2, 30.0), (2, 35.0), (2, 2.0), (2, 1.0)];
    assert_eq!(turned.collect::<Vec<_>>(), wanted);
    assert_eq!(outcome.control.rotary, [0.0, 0.0, 1.0].map(Degrees));
    let changes = outcome.changes();
    assert_eq!(changes.len(), 1, "{changes:?}");
    assert_eq!((changes[0].name.as_str(), changes[0].after), ("$P_UIFR[1,C,TR]", 2.0));
}
