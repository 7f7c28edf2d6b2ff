//! What a measurement corrected is right afterwards: measured again, nothing is left to correct.

use super::draw::{Drawn, hold, is_milling, measuring, milling};
use super::stand::{Stand, stand};
use probewright_core::entry::{Inputs, ProbeUse, names};
use probewright_core::geometry::Wcs;
use probewright_core::name::Name;
use probewright_core::run::Outcome;
use proptest::prelude::*;
use proptest::test_runner::TestCaseError;

/// What a second measurement may leave, mm and degree: contact is computed to 1e-9 mm, over a base of some 20 mm.
const LEFT: f64 = 1e-7;

/// The machine after a call, the probe where it stood in the workpiece system of before, seen in that of now. A corner
/// is looked for from where the probe stands.
fn after(stand: &Stand, outcome: &Outcome) -> Stand {
    let mut again = stand.clone();
    let start = stand.setup.control.to_workpiece(stand.setup.position);
    again.setup.control = outcome.control.clone();
    let settable = match stand.inputs.any(names::KNUM).map_or(0, |number| number as i64) {
        number @ 1..=99 => number as usize,
        1000 => 0,
        _ => again.setup.control.settable,
    };
    let programmed = again.setup.control.program_frame;
    again.setup.control.activate(settable);
    again.setup.control.program_frame = programmed;
    if stand.inputs.cycle.name != "CYCLE961" {
        again.setup.position = again.setup.control.to_machine(start);
    } else if stand.inputs.variant > 110 {
        same_places(stand, start.0, &mut again);
    }
    again
}

/// The places before the edges of a corner (B:8046) as the corrected system has them.
fn same_places(stand: &Stand, start: [f64; 3], again: &mut Stand) {
    let [abscissa, ordinate, _] = stand.setup.control.plane.axes();
    let names = stand.inputs.cycle.params.iter().map(|param| param.name);
    let names: Vec<Name> = names.filter(|name| name.starts_with("_SETV[")).collect();
    for pair in names.chunks_exact(2) {
        let mut place = start;
        (place[abscissa], place[ordinate]) = (stand.inputs.number(pair[0]), stand.inputs.number(pair[1]));
        let place = again.setup.control.to_workpiece(stand.setup.control.to_machine(Wcs(place)));
        for (name, axis) in pair.iter().zip([abscissa, ordinate]) {
            again.inputs.numbers.entry(*name).and_modify(|value| *value = place[axis]);
        }
    }
}

/// Whether a call corrects a zero offset or calibrates: then the same call finds nothing any more.
fn settles(drawn: &Drawn, inputs: &Inputs) -> bool {
    let cycle = drawn.cycle();
    let itself = cycle.purpose.calibrates.holds(inputs) || cycle.purpose.probe == ProbeUse::Tool;
    let zero = cycle
        .param("_KNUM")
        .is_some_and(|param| probewright_core::check::target(param, inputs) == probewright_core::check::Target::Zero);
    itself || zero && inputs.integer(names::KNUM) != 0
}

/// A probe beside the spindle axis is calibrated for one turn of the coordinates; only a spindle that follows them
/// keeps what was found right (`_CHBIT[13]`, turning as the machine's does with `_CHBIT[14]` = 0: B:13973-13987).
fn follows(drawn: &Drawn) -> bool {
    let is = |bit: &str| drawn.machine.bits.contains(&bit);
    drawn.machine.upright && is("_CHBIT[13]") && !is("_CHBIT[14]")
}

fn settled(drawn: &Drawn) -> Result<Option<String>, TestCaseError> {
    let mut drawn = drawn.clone();
    if !follows(&drawn) {
        drawn.machine.skew = [0.0; 2];
    }
    // two angles are corrected as one turn, to which an empirical value of each adds up only nearly
    drawn.call.memory &= drawn.variant % 100 != 6;
    let drawn = &drawn;
    let first = match stand(drawn) {
        Ok(stand) => stand,
        Err(refused) => return Ok(Some(refused)),
    };
    if !settles(drawn, &first.inputs) {
        return Ok(None);
    }
    let outcome = first.run();
    if let Some(stop) = &outcome.stop {
        return Ok(Some(format!("{stop:?}")));
    }
    let second = after(&first, &outcome).run();
    prop_assert_eq!(&second.stop, &None, "{:?}", drawn);
    for change in second.changes() {
        let mut what = (change.after - change.before).abs();
        if change.name.ends_with(",RT]") {
            what = what.min((what - 360.0).abs()); // the same angle
        }
        let remembers = change.name.starts_with("_MV[") || change.name.starts_with("_EV[");
        prop_assert!(remembers || what < LEFT, "{:?} {:?}", change, drawn);
    }
    Ok(None)
}

// oracle: manual B:6153 (afterwards the measured point has the set coordinates), B:5037 (the probe is as calibrated)
#[test]
fn measured_again_nothing_is_left() {
    hold(milling(), 12, settled);
    hold(measuring().filter(|cycle| !is_milling(cycle)), 6, settled);
}
