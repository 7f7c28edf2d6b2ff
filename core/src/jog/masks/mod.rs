//! The functions of measuring in JOG and their masks, as data (B:2602-4083), and those up to measuring cycles SW 6.2
//! (A:2905-3298). A mask that is not here cannot be opened.

mod calibrate;
mod centres;
mod corners;
mod edges;
mod elements;
mod older;
mod plane;
mod shared;
mod tools;

use super::mask::{Area, Function, Mask};
use crate::control::{Control, OLDER_JOG};

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
    tools::LENGTH,
    tools::RADIUS,
    tools::CALIBRATE,
];

/// Every function up to measuring cycles SW 6.2; tools are measured alike.
pub static OLDER: &[Function] = &[
    older::EDGE,
    older::CORNER,
    older::HOLE,
    older::SPIGOT,
    older::LENGTH,
    older::RADIUS,
    tools::LENGTH,
    tools::RADIUS,
    tools::CALIBRATE,
];

/// The functions that a control has.
pub fn offered(control: &Control) -> &'static [Function] {
    if control.bit(OLDER_JOG) { OLDER } else { FUNCTIONS }
}

/// The softkeys of the vertical bar, and the masks that each of them offers, in their order. Holes and spigots are of
/// one function and under two softkeys (B:3264-3268, B:3295-3299).
pub fn menu(functions: &'static [Function]) -> Vec<(Area, Vec<&'static Mask>)> {
    let mut menu: Vec<(Area, Vec<&Mask>)> = Vec::new();
    for mask in functions.iter().flat_map(|function| function.masks) {
        let area = mask.task.area();
        match menu.iter_mut().find(|(known, _)| *known == area) {
            Some((_, masks)) => masks.push(mask),
            None => menu.push((area, vec![mask])),
        }
    }
    menu
}

/// Every mask, those up to SW 6.2 last.
pub fn all() -> impl Iterator<Item = &'static Mask> {
    let older = OLDER.iter().flat_map(|function| function.masks).filter(|mask| mask.older.is_some());
    FUNCTIONS.iter().flat_map(|function| function.masks).chain(older)
}

/// The mask with this name.
pub fn find(name: &str) -> Option<&'static Mask> {
    all().find(|mask| mask.name.eq_ignore_ascii_case(name))
}

/// The mask with this name, where the control has it.
pub fn opened(control: &Control, name: &str) -> Option<&'static Mask> {
    let mut masks = offered(control).iter().flat_map(|function| function.masks);
    masks.find(|mask| mask.name.eq_ignore_ascii_case(name))
}

/// The mask that a control has for one from SW 6.3: itself, or the older one that measures alike.
pub fn alike(control: &Control, name: &str) -> Option<&'static Mask> {
    let mut masks = offered(control).iter().flat_map(|function| function.masks);
    // three or four points: it is both corners
    masks.find(|mask| mask.name == name || mask.older == Some(name) || mask.by_hand() && name == "corner_any")
}
