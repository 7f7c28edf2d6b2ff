//! The functions of measuring in JOG and their masks, as data (B:2602-4083). A mask that is not here cannot be opened.

mod calibrate;
mod centres;
mod corners;
mod edges;
mod elements;
mod plane;
mod shared;
mod tools;

use super::mask::{Function, Mask};

/// Every function, in the order of the softkeys.
pub static FUNCTIONS: &[Function] = &[
    edges::SET,
    edges::ALIGN,
    edges::DISTANCE,
    corners::RIGHT,
    corners::ANY,
    elements::POCKET,
    elements::HOLE,
    elements::RECTANGULAR_SPIGOT,
    elements::SPIGOT,
    centres::TWO,
    centres::THREE,
    centres::FOUR,
    plane::ALIGN,
    calibrate::LENGTH,
    calibrate::RADIUS,
    tools::CALIBRATE,
    tools::LENGTH,
    tools::RADIUS,
];

/// Every mask.
pub fn all() -> impl Iterator<Item = &'static Mask> {
    FUNCTIONS.iter().flat_map(|function| function.masks)
}

/// The mask with this name.
pub fn find(name: &str) -> Option<&'static Mask> {
    all().find(|mask| mask.name.eq_ignore_ascii_case(name))
}
