//! The ring gauge or bored hole in which the stylus is calibrated (C:158, C:187-189, C:299, C:317-319).

use super::walls::{across, travel};
use super::{FORMAT_ERROR, MACRO, OVERTRAVEL, checks, figures, overtravel, part};
use crate::catalogue::prelude::*;

/// A macro that calibrates in the ring; one without room for the ball is refused.
pub const CALIBRATION: Cycle = Cycle {
    checks: |inputs, control, findings| checks::room(inputs, address::D, control, findings),
    picture: Drawing::staged(stage, marks),
    ..MACRO
};

/// Diameter of the ring; a macro adds label, usual range and source.
pub const D: Param = Param {
    name: address::D,
    unit: Unit::ActiveLength,
    range: Range::POSITIVE,
    alarm: Some(FORMAT_ERROR),
    needs: ALWAYS_REQUIRED,
    ..PARAM
};

/// A value of the calibration: in the basic system of the machine (C:92-94).
pub const fn value(name: &'static str, key: &'static str, source: &'static str) -> ResultField {
    ResultField { name, key, when: When::Always, unit: Unit::BasicLength, source }
}

/// Coordinates of the spindle where the stylus is in the centre: middle between the walls in the first axis, and on
/// that line in the second. The stylus then is in the middle of the first axis.
pub fn centre(machine: &mut dyn Machine, inputs: &Inputs) -> Result<[f64; 2], Stop> {
    let [abscissa, ordinate, _] = machine.control().plane.axes();
    let first = middle(walls(machine, inputs, abscissa)?);
    travel(machine, abscissa, first)?;
    let second = middle(walls(machine, inputs, ordinate)?);
    Ok([first, second])
}

/// Both walls along one axis from where the machine stands; coordinates of the spindle. The limit (C:187) counts on
/// each side, so that a start as far off the centre as the manual allows (C:299) still reaches every wall; and for the
/// spindle, because the ball radius is not known yet.
pub fn walls(machine: &mut dyn Machine, inputs: &Inputs, axis: usize) -> Result<[f64; 2], Stop> {
    let reach = inputs.number(address::D) / 2.0 + overtravel(machine.control());
    let from = machine.position()[axis];
    across(machine, axis, [from + reach, from - reach])
}

fn middle([upper, lower]: [f64; 2]) -> f64 {
    (upper + lower) / 2.0
}

/// A ring whose upper face is the zero of the WCS, the stylus 10 mm deep in it.
pub fn propose(inputs: &Inputs, control: &Control) -> Proposal {
    let shape = Shape::Hole { diameter: inputs.positive(address::D, 50.0), depth: 30.0 };
    part::propose(shape, [0.0; 3], [0.0, 0.0, -10.0], control)
}

/// The ring in the size of the picture.
fn stage(inputs: &Inputs) -> Staging {
    Staging::new(Look::ABOVE, Fields { path: Some(address::D), ..Fields::MACRO }).sized(inputs, &[address::D])
}

/// Diameter of the ring, and limit of the search behind the walls.
fn marks(_: &Inputs, looks: &[Seen]) -> Vec<PictureShape> {
    let limit = |above: &Seen| above.bands(ShapeKind::Zone, &[(address::D, -OVERTRAVEL[0], 0.0)]);
    let all = |above: &Seen| [figures::axes(above), limit(above), vec![above.size(address::D, 0)]].concat();
    looks.iter().flat_map(all).collect()
}
