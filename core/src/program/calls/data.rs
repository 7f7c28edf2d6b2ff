//! What assignments and declarations leave: the newest value of every variable, and its number where it is known.

use super::Walk;
use crate::control::arrays;
use crate::diagnostic::Span;
use crate::program::fold;
use crate::program::tree::{Expr, ExprId};
use crate::program::values::{self, Spread, Value, spread};

/// Most elements of an array that a program declares.
const ELEMENTS: f64 = 10_000.0;

impl Walk<'_> {
    fn learn(&mut self, name: String, number: Option<f64>) {
        self.tools.learn(&mut self.control, &name, number);
        match number.filter(|_| !self.unsteady.contains_key(&name)) {
            Some(number) => {
                self.control.set(name.clone(), number);
                self.known.insert(name, number);
            }
            None => drop(self.known.remove(&name)),
        }
    }

    pub(super) fn assign(&mut self, name: String, value: Value, line: u32) {
        self.learn(name.clone(), value.number);
        self.newest.insert(name, (value, line));
    }

    /// One value, or those of `SET(…)` or `REP(…)` spread over an array.
    pub(super) fn write(&mut self, name: String, value: ExprId, span: Span, line: u32) {
        match spread(self.program, value) {
            Spread::One => {
                let value = values::value(self.program, value, span, &self.known);
                self.assign(name, value, line);
            }
            Spread::Each(values) => {
                let elements = self.elements(&name);
                for (element, id) in elements.into_iter().zip(values) {
                    self.assign_element(element, *id, line);
                }
            }
            Spread::Same(id) => {
                let place = values::place(self.program, id).unwrap_or(span);
                let value = Value {
                    shared: true,
                    ..values::value(self.program, id, place, &self.known)
                };
                for element in self.repeated(&name) {
                    self.assign(element, value.clone(), line);
                }
            }
        }
    }

    /// `_SETV[0]=SET(1,,3)` writes `_SETV[0]` and `_SETV[2]`. A value whose place is not known is at least forgotten.
    fn assign_element(&mut self, element: String, id: ExprId, line: u32) {
        if matches!(self.program.expr(id), None | Some(Expr::Omitted(_))) {
            return;
        }
        match values::place(self.program, id) {
            Some(place) => {
                let value = values::value(self.program, id, place, &self.known);
                self.assign(element, value, line);
            }
            None => {
                let number = fold::number(self.program, id, &self.known);
                self.learn(element.clone(), number);
                self.newest.remove(&element);
            }
        }
    }

    fn elements(&self, name: &str) -> Vec<String> {
        let stem = name.split('[').next().unwrap_or_default();
        let local = self.arrays.get(stem).map(Vec::as_slice);
        let sizes = local.or_else(|| arrays::sizes(name));
        sizes.map_or(Vec::new(), |sizes| arrays::elements_from(name, sizes))
    }

    fn repeated(&self, name: &str) -> Vec<String> {
        arrays::repeated(&self.control, name).unwrap_or_else(|| self.elements(name))
    }

    /// `DEF REAL A=1, B[3]=SET(1,2)`.
    pub(super) fn declare(
        &mut self,
        name: Span,
        index: &[ExprId],
        value: Option<ExprId>,
        line: u32,
    ) {
        let name = self.program.name(name);
        if !index.is_empty() {
            let size = |id: &ExprId| fold::number(self.program, *id, &self.known);
            let sizes: Option<Vec<f64>> = index.iter().map(size).collect();
            let sizes = sizes.unwrap_or_default();
            if sizes.iter().product::<f64>() > ELEMENTS {
                return;
            }
            let sizes = sizes.into_iter().map(|size| size as usize).collect();
            self.arrays.insert(name.clone(), sizes);
        }
        if let Some(value) = value {
            let place = values::place(self.program, value).unwrap_or_default();
            self.write(name, value, place, line);
        }
    }
}
