//! Parts that are made with the corrected tool come nearer to the setpoint, as mean value and limits let them.
//!
//! A part becomes as the tool really is and as the control believes it to be: where the mill is thicker than believed,
//! a hole grows by twice the difference, a shaft shrinks by it, and a face stands back.

use super::bench::{Values, call, near, result, with};
use probewright_core::control::{Edge, Plane, Tool};
use probewright_core::diagnostic::Code;
use probewright_core::dialect::Dialect;
use probewright_core::machine::Setup;
use probewright_core::workpiece::PartErrors;

/// `_TZL`, `_TMV`, tolerance, `_TDIF`, mm.
const ZERO: f64 = 0.04;
const MEAN: f64 = 0.08;
const TOLERANCE: f64 = 0.1;
const DIFFERENCE: f64 = 0.3;
/// Radius and length of the mill in the tool memory.
const MILL: [f64; 2] = [10.0, 80.0];

/// Set sizes of the elements, the ways of the probe, and the mill as what is corrected.
pub const MEASURED: [(&str, f64); 7] = [
    ("_SETVAL", 60.0),
    ("_SETV[0]", 60.0),
    ("_SETV[1]", 44.0),
    ("_FA", 4.0),
    ("_TSA", 2.0),
    ("_KNUM", 2001.0),
    ("_TNUM", 20.0),
];

/// A measurement that corrects the mill.
#[derive(Clone, Debug)]
struct Job {
    cycle: &'static str,
    values: Values,
    /// Measuring axis where a position is measured, 0 to 2.
    axis: Option<usize>,
    /// What is added to the datum of the tool for a difference of 1: half and whole, thicker and thinner.
    share: f64,
    /// The datum: wear of the radius, or of L1.
    datum: &'static str,
}

impl Job {
    /// What the datum believes to be more than there is (`believed`, mm) makes the part differ by.
    fn difference(&self, believed: f64) -> f64 {
        -believed / self.share
    }

    /// A part with this difference.
    fn part(&self, difference: f64) -> PartErrors {
        let mut errors = PartErrors::default();
        match self.axis {
            Some(axis) => errors.shift[axis] = difference,
            None => errors.size = difference,
        }
        errors
    }
}

/// Holes, shafts, grooves, webs, rectangles along the axes and at an angle; faces in each axis, the upper one by L1.
fn jobs(weight: f64) -> Vec<Job> {
    let judged = [
        ("_EVNUM", 10.0),
        ("_K", weight),
        ("_TZL", ZERO),
        ("_TMV", MEAN),
        ("_TUL", TOLERANCE),
        ("_TLL", -TOLERANCE),
        ("_TDIF", DIFFERENCE),
    ];
    let values = with(&MEASURED, &judged);
    let radius = "$TC_DP15[20,1]";
    let element = |cycle, variant: i32, more: &[(&'static str, f64)]| Job {
        cycle,
        values: with(&with(&values, &[("_MVAR", f64::from(variant))]), more),
        axis: None,
        share: if variant % 2 == 1 { 0.5 } else { -0.5 },
        datum: radius,
    };
    let mut jobs: Vec<Job> =
        (1..=6).map(|variant| element("CYCLE977", variant, &[("_MA", 1.0), ("_ID", -25.0)])).collect();
    let at_angle = [("_CPA", 0.0), ("_CPO", 0.0), ("_STA1", 25.0), ("_INCA", 80.0), ("_RF", 900.0), ("_ID", 25.0)];
    jobs.extend((1..=4).map(|variant| element("CYCLE979", variant, &at_angle)));
    for (axis, name) in [1.0, 2.0, 3.0].into_iter().enumerate() {
        // the faces of the plane are touched in plus direction, and milled by the radius; the upper one by the length
        let upper = axis == 2;
        let target = if upper { 1.0 } else { 2001.0 };
        let more = [("_MVAR", 0.0), ("_MA", name), ("_KNUM", target)];
        jobs.push(Job {
            cycle: "CYCLE978",
            values: with(&values, &more),
            axis: Some(axis),
            share: if upper { -1.0 } else { 1.0 },
            datum: if upper { "$TC_DP12[20,1]" } else { radius },
        });
    }
    jobs
}

/// A machine with the mill T20, whose mean values are kept.
pub fn machine() -> Setup {
    let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
    let edge = Edge { kind: 120, radius: MILL[0], length: [MILL[1], 0.0, 0.0], ..Edge::default() };
    let tool = Tool { name: "MILL".into(), edges: [(1, edge)].into() };
    setup.control.tools.insert(20, tool);
    setup.control.set("_CHBIT[4]", 1.0); // the mean value is kept
    setup
}

/// What the manual says of a difference, its mean value so far and the weight (B:1239-1263, B:1286-1394): what is
/// corrected, and the mean value afterwards.
fn decided(difference: f64, old: f64, weight: f64) -> (f64, f64) {
    if difference.abs() > DIFFERENCE {
        return (0.0, old);
    }
    if difference.abs() > MEAN {
        return (difference, 0.0);
    }
    let mean = old - (old - difference) / weight;
    if mean.abs() > ZERO { (mean, 0.0) } else { (0.0, mean) }
}

/// Differences of ten parts in table 1-2, µm.
const TABLE: [f64; 10] = [30.0, 50.0, 60.0, 20.0, 40.0, 50.0, 50.0, 30.0, 70.0, 70.0];

// oracle: manual B:1265-1284. Rows 5 to 7 for k = 3 carry a misprint on (32.6 for 33.58) and are worked out by hand.
#[test]
fn parts_that_differ_as_in_the_printed_table_correct_where_it_does() {
    for (weight, means, corrected) in [
        (2.0, [15.0, 32.5, 46.2, 10.0, 25.0, 37.5, 43.75, 15.0, 42.5, 35.0], &[3, 7, 9][..]),
        (3.0, [10.0, 23.3, 35.5, 30.3, 33.580, 39.053, 42.702, 10.0, 30.0, 43.3], &[7, 10]),
    ] {
        for job in jobs(weight).into_iter().step_by(weight as usize - 1) {
            let mut setup = machine();
            let mut rows = Vec::new();
            let mut wear = 0.0;
            for (index, difference) in TABLE.into_iter().enumerate() {
                let part = job.part(difference / 1000.0);
                call(&mut setup, job.cycle, &job.values, part);
                let what = format!("{job:?} row {}", index + 1);
                let mean = result(&setup, 31) * 1000.0;
                let after = setup.control.variable(job.datum).unwrap();
                if after != wear {
                    rows.push(index + 1);
                    let share = (after - wear) / job.share * 1000.0;
                    near(share, means[index], 0.1, &what);
                    near(setup.control.number("_MV[9]"), 0.0, 0.0, &what);
                } else {
                    near(mean, means[index], 0.1, &what);
                    near(setup.control.number("_MV[9]") * 1000.0, mean, 1e-9, &what);
                }
                wear = after;
            }
            assert_eq!(rows, corrected, "{job:?}");
        }
    }
}

// oracle: hand (the model above and the head of this file)
#[test]
fn a_wearing_mill_keeps_making_good_parts() {
    const PARTS: usize = 8;
    const WEAR: f64 = 0.015;
    let mut first = Vec::new();
    for weight in [1.0, 2.0, 4.0] {
        for job in jobs(weight) {
            let mut setup = machine();
            let (mut mean, mut began) = (0.0, None);
            let mut last: Option<(f64, f64)> = None;
            // believed too large from the beginning, so that the first part is out of tolerance
            let wrong = 0.15 * job.share.abs();
            for part in 0..PARTS {
                let lost = wrong + WEAR * job.share.abs() * part as f64;
                let entered = setup.control.variable(job.datum).unwrap();
                let difference = job.difference(lost + entered);
                if let Some((before, corrected)) = last {
                    let drift = WEAR;
                    let nearer = difference.abs() < before.abs() + drift - corrected.abs() + 1e-9;
                    assert!(nearer, "{job:?} part {part}: {before} {difference}");
                }
                let outcome = call(&mut setup, job.cycle, &job.values, job.part(difference));
                let (correction, kept) = decided(difference, mean, weight);
                let what = format!("{job:?} part {part}");
                near(result(&setup, 16), difference, 1e-9, &what);
                let after = setup.control.variable(job.datum).unwrap();
                near(after - entered, correction * job.share, 1e-9, &what);
                near(setup.control.number("_MV[9]"), kept, 1e-9, &what);
                let alarms = outcome.alarms();
                let expected = if difference > 0.0 { 62304 } else { 62305 };
                match part {
                    0 => assert_eq!(alarms, [Code::Alarm(expected)], "{what}"),
                    _ => assert!(alarms.is_empty(), "{what} {alarms:?}"),
                }
                if part > 0 && correction != 0.0 {
                    began = began.or(Some(part));
                }
                last = Some((difference, correction));
                mean = kept;
            }
            // without correction the last part would be out of tolerance by far
            let lost = WEAR * (PARTS - 1) as f64;
            assert!(lost > TOLERANCE && last.unwrap().0.abs() < MEAN, "{job:?}");
            first.push((weight, began));
        }
    }
    // oracle: manual B:1246-1257: the larger the weight, the later a trend is corrected
    let of = |weight: f64| {
        let all = first.iter().filter(|(of, _)| *of == weight);
        let mut parts: Vec<_> = all.map(|(_, part)| part.unwrap()).collect();
        parts.dedup();
        assert_eq!(parts.len(), 1, "the same for every job");
        parts[0]
    };
    assert!(of(1.0) < of(2.0) && of(2.0) < of(4.0), "{first:?}");
}

// oracle: manual B:1340, B:1386-1388: beyond _TDIF and within _TZL nothing is corrected
#[test]
fn what_is_too_far_off_or_good_enough_corrects_nothing() {
    for job in jobs(1.0) {
        for (difference, alarms) in [(0.35, &[Code::Alarm(62306)][..]), (0.03, &[]), (-0.04, &[])] {
            let mut setup = machine();
            let outcome = call(&mut setup, job.cycle, &job.values, job.part(difference));
            assert_eq!(outcome.alarms(), alarms, "{job:?}");
            assert_eq!(setup.control.variable(job.datum), Some(0.0), "{job:?}");
        }
    }
}
