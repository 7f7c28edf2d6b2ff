//! What is measured, whatever a control calls it: by these tasks a call of one control is found again on the other.

use super::{Inputs, When};
use crate::name::Name;

/// A task that another control has too.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Task {
    /// Bore: diameter and centre.
    Bore,
    /// Boss, shaft: diameter and centre.
    Boss,
    /// Pocket, groove: width and middle.
    Pocket,
    /// Web: width and middle.
    Web,
    /// Inside rectangle: sides and middle.
    Rectangle,
    /// Outside rectangle: sides and middle.
    Island,
    /// Surface across an axis of the plane.
    Wall,
    /// Surface across the axis of the tool.
    Face,
    /// Corner inside.
    InnerCorner,
    /// Corner outside.
    OuterCorner,
    /// Angle of an edge.
    Angle,
    /// Calibrates the ball in a ring.
    Ball,
    /// Calibrates the length of the probe.
    Length,
}

impl Task {
    /// Key of its name.
    pub fn key(self) -> &'static str {
        match self {
            Task::Bore => "task-bore",
            Task::Boss => "task-boss",
            Task::Pocket => "task-pocket",
            Task::Web => "task-web",
            Task::Rectangle => "task-rectangle",
            Task::Island => "task-island",
            Task::Wall => "task-wall",
            Task::Face => "task-face",
            Task::InnerCorner => "task-inner-corner",
            Task::OuterCorner => "task-outer-corner",
            Task::Angle => "task-angle",
            Task::Ball => "task-ball",
            Task::Length => "task-length",
        }
    }

    /// Keys of what the controls do differently in it, whatever the values are.
    pub fn differences(self) -> &'static [&'static str] {
        match self {
            Task::InnerCorner | Task::OuterCorner => &["twin-corner"],
            Task::Ball => &["twin-ball"],
            Task::Length => &["twin-length"],
            _ => &[],
        }
    }
}

/// What a value means to both controls.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Meaning {
    /// Set value: diameter, width, or coordinate of a surface.
    Nominal,
    /// Set length of a rectangle along the abscissa.
    FirstSide,
    /// Set length of a rectangle along the ordinate.
    SecondSide,
    /// Number of the axis of the plane across which is measured: 1, 2, or 3 for that of the tool.
    Axis,
    /// The set value, in an address that says the axis: X, Y or Z. Where a boss or web is measured, that of the axis of
    /// the tool is the depth.
    NominalInAxis,
    /// Way from the start down to the depth, negative.
    Infeed,
    /// Coordinate of a corner, in an address that says the axis.
    CornerInAxis,
    /// Where the zero lies from a corner: 1 there, 2 beside it along the abscissa, 3 along both axes, 4 along the
    /// ordinate.
    ZeroAtCorner,
    /// Angle between the abscissa and the first edge of a corner, degree.
    EdgeAngle,
    /// How far the zero lies from the corner along the abscissa.
    ZeroAbscissa,
    /// Zero point along the ordinate.
    ZeroOrdinate,
    /// Upper limit of the deviation.
    Upper,
    /// Lower limit of the deviation.
    Lower,
    /// Half of the tolerance about the set value.
    Half,
    /// Deviation from which nothing is corrected.
    Limit,
    /// How far past the set place the surface is looked for.
    Reach,
    /// Zero offset that is corrected: 1 is G54.
    Zero,
    /// Tool that is corrected.
    Tool,
}

/// A task of a cycle, for some of its variants.
pub struct Shared {
    /// What is measured.
    pub task: Task,
    /// The calls that do it.
    pub when: When,
    /// The variant that is written for it.
    pub variant: i64,
    /// Whether these variants correct a tool; none: the values decide.
    pub tool: Option<bool>,
    /// What its parameters mean.
    pub values: &'static [(Name, Meaning)],
}

impl Shared {
    /// The value of the parameter with this meaning, where a call gives it.
    pub fn given(&self, meaning: Meaning, inputs: &Inputs) -> Option<f64> {
        let (name, _) = self.values.iter().find(|(_, other)| *other == meaning)?;
        inputs.given(*name)
    }
}
