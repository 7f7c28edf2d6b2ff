//! Addresses of G110 (C:1075-1101).

use crate::catalogue::common::{ALWAYS_REQUIRED, PARAM, optional};
use crate::catalogue::nct::{FORMAT_ERROR, params};
use crate::control::Plane;
use crate::entry::{Chooses, Need, Param, Unit, When, address};
use crate::range::Range;

/// The address of the tool axis makes it a boss, whatever its value (C:1076).
const AXIS: Param = Param { key: "g110-axis", unit: Unit::ActiveLength, source: "C:1076", ..PARAM };

const fn in_plane(plane: Plane) -> Need {
    optional(When::Plane(plane), "need-g110-boss")
}

const fn boss_in(plane: Plane) -> Chooses {
    Chooses { when: When::Plane(plane), variant: super::BOSS, typed: "0" }
}

/// In the order of the block format.
pub const PARAMS: &[Param] = &[
    Param {
        name: address::D,
        key: "g110-d",
        unit: Unit::ActiveLength,
        range: Range::POSITIVE,
        usual: Range::closed(1.0, 1000.0),
        alarm: Some(FORMAT_ERROR),
        needs: ALWAYS_REQUIRED,
        source: "C:1075",
        ..PARAM
    },
    Param { name: address::X, needs: &[in_plane(Plane::G19)], chooses: &[boss_in(Plane::G19)], ..AXIS },
    Param { name: address::Y, needs: &[in_plane(Plane::G18)], chooses: &[boss_in(Plane::G18)], ..AXIS },
    Param { name: address::Z, needs: &[in_plane(Plane::G17)], chooses: &[boss_in(Plane::G17)], ..AXIS },
    Param { needs: &[optional(When::Variant(&[super::BOSS]), "need-nct-optional")], source: "C:1077", ..params::R },
    Param { source: "C:1078", ..params::Q },
    Param { source: "C:1079", ..params::S },
    Param { key: "nct-t-size", source: "C:1097", ..params::T },
    Param { source: "C:1091", ..params::M },
    Param { source: "C:1098", ..params::H },
    Param { source: "C:1099", ..params::U },
    Param { source: "C:1100", ..params::V },
    Param { source: "C:1101", ..params::W },
];
