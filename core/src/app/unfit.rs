//! What of the values of a form does not fit another variant.

use super::start::{Machine, start};
use super::{Error, cycle};
use crate::dialect::Dialect;
use crate::entry::Typed;
use crate::form::{self, Unfit};
use serde::Deserialize;

/// The values of a form before another variant was chosen in it, and after.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct UnfitRequest {
    /// Control.
    pub control: Dialect,
    /// Cycle.
    pub cycle: String,
    /// Values before, by parameter.
    pub before: Typed,
    /// Values after.
    pub values: Typed,
    /// Machine; absent: the core's own as it is.
    pub setup: Option<Machine>,
}

/// The values that do not fit the variant which is chosen now.
///
/// # Errors
/// There is no such cycle, or the machine has no such G function of units.
pub fn unfit(asked: UnfitRequest) -> Result<Vec<Unfit>, Error> {
    let cycle = cycle(asked.control, &asked.cycle)?;
    let control = start(asked.control, asked.setup)?.setup.control;
    Ok(form::unfit(cycle, &asked.before, &asked.values, &control))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::super::{ChangeRequest, Changed, change};
    use super::*;
    use crate::catalogue::{CYCLES, example::example, find};
    use crate::control::delivery;
    use crate::entry::{Style, Variant};
    use crate::program::calls::calls;
    use crate::program::write::snippet;
    use crate::syntax;

    /// The program once the variant of its call is another, as far as that is its own text, and what was said.
    fn another(text: &str, variant: &Variant) -> (String, Changed) {
        let number = variant.number.to_string();
        let done = change(ChangeRequest::new(Dialect::Sinumerik, text, 0, "_MVAR", &number)).unwrap();
        let mut after = text.to_owned();
        for step in &done.steps {
            for edit in step.iter().rev() {
                after.replace_range(edit.from as usize..edit.to as usize, &edit.insert);
            }
        }
        (after, done)
    }

    // oracle: manual B:1894-2029 (2001 is D1 of a tool with a tool offset, and no settable zero offset)
    #[test]
    fn a_number_that_means_something_else_leaves_the_call_in_one_step() {
        let text = "_MVAR=1 _SETVAL=50 _KNUM=2001 _TNUM=20 _FA=2 _TSA=1 _PRNUM=1\nCYCLE977\n";
        let cycle = find(Dialect::Sinumerik, "CYCLE977").unwrap();
        let zero = cycle.variants.iter().find(|one| one.number == 101).unwrap();
        let (after, done) = another(text, zero);
        assert_eq!(after, "_MVAR=101 _SETVAL=50 _FA=2 _TSA=1 _PRNUM=1\nCYCLE977\n");
        let told: Vec<_> = done.unfit.iter().map(|one| (one.name.as_str(), one.value.as_str())).collect();
        assert_eq!(told, [("_KNUM", "2001")]);
        assert!(done.reaches && done.values.iter().any(|one| one.param == "_KNUM" && one.after.is_none()), "{done:?}");
    }

    // oracle: self (whatever variant becomes whichever other one: all that does not fit goes with the change itself)
    #[test]
    fn nothing_that_does_not_fit_stays_behind() {
        let mut gone = 0;
        for cycle in CYCLES.iter().filter(|one| one.dialect == Dialect::Sinumerik && one.variant_param().is_some()) {
            let control = delivery(cycle.dialect);
            let site = |text: &str| calls(&syntax::read(cycle.dialect, text.as_bytes())).into_iter().next();
            for from in cycle.variants {
                let text = snippet(cycle, &example(cycle, from), &control, Style::Direct, None).text;
                let Some(before) = site(&text) else { continue };
                for to in cycle.variants {
                    let (after, done) = another(&text, to);
                    let values = site(&after).unwrap().values;
                    let left = form::unfit(cycle, &before.values, &values, &control);
                    assert_eq!(left, [], "{} {} to {}: {after}", cycle.name, from.number, to.number);
                    gone += done.unfit.len();
                }
            }
        }
        assert!(gone > 20, "{gone}");
    }
}
