//! Names and constant values as far as they can be known without running the program.

use super::arithmetic;
use super::tree::{Expr, ExprId, Operator, Program, WordKind};
use crate::diagnostic::Span;
use std::collections::{BTreeSet, HashMap};

/// Numbers that variables hold, by name in upper case with index: `_SETVAL`, `R10`, `_SETV[0]`, `#100`.
pub type Known<'a> = &'a dyn Fn(&str) -> Option<f64>;

/// No variable is known: what does not depend on the place in the program.
pub(crate) const NOTHING: Known = &|_| None;

/// A variable's name with its index in digits: `_SETV[R1]` is `_SETV[2]` while R1 is 2. None: the index is not known.
pub(crate) fn name(program: &Program, name: Span, index: &[ExprId], known: Known) -> Option<String> {
    let text = program.name(name);
    if index.is_empty() {
        return Some(text);
    }
    if text == "#" {
        return Some(format!("#{}", whole(program, *index.first()?, known)?));
    }
    let written = |id: &ExprId| match (whole(program, *id, known), program.expr(*id)) {
        (Some(number), _) => Some(number.to_string()),
        (None, Some(Expr::Name { name, index })) if index.is_empty() => Some(program.name(*name)),
        _ => None,
    };
    let index: Vec<String> = index.iter().map(written).collect::<Option<_>>()?;
    Some(format!("{text}[{}]", index.join(",")))
}

fn whole(program: &Program, id: ExprId, known: Known) -> Option<i64> {
    let value = number(program, id, known)?;
    (value.fract() == 0.0 && value.abs() < 1e9).then_some(value as i64)
}

/// Value of an expression made of numbers, known variables, arithmetic and its functions.
pub(crate) fn number(program: &Program, id: ExprId, known: Known) -> Option<f64> {
    let value = match program.expr(id)? {
        Expr::Number(value, _) => *value,
        Expr::Name { name: place, index } => known(&name(program, *place, index, known)?)?,
        Expr::Unary(Operator::Minus, inner) => -number(program, *inner, known)?,
        Expr::Unary(Operator::Plus, inner) => number(program, *inner, known)?,
        Expr::Binary(left, operator, right) => {
            arithmetic::operate(*operator, number(program, *left, known)?, number(program, *right, known)?)?
        }
        Expr::Call(name, values) => {
            let values: Vec<f64> = values.iter().map(|id| number(program, *id, known)).collect::<Option<_>>()?;
            arithmetic::function(&program.name(*name), &values)?
        }
        _ => return None,
    };
    value.is_finite().then_some(value)
}

/// The names in an expression, without functions, in upper case.
pub(crate) fn names_in(program: &Program, id: ExprId, found: &mut BTreeSet<String>) {
    match program.expr(id) {
        Some(Expr::Name { name, index }) => {
            found.insert(program.name(*name));
            index.iter().for_each(|id| names_in(program, *id, found));
        }
        Some(Expr::Unary(_, inner)) => names_in(program, *inner, found),
        Some(Expr::Binary(left, _, right)) => [left, right].iter().for_each(|id| names_in(program, **id, found)),
        Some(Expr::Call(_, list) | Expr::List(list)) => list.iter().for_each(|id| names_in(program, *id, found)),
        _ => {}
    }
}

/// How often each variable is assigned, if the program can run a line twice; else nothing.
pub(crate) fn unsteady(program: &Program) -> HashMap<String, u32> {
    const BACK: [&str; 7] = ["FOR", "WHILE", "DO", "REPEAT", "LOOP", "GOTOB", "GOTO"];
    let mut counts = HashMap::new();
    if program.words.iter().any(|word| program.is_keyword(word, &BACK)) {
        for word in &program.words {
            if let WordKind::Assign { name: place, index, .. } = &word.kind
                && let Some(name) = name(program, *place, index, NOTHING)
            {
                *counts.entry(name).or_default() += 1;
            }
        }
    }
    counts.retain(|_, count| *count > 1);
    counts
}
