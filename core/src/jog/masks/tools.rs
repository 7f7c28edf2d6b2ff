//! Calibrate the tool probe, measure tools (B:3931-4083).

use super::shared::touching;
use crate::jog::help::{Line, before, corrects, measures, order, wrong};
use crate::jog::mask::{Field, Function, Kind, Least, Mask, Task};

pub(super) const CALIBRATE: Function = Function {
    name: "tool_cal",
    masks: &[Mask {
        name: "tool_cal",
        task: Task::ToolProbe,
        points: 1,
        fields: &[touching("cal_kind", Kind::Words(&["length", "length_and_diameter"]), "B:3963-3978")],
        shows: &[],
        help: &[
            measures("jog-help-tool-cal-measures", "B:3936"),
            before("jog-help-tool-cal-before", "B:3938-3951"),
            order("jog-help-tool-cal-order", "B:3963-3982"),
            corrects("jog-help-tool-cal-corrects", "B:3984"),
            wrong("jog-help-tool-cal-wrong", "B:3938-3945"),
        ],
        older: None,
        source: "B:3934-3986",
    }],
};

const OFFSET: &[Field] = &[touching("v", Kind::Length(Least::Zero), "B:4069-4077")];

const CORRECTS: Line = corrects("jog-help-tool-corrects", "B:4003-4006;B:4083");

const fn measure(name: &'static str, task: Task, help: &'static [Line]) -> Mask {
    Mask { name, task, points: 1, fields: OFFSET, shows: &[], help, older: None, source: "B:3988-4083" }
}

pub(super) const LENGTH: Function = Function {
    name: "tool_length",
    masks: &[measure(
        "tool_length",
        Task::ToolLength,
        &[
            measures("jog-help-tool-length-measures", "B:4001"),
            before("jog-help-tool-length-before", "B:3992-3997;B:4034"),
            order("jog-help-tool-length-order", "B:4013-4018;B:4065-4077"),
            CORRECTS,
            wrong("jog-help-tool-length-wrong", "A:15875"),
        ],
    )],
};

pub(super) const RADIUS: Function = Function {
    name: "tool_radius",
    masks: &[measure(
        "tool_radius",
        Task::ToolRadius,
        &[
            measures("jog-help-tool-radius-measures", "B:4001"),
            before("jog-help-tool-radius-before", "B:3992-3997;B:4035"),
            order("jog-help-tool-radius-order", "B:4012-4018;B:14280-14281"),
            CORRECTS,
            wrong("jog-help-tool-radius-wrong", "A:15875"),
        ],
    )],
};
