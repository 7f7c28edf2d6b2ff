//! How uncertain a form calls what follows from points that lie badly, is how much it scatters when the probe does.

use super::bench::{Values, inputs, place, result, run, with};
use probewright_core::catalogue::find;
use probewright_core::check::check;
use probewright_core::control::Plane;
use probewright_core::diagnostic::Code;
use probewright_core::dialect::Dialect;
use probewright_core::entry::Typed;
use probewright_core::evaluate::spread;
use probewright_core::geometry::Degrees;
use probewright_core::machine::Setup;
use probewright_core::message::Arg;
use probewright_core::workpiece::PartErrors;

/// Scatter of the simulated probe along its way, mm.
const SCATTER: f64 = 0.001;
const RUNS: usize = 400;
/// Four times the standard error of a standard deviation from so many runs, 1/sqrt(2n).
const SURE: f64 = 4.0 / 28.3;

/// Machine and part of a call, and its results in all runs: how much each scatters, as multiples of the scatter of a
/// touch.
fn scattered<const N: usize>(name: &str, values: &Values, results: [usize; N]) -> [f64; N] {
    let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    setup.probe.repeatability = (SCATTER, 1);
    let inputs = inputs(&setup, name, values);
    place(&mut setup, &inputs, PartErrors::default());
    let all: Vec<[f64; N]> = (0..RUNS)
        .map(|_| {
            run(&mut setup, &inputs);
            results.map(|index| result(&setup, index))
        })
        .collect();
    std::array::from_fn(|i| {
        let mean = all.iter().map(|one| one[i]).sum::<f64>() / RUNS as f64;
        let squares = all.iter().map(|one| (one[i] - mean).powi(2)).sum::<f64>();
        (squares / (RUNS - 1) as f64).sqrt() / SCATTER
    })
}

/// Numbers that a form tells under this number of ours, in their order; none where it says nothing.
fn told(name: &str, values: &Values, number: u16) -> Option<Vec<(&'static str, f64)>> {
    let setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    let text = |(name, value): &(&str, f64)| ((*name).to_owned(), value.to_string());
    let typed: Typed = values.iter().map(text).collect();
    let cycle = find(Dialect::Sinumerik, name).unwrap();
    let found = check(cycle, &typed, &setup.control).diagnostics;
    let one = found.into_iter().find(|one| one.code == Code::Own(number))?;
    let numbers = one.message.args.into_iter().chain(one.hint.into_iter().flat_map(|hint| hint.args));
    Some(
        numbers
            .filter_map(|(name, value)| match value {
                Arg::Number(number) => Some((name, number)),
                Arg::Text(_) => None,
            })
            .collect(),
    )
}

/// One of the numbers, which are rounded to two digits.
fn number(told: &[(&'static str, f64)], name: &str) -> f64 {
    told.iter().find(|(other, _)| *other == name).unwrap().1
}

fn is(scattered: f64, told: f64, what: &str) {
    assert!((told * (0.95 - SURE)..told * (1.05 + SURE)).contains(&scattered), "{what}: {scattered}, told {told}");
}

fn near(scattered: f64, expected: f64, what: &str) {
    assert!((scattered / expected - 1.0).abs() < SURE, "{what}: {scattered}, expected {expected}");
}

/// Values that most calls need.
fn common(more: &[(&'static str, f64)]) -> Values {
    with(
        &[
            ("_KNUM", 0.0),
            ("_FA", 5.0),
            ("_TSA", 5.0),
            ("_SETVAL", 60.0),
            ("_CPA", 0.0),
            ("_CPO", 0.0),
            ("_RF", 900.0),
            ("_RA", 0.0),
        ],
        more,
    )
}

// oracle: self (400 runs of the simulated cycle; the factors of the first two are those of another program, see
// `evaluate::spread`)
#[test]
fn circles_scatter_as_they_are_told_to() {
    for (variant, start, step) in [(101.0, 0.0, 20.0), (101.0, 15.0, 80.0), (10_101.0, 40.0, 12.0)] {
        // the number of points stands in the fourth digit of _PRNUM
        let (variant, probe, count) = if variant > 1e4 { (101.0, 1001.0, 4) } else { (variant, 1.0, 3) };
        let values = common(&[("_MVAR", variant), ("_STA1", start), ("_INCA", step), ("_PRNUM", probe)]);
        let what = format!("{values:?}");
        let [diameter, x, y] = scattered("CYCLE979", &values, [4, 5, 6]);
        let directions: Vec<Degrees> = (0..count).map(|i| Degrees(start + step * f64::from(i))).collect();
        let expected = spread::circle(&directions).unwrap();
        near(diameter, expected.diameter, &what);
        near(x, expected.centre[0], &what);
        near(y, expected.centre[1], &what);
        let told = told("CYCLE979", &values, 170);
        assert_eq!(told.is_some(), step < 60.0, "{what}");
        if let Some(told) = told {
            is(diameter, number(&told, "diameter"), &what);
            is(x.max(y), number(&told, "centre"), &what);
        }
    }
}

// oracle: self (400 runs)
#[test]
fn spheres_scatter_as_they_are_told_to() {
    let sphere = [("_STA1", 0.0), ("_INCA", 15.0), ("_SETV[0]", 0.0), ("_SETV[1]", 0.0), ("_SETV[2]", -30.0)];
    let values = with(&common(&sphere), &[("_MVAR", 1109.0)]);
    let [x, y] = scattered("CYCLE997", &values, [5, 6]);
    is(x.max(y), number(&told("CYCLE997", &values, 170).unwrap(), "centre"), "centre");
    let values = with(&values, &[("_MVAR", 1_001_109.0)]);
    let told = told("CYCLE997", &values, 170).unwrap();
    let [diameter, x, y] = scattered("CYCLE997", &values, [4, 5, 6]);
    is(diameter, number(&told, "diameter"), "diameter");
    is(x.max(y), number(&told, "centre"), "centre");
}

// oracle: self (400 runs); hand: an angle in degree, over 100 mm
#[test]
fn angles_scatter_as_they_are_told_to() {
    for (variant, angle) in [(105.0, 0.0), (105.0, 25.0), (1105.0, -20.0)] {
        let set = [("_MVAR", variant), ("_MA", 102.0), ("_ID", 9.0), ("_STA1", angle), ("_SETVAL", -18.0)];
        let values = common(&set);
        let told = told("CYCLE998", &values, 172).unwrap();
        let [degree] = scattered("CYCLE998", &values, [4]);
        is(degree.to_radians() * 100.0, number(&told, "factor"), &format!("{values:?}"));
        let enough = with(&values, &[("_ID", number(&told, "needed"))]);
        assert_eq!(self::told("CYCLE998", &enough, 172), None);
    }
}

// oracle: self (400 runs); hand: an angle in degree, over 100 mm
#[test]
fn corners_scatter_as_they_are_told_to() {
    let distances = |variant: f64, angles: [f64; 2], distance: f64| {
        common(&[
            ("_MVAR", variant),
            ("_STA1", angles[0]),
            ("_INCA", angles[1]),
            ("_SETV[0]", distance),
            ("_SETV[1]", distance),
            ("_SETV[2]", 0.0),
            ("_SETV[3]", 0.0),
            ("_SETV[4]", 1.0),
            ("_ID", 0.0),
            ("_FA", 20.0),
        ])
    };
    let mut seen = 0;
    for values in [
        distances(107.0, [0.0, 90.0], 18.0),
        distances(107.0, [10.0, 85.0], 24.0),
        distances(107.0, [0.0, 14.0], 60.0),
        distances(105.0, [0.0, 90.0], 12.0),
    ] {
        let what = format!("{values:?}");
        let [degree, x, y] = scattered("CYCLE961", &values, [4, 5, 6]);
        if let Some(told) = told("CYCLE961", &values, 172) {
            is(degree.to_radians() * 100.0, number(&told, "factor"), &what);
            seen += 1;
        }
        if let Some(told) = told("CYCLE961", &values, 171) {
            is(x.max(y), number(&told, "factor"), &what);
            seen += 10;
        }
    }
    assert_eq!(seen, 13);
}
