//! What assignments and declarations leave: the newest value of every variable, and its number where it is known.

use super::{Place, Walk};
use crate::check::expression::{begun, is_parameter};
use crate::control::arrays;
use crate::diagnostic::Span;
use crate::program::held::{Held, stem};
use crate::program::values;
use crate::program::values::{Spread, Value, spread};
use crate::syntax::fold;
use crate::syntax::tree::{ExprId, Word, WordKind};
use std::collections::BTreeSet;
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
                WordKind::Assign { name, index, value } => {
                    let Some(name) = fold::name(self.program, *name, index, &self.numbers(place)) else { continue };
                    if counts {
                        self.keep_first(place, *value);
                        self.assign(place, &name, Value::at(name.clone(), None, self.program.place(*value)));
                    } else {
                        self.write(place, &name, *value);
                    }
                }
                WordKind::Declare { name, index, value } => self.declare(place, *name, index, *value),
                _ => {}
            }
        }
    }

    /// The numbers that variables hold at a place.
    pub(super) fn numbers<'a>(&'a self, place: &'a Place) -> impl Fn(&str) -> Option<f64> + 'a {
        |name| match self.names.find(name).and_then(|id| place.values.get(id)) {
            Some(_) => place.values.number(&self.names, name),
            None => begun(&self.tools.start, name),
        }
    }

    /// An expression with what it is worth there; where that is not known, with a variable that nothing gave a value.
    pub(super) fn right_side(&self, place: &Place, id: ExprId) -> Value {
        let value = values::value(self.program, id, &self.numbers(place));
        if value.number.is_some() || value.quoted {
            return value;
        }
        let mut names = BTreeSet::new();
        fold::names_in(self.program, id, &mut names);
        let held = |name: &String| self.names.find(name).is_some_and(|id| place.values.get(id).is_some());
        let missing = |name: &String| is_parameter(name) && !held(name) && begun(&self.tools.start, name).is_none();
        Value { missing: names.into_iter().find(missing), ..value }
    }

    /// The value of an expression. Of a variable that another program wrote it is known where.
    pub(super) fn value(&self, place: &Place, id: ExprId) -> Value {
        let value = self.right_side(place, id);
        match self.held(place, id) {
            Some(held) if value.number.is_some() && !self.around.unit(value.place).holds(held.source()) => {
                Value { given: Some(held.source()), argument: held.argument, ..value }
            }
            _ => value,
        }
    }

    /// What the variable holds that an expression is.
    fn held<'a>(&self, place: &'a Place, id: ExprId) -> Option<&'a Value> {
        let id = self.variable(place, id).filter(|_| self.around.several())?;
        place.values.get(id)?.only()
    }

    /// Remembers what a right side is worth on its first pass that is not always worth the same.
    fn keep_first(&mut self, place: &Place, id: ExprId) {
        let start = self.program.place(id).start;
        if !self.first_numbers.contains_key(&start) {
            let known = |name: &str| place.values.first_number(&self.names, name, &self.first_numbers);
            let number = fold::number(self.program, id, &known);
            self.first_numbers.insert(start, number);
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
        place.values.set(self.names.number(name), Some(Held::one(Rc::new(value))));
    }

    /// One value, or those of `SET(…)` or `REP(…)` spread over an array.
    fn write(&mut self, place: &mut Place, name: &str, value: ExprId) {
        match spread(self.program, value) {
            Spread::One => {
                let right = self.value(place, value);
                if right.number.is_none() {
                    self.keep_first(place, value);
                }
                self.assign(place, name, right);
            }
            // `_SETV[0]=SET(1,,3)` writes `_SETV[0]` and `_SETV[2]`
            Spread::Each(values) => {
                for (element, id) in self.elements(name).into_iter().zip(values) {
                    if let Some(id) = self.program.given(*id) {
                        let value = self.value(place, id);
                        self.assign(place, &element, value);
                    }
                }
            }
            Spread::Same(id) => {
                let value = Value { shared: true, ..self.value(place, id) };
                for element in self.repeated(name) {
                    self.assign(place, &element, value.clone());
                }
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
            self.write(place, &name, value);
        }
    }
}
