//! CYCLE800 with offsets 0: the table turns the part until the working plane of the active frames lies across the tool,
//! and the coordinate systems turn with it (B:7696-7786, B:7773-7782).

use super::contour;
use super::datum::Datum;
use super::interpret::Interpreter;
use super::statement::Call;
use crate::control::Frame;
use crate::geometry::V3;
use crate::geometry::rigid::{angles, rotation};
use crate::machine::Stop;
use crate::problem::Problem;
use crate::program::of_control::SWIVEL;

/// Argument with the name of the swivel data set, and the name by which none is meant.
const DATA_SET: usize = 1;
const NO_DATA_SET: &str = "0";

/// Arguments that shift or turn the plane: X0 Y0 Z0, three angles, X1 Y1 Z1.
const OFFSETS: std::ops::Range<usize> = 4..13;

/// Turns the table; the machine axes stay where they are. Data set, mode and direction choose between ways that end in
/// the same plane.
pub fn call(run: &mut Interpreter, call: &Call) -> Result<(), Stop> {
    contour::finish(run)?;
    if given_up(call) {
        run.sim.control.part_frame = Frame::default();
        return Ok(());
    }
    let (turns, table) = planned(run, call).map_err(|problem| run.fail(problem))?;
    for (axis, to) in turns.into_iter().enumerate() {
        if run.sim.control.rotary[axis] != to {
            let turned = run.sim.turn_table(axis, to);
            turned.map_err(|stop| run.stopped(stop, call.span))?;
        }
    }
    run.sim.control.part_frame = table;
    Ok(())
}

/// Whether the call gives the plane up: without values, or with the data set "0". The table stays where it is.
fn given_up(call: &Call) -> bool {
    let data_set = call.args.get(DATA_SET).and_then(Option::as_ref);
    let nothing = call.args.iter().all(Option::is_none);
    nothing || data_set == Some(&Datum::Text(NO_DATA_SET.into()))
}

/// Where the rotary axes go, degree, and the frame that turns with the table.
fn planned(run: &mut Interpreter, call: &Call) -> Result<([f64; 3], Frame), Problem> {
    let offsets = call.args.iter().enumerate();
    let mut offsets = offsets.filter(|(place, _)| OFFSETS.contains(place));
    let shifted = offsets.any(|(_, value)| !matches!(value, None | Some(Datum::Number(0.0))));
    if shifted || call.args.len() < 4 {
        return Err(Problem::new("run-swivel", call.span, SWIVEL));
    }
    let control = &mut run.sim.control;
    control.part_frame = Frame::default();
    let total = control.total_frame().ok_or_else(|| Problem::new("run-shear", call.span, SWIVEL))?;
    let turn = rotation(total.rotation).inverse();
    let centre = V3::from(control.rotary_centre);
    let table = Frame { coarse: (centre - turn * centre).into(), rotation: angles(&turn), ..Frame::default() };
    Ok((total.rotation, table))
}
