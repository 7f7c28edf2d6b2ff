//! One block: words in order (assignments act at once), then functions, motion and calls together.

use super::datum::Datum;
use super::expression::{self, evaluate};
use super::flow::{Link, canonical};
use super::interpret::{Interpreter, Next};
use super::motion::Path;
use super::problem::Problem;
use super::trace::Step;
use super::{Stop, action, environment, names};
use crate::control::{Value, arrays};
use crate::diagnostic::{Severity, Span};
use crate::program::tree::{Expr, ExprId, Word, WordKind};

/// A call in a block.
#[derive(Clone, Debug)]
pub struct Call {
    /// Name in upper case.
    pub name: String,
    /// Values of the arguments.
    pub args: Vec<Option<Datum>>,
    /// Place.
    pub span: Span,
}

/// Address words of a block, by letter, in order.
#[derive(Clone, Debug)]
pub struct Address {
    /// Letters in upper case.
    pub name: String,
    /// Extension in `S1=500`.
    pub extension: Option<u32>,
    /// AC, IC, DC, …
    pub mode: Option<String>,
    /// Value.
    pub value: Datum,
    /// Place.
    pub span: Span,
}

/// What a block asks for, collected.
#[derive(Clone, Debug, Default)]
pub struct Words {
    /// Addresses.
    pub addresses: Vec<Address>,
    /// Calls and words without value.
    pub calls: Vec<Call>,
    /// Motion.
    pub path: Path,
    /// RPL of ROT, degree.
    pub turn: Option<f64>,
    /// Where the keywords of the block send the program.
    pub next: Option<Next>,
    /// Value of CASE.
    case: Option<Datum>,
    /// A constant of CASE that was met: the next jump counts or does not.
    armed: Option<bool>,
    /// Type of a declaration is a text.
    text: bool,
    /// Value of FOR's variable.
    counter: Option<f64>,
}

/// Carries out a block.
pub fn block(run: &mut Interpreter, at: usize) -> Result<Next, Stop> {
    let Some(block) = run.program.blocks.get(at) else {
        return Ok(Next::End);
    };
    let words = run.program.words_of(block);
    if left_out(run, words) {
        return Ok(Next::Block);
    }
    let mut found = Words {
        path: Path {
            span: block.span,
            ..Path::default()
        },
        ..Words::default()
    };
    for word in words {
        let go_on = word_of(run, at, word, &mut found).map_err(|problem| run.fail(problem))?;
        if !go_on {
            return Ok(found.next.unwrap_or(Next::Block));
        }
    }
    let next = action::perform(run, at, found)?;
    if next != Next::Block {
        return Ok(next);
    }
    Ok(match run.link(at) {
        Some(Link::Else(end)) if starts_with(run, words, "ELSE") => Next::Jump(end + 1),
        _ => Next::Block,
    })
}

/// Blocks of which nothing is carried out: declarations of subprograms, synchronised actions.
fn left_out(run: &mut Interpreter, words: &[Word]) -> bool {
    for word in words {
        if let WordKind::Keyword { name, .. } = &word.kind {
            let text = run.program.name(*name);
            match text.as_str() {
                "PROC" | "EXTERN" | "ENDPROC" => return true,
                "WHEN" | "WHENEVER" | "EVERY" | "FROM" | "REDEF" => {
                    run.tell(
                        Severity::Warning,
                        &Problem::new("run-not-simulated", word.span, text),
                    );
                    return true;
                }
                _ => {}
            }
        }
    }
    false
}

fn starts_with(run: &Interpreter, words: &[Word], keyword: &str) -> bool {
    words.iter().any(|word| match &word.kind {
        WordKind::Keyword { name, .. } => run.program.is(*name, keyword),
        _ => false,
    })
}

/// Takes one word; false: the rest of the block is not carried out.
fn word_of(
    run: &mut Interpreter,
    at: usize,
    word: &Word,
    found: &mut Words,
) -> Result<bool, Problem> {
    match &word.kind {
        WordKind::Address {
            name,
            extension,
            mode,
            value,
        } => {
            let address = Address {
                name: run.program.name(*name),
                extension: *extension,
                mode: mode.map(|mode| run.program.name(mode)),
                value: evaluate(run, *value)?,
                span: word.span,
            };
            found.addresses.push(address);
        }
        WordKind::Assign {
            name, index, value, ..
        } => {
            let key = names::key(run, *name, index)?;
            let value = match environment::assigned(run, *value)? {
                Some(status) => status,
                None => evaluate(run, *value)?,
            };
            assign(run, &key, value, word.span, found)?;
        }
        WordKind::Declare { name, index, value } => declare(run, *name, index, *value, found.text)?,
        WordKind::Constant(value) => {
            let value = evaluate(run, *value)?;
            if let Some(case) = &found.case {
                found.armed = Some(*case == value);
            }
        }
        WordKind::Call { name, args, .. } => {
            let args = args
                .iter()
                .map(|arg| arg.map(|arg| evaluate(run, arg)).transpose());
            let args = args.collect::<Result<Vec<_>, _>>()?;
            found.calls.push(Call {
                name: run.program.name(*name),
                args,
                span: word.span,
            });
        }
        WordKind::Label(_) | WordKind::Header(_) => {}
        WordKind::Keyword { name, value } => return keyword(run, at, *name, *value, found),
        WordKind::Unknown => {
            let text = String::from_utf8_lossy(run.program.text(word.span)).into_owned();
            run.tell(
                Severity::Error,
                &Problem::new("run-unknown-word", word.span, text),
            );
        }
    }
    Ok(true)
}

/// Assignments; a few names are settings of the block.
fn assign(
    run: &mut Interpreter,
    key: &str,
    value: Datum,
    span: Span,
    found: &mut Words,
) -> Result<(), Problem> {
    let number = || {
        value
            .number()
            .ok_or_else(|| Problem::new("run-not-a-number", span, key))
    };
    match key {
        "MEAS" | "MEAW" => found.path.measure = Some(number()? as i64),
        "RPL" => found.turn = Some(number()?),
        _ => {
            names::write(run, key, &value, span)?;
            found.counter = value.number();
        }
    }
    Ok(())
}

/// Most elements of a local array.
const ELEMENTS: f64 = 10_000.0;
/// Declared elements that count as one block's work.
const WRITTEN: usize = 4;

fn declare(
    run: &mut Interpreter,
    name: Span,
    sizes: &[ExprId],
    first: Option<ExprId>,
    text: bool,
) -> Result<(), Problem> {
    let key = run.program.name(name);
    let empty = if text {
        Value::Text(String::new())
    } else {
        Value::Number(0.0)
    };
    let mut total = 1.0;
    let mut counts = Vec::new();
    for size in sizes {
        let size = expression::number(run, *size)?;
        let whole = size.trunc();
        total *= whole;
        if !(whole >= 1.0 && total <= ELEMENTS) {
            let mut problem = Problem::new("run-array-size", name, key);
            problem.message = problem.message.number("limit", ELEMENTS);
            return Err(problem);
        }
        counts.push(size as usize);
    }
    run.work += total as usize / WRITTEN;
    if counts.is_empty() {
        run.locals.insert(key.clone(), empty);
    } else {
        for element in arrays::elements_from(&key, &counts) {
            run.locals.insert(element, empty.clone());
        }
        run.arrays.insert(key.clone(), counts);
    }
    if let Some(first) = first {
        let value = evaluate(run, first)?;
        names::write(run, &key, &value, name)?;
    }
    Ok(())
}

/// Keywords; false: the rest of the block is not carried out.
fn keyword(
    run: &mut Interpreter,
    at: usize,
    place: Span,
    value: Option<ExprId>,
    found: &mut Words,
) -> Result<bool, Problem> {
    let name = run.program.name(place);
    match name.as_str() {
        "IF" => return condition(run, at, place, value, found),
        "GOTO" | "GOTOF" | "GOTOB" | "GOTOC"
            if found.case.is_none() || found.armed == Some(true) =>
        {
            found.next = jump(run, at, &name, place, value)?.map(Next::Jump);
            return Ok(found.next.is_none());
        }
        "CASE" => found.case = value.map(|value| evaluate(run, value)).transpose()?,
        "DEFAULT" => found.armed = Some(true),
        "WHILE" | "FOR" | "LOOP" | "UNTIL" | "ENDWHILE" | "ENDFOR" | "ENDLOOP" | "ELSE"
        | "ENDIF" | "TO" | "END" => {
            return structure(run, at, &name, place, value, found);
        }
        "REPEAT" if value.is_none() => return structure(run, at, &name, place, value, found),
        "RET" => found.next = Some(run.returns.pop().map_or(Next::End, Next::Jump)),
        "STRING" => found.text = true,
        "REPEAT" | "REPEATB" => {
            run.tell(
                Severity::Warning,
                &Problem::new("run-not-simulated", place, name),
            );
        }
        _ => {}
    }
    Ok(true)
}

/// `IF` with a jump (or NCT `THEN`) decides over the rest of the block, else over the blocks up to `ELSE` or `ENDIF`.
fn condition(
    run: &mut Interpreter,
    at: usize,
    place: Span,
    value: Option<ExprId>,
    found: &mut Words,
) -> Result<bool, Problem> {
    let holds = truth(run, place, value)?;
    match run.link(at) {
        Some(Link::If(other)) if !holds => {
            found.next = Some(Next::Jump(other + 1));
            Ok(false)
        }
        // an IF with ELSE is linked to the ELSE block, which is passed over from above
        Some(Link::If(_)) => Ok(true),
        Some(Link::Alone) => Err(Problem::new("run-unmatched", place, "IF")),
        _ => Ok(holds),
    }
}

fn truth(run: &Interpreter, place: Span, value: Option<ExprId>) -> Result<bool, Problem> {
    let value = value.ok_or_else(|| Problem::new("run-not-a-number", place, ""))?;
    Ok(expression::number(run, value)? != 0.0)
}

/// Loops and the parts of `IF`.
fn structure(
    run: &mut Interpreter,
    at: usize,
    name: &str,
    place: Span,
    value: Option<ExprId>,
    found: &mut Words,
) -> Result<bool, Problem> {
    let link = run.link(at);
    if link == Some(Link::Alone) || (link.is_none() && name != "TO") {
        return Err(Problem::new("run-unmatched", place, name));
    }
    match (name, link) {
        ("WHILE", Some(Link::Begin(end))) if !truth(run, place, value)? => {
            found.next = Some(Next::Jump(end + 1));
            return Ok(false);
        }
        ("TO", Some(Link::Begin(end))) => {
            let last = value
                .map(|value| expression::number(run, value))
                .transpose()?;
            if found
                .counter
                .zip(last)
                .is_some_and(|(counter, last)| counter > last)
            {
                found.next = Some(Next::Jump(end + 1));
                return Ok(false);
            }
        }
        ("ENDWHILE" | "ENDLOOP" | "END", Some(Link::End(begin))) => {
            found.next = Some(Next::Jump(begin))
        }
        ("UNTIL", Some(Link::End(begin))) if !truth(run, place, value)? => {
            found.next = Some(Next::Jump(begin + 1));
        }
        ("ENDFOR", Some(Link::End(begin))) => found.next = again(run, begin)?,
        _ => {}
    }
    Ok(found.next.is_none())
}

/// Counts the variable of the `FOR` in this block up; where its body goes on, if it does.
fn again(run: &mut Interpreter, begin: usize) -> Result<Option<Next>, Problem> {
    let Some(block) = run.program.blocks.get(begin) else {
        return Ok(None);
    };
    let (mut counter, mut last) = (None, None);
    for word in run.program.words_of(block) {
        match &word.kind {
            WordKind::Assign { name, index, .. } => {
                let key = names::key(run, *name, index)?;
                let value = names::read(run, &key, *name)?.number().unwrap_or(0.0) + 1.0;
                names::write(run, &key, &Datum::Number(value), *name)?;
                counter = Some(value);
            }
            WordKind::Keyword {
                name,
                value: Some(value),
            } if run.program.is(*name, "TO") => {
                last = Some(expression::number(run, *value)?);
            }
            _ => {}
        }
    }
    let inside = counter
        .zip(last)
        .is_some_and(|(counter, last)| counter <= last);
    Ok(inside.then_some(Next::Jump(begin + 1)))
}

/// Block of a jump target; none for GOTOC without target.
fn jump(
    run: &Interpreter,
    at: usize,
    word: &str,
    place: Span,
    value: Option<ExprId>,
) -> Result<Option<usize>, Problem> {
    let target = value
        .map(|id| target(run, id))
        .transpose()?
        .unwrap_or_default();
    let blocks = run
        .targets
        .get(&canonical(&target))
        .map(Vec::as_slice)
        .unwrap_or_default();
    let forward = blocks.iter().copied().find(|block| *block > at);
    let backward = blocks.iter().copied().rfind(|block| *block <= at);
    let found = match word {
        "GOTOF" => forward,
        "GOTOB" => backward,
        _ => forward.or(backward),
    };
    match found {
        None if word != "GOTOC" => Err(Problem::new("run-label", place, target)),
        found => Ok(found),
    }
}

/// A target is a label, a block number, a text or a number.
fn target(run: &Interpreter, id: ExprId) -> Result<String, Problem> {
    if let Some(Expr::Name { name, index }) = run.program.expr(id)
        && index.is_empty()
        && !run.program.text(*name).starts_with(b"#")
        && !run.locals.contains_key(&run.program.name(*name))
    {
        return Ok(run.program.name(*name));
    }
    Ok(match evaluate(run, id)? {
        Datum::Number(number) => format!("N{number}"),
        other => other.shown().to_ascii_uppercase(),
    })
}

/// Records an operator text.
pub fn message(run: &mut Interpreter, args: &[Option<Datum>]) {
    let text = args
        .first()
        .and_then(Option::as_ref)
        .map(Datum::shown)
        .unwrap_or_default();
    run.sim.note(Step::Message(text));
}
