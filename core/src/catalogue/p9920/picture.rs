//! G65 P9920 drawn: at the left the disk from above, at the right from the side. Disk and tool stand for any size. What
//! the scene does not carry is drawn here: the tool from the side in each of its places, and the stem of the probe.

use super::{CALIBRATE, DIAMETER};
use crate::catalogue::prelude::*;

/// Radius of the disk, mm.
const DISK: f64 = 13.0;
/// Length of the drawn tool, mm.
const TOOL: f64 = 26.0;
/// Way down from the start, which is half of it above the disk, mm.
const DOWN: f64 = 18.0;
/// Place and size of the disk, its upper side at 0, and the length of the reference tool, mm.
const DATA: [(&str, f64); 5] = [("#506", TOOL), ("#507", 0.0), ("#508", 0.0), ("#509", 2.0 * DISK), ("#513", TOOL)];
/// Register of the drawn tool.
const REGISTER: f64 = 1.0;

/// The tool above the disk, which it touches as the variant does.
pub fn stage(inputs: &Inputs) -> Staging {
    let given = inputs.given(address::D).filter(|diameter| *diameter > 0.0);
    let radius = given.map_or(6.0, |diameter| (diameter / 2.0).clamp(3.0, 8.0));
    let over_centre = inputs.given(address::D) == Some(0.0) && inputs.variant == super::LENGTH;
    let fields = Fields { path: Some(address::F), probe: Some(address::T), edges: &[], ..Fields::MACRO };
    let above = Look { called: false, flat: true, ..Look::ABOVE };
    let side = Look { cut: false, balls: false, ..Look::section(0) }.ways(address::Z);
    // once in the abscissa, and above
    let touches = if inputs.variant == CALIBRATE { 0b1_0001 } else { u32::MAX };
    let data = DATA.map(|(name, value)| (name.to_owned(), value)).into();
    Staging { data, ..Staging::new(above, fields) }
        .ball(radius)
        .with(address::T, if inputs.variant == CALIBRATE { 0.0 } else { REGISTER })
        .with(address::Z, -DOWN)
        .with(address::D, if over_centre { 0.0 } else { 2.0 * radius })
        .with(address::E, inputs.number(address::E).clamp(2.0, 6.0))
        .with(address::K, lift(inputs))
        .beside(true, Look { called: false, flat: true, ..side }.touching(touches))
}

/// `K`, as far as it can be drawn.
fn lift(inputs: &Inputs) -> f64 {
    inputs.number(address::K).clamp(3.0, 6.0)
}

/// Diameter, ways, heights, and how the tool turns.
pub fn marks(inputs: &Inputs, looks: &[Seen]) -> Vec<PictureShape> {
    let [above, side] = looks else { return Vec::new() };
    let mut shapes = above.axes(above.middle(), [None; 2]).to_vec();
    shapes.extend(from_above(inputs, above));
    shapes.extend(from_the_side(inputs, side));
    shapes
}

/// The diameter of the tool beside the disk, where it sinks there, and how it turns.
fn from_above(inputs: &Inputs, above: &Seen) -> Vec<PictureShape> {
    let radius = above.ball;
    let centre = above.middle();
    let mut shapes = Vec::new();
    let beside = above.touches.iter().find(|touch| touch.start[0] > centre[0] + DISK);
    let tool = beside.or(above.touches.first()).map_or(centre, |touch| touch.start);
    let wide = [-radius, radius].map(|side| add(tool, [side, -1.5 * radius]));
    shapes.push(dimension(address::D, wide[0], wide[1]));
    if beside.is_some() {
        let below = tool[1] - 2.4 * radius;
        shapes.push(dimension(address::E, [centre[0] + DISK, below], [tool[0] - radius, below]));
    }
    if inputs.given(address::M).is_some_and(|turning| turning != 5.0) {
        let turn = if matches!(inputs.integer(address::M), 3 | 13) { -250.0 } else { 250.0 };
        let over = above.touches.first().map_or(centre, |touch| touch.start);
        shapes.extend(above.angle(address::M, over, radius * 1.25, [90.0, 90.0 + turn]));
    }
    shapes
}

/// The tool where it begins and where it touches the rim, and how deep it goes.
fn from_the_side(inputs: &Inputs, side: &Seen) -> Vec<PictureShape> {
    let radius = side.ball;
    let tool = |end: [f64; 2]| rectangle(ShapeKind::Probe, add(end, [0.0, TOOL / 2.0]), [2.0 * radius, TOOL]);
    let start = side.start;
    let left = start[0] - radius - 4.0;
    let middle = side.zero[0];
    let below = [middle, side.extent[0][1] - 6.0];
    let stem = rectangle(ShapeKind::Material, below, [6.0, 12.0]);
    let down = side.along(address::Z, 1, [start, add(start, [0.0, -DOWN])], left);
    let mut shapes = vec![stem, tool(start).of(address::T), down];
    let rim = side.touches.iter().find(|touch| touch.start[0] > middle + DISK);
    let Some(rim) = rim.map(|touch| touch.start) else { return shapes };
    shapes.push(tool(rim).of(address::D));
    let right = rim[0] + radius + 5.0;
    if inputs.variant == CALIBRATE {
        shapes.push(side.along(address::H, 1, [rim, add(rim, [0.0, TOOL])], right));
    }
    if inputs.variant == DIAMETER {
        let face = [middle, side.part[1][1]];
        let ends = [lift(inputs), -lift(inputs)].map(|lift| add(face, [0.0, lift]));
        shapes.push(side.along(address::K, 1, [ends[0], face], right));
        shapes.push(side.along(address::K, 1, [face, ends[1]], right));
    }
    shapes
}
