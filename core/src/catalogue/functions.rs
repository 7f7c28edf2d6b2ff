//! Which G function calls which macro of an NCT control: the parameters G(9010) to G(9019), number 9041 to 9050, hold
//! the number of the function that calls O9010 to O9019, 101 to 110 as the manual sets them (C:58). Our entries have
//! the names of these functions; what a program writes follows from the parameters of its machine.

use super::find;
use crate::control::Control;
use crate::dialect::Dialect;
use crate::entry::Cycle;

/// Number of these macros.
const MACROS: usize = 10;
/// Program number of the first (C:58).
const PROGRAM: f64 = 9010.0;
/// Parameter of the first (C:58).
const PARAMETER: usize = 9041;
/// G function of the first, as the manual sets it (C:58), after which its entry is named.
const FUNCTION: usize = 101;
/// Functions below are the control's own, whatever a parameter says.
const OWN: f64 = 100.0;

/// The functions by which a machine calls the macros.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Functions([f64; MACROS]);

/// What a G function calls.
pub struct Calls {
    /// The macro; the first, where two parameters have its number.
    pub cycle: &'static Cycle,
    /// The parameter that says so.
    pub parameter: String,
    /// Another parameter with the same number.
    pub also: Option<String>,
}

fn parameter(index: usize) -> String {
    format!("P{}", PARAMETER + index)
}

fn named(index: usize) -> Option<&'static Cycle> {
    find(Dialect::Nct, &format!("G{}", FUNCTION + index))
}

/// Place of a macro among those that a function may call.
fn index(cycle: &Cycle) -> Option<usize> {
    let number: usize = cycle.name.strip_prefix('G')?.parse().ok()?;
    number.checked_sub(FUNCTION).filter(|index| cycle.dialect == Dialect::Nct && *index < MACROS)
}

impl Functions {
    /// Those of this machine.
    pub fn of(control: &Control) -> Functions {
        if control.dialect != Dialect::Nct {
            return Functions::default();
        }
        Functions(std::array::from_fn(|index| control.number(&parameter(index))))
    }

    /// Places of the macros that a function calls on this machine.
    fn calling(&self, code: f64) -> impl Iterator<Item = usize> {
        (0..MACROS).filter(move |index| code >= OWN && self.0.get(*index) == Some(&code))
    }

    /// What a function calls on this machine.
    pub fn called(&self, code: f64) -> Option<Calls> {
        let mut all = self.calling(code);
        let first = all.next()?;
        Some(Calls { cycle: named(first)?, parameter: parameter(first), also: all.next().map(parameter) })
    }

    /// The macro that a function calls on this machine.
    pub fn cycle(&self, code: f64) -> Option<&'static Cycle> {
        self.calling(code).next().and_then(named)
    }

    /// Of a function that calls nothing here: the macro that has it as the manual sets the parameters, and the
    /// parameter that says otherwise.
    pub fn missed(&self, code: f64) -> Option<Calls> {
        let index = (0..MACROS).find(|index| (FUNCTION + index) as f64 == code)?;
        let known = self.cycle(code).is_some();
        let calls = Calls { cycle: named(index)?, parameter: parameter(index), also: None };
        (!known).then_some(calls)
    }

    /// How a block begins that calls this macro: `G110`, `G120`, and where no function calls it, or one that calls
    /// another macro first, `G65 P9019`.
    pub fn written(&self, cycle: &Cycle) -> String {
        let Some(index) = index(cycle) else { return cycle.name.to_owned() };
        match self.0.get(index) {
            Some(code) if self.calling(*code).next() == Some(index) => format!("G{code}"),
            _ => format!("G65 P{}", PROGRAM + index as f64),
        }
    }
}

/// The macro that `G65 P…` calls by its program number, whatever function calls it; others have their number as name.
pub fn by_program(number: f64) -> Option<&'static Cycle> {
    let index = (0..MACROS).find(|index| PROGRAM + *index as f64 == number);
    index.and_then(named).or_else(|| find(Dialect::Nct, &format!("G65 P{number}")))
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::control::delivery;

    fn machine(changed: &[(&str, f64)]) -> Functions {
        let mut control = delivery(Dialect::Nct);
        changed.iter().for_each(|(name, value)| control.set(*name, *value));
        Functions::of(&control)
    }

    #[test]
    fn delivered_parameters_call_the_entries_by_their_names() {
        // oracle: manual C:58, C:142 (9041 = 101), C:1157 (9050 = 110)
        let functions = machine(&[]);
        for number in 101..=110 {
            let cycle = functions.cycle(f64::from(number)).unwrap();
            assert_eq!(cycle.name, format!("G{number}"));
            assert_eq!(functions.written(cycle), cycle.name);
        }
        assert!(functions.cycle(111.0).is_none() && functions.missed(111.0).is_none());
    }

    #[test]
    fn another_number_calls_the_bore() {
        // oracle: manual C:58 (the macro is called by the command whose number the parameter holds)
        let functions = machine(&[("P9050", 120.0)]);
        let called = functions.called(120.0).unwrap();
        assert_eq!((called.cycle.name, called.parameter.as_str(), called.also), ("G110", "P9050", None));
        assert_eq!(functions.written(called.cycle), "G120");
        let missed = functions.missed(110.0).unwrap();
        assert_eq!((missed.cycle.name, missed.parameter.as_str()), ("G110", "P9050"));
        assert!(functions.called(110.0).is_none());
    }

    #[test]
    fn a_parameter_without_a_function_leaves_the_program_number() {
        // oracle: manual C:54 (O9019), hand (functions below 100 are the control's own)
        for none in [0.0, 1.0, 65.0] {
            let functions = machine(&[("P9050", none)]);
            assert!(functions.called(none).is_none());
            assert_eq!(functions.written(by_program(9019.0).unwrap()), "G65 P9019");
        }
    }

    #[test]
    fn what_is_written_calls_the_macro() {
        // oracle: self (a block that begins so calls this macro and no other), whatever the parameters hold
        for number in [0.0, 65.0, 101.0, 105.0, 109.0, 110.0, 120.0] {
            for other in ["P9041", "P9045", "P9050"] {
                let functions = machine(&[(other, number), ("P9046", 109.0)]);
                for index in 0..MACROS {
                    let cycle = named(index).unwrap();
                    let written = functions.written(cycle);
                    let called = match written.strip_prefix("G65 P") {
                        Some(program) => by_program(program.parse().unwrap()),
                        None => functions.cycle(written.strip_prefix('G').unwrap().parse().unwrap()),
                    };
                    assert_eq!(called.unwrap().name, cycle.name, "{other}={number}: {written}");
                }
            }
        }
    }

    #[test]
    fn two_parameters_with_one_number_are_told() {
        // oracle: hand
        let functions = machine(&[("P9050", 109.0)]);
        assert_eq!(functions.written(by_program(9019.0).unwrap()), "G65 P9019");
        let called = functions.called(109.0).unwrap();
        assert_eq!((called.cycle.name, called.also.as_deref()), ("G109", Some("P9050")));
    }
}
