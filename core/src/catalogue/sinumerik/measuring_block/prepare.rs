//! What a measuring block takes from parameters and data, and what must be true before the first motion.

use super::{Spindle, on_machine, turnable};
use crate::catalogue::common::MONO;
use crate::catalogue::prelude::*;
use crate::catalogue::sinumerik::{calibrated_as, state};
use crate::control::braking::measuring_feed;
use crate::geometry::TOLERANCE;

impl Block {
    /// Reads parameters and data and checks what must be true before the first motion (sequence of B:4147-4157).
    pub fn prepare(machine: &mut dyn Machine, inputs: &Inputs) -> Result<Block, Stop> {
        let block = read(machine.control(), inputs).map_err(|number| alarm(machine, number))?;
        if let Some(angle) = follow_rotation(machine.control(), inputs) {
            turnable(machine)?;
            machine.orient(angle);
        }
        Ok(block)
    }

    /// A block for the tool in use before a tool probe: what is touched lies where the position of the tool says, and
    /// the spindle is left alone. The path has no sign.
    pub fn for_tool(machine: &mut dyn Machine, inputs: &Inputs) -> Result<Block, Stop> {
        let control = machine.control();
        let block = state::with_edge(control).and_then(|_| common(control, inputs, inputs.number(names::FA).abs()));
        block.map_err(|number| alarm(machine, number))
    }
}

/// What does not depend on what touches; error: number of the alarm.
fn common(control: &Control, inputs: &Inputs, path: f64) -> Result<Block, u32> {
    if path <= 0.0 {
        return Err(61308);
    }
    let monitored = control.bit("_CHBIT[2]");
    let (feed_plane, feed_depth) = speeds(control, monitored)?;
    Ok(Block {
        axes: control.plane.axes(),
        radius: control.active_radius(),
        path,
        centre: 0.0,
        triggers: [[0.0; 2]; 3],
        skew: [0.0; 2],
        ball: 0.0,
        other: false,
        feed: measuring_feed(inputs.number(names::VMS), path),
        fast: (control.bit("_CHBIT[17]") && path > 1.0).then(|| control.basic_length("_SPEED[3]")),
        attempts: if control.bit("_CHBIT[15]") { 1 } else { 5 },
        repeats: u32::try_from(inputs.integer(names::NMSP)).unwrap_or(1).max(1),
        monitored,
        feed_plane,
        feed_depth,
        rapid_retract: control.bit("_CHBIT[16]"),
        spindle: Spindle::Stays,
    })
}

/// Everything from parameters and data; error: number of the alarm.
fn read(control: &Control, inputs: &Inputs) -> Result<Block, u32> {
    state::fit(control, inputs.cycle.purpose.machine)?;
    let (index, mono) = probe(control, inputs)?;
    let common = common(control, inputs, inputs.number(names::FA))?;
    let data = |i: usize| control.basic_length(&format!("_WP[{index},{i}]"));
    // The data were found in machine directions: in a mirrored axis plus is their minus.
    let sense = common.axes.map(|axis| if control.mirrored(axis) { -1.0 } else { 1.0 });
    let triggers = std::array::from_fn(|i| {
        let [minus, plus] = [data(2 * i + 1), data(2 * i + 2)];
        if sense[i] > 0.0 { [minus, plus] } else { [-plus, -minus] }
    });
    let spindle = match (mono, control.bit("_CBIT[8]")) {
        (false, _) => Spindle::Stays,
        (true, false) => Spindle::Follows(Degrees(0.0)),
        (true, true) => Spindle::Follows(inputs.degrees(names::CORA)),
    };
    Ok(Block {
        centre: if control.bit("_CBIT[14]") && !turning(inputs) { common.radius * sense[2] } else { 0.0 },
        triggers,
        // The skew of a mono probe turns with the spindle, so that it is not carried over.
        skew: if mono { [0.0; 2] } else { [data(7) * sense[0], data(8) * sense[1]] },
        ball: data(0) / 2.0,
        other: calibrated_as::differs(control, inputs),
        spindle,
        ..common
    })
}

/// Index of the probe's data field `_WP[]`, and whether it is a mono probe, which has to be turned (A:15852, A:15917).
fn probe(control: &Control, inputs: &Inputs) -> Result<(i64, bool), u32> {
    let number = inputs.integer(names::PRNUM);
    // In a turret a mono probe is used as a multi probe (B:2277).
    let (mono, field) = (MONO.holds(inputs) && !turning(inputs), number % 100);
    if field < 1 || field as f64 > control.fields("_CVAL[1]") {
        return Err(61313);
    }
    if mono && !control.spindle_positions {
        return Err(61373);
    }
    Ok((field - 1, mono))
}

/// Whether the probe is in the turret of a turning machine, where no spindle turns it.
fn turning(inputs: &Inputs) -> bool {
    inputs.cycle.purpose.machine == MachineSort::Turning
}

/// Speeds of monitored positioning in the plane and in the applicate, mm/min (B:13732-13733, A:15879-15880).
fn speeds(control: &Control, monitored: bool) -> Result<(f64, f64), u32> {
    if control.number("_SPEED[0]") < 0.0 {
        return Err(61339);
    }
    let (plane, depth) = (control.basic_length("_SPEED[1]"), control.basic_length("_SPEED[2]"));
    if monitored && (plane == 0.0 || depth == 0.0) {
        return Err(61338);
    }
    Ok((plane, depth))
}

/// With `_CHBIT[13]` a multi probe turns with the coordinate system: 90 degree of rotation about the applicate, and
/// only about it, give 270 degree (with `_CHBIT[14]` 90) of the spindle (B:13973-13987). What frames mirror is not
/// turned: the data of the probe take the other direction there.
fn follow_rotation(control: &Control, inputs: &Inputs) -> Option<Degrees> {
    let asked = !turning(inputs) && control.bit("_CHBIT[13]") && !MONO.holds(inputs);
    if asked { follow(control) } else { None }
}

/// Position of a spindle that follows the rotation of the WCS about the applicate; none where it turns otherwise too.
pub fn follow(control: &Control) -> Option<Degrees> {
    let [abscissa, _, applicate] = control.plane.axes();
    // the frames as a whole: those of a swivelled plane lean, and the one of its table leans back
    let along = V3::ith(applicate, if control.mirrored(applicate) { -1.0 } else { 1.0 });
    let up = V3::from(control.direction_to_machine(V3::ith(applicate, 1.0).into()));
    if (up.normalize() - along).norm() > TOLERANCE {
        return None;
    }
    let rotation = on_machine(control, Degrees(if control.mirrored(abscissa) { 180.0 } else { 0.0 }));
    Some(followed(control, rotation))
}

/// Where a spindle stands that follows a rotation (`_CHBIT[14]`, B:13983-13987).
pub fn followed(control: &Control, rotation: Degrees) -> Degrees {
    let angle = if control.bit("_CHBIT[14]") { rotation } else { -rotation };
    angle.positive()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::control::{Frame, Plane};
    use crate::dialect::Dialect;
    use crate::geometry::{Rpy, rigid};
    use crate::machine::Setup;

    // oracle: manual B:13979-13985; hand: a frame that leans back leaves the 3 degree of the other
    #[test]
    fn a_spindle_follows_what_the_frames_turn_as_a_whole() {
        let mut control = Setup::calibrated(Dialect::Sinumerik, Plane::G17).control;
        let turned = |rotation| Frame { rotation, ..Frame::default() };
        control.frames.insert(1, turned(Rpy([0.0, 10.0, 3.0])));
        control.activate(1);
        assert_eq!(follow(&control), None);
        let back = [Rpy([0.0, 0.0, 3.0]), Rpy([0.0, 10.0, 3.0])].map(rigid::rotation);
        control.part_frame = turned(rigid::angles(&(back[0] * back[1].inverse())));
        let angle = follow(&control).map_or(f64::NAN, |angle| angle.0);
        assert!((angle - 357.0).abs() < 1e-9, "{angle}");
    }
}
