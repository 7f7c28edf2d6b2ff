//! `DEF`: variables of a program with sizes and first values.

use super::{Interpreter, Local, Type, Variable, expression, limits, names};
use crate::control::AXES;
use crate::diagnostic::{Severity, Span};
use crate::problem::Problem;
use crate::syntax::tree::{ExprId, Word, WordKind};

/// What the words of a declaration have said so far.
#[derive(Clone, Copy, Debug, Default)]
pub struct Declaring {
    /// Type of the names that follow.
    pub kind: Option<Type>,
    /// Whether every program of the text sees them (`NCK`, `CHAN`).
    pub shared: bool,
}

/// Most elements of a variable.
const ELEMENTS: f64 = 10_000.0;
/// Declared elements that count as one block's work.
const WRITTEN: usize = 4;

impl Declaring {
    /// Takes a word that may be a type, with its length, or an attribute.
    pub fn take(&mut self, run: &Interpreter, name: &str, length: Option<ExprId>) -> Result<(), Problem> {
        self.shared |= matches!(name, "NCK" | "CHAN");
        let length = length.map(|length| expression::number(run, length)).transpose()?;
        self.kind = Type::named(name, length).or(self.kind);
        Ok(())
    }
}

/// Whether every machine has an axis of this name, which no variable takes.
pub fn is_axis(name: &str) -> bool {
    AXES.contains(&name)
}

/// Makes the variable that a word declares, with its first value.
pub fn declare(run: &mut Interpreter, word: &Word, declaring: Declaring) -> Result<(), Problem> {
    let WordKind::Declare { name, index: sizes, value: first } = &word.kind else { return Ok(()) };
    let (name, key) = (*name, run.program.name(*name));
    if is_axis(&key) {
        return Err(Problem::new("run-axis-name", name, &*key));
    }
    let kind = declaring.kind.ok_or_else(|| Problem::new("run-type", name, &*key))?;
    let variable = variable(run, name, kind, sizes)?;
    let (locals, elements) = match run.levels.last_mut() {
        Some(level) if !declaring.shared => (&mut level.locals, &mut level.elements),
        _ => (&mut run.shared, &mut run.shared_elements),
    };
    run.unread.remove(&key);
    *elements += variable.values.len();
    let before = locals.insert(key.clone(), Local::Own(variable));
    *elements -= before.as_ref().and_then(Local::own).map_or(0, |old| old.values.len());
    if matches!(before, Some(Local::Own(old)) if old.place != name) {
        run.tell(Severity::Error, &Problem::new("run-declared-twice", name, &*key));
    }
    first.map_or(Ok(()), |first| names::write(run, &key, &expression::evaluate(run, first)?, name))
}

/// A variable of these sizes; making it is work that counts, and takes room.
pub fn variable(run: &mut Interpreter, name: Span, kind: Type, sizes: &[ExprId]) -> Result<Variable, Problem> {
    let mut total = 1.0;
    let mut counts = Vec::new();
    for size in sizes {
        let size = expression::number(run, *size)?;
        total *= size.trunc();
        if !(size >= 1.0 && total <= ELEMENTS) {
            return Err(Problem::new("run-array-size", name, run.program.name(name)).number("limit", ELEMENTS));
        }
        counts.push(size as usize);
    }
    limits::elements(run, total as usize, name)?;
    run.work += (total as usize / WRITTEN) as u64;
    Ok(Variable::new(kind, counts, name))
}
