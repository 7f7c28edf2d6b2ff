//! Variables of NCT programs, `#number`: of a level, of all programs, those that stay; vacant where nothing was
//! written. Numbers by C:78-90 and, for levels, by the macro language that it builds on.

use super::{Datum, Interpreter, Local, Type, Variable, macro_system};
use crate::diagnostic::Span;
use crate::problem::Problem;
use crate::syntax::tree::Operator;

/// What a number stands for.
enum Kind {
    /// `#0`: always vacant.
    Nothing,
    /// `#1` to `#33`: of the program level; arguments of `G65`.
    Local,
    /// `#100` to `#199`: free for all programs, used by the macros (C:78-82). `#500` to `#999` stay (C:84-88).
    Common,
    /// `#1002` and `#1003`: signals of the tool measuring device (C:1204).
    Input,
    /// What the control tells, from `#3000`.
    System(u32),
}

fn kind(run: &Interpreter, number: u32) -> Option<Kind> {
    Some(match number {
        0 => Kind::Nothing,
        1..=33 => Kind::Local,
        100..=199 | 500..=999 => Kind::Common,
        1002 | 1003 => Kind::Input,
        number if macro_system::is(run, number) => Kind::System(number),
        _ => return None,
    })
}

/// Whether a name is one of these variables.
pub fn is(key: &str) -> bool {
    key.starts_with('#')
}

/// Name of the variable with this number.
pub fn local(number: u32) -> String {
    format!("#{number}")
}

fn known(run: &Interpreter, key: &str, place: Span) -> Result<Kind, Problem> {
    let number = key.get(1..).and_then(|digits| digits.parse().ok());
    let offset = matches!(number, Some(2001..=2999 | 10_001..=13_999));
    let why = if offset { "run-offset-variable" } else { "run-unknown-variable" };
    number.and_then(|number| kind(run, number)).ok_or_else(|| Problem::new(why, place, key))
}

pub fn read(run: &Interpreter, key: &str, place: Span) -> Result<Datum, Problem> {
    let value = match known(run, key, place)? {
        Kind::Nothing => None,
        Kind::Local => {
            let local = run.levels.last().and_then(|level| level.locals.get(key)?.own());
            local.and_then(|variable| variable.values.first().cloned())
        }
        Kind::System(number) => Some(macro_system::read(run, number)),
        Kind::Common | Kind::Input => run.sim.control.data.get(key).map(Datum::from),
    };
    Ok(value.unwrap_or(Datum::Vacant))
}

/// Writes a variable; what is not of a level is recorded.
pub fn write(run: &mut Interpreter, key: &str, value: &Datum, place: Span) -> Result<(), Problem> {
    let number = value.number().ok_or_else(|| Problem::new("run-not-a-number", place, key))?;
    let vacant = *value == Datum::Vacant;
    match known(run, key, place)? {
        Kind::Nothing | Kind::Input => Err(Problem::new("run-read-only", place, key)),
        Kind::System(system) => macro_system::write(run, system, number, place),
        Kind::Local => {
            match run.levels.last_mut() {
                Some(level) if vacant => drop(level.locals.remove(key)),
                Some(level) => drop(level.locals.insert(key.to_owned(), holding(number, place))),
                None => {}
            }
            Ok(())
        }
        Kind::Common => {
            let before = run.sim.control.number(key);
            match vacant {
                true => drop(run.sim.control.data.remove(key)),
                false => run.sim.control.set(key, number),
            }
            run.note_set(key, before, number);
            Ok(())
        }
    }
}

/// A variable of a level with its value.
pub fn holding(number: f64, place: Span) -> Local {
    let mut variable = Variable::new(Type::Real, Vec::new(), place);
    variable.values = vec![Datum::Number(number)];
    Local::Own(variable)
}

/// `EQ` and `NE` where one side is vacant: only vacant is equal to vacant. None: the values decide.
pub fn compared(operator: Operator, a: &Datum, b: &Datum) -> Option<Datum> {
    let (one, other) = (*a == Datum::Vacant, *b == Datum::Vacant);
    match operator {
        Operator::Equal if one || other => Some(Datum::from(one == other)),
        Operator::NotEqual if one || other => Some(Datum::from(one != other)),
        _ => None,
    }
}
