//! What the tables say behind `required-if:`, as values that make it true.

use super::super::{Cycle, Level, names};
use crate::check::Inputs;

/// Inputs of this variant for which the condition holds; none where the condition is about the variant and this one
/// does not meet it.
pub fn met(condition: &str, cycle: &'static Cycle, variant: i64) -> Option<Inputs> {
    let mut inputs = Inputs::new(cycle, variant);
    let digit = |place: u32| variant / 10_i64.pow(place - 1) % 10;
    if condition.contains("milling tool") {
        inputs.tool_type = 120;
    }
    let mut set = |name, value| {
        inputs.numbers.insert(name, value);
    };
    match condition {
        "mono probe" => set(names::PRNUM, 101.0),
        "_KNUM>0 and no _TNAME/_TENV"
        | "_KNUM>0 (0 only with _TENV/_TNAME or flat D numbers)"
        | "tool management and _TNUM=0" => set(names::KNUM, 2001.0),
        "7th (9th) digit of _KNUM is 1 or 3"
        | "7th (9th) digit of _KNUM is 2 or 3"
        | "7th digit of _KNUM is 1 or 3"
        | "7th digit of _KNUM is 2 or 3" => set(names::KNUM, 3_002_001.0),
        "MA=3|103|203 and 2R>_TP[k,6]" => set(names::MA, 3.0),
        "d3=1 (reversal) and milling tool" if digit(3) != 1 => return None,
        "d4=1" if digit(4) != 1 => return None,
        "d4=1 or d4=2" if !(1..=2).contains(&digit(4)) => return None,
        "d6=1" if digit(6) != 1 => return None,
        "d4=1" | "d4=1 or d4=2" | "d6=1" => {}
        "d3=1 (reversal) and milling tool"
        | "milling tool and spindle stationary and _CHBIT[20]=0" => {}
        other => panic!("{}: {other}", cycle.name),
    }
    Some(inputs)
}

/// How the form asks for a parameter where the condition holds. The T number is the one that is asked for; a name may
/// stand instead. The tool's radius is not among the values of a form: what depends on it is asked for by the checks.
pub fn level(name: &str, condition: &str) -> Level {
    let elsewhere = condition.contains("2R>") || name == names::TNAME;
    if elsewhere {
        Level::Optional
    } else {
        Level::Required
    }
}
