//! The variables of a value that is written as an expression: what else reads them, and which assignment would give the
//! value another worth.

use super::calls::CallSite;
use super::change::Edit;
use super::compared::ComparedValue;
use super::flow::{Follow, Meet, follow};
use super::held::stem;
use super::touched::{TouchedLine, touched};
use super::values::{Spread, literal, spread};
use crate::check::{Parsed, expression::shown, parse};
use crate::diagnostic::Span;
use crate::entry::Arg;
use crate::message::Message;
use crate::name::numbered;
use crate::syntax::fold::{self, NOTHING, number};
use crate::syntax::programs::programs;
use crate::syntax::{Expr, ExprId, Operator, Program, Word, WordKind};
use std::collections::{BTreeMap, BTreeSet};

/// A variable of an expression.
#[derive(Clone, Debug, PartialEq)]
pub struct Variable {
    /// Its name, in upper case.
    pub name: String,
    /// Lines, from 1, that read what it holds at the call.
    pub uses: Vec<u32>,
    /// Lines, from 1, that may have given it its value.
    pub assigned: Vec<u32>,
    /// The assignment as it would be, or why it cannot be changed.
    pub change: Result<Change, Message>,
}

/// An assignment that would be another.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// The number that it would assign.
    pub value: String,
    /// The only edit.
    pub edit: Edit,
    /// Its line.
    pub line: TouchedLine,
    /// What the calls of the program would say otherwise.
    pub values: Vec<ComparedValue>,
}

/// The variables of the expression that is a value of a call, each with what would make that value this one, as typed.
pub fn variables(program: &Program, site: &CallSite, name: &str, typed: &str) -> Vec<Variable> {
    let Some(place) = site.places.get(name) else { return Vec::new() };
    let Some((word, id)) = program.word_at(*place).and_then(|word| Some((word, at(program, word, *place)?))) else {
        return Vec::new();
    };
    let wanted = match parse(typed) {
        Parsed::Number(number) if is_down(site, name, *place) => Some(-number),
        Parsed::Number(number) => Some(number),
        _ => None,
    };
    let mut names = BTreeSet::new();
    places_in(program, id, &mut names);
    let found = names.into_iter().filter(|name| !name.ends_with('#'));
    found.map(|name| variable(program, word, id, name, wanted)).collect()
}

/// The variables in an expression, an element of an array by its index where that is a number.
fn places_in(program: &Program, id: ExprId, found: &mut BTreeSet<String>) {
    match program.expr(id) {
        Some(Expr::Name { name, index }) => {
            let place = fold::name(program, *name, index, NOTHING).map(|place| plain_name(&place));
            found.insert(place.filter(|place| has_numbers(place)).unwrap_or_else(|| program.name(*name)));
            index.iter().for_each(|id| places_in(program, *id, found));
        }
        Some(Expr::Unary(_, inner)) => places_in(program, *inner, found),
        Some(Expr::Binary(left, _, right)) => [left, right].iter().for_each(|id| places_in(program, **id, found)),
        Some(Expr::Call(_, list) | Expr::List(list)) => list.iter().for_each(|id| places_in(program, *id, found)),
        _ => {}
    }
}

/// Where the assignments begin that may have given a variable its value where a word reads it: the first byte of each
/// right side. What was before the program is none.
pub fn assigned(program: &Program, word: &Word, name: &str) -> Vec<u32> {
    let given = Reads::of(program, name).found.remove(&word.span.start).unwrap_or_default();
    given.into_iter().filter_map(|one| if let Given::At(at) = one { Some(at) } else { None }).collect()
}

/// Whether the list of the call has the value with the other sign.
fn is_down(site: &CallSite, name: &str, place: Span) -> bool {
    let down = |arg: &Arg| matches!(arg, Arg::Down(param) if *param == name);
    let within = place.start >= site.span.start && place.end <= site.span.end;
    within && site.list.is_some_and(|list| list.args.iter().any(down))
}

/// The expression of a word that stands at a place.
fn at(program: &Program, word: &Word, place: Span) -> Option<ExprId> {
    let mut all: Vec<ExprId> = match &word.kind {
        WordKind::Assign { value, .. } | WordKind::Address { value, .. } => vec![*value],
        WordKind::Call { args, .. } => args.to_vec(),
        _ => Vec::new(),
    };
    let elements = all.iter().flat_map(|id| match spread(program, *id) {
        Spread::Each(values) => values.to_vec(),
        Spread::Same(value) => vec![value],
        Spread::One => Vec::new(),
    });
    let elements: Vec<ExprId> = elements.collect();
    all.extend(elements);
    all.into_iter().find(|id| program.place(*id) == place)
}

fn variable(program: &Program, word: &Word, id: ExprId, name: String, wanted: Option<f64>) -> Variable {
    let reads = Reads::of(program, &name);
    let given = reads.found.get(&word.span.start).cloned().unwrap_or_default();
    let line = |at: u32| program.line_of(at) + 1;
    let same = reads.found.iter().filter(|(_, all)| all.iter().any(|one| given.contains(one)));
    let mut uses: Vec<u32> = same.map(|(at, _)| line(*at)).collect();
    uses.dedup();
    let places = given.iter().filter_map(|one| if let Given::At(at) = one { Some(*at) } else { None });
    let mut assigned: Vec<u32> = places.map(line).collect();
    assigned.dedup();
    let change = change(program, id, &name, wanted, &given);
    Variable { name, uses, assigned, change }
}

/// The assignment that would have to be another one.
fn change(
    program: &Program,
    id: ExprId,
    name: &str,
    wanted: Option<f64>,
    given: &BTreeSet<Given>,
) -> Result<Change, Message> {
    let why = |key: &'static str| Message::new(key).text("name", name);
    let lines = || {
        let places = given.iter().filter_map(|one| if let Given::At(at) = one { Some(*at) } else { None });
        let all: BTreeSet<u32> = places.map(|at| program.line_of(at) + 1).collect();
        all.iter().map(u32::to_string).collect::<Vec<_>>().join(", ")
    };
    let at = match given.iter().collect::<Vec<_>>()[..] {
        [Given::At(at)] => *at,
        [Given::Before] | [] => return Err(why("variable-before")),
        ref all if all.contains(&&Given::Unclear) => return Err(why("variable-unclear")),
        _ => return Err(why("variable-several").text("lines", lines())),
    };
    let right = assignment(program, at);
    let plain = right.filter(|right| program.expr(*right).is_some_and(|expr| literal(program, expr)));
    let Some(right) = plain else { return Err(why("variable-calculated").text("lines", lines())) };
    let Some(wanted) = wanted else { return Err(why("variable-number")) };
    let value = solved(program, id, name, wanted).ok_or_else(|| why("variable-unsolved"))?;
    let edit = Edit::replace(program.place(right), value.clone());
    let line = touched(program, std::slice::from_ref(&edit)).into_iter().next();
    let line = line.ok_or_else(|| why("variable-same"))?;
    Ok(Change { value, edit, line, values: Vec::new() })
}

/// The right side that begins here.
fn assignment(program: &Program, at: u32) -> Option<ExprId> {
    let behind = program.words.partition_point(|word| word.span.start <= at);
    match program.words.get(behind.checked_sub(1)?)?.kind {
        WordKind::Assign { value, .. } | WordKind::Declare { value: Some(value), .. } => Some(value),
        _ => None,
    }
}

/// The number, as a program writes it, for which the expression is worth the wanted one.
fn solved(program: &Program, id: ExprId, name: &str, wanted: f64) -> Option<String> {
    let exact = solve(program, id, name, wanted)?;
    let text = shown(exact + 0.0);
    let rounded = text.parse().ok()?;
    let worth = number(program, id, &|other| (plain_name(other) == name).then_some(rounded))?;
    ((worth - wanted).abs() <= 1e-9 * wanted.abs().max(1.0)).then_some(text)
}

fn solve(program: &Program, id: ExprId, name: &str, wanted: f64) -> Option<f64> {
    let constant = |id: ExprId| number(program, id, NOTHING);
    let found = match program.expr(id)? {
        Expr::Name { name: place, index } => {
            (plain_name(&fold::name(program, *place, index, NOTHING)?) == name).then_some(wanted)
        }
        Expr::Unary(Operator::Minus, inner) => solve(program, *inner, name, -wanted),
        Expr::Unary(Operator::Plus, inner) => solve(program, *inner, name, wanted),
        Expr::Binary(left, operator, right) => match (constant(*left), operator, constant(*right)) {
            (_, Operator::Plus, Some(number)) => solve(program, *left, name, wanted - number),
            (Some(number), Operator::Plus, _) => solve(program, *right, name, wanted - number),
            (_, Operator::Minus, Some(number)) => solve(program, *left, name, wanted + number),
            (Some(number), Operator::Minus, _) => solve(program, *right, name, number - wanted),
            (_, Operator::Times, Some(number)) => solve(program, *left, name, wanted / number),
            (Some(number), Operator::Times, _) => solve(program, *right, name, wanted / number),
            (_, Operator::Over, Some(number)) => solve(program, *left, name, wanted * number),
            (Some(number), Operator::Over, _) => solve(program, *right, name, number / wanted),
            _ => None,
        },
        _ => None,
    }?;
    found.is_finite().then_some(found)
}

/// What may have given a variable its value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Given {
    /// What was before the program.
    Before,
    /// The right side that begins here.
    At(u32),
    /// Something that only the run knows.
    Unclear,
}

/// What may have given a variable its value, at a place of the program.
#[derive(Clone, Debug, PartialEq)]
struct Holds(BTreeSet<Given>);

impl Default for Holds {
    fn default() -> Holds {
        Holds(BTreeSet::from([Given::Before]))
    }
}

impl Meet for Holds {
    fn meet(&self, other: &Holds) -> Holds {
        Holds(self.0.union(&other.0).copied().collect())
    }
}

/// The words that read a variable, by their first byte, with what gave it its value there.
struct Reads<'a> {
    program: &'a Program,
    name: &'a str,
    /// A program of the text declares it, and another one knows nothing of that.
    local: bool,
    found: BTreeMap<u32, BTreeSet<Given>>,
}

impl<'a> Reads<'a> {
    fn of(program: &'a Program, name: &'a str) -> Reads<'a> {
        let declares = |word: &Word| word.declared().is_some_and(|place| program.is(place, stem(name)));
        let local = program.words.iter().any(declares);
        let mut reads = Reads { program, name, local, found: BTreeMap::new() };
        if program.grammar().by_address {
            let mut state = Holds::default();
            for block in &program.blocks {
                reads.block(&mut state, program.words_of(block));
            }
        } else {
            follow(program, &programs(program), &mut reads);
        }
        reads
    }

    fn word(&mut self, state: &mut Holds, word: &Word, counts: bool) {
        let (mut names, mut by_reference) = (BTreeSet::new(), false);
        let mut read = |id: &ExprId| places_in(self.program, *id, &mut names);
        match &word.kind {
            WordKind::Assign { index, value, .. } => index.iter().chain([value]).for_each(&mut read),
            WordKind::Declare { index, value, .. } => index.iter().chain(value).for_each(&mut read),
            WordKind::Address { value, .. } | WordKind::Keyword { value: Some(value), .. } => read(value),
            WordKind::Call { args, .. } => {
                args.iter().for_each(&mut read);
                by_reference = args.iter().any(|id| self.is_own(*id));
            }
            _ => {}
        }
        if names.iter().any(|name| name == stem(self.name) || name == self.name) {
            self.found.entry(word.span.start).or_default().extend(&state.0);
        }
        match &word.kind {
            WordKind::Assign { name, index, value } => self.assign(state, (*name, index), *value, counts),
            WordKind::Declare { name, index, value: Some(value) } if index.is_empty() => {
                self.assign(state, (*name, &[]), *value, false);
            }
            WordKind::Call { name, .. } if by_reference && !self.keeps(*name) => drop(state.0.insert(Given::Unclear)),
            _ => {}
        }
    }

    /// Whether a called name leaves its arguments as they are: the cycles of the control do.
    fn keeps(&self, name: Span) -> bool {
        self.program.text(name).get(..5).is_some_and(|start| start.eq_ignore_ascii_case(b"CYCLE"))
    }

    /// Whether an expression is the variable, and nothing more.
    fn is_own(&self, id: ExprId) -> bool {
        let Some(Expr::Name { name, index }) = self.program.expr(id) else { return false };
        fold::name(self.program, *name, index, NOTHING).is_some_and(|name| plain_name(&name) == self.name)
    }

    fn assign(&self, state: &mut Holds, (name, index): (Span, &[ExprId]), value: ExprId, counts: bool) {
        let array = self.program.name(name);
        let written = fold::name(self.program, name, index, NOTHING).map(|name| plain_name(&name));
        let own = written.as_deref() == Some(self.name);
        let one = matches!(spread(self.program, value), Spread::One) && !counts;
        let certain = one && written.as_deref().is_some_and(has_numbers);
        if own && one {
            state.0 = BTreeSet::from([Given::At(self.program.place(value).start)]);
        } else if own || !certain && is_of(&array, self.name) {
            state.0.insert(Given::Unclear);
        }
    }
}

/// Whether a name has numbers as indices, or none.
fn has_numbers(name: &str) -> bool {
    let index = name.split_once('[').map_or("", |(_, index)| index);
    index.bytes().all(|byte| byte.is_ascii_digit() || b",]".contains(&byte))
}

/// The name of an R parameter without brackets: `R[2]` is `R2`.
pub(super) fn plain_name(name: &str) -> String {
    let inside = name.strip_prefix("R[").and_then(|rest| rest.strip_suffix(']'));
    let inside = inside.filter(|inside| inside.bytes().all(|byte| byte.is_ascii_digit()));
    numbered(inside.map_or_else(|| name.to_owned(), |number| format!("R{number}")))
}

/// Whether a variable may be an element of what has this name.
fn is_of(array: &str, name: &str) -> bool {
    let parameter = |letter: char| {
        let rest = name.strip_prefix(letter).unwrap_or_default();
        array.len() == 1 && array.starts_with(letter) && rest.starts_with(|c: char| c.is_ascii_digit())
    };
    stem(name) == array || parameter('R') || parameter('#')
}

impl Follow for Reads<'_> {
    type State = Holds;

    fn block(&mut self, state: &mut Holds, words: &[Word]) {
        let counts = words.iter().any(|word| self.program.is_keyword(word, &["FOR"]));
        for word in words {
            self.word(state, word, counts);
        }
    }

    fn enter(&mut self, state: &Holds, _: &super::flow::Entry) -> Holds {
        if self.local { Holds::default() } else { state.clone() }
    }

    fn leave(&mut self, state: &Holds, way: (&Holds, &Holds), _: &super::flow::Entry, _: bool) -> Holds {
        if self.local { state.clone() } else { way.1.clone() }
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::dialect::Dialect;
    use crate::program::calls::calls;
    use crate::program::change::apply;
    use crate::syntax::read;

    fn of(dialect: Dialect, text: &str, name: &str, typed: &str) -> Vec<Variable> {
        let program = read(dialect, text.as_bytes());
        let site = calls(&program).pop().unwrap();
        variables(&program, &site, name, typed)
    }

    /// The program with the only variable of the last call's setpoint changed, or the key of why not.
    fn changed(text: &str, typed: &str) -> String {
        let all = of(Dialect::Sinumerik, text, "_SETVAL", typed);
        match &all[..] {
            [Variable { change: Ok(change), .. }] => {
                String::from_utf8(apply(text.as_bytes(), std::slice::from_ref(&change.edit))).unwrap()
            }
            [Variable { change: Err(why), .. }] => why.key.to_string(),
            _ => format!("{all:?}"),
        }
    }

    const CALL: &str = "_MVAR=1 _SETVAL=R2 _PRNUM=1 _FA=2 _TSA=2\nCYCLE977\n";

    // oracle: hand
    #[test]
    fn the_assignment_is_changed_that_counts_at_the_call() {
        let text = format!("R2=7\nG0 X=R2\nR2=50.02 ; bore\n{CALL}G1 X=R2+1\nR2=3\nX=R2\n");
        assert_eq!(changed(&text, "51,5"), text.replace("50.02", "51.5"));
        let all = of(Dialect::Sinumerik, &text, "_SETVAL", "51.5");
        assert_eq!((&*all[0].name, &all[0].uses[..], &all[0].assigned[..]), ("R2", &[4, 6][..], &[3][..]));
        let line = &all[0].change.as_ref().unwrap().line;
        assert_eq!((line.line, &*line.before, &*line.after), (3, "R2=50.02 ; bore", "R2=51.5 ; bore"));
    }

    // oracle: hand (2 R2 + 1 = 61 where R2 is 30)
    #[test]
    fn an_expression_is_solved_for_its_variable() {
        for (expression, number) in
            [("2*R2", "30"), ("R2*2", "30"), ("-R2", "-60"), ("60-R2", "0"), ("R2/0.5", "30"), ("120/R2", "2")]
        {
            let text = format!("R2=1\n{}", CALL.replace("R2", expression));
            assert_eq!(changed(&text, "60"), text.replace("R2=1\n", &format!("R2={number}\n")), "{expression}");
        }
    }

    // oracle: hand: an element of an array is a variable of its own, and `R[2]` is R2
    #[test]
    fn an_element_is_changed_where_it_is_assigned() {
        let before = "DEF REAL ARR[3]\nARR[1]=50.02\nARR[2]=7\nR2=8\nR[3]=9\n";
        for (written, old, new) in
            [("ARR[1]", "50.02", "61"), ("2*ARR[2]+1", "]=7", "]=30"), ("R[2]", "R2=8", "R2=61"), ("R3", "=9", "=61")]
        {
            let text = format!("{before}{}", CALL.replace("R2", written));
            assert_eq!(changed(&text, "61"), text.replacen(old, new, 1), "{written}");
        }
        let open = format!("{before}ARR[R1]=4\n{}", CALL.replace("R2", "ARR[1]"));
        assert_eq!(changed(&open, "61"), "variable-unclear");
    }

    // oracle: hand
    #[test]
    fn what_is_no_single_plain_number_is_left_and_told() {
        for (before, typed, why) in [
            ("R1=5\nR2=R1+1\n", "60", "variable-calculated"),
            ("IF R9==1\nR2=5\nELSE\nR2=6\nENDIF\n", "60", "variable-several"),
            ("/R2=5\n", "60", "variable-several"),
            ("", "60", "variable-before"),
            ("R2=5\nREAD_IT(R2)\n", "60", "variable-unclear"),
            ("R2=5\nR[R1]=6\n", "60", "variable-unclear"),
            ("FOR R2=1 TO 3\n", "60", "variable-unclear"),
            ("R2=5\n", "", "variable-number"),
            ("R2=5\n", "5", "variable-same"),
        ] {
            assert_eq!(changed(&format!("{before}{CALL}"), typed), why, "{before}");
        }
        let unsolved = format!("R2=5\n{}", CALL.replace("=R2", "=R2*R2"));
        assert_eq!(changed(&unsolved, "60"), "variable-unsolved");
    }

    // oracle: hand
    #[test]
    fn a_variable_of_macros_is_changed_where_it_is_assigned() {
        let text = "#101=50\nG65 P9001\nX#101\n";
        let program = read(Dialect::Nct, text.as_bytes());
        assert_eq!(Reads::of(&program, "#101").found.len(), 1);
        let all = of(Dialect::Nct, "#101=40\nG101 X[#101+1.5]\n", "X", "50");
        assert_eq!(all[0].change.as_ref().unwrap().value, "48.5");
        assert_eq!(of(Dialect::Nct, "#101=40\nG101 X#[#101]\n", "X", "50").len(), 1);
    }
}
