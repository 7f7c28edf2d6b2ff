//! What can be measured.

use crate::catalogue::CYCLES;
use crate::catalogue::example::{choosing, example, turned, worked};
use crate::check::{Parsed, parse};
use crate::control::units::INCH;
use crate::control::{MachineSort, Plane, delivery};
use crate::diagnostic::Code;
use crate::dialect::Dialect;
use crate::entry::{Aim, Cycle, Param, ProbeUse, ResultField, Style, Typed, Unit};
use crate::manual::Cited;
use crate::manual::commissioning::{CONNECTIONS, Connection};
use crate::manual::explained::{CONCEPTS, Concept, GUIDES, TERMS, Term};
use crate::name::Name;
use crate::program::around::{Block, blocks};
use crate::workpiece::free::EXAMPLES;
use crate::{check, entry, jog};
use serde::Serialize;
use std::collections::BTreeMap;

/// Everything that can be measured.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Catalogue {
    /// In the order in which they are offered.
    pub cycles: Vec<CycleInfo>,
    /// Axis of the machine (X 0, Y 1, Z 2) about which the error `tilt` of the sliders turns a part, by plane.
    #[cfg_attr(test, ts(type = "Record<Plane, 0 | 1 | 2>"))]
    pub applicate: BTreeMap<Plane, usize>,
    /// Controls with which measuring in JOG can be practised.
    pub practises: Vec<Dialect>,
    /// Blocks that can stand around a call.
    pub around: Vec<AroundInfo>,
    /// Guides by id, as links name them: keys `guide-…` of their titles, and with `-words` by what they are found.
    pub guides: Vec<&'static str>,
    /// Concepts, terms and connections, which can be looked up.
    pub explained: Vec<ExplainedInfo>,
}

/// Something that is explained: where the manuals take it for granted, or a connection of a probe.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct ExplainedInfo {
    /// What it is.
    pub kind: ExplainedKind,
    /// Plug, pin or address of a connection; else empty.
    pub code: &'static str,
    /// Key of its name: `concept-…`, `term-…`, `connection-…`.
    pub key: String,
}

/// What is explained.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum ExplainedKind {
    /// A concept, with a page of its own.
    Concept,
    /// A term, with its definition.
    Term,
    /// A connection of a probe.
    Connection,
}

/// A block that can stand around a call.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct AroundInfo {
    /// Control that has it.
    pub control: Dialect,
    /// Its name.
    pub name: &'static str,
    /// Key of its title; with `-words` by what it is found.
    pub key: String,
}

/// A measuring cycle or macro.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct CycleInfo {
    /// Control that has it.
    pub control: Dialect,
    /// Name of the cycle: `CYCLE977`.
    pub cycle: &'static str,
    /// Stem of its messages: `cycle977` of `cycle977-title`, `cycle977-words`, `cycle977-help`.
    pub key: &'static str,
    /// Where it belongs.
    pub purpose: Purpose,
    /// The styles that its call has, direct first.
    pub styles: Vec<Style>,
    /// Whether a parameter takes the number of the variant; else that number is ours, and no program writes it.
    pub numbered: bool,
    /// Measuring variants of the cycle.
    pub variants: Vec<VariantInfo>,
    /// Parameters of the cycle, in the order in which they are written.
    pub parameters: Vec<ParameterInfo>,
    /// What it leaves in the result data.
    pub results: &'static [ResultField],
    /// Names of its alarms: `61303`, `PROBE FAIL`.
    pub alarms: Vec<Code>,
    /// Values of a worked measurement, as typed.
    pub example: Typed,
    /// Whether the other control has some of its tasks too.
    pub twins: bool,
    /// Whether it is simulated; else there are form, checks and text only, and a form has no outcome.
    pub simulated: bool,
    /// Names of our surfaces where it scans one, which a scan answers in pieces; else none.
    pub surfaces: Vec<&'static str>,
    /// Place in the manual.
    pub source: Cited,
}

/// Where a cycle belongs.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Purpose {
    /// Sort of machine.
    pub machine: MachineSort,
    /// In which plane such a machine works unless told otherwise.
    pub plane: Option<Plane>,
    /// The probe that it uses.
    pub probe: ProbeUse,
    /// Whether calibrating is all that it does.
    pub calibrates: bool,
}

/// A measuring variant. Its values, as typed, choose it; its example is a worked measurement.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct VariantInfo {
    /// Number of the variant.
    pub mvar: i64,
    /// Key of its name.
    pub key: &'static str,
    /// Place in the manual.
    pub source: Cited,
    /// Keys of what the digits of its number choose, the lowest place first.
    pub choices: Vec<&'static str>,
    /// What it is for; none: it is found by its number alone.
    pub aim: Option<Aim>,
    /// In G17.
    #[serde(flatten)]
    pub usual: Values,
    /// In the planes in which other addresses name the axes.
    pub planes: BTreeMap<Plane, Values>,
}

/// Values of a variant as typed, by parameter name.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Values {
    /// Values that choose the variant.
    pub values: Typed,
    /// Values of the worked measurement.
    pub example: Typed,
    /// Those of them that are lengths in the active system of units, in inches: the same measurement.
    pub inch: Typed,
}

impl Values {
    fn of(cycle: &'static Cycle, values: Typed, example: Typed) -> Values {
        let inch = inch(cycle, &example);
        Values { values, example, inch }
    }
}

/// Lengths as an inch program has them, to its finest step (1/10000 inch).
fn inch(cycle: &'static Cycle, example: &Typed) -> Typed {
    let inputs = check::read(cycle, example, &delivery(cycle.dialect), &mut Vec::new());
    let lengths = cycle.params.iter().filter(|param| param.unit_with(&inputs) == Unit::ActiveLength);
    let converted = lengths.filter_map(|param| match parse(example.get(param.name.as_str())?) {
        Parsed::Number(value) => Some((param.name.to_string(), ((value / INCH * 1e4).round() / 1e4).to_string())),
        _ => None,
    });
    converted.filter(|(name, value)| example.get(name) != Some(value)).collect()
}

/// A parameter.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct ParameterInfo {
    /// As the manual writes it: `_SETVAL`.
    pub name: Name,
    /// Stem of its messages: `setval` of `param-setval`.
    pub key: &'static str,
    /// Rule of its unit.
    pub unit: Unit,
    /// What counts while it is not written; none: it has to be.
    pub default: Option<f64>,
    /// Place in the manual.
    pub source: Cited,
}

/// Everything that can be measured.
pub fn catalogue() -> Catalogue {
    let applicate = Plane::ALL.map(|plane| (plane, plane.axes()[2])).into();
    let practises = [Dialect::Sinumerik, Dialect::Nct].into_iter().filter(|control| jog::measures(*control)).collect();
    let of = |control: Dialect| {
        let info = move |block: &Block| AroundInfo { control, name: block.name, key: block.key() };
        blocks(control).iter().map(info)
    };
    let around = [Dialect::Sinumerik, Dialect::Nct].into_iter().flat_map(of).collect();
    let cycles = CYCLES.iter().map(|cycle| entry(cycle)).collect();
    let guides = GUIDES.iter().map(|guide| guide.id).collect();
    Catalogue { cycles, applicate, practises, around, guides, explained: explained() }
}

fn explained() -> Vec<ExplainedInfo> {
    let info = |kind, code, key| ExplainedInfo { kind, code, key };
    let concept = |one: &Concept| info(ExplainedKind::Concept, "", format!("concept-{}", one.id));
    let term = |one: &Term| info(ExplainedKind::Term, "", format!("term-{}", one.id));
    let connection = |one: &Connection| info(ExplainedKind::Connection, one.signal, format!("connection-{}", one.id));
    let explained = CONCEPTS.iter().map(concept).chain(TERMS.iter().map(term));
    explained.chain(CONNECTIONS.iter().map(connection)).collect()
}

fn entry(cycle: &'static Cycle) -> CycleInfo {
    CycleInfo {
        control: cycle.dialect,
        cycle: cycle.name,
        key: cycle.key,
        purpose: purpose(cycle),
        styles: styles(cycle),
        numbered: cycle.variant_param().is_some(),
        variants: cycle.variants.iter().map(|one| variant(cycle, one)).collect(),
        parameters: cycle.params.iter().map(parameter).collect(),
        results: cycle.results,
        alarms: cycle.alarms(),
        example: worked(cycle),
        twins: !cycle.purpose.tasks.is_empty(),
        simulated: cycle.simulation.is_some(),
        surfaces: EXAMPLES.iter().filter(|_| cycle.scan().is_some()).map(|(name, _)| *name).collect(),
        source: Cited(cycle.source),
    }
}

fn purpose(cycle: &'static Cycle) -> Purpose {
    let control = delivery(cycle.dialect);
    let calibrates = |variant: &entry::Variant| {
        let typed = choosing(cycle, variant.number);
        let inputs = check::read(cycle, &typed, &control, &mut Vec::new());
        cycle.purpose.calibrates.holds(&inputs)
    };
    Purpose {
        machine: cycle.purpose.machine,
        plane: cycle.purpose.machine.plane(),
        probe: cycle.purpose.probe,
        calibrates: cycle.variants.iter().all(calibrates),
    }
}

fn styles(cycle: &Cycle) -> Vec<Style> {
    let has = |style: &Style| {
        *style == Style::Direct || cycle.lists.iter().any(|list| list.style == *style && list.is_written())
    };
    [Style::Direct, Style::Indirect, Style::Operate].into_iter().filter(has).collect()
}

fn variant(cycle: &'static Cycle, variant: &entry::Variant) -> VariantInfo {
    let usual = Values::of(cycle, choosing(cycle, variant.number), example(cycle, variant));
    let choices = cycle.choices(variant.number).collect();
    let mut planes = BTreeMap::new();
    for plane in [Plane::G18, Plane::G19] {
        let there = |values: &Typed| turned(cycle, values, plane);
        let there = Values::of(cycle, there(&usual.values), there(&usual.example));
        if there != usual {
            planes.insert(plane, there);
        }
    }
    let aim = cycle.aim(&check::read(cycle, &usual.values, &delivery(cycle.dialect), &mut Vec::new()));
    VariantInfo { mvar: variant.number, key: variant.key, source: Cited(variant.source), choices, aim, usual, planes }
}

fn parameter(param: &Param) -> ParameterInfo {
    ParameterInfo {
        name: param.name,
        key: param.key,
        unit: param.unit,
        default: param.default,
        source: Cited(param.source),
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use crate::app::{FormRequest, FormView, form};

    fn formed(control: Dialect, cycle: &str, plane: Plane, units: &str, values: &Typed) -> FormView {
        let asked = serde_json::json!({
            "control": control, "cycle": cycle, "values": values, "predict": true,
            "setup": { "own": { "plane": plane, "units": units } }
        });
        form(serde_json::from_value::<FormRequest>(asked).unwrap()).unwrap()
    }

    /// The alarms of its run by name; none: it was not carried out.
    fn alarms(view: &FormView) -> Option<Vec<String>> {
        view.outcome.as_ref().map(|outcome| outcome.alarms.iter().map(|one| one.code.clone()).collect())
    }

    // oracle: self (the worked measurement is the same one in inches: nothing is wrong with it, and it runs as in mm)
    #[test]
    fn the_worked_measurements_are_there_in_inches() {
        let mut lengths = 0;
        for cycle in catalogue().cycles {
            let plane = cycle.purpose.plane.unwrap_or(Plane::G17);
            let [mm, inches] = if cycle.control == Dialect::Nct { ["G21", "G20"] } else { ["G71", "G70"] };
            for variant in &cycle.variants {
                let values = variant.planes.get(&plane).unwrap_or(&variant.usual);
                let mut small = values.example.clone();
                small.extend(values.inch.clone());
                let usual = formed(cycle.control, cycle.cycle, plane, mm, &values.example);
                let inch = formed(cycle.control, cycle.cycle, plane, inches, &small);
                assert_eq!(inch.complete, usual.complete, "{} {}", cycle.cycle, variant.mvar);
                assert_eq!(alarms(&inch), alarms(&usual), "{} {}", cycle.cycle, variant.mvar);
                lengths += values.inch.len();
            }
        }
        assert!(lengths > 300, "{lengths}");
    }
}
