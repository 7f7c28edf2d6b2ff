//! Set edge, align edge, distance of two edges (B:2985-3149).

use super::shared::{axis, direction, direction_2, offset, set_angle, touching, turned_offset, writing, x0};
use crate::jog::mask::{Area, Function, Kind, Mask, Show, Task};

pub(super) const SET: Function = Function {
    name: "set_edge",
    area: Area::Edge,
    masks: &[Mask {
        name: "set_edge",
        task: Task::Edge,
        points: 1,
        fields: &[offset("B:3024"), direction("B:3025"), axis("B:3025"), x0("B:3026")],
        shows: &[Show::Translation, Show::Measuring, Show::Length("meas_x0")],
        source: "B:3009-3041",
    }],
};

pub(super) const ALIGN: Function = Function {
    name: "align_edge",
    area: Area::Edge,
    masks: &[Mask {
        name: "align_edge",
        task: Task::EdgeAngle,
        points: 2,
        fields: &[
            turned_offset("B:3068"),
            direction("B:3069"),
            axis("B:3069"),
            touching("ref_axis", Kind::OtherAxis, "B:3070"),
            writing("angle_offset", Kind::Turned, "B:3071"),
            set_angle("B:3072"),
        ],
        shows: &[Show::Turned, Show::Measuring, Show::Angle("alpha")],
        source: "B:3047-3107",
    }],
};

pub(super) const DISTANCE: Function = Function {
    name: "distance",
    area: Area::Edge,
    masks: &[Mask {
        name: "distance",
        task: Task::Distance,
        points: 2,
        fields: &[offset("B:3127"), direction("B:3128"), axis("B:3128"), direction_2("B:3129"), x0("B:3130")],
        shows: &[Show::Translation, Show::Measuring, Show::Length("meas_l"), Show::Length("meas_x0")],
        source: "B:3113-3149",
    }],
};
