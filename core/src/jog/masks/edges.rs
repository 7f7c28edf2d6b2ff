//! Set edge, align edge, distance of two edges (B:2985-3149).

use super::shared::{axis, direction, direction_2, offset, set_angle, touching, turned_offset, writing, x0};
use crate::jog::help::{before, corrects, measures, wrong};
use crate::jog::mask::{Function, Kind, Mask, Show, Task};

pub(super) const SET: Function = Function {
    name: "set_edge",
    masks: &[Mask {
        name: "set_edge",
        task: Task::Edge,
        points: 1,
        fields: &[offset("B:3024"), direction("B:3025"), axis("B:3025"), x0("B:3026")],
        shows: &[Show::Translation, Show::Measuring, Show::Length("meas_x0")],
        help: &[
            measures("jog-help-set-edge-measures", "B:3011"),
            before("jog-help-set-edge-before", "B:3015;B:3025"),
            before("jog-help-edge-before-depth", "B:3015"),
            corrects("jog-help-set-edge-corrects", "B:3034-3041"),
            wrong("jog-help-edge-wrong", "B:3025"),
        ],
        older: None,
        source: "B:3009-3041",
    }],
};

pub(super) const ALIGN: Function = Function {
    name: "align_edge",
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
        help: &[
            measures("jog-help-align-edge-measures", "B:3049"),
            before("jog-help-align-edge-before", "B:3060"),
            before("jog-help-edge-before-depth", "B:3060"),
            corrects("jog-help-align-edge-corrects", "B:3096-3107"),
            corrects("jog-help-turn-corrects-rotary", "B:3098-3104"),
            wrong("jog-help-align-edge-wrong", "B:3060"),
            wrong("jog-help-edge-wrong", "B:3069"),
        ],
        older: None,
        source: "B:3047-3107",
    }],
};

pub(super) const DISTANCE: Function = Function {
    name: "distance",
    masks: &[Mask {
        name: "distance",
        task: Task::Distance,
        points: 2,
        fields: &[offset("B:3127"), direction("B:3128"), axis("B:3128"), direction_2("B:3129"), x0("B:3130")],
        shows: &[Show::Translation, Show::Measuring, Show::Length("meas_l"), Show::Length("meas_x0")],
        help: &[
            measures("jog-help-distance-measures", "B:3115"),
            before("jog-help-distance-before", "B:3121;B:3129"),
            before("jog-help-edge-before-depth", "B:3121"),
            corrects("jog-help-distance-corrects", "B:3142"),
            wrong("jog-help-distance-wrong", "B:3129"),
        ],
        older: None,
        source: "B:3113-3149",
    }],
};
