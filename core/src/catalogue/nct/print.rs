//! Lines of the print-out, in the manual's columns (C:1103-1116).

use super::correct::Found;
use super::{PRINT_ENABLED, axis_name};
use crate::catalogue::prelude::*;

/// Four decimals, no zero before the point, a blank after the minus sign: `.7810`, `- 15.0000`.
pub fn number(value: f64) -> String {
    let digits = format!("{:.4}", value.abs());
    let digits = digits.strip_prefix('0').unwrap_or(&digits);
    if value < 0.0 && digits != ".0000" { format!("- {digits}") } else { digits.into() }
}

/// Header of the print-out of dimensions.
const DIMENSION_HEADER: [&str; 2] =
    ["TOOL       NOMINAL    TOLERANCE  DEVIATION", "OFFSET NO  DIMENSION             FROM NOMINAL"];

/// Header of the print-out of positions.
const POSITION_HEADER: [&str; 2] = ["WORK       NOMINAL    DEVIATION", "OFFSET NO  POSITION   FROM NOMINAL"];

/// Data line of a dimension: register corrected by T, nominal, tolerance H, deviation, in the active unit.
pub fn dimension(register: Option<i64>, nominal: f64, tolerance: Option<f64>, deviation: f64) -> String {
    let register = register.map_or(String::new(), |register| format!("D {register}"));
    let tolerance = tolerance.map_or(String::new(), number);
    format!("{register:<11}{:<11}{tolerance:<11}{}", number(nominal), number(deviation))
}

/// Data line of a position: work offset corrected by S, nominal, deviation, in the active unit. `axis` is empty where
/// one axis was measured (C:1107, C:955).
pub fn position(offset: Option<i64>, axis: &str, nominal: f64, deviation: f64) -> String {
    let offset = offset.map_or(String::new(), |offset| offset.to_string());
    let nominal = format!("{axis} {}", number(nominal));
    let nominal = nominal.trim_start();
    format!("{offset:<11}{nominal:<11}{}", number(deviation))
}

/// Prints by V and W, unless the machine has printing switched off (C:60, C:1100-1116): the dimension between two
/// walls, and the places.
pub fn print(machine: &mut dyn Machine, inputs: &Inputs, found: &Found) {
    let control = machine.control();
    if control.data.contains_key(PRINT_ENABLED) && !control.bit(PRINT_ENABLED) {
        return;
    }
    for line in lines(inputs, found, control.active_factor()) {
        machine.record(Step::Log { text: line });
    }
}

fn lines(inputs: &Inputs, found: &Found, per: f64) -> Vec<String> {
    let whole = |name: Name| inputs.given(name).map(|number| number as i64);
    let mut lines: Vec<String> = Vec::new();
    if let Some(nominal) = found.size {
        if whole(address::V) == Some(2) {
            lines.extend(DIMENSION_HEADER.map(String::from));
        }
        if inputs.integer(address::V) > 0 {
            let tolerance = inputs.given(address::H).map(|limit| limit / per);
            lines.push(dimension(whole(address::T), nominal / per, tolerance, found.deviation / per));
        }
    }
    if whole(address::W) == Some(2) {
        lines.extend(POSITION_HEADER.map(String::from));
    }
    if inputs.integer(address::W) > 0 {
        let named = found.places.len() > 1;
        lines.extend(found.places.iter().map(|place| {
            let axis = if named { axis_name(place.axis).as_str() } else { "" };
            position(whole(address::S), axis, place.nominal / per, place.deviation / per)
        }));
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    // oracle: manual C:1103-1116, with the minus signs that the scan lost
    #[test]
    fn lines_as_printed() {
        let line = dimension(Some(4), 51.57, Some(0.02), -0.014);
        assert_eq!(line, "D 4        51.5700    .0200      - .0140");
        assert_eq!(dimension(Some(3), 30.0, None, -0.77), "D 3        30.0000               - .7700");
        assert_eq!(position(Some(6), "X", 0.0, 0.0016), "6          X .0000    .0016");
        assert_eq!(position(Some(6), "Y", 0.0, -0.0006), "6          Y .0000    - .0006");
        assert_eq!(position(Some(3), "", -15.0, 0.781), "3          - 15.0000  .7810");
        assert_eq!(number(-15.0), "- 15.0000");
        assert_eq!(number(-0.00001), ".0000");
    }
}
