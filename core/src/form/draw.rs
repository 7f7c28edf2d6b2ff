//! The drawing of a form, also while it is incomplete.

use crate::catalogue::shown_with::shown_with;
use crate::check;
use crate::check::{Parsed, parse};
use crate::control::Control;
use crate::entry::{Cycle, How, Kind, Typed};
use crate::name::Name;
use crate::picture::Picture;

/// Draws the values; missing and wrong ones come from the cycle's worked example.
pub fn draw(cycle: &'static Cycle, typed: &Typed, control: &Control) -> Option<Picture> {
    let mut values = typed.clone();
    for param in cycle.params.iter().filter(|param| !param.example.is_empty()) {
        let text = matches!(param.kind, Kind::Text(_));
        let usable = |typed: &String| match parse(typed) {
            Parsed::Empty => false,
            Parsed::Wrong => text,
            _ => true,
        };
        if !values.get(param.name.as_str()).is_some_and(usable) {
            values.insert(param.name.to_string(), param.example.to_owned());
        }
    }
    let inputs = check::read(cycle, &values, control, &mut Vec::new());
    let mut picture = match cycle.picture.how() {
        How::Staged(staged) => crate::scene::plan::draw(&inputs, staged),
        How::Own(draw) => draw(&inputs),
    };
    let used = cycle.params.iter().filter(|param| param.need(&inputs).is_some());
    used.for_each(|param| place(param.name, &mut picture));
    Some(picture)
}

/// A parameter without a figure is shown in those of others, as the catalogue says.
fn place(name: Name, picture: &mut Picture) {
    if picture.explains(name) {
        return;
    }
    let mut groups = shown_with(name).iter();
    let Some(group) = groups.find(|group| group.iter().any(|one| picture.explains(*one))) else { return };
    for shape in &mut picture.shapes {
        if shape.field.is_some_and(|field| group.contains(&field)) {
            shape.also.push(name);
        }
    }
}
