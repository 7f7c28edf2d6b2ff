//! Does the probe switch, and how far do repeated touches spread: the two test programs, one of them run on the
//! machine, and what values of it or of a real machine come to.

use super::Error;
use super::start::{Machine, start};
use crate::control::probe::{PROBE, upright};
use crate::control::{AXES, BasicFrames, Control, Edge, LATHE_PROBE, Transverse, Units};
use crate::dialect::Dialect;
use crate::entry::Typed;
use crate::geometry::{Dir, Mcs};
use crate::machine::Setup;
use crate::message::Message;
use crate::program::probe_test::{FIRST, Keep, ProbeTest, SAYS};
use crate::refused::Path;
use crate::run::{Limits, Outcome, run};
use crate::series::repeat::Repeat;
use crate::syntax;
use crate::workpiece::{Shape, Solid};
use serde::{Deserialize, Serialize};

/// Most touches of a program, and most values that are evaluated.
const MOST: [usize; 2] = [500, 10_000];
/// Intervals of a histogram, by the number of values.
const INTERVALS: [usize; 2] = [5, 15];
/// Side of the block that is touched, mm.
const BLOCK: f64 = 100.0;
/// Largest coordinate, feed and number.
const LARGEST: f64 = 1e5;
/// How far the axis moves without a signal in repeated touches (B:15187-15217) and in the function test, and its feed
/// (B:12825-12856): in mm, and as round values in inch.
const USUAL: [Usual; 2] =
    [Usual { way: 50.0, further: 100.0, feed: 150.0 }, Usual { way: 2.0, further: 4.0, feed: 6.0 }];
/// Touches, as in the program of the manual (B:15187-15217).
const TOUCHES: f64 = 10.0;

/// Motions as the manual has them.
struct Usual {
    way: f64,
    further: f64,
    feed: f64,
}

/// What is tested.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(default)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct RepeatRequest {
    /// Axis that moves: `X`, `Y`, `Z`; absent: X.
    pub axis: Option<String>,
    /// Where the motion begins, in the unit that is active; absent: 0.
    pub from: Option<f64>,
    /// Where it ends without a signal; absent: 50 mm or 2 inch from there, in the function test twice that, in plus
    /// direction, or with the ball of the probe ahead.
    pub to: Option<f64>,
    /// Feed a minute in that unit; absent: 150 mm/min or 6 inch/min.
    pub feed: Option<f64>,
    /// Measuring input, 1 or 2; absent: that of the workpiece probe, `_CHBIT[0]`.
    pub input: Option<u8>,
    /// Touches; absent: 10.
    pub count: Option<f64>,
    /// Whether the values are those of the machine system; absent: of the workpiece system.
    pub machine: Option<bool>,
    /// First R parameter that keeps the values; absent: an array of the program does.
    pub parameters: Option<f64>,
    /// Whether M6 changes the tool; absent: it does not.
    pub changes: Option<bool>,
    /// Values of a real machine, with blanks between them; absent: the program is run.
    pub values: Option<String>,
    /// Words by key, for comments and operator texts.
    pub words: Option<Typed>,
    /// Machine; absent: the core's own as it is.
    pub setup: Option<Machine>,
}

/// The programs, and what the values come to.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct RepeatView {
    /// One touch: whether the probe switches.
    pub function: String,
    /// Repeated touches.
    pub program: String,
    /// Keys of the words in them.
    pub says: [&'static str; 5],
    /// `mm` or `inch`.
    pub unit: &'static str,
    /// What is taken where nothing else is asked for.
    pub usual: RepeatUsual,
    /// What the values come to, a line each.
    pub told: Vec<Message>,
    /// What should be known beside it.
    pub notes: Vec<Message>,
    /// What the values come to.
    pub found: RepeatFound,
}

/// What is taken where nothing else is asked for, in the unit of the view.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct RepeatUsual {
    /// Where the motion begins.
    pub from: f64,
    /// Where it ends without a signal.
    pub to: f64,
    /// Feed a minute.
    pub feed: f64,
    /// Touches.
    pub count: f64,
}

/// What repeated touches come to, in the unit of the view.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct RepeatFound {
    /// The values in their order.
    pub values: Vec<f64>,
    /// Mean.
    pub mean: f64,
    /// Standard deviation of a sample.
    pub deviation: f64,
    /// Smallest value.
    pub smallest: f64,
    /// Largest value.
    pub largest: f64,
    /// Largest minus smallest.
    pub range: f64,
    /// Largest distance from the mean.
    pub furthest: f64,
    /// How many values lie in each interval from the smallest to the largest.
    pub intervals: Vec<usize>,
    /// A straight line through them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub trend: Option<RepeatTrend>,
    /// `_TZL` for one touch.
    pub zone: f64,
    /// `_TZL` for what two touches make.
    pub zone_of_two: f64,
}

/// A straight line through values in their order.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct RepeatTrend {
    /// Change from one touch to the next.
    pub slope: f64,
    /// Correlation with the order, −1 to 1.
    pub correlation: f64,
    /// Student's t of it.
    pub t: f64,
    /// Whether it is one with 95 % confidence.
    pub certain: bool,
}

/// The two programs, and what repeated touches come to.
///
/// # Errors
/// What cannot be tested: which member is at fault; or why the program ended without values.
pub fn repeat(mut asked: RepeatRequest) -> Result<RepeatView, Error> {
    let setup = start(Dialect::Sinumerik, asked.setup.take())?.setup;
    repeat_on(&asked, setup)
}

/// What [`repeat`] answers, on this machine.
///
/// # Errors
/// As those of [`repeat`].
pub fn repeat_on(asked: &RepeatRequest, setup: Setup) -> Result<RepeatView, Error> {
    let [function, program] = repeat_texts(asked, &setup)?;
    let ([once, test], (count, _)) = (tests(asked, &setup)?, whole(asked)?);
    let machine = asked.machine.unwrap_or(false);
    let factor = setup.control.active_units.factor();
    let mut notes = beside(&test, &setup, factor);
    let mut lines = Vec::new();
    let values = match &asked.values {
        Some(text) => numbers(text)?,
        None => {
            held(&test, &setup)?;
            lines.push(switched(&once, &test, setup.clone(), factor));
            if setup.probe.repeatability.0 == 0.0 {
                notes.push(Message::new("repeat-no-scatter"));
            }
            let touching = test.repeat(count, Keep::Parameters(FIRST), machine, &|key| key.to_owned());
            touched(&touching, &test, count, setup.clone(), factor)?
        }
    };
    let inch = factor != 1.0;
    let missing = || Error::new("repeat-few", Path::of(&["values"]));
    let repeat = Repeat::of(&values, inch).ok_or_else(missing)?;
    if test.axis == 0 && !machine && setup.control.transverse != Transverse::Radius {
        notes.push(Message::new("repeat-diameters"));
    }
    notes.extend(doubts(&repeat, inch));
    lines.extend(told(&repeat, inch));
    Ok(RepeatView {
        function,
        program,
        says: SAYS,
        unit: if inch { "inch" } else { "mm" },
        usual: usual(asked, &setup, test.axis),
        told: lines,
        notes,
        found: found(values, &repeat),
    })
}

/// The texts of the two programs, of one touch and of repeated ones, whatever they come to.
///
/// # Errors
/// What cannot be tested: which member is at fault.
pub fn repeat_texts(asked: &RepeatRequest, setup: &Setup) -> Result<[String; 2], Error> {
    if setup.control.dialect != Dialect::Sinumerik {
        return Err(Error::new("repeat-control", Path::of(&["setup", "control"])));
    }
    let ([once, test], (count, first)) = (tests(asked, setup)?, whole(asked)?);
    let said = |key: &str| asked.words.as_ref().and_then(|words| words.get(key)).cloned();
    let words = |key: &str| said(key).unwrap_or_else(|| key.to_owned());
    let keep = first.map_or(Keep::Array, Keep::Parameters);
    let machine = asked.machine.unwrap_or(false);
    Ok([once.function(&words), test.repeat(count, keep, machine, &words)])
}

/// What is to be touched once, and what repeatedly.
fn tests(asked: &RepeatRequest, setup: &Setup) -> Result<[ProbeTest; 2], Error> {
    let control = &setup.control;
    let wrong = |name: &'static str| refused(name, [0.0, LARGEST]);
    let letter = asked.axis.as_deref().unwrap_or("X").trim().to_ascii_uppercase();
    let axis = AXES.iter().take(3).position(|axis| *axis == letter).ok_or_else(|| wrong("axis"))?;
    let usual = usual(asked, setup, axis);
    let within = |name: &'static str, value: f64| {
        if value.is_finite() && value.abs() <= LARGEST { Ok(value) } else { Err(wrong(name)) }
    };
    let from = within("from", asked.from.unwrap_or(usual.from))?;
    let ends = [from, within("to", asked.to.unwrap_or(usual.to))?];
    let feed = within("feed", asked.feed.unwrap_or(usual.feed))?;
    let own = if control.bit("_CHBIT[0]") { 2 } else { 1 };
    let input = asked.input.unwrap_or(own);
    for (name, fits) in [("to", ends[0] != ends[1]), ("feed", feed > 0.0), ("input", (1..=2).contains(&input))] {
        if !fits {
            return Err(wrong(name));
        }
    }
    let test = ProbeTest {
        axis,
        ends,
        feed,
        input,
        place: place(control),
        changes: asked.changes.unwrap_or(false),
        plane: control.plane,
        inch: control.active_units == Units::Inch,
    };
    let further = from + direction(control, axis) * of_unit(control).further;
    Ok([ProbeTest { ends: [from, asked.to.unwrap_or(further)], ..test.clone() }, test])
}

/// What is taken where nothing else is asked for.
fn usual(asked: &RepeatRequest, setup: &Setup, axis: usize) -> RepeatUsual {
    let Usual { way, feed, .. } = of_unit(&setup.control);
    let to = asked.from.unwrap_or(0.0) + direction(&setup.control, axis) * way;
    RepeatUsual { from: 0.0, to, feed: *feed, count: TOUCHES }
}

fn of_unit(control: &Control) -> &'static Usual {
    let [metric, inch] = &USUAL;
    if control.active_units == Units::Inch { inch } else { metric }
}

/// T and D number of the probe: what is in the spindle, or as in the programs of the manual.
fn place(control: &Control) -> (i64, i64) {
    if control.tool == 0 { (1, 1) } else { (control.tool, control.edge.max(1)) }
}

/// Direction from the ball of the probe to its body.
fn stands(control: &Control) -> Dir<Mcs> {
    let (tool, edge) = place(control);
    control.edge_of(tool, edge).and_then(Edge::stands).unwrap_or_else(|| upright(control.plane))
}

/// Plus or minus: along the probe its ball goes ahead, across it plus, as in the programs of the manual.
fn direction(control: &Control, axis: usize) -> f64 {
    if stands(control)[axis] > 0.5 { -1.0 } else { 1.0 }
}

/// Nothing touches where the programs call no tool, or another one than a probe, or where its ball does not go ahead.
fn held(test: &ProbeTest, setup: &Setup) -> Result<(), Error> {
    let (tool, edge) = test.place;
    let error = |key: &'static str| {
        let error = Error::new(key, Path::of(&["setup", "tools"]));
        error.number("tool", tool as f64).number("edge", edge as f64)
    };
    let data = setup.control.edge_of(tool, edge).ok_or_else(|| error("repeat-no-tool"))?;
    if ![PROBE, LATHE_PROBE].contains(&data.kind) {
        return Err(error("repeat-no-probe").number("kind", data.kind as f64));
    }
    let [from, to] = test.ends;
    if (to - from) * stands(&setup.control)[test.axis] <= 0.0 {
        return Ok(());
    }
    let other = ((2.0 * from - to) * 1e5).round() / 1e5;
    let behind = Error::new("repeat-behind", Path::of(&["to"]));
    Err(behind.text("axis", AXES[test.axis]).number("to", other))
}

/// How many touches, and the first R parameter that keeps their values.
fn whole(asked: &RepeatRequest) -> Result<(usize, Option<usize>), Error> {
    let within = |name: &'static str, value: f64, ends: [f64; 2]| {
        let fits = value.fract() == 0.0 && (ends[0]..=ends[1]).contains(&value);
        if fits { Ok(value as usize) } else { Err(refused(name, ends)) }
    };
    let count = within("count", asked.count.unwrap_or(TOUCHES), [2.0, MOST[0] as f64])?;
    let first = asked.parameters.map(|first| within("parameters", first, [0.0, 10_000.0]));
    Ok((count, first.transpose()?))
}

/// Why a value cannot be, with the least and the most.
fn refused(name: &'static str, [least, most]: [f64; 2]) -> Error {
    Error::new("repeat-value", Path::of(&[name])).text("name", name).number("least", least).number("most", most)
}

/// Values with blanks, line ends or semicolons between them; a decimal comma is one.
fn numbers(text: &str) -> Result<Vec<f64>, Error> {
    let mut found = Vec::new();
    for word in text.split(|c: char| c.is_whitespace() || c == ';').filter(|word| !word.is_empty()) {
        let number = word.replace(',', ".").parse::<f64>().ok().filter(|number| number.abs() <= LARGEST);
        let wrong = || Error::new("repeat-not-a-number", Path::of(&["values"])).text("value", word);
        found.push(number.ok_or_else(wrong)?);
        if found.len() > MOST[1] {
            let many = Error::new("repeat-many", Path::of(&["values"]));
            return Err(many.number("most", MOST[1] as f64));
        }
    }
    Ok(found)
}

/// The values that the program leaves on a machine whose probe meets a face halfway.
fn touched(text: &str, test: &ProbeTest, count: usize, setup: Setup, factor: f64) -> Result<Vec<f64>, Error> {
    let outcome = at_a_face(text, test, setup, factor);
    let name = |touch: usize| format!("R{}", FIRST + touch);
    if (0..count).any(|touch| outcome.control.data.get(&name(touch)).is_none()) {
        return Err(Error::new("repeat-no-signal", Path::of(&["to"])));
    }
    Ok((0..count).map(|touch| outcome.control.number(&name(touch))).collect())
}

/// What the function test comes to at the face of the repeated touches: R1 holds where the probe switched
/// (B:12825-12856).
fn switched(once: &ProbeTest, test: &ProbeTest, setup: Setup, factor: f64) -> Message {
    let outcome = at_a_face(&once.function(&|key| key.to_owned()), test, setup, factor);
    if outcome.control.data.get("R1").is_none() {
        return Message::new("repeat-not-switched");
    }
    let value = (outcome.control.number("R1") * 1e5).round() / 1e5;
    let unit = if factor == 1.0 { "\u{a0}mm" } else { "\u{a0}inch" };
    Message::new("repeat-switched").text("axis", AXES[test.axis]).number("value", value).text("unit", unit)
}

/// What a program does on a machine whose probe meets a face halfway. The axes of the WCS are those of the machine.
fn at_a_face(text: &str, test: &ProbeTest, mut setup: Setup, factor: f64) -> Outcome {
    let [from, to] = test.ends;
    let control = &mut setup.control;
    (control.tool, control.edge) = test.place;
    control.frames.clear();
    control.stored = BasicFrames::default();
    control.activate(0);
    drop(control.take_frames());
    let shown = if test.axis == 0 { control.transverse.shown() } else { 1.0 };
    let at = |along: f64| {
        let mut point = Mcs::default();
        point[test.axis] = along / shown * factor;
        point
    };
    let body = stands(control);
    let mut centre = at((from + to) / 2.0);
    centre[test.axis] += (to - from).signum() * (setup.probe.radius + BLOCK / 2.0);
    for axis in (0..3).filter(|axis| *axis != test.axis) {
        centre[axis] += body[axis] * (setup.probe.radius - BLOCK / 2.0); // only the ball is as low as the block
    }
    centre[2] += BLOCK / 2.0; // a block stands by the middle of its upper face
    setup.workpiece.solids = vec![Solid::new(Shape::Block { size: [BLOCK; 3] }, centre)];
    setup.tool_probes.clear();
    setup.position = at(from);
    run(&syntax::read(Dialect::Sinumerik, text.as_bytes()), &setup, Limits::default())
}

/// Braking beyond what the probe takes.
fn beside(test: &ProbeTest, setup: &Setup, factor: f64) -> Vec<Message> {
    let told = setup.control.deflection_at(test.feed * factor).filter(|told| told.is_too_far());
    let message = told.map(|told| {
        let message = Message::new("run-deflected-too-far").number("feed", test.feed * factor);
        message.number("path", told.told()).number("deflection", told.permitted)
    });
    message.into_iter().collect()
}

/// What the values come to in words.
fn told(repeat: &Repeat, inch: bool) -> Vec<Message> {
    let digits = if inch { 1e6 } else { 1e5 };
    let round = |value: f64| (value * digits).round() / digits;
    let line = |key: &'static str, values: &[(&'static str, f64)]| {
        let message = Message::new(key).text("unit", if inch { "\u{a0}inch" } else { "\u{a0}mm" });
        values.iter().fold(message, |message, (name, value)| message.number(name, round(*value)))
    };
    let (spread, [smallest, largest]) = (&repeat.spread, repeat.ends);
    let one = spread.deviation;
    let mut lines = vec![
        line("repeat-mean", &[("count", spread.count() as f64), ("mean", spread.mean)]),
        line("repeat-deviation", &[("one", one), ("two", 2.0 * one), ("three", 3.0 * one)]),
        line("repeat-range", &[("smallest", smallest), ("largest", largest), ("range", largest - smallest)]),
        line("repeat-furthest", &[("furthest", repeat.furthest)]),
    ];
    lines.extend(
        repeat.trend.map(|trend| line("repeat-slope", &[("slope", trend.slope)]).number("t", hundredths(trend.t))),
    );
    lines.push(line("repeat-zone", &[("zone", repeat.zone), ("two", repeat.zone_of_two)]));
    lines
}

fn hundredths(value: f64) -> f64 {
    (value * 100.0).round() / 100.0
}

/// What speaks against taking the proposal as it is.
fn doubts(repeat: &Repeat, inch: bool) -> Vec<Message> {
    let mut notes = Vec::new();
    if repeat.trend.is_some_and(|trend| trend.certain) {
        notes.push(Message::new("repeat-drift"));
    }
    if repeat.is_narrow() {
        let digits = if inch { 1e5 } else { 1e4 };
        let three = (3.0 * repeat.spread.deviation * digits).round() / digits;
        notes.push(Message::new("repeat-narrow").number("three", three));
    }
    notes
}

fn found(values: Vec<f64>, repeat: &Repeat) -> RepeatFound {
    let [smallest, largest] = repeat.ends;
    let [fewest, most] = INTERVALS;
    let intervals = repeat.spread.histogram(((values.len() as f64).sqrt().ceil() as usize).clamp(fewest, most));
    RepeatFound {
        mean: repeat.spread.mean,
        deviation: repeat.spread.deviation,
        smallest,
        largest,
        range: largest - smallest,
        furthest: repeat.furthest,
        intervals,
        trend: repeat.trend.map(|trend| RepeatTrend {
            slope: trend.slope,
            correlation: trend.correlation,
            t: trend.t,
            certain: trend.certain,
        }),
        zone: repeat.zone,
        zone_of_two: repeat.zone_of_two,
        values,
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::control::{Frame, Plane};
    use crate::geometry::Rpy;
    use crate::message::Arg;
    use crate::program::findings;
    use crate::workpiece::ProbeBody;

    fn asked() -> RepeatRequest {
        let mut setup = Setup::calibrated(Dialect::Sinumerik, Plane::G17);
        setup.probe.repeatability = (0.001, 7);
        RepeatRequest { setup: Some(machine(&setup)), ..RepeatRequest::default() }
    }

    fn machine(setup: &Setup) -> Machine {
        serde_json::from_str(&serde_json::to_string(setup).unwrap()).unwrap()
    }

    #[test]
    fn ten_touches_spread_as_the_probe_does() {
        // oracle: hand (the face is halfway, the scatter that of the probe: a sample of 400 has its deviation to 15 %)
        let view = repeat(RepeatRequest { count: Some(400.0), ..asked() }).unwrap();
        assert_eq!(view.found.values.len(), 400);
        assert!((view.found.mean - 25.0).abs() < 0.0003, "{}", view.found.mean);
        assert!((view.found.deviation / 0.001 - 1.0).abs() < 0.15, "{}", view.found.deviation);
        assert_eq!(view.found.intervals.iter().sum::<usize>(), 400);
        assert!(view.found.zone >= view.found.furthest && view.found.zone < view.found.furthest + 0.001);
        assert_eq!(view.told[0].key, "repeat-switched"); // the function test meets the same face
    }

    fn figure(message: &Message, name: &str) -> Option<f64> {
        message.args.iter().find_map(|(known, arg)| match arg {
            Arg::Number(number) if *known == name => Some(*number),
            _ => None,
        })
    }

    /// Machines: of each plane, a mill and a lathe, in both units, with each way to give X.
    fn machines() -> impl Iterator<Item = Setup> {
        Plane::ALL.into_iter().flat_map(|plane| {
            let units = [Units::Metric, Units::Inch].into_iter();
            units.flat_map(move |units| {
                let mill = Setup::calibrated_in(Dialect::Sinumerik, plane, units);
                let lathe = Setup::turning_in(plane, units);
                [mill, lathe].into_iter().flat_map(|setup| {
                    let all = [Transverse::Radius, Transverse::Diameter, Transverse::AbsoluteDiameter];
                    all.map(|transverse| {
                        let mut setup = setup.clone();
                        setup.control.transverse = transverse;
                        setup
                    })
                })
            })
        })
    }

    // oracle: hand (the face is halfway; along the probe it touches with its ball ahead)
    #[test]
    fn wherever_the_machine_stands_the_face_is_halfway() {
        for mut setup in machines() {
            let control = &mut setup.control;
            let turned = Frame { coarse: [7.0, -8.0, 9.0], rotation: Rpy([0.0, 0.0, 30.0]), ..Frame::default() };
            control.stored.channel.insert(0, turned);
            control.frames.insert(1, turned);
            control.activate(1);
            setup.probe.body = Some(ProbeBody { radius: 20.0, distance: 15.0 });
            let (units, plane, transverse) = (control.active_units, control.plane, control.transverse);
            for axis in ["X", "Y", "Z"] {
                for (from, to) in [(None, None), (Some(0.0), Some(4.0)), (Some(30.0), Some(-10.0)), (Some(-3.0), None)]
                {
                    let request = RepeatRequest { axis: Some(axis.into()), from, to, ..RepeatRequest::default() };
                    let which = format!("{plane:?} {units:?} {transverse:?} {axis} {from:?} {to:?}");
                    let view = match repeat_on(&request, setup.clone()) {
                        Ok(view) => view,
                        Err(error) => {
                            assert!(error.message.key == "repeat-behind" && to.is_some(), "{which}: {error:?}");
                            continue;
                        }
                    };
                    let middle = (from.unwrap_or(0.0) + to.unwrap_or(view.usual.to)) / 2.0;
                    assert!((view.found.mean - middle).abs() < 1e-6, "{which}: {}", view.found.mean);
                    assert_eq!(view.told[0].key, "repeat-switched", "{which}");
                    assert!(
                        (figure(&view.told[0], "value").unwrap() - middle).abs() < 1e-4,
                        "{which}: {:?}",
                        view.told
                    );
                }
            }
        }
    }

    // oracle: hand (a diameter scatters twice as far as its radius; values of the machine system are radii)
    #[test]
    fn values_of_diameters_scatter_twice_as_far() {
        let of = |axis: &str, machine| {
            let mut setup = Setup::turning(Plane::G18);
            setup.probe.repeatability = (0.001, 7);
            let (count, axis) = (Some(400.0), Some(axis.to_owned()));
            let view = repeat_on(&RepeatRequest { axis, count, machine, ..RepeatRequest::default() }, setup).unwrap();
            let told = view.notes.iter().any(|note| note.key == "repeat-diameters");
            (told, (view.found.deviation * 1000.0).round())
        };
        assert_eq!(of("X", None), (true, 2.0));
        assert_eq!(of("X", Some(true)), (false, 1.0));
        assert_eq!(of("Z", None), (false, 1.0));
    }

    // oracle: manual B:12825-12856, B:15187-15217 (F150, X100 once, X50 repeatedly), hand (the ball goes ahead)
    #[test]
    fn what_is_not_asked_for_is_as_in_the_manual() {
        let of = |setup: Setup, axis: &str| {
            repeat_on(&RepeatRequest { axis: Some(axis.into()), ..RepeatRequest::default() }, setup).unwrap()
        };
        let view = of(Setup::calibrated(Dialect::Sinumerik, Plane::G17), "X");
        assert!(view.function.contains("G0 X0 F150") && view.function.contains("G1 X100\n"), "{}", view.function);
        assert!(view.program.contains("G0 X0 F150") && view.program.contains("G1 X50\n"), "{}", view.program);
        assert_eq!((view.usual.from, view.usual.to, view.usual.feed, view.usual.count), (0.0, 50.0, 150.0, 10.0));
        let view = of(Setup::calibrated_in(Dialect::Sinumerik, Plane::G17, Units::Inch), "Z");
        assert!(view.function.contains("G0 Z0 F6") && view.function.contains("G1 Z-4\n"), "{}", view.function);
        assert_eq!((view.usual.to, view.usual.feed, view.unit), (-2.0, 6.0, "inch"));
        for (plane, along) in [(Plane::G17, "Z"), (Plane::G18, "Y"), (Plane::G19, "X")] {
            for axis in ["X", "Y", "Z"] {
                let to = of(Setup::calibrated(Dialect::Sinumerik, plane), axis).usual.to;
                assert_eq!(to, if axis == along { -50.0 } else { 50.0 }, "{plane:?} {axis}");
            }
        }
        // the probe of the turning machine points in minus direction of Z
        let lathe = Setup::turning(Plane::G18);
        assert_eq!(["X", "Z"].map(|axis| of(lathe.clone(), axis).usual.to), [50.0, -50.0]);
    }

    // oracle: hand
    #[test]
    fn why_nothing_touches_is_told_with_what_to_change() {
        let setup = || Setup::calibrated(Dialect::Sinumerik, Plane::G17);
        let along = |from, to| RepeatRequest { axis: Some("Z".into()), from, to, ..RepeatRequest::default() };
        for (from, to, other) in [(None, Some(50.0), -50.0), (Some(10.0), Some(300.0), -280.0)] {
            let error = repeat_on(&along(from, to), setup()).unwrap_err();
            assert_eq!((error.message.key.as_ref(), figure(&error.message, "to")), ("repeat-behind", Some(other)));
            assert!(repeat_on(&along(from, Some(other)), setup()).is_ok());
        }
        let mut mill = setup();
        mill.control.edge_made(9, 1).kind = 120;
        let error = repeat_on(&along(None, None), mill.clone()).unwrap_err();
        assert_eq!((error.message.key.as_ref(), figure(&error.message, "kind")), ("repeat-no-probe", Some(120.0)));
        // the programs are written, and values of a real machine are evaluated
        assert!(repeat_texts(&along(None, Some(50.0)), &mill).is_ok());
        let real = RepeatRequest { values: Some("1 2 3".into()), ..along(None, Some(50.0)) };
        assert!(repeat_on(&real, mill).is_ok());
    }

    #[test]
    fn the_programs_are_right() {
        // oracle: manual B:12825-12856, B:15187-15217 (what they contain), self (no finding)
        let view = repeat(asked()).unwrap();
        for part in ["MEAS=PW_IN G1 X100", "STOPRE", "$AC_MEA[PW_IN]", "R1=$AA_MW[X] R2=$AA_MM[X]", "T9 D1"] {
            assert!(view.function.contains(part), "{part}\n{}", view.function);
        }
        for part in ["DEF REAL PW_VAL[10]", "MEAS=1 G1 X50", "PW_VAL[PW_K]=$AA_MW[X]", "IF PW_K<10 GOTOB PW_NEXT"] {
            assert!(view.program.contains(part), "{part}\n{}", view.program);
        }
        for text in [&view.function, &view.program] {
            assert_eq!(findings(&syntax::read(Dialect::Sinumerik, text.as_bytes())), [], "{text}");
        }
        let kept = RepeatRequest { parameters: Some(100.0), machine: Some(true), changes: Some(true), ..asked() };
        let view = repeat(kept).unwrap();
        assert!(view.program.contains("R[100+PW_K]=$AA_MM[X]") && view.program.contains("N30 M6"), "{}", view.program);
    }

    #[test]
    fn values_of_a_real_machine_are_evaluated() {
        // oracle: hand (see series::repeat)
        let text = "20,0012 20.0013;20.0027\n20.0028 20.0028 20.0041 20.0054 20.0051 20.0061 20.0060";
        let view = repeat(RepeatRequest { values: Some(text.into()), ..asked() }).unwrap();
        assert!((view.found.mean - 20.00375).abs() < 1e-9 && (view.found.zone - 0.003).abs() < 1e-12);
        let keys: Vec<_> = view.notes.iter().map(|note| note.key.as_ref()).collect();
        assert_eq!(keys, ["repeat-drift", "repeat-narrow"]);
    }

    #[test]
    fn what_cannot_be_tested_is_told() {
        // oracle: hand
        let refused = |request: RepeatRequest| repeat(request).unwrap_err().message.key.to_string();
        assert_eq!(refused(RepeatRequest { axis: Some("Q".into()), ..asked() }), "repeat-value");
        assert_eq!(refused(RepeatRequest { to: Some(0.0), ..asked() }), "repeat-value");
        assert_eq!(refused(RepeatRequest { feed: Some(f64::NAN), ..asked() }), "repeat-value");
        for count in [-4.0, 0.0, 1.0, 2.5, MOST[0] as f64 + 1.0, f64::NAN] {
            let error = repeat(RepeatRequest { count: Some(count), ..asked() }).unwrap_err();
            let words = crate::words::Words::english().text(&error.message);
            assert!(words.contains("touches") && words.contains("from 2 to 500"), "{count}: {words}");
        }
        assert_eq!(refused(RepeatRequest { parameters: Some(-1.0), ..asked() }), "repeat-value");
        assert_eq!(refused(RepeatRequest { values: Some("1 two".into()), ..asked() }), "repeat-not-a-number");
        assert_eq!(refused(RepeatRequest { values: Some("1".into()), ..asked() }), "repeat-few");
        let nct = machine(&Setup::calibrated(Dialect::Nct, Plane::G17));
        assert_eq!(refused(RepeatRequest { setup: Some(nct), ..asked() }), "repeat-control");
    }
}
