//! Measuring blocks and calls, and what ends them.

use super::running::machine;
use super::{block_setup, go, near};
use probewright_core::control::Frame;
use probewright_core::diagnostic::Code;
use probewright_core::dialect::Dialect;
use probewright_core::machine::Stop;
use probewright_core::machine::trace::Step;
use probewright_core::run::{Limits, run};
use probewright_core::syntax::read;

#[test]
fn the_test_of_a_probe_runs_as_printed() {
    // oracle: manual B:12790-12856: switched: position in R1 and stop; not switched: operator text
    let text = "N05 DEF INT MTSIGNAL\nN10 DEF INT ME_NR=1\nN30 G17 T9 D1\nN40 G0 G90 Z20 F150\nN50 MEAS=ME_NR G1 Z=-5\n\
        N60 STOPRE\nN70 MTSIGNAL=$AC_MEA[ME_NR]\nN80 IF MTSIGNAL == 0 GOTOF _FEHL1\nN90 R1=$AA_MW[Z]\nN95 M0\nN100 M2\n\
        N110 _FEHL1: MSG (\"Probe not switching!\")\nN120 M0\nN130 M2";
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let outcome = run(&program, &block_setup(), Limits::default());
    assert_eq!(outcome.stop, None);
    assert!((outcome.control.number("R1") - 3.0).abs() < 1e-9);
    let outcome = run(&program, &machine(), Limits::default());
    let texts: Vec<_> = outcome
        .trace
        .entries
        .iter()
        .filter_map(|entry| match &entry.step {
            Step::Message(text) => Some(text.as_str()),
            _ => None,
        })
        .collect();
    assert_eq!(texts, ["Probe not switching!", "M0"]);
}

#[test]
fn a_crash_ends_the_run_where_it_happens() {
    let program = read(Dialect::Sinumerik, b"G0 Z10\nG0 Z-5\nG0 Z50");
    let outcome = run(&program, &block_setup(), Limits::default());
    assert!(matches!(&outcome.stop, Some(Stop::Fault(message)) if message.key == "run-crash"));
    near(outcome.position, [0.0, 0.0, 3.0]);
    assert_eq!(outcome.trace.entries.last().unwrap().line, Some(1));
}

#[test]
fn a_surface_is_measured_and_its_frame_corrected() {
    let mut setup = block_setup();
    setup.workpiece.solids[0].at = [0.5, 0.0, 0.0];
    setup.control.frames.insert(1, Frame::translation([-50.0, 0.0, 0.0]));
    let text = "N10 G54 G17 G90 T9 D1\nN20 M6\nN30 G0 X-20 Y0\nN40 Z-10\n\
        N50 _TSA=6 _FA=4 _MVAR=100 _SETVAL=0 _MA=1 _KNUM=1 _EVNUM=0 _PRNUM=1 _VMS=0 _NMSP=1\nN60 CYCLE978\nN70 G54\n\
        M30";
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let outcome = run(&program, &setup, Limits::default());
    assert_eq!(outcome.stop, None, "{:?}", outcome.diagnostics);
    // oracle: hand: the face lies 0.5 mm further than the frame says
    assert!((outcome.control.number("_OVR[16]") - 0.5).abs() < 1e-9);
    assert!((outcome.control.frames[&1].fine[0] - 0.5).abs() < 1e-9);
    assert_eq!(outcome.control.active, outcome.control.frames[&1]);
    // oracle: manual B:1696: values stay for the next call; a wrong variant is alarm 61307 (B:1854)
    let program = read(Dialect::Sinumerik, text.replace("N70 G54", "N70 _MVAR=77\nCYCLE978").as_bytes());
    let outcome = run(&program, &setup, Limits::default());
    assert_eq!(outcome.stop, Some(Stop::Alarm(Code::Alarm(61307))));
    assert_eq!(outcome.alarms().last(), Some(&Code::Alarm(61307)));
}

#[test]
fn a_cycle_without_probe_is_refused() {
    let call = "_MVAR=100 _SETVAL=0 _MA=1 _KNUM=0\nCYCLE978";
    // oracle: manual B:4147-4152
    let stop = |start: &str| go(&format!("{start}\n{call}")).stop;
    assert_eq!(stop("D0"), Some(Stop::Alarm(Code::Alarm(61311))));
    assert_eq!(stop("$TC_DP1[9,1]=500"), Some(Stop::Alarm(Code::Alarm(61309))));
}

#[test]
fn a_face_is_milled_and_measured_on_a_turning_machine() {
    // oracle: manual B:4148-4152; hand: the face lies 0.5 mm further in X than the call says, which names no diameters,
    // and the spindle that turns the part before leaves the probe as it is
    let mut setup = block_setup();
    setup.workpiece.solids[0].at = [0.5, 0.0, 0.0];
    setup.control.set("SD42950", 2.0);
    setup.probe.skew = [0.0, 0.3];
    for (name, value) in [("$TC_DP1[9,1]", 580.0), ("$TC_DP2[9,1]", 7.0), ("$TC_DP3[9,1]", 0.0), ("$TC_DP5[9,1]", 50.0)]
    {
        assert!(setup.control.set_variable(name, value));
    }
    let text = "N10 G500 G17 G90 DIAMON T9 D1\nN20 SPOS=90\nN30 G0 X-140 Y0\nN40 Z-10\n\
        N50 _TSA=6 _FA=4 _MVAR=0 _SETVAL=-50 _MA=1 _KNUM=0 _EVNUM=0 _PRNUM=1 _VMS=0 _NMSP=1\nN60 CYCLE978\nM30";
    let program = read(Dialect::Sinumerik, text.as_bytes());
    let outcome = run(&program, &setup, Limits::default());
    assert_eq!(outcome.stop, None, "{:?}", outcome.diagnostics);
    assert!((outcome.control.number("_OVR[16]") - 0.5).abs() < 1e-9);
}
