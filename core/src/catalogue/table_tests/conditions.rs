//! What the tables say behind `required-if:`, as values that make it true.

use crate::entry::{Cycle, Inputs, Level, names};

/// Inputs of this variant for which the condition holds, one for each way; none where the condition is about the
/// variant and this one does not meet it.
pub fn met(condition: &str, cycle: &'static Cycle, variant: i64) -> Vec<Inputs> {
    let mut plain = Inputs::new(cycle, variant);
    if condition.contains("milling tool") {
        plain.tool_type = 120;
    }
    let with = |name: &str, value: f64| {
        let mut inputs = plain.clone();
        give(&mut inputs, name, value);
        inputs
    };
    match condition {
        "" => vec![plain],
        "mono probe" => vec![with(names::PRNUM.as_str(), 101.0)],
        "_KNUM>0 and no _TNAME/_TENV"
        | "_KNUM>0 (0 only with _TENV/_TNAME or flat D numbers)"
        | "tool management and _TNUM=0" => vec![with(names::KNUM.as_str(), 2001.0)],
        "7th (9th) digit of _KNUM is 1 or 3"
        | "7th (9th) digit of _KNUM is 2 or 3"
        | "7th digit of _KNUM is 1 or 3"
        | "7th digit of _KNUM is 2 or 3" => vec![with(names::KNUM.as_str(), 3_002_001.0)],
        "MA=3|103|203 and 2R>_TP[k,6]" => vec![with(names::MA.as_str(), 3.0)],
        "d3=1 (reversal) and milling tool" if variant / 100 % 10 != 1 => vec![],
        "d3=1 (reversal) and milling tool" | "milling tool and spindle stationary and _CHBIT[20]=0" => vec![plain],
        other => match other.strip_suffix(">0") {
            Some(name) => vec![with(name, 1.0)],
            None => equal(other, variant, with),
        },
    }
}

/// `d4=1 or d4=2`, `_SETV[4]=2 or 3`: digits of the variant, or values of a parameter or datum.
fn equal(condition: &str, variant: i64, with: impl Fn(&str, f64) -> Inputs) -> Vec<Inputs> {
    let (mut ways, mut left) = (Vec::new(), "");
    for part in condition.split(" or ") {
        let (name, value) = part.split_once('=').unwrap_or((left, part));
        left = name;
        let value: f64 = value.parse().unwrap_or_else(|_| panic!("{condition}"));
        match name.strip_prefix('d').map(str::parse::<u32>) {
            Some(Ok(place)) if (variant / 10_i64.pow(place - 1) % 10) as f64 != value => {}
            Some(Ok(_)) => ways.push(with("", 0.0)),
            _ => ways.push(with(name, value)),
        }
    }
    ways
}

/// Gives a parameter, or a datum of the machine, its value.
fn give(inputs: &mut Inputs, name: &str, value: f64) {
    let cycle = inputs.cycle;
    let param = cycle.params.iter().find(|param| param.name == name);
    let setting = cycle.settings.iter().find(|setting| **setting == name);
    if let Some(param) = param {
        inputs.numbers.insert(param.name, value);
    } else if let Some(setting) = setting {
        inputs.settings.insert(setting, value);
    } else {
        assert_eq!(name, "", "{} has no {name}", cycle.name);
    }
}

/// How the form asks for a parameter of a row; none: not used. The T number is the one that is asked for; a name may
/// stand instead. The tool's radius is not among the values of a form: what depends on it is asked for by the checks.
pub fn level(name: &str, requirement: &str, condition: &str) -> Option<Level> {
    let elsewhere = condition.contains("2R>") || name == names::TNAME;
    match requirement {
        "unused" => None,
        "required-if" if elsewhere => Some(Level::Optional),
        "required" | "required-if" => Some(Level::Required),
        text if text.starts_with("optional") => Some(Level::Optional),
        other => panic!("{other:?}"),
    }
}
