//! Series of a hole on the machine of the manual's examples.
#![allow(clippy::unwrap_used)]

use super::*;
use crate::control::Plane;
use crate::dialect::Dialect;
use crate::geometry::Mcs;
use crate::machine::Setup;
use crate::machine::series::{Per, Series, Vary};
use crate::syntax::{Program, read};
use crate::workpiece::{Shape, Solid};
use std::collections::BTreeMap;
use std::rc::Rc;

/// A hole of 50 mm at the zero point, measured with these tolerances; T20 D1 has cut it.
fn hole(tolerances: &str, vary: Vec<Vary>, runs: u32, mode: Mode) -> (Rc<Program>, Setup) {
    let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    setup.workpiece.solids.push(Solid::new(Shape::Hole { diameter: 50.0, depth: 30.0 }, Mcs([0.0; 3])));
    setup.control.edge_made(20, 1).kind = 120;
    setup.series = Series { runs, seed: 3, mode, vary };
    let text = format!(
        "G17 G54 G90 T9 D1 M6\nG0 X0 Y0\nZ-10\n_CHBIT[4]=1 _EVNUM=1\n_TUL=0.03 _TLL=-0.03 _TDIF=0.06 _TSA=1 _FA=2 \
         {tolerances}\n_MVAR=1 _SETVAL=50 _TNUM=20 _KNUM=2001 _PRNUM=1\nCYCLE977\nM30\n"
    );
    (Rc::new(read(Dialect::Sinumerik, text.as_bytes())), setup)
}

fn size(sigma: f64, mean: f64) -> Vary {
    Vary {
        what: "workpiece[0].errors.size".into(),
        shape: crate::machine::series::Shape::Normal,
        sigma,
        half: 0.0,
        mean,
        drift: 0.0,
        per: Per::Part,
        values: Vec::new(),
        follows: BTreeMap::new(),
    }
}

fn ran((program, setup): &(Rc<Program>, Setup)) -> SeriesView {
    series(&Prepared { setup: setup.clone(), program: Rc::clone(program), main: None }, &mut |_| {})
}

fn figures(group: &str, part: &str) -> serde_json::Value {
    let all: serde_json::Value = serde_json::from_str(include_str!("../../../../tests/data/uncertainty.json")).unwrap();
    all[group][part].clone()
}

const WIDE: &str = "_TMV=0.02 _TZL=0.01 _K=1";

// oracle: peer: tests/data/uncertainty.json: a width of two touches is uncertain by σ·√(2/n)
#[test]
fn a_diameter_spreads_as_its_touches_do() {
    let given = figures("two_walls", "given");
    let mut hole = hole(WIDE, Vec::new(), 800, Mode::Independent);
    hole.1.probe.repeatability.0 = given["sigma"].as_f64().unwrap();
    let view = ran(&hole);
    let spread = view.calls[0].measured[0].spread;
    let single = figures("two_walls", "expect")["u_width"].as_f64().unwrap() * given["n"].as_f64().unwrap().sqrt();
    assert!((spread.deviation - single).abs() < 4.0 * spread.deviation_error, "{spread:?} {single}");
    assert_eq!((view.finished, spread.count), (800, 800));
    assert_eq!(ran(&hole), view, "the same seed gives the same results");
}

// oracle: hand
#[test]
fn nothing_varies_nothing_spreads() {
    let view = ran(&hole(WIDE, vec![size(0.0, 0.004)], 20, Mode::Independent));
    let spread = view.calls[0].measured[0].spread;
    assert_eq!((spread.deviation, spread.min), (0.0, spread.max));
    assert!((spread.mean - 50.004).abs() < 1e-9, "{spread:?}");
}

// oracle: definition: what is common to all parts moves the mean, and does not spread
#[test]
fn what_is_drawn_once_does_not_spread() {
    let view = ran(&hole(WIDE, vec![Vary { per: Per::Series, ..size(0.008, 0.0) }], 20, Mode::Independent));
    let spread = view.calls[0].measured[0].spread;
    assert_eq!(spread.deviation, 0.0);
    assert!((spread.mean - 50.0).abs() > 1e-4, "{spread:?}");
}

// oracle: peer: tests/data/uncertainty.json: chances of each branch for a first part, `_K` = 1
#[test]
fn verdicts_come_as_often_as_calculated() {
    let (given, expect) = (figures("branches_K1", "given"), figures("branches_K1", "expect"));
    let number = |name: &str| given[name].as_f64().unwrap();
    let mut hole = hole(WIDE, vec![size(number("s_process"), number("mu"))], 1500, Mode::Independent);
    hole.1.probe.repeatability.0 = number("u") / 2.0f64.sqrt();
    let call = ran(&hole).calls.remove(0);
    for (verdict, name) in [(Verdict::Scrap, "oversize"), (Verdict::Rework, "undersize")] {
        let found = call.verdicts.iter().find(|one| one.verdict == verdict).map_or(0.0, |one| one.share);
        let share = expect[name].as_f64().unwrap();
        let error = crate::series::spread::share_error(share, 1500);
        assert!((found - share).abs() < 4.0 * error, "{name}: {found} instead of {share} ± {error}");
    }
    let corrected = call.corrected.iter().map(|one| one.spread.count).max().unwrap() as f64 / 1500.0;
    let share = ["whole", "mean_applied"].iter().map(|name| expect[name].as_f64().unwrap()).sum::<f64>();
    let error = crate::series::spread::share_error(share, 1500);
    assert!((corrected - share).abs() < 4.0 * error, "{corrected} instead of {share} ± {error}");
}

// oracle: peer: tests/data/uncertainty.json: a stable process that is corrected whole after each part scatters more
#[test]
fn a_correction_after_each_part_makes_them_worse() {
    let (given, expect) = (figures("over_correction", "given"), figures("over_correction", "expect"));
    let number = |name: &str| given[name].as_f64().unwrap();
    let follows = BTreeMap::from([("$TC_DP15[20,1]".to_owned(), -2.0)]);
    let varied = Vary { follows, ..size(number("s_process"), 0.0) };
    let tolerances = "_TUL=0.3 _TLL=-0.3 _TDIF=0.6 _TMV=0.000001 _TZL=0 _K=1";
    let mut hole = hole(tolerances, vec![varied], 700, Mode::Production);
    hole.1.probe.repeatability.0 = number("u") / 2.0f64.sqrt();
    let view = ran(&hole);
    let spread = view.calls[0].measured[0].spread;
    // what is measured scatters by the parts and by the measurement
    let parts = (spread.deviation.powi(2) - number("u").powi(2)).sqrt();
    let wanted = expect["each_part_whole"].as_f64().unwrap();
    assert!((parts - wanted).abs() < 5.0 * spread.deviation_error, "{parts} {wanted} {spread:?}");
    assert!(!view.calls[0].uncorrected.is_empty());
}

// oracle: hand: a part that grows by 0.002 mm each leaves the tolerance of 0.03 mm after 15 without a correction only
#[test]
fn wear_is_held_by_the_correction() {
    let follows = BTreeMap::from([("$TC_DP15[20,1]".to_owned(), -2.0)]);
    let varied = Vary { follows, drift: 0.002, ..size(0.0, 0.0) };
    let view = ran(&hole("_TMV=0.02 _TZL=0.003 _K=1", vec![varied], 60, Mode::Production));
    let call = &view.calls[0];
    let within = |shares: &[SeriesShare]| {
        shares.iter().filter(|one| one.verdict == Verdict::Within).map(|one| one.count).sum::<usize>()
    };
    assert_eq!((within(&call.verdicts), within(&call.uncorrected)), (60, 16), "{:?}", call.verdicts);
}

// oracle: hand
#[test]
fn a_share_has_no_more_digits_than_are_certain() {
    let words = crate::words::Words::english();
    for (count, runs, told) in [
        (1, 1, "1 (100 %; at least 5 % with 95 % confidence)"), // 1 − 0.95
        (30, 100, "30 (30 ± 5 %)"),                             // √(0.3·0.7/100) = 4.6 %
        (9500, 10_000, "9500 (95 ± 0.2 %)"),                    // 0.22 %
        (10_000, 10_000, "10000 (100 %; at least 99.97 % with 95 % confidence)"), // 3/10,000
    ] {
        let share = f64::from(count) / f64::from(runs);
        let message = share_told(count as usize, share, crate::series::spread::share_doubt(share, runs as usize));
        let text =
            words.text(&message).replace(['\u{a0}', ','], " ").replace("9 500", "9500").replace("10 000", "10000");
        assert_eq!(text, told);
    }
}

// oracle: hand: each of the 1001 calls is counted, and the first 1000 are listed
#[test]
fn a_series_tells_that_it_lists_the_first_calls_only() {
    let (program, mut setup) = hole(WIDE, Vec::new(), 1, Mode::Independent);
    let text = String::from_utf8_lossy(&program.source).replace("CYCLE977", "FOR R1=1 TO 1001\nCYCLE977\nENDFOR");
    let view = ran(&(Rc::new(read(Dialect::Sinumerik, text.as_bytes())), setup.clone()));
    let more = view.more.unwrap();
    let number = |name| more.args.iter().find(|(known, _)| *known == name).map(|(_, value)| value.clone());
    assert_eq!((view.calls.len(), number("count")), (1000, Some(crate::message::Arg::Number(1001.0))), "{more:?}");
    setup.series.runs = 1;
    assert_eq!(ran(&(program, setup)).more, None);
}

// oracle: hand
#[test]
fn a_program_without_end_is_run_once() {
    let (_, setup) = hole(WIDE, Vec::new(), 1000, Mode::Independent);
    let program = Rc::new(read(Dialect::Sinumerik, b"N1 R1=R1+1\nGOTOB N1\nM30\n"));
    let view = ran(&(program, setup));
    assert!(view.runs <= 2 && view.finished == 0 && view.alarms.len() == 1, "{view:?}");
}

// oracle: hand
#[test]
fn the_table_has_a_line_for_each_run() {
    let table = series_csv(&ran(&hole(WIDE, vec![size(0.0, 0.004)], 3, Mode::Independent)));
    let lines: Vec<&str> = table.lines().collect();
    assert_eq!(lines.len(), 4);
    assert!(lines[0].starts_with("run,\"7 CYCLE977 _OVR[4] mm\""), "{}", lines[0]);
    assert!(lines[3].starts_with("3,50.00"), "{}", lines[3]);
}

// oracle: manual B:1265-1284: `_TZL` 40 µm; the rows of weight 3 that a misprint leaves alone; with weight 1 each
// difference above it is corrected whole (B:1247: the mean value is then the difference itself)
#[test]
fn the_example_is_the_table_of_the_manual() {
    let start = series_start(example_asked()).unwrap();
    let view = series_of(
        SeriesRequest { text: start.example.text.as_str().into(), setup: None, example: Some(true), ..example_asked() },
        &mut |_| {},
    )
    .unwrap();
    assert_eq!((view.runs, view.finished), (10, 10), "{:?}", view.alarms);
    let memory = |call: usize| &view.calls[call].memories[0];
    let (third, first) = (memory(0), memory(1));
    assert_eq!((third.name.as_str(), first.name.as_str()), ("_MV[0]", "_MV[1]"));
    // a correction empties the memory (B:1262-1263)
    let printed = [(0, 10.0), (1, 23.3), (2, 35.5), (3, 30.3), (6, 0.0), (7, 10.0), (8, 30.0), (9, 0.0)];
    for (run, value) in printed {
        assert!((third.course[run] * 1000.0 - value).abs() < 0.1, "{run}: {}", third.course[run]);
    }
    let parts = |call: usize| -> Vec<usize> {
        let course = &view.calls[call].corrected[0].course;
        (1..=course.len()).filter(|run| course[run - 1] != 0.0).collect()
    };
    assert_eq!((parts(0), parts(1)), (vec![7, 10], vec![2, 3, 6, 7, 9, 10]));
    assert!((view.calls[0].measured[0].course[2].unwrap() - 50.06).abs() < 1e-6);
}

// oracle: self: the same parts in inch, on a control of millimetres: its memory in the unit of the call
#[test]
fn a_memory_is_told_in_the_unit_of_the_call() {
    let [metric, inch] = [("G71", 1.0), ("G70", 25.4)].map(|(units, factor)| {
        let lengths = [("_TUL", 0.03), ("_TLL", -0.03), ("_SETVAL", 50.0)];
        let given: String = lengths.map(|(name, length)| format!("{name}={} ", length / factor)).concat();
        let text = format!(
            "G17 G54 G90 T9 D1 M6\nG0 X0 Y0\nZ-10\n_CHBIT[4]=1 _EVNUM=1 _PRNUM=1 _KNUM=2001 _TNUM=20 _TDIF=0.06 _TSA=1 \
             _FA=2 _TMV=0.02 _TZL=0.01 _K=3\n{units} {given}_MVAR=1\nCYCLE977\nM30\n"
        );
        let (_, setup) = hole(WIDE, vec![size(0.0, 0.006)], 3, Mode::Production);
        ran(&(Rc::new(read(Dialect::Sinumerik, text.as_bytes())), setup)).calls[0].memories[0].clone()
    });
    assert_eq!((metric.unit, inch.unit), ("mm", "inch"));
    assert!(metric.course[0] > 1e-4, "{metric:?}");
    for (metric, inch) in metric.course.iter().zip(&inch.course) {
        assert!((metric - 25.4 * inch).abs() < 1e-9, "{metric} {inch}");
    }
}

fn example_asked() -> SeriesRequest {
    let text = "".into();
    let (setup, program, with, series, example) = (None, None, None, None, None);
    SeriesRequest { control: Dialect::Sinumerik, text, setup, program, with, series, example }
}

/// What is offered for a program on its machine.
fn start((program, setup): &(Rc<Program>, Setup)) -> (Vec<SeriesFollow>, Vec<SeriesPreset>) {
    offered::offered(&Prepared { setup: setup.clone(), program: Rc::clone(program), main: None })
}

// oracle: hand (a hole gets smaller by twice what the radius of its cutter is taken larger), closed loop: with the
// correction that is offered a hole that is made too large comes right at the next part
#[test]
fn a_correction_of_the_program_is_offered_and_closes_the_loop() {
    let mut made = hole("_TMV=0.02 _TZL=0.001 _K=1", Vec::new(), 6, Mode::Production);
    let (follows, presets) = start(&made);
    let of_size: Vec<_> = follows.iter().filter(|one| one.what == "workpiece[0].errors.size").collect();
    assert_eq!(of_size.len(), 1, "{follows:?}");
    assert_eq!((of_size[0].variable.as_str(), of_size[0].factor), ("$TC_DP15[20,1]", -2.0));
    assert_eq!(of_size[0].part, "R");
    let wear = presets.iter().find(|one| one.of.is_some()).unwrap();
    assert!(wear.vary.drift < 0.0, "a worn cutter makes a hole smaller: {wear:?}");
    made.1.series.vary = vec![Vary { mean: 0.02, ..wear.vary.clone() }];
    let sizes = ran(&made).calls[0].measured[0].course.clone();
    assert!((sizes[0].unwrap() - 50.02).abs() < 1e-6 && (sizes[1].unwrap() - 50.0).abs() < 0.002, "{sizes:?}");
    made.1.series.vary[0].follows.clear();
    let sizes = ran(&made).calls[0].measured[0].course.clone();
    assert!((sizes[5].unwrap() - 50.015).abs() < 1e-6, "without it nothing comes back: {sizes:?}");
}

// oracle: hand: steel of 50 mm grows by 50·11.5 µm/m·K
#[test]
fn a_part_that_gets_warm_grows() {
    let mut made = hole(WIDE, Vec::new(), 3, Mode::Independent);
    let (_, presets) = start(&made);
    let warm = presets.iter().find(|one| one.vary.what == draw::WARMTH).unwrap().vary.clone();
    made.1.series.vary = vec![Vary { drift: 10.0, ..warm }];
    let sizes = ran(&made).calls[0].measured[0].course.clone();
    for (part, size) in sizes.iter().enumerate() {
        let expected = 50.0 * (1.0 + 11.5e-6 * 10.0 * part as f64);
        assert!((size.unwrap() - expected).abs() < 1e-6, "{sizes:?}");
    }
}

// oracle: hand: what is offered can be set as it is
#[test]
fn all_that_is_offered_is_known_to_the_machine() {
    let mut made = hole(WIDE, Vec::new(), 2, Mode::Production);
    let (follows, presets) = start(&made);
    let follow = |one: SeriesFollow| Vary { follows: [(one.variable, one.factor)].into(), ..size(0.0, 0.0) };
    made.1.series.vary = presets.into_iter().map(|one| one.vary).chain(follows.into_iter().map(follow)).collect();
    assert!(made.1.series.vary.len() >= 2);
    draw::known(&made.1).unwrap();
}

// oracle: manual B:1346-1360, hand: the tolerance is that of the drawing; a safe area, or a dimension difference that
// is narrower than the tolerance, says nothing about the part
#[test]
fn only_a_tolerance_has_a_capability() {
    let varied = || vec![size(0.004, 0.0)];
    let (_, mut setup) = hole(WIDE, varied(), 100, Mode::Independent);
    let text = "G17 G54 G90 T9 D1 M6\nG0 X0 Y0\nZ-10\n_TSA=1 _FA=2 _MVAR=101 _SETVAL=50 _KNUM=0 _PRNUM=1\nCYCLE977\n\
        M30\n";
    let view = ran(&(Rc::new(read(Dialect::Sinumerik, text.as_bytes())), setup.clone()));
    assert!(view.calls[0].measured.iter().all(|figure| figure.limits.is_none() && figure.capability.is_none()));
    assert_eq!(view.calls[0].verdicts[0].words.key, "answer-within-area");
    let limits = |tolerances: &str| {
        let (program, _) = hole(tolerances, Vec::new(), 0, Mode::Independent);
        setup.series = Series { runs: 100, seed: 3, mode: Mode::Independent, vary: varied() };
        ran(&(program, setup.clone())).calls[0].measured[0].limits
    };
    let mut limits = limits;
    assert_eq!(limits(WIDE), Some([-0.03, 0.03]));
    assert_eq!(limits(&format!("{WIDE} _TDIF=0.02")), Some([-0.03, 0.03]));
}

// oracle: hand: a call that only some runs come to has the values of those runs, and the one behind it keeps its own
#[test]
fn a_call_that_is_left_out_moves_no_other() {
    let (_, setup) = hole(WIDE, vec![size(0.02, 0.0)], 60, Mode::Production);
    let call = |set: u32| format!("_MVAR=1 _SETVAL={set} _TNUM=20 _KNUM=2001 _PRNUM=1\nCYCLE977\n");
    let text = format!(
        "G17 G54 G90 T9 D1 M6\nG0 X0 Y0\nZ-10\n_TUL=0.5 _TLL=-0.5 _TDIF=0.6 _TSA=1 _FA=2\n\
         {}IF _OVR[4]<50\n{}ENDIF\n{}M30\n",
        call(50),
        call(49),
        call(51)
    );
    let program = Rc::new(read(Dialect::Sinumerik, text.as_bytes()));
    let view = ran(&(program, setup));
    let lines: Vec<_> =
        view.calls.iter().map(|one| (one.call.line.unwrap(), one.verdicts.iter().map(|one| one.count).sum())).collect();
    let between = lines.iter().find(|(line, _)| *line == 9).unwrap().1;
    assert!((10..50).contains(&between), "{lines:?}");
    assert!(lines.contains(&(6, 60)) && lines.contains(&(12, 60)), "{lines:?}");
    for call in &view.calls {
        let own = call.uncorrected.iter().map(|one| one.count).sum::<usize>();
        assert!(own > 0 && own <= 60, "{:?}", call.call);
    }
}
