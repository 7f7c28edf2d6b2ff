//! The help page of a measuring variant: the lines of its entry, and what follows from the rest of it: values that have
//! to be given, alarms that can come.

use super::CYCLES;
use super::common::{TOOL_OFFSET, ZERO_OFFSET};
use crate::catalogue::prelude::*;

/// What the help page of one variant says.
pub struct HelpPage {
    /// Lines, section by section.
    pub lines: Vec<&'static HelpLine>,
    /// Names of the parameters that every call of this variant has to give, that of the variant aside.
    pub required: Vec<Name>,
    /// Results that a call can leave.
    pub results: Vec<&'static ResultField>,
    /// Alarms that can come.
    pub alarms: Vec<Code>,
}

impl HelpPage {
    /// The page of this variant.
    pub fn of(cycle: &'static Cycle, variant: i64) -> HelpPage {
        let inputs = Inputs::new(cycle, variant);
        let mut lines: Vec<_> = cycle.help.lines().filter(|line| line.when.of_variant(&inputs) == Some(true)).collect();
        lines.sort_by_key(|line| line.section);
        let required = cycle.params.iter().filter(|param| required(param, &inputs));
        let results = cycle.results.iter();
        let left = |field: &&ResultField| field.when.of_variant(&inputs) != Some(false);
        let mut alarms = cycle.alarms();
        alarms.retain(|alarm| can_come(*alarm, &inputs));
        HelpPage {
            lines,
            required: required.map(|param| param.name).collect(),
            results: results.filter(left).collect(),
            alarms,
        }
    }

    /// The lines of a section.
    pub fn section(&self, section: Section) -> impl Iterator<Item = &'static HelpLine> {
        self.lines.iter().copied().filter(move |line| line.section == section)
    }
}

/// Whether every call of the variant has to give this parameter, whatever else it gives.
fn required(param: &Param, inputs: &Inputs) -> bool {
    let open = |need: &&Need| need.when.of_variant(inputs) != Some(false);
    let always = |need: &Need| need.level == Level::Required && need.when.of_variant(inputs) == Some(true);
    let chooses = matches!(param.kind, Kind::Variant(_));
    !chooses && param.needs.iter().find(open).is_some_and(always)
}

/// Whether some call of the variant uses this parameter.
fn used(param: &Param, inputs: &Inputs) -> bool {
    param.needs.iter().any(|need| need.when.of_variant(inputs) != Some(false))
}

/// Alarms about parameters beside those that stand with a parameter: about the safe area, the tolerances, the tool or
/// the frame that is corrected. They come in variants that use the parameter and for which the condition holds.
const ABOUT: &[(Name, When, &[u32])] = &[
    (names::TSA, When::Always, &[61303, 62303]),
    (names::TDIF, When::Always, &[61306, 62306]),
    (names::TUL, When::Always, &[62304, 62305]),
    (names::KNUM, TOOL_OFFSET, &[61322, 61323, 61324, 61328, 61345, 61407, 61408, 61409, 61410]),
    (names::KNUM, ZERO_OFFSET, &[61321, 61403, 61412]),
    (names::COR, When::Always, &[61321, 61412]),
];

/// Whether a call of the variant can raise an alarm: not one about a parameter that the variant does not use.
fn can_come(alarm: Code, inputs: &Inputs) -> bool {
    let is_used = |name: Name| {
        let param = inputs.cycle.param(name.as_str());
        param.is_some_and(|param| used(param, inputs))
    };
    let mut bound = CYCLES.iter().flat_map(|cycle| cycle.params).filter(|param| param.alarm == Some(alarm)).peekable();
    if bound.peek().is_some() {
        return bound.any(|param| is_used(param.name));
    }
    let mut about =
        ABOUT.iter().filter(|(_, _, alarms)| alarms.iter().any(|number| Code::Alarm(*number) == alarm)).peekable();
    about.peek().is_none() || about.any(|(name, when, _)| when.of_variant(inputs) == Some(true) && is_used(*name))
}
