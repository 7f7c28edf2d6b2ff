//! Right-angled corner, any corner (B:3161-3250).

use super::shared::{touching, turned_offset, x0, y0};
use crate::jog::mask::{Area, Field, Function, Kind, Mask, Show, Task};

const FIELDS: &[Field] = &[
    turned_offset("B:3192"),
    touching("corner", Kind::Words(&["outside", "inside"]), "B:3193"),
    touching("pos", Kind::Words(&["1", "2", "3", "4"]), "B:3194"),
    x0("B:3195"),
    y0("B:3195"),
];

const SHOWS: &[Show] =
    &[Show::Translation, Show::Measuring, Show::Length("meas_x0"), Show::Length("meas_y0"), Show::Angle("alpha")];

const fn corner(name: &'static str, points: usize, source: &'static str) -> Mask {
    Mask { name, task: Task::Corner, points, fields: FIELDS, shows: SHOWS, source }
}

pub(super) const RIGHT: Function =
    Function { name: "corner_right", area: Area::Corner, masks: &[corner("corner_right", 3, "B:3174-3214")] };

pub(super) const ANY: Function =
    Function { name: "corner_any", area: Area::Corner, masks: &[corner("corner_any", 4, "B:3220-3250")] };
