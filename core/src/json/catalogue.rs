//! The whole catalogue as JSON.

use super::{code, dialect_name, object, typed};
use crate::catalogue::example::{choosing, example};
use crate::catalogue::{CYCLES, Cycle, Param, ResultField, Unit, Variant};
use serde_json::Value;

/// What the page asks for first: the cycles under a name.
pub fn catalogue() -> Value {
    object([("cycles", cycles())])
}

/// One object a cycle: control, cycle, variants, parameters, results, alarms, each with its place in the manual.
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
        (
            "variants",
            variants.map(|one| variant(cycle, one)).collect(),
        ),
        ("parameters", cycle.params.iter().map(param).collect()),
        ("results", cycle.results.iter().map(result).collect()),
        ("alarms", cycle.alarms().into_iter().map(code).collect()),
        (
            "example",
            object(example.map(|(name, value)| (*name, (*value).into()))),
        ),
        ("simulated", cycle.simulation.is_some().into()),
        ("source", cycle.source.into()),
    ])
}

fn variant(cycle: &'static Cycle, variant: &Variant) -> Value {
    object([
        ("mvar", variant.number.into()),
        ("key", variant.key.into()),
        ("source", variant.source.into()),
        ("values", typed(&choosing(cycle, variant.number))),
        ("example", typed(&example(cycle, variant))),
    ])
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
