//! Pocket, hole and spigots, one of them (B:3258-3374).

use super::shared::{hole_diameter, infeed, offset, spigot_diameter, touching, x0, y0};
use crate::jog::help::{Line, before, corrects, measures, order, wrong};
use crate::jog::mask::{Element, Field, Function, Kind, Least, Mask, Show, Task};

/// Length in the first axis.
const LENGTH: Field = touching("l", Kind::Length(Least::Above), "B:3343");
/// Width in the second axis.
const WIDTH: Field = touching("w", Kind::Length(Least::Above), "B:3343");
/// Angle at which the element is touched first.
const CONTACT_ANGLE: Field = touching("contact_angle", Kind::Angle, "B:3353-3355");

const X0: Field = x0("B:3357");
const Y0: Field = y0("B:3357");

const RECTANGLE: &[Show] = &[
    Show::Translation,
    Show::Measuring,
    Show::Length("meas_l"),
    Show::Length("meas_w"),
    Show::Length("meas_x0"),
    Show::Length("meas_y0"),
];

const ROUND: &[Show] =
    &[Show::Translation, Show::Measuring, Show::Length("diameter"), Show::Length("meas_x0"), Show::Length("meas_y0")];

const fn element(
    name: &'static str,
    round: bool,
    inside: bool,
    fields: &'static [Field],
    shows: &'static [Show],
    help: &'static [Line],
) -> Mask {
    Mask {
        name,
        task: Task::Element(Element { round, inside }),
        points: 1,
        fields,
        shows,
        help,
        older: None,
        source: "B:3315-3374",
    }
}

const CORRECTS: Line = corrects("jog-help-centre-corrects", "B:3357;B:3369");
const TURNED: Line = order("jog-help-round-order", "B:3353-3355");
const LEANS: Line = wrong("jog-help-rect-wrong", "B:3319");

pub(super) const POCKET: Function = Function {
    name: "pocket_rect",
    masks: &[element(
        "pocket_rect",
        false,
        true,
        &[offset("A:3928"), LENGTH, WIDTH, X0, Y0],
        RECTANGLE,
        &[
            measures("jog-help-pocket-rect-measures", "B:3315-3328"),
            before("jog-help-pocket-rect-before", "B:3328;B:3343"),
            CORRECTS,
            LEANS,
        ],
    )],
};

pub(super) const HOLE: Function = Function {
    name: "hole_1",
    masks: &[element(
        "hole_1",
        true,
        true,
        &[offset("A:3890"), hole_diameter("B:3345-3347"), CONTACT_ANGLE, X0, Y0],
        ROUND,
        &[
            measures("jog-help-hole-1-measures", "B:3315-3328"),
            before("jog-help-hole-1-before", "B:3328;B:3345-3347;A:3236"),
            TURNED,
            CORRECTS,
        ],
    )],
};

pub(super) const RECTANGULAR_SPIGOT: Function = Function {
    name: "spigot_rect",
    masks: &[element(
        "spigot_rect",
        false,
        false,
        &[offset("A:3919"), LENGTH, WIDTH, infeed("B:3349-3351"), X0, Y0],
        RECTANGLE,
        &[
            measures("jog-help-spigot-rect-measures", "B:3315-3328"),
            before("jog-help-spigot-rect-before", "B:3328;B:3343"),
            CORRECTS,
            LEANS,
        ],
    )],
};

pub(super) const SPIGOT: Function = Function {
    name: "spigot_1",
    masks: &[element(
        "spigot_1",
        true,
        false,
        &[offset("A:3900"), spigot_diameter("B:3345-3347"), infeed("B:3349-3351"), CONTACT_ANGLE, X0, Y0],
        ROUND,
        &[
            measures("jog-help-spigot-1-measures", "B:3315-3328"),
            before("jog-help-spigot-1-before", "B:3328;B:3345-3347"),
            TURNED,
            CORRECTS,
        ],
    )],
};
