//! Does the probe switch, and how far do repeated touches spread: the two test programs, one of them run on the
//! machine, and what values of it or of a real machine come to.

use super::Error;
use super::start::{Machine, start};
use crate::control::{AXES, Units};
use crate::dialect::Dialect;
use crate::entry::Typed;
use crate::geometry::{Mcs, Wcs};
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

/// What is tested.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(default)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct RepeatRequest {
    /// Axis that moves: `X`, `Y`, `Z`; absent: X.
    pub axis: Option<String>,
    /// Where the motion begins, in the unit that is active; absent: 0.
    pub from: Option<f64>,
    /// Where it ends without a signal; absent: 50.
    pub to: Option<f64>,
    /// Feed a minute in that unit; absent: 150 mm/min.
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
    /// What the values come to, a line each.
    pub told: Vec<Message>,
    /// What should be known beside it.
    pub notes: Vec<Message>,
    /// What the values come to.
    pub found: RepeatFound,
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
    let (test, (count, _)) = (test(asked, &setup)?, whole(asked)?);
    let machine = asked.machine.unwrap_or(false);
    let factor = setup.control.active_units.factor();
    let mut notes = beside(&test, &setup, factor);
    let mut lines = Vec::new();
    let values = match &asked.values {
        Some(text) => numbers(text)?,
        None => {
            held(&test, &setup)?;
            lines.push(switched(&test, setup.clone(), factor));
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
    notes.extend(doubts(&repeat, inch));
    lines.extend(told(&repeat, inch));
    Ok(RepeatView {
        function,
        program,
        says: SAYS,
        unit: if inch { "inch" } else { "mm" },
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
    let (test, (count, first)) = (test(asked, setup)?, whole(asked)?);
    let said = |key: &str| asked.words.as_ref().and_then(|words| words.get(key)).cloned();
    let words = |key: &str| said(key).unwrap_or_else(|| key.to_owned());
    let keep = first.map_or(Keep::Array, Keep::Parameters);
    let machine = asked.machine.unwrap_or(false);
    Ok([test.function(&words), test.repeat(count, keep, machine, &words)])
}

/// What is to be touched.
fn test(asked: &RepeatRequest, setup: &Setup) -> Result<ProbeTest, Error> {
    let control = &setup.control;
    let wrong = |name: &'static str| refused(name, [0.0, LARGEST]);
    let letter = asked.axis.as_deref().unwrap_or("X").trim().to_ascii_uppercase();
    let axis = AXES.iter().take(3).position(|axis| *axis == letter).ok_or_else(|| wrong("axis"))?;
    let within = |name: &'static str, value: f64| {
        if value.is_finite() && value.abs() <= LARGEST { Ok(value) } else { Err(wrong(name)) }
    };
    let ends = [within("from", asked.from.unwrap_or(0.0))?, within("to", asked.to.unwrap_or(50.0))?];
    let inch = control.active_units == Units::Inch;
    let delivered = 150.0 / control.active_units.factor();
    let feed = within("feed", asked.feed.unwrap_or(delivered))?;
    let own = if control.bit("_CHBIT[0]") { 2 } else { 1 };
    let input = asked.input.unwrap_or(own);
    for (name, fits) in [("to", ends[0] != ends[1]), ("feed", feed > 0.0), ("input", (1..=2).contains(&input))] {
        if !fits {
            return Err(wrong(name));
        }
    }
    let place = if control.tool == 0 { (1, 1) } else { (control.tool, control.edge.max(1)) };
    Ok(ProbeTest {
        axis,
        ends,
        feed,
        input,
        place,
        changes: asked.changes.unwrap_or(false),
        plane: control.plane,
        inch,
    })
}

/// The programs call a tool, without which nothing touches.
fn held(test: &ProbeTest, setup: &Setup) -> Result<(), Error> {
    let (tool, edge) = test.place;
    if setup.control.tools.get(&tool).is_some_and(|one| one.edges.contains_key(&edge)) {
        return Ok(());
    }
    let missing = Error::new("repeat-no-tool", Path::of(&["setup", "tools"]));
    Err(missing.number("tool", tool as f64).number("edge", edge as f64))
}

/// How many touches, and the first R parameter that keeps their values.
fn whole(asked: &RepeatRequest) -> Result<(usize, Option<usize>), Error> {
    let within = |name: &'static str, value: f64, ends: [f64; 2]| {
        let fits = value.fract() == 0.0 && (ends[0]..=ends[1]).contains(&value);
        if fits { Ok(value as usize) } else { Err(refused(name, ends)) }
    };
    let count = within("count", asked.count.unwrap_or(10.0), [2.0, MOST[0] as f64])?;
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

/// What the function test comes to there: R1 holds where the probe switched (B:12825-12856).
fn switched(test: &ProbeTest, setup: Setup, factor: f64) -> Message {
    let outcome = at_a_face(&test.function(&|key| key.to_owned()), test, setup, factor);
    if outcome.control.data.get("R1").is_none() {
        return Message::new("repeat-not-switched");
    }
    let value = (outcome.control.number("R1") * 1e5).round() / 1e5;
    let unit = if factor == 1.0 { "\u{a0}mm" } else { "\u{a0}inch" };
    Message::new("repeat-switched").text("axis", AXES[test.axis]).number("value", value).text("unit", unit)
}

/// What a program does on a machine whose probe meets a face halfway.
fn at_a_face(text: &str, test: &ProbeTest, mut setup: Setup, factor: f64) -> Outcome {
    let [from, to] = test.ends;
    let control = &mut setup.control;
    control.frames.clear();
    control.activate(0);
    let at = |along: f64| {
        let mut point = [0.0; 3];
        point[test.axis] = along * factor;
        control.to_machine(Wcs(point))
    };
    let (start, middle) = (at(from), at((from + to) / 2.0));
    let mut centre = middle.0;
    centre[test.axis] += (to - from).signum() * (setup.probe.radius + BLOCK / 2.0);
    centre[2] += BLOCK / 2.0; // a block stands by the middle of its upper face
    setup.workpiece.solids = vec![Solid::new(Shape::Block { size: [BLOCK; 3] }, Mcs(centre))];
    setup.position = start;
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
    use crate::control::Plane;
    use crate::program::findings;

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

    #[test]
    fn each_axis_and_direction_meets_its_face() {
        // oracle: hand (halfway between the ends)
        for axis in ["X", "Y"] {
            for (from, to) in [(0.0, 50.0), (30.0, -10.0)] {
                let request = RepeatRequest { axis: Some(axis.into()), from: Some(from), to: Some(to), ..asked() };
                let view = repeat(request).unwrap();
                assert!((view.found.mean - (from + to) / 2.0).abs() < 0.002, "{axis} {from}: {}", view.found.mean);
            }
        }
        let down = RepeatRequest { axis: Some("Z".into()), from: Some(20.0), to: Some(0.0), ..asked() };
        let view = repeat(down).unwrap();
        assert!(view.found.range > 0.0 && view.found.range < 0.01, "{:?}", view.found);
    }

    #[test]
    fn the_programs_are_right() {
        // oracle: manual B:12825-12856, B:15187-15217 (what they contain), self (no finding)
        let view = repeat(asked()).unwrap();
        for part in ["MEAS=PW_IN G1 X50", "STOPRE", "$AC_MEA[PW_IN]", "R1=$AA_MW[X] R2=$AA_MM[X]", "T9 D1"] {
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
