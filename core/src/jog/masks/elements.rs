//! Pocket, hole and spigots, one of them (B:3258-3374).

use super::shared::{hole_diameter, infeed, offset, spigot_diameter, touching, x0, y0};
use crate::jog::mask::{Area, Element, Field, Function, Kind, Least, Mask, Show, Task};

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
) -> Mask {
    Mask { name, task: Task::Element(Element { round, inside }), points: 1, fields, shows, source: "B:3315-3374" }
}

pub(super) const POCKET: Function = Function {
    name: "pocket_rect",
    area: Area::Hole,
    masks: &[element("pocket_rect", false, true, &[offset("A:3928"), LENGTH, WIDTH, X0, Y0], RECTANGLE)],
};

pub(super) const HOLE: Function = Function {
    name: "hole_1",
    area: Area::Hole,
    masks: &[element(
        "hole_1",
        true,
        true,
        &[offset("A:3890"), hole_diameter("B:3345-3347"), CONTACT_ANGLE, X0, Y0],
        ROUND,
    )],
};

pub(super) const RECTANGULAR_SPIGOT: Function = Function {
    name: "spigot_rect",
    area: Area::Spigot,
    masks: &[element(
        "spigot_rect",
        false,
        false,
        &[offset("A:3919"), LENGTH, WIDTH, infeed("B:3349-3351"), X0, Y0],
        RECTANGLE,
    )],
};

pub(super) const SPIGOT: Function = Function {
    name: "spigot_1",
    area: Area::Spigot,
    masks: &[element(
        "spigot_1",
        true,
        false,
        &[offset("A:3900"), spigot_diameter("B:3345-3347"), infeed("B:3349-3351"), CONTACT_ANGLE, X0, Y0],
        ROUND,
    )],
};
