//! A text as it is in its variable: one cell a character.

use crate::catalogue::prelude::*;

/// Width of a cell, and of what is drawn beside it.
pub const CELL: f64 = 4.0;
/// From one row to the next.
pub const ROW: f64 = 6.0;

/// Left edge of a cell.
pub fn left(index: usize) -> f64 {
    CELL * index as f64
}

/// A variable of so many characters, centred at this height, with the text that it holds.
pub fn cells(text: &str, count: usize, y: f64, field: Name) -> Vec<PictureShape> {
    let width = left(count);
    let mut shapes = vec![rectangle(ShapeKind::Material, [width / 2.0, y], [width, CELL]).of(field)];
    let borders = (1..count).map(|index| {
        let ends = [y - CELL / 2.0, y + CELL / 2.0].map(|end| [left(index), end]);
        line(ShapeKind::Path, ends.to_vec())
    });
    shapes.extend(borders);
    let characters = text.chars().take(count).enumerate();
    shapes.extend(characters.map(|(index, character)| {
        line(ShapeKind::Label, vec![[left(index) + CELL / 2.0, y - CELL * 0.2]]).text(character).of(field)
    }));
    shapes
}
