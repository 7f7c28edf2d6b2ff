//! The same measurement seen otherwise: axes renamed, in a looking-glass, elsewhere, in other units.

use super::draw::{Drawn, Passed, hold, measuring, milling};
use super::stand::{Stand, stand, stand_in};
use super::view::{View, differs};
use probewright_core::control::Units;
use probewright_core::entry::{factor, names};
use probewright_core::machine::trace::Step;
use probewright_core::run::Outcome;
use proptest::prelude::*;
use proptest::test_runner::TestCaseError;

/// A resolution of contact, and what turning a frame over leaves of it at the end of a lever of some 300 mm.
const NEAR: f64 = 1e-7;

fn stopped(outcome: &Outcome) -> Passed {
    outcome.stop.as_ref().map(|stop| format!("{stop:?}"))
}

/// Cycles that calibrate or turn a frame, for which no axis may be mirrored, and the corner, whose setpoint angle
/// applies to the machine (B:7858).
const UNMIRRORED: [&str; 4] = ["CYCLE961", "CYCLE976", "CYCLE997", "CYCLE998"];

/// Ends of all motions, machine coordinates, mm, with their feeds.
fn motions(outcome: &Outcome) -> Vec<([f64; 3], f64)> {
    let steps = outcome.trace.entries.iter();
    let end = |step: &Step| match step {
        Step::Motion { to, feed, .. } => Some((to.0, *feed)),
        _ => None,
    };
    steps.filter_map(|entry| end(&entry.step)).collect()
}

/// Both run; what the one does, seen so, is what the other does.
fn follows(view: View, drawn: &Drawn, here: &Stand) -> Result<Passed, TestCaseError> {
    let there = view.stand(here).run();
    let here = here.run();
    prop_assert_eq!(&here.stop, &there.stop, "{:?} {:?}", view, drawn);
    let (ways, others) = (motions(&here), motions(&there));
    prop_assert_eq!(ways.len(), others.len(), "{:?} {:?}", view, drawn);
    for ((to, feed), (other, other_feed)) in ways.into_iter().zip(others) {
        let to = view.point(to);
        let off = (0..3).map(|i| (to[i] - other[i]).abs()).fold(0.0, f64::max);
        prop_assert!(off < NEAR && (feed - other_feed).abs() < NEAR, "{:?} {:?} {:?} {:?}", view, to, other, drawn);
    }
    let differs = differs(drawn.cycle, &view.control(&here.control), &there.control, NEAR);
    prop_assert_eq!(differs, None, "{:?} {:?}", view, drawn);
    Ok(stopped(&here))
}

// oracle: self (which axis is called X, Y and Z is a matter of names: the plane goes along, and with it everything, but
// for the order in which a frame turns about both axes of the plane, which is by name)
#[test]
fn the_plane_changes_nothing() {
    hold(milling(), 12, |drawn| {
        let mut here = match stand(drawn) {
            Ok(here) => here,
            Err(refused) => return Ok(Some(refused)),
        };
        if drawn.cycle == "CYCLE998" && drawn.variant % 10 == 6 {
            here.inputs.numbers.insert(names::KNUM, 0.0);
        }
        follows(View::Renamed(1), drawn, &here)?;
        follows(View::Renamed(2), drawn, &here)
    });
}

// oracle: self (whoever sees machine, part and probe in a looking-glass sees a measurement too)
#[test]
fn a_looking_glass_changes_nothing() {
    let places = milling().filter(|cycle| !UNMIRRORED.contains(&cycle.name));
    hold(places, 12, |drawn| {
        let here = match stand(drawn) {
            Ok(here) => here,
            Err(refused) => return Ok(Some(refused)),
        };
        let [abscissa, ordinate, _] = here.setup.control.plane.axes();
        follows(View::Reflected(abscissa), drawn, &here)?;
        follows(View::Reflected(ordinate), drawn, &here)
    });
}

// oracle: self (part, zero offset and probe moved together and turned about the spindle are only another choice of
// coordinates; a probe that stands beside the spindle axis does not turn with them). The corner has its test in
// `anywhere.rs`, as its setpoint angle applies to the machine.
#[test]
fn the_place_changes_nothing() {
    hold(milling().filter(|cycle| cycle.name != "CYCLE961"), 8, |drawn| {
        let mut drawn = drawn.clone();
        drawn.machine.skew = [0.0; 2];
        let here = match stand(&drawn) {
            Ok(here) => here,
            Err(refused) => return Ok(Some(refused)),
        };
        let [.., applicate] = here.setup.control.plane.axes();
        let view = View::Elsewhere { axis: applicate, turn: drawn.moved.turn[0], by: drawn.moved.at };
        follows(view, &drawn, &here)
    });
}

/// Everything that can be compared, in mm, mm/min and degree.
fn physical(stand: &Stand, outcome: &Outcome) -> Vec<(String, f64)> {
    let mut list = Vec::new();
    for (field, value) in outcome.results(stand.inputs.cycle) {
        list.push((field.name.to_owned(), value * factor(field.unit, &outcome.control)));
    }
    let changes = outcome.changes();
    list.extend(changes.into_iter().map(|change| (change.name, change.after - change.before)));
    for (to, feed) in motions(outcome) {
        list.extend(to.into_iter().chain([feed]).map(|value| ("motion".to_owned(), value)));
    }
    list
}

// oracle: self (four codes on two machines against a metric program on a metric machine)
#[test]
fn units_change_nothing() {
    hold(measuring(), 4, |drawn| {
        let here = match stand_in(drawn, Units::Metric, Some(71)) {
            Ok(here) => here,
            Err(refused) => return Ok(Some(refused)),
        };
        let metric = here.run();
        let expected = physical(&here, &metric);
        for (basic, code) in
            [(Units::Metric, 70), (Units::Metric, 700), (Units::Inch, 70), (Units::Inch, 71), (Units::Inch, 710)]
        {
            let there = stand_in(drawn, basic, Some(code));
            prop_assert!(there.is_ok(), "{:?} G{} is refused: {:?}", basic, code, drawn);
            let there = there.unwrap();
            let outcome = there.run();
            prop_assert_eq!(&metric.stop, &outcome.stop, "{:?} G{} {:?}", basic, code, drawn);
            let found = physical(&there, &outcome);
            prop_assert_eq!(
                expected.len(),
                found.len(),
                "{:?} G{} {:?} {:?} {:?}",
                basic,
                code,
                drawn,
                expected,
                found
            );
            for (one, other) in expected.iter().zip(&found) {
                let same = one.0 == other.0 && (one.1 - other.1).abs() < NEAR;
                prop_assert!(same, "{:?} G{}: {:?} {:?} {:?}", basic, code, one, other, drawn);
            }
        }
        Ok(stopped(&metric))
    });
}
