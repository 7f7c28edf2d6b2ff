//! Calibrate the workpiece probe (B:2876-2977).

use super::shared::touching;
use crate::jog::help::{before, corrects, measures, order, wrong};
use crate::jog::mask::{Function, Kind, Least, Mask, Task};

pub(super) const LENGTH: Function = Function {
    name: "cal_length",
    masks: &[Mask {
        name: "cal_length",
        task: Task::Length,
        points: 1,
        fields: &[touching("z0", Kind::Length(Least::Any), "B:2929")],
        shows: &[],
        help: &[
            measures("jog-help-cal-length-measures", "B:2906"),
            before("jog-help-cal-length-before", "B:2876;B:2925-2937"),
            corrects("jog-help-cal-length-corrects", "B:2941"),
            wrong("jog-help-cal-length-wrong", "B:2929"),
        ],
        older: None,
        source: "B:2902-2941",
    }],
};

pub(super) const RADIUS: Function = Function {
    name: "cal_radius",
    masks: &[Mask {
        name: "cal_radius",
        task: Task::Ring,
        points: 1,
        fields: &[touching("d", Kind::Length(Least::Above), "B:2964")],
        shows: &[],
        help: &[
            measures("jog-help-cal-radius-measures", "B:2947"),
            before("jog-help-cal-radius-before", "B:2876-2878;B:2960"),
            order("jog-help-cal-radius-order", "B:2977;B:5326-5332"),
            corrects("jog-help-cal-radius-corrects", "B:2977;B:13655-13656"),
            wrong("jog-help-cal-radius-wrong", "B:2964"),
            wrong("jog-help-cal-radius-wrong-spindle", "A:15916;A:15917"),
        ],
        older: None,
        source: "B:2943-2977",
    }],
};
