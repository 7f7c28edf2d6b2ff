//! Calibrate the tool probe, measure tools (B:3931-4083).

use super::shared::touching;
use crate::jog::mask::{Area, Field, Function, Kind, Least, Mask, Task};

pub(super) const CALIBRATE: Function = Function {
    name: "tool_cal",
    area: Area::Tool,
    masks: &[Mask {
        name: "tool_cal",
        task: Task::ToolProbe,
        points: 1,
        fields: &[touching("cal_kind", Kind::Words(&["length", "length_and_diameter"]), "B:3963-3978")],
        shows: &[],
        source: "B:3934-3986",
    }],
};

const OFFSET: &[Field] = &[touching("v", Kind::Length(Least::Zero), "B:4069-4077")];

const fn measure(name: &'static str, task: Task, source: &'static str) -> Mask {
    Mask { name, task, points: 1, fields: OFFSET, shows: &[], source }
}

pub(super) const LENGTH: Function = Function {
    name: "tool_length",
    area: Area::Tool,
    masks: &[measure("tool_length", Task::ToolLength, "B:3988-4083")],
};

pub(super) const RADIUS: Function = Function {
    name: "tool_radius",
    area: Area::Tool,
    masks: &[measure("tool_radius", Task::ToolRadius, "B:3988-4083")],
};
