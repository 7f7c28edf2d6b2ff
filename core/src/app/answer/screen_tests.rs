//! The measuring result screens of all measurements.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use crate::app::{FormRequest, ResultScreen, RunView, ScreenUntil, form};
use crate::catalogue::{CYCLES, example::example};
use crate::control::Plane;
use crate::dialect::Dialect;
use crate::entry::{Cycle, Variant};
use crate::geometry::Mcs;
use crate::machine::Setup;
use crate::run::{Limits, run};
use crate::syntax::read;
use crate::workpiece::{Shape, Solid};

/// The screen of a worked measurement with these switches, its part 0.06 mm too large and 0.1 mm off in X.
fn screen(cycle: &'static Cycle, variant: &Variant, bits: [i32; 3]) -> Option<ResultScreen> {
    let data = serde_json::json!({ "_CHBIT[10]": bits[0], "_CHBIT[11]": bits[1], "_CHBIT[18]": bits[2] });
    let asked = serde_json::json!({
        "control": cycle.dialect, "cycle": cycle.name, "values": example(cycle, variant), "predict": true,
        "setup": { "own": { "data": data } }, "errors": { "part": { "size": 0.06, "dx": 0.1 } },
    });
    let outcome = form(serde_json::from_value::<FormRequest>(asked).unwrap()).unwrap().outcome?;
    outcome.answer?.screen
}

// oracle: manual B:12564-12578 (when it is shown, and how long), B:12586-12616 (what is on it), B:12627-12644 (the
// difference is actual value minus setpoint)
#[test]
fn each_measurement_has_its_screen() {
    let mut titles = std::collections::BTreeSet::new();
    let cycles = CYCLES.iter().filter(|cycle| cycle.dialect == Dialect::Sinumerik && cycle.purpose.probe.measures());
    let mut compared = 0;
    for (cycle, variant) in cycles.flat_map(|cycle| cycle.variants.iter().map(move |one| (*cycle, one))) {
        assert_eq!(screen(cycle, variant, [0, 1, 0]), None, "{}", cycle.name);
        let Some(shown) = screen(cycle, variant, [1, 1, 0]) else { continue }; // an alarm stopped it before
        assert_eq!((shown.until, shown.cycle, shown.variant), (ScreenUntil::Start, cycle.name, variant.number));
        assert!(!shown.rows.is_empty() && !shown.values.is_empty(), "{} {}", cycle.name, variant.number);
        titles.insert(shown.title.key.to_string());
        let centred = |key: &str| key.starts_with("result-actual-size") || key.starts_with("result-actual-centre");
        for row in shown.rows.iter().filter(|row| centred(&row.label.key)) {
            let [set, actual, difference] = [row.set, row.actual, row.difference].map(Option::unwrap);
            assert!((actual - set - difference).abs() < 1e-9, "{} {} {row:?}", cycle.name, variant.number);
            compared += 1;
        }
    }
    assert_eq!(titles.len(), 4, "{titles:?}");
    assert!(compared > 20, "{compared}");
}

// oracle: manual B:12569-12578
#[test]
fn it_goes_with_the_cycle_or_stays() {
    let cycle = CYCLES.iter().copied().find(|cycle| cycle.purpose.probe.measures()).unwrap();
    let until = |bits| screen(cycle, &cycle.variants[0], bits).map(|shown| shown.until);
    assert_eq!([until([1, 0, 0]), until([1, 0, 1])], [Some(ScreenUntil::End), Some(ScreenUntil::Next)]);
}

/// What a program for a hole does, with these lines before and behind its measuring call.
fn around(before: &str, behind: &str) -> RunView {
    let text = format!(
        "G17 G54 G0 X0 Y0 Z-10\n_MVAR=1 _SETVAL=40 _PRNUM=1 _FA=2 _TSA=1 _KNUM=0 _TNUM=1 _VMS=0 _NMSP=1 _EVNUM=0\n\
         {before}CYCLE977\n{behind}M30\n"
    );
    let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    setup.workpiece.solids.push(Solid::new(Shape::Hole { diameter: 40.02, depth: 30.0 }, Mcs::default()));
    let outcome = run(&read(Dialect::Sinumerik, text.as_bytes()), &setup, Limits::default());
    RunView::new(setup, outcome, text.as_bytes())
}

// oracle: self: what a program does behind a screen is not on it yet
#[test]
fn a_screen_shows_what_stood_there_then() {
    let writes: String = (0..32).map(|at| format!("_OVR[{at}]=77.5\n")).collect();
    for before in ["_CHBIT[10]=1\n", "_CHBIT[10]=1 _CHBIT[18]=1\n"] {
        let screen = |behind: &str| around(before, behind).answers[0].answer.screen.clone().unwrap();
        assert_eq!(screen(&writes), screen(""));
    }
    let asked = |behind: &str| around("", behind).answers[0].answer.screen.clone().unwrap();
    assert_eq!(asked(&format!("CYCLE102\n{writes}")).rows, asked("CYCLE102\n").rows);
    assert_ne!(asked(&format!("{writes}CYCLE102\n")).rows, asked("CYCLE102\n").rows);
}

// oracle: manual B:2386, B:15278-15279 (CYCLE102 shows the result, CYCLE103 asks for values), B:12627-12644 (decimals)
#[test]
fn older_programs_ask_for_the_screen_themselves() {
    let keys = |view: &RunView| view.diagnostics.iter().map(|one| one.message.key.to_string()).collect::<Vec<_>>();
    assert_eq!(around("", "").answers[0].answer.screen, None);
    let view = around("CYCLE103\n_DIGIT=4\n", "G0 Z100\nCYCLE102\n");
    let shown = view.answers[0].answer.screen.as_ref().unwrap();
    assert_eq!((shown.until, shown.digits), (ScreenUntil::End, 6));
    assert!(shown.at > view.answers[0].to, "it is shown where the program asks for it");
    assert!(keys(&view).contains(&"run-dialogue".to_owned()), "{:?}", keys(&view));
    assert!(view.passed_over.is_empty(), "{:?}", view.passed_over);
    assert!(keys(&around("CYCLE102\n", "")).contains(&"run-screen-empty".to_owned()));
}

// oracle: hand: M0 waits with the text that stands on the screen, M1 and a text alone do not
#[test]
fn a_program_waits_at_m0() {
    let view = around("MSG(\"CLEAN\")\nM1\nM0\nMSG(\"\")\nM0\n", "");
    assert_eq!(view.waits.iter().map(|one| one.text.as_str()).collect::<Vec<_>>(), ["CLEAN", "M0"]);
}
