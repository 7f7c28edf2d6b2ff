//! The masks up to measuring cycles SW 6.2: fewer, without an activation screen; the corner is stored point by point
//! (A:2905-3298).

use super::shared::{axis, direction, hole_diameter, infeed, offset, spigot_diameter, touching, turned_offset, x0, y0};
use crate::jog::help::{before, corrects, measures, order, wrong};
use crate::jog::mask::{Element, Function, Kind, Least, Mask, Show, Task};

const ROUND: &[Show] =
    &[Show::Translation, Show::Measuring, Show::Length("diameter"), Show::Length("meas_x0"), Show::Length("meas_y0")];

pub(super) const EDGE: Function = Function {
    name: "old_edge",
    masks: &[Mask {
        name: "old_edge",
        task: Task::Edge,
        points: 1,
        fields: &[offset("A:3109-3112"), direction("A:3113"), axis("A:3113"), x0("A:3114")],
        shows: &[Show::Translation, Show::Measuring, Show::Length("meas_x0")],
        help: &[
            measures("jog-help-set-edge-measures", "A:3087"),
            before("jog-help-set-edge-before", "A:3099;A:3113"),
            before("jog-help-edge-before-depth", "A:3099"),
            corrects("jog-help-set-edge-corrects", "A:3124"),
            wrong("jog-help-edge-wrong", "A:3113"),
        ],
        older: Some("set_edge"),
        source: "A:3081-3124",
    }],
};

pub(super) const CORNER: Function = Function {
    name: "old_corner",
    masks: &[Mask {
        name: "old_corner",
        task: Task::Corner,
        points: 4,
        fields: &[
            turned_offset("A:3168-3171"),
            touching("pos", Kind::Words(&["1", "2", "3", "4"]), "A:3143;A:3172"),
            x0("A:3144;A:3173"),
            y0("A:3145;A:3173"),
        ],
        shows: &[
            Show::Translation,
            Show::Measuring,
            Show::Length("meas_x0"),
            Show::Length("meas_y0"),
            Show::Angle("alpha"),
        ],
        help: &[
            measures("jog-help-corner-any-measures", "A:3132"),
            before("jog-help-corner-any-before", "A:3177-3188"),
            before("jog-help-older-corner-before", "A:3141-3145;A:3172"),
            order("jog-help-older-corner-order", "A:3188-3200"),
            corrects("jog-help-corner-corrects", "A:3194"),
            wrong("jog-help-older-corner-wrong", "A:3198"),
            wrong("jog-help-corner-any-wrong", "A:15912"),
            wrong("jog-help-corner-wrong-same", "A:15911"),
        ],
        older: Some("corner_right"),
        source: "A:3126-3200",
    }],
};

pub(super) const HOLE: Function = Function {
    name: "old_hole",
    masks: &[Mask {
        name: "old_hole",
        task: Task::Element(Element { round: true, inside: true }),
        points: 1,
        fields: &[offset("A:3232-3235"), hole_diameter("A:3236"), x0("A:3237"), y0("A:3237")],
        shows: ROUND,
        help: &[
            measures("jog-help-hole-1-measures", "A:3209"),
            before("jog-help-hole-1-before", "A:3210;A:3236"),
            corrects("jog-help-centre-corrects", "A:3245"),
        ],
        older: Some("hole_1"),
        source: "A:3203-3249",
    }],
};

pub(super) const SPIGOT: Function = Function {
    name: "old_spigot",
    masks: &[Mask {
        name: "old_spigot",
        task: Task::Element(Element { round: true, inside: false }),
        points: 1,
        fields: &[offset("A:3284-3287"), spigot_diameter("A:3288"), x0("A:3289"), y0("A:3289"), infeed("A:3290")],
        shows: ROUND,
        help: &[
            measures("jog-help-spigot-1-measures", "A:3257"),
            before("jog-help-spigot-1-before", "A:3259;A:3288"),
            corrects("jog-help-centre-corrects", "A:3298"),
        ],
        older: Some("spigot_1"),
        source: "A:3251-3298",
    }],
};

pub(super) const LENGTH: Function = Function {
    name: "old_cal_length",
    masks: &[Mask {
        name: "old_cal_length",
        task: Task::Length,
        points: 1,
        fields: &[touching("z0", Kind::Length(Least::Any), "A:3061;A:3073")],
        shows: &[],
        help: &[
            measures("jog-help-cal-length-measures", "A:3053"),
            before("jog-help-cal-length-before", "A:3061-3065"),
            corrects("jog-help-cal-length-corrects", "A:3079"),
            wrong("jog-help-cal-length-wrong", "A:3073"),
        ],
        older: Some("cal_length"),
        source: "A:3051-3079",
    }],
};

pub(super) const RADIUS: Function = Function {
    name: "old_cal_radius",
    masks: &[Mask {
        name: "old_cal_radius",
        task: Task::Ring,
        points: 1,
        fields: &[touching("d", Kind::Length(Least::Above), "A:3030;A:3044")],
        shows: &[],
        help: &[
            measures("jog-help-cal-radius-measures", "A:3020"),
            before("jog-help-cal-radius-before", "A:3028-3034"),
            order("jog-help-cal-radius-order", "A:3047;B:5326-5332"),
            corrects("jog-help-cal-radius-corrects", "A:3020"),
            wrong("jog-help-cal-radius-wrong", "A:3044"),
            wrong("jog-help-cal-radius-wrong-spindle", "A:15916;A:15917"),
        ],
        older: Some("cal_radius"),
        source: "A:3018-3047",
    }],
};
