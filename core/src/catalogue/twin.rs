//! A measurement as the other control writes it: what a call means is taken from its values and written with those of
//! the entry that has the task there.

use super::example::example;
use super::twin_place::has_depth;
use super::{CYCLES, twin_place};
use crate::catalogue::prelude::*;
use crate::check;
use crate::control::delivery_in;
use crate::control::variables::AXES;
use crate::dialect::Dialect;

/// What a measurement is, whatever a control calls it. Lengths in mm.
#[derive(Clone, Debug, PartialEq)]
pub struct Measurement {
    /// What is measured.
    pub task: Task,
    /// Whether a tool is corrected; else a zero offset, or nothing.
    pub corrects_tool: bool,
    /// Set value; with a tolerance the middle of its limits.
    pub nominal: Option<f64>,
    /// Set lengths of a rectangle along abscissa and ordinate; with a tolerance the middles of their limits.
    pub sides: Option<[f64; 2]>,
    /// Part of the plane across which is measured: 0 abscissa, 1 ordinate, 2 applicate.
    pub axis: Option<usize>,
    /// Coordinate of the tool axis at which a boss or web is touched.
    pub depth: Option<f64>,
    /// Coordinates that a corner gets in the plane.
    pub corner: Option<[f64; 2]>,
    /// Half of the tolerance.
    pub half: Option<f64>,
    /// Deviation from which nothing is corrected.
    pub limit: Option<f64>,
    /// Way past the set place.
    pub reach: Option<f64>,
    /// Zero offset that both controls have: 1 is G54.
    pub zero: Option<i64>,
    /// Tool that is corrected.
    pub tool: Option<i64>,
}

/// A call of the other control.
pub struct Twin {
    /// Cycle that is called.
    pub cycle: &'static Cycle,
    /// Values as typed.
    pub values: Typed,
    /// What both have in common.
    pub measurement: Measurement,
    /// What is different there.
    pub differences: Vec<Message>,
}

/// Zero offsets that both controls have: G54 to G59, of which a SINUMERIK calls the last two G505 and G506.
const ZEROS: std::ops::RangeInclusive<i64> = 1..=6;

/// What the lists of newer controls add for the coarse part.
const COARSE: i64 = 10_000;

/// The control that a call is not of.
pub fn other(dialect: Dialect) -> Dialect {
    match dialect {
        Dialect::Sinumerik => Dialect::Nct,
        Dialect::Nct => Dialect::Sinumerik,
    }
}

/// A measurement as the other control does it in the same plane and system of units; none where it has no such task.
pub fn twin(cycle: &'static Cycle, typed: &Typed, control: &Control) -> Option<Twin> {
    let inputs = check::read(cycle, typed, control, &mut Vec::new());
    let (shared, measurement) = measured(&inputs, control)?;
    let mut there = delivery_in(other(cycle.dialect), control.basic_units);
    there.plane = control.plane;
    there.active_units = control.active_units;
    let (cycle_there, shared_there) = entry(there.dialect, &measurement)?;
    let measurement = common(measurement, shared_there);
    let (values, of_example) = written(cycle_there, shared_there, &measurement, &there);
    let mut differences = told(&inputs, shared, &measurement, &there);
    let only = only_here(&inputs, shared, &|meaning| has(shared_there, meaning));
    differences.extend(one_sided("twin-only", &only, cycle));
    differences.extend(one_sided("twin-example", &of_example, cycle_there));
    Some(Twin { cycle: cycle_there, values, measurement, differences })
}

/// What a call measures.
pub fn measured(inputs: &Inputs, control: &Control) -> Option<(&'static Shared, Measurement)> {
    let shared = inputs.cycle.purpose.tasks.iter().find(|shared| shared.when.holds(inputs))?;
    let given = |meaning: Meaning| shared.given(meaning, inputs);
    let (in_axis, nominal) = match in_axis(inputs, shared) {
        Some((axis, value)) => (Some(axis), Some(value)),
        None => (None, given(Meaning::Nominal)),
    };
    let limits = given(Meaning::Upper).zip(given(Meaning::Lower));
    let sides = given(Meaning::FirstSide).zip(given(Meaning::SecondSide));
    let middle = limits.map_or(0.0, |(upper, lower)| (upper + lower) / 2.0);
    let number = |meaning| given(meaning).map(|number| number as i64);
    let axis = number(Meaning::Axis).and_then(|axis| usize::try_from(axis - 1).ok());
    let tool = number(Meaning::Tool);
    let measurement = Measurement {
        task: shared.task,
        corrects_tool: shared.tool.unwrap_or(tool.is_some()),
        nominal: nominal.map(|nominal| nominal + middle),
        sides: sides.map(|(first, second)| [first + middle, second + middle]),
        axis: in_axis.or(axis),
        depth: twin_place::depth(inputs, shared, control),
        corner: twin_place::corner(inputs, shared),
        half: given(Meaning::Half).or(limits.map(|(upper, lower)| (upper - lower) / 2.0)),
        limit: given(Meaning::Limit),
        reach: given(Meaning::Reach),
        zero: number(Meaning::Zero).map(settable).filter(|number| ZEROS.contains(number)),
        tool,
    };
    Some((shared, measurement))
}

/// A zero offset whose coarse part a newer control corrects by 10000 more is the one with its number.
fn settable(number: i64) -> i64 {
    if is_coarse(number) { number - COARSE } else { number }
}

fn is_coarse(number: i64) -> bool {
    (COARSE + 1..=COARSE + 99).contains(&number)
}

/// The zero offset of a call that no other control has; none where it corrects none.
pub fn lost_zero(shared: &Shared, inputs: &Inputs, measurement: &Measurement) -> Option<f64> {
    shared.given(Meaning::Zero, inputs).filter(|zero| *zero != 0.0 && measurement.zero.is_none())
}

/// That the other control has no coarse part of a zero offset, where the call corrects it.
pub fn coarse(shared: &Shared, inputs: &Inputs) -> Option<Message> {
    let number = shared.given(Meaning::Zero, inputs).filter(|number| is_coarse(*number as i64))?;
    Some(Message::new("twin-coarse").number("value", number))
}

/// The set value in the address of an axis: the part of the plane to which the axis belongs, and the value. The axis of
/// the tool counts only where the surface lies across it; else its address is a depth.
fn in_axis(inputs: &Inputs, shared: &Shared) -> Option<(usize, f64)> {
    shared.values.iter().find_map(|(name, meaning)| {
        let part = part_of(*meaning, *name, inputs).filter(|_| *meaning == Meaning::NominalInAxis)?;
        let counts = (part == 2) == along_tool(shared.task);
        Some((part, inputs.given(*name).filter(|_| counts)?))
    })
}

/// Part of the plane to which the axis belongs that an address names.
pub fn part_of(meaning: Meaning, name: Name, inputs: &Inputs) -> Option<usize> {
    let axis = AXES.iter().position(|axis| *axis == name)?;
    let part = inputs.plane.axes().iter().position(|of_plane| *of_plane == axis);
    part.filter(|_| matches!(meaning, Meaning::NominalInAxis | Meaning::CornerInAxis))
}

/// Whether the surface of a task lies across the axis of the tool.
fn along_tool(task: Task) -> bool {
    matches!(task, Task::Face | Task::Length)
}

/// The cycle of a control that has the task.
fn entry(dialect: Dialect, wanted: &Measurement) -> Option<(&'static Cycle, &'static Shared)> {
    let cycles = CYCLES.iter().filter(|cycle| cycle.dialect == dialect);
    let mut all = cycles.flat_map(|cycle| cycle.purpose.tasks.iter().map(move |shared| (*cycle, shared)));
    all.find(|(_, shared)| {
        let tool = shared.tool.is_none_or(|tool| tool == wanted.corrects_tool);
        shared.task == wanted.task && tool
    })
}

/// The values that say the same there and what the call needs beside them; parameters that have that from the worked
/// measurement.
fn written(cycle: &'static Cycle, shared: &Shared, wanted: &Measurement, control: &Control) -> (Typed, Vec<Name>) {
    let mut inputs = Inputs::new(cycle, shared.variant);
    inputs.plane = control.plane;
    let mut all = choosing(cycle, shared.variant, &inputs);
    for (name, meaning) in shared.values {
        let Some(param) = cycle.param(name) else { continue };
        if let Some(value) = value_of(*meaning, *name, wanted, &inputs, control) {
            let value = match meaning {
                Meaning::ZeroAtCorner => value, // a choice, though its parameter is a length elsewhere
                _ => value / factor(param.unit, control),
            };
            all.insert(param.name.to_string(), plain(value));
        }
    }
    let read = check::read(cycle, &all, control, &mut Vec::new());
    let variant = cycle.variants.iter().find(|variant| variant.number == shared.variant);
    let worked = variant.map(|variant| example(cycle, variant)).unwrap_or_default();
    let mut of_example = Vec::new();
    for param in cycle.params {
        let missing = required(param, &read, control) && !all.contains_key(param.name.as_str());
        if let Some(value) = worked.get(param.name.as_str()).filter(|_| missing) {
            all.insert(param.name.to_string(), value.clone());
            of_example.push(param.name);
        }
    }
    (all, of_example)
}

fn required(param: &Param, read: &Inputs, control: &Control) -> bool {
    param.need(read).map(|(level, _)| level) == Some(Level::Required) && param.fallback(control).is_none()
}

/// The number of a variant, or the addresses whose presence makes it in this plane.
fn choosing(cycle: &Cycle, variant: i64, inputs: &Inputs) -> Typed {
    let mut typed = Typed::new();
    if let Some(name) = cycle.variant_param() {
        typed.insert(name.to_string(), variant.to_string());
    }
    for param in cycle.params {
        let chosen = param.chooses.iter().find(|one| one.variant == variant && one.when.holds(inputs));
        typed.extend(chosen.map(|chosen| (param.name.to_string(), chosen.typed.to_owned())));
    }
    typed
}

/// The value in mm that a parameter with this meaning gets.
fn value_of(meaning: Meaning, name: Name, wanted: &Measurement, inputs: &Inputs, control: &Control) -> Option<f64> {
    match meaning {
        Meaning::NominalInAxis if has_depth(wanted.task) && part_of(meaning, name, inputs) == Some(2) => wanted.depth,
        // the walls of NCT lie along the axes
        Meaning::EdgeAngle => wanted.corner.map(|_| 0.0),
        Meaning::Infeed => twin_place::infeed(wanted.depth?, control.active_units),
        Meaning::CornerInAxis | Meaning::ZeroAtCorner | Meaning::ZeroAbscissa | Meaning::ZeroOrdinate => {
            twin_place::of_corner(meaning, name, wanted.corner?, inputs)
        }
        Meaning::Nominal => wanted.nominal,
        Meaning::FirstSide => wanted.sides.map(|[first, _]| first),
        Meaning::SecondSide => wanted.sides.map(|[_, second]| second),
        Meaning::Axis => wanted.axis.map(|axis| axis as f64 + 1.0),
        Meaning::NominalInAxis => {
            let part = part_of(meaning, name, inputs)?;
            let axis = if along_tool(wanted.task) { 2 } else { wanted.axis? };
            wanted.nominal.filter(|_| part == axis)
        }
        Meaning::Upper | Meaning::Half => wanted.half,
        Meaning::Lower => wanted.half.map(|half| -half),
        Meaning::Limit => wanted.limit,
        Meaning::Reach => wanted.reach,
        Meaning::Zero => wanted.zero.map(|zero| zero as f64),
        Meaning::Tool => wanted.tool.map(|tool| tool as f64),
    }
}

/// A number without what the last digits of a sum lack.
fn plain(value: f64) -> String {
    let text = format!("{value:.9}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".into() } else { text.into() }
}

/// What the reader of both calls has to know about what they share.
fn told(inputs: &Inputs, shared: &Shared, measurement: &Measurement, control: &Control) -> Vec<Message> {
    let mut all = Vec::new();
    let has = |meaning: Meaning| shared.given(meaning, inputs);
    let limits = has(Meaning::Upper).zip(has(Meaning::Lower));
    if limits.is_some_and(|(upper, lower)| upper + lower != 0.0) {
        all.push(Message::new("twin-middle"));
    }
    // 0 is no correction on SINUMERIK, and the common zero offset on NCT
    let nct = inputs.cycle.dialect == Dialect::Nct;
    let zero = has(Meaning::Zero).is_some_and(|zero| zero != 0.0 || nct);
    let said = [
        ("twin-no-zero", zero && measurement.zero.is_none()),
        ("twin-at-once", measurement.zero.is_some()),
        ("twin-names", measurement.zero.is_some_and(|zero| zero > 4)),
        ("twin-register", measurement.tool.is_some()),
    ];
    all.extend(said.into_iter().filter(|(_, holds)| *holds).map(|(key, _)| Message::new(key)));
    all.extend(coarse(shared, inputs));
    if has_depth(measurement.task) {
        let [.., axis] = control.plane.axes();
        let height = twin_place::start(control.active_units) / control.active_factor();
        all.push(Message::new("twin-depth").text("axis", AXES[axis]).number("height", height));
    }
    all.extend(measurement.task.differences().iter().copied().map(Message::new));
    all
}

/// What only one of the two calls says.
pub fn one_sided(key: &'static str, names: &[Name], cycle: &Cycle) -> Option<Message> {
    (!names.is_empty()).then(|| Message::new(key).text("names", names.join(", ")).text("cycle", cycle.name))
}

/// Parameters that count in this call and have no counterpart there.
pub fn only_here(inputs: &Inputs, here: &Shared, there: &dyn Fn(Meaning) -> bool) -> Vec<Name> {
    let means = |name: Name| here.values.iter().any(|(known, meaning)| *known == name && there(*meaning));
    let counts = inputs.cycle.params.iter().filter(|param| {
        let variant = inputs.cycle.variant_param() == Some(param.name);
        let used = inputs.uses(param.name) && inputs.given(param.name).is_some();
        used && !variant && !means(param.name) && param.chooses.is_empty()
    });
    counts.map(|param| param.name).collect()
}

/// Whether a task has a place for a value with this meaning, in whichever form.
fn has(shared: &Shared, meaning: Meaning) -> bool {
    use Meaning::{
        Axis, CornerInAxis, Half, Infeed, Lower, Nominal, NominalInAxis, Upper, ZeroAbscissa, ZeroAtCorner,
        ZeroOrdinate,
    };
    let same: &[Meaning] = match meaning {
        Infeed => &[Infeed, NominalInAxis],
        CornerInAxis | ZeroAtCorner | ZeroAbscissa | ZeroOrdinate => &[CornerInAxis, ZeroAtCorner],
        Upper | Lower | Half => &[Upper, Half],
        Nominal | NominalInAxis => &[Nominal, NominalInAxis],
        Axis => &[Axis, NominalInAxis],
        _ => &[meaning],
    };
    shared.values.iter().any(|(_, other)| same.contains(other))
}

/// A measurement without what the other call has no place for.
fn common(all: Measurement, there: &Shared) -> Measurement {
    Measurement {
        depth: all.depth.filter(|_| has(there, Meaning::Infeed)),
        corner: all.corner.filter(|_| has(there, Meaning::CornerInAxis)),
        half: all.half.filter(|_| has(there, Meaning::Half)),
        limit: all.limit.filter(|_| has(there, Meaning::Limit)),
        reach: all.reach.filter(|_| has(there, Meaning::Reach)),
        zero: all.zero.filter(|_| has(there, Meaning::Zero)),
        tool: all.tool.filter(|_| has(there, Meaning::Tool)),
        ..all
    }
}
