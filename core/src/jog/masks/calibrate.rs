//! Calibrate the workpiece probe (B:2876-2977).

use super::shared::touching;
use crate::jog::mask::{Area, Function, Kind, Least, Mask, Task};

pub(super) const LENGTH: Function = Function {
    name: "cal_length",
    area: Area::Calibrate,
    masks: &[Mask {
        name: "cal_length",
        task: Task::Length,
        points: 1,
        fields: &[touching("z0", Kind::Length(Least::Any), "B:2929")],
        shows: &[],
        source: "B:2902-2941",
    }],
};

pub(super) const RADIUS: Function = Function {
    name: "cal_radius",
    area: Area::Calibrate,
    masks: &[Mask {
        name: "cal_radius",
        task: Task::Ring,
        points: 1,
        fields: &[touching("d", Kind::Length(Least::Above), "B:2964")],
        shows: &[],
        source: "B:2943-2977",
    }],
};
