//! Fields of a solid of the part, and the solids that can be added.

use super::own::lengths;
use super::slot::{Held, Slot};
use crate::geometry::{Degrees, Mcs};
use crate::range::Range;
use crate::workpiece::{Shape, Solid, ToolProbe};

/// The solids that can be added, by the key of their names.
pub const SHAPES: &[(&str, Shape)] = &[
    ("setup-shape-hole", Shape::Hole { diameter: 50.0, depth: 20.0 }),
    ("setup-shape-shaft", Shape::Shaft { diameter: 50.0, height: 20.0 }),
    ("setup-shape-pocket", Shape::Pocket { length: [80.0, 50.0], depth: 20.0 }),
    ("setup-shape-island", Shape::Island { length: [80.0, 50.0], height: 20.0 }),
    ("setup-shape-groove", Shape::Groove { width: 40.0, depth: 20.0, length: 80.0 }),
    ("setup-shape-web", Shape::Web { width: 40.0, height: 20.0, length: 80.0 }),
    ("setup-shape-block", Shape::Block { size: [100.0, 100.0, 20.0] }),
    ("setup-shape-sphere", Shape::Sphere { diameter: 25.0 }),
    ("setup-shape-outer-corner", Shape::OuterCorner { angle: Degrees(90.0), length: [80.0, 80.0], height: 20.0 }),
    ("setup-shape-inner-corner", Shape::InnerCorner { angle: Degrees(90.0), length: [80.0, 80.0], depth: 20.0 }),
    ("setup-shape-turned", Shape::Turned { diameter: 60.0, length: 80.0, bore: [0.0, 0.0] }),
    ("setup-shape-chuck", Shape::Chuck { diameter: 160.0, length: 60.0, grip: 60.0 }),
];

/// The caps that a tool probe can have: a disc or a cube.
pub const CAPS: &[(&str, Shape)] = &[
    ("setup-shape-disc", Shape::Turned { diameter: 40.0, length: 10.0, bore: [0.0, 0.0] }),
    ("setup-shape-cube", Shape::Block { size: [20.0, 20.0, 20.0] }),
];

const AT: [&str; 3] = ["equip-at-x", "equip-at-y", "equip-at-z"];
const TURNED: [&str; 3] = ["equip-about-x", "equip-about-y", "equip-about-z"];
const SHIFT: [&str; 3] = ["equip-shift-x", "equip-shift-y", "equip-shift-z"];

/// Key of the name of a shape among these.
pub(super) fn named(shapes: &[(&'static str, Shape)], shape: &Shape) -> &'static str {
    let same = |other: &Shape| std::mem::discriminant(other) == std::mem::discriminant(shape);
    shapes.iter().find(|(_, other)| same(other)).map_or("setup-shape-surface", |(key, _)| key)
}

/// A new solid of one of these shapes, nominal, at the origin of the machine.
pub(super) fn new(shapes: &[(&str, Shape)], key: &str) -> Option<Solid> {
    let (_, shape) = shapes.iter().find(|(known, _)| *known == key)?;
    Some(Solid::new(shape.clone(), Mcs([0.0; 3])))
}

/// What a tool probe is, and how its signal comes.
pub(super) fn tool_probe(probe: &mut ToolProbe) -> Vec<Slot<'_>> {
    let ToolProbe { solid, pre_travel, delay, repeatability: (scatter, _) } = probe;
    let mut all = slots(solid);
    all.retain(|slot| !slot.key.starts_with("equip-bore")); // a cap has none
    all.push(Slot::new("equip-travel", Held::Length(pre_travel)));
    all.push(Slot::new("equip-scatter", Held::Length(scatter)).within(Range::NOT_NEGATIVE));
    all.push(Slot::new("equip-delay", Held::Plain(delay)));
    all
}

/// Sizes, place, angles, and what is wrong with it.
pub(super) fn slots(solid: &mut Solid) -> Vec<Slot<'_>> {
    let Solid { shape, at, rotation, errors } = solid;
    let mut all = sizes(shape);
    all.push(Slot::new("equip-size-error", Held::Length(&mut errors.size)));
    all.extend(lengths(AT, &mut at.0));
    let angles = TURNED.into_iter().zip(&mut rotation.0);
    all.extend(angles.map(|(key, angle)| Slot::new(key, Held::Degree(angle))));
    all.extend(lengths(SHIFT, &mut errors.shift));
    all
}

/// The sizes of a shape.
fn sizes(shape: &mut Shape) -> Vec<Slot<'_>> {
    let size = |key, value| Slot::new(key, Held::Length(value)).within(Range::POSITIVE);
    let bore = |key, value| Slot::new(key, Held::Length(value)).within(Range::NOT_NEGATIVE);
    let corner = |angle| Slot::new("equip-corner", Held::Angle(angle)).within(Range::closed(1.0, 179.0));
    match shape {
        Shape::Hole { diameter, depth } => vec![size("equip-diameter", diameter), size("equip-depth", depth)],
        Shape::Shaft { diameter, height } => vec![size("equip-diameter", diameter), size("equip-height", height)],
        Shape::Groove { width, depth, length } => {
            vec![size("equip-width", width), size("equip-length", length), size("equip-depth", depth)]
        }
        Shape::Web { width, height, length } => {
            vec![size("equip-width", width), size("equip-length", length), size("equip-height", height)]
        }
        Shape::Pocket { length: [x, y], depth } => {
            vec![size("equip-size-x", x), size("equip-size-y", y), size("equip-depth", depth)]
        }
        Shape::Island { length: [x, y], height } => {
            vec![size("equip-size-x", x), size("equip-size-y", y), size("equip-height", height)]
        }
        Shape::Block { size: [x, y, z] } => {
            vec![size("equip-size-x", x), size("equip-size-y", y), size("equip-height", z)]
        }
        Shape::Turned { diameter, length, bore: [inside, depth] } => vec![
            size("equip-diameter", diameter),
            size("equip-length", length),
            bore("equip-bore", inside),
            bore("equip-bore-depth", depth),
        ],
        Shape::Chuck { diameter, length, grip } => {
            vec![size("equip-diameter", diameter), size("equip-length", length), size("equip-grip", grip)]
        }
        Shape::Sphere { diameter } => vec![size("equip-diameter", diameter)],
        Shape::OuterCorner { angle, length: [x, y], height } => {
            vec![corner(angle), size("equip-size-x", x), size("equip-edge", y), size("equip-height", height)]
        }
        Shape::InnerCorner { angle, length: [x, y], depth } => {
            vec![corner(angle), size("equip-size-x", x), size("equip-edge", y), size("equip-depth", depth)]
        }
        Shape::Free(_) => Vec::new(),
    }
}
