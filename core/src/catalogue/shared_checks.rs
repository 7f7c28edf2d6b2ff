//! Checks over several parameters that the SINUMERIK workpiece cycles share.

use super::common::MONO;
use crate::catalogue::prelude::*;
use crate::control::Store;
use crate::control::tools::TURNING;
use crate::evaluate::knum::{self, ZeroCode};
use crate::evaluate::mean::{self, Memories};
use crate::own::Own;

/// What every call that corrects a tool or a zero offset is checked for.
pub fn measuring(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    probe(inputs, control, found);
    mirror(control, found);
    lathe_length(inputs, control, found);
    memories(inputs, control, found);
    weighting(inputs, control, found);
    tolerances(inputs, found);
}

/// Probe number beyond the data fields `_WP[]` (`_CVAL[1]`, B:13346) or a type other than multi and mono.
pub fn probe(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    let Some(code) = inputs.given(names::PRNUM).map(|code| code as i64) else { return };
    let fields = match control.fields("_CVAL[1]") {
        0.0 => 3.0,
        fields => fields,
    };
    let (number, kind) = (code % 100, code / 100 % 10);
    if kind > 1 {
        found.push(refused(61313, "check-probe-type", names::PRNUM).number("type", kind as f64));
    }
    if number < 1 || number as f64 > fields {
        let finding = refused(61313, "check-probe-number", names::PRNUM).number("number", number as f64);
        found.push(finding.hint_number("fields", fields));
    }
    // no spindle turns the probe of a lathe
    let turned = kind == 1 && inputs.cycle.purpose.machine != MachineSort::Turning;
    if turned && !control.spindle_positions {
        found.push(refused(61373, "check-mono-spindle", names::PRNUM)); // A:15917
    }
    let offset = inputs.any(names::CORA).unwrap_or(0.0);
    if turned && offset != 0.0 && !control.bit("_CBIT[8]") {
        found.push(own::CORA_OFF.finding().at(names::CORA));
    }
}

/// Memories of mean and empirical values beyond the arrays (`_EVMVNUM`, B:13717), where an access would fail; a mean
/// value counts with tool offset alone (B:1307).
pub fn memories(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    let Some(code) = inputs.given(names::EVNUM).map(|code| code as i64) else { return };
    let Memories { empirical, mean } = mean::memories(code);
    let mean = if common::ZERO_OFFSET.holds(inputs) { 0 } else { mean };
    for (number, array, sentence) in
        [(empirical, "_EVMVNUM[0]", own::EMPIRICAL_MEMORY), (mean, "_EVMVNUM[1]", own::MEAN_MEMORY)]
    {
        let size = control.number(array);
        if number as f64 > size {
            let finding = sentence.finding().number("number", number as f64);
            found.push(finding.number("size", size).hint_text("array", array).at(names::EVNUM));
            return;
        }
    }
}

/// Order of the tolerance parameters: `_TLL` < `_TUL`; zero offset area inside the mean value range, band inside
/// `_TDIF` inside `_TSA` (B:1310-1394). Both tolerances count from their middle (B:2205).
pub fn tolerances(inputs: &Inputs, found: &mut Vec<Diagnostic>) {
    if let (Some(upper), Some(lower)) = (inputs.given(names::TUL), inputs.given(names::TLL)) {
        if upper < lower {
            found.push(own::TOLERANCE_ORDER.finding().number("upper", upper).number("lower", lower).at(names::TUL));
            return;
        }
        let half = (upper - lower) / 2.0;
        order(half, inputs.given(names::TDIF), own::BAND_DIFFERENCE, names::TDIF, found);
    }
    let given = |name| inputs.given(name);
    if let Some(low) = given(names::TZL) {
        order(low, given(names::TMV), own::ZERO_MEAN, names::TMV, found);
    }
    // that delivered with the control is nobody's wish
    let wished = inputs.written.contains(names::TDIF.as_str());
    if let Some(difference) = given(names::TDIF).filter(|_| wished) {
        order(difference, given(names::TSA), own::DIFFERENCE_SAFE, names::TSA, found);
    }
}

/// A warning when the second is smaller than the first.
fn order(small: f64, large: Option<f64>, sentence: Own, at: Name, found: &mut Vec<Diagnostic>) {
    if let Some(large) = large.filter(|large| *large < small) {
        found.push(sentence.finding().number("small", small).number("large", large).at(at));
    }
}

/// Whether the ball fits between the walls of a hole, groove or pocket of this size, mm; says so where it does not.
pub fn fits(name: Name, size: f64, ball: f64, found: &mut Vec<Diagnostic>) -> bool {
    let room = size > 2.0 * ball;
    if !room {
        found.push(own::BALL.finding().text("param", name).number("ball", 2.0 * ball).at(name));
    }
    room
}

/// Between two walls the start of the measuring block must not lie in the opposite wall (B:13743-13763).
pub fn across(inputs: &Inputs, name: Name, size: f64, ball: f64, found: &mut Vec<Diagnostic>) {
    let free = size - 2.0 * ball;
    if inputs.given(names::FA).is_some_and(|path| path >= free) {
        let finding = refused(61302, "check-path-long", names::FA).text("param", name).number("free", free);
        found.push(finding.hint_number("free", free));
    }
}

/// An infeed that does not lead down to the measuring height (B:5833: minus is down, for a probe on the plus side).
pub fn infeed(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    let up = |infeed: &f64| infeed * place::side(control) >= 0.0;
    if let Some(infeed) = inputs.given(names::ID).filter(up) {
        found.push(own::INFEED.finding().number("infeed", infeed).at(names::ID));
    }
}

/// A memory is named but the weighting says that no mean value is meant, or the reverse (B:2358-2366).
pub fn weighting(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    let weight = inputs.given(names::K).unwrap_or(1.0);
    let memory = inputs.given(names::EVNUM).unwrap_or(0.0);
    if weight > 1.0 && memory > 0.0 && !control.bit("_CHBIT[4]") {
        found.push(own::MEAN_OFF.finding().at(names::K));
    }
}

/// Mirrored axes, which these cycles bear only with MD10610 = 0 (B:4154, B:8709). The manual names no alarm.
pub fn mirror(control: &Control, found: &mut Vec<Diagnostic>) {
    if control.number("MD10610") != 0.0 && (0..3).any(|axis| control.mirrored(axis)) {
        found.push(own::MIRROR_DATUM.finding());
    }
}

/// A coordinate system that is turned (A:15873).
pub fn rotation(control: &Control, found: &mut Vec<Diagnostic>) {
    if control.rotated() {
        found.push(error(Code::Alarm(61330), Message::new("check-rotation")).hint(Message::new("check-rotation-hint")));
    }
}

/// Differential measurement turns the spindle under a multi probe (B:6308, B:7297-7299). Alarm 61313 is ours: the
/// manual names none.
pub fn differential(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    if !control.spindle_positions {
        found.push(refused(61372, "check-differential-spindle", names::MVAR)); // A:15916
    }
    if MONO.holds(inputs) {
        found.push(refused(61313, "check-differential-mono", names::PRNUM));
    }
}

/// Only a multi probe switches in all directions that are needed (B:7846-7848, B:8199-8201). The alarm is ours.
pub fn multi_probe(inputs: &Inputs, found: &mut Vec<Diagnostic>) {
    if MONO.holds(inputs) {
        found.push(refused(61313, "check-multi-probe", names::PRNUM));
    }
}

/// Global basic frames, named by this parameter, cannot take a rotation (B:1971).
pub fn takes_rotation(name: Name, inputs: &Inputs, found: &mut Vec<Diagnostic>) {
    let code = inputs.integer(name);
    if let Ok(Some(ZeroCode::Stored(Store::GlobalBasic(_)))) = knum::zero(code) {
        found.push(refused(61321, "check-knum-rotation", name).number("code", code as f64));
    }
}

/// On a lathe the length of a probe that is entered as a turning tool ends at the centre of the ball (B:5358, B:5480,
/// B:5818, B:6400, B:6871, B:7528, B:7836).
pub fn lathe_length(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    if TURNING.contains(&inputs.tool_type) && control.bit("_CBIT[14]") {
        found.push(own::LATHE_LENGTH.finding().at(names::PRNUM));
    }
}
