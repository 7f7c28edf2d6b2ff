//! What a scan is sent as: an NC program, which cuts the surface with a cutter of the size of the ball (C:1262-1275),
//! or lines X Y Z. The manual prints no block layout; DESIGN.md says how ours was chosen.

use super::{Cloud, Layout};
use std::fmt::Write;
use std::ops::Range;

/// A way to write a scan.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "ScanText", rename_all = "lowercase"))]
pub enum Form {
    /// Program of the control, in the units active at the call.
    Program,
    /// Points as sent, mm.
    Points,
    /// Points of the surface under the ball, mm.
    Surface,
}

/// All of them, by name.
pub const FORMS: [(&str, Form); 3] = [("program", Form::Program), ("points", Form::Points), ("surface", Form::Surface)];

const NAMES: [&str; 3] = ["X", "Y", "Z"];

/// The text of these points, with its beginning at the first, its end at the last; pieces in turn are the whole text.
pub fn piece(cloud: &Cloud, layout: &Layout, form: Form, points: Range<usize>) -> String {
    let points = points.start..points.end.min(cloud.points().len());
    match form {
        Form::Program => program(cloud, layout, points),
        Form::Points => lines(points.filter_map(|index| cloud.points().get(index).copied())),
        Form::Surface => lines(points.map(|index| cloud.surface(layout, index).into())),
    }
}

fn lines(points: impl Iterator<Item = [f64; 3]>) -> String {
    let mut text = String::new();
    for [x, y, z] in points {
        for (value, behind) in [(x, ' '), (y, ' '), (z, '\n')] {
            fixed(steps(value, 4), 4, &mut text);
            text.push(behind);
        }
    }
    text
}

fn program(cloud: &Cloud, layout: &Layout, points: Range<usize>) -> String {
    let mut text = String::new();
    if points.start == 0 {
        head(cloud, layout, &mut text);
    }
    for index in points.clone() {
        block(cloud, layout, index, &mut text);
    }
    if points.end == cloud.points().len() && !points.is_empty() {
        let [.., axial] = layout.axes;
        let _ = writeln!(text, "G0 {}{}", NAMES[axial], number(layout.height, layout));
        text.push_str("M30\n%\n");
    }
    text
}

/// Number, what it is, plane and units, and the way to the first point.
fn head(cloud: &Cloud, layout: &Layout, text: &mut String) {
    let [along, across, axial] = layout.axes;
    text.push_str("%\n");
    if let Some(number) = layout.number {
        let _ = writeln!(text, "O{number:04}");
    }
    let ball = number(2.0 * layout.radius, layout);
    let (points, lines) = (cloud.points().len(), cloud.lines());
    let _ = writeln!(text, "(SCANNED {points} POINTS {lines} LINES BALL {ball})");
    let units = if layout.per == 1.0 { 21 } else { 20 };
    let _ = writeln!(text, "{:?} G{units} G90", layout.plane);
    if let Some(first) = cloud.points().first() {
        let at = |axis: usize| format!("{}{}", NAMES[axis], number(first[axis], layout));
        let safe = number(layout.height, layout);
        let _ = writeln!(text, "G0 {}{safe}", NAMES[axial]);
        let _ = writeln!(text, "G0 {} {}", at(along), at(across));
        let feed = number(layout.rate, layout);
        let _ = writeln!(text, "G1 {} F{feed}", at(axial));
    }
}

/// The axes that have moved since the point before.
fn block(cloud: &Cloud, layout: &Layout, index: usize, text: &mut String) {
    let points = cloud.points();
    let before = index.checked_sub(1).and_then(|before| points.get(before));
    let (Some(before), Some(point)) = (before, points.get(index)) else { return };
    let decimals = decimals(layout);
    let mut blank = "";
    for axis in layout.axes {
        let [here, there] = [point, before].map(|at| steps(at[axis] / layout.per, decimals));
        if here != there {
            text.push_str(blank);
            text.push_str(NAMES[axis]);
            fixed(here, decimals, text);
            blank = " ";
        }
    }
    if !blank.is_empty() {
        text.push('\n');
    }
}

fn number(value: f64, layout: &Layout) -> String {
    let (decimals, mut text) = (decimals(layout), String::new());
    fixed(steps(value / layout.per, decimals), decimals, &mut text);
    text
}

/// Usual resolution of a layout: 0.001 mm, 0.0001 inch.
fn decimals(layout: &Layout) -> u32 {
    if layout.per == 1.0 { 3 } else { 4 }
}

/// A number in steps of its last decimal.
fn steps(value: f64, decimals: u32) -> i64 {
    (value * 10_f64.powi(decimals as i32)).round() as i64
}

/// Writes a number of steps with so many decimals: twice as quick as the standard library, for millions of numbers.
fn fixed(steps: i64, decimals: u32, text: &mut String) {
    let sign = if steps < 0 { "-" } else { "" };
    let (unit, steps) = (10_u64.pow(decimals), steps.unsigned_abs());
    let (whole, part) = (steps / unit, steps % unit);
    let _ = write!(text, "{sign}{whole}.{part:0width$}", width = decimals as usize);
}

#[cfg(test)]
mod tests {
    use super::*;

    // oracle: hand
    #[test]
    fn numbers_have_their_decimals() {
        for (value, decimals, written) in [
            (0.0, 3, "0.000"),
            (-0.0004, 3, "0.000"),
            (-0.0006, 3, "-0.001"),
            (12.3456, 3, "12.346"),
            (-1.5, 4, "-1.5000"),
            (1_000_000.25, 4, "1000000.2500"),
        ] {
            let mut text = String::new();
            fixed(steps(value, decimals), decimals, &mut text);
            assert_eq!(text, written);
        }
    }
}
