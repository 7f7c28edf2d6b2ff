//! Align plane (B:3601-3674).

use super::shared::turned_offset;
use crate::jog::mask::{Area, Function, Mask, Show, Task};

pub(super) const ALIGN: Function = Function {
    name: "align_plane",
    area: Area::Plane,
    masks: &[Mask {
        name: "align_plane",
        task: Task::Plane,
        points: 3,
        fields: &[turned_offset("B:3653")],
        shows: &[Show::Rotation, Show::Measuring, Show::Angle("alpha"), Show::Angle("beta")],
        source: "B:3601-3674",
    }],
};
