//! Right sides as text for a form: numbers and texts as written, constants worked out, else the expression itself.

use crate::check::{Parsed, Sort, expression::shown, parse, typed_text};
use crate::diagnostic::Span;
use crate::syntax::fold::Known;
use crate::syntax::{Expr, ExprId, Operator, Program, fold};

/// A value as text, and its place; inside the quotes for a text.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Value {
    pub text: String,
    pub place: Span,
    /// What it is worth, where that is known.
    pub number: Option<f64>,
    /// Whether it is written as a text.
    pub quoted: bool,
    /// As it is written, where `text` is what that is worth.
    pub expression: Option<String>,
    /// A variable in it that nothing gave a value.
    pub missing: Option<String>,
    /// Whether others take their value from the same place (`REP`).
    pub shared: bool,
    /// Where the value is written, when `place` only names the variable of another program that holds it.
    pub given: Option<Span>,
    /// It is written as the argument of a call.
    pub argument: bool,
    /// The assignment of the caller that this value of a called program took the place of, and that call.
    pub instead: Option<(Span, Span)>,
}

impl Value {
    /// A value of its own.
    pub fn at(text: String, number: Option<f64>, place: Span) -> Value {
        Value { text, place, number, ..Value::default() }
    }

    /// What sort of value it is.
    pub fn sort(&self) -> Sort {
        match (self.quoted, self.number) {
            (true, _) => Sort::Text,
            (_, Some(_)) => Sort::Number,
            _ => Sort::Open,
        }
    }

    /// Where it is written.
    pub fn source(&self) -> Span {
        self.given.unwrap_or(self.place)
    }

    /// Where somebody looks for it who finds it wrong.
    pub fn written_at(&self) -> Span {
        if self.argument { self.source() } else { self.place }
    }

    /// The value with the other sign.
    pub fn opposite(self) -> Value {
        Value {
            text: opposite(&self.text),
            number: self.number.map(|number| -number),
            expression: self.expression.as_deref().map(opposite),
            ..self
        }
    }
}

/// A value as text with the other sign: `30` and `-30`, `R1` and `-(R1)`.
pub fn opposite(text: &str) -> String {
    let inner = text.strip_prefix("-(").and_then(|rest| rest.strip_suffix(')')).filter(|inner| closes_itself(inner));
    match parse(text) {
        Parsed::Empty => String::new(),
        Parsed::Number(0.0) => text.to_owned(),
        Parsed::Number(_) => match text.trim().strip_prefix('-') {
            Some(rest) => rest.to_owned(),
            None => format!("-{}", text.trim().trim_start_matches('+')),
        },
        _ => inner.map_or_else(|| format!("-({text})"), str::to_owned),
    }
}

/// Whether no bracket of a text closes one that stands before it.
fn closes_itself(text: &str) -> bool {
    let mut depth = 0_i64;
    let bracket = |byte| match byte {
        b'(' => 1,
        b')' => -1,
        _ => 0,
    };
    text.bytes().all(|byte| {
        depth += bracket(byte);
        depth >= 0
    })
}

/// The value of an expression.
pub(super) fn value(program: &Program, id: ExprId, known: Known) -> Value {
    let place = program.place(id);
    let number = fold::number(program, id, known);
    let written = || program.written(place).trim().to_owned();
    match (program.expr(id), number) {
        (Some(Expr::Text(inside)), _) => {
            Value { quoted: true, ..Value::at(typed_text(&program.written(*inside)), number, program.placed(*inside)) }
        }
        (Some(expr), Some(_)) if literal(program, expr) => Value::at(written().replace(' ', ""), number, place),
        (Some(_), Some(worth)) => Value { expression: Some(written()), ..Value::at(shown(worth), number, place) },
        // what a macro says is a name as if it stood there
        (Some(Expr::Name { name, index }), _) if index.is_empty() && program.placed(*name) != *name => {
            Value::at(program.written(*name), number, place)
        }
        _ => Value::at(written(), number, place),
    }
}

/// A decimal number with at most a sign.
pub(super) fn literal(program: &Program, expr: &Expr) -> bool {
    let decimal = |span: &Span| program.text(*span).iter().all(|byte| byte.is_ascii_digit() || b".+-".contains(byte));
    match expr {
        Expr::Number(_, span) => decimal(span),
        Expr::Unary(Operator::Minus | Operator::Plus, inner) => {
            matches!(program.expr(*inner), Some(Expr::Number(_, span)) if decimal(span))
        }
        _ => false,
    }
}

/// How a right side fills an array.
pub(super) enum Spread<'a> {
    /// It does not: one value.
    One,
    /// `SET(…)` or a list: an element each.
    Each(&'a [ExprId]),
    /// `REP(…)`: all elements.
    Same(ExprId),
}

pub(super) fn spread(program: &Program, value: ExprId) -> Spread<'_> {
    match program.expr(value) {
        Some(Expr::Call(name, values)) if program.is(*name, "SET") => Spread::Each(values),
        Some(Expr::List(values)) => Spread::Each(values),
        Some(Expr::Call(name, values)) if program.is(*name, "REP") && values.len() == 1 => {
            values.first().map_or(Spread::One, |id| Spread::Same(*id))
        }
        _ => Spread::One,
    }
}
