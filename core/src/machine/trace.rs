//! What happened, in order, each with the program line that caused it. 3D view, timeline, tables and tests read this.

use super::{Entries, InUse};
use crate::control::ROTARY;
use crate::diagnostic::Code;
use crate::geometry::{Around, Degrees, Dir, Mcs};
use crate::message::Message;
use crate::workpiece::{Solid, Touching};
use serde::{Serialize, Serializer};
use std::collections::BTreeMap;

/// Kind of a motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum MotionKind {
    /// G0 of the program, or unmonitored positioning.
    Rapid,
    /// Intermediate positioning of a cycle with collision monitoring, or G1.
    Positioning,
    /// Measuring motion up to the switching position or its end.
    Measuring,
    /// Back to the start of the measuring block.
    Retract,
}

/// One step. Directions are in machine (basic) coordinates X Y Z, as the points.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "step", rename_all = "lowercase")]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub enum Step {
    /// A motion.
    Motion {
        /// Kind.
        kind: MotionKind,
        /// Start: the point to which the tool length refers.
        from: Mcs,
        /// Real end.
        to: Mcs,
        /// Round what it went; none: straight.
        #[serde(skip_serializing_if = "Option::is_none")]
        around: Option<Around<Mcs>>,
        /// mm/min; 0: rapid traverse.
        feed: f64,
    },
    /// The probe switched.
    Touch {
        /// Position latched by the control.
        latched: Mcs,
        /// Centre of the ball at contact; of a tool at a tool probe the point to which its lengths refer.
        ball: Mcs,
        /// Point touched on the part.
        point: Mcs,
        /// Outward unit normal of the part there.
        normal: Dir<Mcs>,
        /// What touched; left out: what measures, the ball or a tool.
        #[serde(skip_serializing_if = "Touching::measures")]
        #[cfg_attr(test, ts(optional, as = "Option<Touching>"))]
        by: Touching,
    },
    /// Contact where none is allowed and nobody watched, or that gives no signal.
    Crash {
        /// Point touched on the part.
        point: Mcs,
        /// Outward unit normal of the part there.
        normal: Dir<Mcs>,
        /// What touched; left out: what measures, the ball or a tool.
        #[serde(skip_serializing_if = "Touching::measures")]
        #[cfg_attr(test, ts(optional, as = "Option<Touching>"))]
        by: Touching,
    },
    /// Spindle orientation.
    Orient {
        /// Degree.
        angle: Degrees,
    },
    /// The spindle turns from now on.
    Spin {
        /// 1/min: positive with M3, negative with M4; 0: it stops.
        speed: f64,
    },
    /// A rotary axis turned, and the part with it.
    Table {
        /// Which one: 0 A, 1 B, 2 C.
        #[serde(serialize_with = "rotary_name")]
        #[cfg_attr(test, ts(type = "string"))]
        axis: usize,
        /// Before, machine, degree.
        from: Degrees,
        /// After.
        to: Degrees,
        /// The part as it stands then, machine coordinates.
        solids: Vec<Solid>,
    },
    /// The tool in the spindle changed.
    Tool {
        /// T number.
        tool: i64,
        /// D number.
        edge: i64,
    },
    /// A datum was written: name and value, in the unit of the datum.
    Set {
        /// `_OVR[4]`, `$P_UIFR[1,X,FI]`, `$TC_DP15[20,1]`, `#505`.
        name: String,
        /// Value before.
        before: f64,
        /// Value after.
        after: f64,
    },
    /// A decision of the cycle (branch of the tolerance chain).
    Decision {
        /// In words.
        message: Message,
    },
    /// An alarm or operator message.
    Alarm(
        #[serde(skip_serializing)]
        #[cfg_attr(test, ts(type = "Raised"))]
        Code,
    ),
    /// Operator text (`MSG`), or a halt.
    Message {
        /// As it is shown.
        text: String,
        /// Whether the program waits for NC START.
        #[serde(skip_serializing_if = "std::ops::Not::not")]
        #[cfg_attr(test, ts(optional, as = "Option<bool>"))]
        waits: bool,
    },
    /// A line of the measuring log or print-out.
    Log {
        /// As it is written.
        text: String,
    },
    /// A file of the control was made, or a line was written into it.
    File {
        /// `LOG_1.MPF`.
        name: String,
        /// The line; none: it is made, and empty.
        #[serde(skip_serializing_if = "Option::is_none")]
        text: Option<String>,
    },
    /// A block that was sent to a computer (digitizing).
    #[serde(rename = "log")]
    #[cfg_attr(test, ts(skip))]
    Sent {
        /// As it is sent.
        text: String,
    },
    /// Begin of a measuring cycle.
    #[serde(rename = "call")]
    CallBegin {
        /// Name.
        cycle: &'static str,
        /// Number of the measuring variant.
        variant: i64,
    },
    /// End of it.
    #[serde(rename = "return")]
    CallEnd,
}

fn rotary_name<S: Serializer>(axis: &usize, to: S) -> Result<S::Ok, S::Error> {
    to.serialize_str(ROTARY.get(*axis).copied().unwrap_or_default())
}

/// A step with its line.
#[derive(Clone, Debug, PartialEq)]
pub struct Entry {
    /// Line of the program, from 0; none for a call without a program.
    pub line: Option<u32>,
    /// What happened.
    pub step: Step,
    /// Index in [`Trace::in_use`] of the tool that was in use then.
    pub in_use: usize,
}

/// Everything that happened.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Trace {
    /// In order.
    pub entries: Entries,
    /// Whatever was in use, each once for each way in which it was.
    pub in_use: Vec<InUse>,
    /// Data that the program wrote when the trace had no more room for it, with their last values.
    pub later: BTreeMap<String, f64>,
}

impl Trace {
    /// Adds an entry.
    pub(super) fn record(&mut self, entry: Entry) {
        if let (Step::Set { name, .. }, false) = (&entry.step, self.later.is_empty()) {
            self.later.remove(name);
        }
        self.entries.push(entry);
    }

    /// Keeps of a step without room what it leaves.
    pub(super) fn leave_out(&mut self, step: Step) {
        if let Step::Set { name, after, .. } = step {
            self.later.insert(name, after);
        }
    }
}

impl Step {
    /// Whether a program may do this without a record of it: what a call decides, raises and logs is always told.
    pub(super) fn may_be_left_out(&self) -> bool {
        !matches!(
            self,
            Step::Decision { .. }
                | Step::Alarm(_)
                | Step::Log { .. }
                | Step::Sent { .. }
                | Step::CallBegin { .. }
                | Step::CallEnd
        )
    }
}
