//! Axes that the setup does not name (`V10`, `W=IC(5)`, `X1=20`): each is taken into the machine of the run, which is
//! one note. They move nothing that is simulated; a program reads where they stand.

use super::{Address, Interpreter, addresses::number, noted};
use crate::control::Value;
use crate::problem::Problem;

/// Letters of such axes; those of X, Y and Z only with a number behind them.
const LETTERS: [&str; 8] = ["A", "B", "C", "E", "Q", "U", "V", "W"];
const NUMBERED: [&str; 3] = ["X", "Y", "Z"];
/// Rotary ones: their positions have no unit of length.
const TURNING: [char; 3] = ['A', 'B', 'C'];
/// Where a program reads a position: machine, basic, workpiece, programmed.
const POSITIONS: [&str; 4] = ["$AA_IM", "$AA_IB", "$AA_IW", "$P_EP"];

/// Whether a name with its number is one of an axis that no setup has to name: `V`, `X1`.
pub fn is_name(name: &str) -> bool {
    let letter = name.trim_end_matches(|digit: char| digit.is_ascii_digit());
    LETTERS.contains(&letter) || NUMBERED.contains(&letter) && letter.len() < name.len()
}

/// Whether an address is a component of the direction of a tool or a surface: `A3=0 B3=0 C3=1`, up to `C7`.
fn is_direction(address: &Address) -> bool {
    TURNING.iter().any(|letter| address.name.starts_with(*letter)) && matches!(address.extension, Some(3..=7))
}

/// Moves such an axis; false: the address is none.
pub fn take(run: &mut Interpreter, address: &Address) -> Result<bool, Problem> {
    let name = match address.extension {
        Some(number) => format!("{}{number}", address.name),
        None => address.name.clone(),
    };
    if run.program.grammar().by_address || !is_name(&name) {
        return Ok(false);
    }
    if is_direction(address) {
        number(address)?;
        noted::without(run, "run-passed", address.span, &name);
        return Ok(true);
    }
    let control = &run.sim.control;
    let length = if name.starts_with(TURNING) { 1.0 } else { control.active_factor() / control.data_factor() };
    let written = number(address)? * length;
    let adds = match address.mode.as_deref() {
        Some(mode) => ["IC", "CIC"].contains(&mode),
        None => !run.modal.absolute,
    };
    let stands = control.number(&key(POSITIONS[0], &name));
    let position = if adds { stands + written } else { written };
    for stem in POSITIONS {
        run.sim.control.data.insert(key(stem, &name), Value::Number(position));
    }
    noted::add(run, "run-axes", address.span, &name);
    Ok(true)
}

fn key(stem: &str, axis: &str) -> String {
    format!("{stem}[{axis}]")
}
