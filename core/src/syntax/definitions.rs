//! Definition files: `DEF NCK|CHAN type name[n,m] = …` adds a user datum to the control, `REDEF name …` gives one other
//! attributes. They are files of their own, or sections `%_N_GUD4_DEF` of a text.

use super::fold::{self, NOTHING};
use super::programs::{Programs, programs};
use super::read;
use super::tree::{Block, Expr, ExprId, Program, Word, WordKind};
use crate::control::definitions::{Definition, Definitions, ELEMENTS, First, Type};
use crate::control::{AXES, Value, gud};
use crate::diagnostic::{Diagnostic, Severity, Span};
use crate::dialect::Dialect;
use crate::own;
use crate::problem::Problem;
use std::collections::btree_map::Entry;
use std::sync::Arc;

/// What was read of a definition file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Defined {
    /// What it adds to the control.
    pub definitions: Definitions,
    /// Data of the measuring cycles in it, which are on every control.
    pub measuring: Vec<Measuring>,
    /// What is wrong with it; what is not defined then, is left out.
    pub problems: Vec<Problem>,
    /// Lists with more values than their arrays have elements.
    pub beyond: Vec<Beyond>,
}

/// A list whose last values have no element.
#[derive(Clone, Debug, PartialEq)]
pub struct Beyond {
    /// Name of the datum.
    pub name: String,
    /// Where the name stands.
    pub place: Span,
    /// How many elements there are, and how many values.
    pub counts: [usize; 2],
}

/// A datum of the measuring cycles, as a definition file has it.
#[derive(Clone, Debug, PartialEq)]
pub struct Measuring {
    /// Its name.
    pub name: String,
    /// Where the name stands.
    pub place: Span,
    /// Sizes of an array.
    pub sizes: Vec<usize>,
    /// First values.
    pub first: First,
}

impl Defined {
    /// What is wrong, as findings.
    pub fn findings(&self) -> impl Iterator<Item = Diagnostic> {
        let problems = self.problems.iter().map(|problem| problem.diagnostic(Severity::Error));
        let beyond = self.beyond.iter().map(|one| {
            let [elements, values] = one.counts.map(|count| count as f64);
            let many = own::DEFINITION_MANY.finding().text("name", &*one.name);
            many.number("elements", elements).number("values", values).on(one.place)
        });
        problems.chain(beyond)
    }
}

/// Reads a definition file: its sections that are named so, or the whole text where no header says what it is.
pub fn definitions(text: &[u8]) -> Defined {
    let program = read(Dialect::Sinumerik, text);
    let programs = programs(&program);
    if programs.definitions.is_empty() && programs.names.is_empty() {
        return of_blocks(&program, &program.blocks);
    }
    of_text(&program, &programs)
}

/// What the definition files in the text of a program add.
pub fn of_text(program: &Program, programs: &Programs) -> Defined {
    let sections = programs.definitions.iter().filter_map(|range| program.blocks.get(range.clone()));
    of_blocks(program, sections.flatten())
}

fn of_blocks<'a>(program: &'a Program, blocks: impl IntoIterator<Item = &'a Block>) -> Defined {
    let mut found = Defined::default();
    for block in blocks {
        let words = program.words_of(block);
        let Some((first, rest)) = words.split_first() else { continue };
        if program.is_keyword(first, &["DEF"]) {
            found.define(program, rest);
        } else if program.is_keyword(first, &["REDEF"]) {
            found.redefine(program, rest);
        } else if let Some((name, text)) = names_text(program, words) {
            Arc::make_mut(&mut found.definitions.macros).insert(name, text);
        } else {
            continue;
        }
        let end = words.last().map_or(first.span.end, |word| word.span.end);
        let line = program.written(Span { start: first.span.start, end });
        // a file may be filled up with zeros, and blanks before them; in the middle of one they would be none
        found.definitions.lines.push(line.trim_end_matches(['\0', ' ', '\t', '\r']).to_owned());
    }
    found
}

/// The name and the text of `DEFINE NAME AS …`.
fn names_text(program: &Program, words: &[Word]) -> Option<(String, Vec<u8>)> {
    let [define, name, _, text] = words else { return None };
    let WordKind::Constant(text) = text.kind else { return None };
    match program.expr(text)? {
        Expr::Text(text) if program.is_call(define, &["DEFINE"]) => {
            Some((program.name(name.called()?), program.text(*text).to_owned()))
        }
        _ => None,
    }
}

/// What the words before the names of a declaration say.
#[derive(Default)]
struct Said {
    channel: bool,
    kind: Option<Type>,
    attributes: Vec<(String, Option<f64>)>,
}

impl Said {
    fn take(&mut self, program: &Program, name: Span, value: Option<ExprId>) {
        let number = value.and_then(|value| fold::number(program, value, NOTHING));
        let name = program.name(name);
        match (Type::named(&name, number), name.as_str()) {
            (Some(kind), _) => self.kind = Some(kind),
            (None, "CHAN") => self.channel = true,
            (None, "NCK") => self.channel = false,
            _ => self.attributes.push((name, number)),
        }
    }
}

impl Defined {
    /// `DEF …`: the words behind it.
    fn define(&mut self, program: &Program, words: &[Word]) {
        let mut said = Said::default();
        for word in words {
            let made = match &word.kind {
                WordKind::Keyword { name, value } => {
                    said.take(program, *name, *value);
                    continue;
                }
                WordKind::Declare { name, index, value } => datum(program, &said, *name, (index, *value)),
                _ => continue,
            };
            match made {
                Ok((name, datum)) => {
                    self.beyond.extend(beyond(&name, &datum, word));
                    self.add(name, datum, word);
                }
                Err(problem) => self.problems.push(problem),
            }
        }
    }

    /// Adds a datum; one of the measuring cycles is on every control, with the values of the machine: of that its size.
    fn add(&mut self, name: String, datum: Definition, word: &Word) {
        if let Some(gud) = gud::find(&name) {
            let Definition { sizes, first, .. } = datum;
            if !sizes.is_empty() && sizes.len() == gud.sizes.len() {
                self.definitions.sizes.insert(name.clone(), sizes.clone());
            }
            let place = word.declared().unwrap_or(word.span);
            self.measuring.push(Measuring { name, place, sizes, first });
            return;
        }
        match self.definitions.data.entry(name) {
            Entry::Vacant(free) => drop(free.insert(datum)),
            Entry::Occupied(there) => {
                let place = word.declared().unwrap_or(word.span);
                self.problems.push(Problem::new("run-declared-twice", place, there.key()));
            }
        }
    }

    /// `REDEF …`: attributes, and the names that get them. A name of the control keeps what it is.
    fn redefine(&mut self, program: &Program, words: &[Word]) {
        let mut said = Said::default();
        let mut names = Vec::new();
        for word in words {
            match &word.kind {
                WordKind::Keyword { name, value } => said.take(program, *name, *value),
                WordKind::Declare { name, .. } => names.push(program.name(*name)),
                _ => {}
            }
        }
        for name in names {
            if let Some(datum) = self.definitions.data.get_mut(&name) {
                let new = |known: &str| said.attributes.iter().any(|(name, _)| name == known);
                datum.attributes.retain(|(known, _)| !new(known));
                datum.attributes.extend(said.attributes.iter().cloned());
            }
        }
    }
}

/// That a list, or the count of a `REP`, goes beyond the last element.
fn beyond(name: &str, datum: &Definition, word: &Word) -> Option<Beyond> {
    let (elements, values) = (datum.elements(), datum.first.counted()?);
    let place = word.declared().unwrap_or(word.span);
    (values > elements).then(|| Beyond { name: name.to_owned(), place, counts: [elements, values] })
}

/// The datum that a name of a declaration is.
fn datum(
    program: &Program,
    said: &Said,
    place: Span,
    (sizes, value): (&[ExprId], Option<ExprId>),
) -> Result<(String, Definition), Problem> {
    let name = program.name(place);
    if AXES.contains(&name.as_str()) {
        return Err(Problem::new("run-axis-name", place, name));
    }
    let kind = said.kind.ok_or_else(|| Problem::new("run-type", place, &*name))?;
    let wrong = || Problem::new("run-array-size", place, &*name).number("limit", ELEMENTS as f64);
    let mut counts = Vec::new();
    for size in sizes {
        let size = fold::number(program, *size, NOTHING).filter(|size| (1.0..=ELEMENTS as f64).contains(size));
        counts.push(size.ok_or_else(wrong)? as usize);
    }
    if counts.iter().try_fold(1_usize, |all, one| all.checked_mul(*one)).is_none_or(|all| all > ELEMENTS) {
        return Err(wrong());
    }
    let first = match value {
        Some(value) => first(program, kind, value).ok_or_else(|| Problem::new("run-type", place, &*name))?,
        None => First::Each(Vec::new()),
    };
    let attributes = said.attributes.clone();
    Ok((name, Definition { channel: said.channel, kind, sizes: counts, first, attributes }))
}

/// First values: one, `(1,2)`, `SET(1,,2)`, `REP(1)` or `REP(1,5)`.
fn first(program: &Program, kind: Type, value: ExprId) -> Option<First> {
    let each = |list: &[ExprId]| {
        let given = |id: &ExprId| match program.given(*id) {
            Some(id) => single(program, kind, id).map(Some),
            None => Some(None),
        };
        list.iter().map(given).collect::<Option<Vec<_>>>().map(First::Each)
    };
    match program.expr(value)? {
        Expr::List(list) => each(list),
        Expr::Call(name, list) if program.is(*name, "SET") => each(list),
        Expr::Call(name, list) if program.is(*name, "REP") => {
            let (value, count) = list.split_first()?;
            let count = match count {
                [] => ELEMENTS as f64,
                [count] => fold::number(program, *count, NOTHING).filter(|count| *count >= 1.0)?,
                _ => return None,
            };
            Some(First::Same(single(program, kind, *value)?, count as usize))
        }
        _ => Some(First::Each(vec![Some(single(program, kind, value)?)])),
    }
}

/// One value, as data hold it.
fn single(program: &Program, kind: Type, id: ExprId) -> Option<Value> {
    match (kind, program.expr(id)?) {
        (Type::Text(length), Expr::Text(place)) => {
            let text = program.written(*place);
            (text.chars().count() <= length).then_some(Value::Text(text))
        }
        (Type::Char, Expr::Text(place)) => match program.text(*place) {
            [code] => Some(Value::Number(f64::from(*code))),
            _ => None,
        },
        (Type::Axis, Expr::Name { name, index }) if index.is_empty() => Some(Value::Text(program.name(*name))),
        (Type::Text(_) | Type::Axis | Type::Frame, _) => None,
        (_, Expr::Name { name, .. }) if program.is(*name, "TRUE") => Some(Value::Number(1.0)),
        (_, Expr::Name { name, .. }) if program.is(*name, "FALSE") => Some(Value::Number(0.0)),
        (Type::Int, _) => fold::number(program, id, NOTHING).map(|number| Value::Number(number.round())),
        _ => fold::number(program, id, NOTHING).map(Value::Number),
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    fn keys(text: &str) -> Vec<String> {
        definitions(text.as_bytes()).problems.iter().map(|problem| problem.message.key.to_string()).collect()
    }

    // oracle: hand (the forms of a definition file, B:13269-13288: scope, type, sizes, list; attributes with a number)
    #[test]
    fn a_definition_file_adds_data() {
        let text = "%_N_GUD4_DEF\r\n;$PATH=/_N_DEF_DIR\r\nN10 DEF NCK REAL A_LIMIT[2,3]=SET(1,,-2.5)\r\n\
            N20 DEF CHAN SYNRW INT PHU 24 LLI -10 ULI 'H7F' APR 7 APW 2 B_COUNT=5, B_OTHER\r\n\
            DEF NCK STRING[8] NAMES[3]=REP(\"AB\")\r\nDEF CHAN AXIS TURNS=X\r\nDEF CHAN BOOL SWITCH=TRUE\r\n\
            REDEF B_COUNT APR 4 PHU 1\r\nM17\r\n";
        let found = definitions(text.as_bytes());
        assert_eq!(found.problems, []);
        let limit = found.definitions.find("A_LIMIT").unwrap();
        assert_eq!((limit.channel, limit.kind, &limit.sizes[..]), (false, Type::Real, &[2, 3][..]));
        let begins = [0, 1, 2, 3].map(|element| limit.begins(element).cloned());
        assert_eq!(begins, [Some(Value::Number(1.0)), None, Some(Value::Number(-2.5)), None]);
        let count = found.definitions.find("B_COUNT").unwrap();
        assert_eq!((count.channel, count.begins(0)), (true, Some(&Value::Number(5.0))));
        let attributes: Vec<_> = count.attributes.iter().map(|(name, number)| (&**name, *number)).collect();
        let wanted =
            [("SYNRW", None), ("LLI", Some(-10.0)), ("ULI", Some(127.0)), ("APW", Some(2.0)), ("APR", Some(4.0))];
        assert_eq!(attributes, [&wanted[..], &[("PHU", Some(1.0))]].concat());
        assert_eq!(found.definitions.find("B_OTHER").unwrap().begins(0), None);
        let names = found.definitions.find("NAMES").unwrap();
        assert_eq!((names.kind, names.begins(2)), (Type::Text(8), Some(&Value::Text("AB".into()))));
        assert_eq!(found.definitions.lines.len(), 6);
        let again = definitions(found.definitions.lines.join("\n").as_bytes());
        assert_eq!(again.definitions, found.definitions);
    }

    // oracle: hand
    #[test]
    fn what_cannot_be_defined_is_told_and_left_out() {
        for (line, key) in [
            ("DEF NCK NO_TYPE", "run-type"),
            ("DEF NCK REAL X", "run-axis-name"),
            ("DEF NCK REAL BIG[1000,1000]", "run-array-size"),
            ("DEF NCK REAL NONE[0]", "run-array-size"),
            ("DEF NCK REAL SIZE[R1]", "run-array-size"),
            ("DEF NCK REAL A\nDEF NCK REAL A", "run-declared-twice"),
            ("DEF NCK STRING[2] A=\"ABC\"", "run-type"),
            ("DEF NCK INT A=\"ABC\"", "run-type"),
        ] {
            assert_eq!(keys(line), [key], "{line}");
        }
        assert_eq!(keys("%_N_A_MPF\nDEF REAL NO_TYPE\nM30"), [""; 0]);
    }

    // oracle: hand: a list of one value more than elements, a count beyond them, several in a line; what fits is not
    // told
    #[test]
    fn values_without_an_element_are_told() {
        for (text, wanted) in [
            ("DEF NCK REAL A[3]=SET(1,2,3)", vec![]),
            ("DEF NCK REAL A[3]=REP(1)", vec![]),
            ("DEF NCK REAL A[2,2]=(1,2,3,4,5)", vec![("A", [4, 5])]),
            ("DEF NCK INT A=(1,2)", vec![("A", [1, 2])]),
            ("DEF NCK REAL A[2]=REP(7,3), B[2]=(1,2,,)", vec![("A", [2, 3]), ("B", [2, 4])]),
            ("DEF NCK INT _CVAL[4]=(2,2,0,0,9)", vec![("_CVAL", [4, 5])]),
        ] {
            let found = definitions(text.as_bytes());
            let told: Vec<_> = found.beyond.iter().map(|one| (one.name.as_str(), one.counts)).collect();
            assert_eq!(told, wanted, "{text}");
            assert_eq!(found.findings().count(), wanted.len(), "{text}");
        }
    }
}
