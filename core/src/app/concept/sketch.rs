//! What is calculated, drawn: the manual's own examples of mean value and braking path, an empirical value, and the
//! limits of a deviation.

use super::{ConceptExample, ConceptPicture, dragged};
use crate::control::braking::Braking;
use crate::control::units::INCH;
use crate::control::{AXES, Plane};
use crate::entry::{Typed, names};
use crate::evaluate::mean;
use crate::evaluate::tolerance::{Bands, Branch, chain};
use crate::manual::explained::Example;
use crate::message::Message;
use crate::name::Name;
use crate::picture::figures::{circle, dimension, line, polar, ray, rectangle, swept};
use crate::picture::{Picture, PictureShape, ShapeKind, View};
use crate::scene::plan::reference::{Lengths, Systems, lengths, systems};

/// Differences of ten parts, and the limit beyond which their mean value corrects, µm (B:1265-1284).
const DIFFERENCES: [f64; 10] = [30.0, 50.0, 60.0, 20.0, 40.0, 50.0, 50.0, 30.0, 70.0, 70.0];
const LIMIT: f64 = 40.0;
/// The axis of the worked example (B:1184-1187).
const AXIS: Braking = Braking { delay: 0.016, acceleration: 1.0, gain: 1.0 };
/// Limits that can be told apart in a drawing, mm, in their order (B:1286-1422).
const BANDS: Bands = Bands {
    safe_area: 0.1,
    difference: 0.07,
    upper: 0.045,
    lower: -0.045,
    mean: 0.025,
    zero_offset: 0.01,
    weight: 1.0,
};
/// What an empirical value is subtracted from, and the tolerance around 0, mm.
const MEASURED: f64 = 0.03;
const TOLERANCE: f64 = 0.04;
/// The direction in which a mono probe switches where the spindle stands at 0°, degree: it was not seated exactly.
const SEATED: f64 = -12.0;
/// What nine touches of one place differ from it, µm, and the standard deviation of the probe that gave them.
const TOUCHES: [f64; 9] = [1.2, -0.7, 0.6, -1.5, 0.2, 1.8, -0.4, -1.1, 0.8];
const SCATTER: f64 = 1.1;
/// What the control repeats when it measures on the fly, mm (B:16760).
const REPEATS: f64 = 0.001;
/// Parts of the paper: radius of a point, and paper for a mm where hundredths matter.
const POINT: f64 = 1.4;
const FINE: f64 = 1000.0;
/// Height of a bar, and from one to the next.
const BAR: f64 = 12.0;
const NEXT: f64 = 18.0;

/// What is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sketch {
    Mean,
    Empirical,
    Chain,
    Braking,
    Mono,
    Repeated,
    Systems,
    Lengths,
    Latched,
    Travel,
    Units,
}

impl Sketch {
    pub fn of(name: &str) -> Option<Sketch> {
        match name {
            "sketch/mean" => Some(Sketch::Mean),
            "sketch/empirical" => Some(Sketch::Empirical),
            "sketch/chain" => Some(Sketch::Chain),
            "sketch/braking" => Some(Sketch::Braking),
            "sketch/mono" => Some(Sketch::Mono),
            "sketch/repeated" => Some(Sketch::Repeated),
            "sketch/systems" => Some(Sketch::Systems),
            "sketch/lengths" => Some(Sketch::Lengths),
            "sketch/latched" => Some(Sketch::Latched),
            "sketch/travel" => Some(Sketch::Travel),
            "sketch/units" => Some(Sketch::Units),
            _ => None,
        }
    }

    pub fn example(self, example: &Example) -> ConceptExample {
        let (name, key, unit, step, value) = match self {
            Sketch::Mean => ("_K", "param-k", "", 1.0, 2.0),
            Sketch::Empirical => ("_EV", "concept-empirical-value", "mm", 0.001, 0.02),
            Sketch::Chain => ("", "concept-drag-difference", "mm", 0.001, 0.03),
            Sketch::Braking | Sketch::Latched | Sketch::Travel => {
                ("", "concept-drag-feed", "mm/min", 10.0, (example.from + example.to) / 2.0)
            }
            Sketch::Units => ("_SETVAL", "param-setval", "inch", 0.05, 1.0),
            Sketch::Mono => ("_CORA", "param-cora", "deg", 1.0, 0.0),
            Sketch::Repeated => ("_NMSP", "param-nmsp", "", 1.0, 3.0),
            Sketch::Systems => ("", "concept-drag-offset", "mm", 1.0, 100.0),
            Sketch::Lengths => ("", "concept-drag-plane", "", 1.0, 17.0),
        };
        let whole = matches!(self, Sketch::Mean | Sketch::Repeated | Sketch::Lengths);
        ConceptExample { whole, ..dragged(example, name, Message::new(key), unit, step).at(value) }
    }

    pub fn draw(self, value: f64) -> ConceptPicture {
        match self {
            Sketch::Mean => of_mean(value.round()),
            Sketch::Empirical => of_empirical(value),
            Sketch::Chain => of_chain(value),
            Sketch::Braking => of_braking(value),
            Sketch::Mono => of_mono(value),
            Sketch::Repeated => of_repeated(value.round()),
            Sketch::Systems => of_systems(value),
            Sketch::Lengths => of_lengths(value.round()),
            Sketch::Latched => of_latched(value),
            Sketch::Travel => of_travel(value),
            Sketch::Units => of_units(value),
        }
    }
}

fn plane(shapes: Vec<PictureShape>, values: Typed, told: Message) -> ConceptPicture {
    ConceptPicture { picture: Picture { view: View::Plane, shapes }, values, told: Some(told) }
}

fn value_of(name: Name, value: f64) -> (String, String) {
    (name.to_string(), value.to_string())
}

/// Ten measured differences, the mean value that follows them, and where it corrects and begins again.
fn of_mean(weight: f64) -> ConceptPicture {
    let place = |index: usize| 10.0 * (index + 1) as f64;
    let mut shapes = vec![
        rectangle(ShapeKind::Tolerance, [55.0, 0.0], [110.0, 2.0 * LIMIT]).of(names::TZL),
        line(ShapeKind::Axis, vec![[0.0, 0.0], [110.0, 0.0]]),
        dimension(names::TZL, [110.0, 0.0], [110.0, LIMIT]),
    ];
    let (mut old, mut way, mut corrected) = (0.0, vec![[0.0, 0.0]], 0);
    for (index, difference) in DIFFERENCES.into_iter().enumerate() {
        let mean = mean::next(old, difference, weight).unwrap_or(difference);
        let at = [place(index), mean];
        way.push(at);
        shapes.push(circle(ShapeKind::Touch, [place(index), difference], POINT));
        old = mean;
        if mean > LIMIT {
            corrected += 1;
            old = 0.0;
            shapes.push(line(ShapeKind::Edge, std::mem::replace(&mut way, vec![[place(index), 0.0]])).of(names::K));
            shapes.push(circle(ShapeKind::Probe, at, 2.0 * POINT).of(names::K));
        }
    }
    shapes.push(line(ShapeKind::Edge, way).of(names::K));
    let values = [value_of(names::K, weight), value_of(names::TZL, LIMIT / FINE)].into_iter().collect();
    plane(shapes, values, Message::new("concept-told-mean").number("count", f64::from(corrected)))
}

/// A measured difference, and what it counts as once the empirical value is subtracted (B:1292-1308).
fn of_empirical(value: f64) -> ConceptPicture {
    let counts = MEASURED - value;
    let [low, high, from, to] = [-TOLERANCE, TOLERANCE, MEASURED, counts].map(|place| place * FINE);
    let mut ev = line(ShapeKind::Dimension, vec![[from, -NEXT], [to, -NEXT]]);
    ev.text = Some(format!("_EV {}", rounded(value)));
    let shapes = vec![
        rectangle(ShapeKind::Tolerance, [0.0, 0.0], [high - low, BAR]),
        line(ShapeKind::Axis, vec![[-100.0, 0.0], [100.0, 0.0]]),
        line(ShapeKind::Edge, vec![[0.0, -BAR], [0.0, BAR]]),
        dimension(names::TUL, [0.0, NEXT], [high, NEXT]),
        dimension(names::TLL, [0.0, NEXT], [low, NEXT]),
        circle(ShapeKind::Probe, [from, 0.0], 2.0 * POINT),
        circle(ShapeKind::Touch, [to, 0.0], 2.0 * POINT),
        ev,
    ];
    let values = [value_of(names::TUL, TOLERANCE), value_of(names::TLL, -TOLERANCE)].into_iter().collect();
    let told = Message::new("concept-told-empirical").number("measured", MEASURED).number("counts", rounded(counts));
    plane(shapes, values, told)
}

/// The limits one below the other, a difference across them, and what follows from it.
fn of_chain(difference: f64) -> ConceptPicture {
    let Bands { safe_area, difference: most, upper, mean, zero_offset, .. } = BANDS;
    let bars = [
        (names::TSA, safe_area),
        (names::TDIF, most),
        (names::TUL, upper),
        (names::TMV, mean),
        (names::TZL, zero_offset),
    ];
    let mut shapes = Vec::new();
    for (row, (name, limit)) in bars.into_iter().enumerate() {
        let at = -NEXT * row as f64;
        shapes.push(rectangle(ShapeKind::Tolerance, [0.0, at], [2.0 * limit * FINE, BAR]).of(name));
        shapes.push(dimension(name, [0.0, at], [limit * FINE, at]));
    }
    let bottom = -NEXT * bars.len() as f64;
    let at = difference * FINE;
    shapes.push(line(ShapeKind::Axis, vec![[0.0, NEXT], [0.0, bottom]]));
    shapes.push(line(ShapeKind::Edge, vec![[at, NEXT], [at, bottom]]));
    shapes.push(circle(ShapeKind::Touch, [at, NEXT], 2.0 * POINT));
    let values = bars.into_iter().map(|(name, limit)| value_of(name, limit)).collect();
    let decision = chain(&[difference], &BANDS, 0.0);
    let told =
        Message::new(decision.branch.key()).number("difference", difference).number("mean", rounded(decision.mean));
    let told = match decision.branch {
        branch if !branch.corrects() => told,
        Branch::Mean => told.text("follows", "evaluate-corrects-mean"),
        _ => told.text("follows", "evaluate-corrects-whole"),
    };
    plane(shapes, values, told)
}

/// What the probe is pushed on after its signal: the three parts of the path, and the ball where the axis stands.
fn of_braking(feed: f64) -> ConceptPicture {
    let parts = AXIS.parts(feed);
    let ends = [0.0, parts.delay, parts.delay + parts.braking, parts.sum()];
    let size = 0.6; // of the drawing, mm: a stylus ball
    let mut shapes = vec![
        line(ShapeKind::Edge, vec![[0.0, -2.0 * size], [0.0, 3.0 * size]]),
        circle(ShapeKind::Touch, [0.0, 0.0], size / 3.0),
        circle(ShapeKind::Probe, [parts.sum(), 0.0], size),
        line(ShapeKind::Path, vec![[-4.0 * size, 0.0], [parts.sum(), 0.0]]),
    ];
    for (row, (pair, name)) in ends.windows(2).zip(["v·t", "v²/2a", "v/Kv"]).enumerate() {
        let at = (4.0 + 2.5 * row as f64) * size;
        shapes.push(line(ShapeKind::Dimension, vec![[pair[0], at], [pair[1], at]]).text(name));
    }
    let told = Message::new("braking-path")
        .number("sum", rounded(parts.sum()))
        .number("delay", rounded(parts.delay))
        .number("braking", rounded(parts.braking))
        .number("following", rounded(parts.following));
    plane(shapes, Typed::new(), told)
}

/// A mono probe in front of a face at the right: the way that it is led, and the direction in which it switches.
fn of_mono(corrected: f64) -> ConceptPicture {
    let beside = SEATED + corrected;
    let (ball, face, tip) = (6.0, 30.0, polar(beside, 22.0));
    let mut shapes = vec![
        line(ShapeKind::Edge, vec![[face, -20.0], [face, 20.0]]),
        circle(ShapeKind::Probe, [0.0, 0.0], ball),
        line(ShapeKind::Path, vec![[0.0, 0.0], [face - ball, 0.0]]),
        circle(ShapeKind::Touch, [face, 0.0], POINT),
    ];
    shapes.extend(ray(names::CORA, [0.0, 0.0], tip, 3.0));
    shapes.push(line(ShapeKind::Axis, vec![[0.0, 0.0], polar(SEATED, 24.0)]));
    shapes.extend(swept(names::CORA, 16.0, SEATED, beside));
    let told = Message::new("concept-told-mono").number("beside", beside.abs());
    plane(shapes, [value_of(names::CORA, corrected)].into_iter().collect(), told)
}

/// Touches of one place, one below the other, and their mean value.
fn of_repeated(count: f64) -> ConceptPicture {
    let touches = TOUCHES.get(..count as usize).unwrap_or(&TOUCHES);
    let mean = touches.iter().sum::<f64>() / count;
    let bottom = -(TOUCHES.len() as f64);
    let mut shapes = vec![
        line(ShapeKind::Axis, vec![[0.0, 0.0], [0.0, bottom - 1.0]]),
        line(ShapeKind::Edge, vec![[mean, 0.0], [mean, bottom - 1.0]]).of(names::NMSP),
    ];
    let touch = |(row, at): (usize, &f64)| circle(ShapeKind::Touch, [*at, -(row as f64) - 1.0], POINT / 8.0);
    shapes.extend(touches.iter().enumerate().map(touch));
    let told = Message::new("concept-told-repeated")
        .number("count", count)
        .number("mean", (mean * 100.0).round() / 100.0)
        .number("scatter", (SCATTER / count.sqrt() * 100.0).round() / 100.0)
        .number("single", SCATTER);
    plane(shapes, [value_of(names::NMSP, count)].into_iter().collect(), told)
}

/// Where F and the ball stand, each in its system; the zero offset moves W, and with it the part.
fn of_systems(offset: f64) -> ConceptPicture {
    let Systems { picture, machine, workpiece } = systems(offset);
    let written = |position: [f64; 3]| {
        let of_axis = |(axis, value): (&str, f64)| format!("{axis} {}", figure(value));
        AXES.into_iter().zip(position).map(of_axis).collect::<Vec<_>>().join(", ")
    };
    let told =
        Message::new("concept-told-systems").text("machine", written(machine)).text("workpiece", written(workpiece));
    ConceptPicture { picture, values: Typed::new(), told: Some(told) }
}

/// A position to a hundredth of a mm, as it is read.
fn figure(value: f64) -> String {
    let rounded = (value * 100.0).round() / 100.0;
    rounded.to_string().replace('-', "−")
}

/// A tool with its lengths in a plane, and a turning tool.
fn of_lengths(number: f64) -> ConceptPicture {
    let plane = Plane::of(number as u16).unwrap_or_default();
    let Lengths { picture, axes: [first, second, third], turning } = lengths(plane);
    let told = Message::new("concept-told-lengths")
        .text("plane", format!("G{number}"))
        .text("first", first)
        .text("second", second)
        .text("third", third)
        .text("turning", turning[0])
        .text("along", turning[1]);
    ConceptPicture { picture, values: Typed::new(), told: Some(told) }
}

/// The position that is stored as the probe switches, and the ball where the axis stands at last (B:1092-1095).
fn of_latched(feed: f64) -> ConceptPicture {
    let stops = AXIS.parts(feed).sum();
    let size = 0.6; // of the drawing, mm: a stylus ball
    let shapes = vec![
        line(ShapeKind::Edge, vec![[size, -3.0 * size], [size, 3.0 * size]]),
        circle(ShapeKind::Probe, [stops, 0.0], size),
        line(ShapeKind::Path, vec![[-6.0 * size, 0.0], [stops, 0.0]]),
        circle(ShapeKind::Touch, [0.0, 0.0], size / 4.0).text("_OVR"),
        line(ShapeKind::Dimension, vec![[0.0, 4.0 * size], [stops, 4.0 * size]]),
    ];
    plane(shapes, Typed::new(), Message::new("concept-told-latched").number("path", rounded(stops)))
}

/// How far the axis moves until the value is stored, for a signal that takes a millisecond (B:1202), beside what
/// the control itself repeats (B:16760), µm.
fn of_travel(feed: f64) -> ConceptPicture {
    let travel = feed / 60_000.0;
    let at = travel * FINE;
    let shapes = vec![
        rectangle(ShapeKind::Tolerance, [at, 0.0], [2.0 * REPEATS * FINE, 4.0]),
        line(ShapeKind::Edge, vec![[0.0, -4.0], [0.0, 4.0]]),
        line(ShapeKind::Path, vec![[-4.0, 0.0], [at, 0.0]]),
        circle(ShapeKind::Touch, [at, 0.0], POINT / 4.0),
        line(ShapeKind::Dimension, vec![[0.0, 3.0], [at, 3.0]]).text("v·t"),
    ];
    plane(shapes, Typed::new(), Message::new("concept-told-travel").number("path", rounded(travel)))
}

/// Three parameters of a call on a metric control with G70: the drawing is in inch, the rest in mm (B:1787-1795).
fn of_units(inches: f64) -> ConceptPicture {
    let length = inches * INCH;
    let bars = [(names::SETVAL, length), (names::TSA, 1.0), (names::FA, 1.0)];
    let mut shapes = Vec::new();
    for (row, (name, length)) in bars.into_iter().enumerate() {
        let at = -BAR / 2.0 * row as f64;
        shapes.push(rectangle(ShapeKind::Tolerance, [length / 2.0, at], [length, BAR / 6.0]).of(name));
        shapes.push(dimension(name, [0.0, at], [length, at]));
    }
    shapes.push(line(ShapeKind::Axis, vec![[0.0, BAR / 3.0], [0.0, -4.0 * BAR / 3.0]]));
    let values = [(names::SETVAL, inches), (names::TSA, 1.0), (names::FA, 1.0)];
    let values = values.into_iter().map(|(name, value)| value_of(name, rounded(value))).collect();
    let told = Message::new("concept-told-units").number("inches", rounded(inches)).number("length", rounded(length));
    plane(shapes, values, told)
}

/// To a ten thousandth.
fn rounded(value: f64) -> f64 {
    (value * 10_000.0).round() / 10_000.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::message::Arg;

    fn number(told: Option<Message>, name: &str) -> Option<f64> {
        told?.args.iter().find_map(|(known, arg)| match arg {
            Arg::Number(value) if *known == name => Some(*value),
            _ => None,
        })
    }

    // oracle: manual B:1265-1284, B:1184-1195, B:1292-1308
    #[test]
    fn the_sketches_tell_the_figures_of_the_manual() {
        assert_eq!(number(Sketch::Mean.draw(2.0).told, "count"), Some(3.0));
        assert_eq!(number(Sketch::Mean.draw(3.0).told, "count"), Some(2.0));
        assert_eq!(number(Sketch::Braking.draw(6000.0).told, "sum"), Some(12.6));
        assert_eq!(number(Sketch::Empirical.draw(0.01).told, "counts"), Some(0.02));
    }

    // oracle: manual B:2344-2356 (the arithmetic mean counts); hand: 1.2, 0.5/2, 1.1/3; n touches scatter by 1/√n
    #[test]
    fn more_touches_scatter_less() {
        for (count, mean, scatter) in [(1.0, 1.2, 1.1), (2.0, 0.25, 0.78), (3.0, 0.37, 0.64), (9.0, 0.1, 0.37)] {
            let told = Sketch::Repeated.draw(count).told;
            assert_eq!(number(told.clone(), "mean"), Some(mean), "{count}");
            assert_eq!(number(told, "scatter"), Some(scatter), "{count}");
        }
    }

    // oracle: hand: a probe that is seated at −12° is set right by 12°
    #[test]
    fn the_offset_angle_turns_the_switching_direction_to_the_face() {
        assert_eq!(number(Sketch::Mono.draw(0.0).told, "beside"), Some(12.0));
        assert_eq!(number(Sketch::Mono.draw(12.0).told, "beside"), Some(0.0));
        assert_eq!(number(Sketch::Mono.draw(-18.0).told, "beside"), Some(30.0));
    }

    // oracle: manual B:1286-1422: each limit in its order
    #[test]
    fn a_growing_difference_passes_each_limit() {
        let keys = [0.005, 0.02, 0.03, 0.05, 0.08, 0.11].map(|value| Sketch::Chain.draw(value).told.map(|one| one.key));
        let told = ["small", "mean", "whole", "oversize", "difference", "safe-area"];
        for (key, end) in keys.iter().zip(told) {
            assert_eq!(key.as_deref(), Some(format!("evaluate-{end}").as_str()));
        }
    }
}
