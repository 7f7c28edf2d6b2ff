//! Right-angled corner, any corner (B:3161-3250).

use super::shared::{touching, turned_offset, x0, y0};
use crate::jog::help::{Line, before, corrects, measures, wrong};
use crate::jog::mask::{Field, Function, Kind, Mask, Show, Task};

const FIELDS: &[Field] = &[
    turned_offset("B:3192"),
    touching("corner", Kind::Words(&["outside", "inside"]), "B:3193"),
    touching("pos", Kind::Words(&["1", "2", "3", "4"]), "B:3194"),
    x0("B:3195"),
    y0("B:3195"),
];

const SHOWS: &[Show] =
    &[Show::Translation, Show::Measuring, Show::Length("meas_x0"), Show::Length("meas_y0"), Show::Angle("alpha")];

const SIDES: Line = before("jog-help-corner-before", "B:3188-3199");
const CORRECTS: Line = corrects("jog-help-corner-corrects", "B:3176-3180;B:3207-3214");
const SAME_POINTS: Line = wrong("jog-help-corner-wrong-same", "A:15911");

const fn corner(name: &'static str, points: usize, help: &'static [Line], source: &'static str) -> Mask {
    Mask { name, task: Task::Corner, points, fields: FIELDS, shows: SHOWS, help, older: None, source }
}

pub(super) const RIGHT: Function = Function {
    name: "corner_right",
    masks: &[corner(
        "corner_right",
        3,
        &[
            measures("jog-help-corner-right-measures", "B:3176-3180"),
            before("jog-help-corner-right-before", "B:3184"),
            SIDES,
            CORRECTS,
            wrong("jog-help-corner-right-wrong", "B:3161-3168"),
            SAME_POINTS,
        ],
        "B:3174-3214",
    )],
};

pub(super) const ANY: Function = Function {
    name: "corner_any",
    masks: &[corner(
        "corner_any",
        4,
        &[
            measures("jog-help-corner-any-measures", "B:3220-3226"),
            before("jog-help-corner-any-before", "B:3228-3236"),
            SIDES,
            CORRECTS,
            wrong("jog-help-corner-any-wrong", "A:15912"),
            SAME_POINTS,
        ],
        "B:3220-3250",
    )],
};
