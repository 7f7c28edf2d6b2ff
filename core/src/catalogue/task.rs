//! What is measured, whatever a control calls it: by these tasks a call of one control is found again on the other.

use super::When;

/// A task that both controls have.
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
    /// Surface across an axis of the plane.
    Wall,
    /// Surface across the axis of the tool.
    Face,
    /// Corner inside.
    InnerCorner,
    /// Corner outside.
    OuterCorner,
    /// Calibrates the ball in a ring.
    Ball,
    /// Calibrates the length of the probe.
    Length,
}

/// All tasks.
pub const TASKS: [Task; 10] = [
    Task::Bore,
    Task::Boss,
    Task::Pocket,
    Task::Web,
    Task::Wall,
    Task::Face,
    Task::InnerCorner,
    Task::OuterCorner,
    Task::Ball,
    Task::Length,
];

impl Task {
    /// Keys of what the controls do differently in it, whatever the values are.
    pub fn differences(self) -> &'static [&'static str] {
        match self {
            Task::Boss | Task::Web => &["twin-depth"],
            Task::InnerCorner | Task::OuterCorner => &["twin-corner"],
            Task::Ball => &["twin-ball"],
            Task::Length => &["twin-length"],
            Task::Bore | Task::Pocket | Task::Wall | Task::Face => &[],
        }
    }
}

/// What a value means to both controls.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Meaning {
    /// Set value: diameter, width, or coordinate of a surface.
    Nominal,
    /// Number of the axis of the plane across which is measured: 1, 2, or 3 for that of the tool.
    Axis,
    /// The set value, in an address that says the axis: X, Y or Z.
    NominalInAxis,
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
    pub values: &'static [(&'static str, Meaning)],
}
