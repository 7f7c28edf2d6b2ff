//! One block: words in order (assignments act at once), then functions, motion and calls together.

use super::{
    Datum, Halt, Interpreter, Measure, Next, Path, action, back, branch, circle_data, contour, declare,
    declare::Declaring, diameters, evaluate, expression, indexed, locals, names, noted, of_control, plain, repeat,
    synchronous, tool_memory, uncomputed, unread,
};
use crate::diagnostic::{Severity, Span};
use crate::own;
use crate::problem::Problem;
use crate::program::words::{MOVES_TOOL, ignores_arguments, left_out as left_out_value};
use crate::syntax::language::BY_TEXT;
use crate::syntax::links::Link;
use crate::syntax::tree::{Block, Expr, ExprId, Word, WordKind};
use std::borrow::Cow;
use std::rc::Rc;

/// A call in a block.
#[derive(Clone, Debug, PartialEq)]
pub struct Call {
    /// Name in upper case.
    pub name: String,
    /// Values of the arguments; a whole array is a list.
    pub args: Vec<Option<Datum>>,
    /// Names with index of the arguments that are variables, for what a called program or cycle writes.
    pub places: Vec<Option<String>>,
    pub span: Span,
}

impl Call {
    /// A call without arguments.
    pub fn named(name: impl Into<String>, span: Span) -> Call {
        Call { name: name.into(), args: Vec::new(), places: Vec::new(), span }
    }

    /// The value of an argument that is written.
    pub fn arg(&self, index: usize) -> Option<&Datum> {
        self.args.get(index)?.as_ref()
    }

    /// Number of an argument, 0 where it is omitted; none: it is a text or the like.
    pub fn number(&self, index: usize) -> Option<f64> {
        self.arg(index).map_or(Some(0.0), Datum::number)
    }
}

/// Address words of a block, by letter, in order.
#[derive(Clone, Debug, PartialEq)]
pub struct Address {
    /// Letters in upper case.
    pub name: String,
    /// Extension in `S1=500`.
    pub extension: Option<u32>,
    pub mode: Option<String>,
    pub value: Datum,
    pub span: Span,
}

impl Address {
    /// An address word with its value; none: the word is something else.
    pub fn of(run: &Interpreter, word: &Word) -> Result<Option<Address>, Problem> {
        let WordKind::Address { name, .. } = &word.kind else { return Ok(None) };
        Address::named(run, run.program.name(*name), word)
    }

    /// The same with these letters.
    fn named(run: &Interpreter, name: String, word: &Word) -> Result<Option<Address>, Problem> {
        let WordKind::Address { extension, mode, value, .. } = &word.kind else { return Ok(None) };
        let (mode, value) = (mode.map(|mode| run.program.name(mode)), evaluate(run, *value)?);
        Ok(Some(Address { name, extension: *extension, mode, value, span: word.span }))
    }
}

/// What a block asks for, collected.
#[derive(Clone, Debug, Default)]
pub struct Words {
    pub addresses: Vec<Address>,
    /// Axes that move by themselves: `POS[X]=5`.
    pub positioning: Vec<Address>,
    /// Calls and words without value.
    pub calls: Vec<Call>,
    pub path: Path,
    /// RPL of ROT, degree.
    pub turn: Option<f64>,
    /// Where the keywords of the block send the program.
    pub next: Option<Next>,
    /// Value of CASE.
    pub case: Option<Datum>,
    /// A constant of CASE that was met: the next jump counts or does not.
    pub armed: Option<bool>,
    pub at: usize,
    /// What a declaration has said.
    declaring: Declaring,
    /// Value of FOR's variable.
    pub counter: Option<f64>,
    /// RET ends the program.
    pub leaves: Option<back::Back>,
    /// A word of the block could not be read.
    pub unread: bool,
}

impl Words {
    /// Of a block of which no word was taken yet.
    pub fn before(at: usize, span: Span) -> Words {
        Words { at, path: Path { span, ..Path::default() }, ..Words::default() }
    }

    /// Addresses with these letters, in order.
    pub fn of<'a>(&'a self, letters: &'a str) -> impl DoubleEndedIterator<Item = &'a Address> {
        self.addresses.iter().filter(move |address| address.name == letters)
    }

    /// The G function or M function with this number.
    pub fn function(&self, letter: &str, number: f64) -> Option<&Address> {
        self.addresses.iter().find(|address| address.name == letter && address.value.number() == Some(number))
    }
}

pub fn block(run: &mut Interpreter, at: usize) -> Result<Next, Halt> {
    let program = Rc::clone(&run.program);
    let Some(block) = program.blocks.get(at) else { return Ok(Next::End) };
    let words = program.words_of(block);
    if block.skip.is_some_and(|level| run.skip.contains(&level)) || left_out(run, at, words) {
        return Ok(Next::Block);
    }
    unread::tell(run, at);
    if let Some(motion) = program.plain(block) {
        return plain::block(run, at, block.span, &motion);
    }
    if let Some((keyword, label)) = repetition(run, words) {
        repeat::alone(run, words)?;
        return Ok(repeat::begin(run, at, keyword, label, words)?);
    }
    if contour::waits(run) && asks_for_position(run, block) {
        contour::finish(run)?;
    }
    let mut found = Words::before(at, block.span);
    let mut rest = words.iter();
    while let Some(word) = rest.next() {
        // IF … GOTOF A ELSE GOTOF B: the other jump of the same block
        let otherwise = |word: &Word| program.is_keyword(word, &["ELSE"]);
        if !word_of(run, word, &mut found)? && (found.next.is_some() || !rest.any(otherwise)) {
            return Ok(found.next.unwrap_or(Next::Block));
        }
    }
    let next = action::perform(run, found)?;
    if next != Next::Block {
        return Ok(next);
    }
    Ok(match run.link(at) {
        Some(Link::Else(end)) if words.iter().any(|word| program.is_keyword(word, &["ELSE"])) => {
            branch::behind(run, end)?
        }
        _ => Next::Block,
    })
}

/// Whether the block has a word that counts on the real position or writes data of tools.
fn asks_for_position(run: &Interpreter, block: &Block) -> bool {
    let span = Span { end: block.comment.map_or(block.span.end, |comment| comment.start), ..block.span };
    let text = run.program.text(span).to_ascii_uppercase();
    let holds = |word: &[u8]| text.windows(word.len()).any(|part| part == word);
    run.rules().asks_for_position.iter().any(|word| holds(word))
}

/// `REPEAT LABEL` or `REPEATB LABEL` with the label.
fn repetition(run: &Interpreter, words: &[Word]) -> Option<(Span, ExprId)> {
    let repeats = |name: Span| run.program.is(name, "REPEAT") || run.program.is(name, "REPEATB");
    words.iter().find_map(|word| match &word.kind {
        WordKind::Keyword { name, value: Some(label) } if repeats(*name) => Some((*name, *label)),
        _ => None,
    })
}

/// Blocks of which nothing is carried out: declarations; and, which is told, synchronised actions and interrupts.
fn left_out(run: &mut Interpreter, at: usize, words: &[Word]) -> bool {
    let loops = || run.program.grammar().structures.contains(&"DO");
    for word in words {
        let (WordKind::Keyword { name, .. } | WordKind::Call { name, .. }) = &word.kind else { continue };
        let text = run.program.name(*name);
        match text.as_str() {
            "PROC" | "EXTERN" | "ENDPROC" | "DEFINE" => return true,
            "WHEN" | "WHENEVER" | "EVERY" | "FROM" | "REDEF" | "SETINT" => {}
            "DO" if !loops() => {}
            _ => continue,
        }
        synchronous::keep(run, at, word.span, &text);
        return true;
    }
    false
}

/// Takes one word; false: the rest of the block is not carried out.
pub(super) fn word_of(run: &mut Interpreter, word: &Word, found: &mut Words) -> Result<bool, Problem> {
    match &word.kind {
        WordKind::Address { name, extension, mode, value } => {
            let letters = run.program.name(*name);
            let variable = match extension {
                Some(number) => Cow::from(format!("{letters}{number}")),
                None => Cow::from(&letters),
            };
            let name = *name;
            if mode.is_none() && hidden(run, &variable, word.span) && !is_address(run, name, *value, &variable) {
                let value = right_side(run, *value)?;
                names::write(run, &variable, &value, word.span)?;
                found.counter = value.number();
                return Ok(true);
            }
            let address = Address::named(run, letters, word)?;
            found.addresses.extend(address.filter(|address| address.value != Datum::Vacant));
        }
        WordKind::Assign { name, index, value, .. } => {
            let letters = run.program.name(*name);
            if left_alone(run, &letters, word.span) {
                return Ok(true);
            }
            if !locals::declared(run, &letters) && indexed::take(run, word, found)? {
                return Ok(true);
            }
            let key = names::key(run, *name, index)?;
            match right_side(run, *value) {
                Err(problem) if uncomputed::leaves(run, &problem, &key, *value)? => {}
                value => assign(run, &key, value?, word.span, found)?,
            }
        }
        WordKind::Declare { .. } => declare::declare(run, word, found.declaring)?,
        WordKind::Constant(value) => {
            let value = evaluate(run, *value)?;
            match (&found.case, found.calls.last_mut()) {
                (Some(case), _) => found.armed = Some(*case == value),
                (None, Some(call)) if BY_TEXT.contains(&call.name.as_str()) => call.args.push(Some(value)),
                _ => return Err(Problem::new("run-unknown-word", word.span, value.shown())),
            }
        }
        WordKind::Call { name, args, .. } => {
            let word_name = run.program.name(*name);
            if diameters::take(run, &word_name, args, word.span)? {
                return Ok(true);
            }
            let own = run.programs.named(&word_name).is_some();
            let args = if !own && ignores_arguments(&word_name) && uncomputed::find(&word_name).is_none() {
                &[]
            } else {
                &args[..]
            };
            found.calls.push(call(run, *name, args, word.span)?);
        }
        WordKind::Label(_) | WordKind::Header => {}
        WordKind::Keyword { name, value } => return keyword(run, *name, *value, found),
        WordKind::Unknown => {
            unread::pass(run, word, found)?;
        }
    }
    Ok(true)
}

/// The right side of an assignment, which may be a function that does something.
fn right_side(run: &mut Interpreter, value: ExprId) -> Result<Datum, Problem> {
    let made = of_control::assigned(run, value)?.or(tool_memory::assigned(run, value)?);
    match made.or(circle_data::assigned(run, value)?) {
        Some(made) => Ok(made),
        None => evaluate(run, value),
    }
}

/// Whether a name with a value is one that the run goes on without; where it does something, that is told.
fn left_alone(run: &mut Interpreter, name: &str, span: Span) -> bool {
    let Some(told) = left_out_value(name).filter(|_| !locals::declared(run, name)) else { return false };
    if told {
        noted::without(run, "run-passed", span, name);
    }
    if name == MOVES_TOOL {
        unread::leave_all_axes(run, span);
    }
    true
}

/// Whether a variable of the program has the name of an address. X, Y and Z stay axes, whatever is declared; where the
/// machine has a rotary axis of that name, it is told that the program means its variable.
pub fn hidden(run: &mut Interpreter, name: &str, span: Span) -> bool {
    let variable = !declare::is_axis(name) && locals::declared(run, name);
    if variable && run.sim.control.rotary_axis(name).is_some() {
        run.tell(Severity::Warning, &Problem::new("run-axis-variable", span, name));
    }
    variable
}

/// Whether a word is the address although a variable has its name: `M30` without `=` stays the function.
fn is_address(run: &mut Interpreter, name: Span, value: ExprId, variable: &str) -> bool {
    let between = Span { start: name.end, end: run.program.place(value).start };
    let address = !run.program.text(between).contains(&b'=');
    if address {
        tell_letter(run, variable, name);
    }
    address
}

/// Tells, at its declaration, a variable that has the name of an address.
pub fn tell_letter(run: &mut Interpreter, name: &str, place: Span) {
    let home = locals::home(run, name);
    let declared = locals::variable(run, &home).map_or(place, |variable| variable.place);
    run.tell_once(own::BLOCK_LETTER_NAME.finding().text("word", name).on(declared));
}

/// A call with the values of its arguments.
fn call(run: &Interpreter, name: Span, args: &[ExprId], span: Span) -> Result<Call, Problem> {
    let places = args.iter().map(|arg| match run.program.expr(*arg) {
        Some(Expr::Name { name, index }) => names::key(run, *name, index).map(Some),
        _ => Ok(None),
    });
    Ok(Call {
        name: run.program.name(name),
        args: expression::list(run, args)?,
        places: places.collect::<Result<_, _>>()?,
        span,
    })
}

/// Assignments; a few names are settings of the block.
fn assign(run: &mut Interpreter, key: &str, value: Datum, span: Span, found: &mut Words) -> Result<(), Problem> {
    let number = || value.number().ok_or_else(|| Problem::new("run-not-a-number", span, key));
    match key {
        "MEAS" | "MEAW" => {
            found.path.measure = Some(Measure { input: number()? as i64, goes_on: key == "MEAW" });
        }
        "RPL" => found.turn = Some(number()?),
        "LIMS" => run.modal.speed_limit = Some(number()?),
        "OFFN" => run.modal.allowance = number()? * run.sim.control.active_factor(),
        "DISC" if number()? == 0.0 => {}
        "DISC" if !(0.0..=100.0).contains(&number()?) => return Err(Problem::new("run-range", span, key)),
        "DISC" => run.tell(Severity::Warning, &Problem::new("run-not-simulated", span, key)),
        _ => {
            names::write(run, key, &value, span)?;
            found.counter = value.number();
        }
    }
    Ok(())
}

/// Keywords; false: the rest of the block is not carried out.
fn keyword(run: &mut Interpreter, place: Span, value: Option<ExprId>, found: &mut Words) -> Result<bool, Problem> {
    let name = run.program.name(place);
    match name.as_str() {
        "IF" => return branch::condition(run, place, value, found),
        "GOTO" | "GOTOF" | "GOTOB" | "GOTOC" => {
            if found.case.is_some() && found.armed != Some(true) {
                return Ok(true);
            }
            found.next = branch::jump(run, place, value, found.at)?.map(Next::Jump);
            return Ok(found.next.is_none());
        }
        "CASE" => found.case = value.map(|value| evaluate(run, value)).transpose()?,
        "DEFAULT" => found.armed = Some(true),
        "WHILE" | "FOR" | "LOOP" | "UNTIL" | "ENDWHILE" | "ENDFOR" | "ENDLOOP" | "ELSE" | "ENDIF" | "TO" | "END"
        | "REPEAT" | "DO" => return branch::structure(run, place, value, found),
        "RET" => found.leaves = Some(back::written(run, place, value)?),
        _ => found.declaring.take(run, &name, value)?,
    }
    Ok(true)
}
