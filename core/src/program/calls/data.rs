//! What assignments and declarations leave: the newest value of every variable, and its number where it is known.

use super::{Place, Walk};
use crate::control::arrays;
use crate::diagnostic::Span;
use crate::program::held::{Held, stem};
use crate::program::values::{Spread, Value, spread};
use crate::program::{arguments, values};
use crate::syntax::fold;
use crate::syntax::tree::{Expr, ExprId, Word, WordKind};
use std::rc::Rc;

/// Most elements of an array that a program declares.
const ELEMENTS: f64 = 10_000.0;

impl Walk<'_> {
    /// Takes in the assignments and declarations of a block.
    pub(super) fn data(&mut self, place: &mut Place, words: &[Word]) {
        let says = |keywords: &[&str]| words.iter().any(|word| self.program.is_keyword(word, keywords));
        if says(&["PROC", "EXTERN"]) {
            return;
        }
        let counts = says(&["FOR"]);
        for word in words {
            match &word.kind {
                WordKind::Assign { name, index, value_span, value } => {
                    let Some(name) = fold::name(self.program, *name, index, &self.numbers(place)) else { continue };
                    if counts {
                        self.keep_first(place, *value, *value_span);
                        self.assign(place, &name, Value::at(name.clone(), None, *value_span));
                    } else {
                        self.write(place, &name, *value, *value_span);
                    }
                }
                WordKind::Declare { name, index, value } => self.declare(place, *name, index, *value),
                _ => {}
            }
        }
    }

    /// The numbers that variables hold at a place.
    pub(super) fn numbers<'a>(&'a self, place: &'a Place) -> impl Fn(&str) -> Option<f64> + 'a {
        |name| place.values.number(&self.names, name)
    }

    /// The value of an expression. Of a variable that another program wrote it is known where.
    pub(super) fn value(&self, place: &Place, id: ExprId, at: Span) -> Value {
        let value = values::value(self.program, id, at, &self.numbers(place));
        match self.held(place, id) {
            Some(held) if value.number.is_some() && !self.around.unit(at).holds(held.source()) => {
                Value { given: Some(held.source()), argument: held.argument, ..value }
            }
            _ => value,
        }
    }

    /// What the variable holds that an expression is.
    fn held<'a>(&self, place: &'a Place, id: ExprId) -> Option<&'a Value> {
        let id = self.variable(place, id).filter(|_| self.around.several())?;
        match place.values.get(id)? {
            Held::One(value) => Some(value),
            Held::Several(_) => None,
        }
    }

    /// Remembers what a right side is worth on its first pass that is not always worth the same.
    fn keep_first(&mut self, place: &Place, id: ExprId, at: Span) {
        if !self.first_numbers.contains_key(&at.start) {
            let known = |name: &str| place.values.first_number(&self.names, name, &self.first_numbers);
            let number = fold::number(self.program, id, &known);
            self.first_numbers.insert(at.start, number);
        }
    }

    fn learn(&mut self, name: &str, number: Option<f64>) {
        self.tools.learn(&mut self.control, name, number);
        if let Some(number) = number.filter(|_| !self.names.is_unsteady(name)) {
            self.control.set(name, number);
        }
    }

    pub(super) fn assign(&mut self, place: &mut Place, name: &str, value: Value) {
        self.learn(name, value.number);
        place.values.set(self.names.number(name), Some(Held::One(Rc::new(value))));
    }

    /// One value, or those of `SET(…)` or `REP(…)` spread over an array.
    fn write(&mut self, place: &mut Place, name: &str, value: ExprId, span: Span) {
        match spread(self.program, value) {
            Spread::One => {
                let right = self.value(place, value, span);
                if right.number.is_none() {
                    self.keep_first(place, value, span);
                }
                self.assign(place, name, right);
            }
            Spread::Each(values) => {
                let elements = self.elements(name);
                let written = arguments::places(self.program, span);
                for (index, (element, id)) in elements.into_iter().zip(values).enumerate() {
                    let at = written.get(index).copied().filter(|_| written.len() == values.len());
                    self.assign_element(place, &element, *id, at.or_else(|| values::place(self.program, *id)));
                }
            }
            Spread::Same(id) => {
                let at = values::place(self.program, id).unwrap_or(span);
                let value = Value { shared: true, ..self.value(place, id, at) };
                for element in self.repeated(name) {
                    self.assign(place, &element, value.clone());
                }
            }
        }
    }

    /// `_SETV[0]=SET(1,,3)` writes `_SETV[0]` and `_SETV[2]`. A value whose place is not known is at least forgotten.
    fn assign_element(&mut self, place: &mut Place, element: &str, id: ExprId, at: Option<Span>) {
        if matches!(self.program.expr(id), None | Some(Expr::Omitted(_))) {
            return;
        }
        match at {
            Some(at) => {
                let value = self.value(place, id, at);
                self.assign(place, element, value);
            }
            None => {
                let number = fold::number(self.program, id, &self.numbers(place));
                self.learn(element, number);
                place.values.set(self.names.number(element), None);
            }
        }
    }

    fn elements(&self, name: &str) -> Vec<String> {
        let sizes = self.arrays.get(stem(name)).map(Vec::as_slice).or_else(|| arrays::sizes(name));
        sizes.map_or(Vec::new(), |sizes| arrays::elements_from(name, sizes))
    }

    fn repeated(&self, name: &str) -> Vec<String> {
        arrays::repeated(&self.control, name).unwrap_or_else(|| self.elements(name))
    }

    /// `DEF REAL A=1, B[3]=SET(1,2)`.
    fn declare(&mut self, place: &mut Place, name: Span, index: &[ExprId], value: Option<ExprId>) {
        let name = self.program.name(name);
        if !index.is_empty() {
            let size = |id: &ExprId| fold::number(self.program, *id, &self.numbers(place));
            let sizes: Vec<f64> = index.iter().map(size).collect::<Option<_>>().unwrap_or_default();
            if sizes.iter().any(|size| *size < 1.0) || sizes.iter().product::<f64>() > ELEMENTS {
                return;
            }
            self.arrays.insert(name.clone(), sizes.into_iter().map(|size| size as usize).collect());
        }
        if let Some(value) = value {
            self.write(place, &name, value, values::place(self.program, value).unwrap_or_default());
        }
    }
}
