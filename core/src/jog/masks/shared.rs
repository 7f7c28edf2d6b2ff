//! Fields that several masks have.

use crate::jog::mask::{Field, Kind, Least};

/// The words of a choice between yes and no, and those of the signs and axes.
pub const YES: &[&str] = &["yes", "no"];
const SIGNS: &[&str] = &["+", "-"];
const AXES: &[&str] = &["X", "Y", "Z"];

/// A field that says how is touched.
pub const fn touching(name: &'static str, kind: Kind, source: &'static str) -> Field {
    Field { name, kind, when: &[], touches: true, source }
}

/// A field that says what is written.
pub const fn writing(name: &'static str, kind: Kind, source: &'static str) -> Field {
    Field { name, kind, when: &[], touches: false, source }
}

/// The zero offset that is corrected by a translation (B:2762-2781).
pub const fn offset(source: &'static str) -> Field {
    writing("zo", Kind::Offset { turned: false }, source)
}

/// The zero offset that is corrected by a rotation as well.
pub const fn turned_offset(source: &'static str) -> Field {
    writing("zo", Kind::Offset { turned: true }, source)
}

/// Direction of travel at the first point.
pub const fn direction(source: &'static str) -> Field {
    touching("direction", Kind::Words(SIGNS), source)
}

/// Direction of travel at the second point.
pub const fn direction_2(source: &'static str) -> Field {
    touching("direction_2", Kind::Words(SIGNS), source)
}

/// Measuring axis.
pub const fn axis(source: &'static str) -> Field {
    touching("axis", Kind::Words(AXES), source)
}

/// Set position in the first axis.
pub const fn x0(source: &'static str) -> Field {
    writing("x0", Kind::Length(Least::Any), source)
}

/// Set position in the second axis.
pub const fn y0(source: &'static str) -> Field {
    writing("y0", Kind::Length(Least::Any), source)
}

/// Set angle.
pub const fn set_angle(source: &'static str) -> Field {
    writing("spec_angle", Kind::Angle, source)
}

/// Diameter of a hole, 0 where it is not known.
pub const fn hole_diameter(source: &'static str) -> Field {
    touching("diameter", Kind::Length(Least::Zero), source)
}

/// Diameter of a spigot.
pub const fn spigot_diameter(source: &'static str) -> Field {
    touching("diameter", Kind::Length(Least::Above), source)
}

/// Infeed from the start beside a spigot.
pub const fn infeed(source: &'static str) -> Field {
    touching("dz", Kind::Length(Least::Above), source)
}
