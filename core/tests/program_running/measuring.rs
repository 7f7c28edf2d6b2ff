//! Measuring blocks and calls, and what ends them.

use super::running::machine;
use super::{block_setup, go, near};
use probewright_core::catalogue::example::example;
use probewright_core::catalogue::find;
use probewright_core::control::Frame;
use probewright_core::diagnostic::Code;
use probewright_core::dialect::Dialect;
use probewright_core::geometry::Mcs;
use probewright_core::machine::Stop;
use probewright_core::machine::trace::Step;
use probewright_core::run::{Limits, Outcome, run};
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
        .others()
        .filter_map(|entry| match entry.step {
            Step::Message { text, .. } => Some(text.as_str()),
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
    near(outcome.position.0, [0.0, 0.0, 3.0]);
    assert_eq!(outcome.trace.entries.last().unwrap().line, Some(1));
}

#[test]
fn a_surface_is_measured_and_its_frame_corrected() {
    let mut setup = block_setup();
    setup.workpiece.solids[0].at = Mcs([0.5, 0.0, 0.0]);
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
    setup.workpiece.solids[0].at = Mcs([0.5, 0.0, 0.0]);
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

/// The program of a worked call, without some of its values.
fn without(name: &str, variant: i64, left_out: &[&str]) -> String {
    let cycle = find(Dialect::Sinumerik, name).unwrap();
    let variant = cycle.variants.iter().find(|one| one.number == variant).unwrap();
    let values = example(cycle, variant);
    let written = values.iter().filter(|(name, _)| !left_out.contains(&name.as_str()));
    let written: Vec<String> = written.map(|(name, value)| format!("{name}={value}")).collect();
    format!("{}\n{name}\nM30\n", written.join("\n"))
}

/// Names of the parameters that are reported missing.
fn missing(outcome: &Outcome) -> Vec<&'static str> {
    let found = outcome.diagnostics.iter().filter(|one| one.code == Code::Own(1) && one.message.key == "check-missing");
    found.filter_map(|one| one.param.map(|name| name.as_str())).collect()
}

#[test]
fn a_datum_that_is_never_written_counts_as_0_and_the_alarm_of_that_comes() {
    // oracle: manual A:15889 (61346: _SETV[0], _SETV[1] at most 0), A:15890 (61347: _INCA is 0), B:1854 and A:15846
    // (61307: a variant that there is not)
    for (name, variant, left_out, alarm) in [
        ("CYCLE961", 105, "_SETV[0]", 61346),
        ("CYCLE961", 107, "_SETV[1]", 61346),
        ("CYCLE961", 105, "_INCA", 61347),
        ("CYCLE961", 105, "_MVAR", 61307),
    ] {
        let outcome = go(&without(name, variant, &[left_out]));
        assert_eq!(outcome.stop, Some(Stop::Alarm(Code::Alarm(alarm))), "{left_out}");
        assert!(missing(&outcome).contains(&left_out), "{left_out}: {:?}", outcome.diagnostics);
        let written = go(&without(name, variant, &[left_out]).replacen("CYCLE", &format!("{left_out}=0\nCYCLE"), 1));
        assert_eq!(written.stop, outcome.stop, "{left_out}");
        assert!(!missing(&written).contains(&left_out));
    }
    // oracle: hand: the face of the block stands at 0, where _SETVAL points that nobody wrote
    let mut setup = block_setup();
    setup.control.frames.insert(1, Frame::translation([-50.0, 0.0, 0.0]));
    let text = "N10 G54 G17 G90 T9 D1\nN20 M6\nN30 G0 X-20 Y0\nN40 Z-10\n\
        N50 _TSA=6 _FA=4 _MVAR=100 _MA=1 _KNUM=1 _EVNUM=0 _PRNUM=1 _VMS=0 _NMSP=1\nN60 CYCLE978\nM30";
    let outcome = run(&read(Dialect::Sinumerik, text.as_bytes()), &setup, Limits::default());
    assert_eq!((missing(&outcome), &outcome.stop), (vec!["_SETVAL"], &None));
    assert_eq!((outcome.control.number("_OVR[0]"), outcome.alarms()), (0.0, Vec::new()));
    assert!(outcome.control.number("_OVR[16]").abs() < 1e-9);
}

#[test]
fn data_of_a_call_stay_for_the_next_one() {
    // oracle: manual B:1696 (global user data keep their values), hand: the second call measures where the first did,
    // on the other axis, and nothing is missing
    let text = "N10 G54 G17 G90 T9 D1\nN20 M6\nN30 G0 X-70 Y0\nN40 Z-10\n\
        N50 _TSA=6 _FA=4 _MVAR=100 _SETVAL=-50 _MA=1 _KNUM=0 _EVNUM=0 _PRNUM=1 _VMS=0 _NMSP=1\nN60 CYCLE978\n\
        N70 G0 X-70 Y-70\nN80 X0\nN90 _MA=2\nN100 CYCLE978\nM30";
    let outcome = run(&read(Dialect::Sinumerik, text.as_bytes()), &block_setup(), Limits::default());
    assert_eq!((missing(&outcome), &outcome.stop), (Vec::new(), &None), "{:?}", outcome.diagnostics);
    assert_eq!(outcome.control.number("_SETVAL"), -50.0);
    assert!((outcome.control.number("_OVR[6]") + 50.0).abs() < 1e-9);
}
