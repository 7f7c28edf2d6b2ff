//! Two, three and four holes or circular spigots (B:3380-3595).

use super::shared::{YES, hole_diameter, infeed, set_angle, spigot_diameter, turned_offset, writing, x0, y0};
use crate::jog::mask::{Area, Element, Field, Function, Kind, Least, Mask, Show, Task};

const SHOWS: &[Show] =
    &[Show::Rotation, Show::Measuring, Show::Angle("alpha"), Show::Length("meas_x0"), Show::Length("meas_y0")];

const ROTATION: (&str, &[&str]) = ("angle_offset", &["rotation"]);

const OFFSET: Field = turned_offset("B:3413");
const SET_ANGLE: Field = set_angle("B:3422");
const ANGLE_OFFSET: Field = writing("angle_offset", Kind::Turned, "B:3418-3420");
const SET_P1: Field = Field { when: &[ROTATION], ..writing("set_p1", Kind::Words(YES), "B:3423") };
const X1: Field = at_p1("x1");
const Y1: Field = at_p1("y1");

const fn at_p1(name: &'static str) -> Field {
    Field { when: &[ROTATION, ("set_p1", &["yes"])], ..writing(name, Kind::Length(Least::Any), "B:3425") }
}

/// Whether the rotation is corrected, and by which set angle.
const TURNS: Field = writing("angle_offset", Kind::Words(YES), "B:3491;B:3566");
const TURNED_ANGLE: Field = Field { when: &[("angle_offset", &["yes"])], ..set_angle("B:3493;B:3568") };

const HOLE: Field = hole_diameter("B:3414-3415");
const SPIGOT: Field = spigot_diameter("B:3414-3415");
const INFEED: Field = infeed("B:3416");

const X0: Field = x0("B:3490;B:3565");
const Y0: Field = y0("B:3490;B:3565");
const SEVERAL_HOLES: &[Field] = &[OFFSET, HOLE, X0, Y0, TURNS, TURNED_ANGLE];
const SEVERAL_SPIGOTS: &[Field] = &[OFFSET, SPIGOT, INFEED, X0, Y0, TURNS, TURNED_ANGLE];

const fn centres(
    name: &'static str,
    inside: bool,
    points: usize,
    fields: &'static [Field],
    shows: &'static [Show],
    source: &'static str,
) -> Mask {
    Mask { name, task: Task::Centres(Element { round: true, inside }), points, fields, shows, source }
}

const fn several(name: &'static str, inside: bool, points: usize, source: &'static str) -> Mask {
    let fields = if inside { SEVERAL_HOLES } else { SEVERAL_SPIGOTS };
    centres(name, inside, points, fields, SHOWS, source)
}

pub(super) const TWO: Function = Function {
    name: "centres_2",
    area: Area::Hole,
    masks: &[
        centres("holes_2", true, 2, &[OFFSET, HOLE, ANGLE_OFFSET, SET_ANGLE, SET_P1, X1, Y1], SHOWS, "B:3380-3448"),
        centres(
            "spigots_2",
            false,
            2,
            &[OFFSET, SPIGOT, INFEED, ANGLE_OFFSET, SET_ANGLE, SET_P1, X1, Y1],
            SHOWS,
            "B:3380-3448",
        ),
    ],
};

pub(super) const THREE: Function = Function {
    name: "centres_3",
    area: Area::Hole,
    masks: &[several("holes_3", true, 3, "B:3454-3520"), several("spigots_3", false, 3, "B:3454-3520")],
};

pub(super) const FOUR: Function = Function {
    name: "centres_4",
    area: Area::Hole,
    masks: &[several("holes_4", true, 4, "B:3526-3595"), several("spigots_4", false, 4, "B:3526-3595")],
};
