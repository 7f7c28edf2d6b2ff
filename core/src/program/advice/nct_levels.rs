//! Levels of an NCT control: a macro calls macros and subprograms itself (C:142-144), so that a call needs more of them
//! than the programs that lead to it. How many a control has is in its own description, here in the machine's data.

use super::nct::{called_here, calls_macro};
use super::subprograms;
use crate::catalogue::by_program;
use crate::catalogue::nct::levels::levels;
use crate::control::{Control, nct_data};
use crate::diagnostic::Diagnostic;
use crate::entry::Cycle;
use crate::own;
use crate::program::calls::CallSite;
use crate::program::flow::LEVELS;
use crate::syntax::programs::Programs;
use crate::syntax::{Block, Program};

/// Program number of the tool probe's macro.
const TOOL_PROBE: f64 = 9920.0;
/// It may be called up to the second subroutine level (C:1189); the main program is the first of ours.
const TOOL_PROBE_LEVEL: usize = 3;

/// A call of a program of the text.
struct Call {
    /// The program.
    unit: usize,
    /// By G65: a level of macros; else by M98, one of subprograms.
    by_macro: bool,
}

/// Calls on too deep a level.
pub fn look(
    program: &Program,
    programs: &Programs,
    control: &Control,
    sites: &[CallSite],
    found: &mut Vec<Diagnostic>,
) {
    if sites.is_empty() {
        return;
    }
    let call = |block: &Block| {
        let by_macro = program.words_of(block).iter().any(|word| calls_macro(program, word));
        called_here(program, programs, block).map(|unit| Call { unit, by_macro })
    };
    let of_unit = |unit| program.blocks_of(unit).iter().filter_map(call).collect();
    let calls: Vec<Vec<Call>> = programs.units.iter().map(of_unit).collect();
    let any: Vec<Vec<usize>> = calls.iter().map(|calls| calls.iter().map(|call| call.unit).collect()).collect();
    tool_probe(programs, &subprograms::levels(&any), sites, found);
    let (macros, subprograms) = (deepest(&calls, |call| call.by_macro), deepest(&calls, |call| !call.by_macro));
    let needs = sites.iter().filter_map(|site| {
        let unit = programs.of_line(site.line);
        let before = |levels: &[usize]| unit.and_then(|unit| levels.get(unit)).copied().unwrap_or(0);
        Need::of(site, before(&macros), before(&subprograms))
    });
    say(control, &needs.collect::<Vec<_>>(), found);
}

/// What a call needs, with what leads to it and itself.
struct Need<'a> {
    site: &'a CallSite,
    macros: usize,
    subprograms: usize,
    /// Whether other programs lead to it.
    called: bool,
}

impl Need<'_> {
    fn of(site: &CallSite, macros: usize, subprograms: usize) -> Option<Need<'_>> {
        let own = levels(site.cycle)?;
        let called = macros + subprograms > 0;
        // the macro itself is one more
        Some(Need { site, macros: macros + 1 + own.macros, subprograms: subprograms + own.subprograms, called })
    }
}

/// Each call that needs more than the control has; where that is not told, the deepest one that others lead to.
fn say(control: &Control, needs: &[Need], found: &mut Vec<Diagnostic>) {
    let [most_macros, most_subprograms] = nct_data::LEVELS.map(|name| control.number(name) as usize);
    for need in needs {
        let all = [
            (own::NCT_MACRO_LEVELS, need.macros, most_macros),
            (own::NCT_SUBPROGRAM_LEVELS, need.subprograms, most_subprograms),
        ];
        for (finding, count, limit) in all.into_iter().filter(|(_, count, limit)| (1..*count).contains(limit)) {
            let told = finding.finding().number("count", count as f64).number("limit", limit as f64);
            found.push(told.on(need.site.span));
        }
    }
    let untold = needs.iter().filter(|need| need.called && (most_macros == 0 || most_subprograms == 0));
    if let Some(need) = untold.max_by_key(|need| (need.macros + need.subprograms, std::cmp::Reverse(need.site.line))) {
        let told = own::NCT_LEVELS.finding().number("macros", need.macros as f64);
        found.push(told.number("subprograms", need.subprograms as f64).on(need.site.span));
    }
}

/// Most levels of a sort that lead to each program of the text; what nothing calls may be the main program.
fn deepest(calls: &[Vec<Call>], counts: impl Fn(&Call) -> bool) -> Vec<usize> {
    let mut reached: Vec<Option<usize>> = vec![Some(0); calls.len()];
    for call in calls.iter().flatten() {
        reached.get_mut(call.unit).into_iter().for_each(|level| *level = None);
    }
    // each round goes one call deeper, so that a program that calls itself comes to an end too
    for _ in 0..LEVELS {
        for (unit, calls) in calls.iter().enumerate() {
            let Some(level) = reached.get(unit).copied().flatten() else { continue };
            for call in calls {
                let deeper = (level + usize::from(counts(call))).min(LEVELS);
                if let Some(known) = reached.get_mut(call.unit) {
                    *known = (*known).max(Some(deeper));
                }
            }
        }
    }
    reached.into_iter().map(Option::unwrap_or_default).collect()
}

/// The tool probe's macro on too deep a level.
fn tool_probe(programs: &Programs, levels: &[usize], sites: &[CallSite], found: &mut Vec<Diagnostic>) {
    let of_tool_probe = |cycle: &Cycle| by_program(TOOL_PROBE).is_some_and(|other| std::ptr::eq(other, cycle));
    for site in sites.iter().filter(|site| of_tool_probe(site.cycle)) {
        let unit = programs.of_line(site.line);
        let level = unit.and_then(|unit| levels.get(unit)).copied().unwrap_or(1);
        if level > TOOL_PROBE_LEVEL {
            found.push(own::NCT_LEVEL.finding().number("level", (level - 1) as f64).on(site.span));
        }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use crate::control::{delivery, nct_data::LEVELS};
    use crate::dialect::Dialect;
    use crate::message::Arg;
    use crate::program::findings_on;
    use crate::syntax::read;

    /// Findings about levels on a control that has so many of macros and of subprograms: key, line from 1, figures.
    fn told(text: &str, has: [usize; 2]) -> Vec<(String, u32, Vec<f64>)> {
        let program = read(Dialect::Nct, text.as_bytes());
        let mut control = delivery(Dialect::Nct);
        LEVELS.into_iter().zip(has).for_each(|(name, count)| control.set(name, count as f64));
        let found = findings_on(&program, control).into_iter();
        let ours = found.filter(|one| one.message.key.starts_with("nct-") && one.message.key.contains("level"));
        let number = |arg: &Arg| if let Arg::Number(number) = arg { Some(*number) } else { None };
        ours.map(|one| {
            let figures = one.message.args.iter().filter_map(|(_, arg)| number(arg)).collect();
            (one.message.key.to_string(), program.line_of(one.span.unwrap().start) + 1, figures)
        })
        .collect()
    }

    fn one(key: &str, line: u32, figures: &[f64]) -> Vec<(String, u32, Vec<f64>)> {
        vec![(key.to_owned(), line, figures.to_vec())]
    }

    #[test]
    fn the_tool_probe_has_its_levels() {
        // oracle: manual C:1189 (to maximum the second subroutine level)
        let chain = |levels: usize| {
            let call = |level: usize| format!("O{}\nM98 P{}\nM99\n", 100 + level, 101 + level);
            let before: String = (0..levels).map(call).collect();
            format!("{before}O{}\nG65 P9920 Z-8 T8\nM99\n", 100 + levels)
        };
        assert_eq!(told(&chain(2), [9, 9]), []);
        assert_eq!(told(&chain(3), [9, 9]), one("nct-level", 11, &[3.0]));
    }

    #[test]
    fn levels_are_added_to_those_of_the_caller() {
        // oracle: manual C:1157: G110 calls macros on 2 levels and subprograms on 2; it is one of macros itself
        let text = "O0100\nG65 P200\nM30\nO0200\nM98 P300\nM99\nO0300\nM19\nG110 D50 S1\nM99\n";
        assert_eq!(told(text, [0, 0]), one("nct-levels", 9, &[4.0, 3.0]));
        assert_eq!(told(text, [4, 3]), []);
        assert_eq!(told(text, [3, 3]), one("nct-macro-levels", 9, &[4.0, 3.0]));
        assert_eq!(told(text, [4, 2]), one("nct-subprogram-levels", 9, &[3.0, 2.0]));
    }

    #[test]
    fn a_call_of_the_main_program_is_noted_where_the_control_has_too_few() {
        // oracle: manual C:1157
        let text = "O0100\nM19\nG110 D50 S1\nM30\n";
        assert_eq!(told(text, [0, 0]), []);
        assert_eq!(told(text, [2, 4]), one("nct-macro-levels", 3, &[3.0, 2.0]));
    }

    #[test]
    fn programs_that_call_each_other_come_to_an_end() {
        // oracle: self
        let text = "O0100\nG65 P200\nM30\nO0200\nG65 P200\nG110 D50 S1\nM99\n";
        assert_eq!(told(text, [0, 0]).len(), 1);
    }
}
