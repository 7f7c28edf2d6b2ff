//! Programmed frames: TRANS, ROT, SCALE, MIRROR replace what was programmed before, their forms with A add to it.
//! Angles and factors are no lengths: the unit of the axis words is taken out again.

use super::{Call, Interpreter, Words};
use crate::control::Frame;
use crate::geometry::Rpy;
use crate::problem::Problem;
use crate::program::of_control::is_frame;

/// `G58 X10`: the translation of the programmed frame along the axes that are written; `G59 X0.1`: its fine part.
fn shifted(run: &mut Interpreter, found: &Words) -> bool {
    let shift = |code: f64| found.function("G", code).is_some();
    let (coarse, fine) = (shift(58.0), shift(59.0));
    let frame = &mut run.sim.control.program_frame;
    for (axis, written) in found.path.axes.iter().enumerate() {
        match written {
            Some(written) if coarse => frame.coarse[axis] = written.value,
            Some(written) if fine => frame.fine[axis] = written.value,
            _ => {}
        }
    }
    coarse || fine
}

/// Carries out the frame instruction of a block with its axis words; false: there is none.
pub fn applied(run: &mut Interpreter, found: &Words) -> Result<bool, Problem> {
    let calls: Vec<&Call> = found.calls.iter().filter(|call| is_frame(&call.name)).collect();
    match calls[..] {
        [] => Ok(!run.program.grammar().numbered && shifted(run, found)),
        [call] => apply(run, call, found).map(|()| true),
        [call, ..] => Err(Problem::new("run-alone", call.span, &*call.name)),
    }
}

fn apply(run: &mut Interpreter, call: &Call, found: &Words) -> Result<(), Problem> {
    let values = found.path.axes.map(|axis| axis.map(|axis| axis.value));
    let factor = run.sim.control.active_factor();
    let before = run.sim.control.program_frame;
    let own = match call.name.trim_start_matches('A') {
        "TRANS" => Frame::translation(values.map(|value| value.unwrap_or(0.0))),
        "ROT" => rotated(run, found, values.map(|value| value.unwrap_or(0.0) / factor)),
        "SCALE" => Frame { scale: values.map(|value| value.map_or(1.0, |value| value / factor)), ..Frame::default() },
        _ => Frame { mirror: values.map(|value| value.is_some()), ..Frame::default() },
    };
    if own.scale.contains(&0.0) {
        return Err(Problem::new("run-range", call.span, &*call.name));
    }
    let adds = call.name.starts_with('A');
    if adds && !before.chains_with(&own) {
        return Err(Problem::new("run-shear", call.span, &*call.name));
    }
    run.sim.control.program_frame = if adds { before.then(&own) } else { own };
    Ok(())
}

/// Angles of the axis words; RPL turns about the applicate.
fn rotated(run: &Interpreter, found: &Words, mut rotation: [f64; 3]) -> Frame {
    if let Some(turn) = found.turn {
        rotation[run.sim.tool_axis()] = turn;
    }
    Frame { rotation: Rpy(rotation), ..Frame::default() }
}
