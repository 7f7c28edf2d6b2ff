//! Arguments of a call as such: of the wrong sort, too many, a selection that tells no variant.

use crate::diagnostic::Diagnostic;
use crate::entry::{Arg, ArgumentList, Cycle, Kind, Param, Style};
use crate::own;

/// What sort of value a program writes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sort {
    /// A text in quotation marks.
    Text,
    /// A number, or what is worth one.
    Number,
    /// A name that the program does not declare.
    Undeclared,
    /// Only the run tells.
    Open,
}

/// A text where a number belongs, or the reverse: the control converts neither.
pub fn sort(param: &Param, value: &str, sort: Sort) -> Option<Diagnostic> {
    let sentence = match (&param.kind, sort) {
        (Kind::Text(_), Sort::Number) => own::TEXT_WANTED,
        (Kind::Text(_), Sort::Undeclared) => own::TEXT_UNQUOTED,
        (Kind::Text(_), _) => return None,
        (_, Sort::Text) => own::NUMBER_WANTED,
        _ => return None,
    };
    Some(sentence.finding().text("param", param.name).text("value", value).at(param.name))
}

/// How many arguments a call has; omitted ones at its end say nothing.
pub fn count<T>(arguments: &[Option<T>]) -> usize {
    arguments.iter().rposition(Option::is_some).map_or(0, |index| index + 1)
}

/// More arguments than the called program has parameters. Those of newer controls differ in this by their version.
pub fn too_many(name: &str, most: usize, count: usize) -> Option<Diagnostic> {
    (count > most).then(|| {
        own::ARGUMENTS_MANY.finding().text("name", name).number("most", most as f64).number("count", count as f64)
    })
}

/// What is wrong with a call of a cycle that has so many arguments; `number` tells what stands at one, if known.
pub fn refused(
    cycle: &Cycle,
    list: Option<&'static ArgumentList>,
    count: usize,
    number: impl Fn(usize) -> Option<f64>,
) -> Option<Diagnostic> {
    let Some(list) = list else { return too_many(cycle.name, 0, count) };
    if list.style == Style::Operate {
        return None;
    }
    if let Some(found) = too_many(list.name, list.args.len(), count) {
        return Some(found);
    }
    let (index, choices) = list.unselected(&number)?;
    Some(selection(list.name, index, number(index)?, choices))
}

/// Numbers where the older control takes variables: newer ones have a list of their own there, which is not published
/// (CYCLE116, CYCLE119). `numbers`: of each argument, whether a program writes it as a number.
pub fn numbers_for_variables(list: &ArgumentList, numbers: impl Iterator<Item = bool>) -> Option<Diagnostic> {
    let variable = |arg: &Arg| matches!(arg, Arg::Variable(_) | Arg::Output(_));
    let mut written = list.args.iter().zip(numbers).filter(|(arg, _)| list.style == Style::Direct && variable(arg));
    written.any(|(_, number)| number).then(|| own::NEWER_NO_LIST.finding().text("cycle", list.name))
}

/// An argument that selects nothing.
pub fn selection(name: &str, index: usize, value: f64, choices: &[(i64, i64)]) -> Diagnostic {
    let choices: Vec<String> = choices.iter().map(|(written, _)| written.to_string()).collect();
    let finding = own::SELECTION.finding().number("place", index as f64 + 1.0);
    finding.text("name", name).number("value", value).hint_text("choices", choices.join(", "))
}
