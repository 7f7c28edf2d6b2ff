//! Works out expressions. Numbers are f64; comparisons give 0 or 1, as on the control.

use super::{Datum, Interpreter, function, macro_variables, names};
use crate::control::Frame;
use crate::diagnostic::Span;
use crate::problem::Problem;
use crate::syntax::arithmetic::operate;
use crate::syntax::tree::{Expr, ExprId, Operator};

/// Value of an expression.
pub fn evaluate(run: &Interpreter, id: ExprId) -> Result<Datum, Problem> {
    let Some(expr) = run.program.expr(id) else { return Err(Problem::new("run-unknown-word", Span::default(), "")) };
    match expr {
        Expr::Number(value, _) => Ok(Datum::Number(*value)),
        Expr::Text(span) => Ok(Datum::Text(run.program.written(*span))),
        Expr::Name { name, index } => names::read(run, &names::key(run, *name, index)?, *name),
        Expr::Unary(operator, operand) => {
            unary(*operator, evaluate(run, *operand)?).ok_or_else(|| wrong(run, *operand))
        }
        Expr::Binary(left, operator, right) => binary(run, *left, *operator, *right),
        Expr::Call(name, args) => function::call(run, *name, args),
        Expr::List(items) => list(run, items).map(Datum::List),
        Expr::Omitted => Err(Problem::new("run-not-a-number", run.program.place(id), "")),
    }
}

/// Value of an argument or index of what stands at `of`; an omitted one is told by that name.
pub fn element(run: &Interpreter, id: ExprId, of: Span) -> Result<Datum, Problem> {
    let omitted = || Problem::new("run-not-a-number", run.program.place(id), run.program.name(of));
    evaluate(run, run.program.given(id).ok_or_else(omitted)?)
}

/// Value of an expression that has to be a number.
pub fn number(run: &Interpreter, id: ExprId) -> Result<f64, Problem> {
    evaluate(run, id)?.number().ok_or_else(|| wrong(run, id))
}

/// Values of a list, omitted ones as none.
pub fn list(run: &Interpreter, items: &[ExprId]) -> Result<Vec<Option<Datum>>, Problem> {
    items.iter().map(|item| run.program.given(*item).map(|item| evaluate(run, item)).transpose()).collect()
}

/// A place that belongs to an expression.
pub fn span(run: &Interpreter, id: ExprId) -> Span {
    match run.program.expr(id) {
        Some(Expr::Number(_, span) | Expr::Text(span) | Expr::Call(span, _)) => *span,
        Some(Expr::Omitted) => run.program.place(id),
        Some(Expr::Name { name, .. }) => *name,
        Some(Expr::Unary(_, operand)) => span(run, *operand),
        Some(Expr::Binary(left, _, right)) => Span { start: span(run, *left).start, end: span(run, *right).end },
        Some(Expr::List(items)) => items.first().map_or(Span::default(), |item| span(run, *item)),
        None => Span::default(),
    }
}

fn wrong(run: &Interpreter, id: ExprId) -> Problem {
    let span = span(run, id);
    Problem::new("run-not-a-number", span, run.program.name(span))
}

fn unary(operator: Operator, value: Datum) -> Option<Datum> {
    if operator == Operator::Join {
        return Some(Datum::Text(value.shown()));
    }
    let number = value.number()?;
    Some(match operator {
        Operator::Plus => Datum::Number(number),
        Operator::Minus => Datum::Number(-number),
        Operator::Not => Datum::from(number == 0.0),
        Operator::BitNot => Datum::Number(!(number as i64) as f64),
        _ => return None,
    })
}

fn binary(run: &Interpreter, left: ExprId, operator: Operator, right: ExprId) -> Result<Datum, Problem> {
    let (a, b) = (evaluate(run, left)?, evaluate(run, right)?);
    match (operator, &a, &b) {
        (Operator::Join, ..) => return Ok(Datum::Text(a.shown() + &b.shown())),
        (Operator::Chain, Datum::Frame(outer), Datum::Frame(inner)) => {
            let shears = || Problem::new("run-shear", span(run, right), "");
            let chained = outer.chains_with(inner).then(|| chain(outer, inner));
            return chained.map(|frame| Datum::Frame(Box::new(frame))).ok_or_else(shears);
        }
        (_, Datum::Text(_), Datum::Text(_) | Datum::Char(_))
        | (_, Datum::Char(_), Datum::Text(_))
        | (_, Datum::Word(_), Datum::Word(_)) => {
            let (a, b) = (a.shown(), b.shown());
            return compared(operator, a == b, a, b).ok_or_else(|| wrong(run, left));
        }
        _ => {}
    }
    let vacancy = macro_variables::compared(operator, &a, &b);
    let (Some(a), Some(b)) = (a.number(), b.number()) else {
        return Err(wrong(run, if a.number().is_none() { left } else { right }));
    };
    if b == 0.0 && matches!(operator, Operator::Over | Operator::Div | Operator::Mod) {
        return Err(Problem::new("run-division", span(run, right), ""));
    }
    let result = (run.rules().operate)(operator, a, b, vacancy).or_else(|| numbers(operator, a, b));
    match result.ok_or_else(|| wrong(run, left))? {
        Datum::Number(number) if !number.is_finite() => {
            let whole = Span { start: run.program.place(left).start, end: run.program.place(right).end };
            Err(Problem::new("run-range", whole, run.program.written(whole)))
        }
        value => Ok(value),
    }
}

/// Difference of numbers that a SINUMERIK compares as equal, `<` and `>` included, as a part of the larger one: 10^-12
/// (Job planning 03/2006, 1.7), as long as MD10280 bit 0 is 0, as delivered.
const SAME: f64 = 1e-12;

/// A comparison of numbers of which almost equal ones are equal.
pub fn nearly(operator: Operator, a: f64, b: f64) -> Option<Datum> {
    compared(operator, (a - b).abs() <= SAME * a.abs().max(b.abs()), a, b)
}

/// A comparison of two values, of which is known whether they are the same and which is the greater one.
fn compared<T: PartialOrd>(operator: Operator, same: bool, a: T, b: T) -> Option<Datum> {
    Some(Datum::from(match operator {
        Operator::Equal => same,
        Operator::NotEqual => !same,
        Operator::LessEqual => same || a < b,
        Operator::GreaterEqual => same || a > b,
        Operator::Less => !same && a < b,
        Operator::Greater => !same && a > b,
        _ => return None,
    }))
}

/// The operator that NCT means by `AND`, `OR` and `XOR`: they work on the bits of whole numbers.
pub fn bits(operator: Operator) -> Option<Operator> {
    Some(match operator {
        Operator::And => Operator::BitAnd,
        Operator::Or => Operator::BitOr,
        Operator::Xor => Operator::BitXor,
        _ => return None,
    })
}

/// A fine translation stays one while nothing is turned or scaled before it: `CTRANS(…):CFINE(…)` keeps both parts.
fn chain(outer: &Frame, inner: &Frame) -> Frame {
    let mut frame = outer.then(inner);
    if outer.rotation == [0.0; 3] && !outer.scaled() && outer.mirror == [false; 3] {
        frame.fine = std::array::from_fn(|i| outer.fine[i] + inner.fine[i]);
        frame.coarse = std::array::from_fn(|i| outer.coarse[i] + inner.coarse[i]);
    }
    frame
}

pub fn numbers(operator: Operator, a: f64, b: f64) -> Option<Datum> {
    match operator {
        Operator::And => Some(Datum::from(a != 0.0 && b != 0.0)),
        Operator::Or => Some(Datum::from(a != 0.0 || b != 0.0)),
        Operator::Xor => Some(Datum::from((a != 0.0) != (b != 0.0))),
        _ => operate(operator, a, b).map(Datum::Number).or_else(|| compared(operator, a == b, a, b)),
    }
}
