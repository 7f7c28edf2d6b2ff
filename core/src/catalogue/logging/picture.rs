//! The log as a page: a character is one unit wide, a line two units high. Header, titles and one block of values, as
//! far as the call prints them (B:11456-11500).

use super::line::widths;
use super::names::{COLUMN, FILE, HEADLINES, LINE, PROGRAM, SEPARATOR, TITLES, VALUES};
use super::params::LONGEST_LINE;
use crate::catalogue::prelude::*;

/// Height of a line beside the width of a character.
const HEIGHT: f64 = 4.0;
/// How far the base line of a text lies below the middle of its line.
const BASE: f64 = HEIGHT * 0.2;
/// Shortest and widest line that is drawn, characters.
const WIDTHS: (f64, f64) = (40.0, LONGEST_LINE);

/// Width of the tab with the name of the file.
const TAB: f64 = 20.0;
/// Lines of a log that has ended.
const CLOSED: f64 = 6.0;

/// A page that fills from top to bottom.
struct Page {
    width: f64,
    /// Widths of the columns, characters.
    columns: Vec<f64>,
    lines: usize,
    shapes: Vec<PictureShape>,
}

impl Page {
    /// Height of the next line above the lower edge of the first one.
    fn y(&self) -> f64 {
        -HEIGHT * self.lines as f64
    }

    /// A text over the whole line.
    fn text(&mut self, name: Name) {
        let at = [self.width / 2.0, self.y() - BASE];
        self.shapes.push(line(ShapeKind::Label, vec![at]).text(name).of(name));
        self.lines += 1;
    }

    /// A line across the page.
    fn rule(&mut self) {
        let y = self.y() + HEIGHT / 2.0;
        let ends = vec![[0.0, y], [self.width, y]];
        self.shapes.push(line(ShapeKind::Axis, ends));
    }

    /// A line of fields below each other's columns.
    fn fields(&mut self, name: Name, text: &str) {
        let y = self.y();
        let mut left = 0.0;
        let fields: Vec<&str> = text.split(',').collect();
        for (index, (field, width)) in fields.iter().zip(self.columns.clone()).enumerate() {
            if left + width > self.width {
                break;
            }
            let middle = [left + width / 2.0, y - BASE];
            self.shapes.push(line(ShapeKind::Label, vec![middle]).text(field.trim()).of(name));
            left += width;
            if index + 1 < fields.len() {
                let ends = vec![[left, y - HEIGHT / 2.0], [left, y + HEIGHT / 2.0]];
                self.shapes.push(line(ShapeKind::Path, ends).of(SEPARATOR));
            }
        }
        self.lines += 1;
    }
}

/// The page that these data make.
pub fn picture(inputs: &Inputs) -> Picture {
    let width = inputs.positive(LINE, WIDTHS.1).clamp(WIDTHS.0, WIDTHS.1);
    let mut page = Page { width, columns: columns(inputs, width), lines: 0, shapes: Vec::new() };
    let used = |name: &Name| inputs.uses(*name);
    for name in [PROGRAM].into_iter().chain(HEADLINES).filter(used) {
        page.text(name);
    }
    if inputs.uses(TITLES[1]) {
        page.rule();
        for name in TITLES {
            page.fields(name, inputs.text(name));
        }
        page.rule();
    }
    for name in VALUES.into_iter().filter(used) {
        page.fields(name, inputs.text(name));
    }
    let height = HEIGHT * page.lines.max(1) as f64;
    let top = HEIGHT / 2.0;
    let middle = [width / 2.0, top - height / 2.0];
    let sheet = rectangle(ShapeKind::Material, middle, [width, height]);
    let above = top + 2.0 * HEIGHT;
    let mut shapes = vec![sheet, dimension(LINE, [0.0, above], [width, above])];
    if let Some(first) = page.columns.first() {
        let below = top - height - HEIGHT;
        shapes.push(dimension(COLUMN, [0.0, below], [*first, below]));
    }
    if inputs.uses(FILE) {
        shapes.extend(tab(top));
    }
    shapes.extend(page.shapes);
    Picture { view: View::Plane, shapes }
}

/// The file that holds the page: a tab at its upper left corner.
fn tab(top: f64) -> [PictureShape; 2] {
    let middle = [TAB / 2.0, top + HEIGHT / 2.0];
    let name = line(ShapeKind::Label, vec![[middle[0], middle[1] - BASE]]);
    [rectangle(ShapeKind::Zone, middle, [TAB, HEIGHT]).of(FILE), name.text(FILE).of(FILE)]
}

/// A log that is switched off: blocks of values, and the end of the page below them.
pub fn closed(_: &Inputs) -> Picture {
    let width = WIDTHS.0;
    let end = -HEIGHT * CLOSED;
    let sheet = rectangle(ShapeKind::Material, [width / 2.0, end / 2.0], [width, -end]);
    let lines = (1..CLOSED as u32).map(|row| {
        let y = -HEIGHT * f64::from(row);
        line(ShapeKind::Path, vec![[HEIGHT, y], [width - HEIGHT, y]])
    });
    let mut shapes = vec![sheet];
    shapes.extend(lines);
    shapes.push(line(ShapeKind::Edge, vec![[0.0, end], [width, end]]));
    Picture { view: View::Plane, shapes }
}

/// Widths of the columns; where the number is 0, those of the first title line.
fn columns(inputs: &Inputs, most: f64) -> Vec<f64> {
    let fixed = inputs.positive(COLUMN, 12.0).clamp(1.0, most);
    let count = TITLES.iter().chain(&VALUES).map(|name| inputs.text(*name).split(',').count()).max().unwrap_or(1);
    let title = inputs.text(TITLES[0]);
    if inputs.number(COLUMN) == 0.0 && !title.is_empty() {
        let wide = |width: usize| (width as f64).clamp(1.0, most);
        return widths(title).map(wide).collect();
    }
    vec![fixed; count]
}
