//! The pictures of concepts as SVG files in `docs/concepts/`: what the page draws, in its colours, which are those of
//! its style sheets.

#![allow(clippy::unwrap_used)]

use crate::app::{ConceptRequest, ConceptView, concept_picture, terms};
use crate::entry::Typed;
use crate::picture::{Picture, PictureShape, ShapeKind};
use crate::scene::plan::extent;
use std::collections::BTreeSet;
use std::fmt::Write;
use std::path::Path;

/// Size of a picture and free paper around its figures, as in the page.
const SIZE: [f64; 2] = [560.0, 340.0];
const MARGIN: [f64; 2] = [34.0, 26.0];
/// Width of a letter, height of a line, and half of the length of an arrow.
const LETTER: f64 = 6.7;
const LINE: f64 = 13.0;
const ARROW: [f64; 2] = [8.0, 2.6];
/// From the ground up: what is filled must not hide what is drawn in lines.
const ORDER: [ShapeKind; 12] = [
    ShapeKind::Material,
    ShapeKind::Cut,
    ShapeKind::Tolerance,
    ShapeKind::Plane,
    ShapeKind::Axis,
    ShapeKind::Zone,
    ShapeKind::Path,
    ShapeKind::Edge,
    ShapeKind::Probe,
    ShapeKind::Touch,
    ShapeKind::Dimension,
    ShapeKind::Label,
];
/// Most bytes of all pictures.
const MOST: usize = 400_000;

/// Words at a place, centred or from there on.
struct Caption {
    text: String,
    at: [f64; 2],
    centred: bool,
}

impl Caption {
    fn new(text: String, at: [f64; 2], centred: bool) -> Caption {
        Caption { text, at, centred }
    }

    /// From the left to the right, from the upper to the lower edge.
    fn room(&self) -> [[f64; 2]; 2] {
        let width = LETTER * self.text.chars().count() as f64;
        let left = self.at[0] - if self.centred { width / 2.0 } else { 0.0 };
        [[left, left + width], [self.at[1] - LINE + 3.0, self.at[1] + 3.0]]
    }

    fn inside(&self) -> bool {
        self.room().into_iter().zip(SIZE).all(|([low, high], size)| low >= 2.0 && high <= size - 2.0)
    }

    fn meets(&self, other: &Caption) -> bool {
        self.room().into_iter().zip(other.room()).all(|(one, two)| one[0] < two[1] && two[0] < one[1])
    }
}

/// Millimetres to the points of the picture, Y down.
struct Scale {
    middle: [f64; 2],
    factor: f64,
}

impl Scale {
    fn of(shapes: &[PictureShape]) -> Scale {
        let [low, high] = extent(shapes);
        let fits = |axis: usize| (SIZE[axis] - 2.0 * MARGIN[axis]) / (high[axis] - low[axis]).max(1e-9);
        Scale { middle: [0, 1].map(|axis| (low[axis] + high[axis]) / 2.0), factor: fits(0).min(fits(1)) }
    }

    fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [right, up] = [x - self.middle[0], y - self.middle[1]].map(|way| way * self.factor);
        [SIZE[0] / 2.0 + right, SIZE[1] / 2.0 - up]
    }
}

/// A picture with its style.
fn svg(picture: &Picture, values: &Typed, style: &str) -> String {
    let seen: Vec<PictureShape> = picture.shapes.iter().filter(|shape| is_seen(shape)).cloned().collect();
    let scale = Scale::of(&seen);
    let mut shapes: Vec<&PictureShape> = seen.iter().collect();
    shapes.sort_by_key(|shape| ORDER.iter().position(|kind| *kind == shape.kind));
    let [width, height] = SIZE;
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" \
         height=\"{height}\">\n<style>\n{style}</style>\n<defs><pattern id=\"hatch\" width=\"6\" height=\"6\" \
         patternUnits=\"userSpaceOnUse\" patternTransform=\"rotate(45)\"><rect width=\"6\" height=\"6\" \
         class=\"hatch-ground\"/><path d=\"M0 0V6\" class=\"hatch-line\"/></pattern></defs>\n\
         <rect width=\"{width}\" height=\"{height}\" class=\"well\"/>\n"
    );
    let mut captions: Vec<Caption> = Vec::new();
    for shape in shapes {
        let kind = format!("{:?}", shape.kind).to_lowercase();
        let drawn = figure(shape, &scale);
        if !drawn.is_empty() {
            let _ = writeln!(text, "<g class=\"shape {kind}\">{drawn}</g>");
        }
        if let Some(caption) = caption(shape, &scale, values) {
            captions.push(free(caption, &captions));
        }
    }
    for Caption { text: words, at: [x, y], centred } in captions {
        let anchor = if centred { " text-anchor=\"middle\"" } else { "" };
        let _ = writeln!(
            text,
            "<g class=\"shape\"><text x=\"{x:.1}\" y=\"{y:.1}\"{anchor} class=\"caption\">{words}</text></g>"
        );
    }
    text + "</svg>\n"
}

/// Corners of the paper of a live picture are points of a way: a picture that stays needs no room for other values.
fn is_seen(shape: &PictureShape) -> bool {
    shape.points.len() > 1 || shape.circle.is_some() || shape.text.is_some() || shape.kind == ShapeKind::Touch
}

/// What is drawn of a shape.
fn figure(shape: &PictureShape, scale: &Scale) -> String {
    let points: Vec<[f64; 2]> = shape.points.iter().map(|point| scale.place(*point)).collect();
    if let (ShapeKind::Dimension, [from, to, ..]) = (shape.kind, &points[..]) {
        return dimension(*from, *to);
    }
    let mut drawn = String::new();
    let round = |([x, y], radius): ([f64; 2], f64), least: f64| {
        let ([x, y], r) = (scale.place([x, y]), (radius * scale.factor).max(least));
        format!("M{:.1} {y:.1}a{r:.1} {r:.1} 0 1 0 {:.1} 0a{r:.1} {r:.1} 0 1 0 {:.1} 0Z", x - r, 2.0 * r, -2.0 * r)
    };
    if let Some(circle) = shape.circle {
        let opening = shape.opening.map(|opening| round(opening, 0.0)).unwrap_or_default();
        drawn += &format!("<path fill-rule=\"evenodd\" d=\"{}{opening}\"/>", round(circle, 2.5));
    }
    if shape.kind == ShapeKind::Touch && shape.circle.is_none() {
        for [x, y] in &points {
            drawn += &format!("<path d=\"M{:.1} {y:.1}h8M{x:.1} {:.1}v8\"/>", x - 4.0, y - 4.0);
        }
    } else if points.len() > 1 {
        let opening = shape.opening.filter(|_| shape.circle.is_none()).map(|opening| round(opening, 0.0));
        let way = rings(&points).into_iter().map(|ring| way(ring, shape.closed)).collect::<String>();
        drawn += &format!("<path fill-rule=\"evenodd\" d=\"{way}{}\"/>", opening.unwrap_or_default());
    }
    drawn
}

fn way(points: &[[f64; 2]], closed: bool) -> String {
    let mut way = String::new();
    for (index, [x, y]) in points.iter().enumerate() {
        let _ = write!(way, "{}{x:.1} {y:.1}", if index == 0 { 'M' } else { 'L' });
    }
    way + if closed { "Z" } else { "" }
}

/// An outline around another comes back to its first point before its end: both.
fn rings(points: &[[f64; 2]]) -> Vec<&[[f64; 2]]> {
    let (mut rings, mut start) = (Vec::new(), 0);
    for index in 1..points.len() {
        if index > start && points[index] == points[start] {
            rings.push(&points[start..index]);
            start = index + 1;
        }
    }
    if rings.len() > 1 { rings } else { vec![points] }
}

/// A line with an arrow at each end, from outside where there is no room between them.
fn dimension(from: [f64; 2], to: [f64; 2]) -> String {
    let length = (to[0] - from[0]).hypot(to[1] - from[1]).max(1e-9);
    let along = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
    let out = if length < 22.0 { 14.0 } else { 0.0 };
    let moved = |[x, y]: [f64; 2], way: f64| [x + along[0] * way, y + along[1] * way];
    let aside = |[x, y]: [f64; 2], way: f64| [x - along[1] * way, y + along[0] * way];
    let [long, wide] = ARROW;
    let head = |tip: [f64; 2], way: f64| {
        let back = moved(tip, long * way);
        format!("<path class=\"arrow\" d=\"{}\"/>", self::way(&[tip, aside(back, wide), aside(back, -wide)], true))
    };
    let lines = [
        vec![moved(from, -out), moved(to, out)],
        vec![aside(from, -5.0), aside(from, 5.0)],
        vec![aside(to, -5.0), aside(to, 5.0)],
    ];
    let lines: String = lines.iter().map(|line| way(line, false)).collect();
    let way = if out > 0.0 { -1.0 } else { 1.0 };
    format!("<path d=\"{lines}\"/>{}{}", head(from, way), head(to, -way))
}

/// What is written beside a shape: its text, and the value of the parameter that a dimension shows.
fn caption(shape: &PictureShape, scale: &Scale, values: &Typed) -> Option<Caption> {
    let text = shape.text.clone()?;
    let shown = shape.field.filter(|field| shape.kind == ShapeKind::Dimension && field.as_str() == text);
    let value = shown.and_then(|field| values.get(field.as_str())).map(|value| value.trim());
    let text = value.filter(|value| !value.is_empty()).map_or(text.clone(), |value| format!("{text} {value}"));
    let points: Vec<[f64; 2]> = shape.points.iter().map(|point| scale.place(*point)).collect();
    if let (ShapeKind::Dimension, [from, to, ..]) = (shape.kind, &points[..]) {
        let upright = (to[1] - from[1]).abs() > (to[0] - from[0]).abs();
        let middle = [0, 1].map(|axis| (from[axis] + to[axis]) / 2.0);
        let at = if upright { [middle[0] + 6.0, middle[1] + 4.0] } else { [middle[0], middle[1] - 7.0] };
        return Some(Caption::new(text, at, !upright));
    }
    if let Some((centre, radius)) = shape.circle {
        let ([x, y], r) = (scale.place(centre), (radius * scale.factor).max(2.5));
        let at = if shape.kind == ShapeKind::Touch { [x + 5.0, y + 14.0] } else { [x + r + 3.0, y - r] };
        return Some(Caption::new(text, at, false));
    }
    let [x, y] = *points.first()?;
    Some(match shape.kind {
        ShapeKind::Label => Caption::new(text, [x, y + 4.0], true),
        _ => Caption::new(text, [x + 5.0, y - 5.0], false),
    })
}

/// The caption at the nearest place where none is written yet.
fn free(caption: Caption, others: &[Caption]) -> Caption {
    let tried = (0..12).flat_map(|ring| {
        let by = f64::from(ring) * LINE / 2.0;
        [[0.0, by], [0.0, -by], [by, 0.0], [-by, 0.0], [-2.0 * by, by], [2.0 * by, -by]]
    });
    let moved = |[x, y]: [f64; 2]| Caption {
        text: caption.text.clone(),
        at: [caption.at[0] + x, caption.at[1] + y],
        centred: caption.centred,
    };
    let place = tried.map(moved).find(|one| one.inside() && others.iter().all(|other| !one.meets(other)));
    place.unwrap_or(caption)
}

/// The rules of the page for its pictures, and what they name of its tokens, by day and by night.
fn style() -> String {
    let read = |name: &str| {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../www/src/styles").join(name);
        std::fs::read_to_string(path).unwrap()
    };
    let rules = read("picture.css");
    let rules: String = rules.split_inclusive("}\n").filter(|rule| !rule.contains(".lit")).collect();
    let tokens = read("tokens.css");
    let named: BTreeSet<&str> = rules.split("var(").skip(1).filter_map(|rest| rest.split(')').next()).collect();
    let of = |block: &str| {
        let block = tokens.split_once(block).unwrap().1.split_once("\n  }").unwrap().0;
        let block = block.split_once("\n}").map_or(block, |(own, _)| own);
        let wanted = block
            .split(';')
            .map(str::trim)
            .filter(|one| named.iter().any(|name| one.strip_prefix(*name).is_some_and(|rest| rest.starts_with(':'))));
        wanted.map(|one| one.split_whitespace().collect::<Vec<_>>().join(" ") + ";").collect::<String>()
    };
    let (day, night) = (of(":root {"), of(":root[data-theme=\"dark\"] {"));
    let dark = format!("@media (prefers-color-scheme: dark) {{:root {{{night}}}}}");
    format!(":root {{{day}}}\n{dark}\n.well {{fill: var(--well);}}\n{rules}")
}

fn drawn(concept: &ConceptView, style: &str) -> Option<String> {
    let value = concept.example.as_ref()?.value;
    let shown = concept_picture(ConceptRequest { concept: concept.id.to_owned(), value }).ok()?;
    Some(svg(&shown.picture, &shown.values, style))
}

// oracle: self: each picture of a concept is a file of docs/, in the colours of the page, and there is no other
#[test]
fn the_pictures_of_docs_are_those_of_the_page() {
    let folder = super::docs("en").join("concepts");
    let style = style();
    let pictures: Vec<(String, String)> = terms()
        .concepts
        .iter()
        .filter_map(|concept| Some((format!("{}.svg", concept.id), drawn(concept, &style)?)))
        .collect();
    if std::env::var_os("PROBEWRIGHT_UPDATE").is_some() {
        let _ = std::fs::remove_dir_all(&folder);
        std::fs::create_dir_all(&folder).unwrap();
        for (name, text) in &pictures {
            std::fs::write(folder.join(name), text).unwrap();
        }
    }
    let there: BTreeSet<String> = std::fs::read_dir(&folder)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned())
        .collect();
    assert_eq!(there, pictures.iter().map(|(name, _)| name.clone()).collect());
    for (name, text) in &pictures {
        assert_eq!(std::fs::read_to_string(folder.join(name)).unwrap(), *text, "{name}");
    }
    let all: usize = pictures.iter().map(|(_, text)| text.len()).sum();
    assert!(all < MOST, "{all} bytes");
}

// oracle: hand: the style has each token that its rules name, for day and night, and nothing that asks elsewhere
#[test]
fn a_picture_brings_its_style_along() {
    let style = style();
    for name in ["--edge", "--probe", "--axis", "--material", "--ink", "--well", "--touch"] {
        assert_eq!(style.matches(&format!("{name}: #")).count(), 2, "{name} in {style}");
    }
    assert!(!style.contains("http") && !style.contains("@import"));
}

// oracle: hand: two captions at one place stand one beside the other
#[test]
fn captions_keep_apart() {
    let first = Caption::new("_SETVAL 70".to_owned(), [200.0, 100.0], true);
    let second = free(Caption::new("_FA 2".to_owned(), [200.0, 100.0], true), std::slice::from_ref(&first));
    assert!(!second.meets(&first) && second.inside());
}
