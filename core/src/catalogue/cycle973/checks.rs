//! What several values of CYCLE973, the data of the groove and the probe in use say together.

use super::groove::Groove;
use super::params::{GROOVE, TWO};
use crate::catalogue::prelude::*;
use crate::catalogue::{calibration, lathe};

/// All of them.
pub fn checks(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    shared_checks::probe(inputs, control, found);
    calibration::band(inputs, found);
    let ball = calibration::ball_radius(inputs, control);
    calibration::first(inputs, control, ball, found);
    shared_checks::rotation(control, found);
    if !GROOVE.holds(inputs) {
        calibration::unmirrored(control, found);
    }
    let tip = lathe::checks::tip(control, found);
    if GROOVE.holds(inputs) {
        groove(inputs, control, tip, ball, found);
    } else if let Some(tip) = tip {
        shank(inputs, tip, found);
    }
}

/// Number of the pair, position of the probe, direction at the base, data of the groove (B:10145, B:10213-10255).
fn groove(inputs: &Inputs, control: &Control, tip: Option<i64>, ball: f64, found: &mut Vec<Diagnostic>) {
    let pair = inputs.given(names::CALNUM);
    let known = pair.is_none_or(|pair| number(pair, control, found));
    let Some(tip) = tip else { return };
    let Some(groove) = Groove::of(tip) else {
        found.push(lathe::checks::wrong_tip(tip, "check-groove-tip-hint"));
        return;
    };
    if inputs.integer(names::MA) - 1 == groove.axes[1] as i64 {
        base(inputs, found);
    }
    if let Some(pair) = pair.filter(|_| known) {
        data(inputs, control, &groove, pair as i64 - 1, ball, found);
    }
}

/// Whether there is such a pair of grooves; `_CVAL[2]` counts them (B:13347, A:15876).
fn number(pair: f64, control: &Control, found: &mut Vec<Diagnostic>) -> bool {
    let pairs = control.number("_CVAL[2]");
    if pair <= pairs {
        return true;
    }
    let finding = refused(61333, "check-groove-number", names::CALNUM).number("number", pair);
    found.push(finding.hint_number("pairs", pairs));
    false
}

/// In the axis of its base a groove has one face, touched in minus direction (B:13473-13482). No alarm is named; 61326
/// is that of a wrong direction (A:15867).
fn base(inputs: &Inputs, found: &mut Vec<Diagnostic>) {
    let at = match inputs.given(names::MD) {
        _ if TWO.holds(inputs) => names::MA,
        Some(0.0) => names::MD,
        _ => return,
    };
    found.push(refused(61326, "check-groove-base", at));
}

/// Whether the data of the groove are there, and leave the ball its way.
fn data(inputs: &Inputs, control: &Control, groove: &Groove, pair: i64, ball: f64, found: &mut Vec<Diagnostic>) {
    let [plus, minus, base] = groove.names(pair);
    let [upper, lower, depth] = [&plus, &minus, &base].map(|name| control.basic_length(name));
    if [upper, lower, depth] == [0.0; 3] {
        let names = [plus, minus, base].join(", ");
        found.push(own::GROOVE_EMPTY.finding().text("names", names).at(names::CALNUM));
        return;
    }
    if upper <= lower {
        found.push(own::GROOVE_EDGES.finding().text("plus", plus).text("minus", minus).at(names::CALNUM));
        return;
    }
    let width = upper - lower;
    let room = shared_checks::fits(names::CALNUM, width, ball, found);
    if room && inputs.integer(names::MA) - 1 != groove.axes[1] as i64 {
        shared_checks::across(inputs, names::CALNUM, width, ball, found);
    }
}

/// A stylus that points along the axis cannot touch backwards: 5 and 7 point to plus and minus of the abscissa, 6 and 8
/// of the ordinate (B:10513; the figure is lost, the groove of position 7 has its base in minus).
fn shank(inputs: &Inputs, tip: i64, found: &mut Vec<Diagnostic>) {
    let backwards = matches!(
        (tip, inputs.integer(names::MA), inputs.given(names::MD).map(|direction| direction as i64)),
        (5, 1, Some(1)) | (7, 1, Some(0)) | (6, 2, Some(1)) | (8, 2, Some(0))
    );
    if backwards {
        found.push(own::SHANK.finding().number("tip", tip as f64).at(names::MD));
    }
}
