//! Programmed frames: TRANS, ROT, SCALE replace what was programmed before, ATRANS, AROT, ASCALE add to it.

use super::interpret::Interpreter;
use super::problem::Problem;
use super::statement::{Call, Words};
use crate::control::Frame;
use crate::diagnostic::Severity;

/// Whether a word begins a frame instruction.
pub fn is_frame(name: &str) -> bool {
    matches!(
        name,
        "TRANS" | "ATRANS" | "ROT" | "AROT" | "MIRROR" | "AMIRROR" | "SCALE" | "ASCALE"
    )
}

/// Carries out a frame instruction with the axis words of its block.
pub fn apply(run: &mut Interpreter, call: &Call, found: &Words) -> Result<(), Problem> {
    let values = found
        .path
        .axes
        .map(|axis| axis.map_or(0.0, |(value, _)| value));
    let before = run.sim.control.program_frame;
    let own = match call.name.as_str() {
        "TRANS" | "ATRANS" => Frame::translation(values),
        "ROT" | "AROT" => rotated(run, found),
        "SCALE" | "ASCALE" => scaled(run, found),
        name => {
            run.tell(
                Severity::Error,
                &Problem::new("run-not-simulated", call.span, name),
            );
            return Ok(());
        }
    };
    let adds = call.name.starts_with('A');
    if adds && !before.chains_with(&own) {
        return Err(Problem::new("run-shear", call.span, &*call.name));
    }
    run.sim.control.program_frame = if adds { before.then(&own) } else { own };
    Ok(())
}

/// Factors are no lengths either; an axis that is not named keeps its size.
fn scaled(run: &Interpreter, found: &Words) -> Frame {
    let factor = run.sim.control.active_factor();
    let scale = found
        .path
        .axes
        .map(|axis| axis.map_or(1.0, |(value, _)| value / factor));
    Frame {
        scale,
        ..Frame::default()
    }
}

/// Angles are no lengths: the unit of the axis words is taken out again. RPL turns about the applicate.
fn rotated(run: &Interpreter, found: &Words) -> Frame {
    let factor = run.sim.control.active_factor();
    let mut rotation = found
        .path
        .axes
        .map(|axis| axis.map_or(0.0, |(value, _)| value / factor));
    if let Some(turn) = found.turn {
        rotation[run.sim.tool_axis()] = turn;
    }
    Frame {
        rotation,
        ..Frame::default()
    }
}
