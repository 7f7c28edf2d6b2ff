//! The whole catalogue as JSON.

use super::setup_write::plane_name;
use super::{code, dialect_name, object, style_name, typed};
use crate::catalogue::CYCLES;
use crate::catalogue::example::{choosing, example, turned};
use crate::check;
use crate::control::MachineSort;
use crate::control::{Plane, delivery};
use crate::entry::{Cycle, Param, ProbeUse, ResultField, Style, Unit, Variant};
use crate::workpiece::free::EXAMPLES;
use serde_json::Value;

/// What the page asks for first: the cycles under a name.
pub fn catalogue() -> Value {
    object([("cycles", cycles())])
}

/// One object a cycle: control, cycle, purpose, ways of writing, variants, parameters, results, alarms, with their
/// places in the manual.
pub fn cycles() -> Value {
    CYCLES.iter().map(|cycle| entry(cycle)).collect()
}

fn entry(cycle: &'static Cycle) -> Value {
    let variants = cycle.variants.iter();
    let example = cycle.example.iter();
    object([
        ("control", dialect_name(cycle.dialect).into()),
        ("cycle", cycle.name.into()),
        ("key", cycle.key.into()),
        ("purpose", purpose(cycle)),
        ("styles", styles(cycle)),
        ("variants", variants.map(|one| variant(cycle, one)).collect()),
        ("parameters", cycle.params.iter().map(param).collect()),
        ("results", cycle.results.iter().map(result).collect()),
        ("alarms", cycle.alarms().into_iter().map(code).collect()),
        ("example", object(example.map(|(name, value)| (name.as_str(), (*value).into())))),
        ("twins", (!cycle.purpose.tasks.is_empty()).into()),
        ("simulated", cycle.simulation.is_some().into()),
        ("surfaces", surfaces(cycle)),
        ("source", cycle.source.into()),
    ])
}

/// Names of our surfaces, for a cycle that scans one.
fn surfaces(cycle: &'static Cycle) -> Value {
    let names = EXAMPLES.iter().filter(|_| cycle.scan().is_some());
    names.map(|(name, _)| Value::from(*name)).collect()
}

/// Where it belongs: sort of machine, probe, and whether calibrating is all that it does.
fn purpose(cycle: &'static Cycle) -> Value {
    let machine = match cycle.purpose.machine {
        MachineSort::Milling => "milling",
        MachineSort::Turning => "turning",
        MachineSort::Any => "any",
    };
    let probe = match cycle.purpose.probe {
        ProbeUse::Workpiece => "workpiece",
        ProbeUse::Tool => "tool",
        ProbeUse::None => "none",
        ProbeUse::Log => "log",
    };
    let control = delivery(cycle.dialect);
    let calibrates = |variant: &Variant| {
        let typed = choosing(cycle, variant.number);
        let inputs = check::read(cycle, &typed, &control, &mut Vec::new());
        cycle.purpose.calibrates.holds(&inputs)
    };
    let plane = cycle.purpose.machine.plane().map(plane_name);
    object([
        ("machine", machine.into()),
        ("plane", plane.into()),
        ("probe", probe.into()),
        ("calibrates", cycle.variants.iter().all(calibrates).into()),
    ])
}

/// The ways of writing that its call has, direct first.
fn styles(cycle: &Cycle) -> Value {
    let has = |style: &Style| {
        *style == Style::Direct || cycle.lists.iter().any(|list| list.style == *style && list.is_written())
    };
    let all = [Style::Direct, Style::Indirect, Style::Operate];
    all.into_iter().filter(has).map(style_name).collect()
}

fn variant(cycle: &'static Cycle, variant: &Variant) -> Value {
    object([
        ("mvar", variant.number.into()),
        ("key", variant.key.into()),
        ("source", variant.source.into()),
        ("choices", cycle.choices(variant.number).collect()),
        ("values", typed(&choosing(cycle, variant.number))),
        ("example", typed(&example(cycle, variant))),
        ("planes", planes(cycle, variant)),
    ])
}

/// Values and example in the planes in which other addresses name the axes.
fn planes(cycle: &'static Cycle, variant: &Variant) -> Value {
    let usual = [choosing(cycle, variant.number), example(cycle, variant)];
    let others = [Plane::G18, Plane::G19].into_iter().filter_map(|plane| {
        let there = usual.each_ref().map(|values| turned(cycle, values, plane));
        let [values, example] = there.each_ref().map(typed);
        let said = object([("values", values), ("example", example)]);
        (there != usual).then(|| (plane_name(plane), said))
    });
    object(others)
}

fn param(param: &Param) -> Value {
    object([
        ("name", param.name.into()),
        ("key", param.key.into()),
        ("unit", unit_rule(param.unit).into()),
        ("default", param.default.into()),
        ("source", param.source.into()),
    ])
}

fn result(field: &ResultField) -> Value {
    object([
        ("name", field.name.into()),
        ("key", field.key.into()),
        ("unit", unit_rule(field.unit).into()),
        ("source", field.source.into()),
    ])
}

/// The rule, not the unit that it gives on a machine.
fn unit_rule(unit: Unit) -> &'static str {
    match unit {
        Unit::None => "",
        Unit::ActiveLength => "active length",
        Unit::BasicLength => "basic length",
        Unit::Millimetre => "mm",
        Unit::Degree => "deg",
        Unit::BasicFeed => "basic feed",
    }
}
