//! Align plane (B:3601-3674).

use super::shared::turned_offset;
use crate::jog::help::{before, corrects, measures, wrong};
use crate::jog::mask::{Function, Mask, Show, Task};

pub(super) const ALIGN: Function = Function {
    name: "align_plane",
    masks: &[Mask {
        name: "align_plane",
        task: Task::Plane,
        points: 3,
        fields: &[turned_offset("B:3653")],
        shows: &[Show::Rotation, Show::Measuring, Show::Angle("alpha"), Show::Angle("beta")],
        help: &[
            measures("jog-help-align-plane-measures", "B:3641-3645"),
            before("jog-help-align-plane-before", "B:3649"),
            corrects("jog-help-align-plane-corrects", "B:3641-3645;B:3669"),
            corrects("jog-help-align-plane-orient", "B:3808-3816;B:3889-3906"),
            wrong("jog-help-align-plane-wrong", "B:3649"),
            wrong("jog-help-align-plane-wrong-orientation", "B:3802-3808"),
        ],
        older: None,
        source: "B:3601-3674",
    }],
};
