//! What variables hold at a place of a program: a map that is copied in one step and shares what did not change, since
//! each branch and each call of a program goes on with a copy of its own.

use super::values::Value;
use crate::syntax::{Program, fold};
use std::collections::HashMap;
use std::rc::Rc;

/// Values of one variable that are told apart; what comes to a place on more ways is not listed.
pub(super) const ALTERNATIVES: usize = 8;

/// Variables that are copied together.
const CHUNK: usize = 16;

/// Numbers for names, so that a name is looked up once.
#[derive(Debug, Default)]
pub(super) struct Names {
    ids: HashMap<Rc<str>, usize>,
    texts: Vec<Rc<str>>,
    /// The names of one variable, by its name without index: `_SETV[0]`, `_SETV[1]`.
    elements: HashMap<String, Vec<usize>>,
    /// Variables that a loop may assign anew, with how often they are assigned.
    unsteady: HashMap<String, u32>,
}

impl Names {
    /// Names of a program.
    pub fn of(program: &Program) -> Names {
        Names { unsteady: fold::unsteady(program), ..Names::default() }
    }

    /// Whether the number of a variable depends on how often the program passes.
    pub fn is_unsteady(&self, name: &str) -> bool {
        self.unsteady.contains_key(name)
    }

    /// The number of a name, which may be new.
    pub fn number(&mut self, name: &str) -> usize {
        if let Some(id) = self.ids.get(name) {
            return *id;
        }
        let id = self.ids.len();
        let text: Rc<str> = name.into();
        self.ids.insert(Rc::clone(&text), id);
        self.texts.push(text);
        self.elements.entry(stem(name).to_owned()).or_default().push(id);
        id
    }

    /// The number of a name that was met.
    pub fn find(&self, name: &str) -> Option<usize> {
        self.ids.get(name).copied()
    }

    /// The name with this number.
    pub fn text(&self, id: usize) -> &str {
        self.texts.get(id).map_or("", |text| text)
    }

    /// How many names were met.
    pub fn count(&self) -> usize {
        self.texts.len()
    }

    /// The numbers of a variable and of its elements.
    pub fn of_variable(&self, stem: &str) -> &[usize] {
        self.elements.get(stem).map_or(&[], Vec::as_slice)
    }
}

/// A name without its index.
pub(super) fn stem(name: &str) -> &str {
    name.split('[').next().unwrap_or(name)
}

/// What one variable may hold.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Held {
    One(Rc<Value>),
    /// One of these: the way through the program decides.
    Several(Rc<[Rc<Value>]>),
}

impl Held {
    /// One of these.
    pub fn of(mut values: Vec<Rc<Value>>) -> Held {
        match (values.len(), values.pop()) {
            (1, Some(value)) => Held::One(value),
            (_, last) => Held::Several(values.into_iter().chain(last).collect()),
        }
    }

    /// All that it may be.
    pub fn all(&self) -> &[Rc<Value>] {
        match self {
            Held::One(value) => std::slice::from_ref(value),
            Held::Several(values) => values,
        }
    }

    /// What all have in common.
    pub fn common<'a, T: PartialEq>(&'a self, of: impl Fn(&'a Value) -> T) -> Option<T> {
        let (first, rest) = self.all().split_first()?;
        let common = of(first);
        rest.iter().all(|other| of(other) == common).then_some(common)
    }

    /// The number, where every way gives the same.
    fn number(&self) -> Option<f64> {
        self.common(|value| value.number)?
    }

    /// What holds where two ways meet.
    pub fn meet(&self, other: &Held) -> Held {
        let mut all = self.all().to_vec();
        for value in other.all() {
            if all.len() < ALTERNATIVES {
                let known = all.iter().any(|one| Rc::ptr_eq(one, value) || one == value);
                all.extend((!known).then(|| Rc::clone(value)));
            } else if !all.iter().any(|one| one.text == value.text) {
                replace_double(&mut all, value);
            }
        }
        Held::of(all)
    }
}

/// Where no more are told apart, what is new takes the place of a value that is there twice.
fn replace_double(all: &mut [Rc<Value>], value: &Rc<Value>) {
    let double = (1..all.len()).rev().find(|at| {
        let (before, rest) = all.split_at(*at);
        let text = rest.first().map(|one| &one.text);
        before.iter().any(|one| Some(&one.text) == text)
    });
    if let Some(place) = double.and_then(|at| all.get_mut(at)) {
        *place = Rc::clone(value);
    }
}

type Chunk = [Option<Held>; CHUNK];

/// What each variable holds, by the numbers of [`Names`].
#[derive(Clone, Debug, Default)]
pub(super) struct Values {
    chunks: Rc<Vec<Rc<Chunk>>>,
}

impl PartialEq for Values {
    fn eq(&self, other: &Self) -> bool {
        self.changed(other).next().is_none()
    }
}

impl Values {
    /// What a variable holds; none: nothing wrote it.
    pub fn get(&self, id: usize) -> Option<&Held> {
        self.chunks.get(id / CHUNK)?.get(id % CHUNK)?.as_ref()
    }

    /// The number of a variable, where every way gives the same; none: it depends on how often the program passes.
    pub fn number(&self, names: &Names, name: &str) -> Option<f64> {
        self.get(names.find(name)?).filter(|_| !names.is_unsteady(name))?.number()
    }

    /// The number of a variable on the first pass; `first`: what right sides are worth then, by their first byte.
    pub fn first_number(&self, names: &Names, name: &str, first: &HashMap<u32, Option<f64>>) -> Option<f64> {
        let value = self.get(names.find(name)?)?.all().first()?;
        value.number.or_else(|| first.get(&value.place.start).copied().flatten())
    }

    /// Writes a variable.
    pub fn set(&mut self, id: usize, held: Option<Held>) {
        let chunks = Rc::make_mut(&mut self.chunks);
        if chunks.len() <= id / CHUNK {
            chunks.resize_with(id / CHUNK + 1, Rc::default);
        }
        let chunk = chunks.get_mut(id / CHUNK).map(Rc::make_mut);
        if let Some(place) = chunk.and_then(|chunk| chunk.get_mut(id % CHUNK)) {
            *place = held;
        }
    }

    /// The variables that are another in the other map, in order.
    pub fn changed(&self, other: &Values) -> impl Iterator<Item = usize> {
        let same = Rc::ptr_eq(&self.chunks, &other.chunks);
        let chunks = if same { 0 } else { self.chunks.len().max(other.chunks.len()) };
        let shared =
            |at| matches!((self.chunks.get(at), other.chunks.get(at)), (Some(one), Some(two)) if Rc::ptr_eq(one, two));
        let ids = (0..chunks).filter(move |at| !shared(*at)).flat_map(|at| at * CHUNK..(at + 1) * CHUNK);
        ids.filter(|id| self.get(*id) != other.get(*id))
    }

    /// What holds where two ways meet. What one of them does not write is what the other left.
    pub fn meet(&self, other: &Values) -> Values {
        let mut met = self.clone();
        for id in self.changed(other) {
            let held = match (self.get(id), other.get(id)) {
                (Some(one), Some(two)) => Some(one.meet(two)),
                (one, two) => one.or(two).cloned(),
            };
            met.set(id, held);
        }
        met
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::diagnostic::Span;

    fn value(number: f64) -> Rc<Value> {
        Rc::new(Value::at(number.to_string(), Some(number), Span::default()))
    }

    // oracle: hand
    #[test]
    fn a_copy_goes_its_own_way_and_meets_again() {
        let mut one = Values::default();
        for id in 0..50 {
            one.set(id, Some(Held::One(value(id as f64))));
        }
        let mut other = one.clone();
        assert!(one == other);
        other.set(3, Some(Held::One(value(77.0))));
        other.set(60, Some(Held::One(value(60.0))));
        assert_eq!(one.changed(&other).collect::<Vec<_>>(), [3, 60]);
        assert_eq!(one.get(3).unwrap().number(), Some(3.0));
        let met = one.meet(&other);
        assert_eq!(met.get(3).unwrap().all().len(), 2);
        assert_eq!(met.get(3).unwrap().number(), None);
        assert_eq!(met.get(60).unwrap().number(), Some(60.0));
        assert!(met.meet(&other) == met, "nothing new");
    }

    // oracle: hand (what is told apart has an end, so that loops come to one)
    #[test]
    fn alternatives_have_an_end() {
        let mut all = Held::One(value(0.0));
        for number in 1..30 {
            all = all.meet(&Held::One(value(f64::from(number))));
        }
        assert_eq!(all.all().len(), ALTERNATIVES);
        assert_eq!(all.meet(&Held::One(value(99.0))), all);
        // The same number from many places leaves room for another one.
        let mut same = Held::One(value(1.0));
        for start in 1..30 {
            let place = Span { start, end: start };
            same = same.meet(&Held::One(Rc::new(Value::at("1".to_owned(), Some(1.0), place))));
        }
        assert_eq!(same.number(), Some(1.0));
        let other = same.meet(&Held::One(value(2.0)));
        assert_eq!((other.all().len(), other.number()), (ALTERNATIVES, None));
    }
}
