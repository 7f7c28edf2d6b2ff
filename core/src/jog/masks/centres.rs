//! Two, three and four holes or circular spigots (B:3380-3595).

use super::shared::{YES, hole_diameter, infeed, set_angle, spigot_diameter, turned_offset, writing, x0, y0};
use crate::jog::help::{Line, before, corrects, measures, wrong};
use crate::jog::mask::{Element, Field, Function, Kind, Least, Mask, Show, Task};

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

const MEASURES_TURN: Line = measures("jog-help-centres-2-measures", "B:3382-3389");
const MEASURES_CIRCLE: Line = measures("jog-help-centres-3-measures", "B:3456-3458");
const MEASURES_CROSSING: Line = measures("jog-help-centres-4-measures", "B:3528-3530");
const TURN: Line = corrects("jog-help-turn-corrects", "B:3435-3443");
const ROTARY: Line = corrects("jog-help-turn-corrects-rotary", "B:3418-3420;B:3441");
const CENTRE: Line = corrects("jog-help-centre-corrects", "B:3515;B:3590");
const TURN_TOO: Line = corrects("jog-help-several-corrects", "B:3515;B:3590");
const EXCHANGED: Line = wrong("jog-help-centres-wrong", "B:3399-3408");
const SAME_POINTS: Line = wrong("jog-help-centres-wrong-same", "A:15911");
const NO_CIRCLE: Line = wrong("jog-help-centres-3-wrong", "A:15857");
const PARALLEL: Line = wrong("jog-help-centres-4-wrong", "A:15912");

/// Fields, where the manual describes it, and what each mask of as many centres has: holes, then spigots.
struct Several {
    fields: [&'static [Field]; 2],
    help: [&'static [Line]; 2],
    source: &'static str,
}

const fn centres(name: &'static str, inside: bool, points: usize, of: &Several) -> Mask {
    let place = if inside { 0 } else { 1 };
    let (fields, help, source) = (of.fields[place], of.help[place], of.source);
    Mask {
        name,
        task: Task::Centres(Element { round: true, inside }),
        points,
        fields,
        shows: SHOWS,
        help,
        older: None,
        source,
    }
}

const OF_TWO: Several = Several {
    fields: [
        &[OFFSET, HOLE, ANGLE_OFFSET, SET_ANGLE, SET_P1, X1, Y1],
        &[OFFSET, SPIGOT, INFEED, ANGLE_OFFSET, SET_ANGLE, SET_P1, X1, Y1],
    ],
    help: [
        &[MEASURES_TURN, before("jog-help-holes-2-before", "B:3395;B:3414"), TURN, ROTARY, EXCHANGED, SAME_POINTS],
        &[MEASURES_TURN, before("jog-help-spigots-2-before", "B:3395;B:3414"), TURN, ROTARY, EXCHANGED, SAME_POINTS],
    ],
    source: "B:3380-3448",
};

const OF_THREE: Several = Several {
    fields: [SEVERAL_HOLES, SEVERAL_SPIGOTS],
    help: [
        &[MEASURES_CIRCLE, before("jog-help-holes-3-before", "B:3464"), CENTRE, TURN_TOO, EXCHANGED, NO_CIRCLE],
        &[MEASURES_CIRCLE, before("jog-help-spigots-3-before", "B:3464"), CENTRE, TURN_TOO, EXCHANGED, NO_CIRCLE],
    ],
    source: "B:3454-3520",
};

const OF_FOUR: Several = Several {
    fields: [SEVERAL_HOLES, SEVERAL_SPIGOTS],
    help: [
        &[MEASURES_CROSSING, before("jog-help-holes-4-before", "B:3536"), CENTRE, TURN_TOO, EXCHANGED, PARALLEL],
        &[MEASURES_CROSSING, before("jog-help-spigots-4-before", "B:3536"), CENTRE, TURN_TOO, EXCHANGED, PARALLEL],
    ],
    source: "B:3526-3595",
};

pub(super) const TWO: Function = Function {
    name: "centres_2",
    masks: &[centres("holes_2", true, 2, &OF_TWO), centres("spigots_2", false, 2, &OF_TWO)],
};

pub(super) const THREE: Function = Function {
    name: "centres_3",
    masks: &[centres("holes_3", true, 3, &OF_THREE), centres("spigots_3", false, 3, &OF_THREE)],
};

pub(super) const FOUR: Function = Function {
    name: "centres_4",
    masks: &[centres("holes_4", true, 4, &OF_FOUR), centres("spigots_4", false, 4, &OF_FOUR)],
};
