//! Parameters without a field, and what is written for them (B:12505-12539).

use super::{EMPIRICAL, FEED, MEAN, Offer, PROBE, SPEEDS, Support, offer};
use crate::check;
use crate::check::{Parsed, parse};
use crate::control::{Control, Value, gud};
use crate::entry::{Cycle, Inputs, Kind, PROBE_TYPE, Param, ProbeUse, Typed, names};
use crate::name::Name;

/// The bit for the mean value (B:12518-12532).
pub const MEAN_BIT: &str = "_CHBIT[4]";
/// The bit for feed and speed out of `_MFS[]` (B:12537-12539).
pub const SPEEDS_BIT: &str = "_CBIT[12]";
/// The bits that the support writes with a call.
pub const BITS: [&str; 2] = [MEAN_BIT, SPEEDS_BIT];

/// A parameter that has a field only where one of these entries is 1.
struct Rule {
    param: Name,
    entries: &'static [usize],
    /// What is written where there is no field.
    value: &'static str,
}

/// A third of the tolerance, as a formula.
const THIRD_OF_TOLERANCE: &str = "ABS(_TUL-_TLL)/3";

const RULES: &[Rule] = &[
    Rule { param: names::VMS, entries: &[FEED], value: "0" },
    Rule { param: names::NMSP, entries: &[FEED], value: "1" },
    Rule { param: names::EVNUM, entries: &[EMPIRICAL, MEAN], value: "0" },
    Rule { param: names::TMV, entries: &[MEAN], value: THIRD_OF_TOLERANCE },
    Rule { param: names::K, entries: &[MEAN], value: "1" },
];

/// What a form with these settings holds.
#[derive(Clone, Debug, PartialEq)]
pub struct Entered {
    /// The values, those without a field included.
    pub values: Typed,
    /// The bits that are written with them.
    pub bits: Vec<(&'static str, bool)>,
}

/// Data of the machine as they were, by name.
pub type Before = Vec<(String, Option<Value>)>;

impl Entered {
    /// Gives the control what the call writes into data of the machine, so that checks and simulation see it. The
    /// data as they were come back, for [`restore`].
    pub fn write(&self, control: &mut Control) -> Before {
        let bits = self.bits.iter().map(|(name, on)| ((*name).to_owned(), f64::from(u8::from(*on))));
        let is_datum = |name: &str| gud::named(name).is_some_and(gud::Gud::of_machine);
        let data = self.values.iter().filter_map(|(name, text)| match parse(text) {
            Parsed::Number(number) if is_datum(name) => Some((name.clone(), number)),
            _ => None,
        });
        let written = bits.chain(data).map(|(name, number)| {
            let before = control.data.insert(name.clone(), Value::Number(number));
            (name, before)
        });
        written.collect()
    }
}

/// Gives a control its data back.
pub fn restore(control: &mut Control, before: Before) {
    for (name, value) in before {
        match value {
            Some(value) => control.data.insert(name, value),
            None => control.data.remove(&name),
        };
    }
}

impl Support {
    /// Whether a parameter that the call uses has no field.
    pub fn hides(&self, param: &Param, inputs: &Inputs) -> bool {
        rule(param).is_some_and(|rule| self.without_field(rule, inputs))
    }

    /// The fields for the mean value are those of a correction that forms one.
    fn without_field(&self, rule: &Rule, inputs: &Inputs) -> bool {
        let counts = |entry: &&usize| **entry != MEAN || mean_value(inputs);
        !rule.entries.iter().filter(counts).any(|entry| self.entry(*entry))
    }

    /// The values that a form with these settings has for what was typed.
    pub fn entered(&self, cycle: &'static Cycle, typed: &Typed, control: &Control) -> Entered {
        let mut values = typed.clone();
        let inputs = check::read(cycle, typed, control, &mut Vec::new());
        for param in cycle.params {
            if param.need(&inputs).is_none() {
                continue;
            }
            if let Some(text) = self.forced(param, &inputs, typed, control) {
                values.insert(param.name.to_string(), text);
            }
        }
        Entered { bits: self.bits(&inputs), values }
    }

    /// The value that the settings give a parameter, whatever was typed.
    fn forced(&self, param: &Param, inputs: &Inputs, typed: &Typed, control: &Control) -> Option<String> {
        if let Some(rule) = rule(param).filter(|rule| self.without_field(rule, inputs)) {
            return match rule.value {
                THIRD_OF_TOLERANCE => third_of_tolerance(inputs.cycle, typed, control),
                number => Some(number.to_owned()),
            };
        }
        if param.name == names::PRNUM {
            return self.probe(param, inputs);
        }
        match offer(*self, param, inputs) {
            Offer::Instead(code) => Some(code.to_string()),
            Offer::Same | Offer::None => None,
        }
    }

    /// `_PRNUM` with the digit for the type of the probe, where it has one (B:12533-12535).
    fn probe(&self, param: &Param, inputs: &Inputs) -> Option<String> {
        let typed = inputs.cycle.purpose.probe == ProbeUse::Workpiece && has_probe_type(param);
        let number = inputs.given(param.name).filter(|_| typed)? as i64;
        let mono = i64::from(self.entry(PROBE)) * PROBE_TYPE.place;
        let right = number % PROBE_TYPE.place + mono;
        (right != number).then(|| right.to_string())
    }

    /// The bits that are written with the call: of a correction that can form a mean value, and of tool measurement
    /// that can take feed and speed from data.
    fn bits(&self, inputs: &Inputs) -> Vec<(&'static str, bool)> {
        let measures = inputs.cycle.settings.contains(&SPEEDS_BIT) && !inputs.cycle.purpose.calibrates.holds(inputs);
        let all = [(mean_value(inputs), (MEAN_BIT, self.entry(MEAN))), (measures, (SPEEDS_BIT, self.entry(SPEEDS)))];
        all.into_iter().filter_map(|(written, bit)| written.then_some(bit)).collect()
    }
}

fn rule(param: &Param) -> Option<&'static Rule> {
    RULES.iter().find(|rule| rule.param == param.name)
}

/// Whether the call corrects with a mean value: then it uses the weight.
fn mean_value(inputs: &Inputs) -> bool {
    inputs.uses(names::K)
}

fn has_probe_type(param: &Param) -> bool {
    matches!(&param.kind, Kind::Digits(groups) if groups.iter().any(|group| group.key == PROBE_TYPE.key))
}

/// A third of the tolerance: its number where both limits are numbers, as on the screens (B:12160), else the formula.
fn third_of_tolerance(cycle: &Cycle, typed: &Typed, control: &Control) -> Option<String> {
    let limit = |name: &str| {
        let text = typed.get(name).map_or("", String::as_str);
        match parse(text) {
            Parsed::Empty => cycle.param(name)?.fallback(control).map(Parsed::Number),
            Parsed::Wrong => None,
            known => Some(known),
        }
    };
    match (limit(names::TUL.as_str())?, limit(names::TLL.as_str())?) {
        (Parsed::Number(upper), Parsed::Number(lower)) => Some(decimal((upper - lower).abs() / 3.0)),
        _ => Some(THIRD_OF_TOLERANCE.to_owned()),
    }
}

/// A number with at most six decimals, a millionth of a millimetre.
pub fn decimal(number: f64) -> String {
    ((number * 1e6).round() / 1e6).to_string()
}
