//! The whole catalogue as JSON.

use super::{code, dialect_name};
use crate::catalogue::{CYCLES, Cycle, Kind, Param, ResultField, Unit, Variant};
use serde_json::{Map, Value, json};

/// One object a cycle: control, cycle, variants, parameters, results, alarms, each with its place in the manual.
pub fn cycles() -> Value {
    CYCLES.iter().map(|cycle| entry(cycle)).collect()
}

fn entry(cycle: &Cycle) -> Value {
    json!({
        "control": dialect_name(cycle.dialect),
        "cycle": cycle.name,
        "key": cycle.key,
        "variants": cycle.variants.iter().map(|variant| self::variant(cycle, variant)).collect::<Vec<_>>(),
        "parameters": cycle.params.iter().map(param).collect::<Vec<_>>(),
        "results": cycle.results.iter().map(result).collect::<Vec<_>>(),
        "alarms": cycle.alarms().into_iter().map(code).collect::<Vec<_>>(),
        "example": cycle.example.iter().map(|(name, value)| ((*name).to_owned(), json!(value))).collect::<serde_json::Map<_, _>>(),
        "simulated": cycle.simulation.is_some(),
        "source": cycle.source,
    })
}

fn variant(cycle: &Cycle, variant: &Variant) -> Value {
    let values = choosing(cycle, variant.number);
    json!({ "mvar": variant.number, "key": variant.key, "source": variant.source, "values": values })
}

/// Values, as typed, that choose a variant: its number, or the address whose presence makes it.
fn choosing(cycle: &Cycle, number: i64) -> Map<String, Value> {
    let mut values = Map::new();
    for param in cycle.params {
        if matches!(param.kind, Kind::Variant(_)) {
            values.insert(param.name.into(), json!(number.to_string()));
        } else if let Some(chosen) = param.chooses {
            let value = if chosen == number { "0" } else { "" };
            values.insert(param.name.into(), json!(value));
        }
    }
    values
}

fn param(param: &Param) -> Value {
    json!({ "name": param.name, "key": param.key, "unit": unit_rule(param.unit), "default": param.default, "source": param.source })
}

fn result(field: &ResultField) -> Value {
    json!({ "name": field.name, "key": field.key, "unit": unit_rule(field.unit), "source": field.source })
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
