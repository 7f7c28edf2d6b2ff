//! The figures collected from the manual: `tests/data/vectors.json`, fifteen groups, each where it is found. The key
//! figures stand in the tests of `evaluate` as well.

#![cfg(feature = "json")]
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use probewright_core::catalogue::find;
use probewright_core::control::{Store, delivery};
use probewright_core::dialect::Dialect;
use probewright_core::entry::Typed;
use probewright_core::evaluate::tolerance::{Bands, chain};
use probewright_core::evaluate::{knum, knum::ZeroCode, mean, symmetry};
use probewright_core::form;
use probewright_core::json::setup_from_json;
use probewright_core::machine::trace::{MotionKind, Step};
use probewright_core::run::{Limits, Outcome, run};
use probewright_core::syntax::read;
use serde::Deserialize;
use serde_json::{Value, json};

/// All groups. A group or figure that nobody reads does not compile.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Vectors {
    mean_value: MeanValue,
    deceleration: Vec<Deceleration>,
    rotating_tool: Vec<RotatingTool>,
    symmetrise: Vec<Symmetrise>,
    tool_correction: Vec<ToolCorrection>,
    tool_correction_long: Vec<ToolCorrection>,
    zero_correction: Vec<ZeroCorrection>,
    probe: Vec<Probe>,
    memories: Vec<Memories>,
    tool_probe_sides: Vec<Sides>,
    circle: Vec<Circle>,
    formatted: Vec<Formatted>,
    measuring_axis: Vec<MeasuringAxis>,
    measuring_speed: Vec<MeasuringSpeed>,
    tolerance_chain: ToleranceChain,
}

fn vectors() -> Vectors {
    serde_json::from_str(include_str!("../../tests/data/vectors.json")).unwrap()
}

/// A mill without anything to touch.
fn bare() -> Value {
    json!({ "control": "sinumerik", "probe": { "radius": 3, "length": 50 }, "position": [0, 0, 400] })
}

/// A run of a SINUMERIK program on a machine of the setup file.
fn outcome(setup: &Value, program: &str) -> Outcome {
    let setup = setup_from_json(&setup.to_string()).unwrap();
    run(&read(Dialect::Sinumerik, program.as_bytes()), &setup, Limits::default())
}

/// The same without a finding.
fn clean(setup: &Value, program: &str) -> Outcome {
    let outcome = outcome(setup, program);
    assert_eq!((&outcome.stop, &outcome.diagnostics[..]), (&None, &[][..]), "{program}");
    outcome
}

/// Start, end and feed of every measuring motion.
fn probings(outcome: &Outcome) -> Vec<([f64; 3], [f64; 3], f64)> {
    let entries = outcome.trace.entries.to_vec();
    let steps = entries.iter().map(|entry| &entry.step);
    steps
        .filter_map(|step| match step {
            Step::Motion { kind: MotionKind::Measuring, from, to, feed, .. } => Some((from.0, to.0, *feed)),
            _ => None,
        })
        .collect()
}

/// Axis and sense of a straight motion along an axis.
fn along(from: [f64; 3], to: [f64; 3]) -> (usize, f64) {
    let moved: Vec<usize> = (0..3).filter(|axis| (to[*axis] - from[*axis]).abs() > 1e-9).collect();
    assert_eq!(moved.len(), 1, "{from:?} {to:?}");
    (moved[0], (to[moved[0]] - from[moved[0]]).signum())
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct MeanValue {
    source: String,
    /// µm above which is corrected and begun again.
    limit: f64,
    differences: Vec<f64>,
    series: Vec<Series>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Series {
    weight: f64,
    /// As printed: rounded, and one misprint carried on.
    printed: Vec<f64>,
    means: Vec<f64>,
    /// Places of the corrections, from 1, and what is corrected.
    corrected: Vec<usize>,
    corrections: Vec<f64>,
    /// The most by which print and rule differ.
    misprinted: f64,
}

#[test]
fn mean_values() {
    // oracle: manual B:1265-1284, recomputed where the table carries a misprint on
    let table = vectors().mean_value;
    for series in table.series {
        let (mut old, mut corrected) = (0.0_f64, Vec::new());
        for (at, difference) in table.differences.iter().enumerate() {
            old = mean::next(old, *difference, series.weight).unwrap();
            assert!((old - series.means[at]).abs() < 1e-4, "{}", table.source);
            assert!((old - series.printed[at]).abs() < series.misprinted + 1e-4, "{}", table.source);
            if old.abs() > table.limit {
                corrected.push((at + 1, old));
                old = 0.0;
            }
        }
        assert_eq!(corrected.iter().map(|(at, _)| *at).collect::<Vec<_>>(), series.corrected);
        assert_eq!(corrected.len(), series.corrections.len());
        assert!(corrected.iter().zip(series.corrections).all(|((_, found), wanted)| (found - wanted).abs() < 1e-4));
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Deceleration {
    source: String,
    /// m/min.
    speed: f64,
    /// m/s².
    deceleration: f64,
    /// s.
    delay: f64,
    /// (m/min)/mm.
    gain: f64,
    /// Parts of the path and the whole, mm.
    by_delay: f64,
    by_braking: f64,
    by_following: f64,
    by_axis: f64,
    path: f64,
}

#[test]
fn deceleration() {
    // oracle: manual B:1168-1202; no cycle calculates this path, so a program does, with the formula of the manual
    let setup = bare();
    for case in vectors().deceleration {
        let Deceleration { speed, deceleration, delay, gain, .. } = case;
        let program = format!(
            "DEF REAL SPEED={speed}/60, LATE={delay}, SLOWER={deceleration}, GAIN={gain}\n\
             R1=1000*SPEED*LATE R2=1000*SPEED*SPEED/(2*SLOWER) R3=60*SPEED/GAIN\nR4=R2+R3 R5=R1+R4\nM30\n"
        );
        let control = clean(&setup, &program).control;
        let wanted = [case.by_delay, case.by_braking, case.by_following, case.by_axis, case.path];
        for (register, wanted) in (1..).zip(wanted) {
            let found = control.number(&format!("R{register}"));
            assert!((found - wanted).abs() < 1e-9, "{}: R{register} is {found}", case.source);
        }
    }
}

/// A mill with a tool probe of 22 by 22 mm at X39 Y31 Z80, which stands 0.01 mm lower than its data say.
fn tool_probe(probe: usize, tool: Value, data: &[(&str, f64)]) -> Value {
    let triggers = [50.0, 28.0, 42.0, 20.0, 80.0, 0.0, 20.0, 133.0, 0.0, 4.0];
    let mut all: serde_json::Map<String, Value> =
        (0..).zip(triggers).map(|(index, value)| (format!("_TP[{},{index}]", probe - 1), json!(value))).collect();
    all.extend(data.iter().map(|(name, value)| ((*name).to_owned(), json!(value))));
    let block = json!({ "shape": "block", "size": [22, 22, 20], "at": [39, 31, 79.99] });
    json!({
        "control": "sinumerik",
        "tools": { "4": { "edges": { "1": tool } } },
        "data": all,
        "probe": { "radius": 3, "length": 50 },
        "toolProbes": vec![json!({ "solid": block }); probe],
        "position": [0, 0, 400],
    })
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RotatingTool {
    source: String,
    /// m/min.
    peripheral: f64,
    /// mm.
    radius: f64,
    /// mm.
    accuracy: f64,
    /// 1/min.
    speed: f64,
    /// mm/min.
    feed: f64,
    /// Speed and feed as printed.
    printed: [f64; 2],
}

#[test]
fn rotating_tool() {
    // oracle: manual B:4284-4300
    for case in vectors().rotating_tool {
        let limits = [("_CM[0]", case.peripheral), ("_CM[1]", 5000.0), ("_CM[2]", 0.0), ("_CM[3]", case.accuracy)];
        let tool = json!({ "type": 120, "length": [70, 0, 0], "radius": case.radius });
        let setup = tool_probe(1, tool, &[&limits[..], &[("_CM[4]", 500.0), ("_CM[6]", 0.0)]].concat());
        let program = "G17 G90 G94 T4 D1 M6\nG0 Z100\nX=50+$P_TOOLR+20 Y31\n\
            _MVAR=2 _MA=1 _ID=0 _FA=3 _TZL=0 _TDIF=0.6 _TSA=2 _PRNUM=1 _VMS=0 _NMSP=1 _EVNUM=0\nCYCLE971\nM30\n";
        let outcome = clean(&setup, program);
        let spins = outcome.trace.entries.iter().filter_map(|entry| match entry.step {
            Step::Spin { speed } if speed != 0.0 => Some(speed.abs()),
            _ => None,
        });
        for speed in spins {
            assert!((speed - case.speed).abs() < 1e-3 && (speed - case.printed[0]).abs() < 0.5, "{speed}");
        }
        let probings = probings(&outcome);
        assert!(!probings.is_empty(), "{}", case.source);
        for (_, _, feed) in probings {
            assert!((feed - case.feed).abs() < 1e-4, "{feed}");
            assert!((feed / case.printed[1] - 1.0).abs() < 0.024, "{feed}"); // printed with one or two digits
        }
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Symmetrise {
    source: String,
    setpoint: f64,
    /// `_TUL`, `_TLL`.
    band: [f64; 2],
    #[serde(rename = "_OVR[0]")]
    middle: f64,
    #[serde(rename = "_OVR[8]")]
    upper: f64,
    #[serde(rename = "_OVR[12]")]
    lower: f64,
}

#[test]
fn symmetrising() {
    // oracle: manual B:2211
    for case in vectors().symmetrise {
        let found = symmetry::symmetric(case.setpoint, case.band[0], case.band[1]);
        assert!((found.setpoint - case.middle).abs() < 1e-9, "{}", case.source);
        assert!((found.upper - case.upper).abs() < 1e-9, "{}", case.source);
        assert!((found.lower - case.lower).abs() < 1e-9, "{}", case.source);
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ToolCorrection {
    source: String,
    code: i64,
    edge: i64,
    kind: i64,
    inverted: i64,
    quantity: i64,
    mode: i64,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ZeroCorrection {
    source: String,
    code: i64,
    target: Option<String>,
}

/// What a correction of a frame writes, in the words of the vectors.
fn named(code: ZeroCode) -> String {
    match code {
        ZeroCode::Stored(Store::Settable(number @ 1..=4)) => format!("G{}", 53 + number),
        ZeroCode::Stored(Store::Settable(number)) => format!("G{}", 500 + number),
        ZeroCode::Stored(Store::ChannelBasic(index)) => format!("$P_CHBFR[{index}]"),
        ZeroCode::Stored(Store::GlobalBasic(index)) => format!("$P_NCBFR[{index}]"),
        ZeroCode::Stored(Store::System) => "$P_SETFR".into(),
        ZeroCode::LastBasic => "last basic".into(),
        ZeroCode::Active => "active".into(),
    }
}

#[test]
fn digits_of_the_correction_target() {
    // oracle: manual B:1928, B:2104-2158
    let vectors = vectors();
    for (cases, five) in [(vectors.tool_correction, false), (vectors.tool_correction_long, true)] {
        for case in cases {
            let expected = [case.edge, case.kind, case.inverted, case.quantity, case.mode];
            assert_eq!(knum::digits(case.code, five), expected, "{}", case.source);
            assert!(knum::tool(case.code, five).is_ok(), "{}", case.code);
        }
    }
    for case in vectors.zero_correction {
        assert_eq!(knum::zero(case.code).unwrap().map(named), case.target, "{} {}", case.source, case.code);
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Probe {
    source: String,
    code: i64,
    /// `workpiece` or `tool`.
    probe: String,
    mono: bool,
    /// Beginning of the names of its data.
    data: String,
}

/// A block from X50 Y30 with its upper face at Z20; the ball of the probe is larger than its data say.
fn faces(units: &str) -> Value {
    json!({
        "control": "sinumerik",
        "units": units,
        "frames": { "G54": { "coarse": [0, 0, 0] } },
        "active": { "frame": "G54" },
        "tools": { "9": { "edges": { "1": { "type": 710, "length": [50, 0, 0], "radius": 3 } } } },
        "probe": { "radius": 3.004, "length": 50 },
        "workpiece": [{ "shape": "block", "size": [100, 100, 40], "at": [100, 80, 20] }],
        "position": [100, 80, 300],
    })
}

#[test]
fn number_and_type_of_the_probe() {
    // oracle: manual B:2253-2300: calibrated are the data of the probe that is named, and a mono probe is turned
    for case in vectors().probe {
        let outcome = if case.probe == "workpiece" {
            let program = format!(
                "G17 G54 G90 T9 D1 M6\nG0 X40 Y80\nZ10\n\
                 _MVAR=0 _SETVAL=50 _MA=1 _MD=0 _PRNUM={} _CORA=0 _FA=2 _TSA=4 _TZL=0 _VMS=0 _NMSP=1\nCYCLE976\nM30\n",
                case.code
            );
            clean(&faces("mm"), &program)
        } else {
            let tool = json!({ "type": 120, "length": [70, 0, 0], "radius": 5 });
            let program = format!(
                "G17 G90 G94 T4 D1 M6\nG0 Z100\nX39 Y31\n\
                 _MVAR=0 _MA=3 _PRNUM={} _FA=6 _TSA=5 _TZL=0 _VMS=0 _NMSP=1\nCYCLE971\nM30\n",
                case.code
            );
            clean(&tool_probe(case.code as usize, tool, &[]), &program)
        };
        let written = outcome.written();
        let data: Vec<&str> = written.keys().map(|name| &**name).filter(|name| calibrates(name)).collect();
        assert!(!data.is_empty(), "{}", case.source);
        assert!(data.iter().all(|name| name.starts_with(&case.data)), "{data:?}");
        let turned = outcome.trace.entries.iter().any(|entry| matches!(entry.step, Step::Orient { .. }));
        assert_eq!(turned, case.mono, "{}", case.source);
    }
}

fn calibrates(name: &str) -> bool {
    ["_WP[", "_TP[", "_TPW["].iter().any(|stem| name.starts_with(stem))
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Memories {
    source: String,
    code: i64,
    /// 0: none.
    empirical: i64,
    mean: i64,
}

#[test]
fn memories() {
    // oracle: manual B:2303-2342
    for case in vectors().memories {
        let found = mean::memories(case.code);
        assert_eq!((found.empirical, found.mean), (case.empirical, case.mean), "{}", case.source);
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Sides {
    source: String,
    /// `_TP[k,7]`.
    code: f64,
    /// Whether X, Y, Z are touched while moving in plus direction, and in minus direction.
    plus: [bool; 3],
    minus: [bool; 3],
}

#[test]
fn sides_of_a_tool_probe() {
    // oracle: manual B:4720-4741
    for case in vectors().tool_probe_sides {
        let tool = json!({ "type": 120, "length": [70, 0, 0], "radius": 5 });
        let program = "G17 G90 G94 T4 D1 M6\nG0 Z100\nX39 Y31\n\
            _MVAR=100000 _PRNUM=1 _FA=6 _TSA=5 _TZL=0 _VMS=0 _NMSP=1\nCYCLE971\nM30\n";
        let outcome = clean(&tool_probe(1, tool, &[("_TP[0,7]", case.code)]), program);
        let (mut plus, mut minus) = ([false; 3], [false; 3]);
        for (from, to, _) in probings(&outcome) {
            let (axis, sense) = along(from, to);
            if sense > 0.0 { plus[axis] = true } else { minus[axis] = true }
        }
        assert_eq!((plus, minus), (case.plus, case.minus), "{} {}", case.source, case.code);
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Circle {
    source: String,
    /// Number of points, then abscissa and ordinate of each: `_DATE[0]` to `[8]`.
    points: Vec<f64>,
    centre: [f64; 2],
    radius: f64,
    status: f64,
    alarm: f64,
}

#[test]
fn circle_through_points() {
    // oracle: manual B:2422-2448
    for case in vectors().circle {
        let points: Vec<String> = case.points.iter().map(f64::to_string).collect();
        let program =
            format!("DEF INT _ALM\nDEF REAL _DATE[13]=SET({})\nCYCLE116(_DATE,_ALM)\nR1=_ALM\nM30\n", points.join(","));
        let program = program.replace("R1=_ALM", "R1=_ALM R9=_DATE[9] R10=_DATE[10] R11=_DATE[11] R12=_DATE[12]");
        let control = clean(&bare(), &program).control;
        let wanted = [(1, case.alarm), (9, case.centre[0]), (10, case.centre[1]), (11, case.radius), (12, case.status)];
        for (register, wanted) in wanted {
            let found = control.number(&format!("R{register}"));
            assert!((found - wanted).abs() < 1e-9, "{}: R{register} is {found}", case.source);
        }
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Formatted {
    source: String,
    number: f64,
    decimals: usize,
    text: String,
}

#[test]
fn numbers_as_texts() {
    // oracle: manual B:11296-11320; the log is left out of a run, the picture of the call has the text in its variable
    let cycle = find(Dialect::Sinumerik, "CYCLE118").unwrap();
    for case in vectors().formatted {
        let typed: Typed =
            [("PAR1".to_owned(), case.number.to_string()), ("PAR2".to_owned(), case.decimals.to_string())].into();
        let picture = form::draw(cycle, &typed, &delivery(Dialect::Sinumerik)).unwrap();
        let texts: Vec<String> = picture.shapes.into_iter().filter_map(|shape| shape.text).collect();
        assert!(texts.concat().starts_with(&format!("{}{}", case.text, case.number)), "{}: {texts:?}", case.source);
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct MeasuringAxis {
    source: String,
    /// `_MA`.
    code: i64,
    /// Axes of the plane from 1.
    offset_axis: usize,
    measuring_axis: usize,
}

#[test]
fn offset_axis_and_measuring_axis() {
    // oracle: manual B:1862-1868: between its two points CYCLE998 goes along the one and measures along the other
    for case in vectors().measuring_axis {
        let program = format!(
            "G17 G54 G90 T9 D1 M6\nG0 X80 Y20\nZ10\n_MVAR=105 _SETVAL=30 _MA={} _ID=40 _RA=0 _KNUM=0 _STA1=0 \
             _TSA=5 _FA=8 _PRNUM=1 _VMS=0 _NMSP=1 _EVNUM=0\nCYCLE998\nM30\n",
            case.code
        );
        let probings = probings(&clean(&faces("mm"), &program));
        let [(first, first_end, _), (second, second_end, _)] = probings[..] else { panic!("{probings:?}") };
        for (from, to) in [(first, first_end), (second, second_end)] {
            assert_eq!(along(from, to).0 + 1, case.measuring_axis, "{}", case.source);
        }
        let across = second[case.offset_axis - 1] - first[case.offset_axis - 1];
        assert!((across - 40.0).abs() < 1e-9, "{}: {first:?} {second:?}", case.source);
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct MeasuringSpeed {
    source: String,
    /// `_FA`, mm.
    path: f64,
    /// mm/min.
    metric: f64,
    /// inch/min.
    inch: f64,
}

#[test]
fn measuring_speed_without_one() {
    // oracle: manual B:1135, B:2164-2170
    for case in vectors().measuring_speed {
        for (units, factor, wanted) in [("mm", 1.0, case.metric), ("inch", 25.4, case.inch)] {
            let program = format!(
                "G17 G54 G90 T9 D1 M6\n_MVAR=0 _SETVAL={} _MA=3 _MD=1 _PRNUM=1 _FA={} _TSA=4 _TZL=0 _VMS=0 _NMSP=1\n\
                 G0 Z={}\nCYCLE976\nM30\n",
                20.0 / factor,
                case.path,
                30.0 / factor
            );
            let outcome = outcome(&faces(units), &program);
            assert_eq!(outcome.stop, None, "{:?}", outcome.diagnostics);
            let probings = probings(&outcome);
            assert!(!probings.is_empty(), "{units}");
            for (_, _, feed) in probings {
                assert!((feed / factor - wanted).abs() < 1e-4, "{}: {units} {feed}", case.source);
            }
        }
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ToleranceChain {
    source: String,
    safe_area: f64,
    difference: f64,
    upper: f64,
    lower: f64,
    mean: f64,
    zero_offset: f64,
    weight: f64,
    cases: Vec<Decided>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Decided {
    /// Difference of a diameter.
    found: f64,
    /// Mean value before.
    old: f64,
    alarm: Option<u32>,
    /// Whether the alarm stops the program.
    stops: bool,
    /// Correction of the radius; none without one.
    radius: Option<f64>,
    /// Mean value after.
    memory: f64,
}

#[test]
fn tolerance_chain() {
    // oracle: manual B:6103-6135
    let example = vectors().tolerance_chain;
    let bands = Bands {
        safe_area: example.safe_area,
        difference: example.difference,
        upper: example.upper,
        lower: example.lower,
        mean: example.mean,
        zero_offset: example.zero_offset,
        weight: example.weight,
    };
    for case in example.cases {
        let found = chain(&[case.found], &bands, case.old);
        assert_eq!(found.branch.alarm(), case.alarm, "{} {}", example.source, case.found);
        let stops = case.alarm.is_some_and(|alarm| alarm / 1000 == 61); // 62xxx informs
        assert_eq!(stops, case.stops, "{}", case.found);
        assert!((found.correction / 2.0 - case.radius.unwrap_or(0.0)).abs() < 1e-6, "{}", case.found);
        assert!((found.memory - case.memory).abs() < 1e-6, "{}", case.found);
    }
}
