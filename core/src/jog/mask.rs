//! The shape of a mask: which function it belongs to, how often is touched, its fields and what it shows, in the order
//! of the control.

use super::help::Line;

/// A function of measuring in JOG, with its masks: one, or one for holes and one for spigots, which the softkeys keep
/// apart.
#[derive(Debug)]
pub struct Function {
    /// Name, with which its words begin: `jog-function-…`.
    pub name: &'static str,
    /// Its masks.
    pub masks: &'static [Mask],
}

/// A softkey of the vertical bar (B:2722-2728), and Measure tool beside Measure workpiece (B:2616-2643).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Area {
    /// Edge.
    Edge,
    /// Corner.
    Corner,
    /// Pocket/hole.
    Hole,
    /// Spigot.
    Spigot,
    /// Align plane.
    Plane,
    /// Calibrate probe.
    Calibrate,
    /// Measure tool.
    Tool,
}

impl Area {
    /// Key of its words.
    pub fn key(self) -> &'static str {
        match self {
            Area::Edge => "jog-area-edge",
            Area::Corner => "jog-area-corner",
            Area::Hole => "jog-area-hole",
            Area::Spigot => "jog-area-spigot",
            Area::Plane => "jog-area-plane",
            Area::Calibrate => "jog-area-calibrate",
            Area::Tool => "jog-area-tool",
        }
    }
}

/// A mask.
#[derive(Debug)]
pub struct Mask {
    /// Name, in a script and in its words: `jog-mask-…`.
    pub name: &'static str,
    /// What is measured.
    pub task: Task,
    /// Points P1 to P4; 1 where NC start does everything and there is no softkey for a point.
    pub points: usize,
    /// Fields for input, in their order.
    pub fields: &'static [Field],
    /// What stands in the left part, in its order.
    pub shows: &'static [Show],
    /// What it alone says to who stands before it.
    pub help: &'static [Line],
    /// Of a mask up to measuring cycles SW 6.2 the newer one that measures alike.
    pub older: Option<&'static str>,
    /// Where the manual describes it.
    pub source: &'static str,
}

/// What is measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Task {
    /// Length of the probe on a surface.
    Length,
    /// Ball of the probe in a ring.
    Ring,
    /// An edge.
    Edge,
    /// The angle of an edge.
    EdgeAngle,
    /// Two edges.
    Distance,
    /// A corner, by as many points as the mask has.
    Corner,
    /// An element.
    Element(Element),
    /// Two to four elements.
    Centres(Element),
    /// A plane.
    Plane,
    /// The tool probe.
    ToolProbe,
    /// The length of a tool.
    ToolLength,
    /// The radius of a tool.
    ToolRadius,
}

/// An element that four touches find.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Element {
    /// Hole or circular spigot.
    pub round: bool,
    /// Hole or pocket.
    pub inside: bool,
}

impl Task {
    /// Whether the tool in the spindle is measured, or measures the tool probe.
    pub fn of_tool(self) -> bool {
        matches!(self, Task::ToolProbe | Task::ToolLength | Task::ToolRadius)
    }

    /// The softkey under which it stands (B:2891-2895, B:2991-2993, B:3167-3168, B:3264-3268, B:3295-3299).
    pub fn area(self) -> Area {
        match self {
            Task::Edge | Task::EdgeAngle | Task::Distance => Area::Edge,
            Task::Corner => Area::Corner,
            Task::Element(Element { inside, .. }) | Task::Centres(Element { inside, .. }) => {
                if inside {
                    Area::Hole
                } else {
                    Area::Spigot
                }
            }
            Task::Plane => Area::Plane,
            Task::Length | Task::Ring => Area::Calibrate,
            Task::ToolProbe | Task::ToolLength | Task::ToolRadius => Area::Tool,
        }
    }

    /// Whether a zero offset can be corrected by it.
    pub fn corrects(self) -> bool {
        !self.of_tool() && !matches!(self, Task::Length | Task::Ring)
    }
}

/// A field.
#[derive(Debug)]
pub struct Field {
    /// Name, in a script and in its words: `jog-field-…`.
    pub name: &'static str,
    /// What it takes.
    pub kind: Kind,
    /// Fields that must have one of these values for it to be shown.
    pub when: &'static [(&'static str, &'static [&'static str])],
    /// Whether it says how is touched: points that were stored before it changed do not count with it.
    pub touches: bool,
    /// Where the manual names it.
    pub source: &'static str,
}

/// What a field takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// The zero offset that is corrected; whether a rotation goes into it, which global basic frames do not take.
    Offset {
        /// Whether a rotation goes into it.
        turned: bool,
    },
    /// A length, mm.
    Length(Least),
    /// An angle, degree.
    Angle,
    /// One of these words.
    Words(&'static [&'static str]),
    /// An axis X Y Z that is not the measuring axis.
    OtherAxis,
    /// The coordinate rotation or a rotary axis of the channel.
    Turned,
}

/// Which numbers a length may be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Least {
    /// Any.
    Any,
    /// From 0 on.
    Zero,
    /// Above 0.
    Above,
}

/// A line of the left part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Show {
    /// Translation X Y Z of the zero offset chosen.
    Translation,
    /// Rotation X Y Z of the zero offset chosen.
    Rotation,
    /// Translation of the rotary axis of the zero offset chosen; with the coordinate rotation as `Rotation`.
    Turned,
    /// The zero offset that is active while measuring.
    Measuring,
    /// A result, a length in mm.
    Length(&'static str),
    /// A result, an angle in degree.
    Angle(&'static str),
}

/// Decimals with which the control shows a value of a mask, or what is written: four for mm and degrees, five for
/// inches (B:3826-3846, B:3880-3883); none: it is a number without unit.
pub fn decimals(unit: &str) -> Option<usize> {
    match unit {
        "mm" | "deg" => Some(4),
        "inch" => Some(5),
        _ => None,
    }
}

/// Key of the words for a mask, a field or a result: `jog-field-set-p1`.
pub fn key(kind: &str, name: &str) -> String {
    format!("jog-{kind}-{}", name.replace('_', "-"))
}

impl Mask {
    /// The field with this name.
    pub fn field(&self, name: &str) -> Option<&'static Field> {
        self.fields.iter().find(|field| field.name == name)
    }

    /// Whether the user stores each point after its touch, in their order, and three of four may do: the corner up to
    /// SW 6.2 (A:3188-3200).
    pub fn by_hand(&self) -> bool {
        self.older.is_some() && self.task == Task::Corner
    }

    /// Whether NC start alone measures and calculates: there are no softkeys for points.
    pub fn at_once(&self) -> bool {
        self.points == 1
    }
}
