//! Programmed frames: TRANS, ATRANS, ROT, AROT. TRANS and ROT replace what was programmed before, the A forms add to it.

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
    let frame = match call.name.as_str() {
        "TRANS" => Frame::translation(values),
        "ATRANS" => before.then(&Frame::translation(values)),
        "ROT" => rotated(run, found),
        "AROT" => before.then(&rotated(run, found)),
        name => {
            run.tell(
                Severity::Error,
                &Problem::new("run-not-simulated", call.span, name),
            );
            before
        }
    };
    run.sim.control.program_frame = frame;
    Ok(())
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
