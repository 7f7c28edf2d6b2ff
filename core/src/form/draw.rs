//! The drawing of a form, also while it is incomplete.

use super::picture::Picture;
use crate::catalogue::{Cycle, Kind};
use crate::check::{self, Parsed, Typed, parse};
use crate::control::Control;

/// Draws the values; what is missing or wrong is taken from the cycle's worked example. None in a build that does not
/// draw.
pub fn draw(cycle: &'static Cycle, typed: &Typed, control: &Control) -> Option<Picture> {
    if !crate::SIMULATES {
        return None;
    }
    let mut values = typed.clone();
    for (name, example) in cycle.example {
        let text = cycle
            .param(name)
            .is_some_and(|param| matches!(param.kind, Kind::Text(_)));
        let usable = |typed: &String| match parse(typed) {
            Parsed::Empty => false,
            Parsed::Wrong => text,
            _ => true,
        };
        if !values.get(*name).is_some_and(usable) {
            values.insert((*name).to_owned(), (*example).to_owned());
        }
    }
    cycle
        .picture
        .draw(&check::read(cycle, &values, control, &mut Vec::new()))
}
