//! What variables hold at a place of a program: a tree that is copied in one step and shares what did not change, since
//! each branch and each call of a program goes on with a copy of its own.

use super::values::Value;
pub(super) use crate::control::arrays::stem;
use crate::syntax::{Program, fold};
use std::collections::HashMap;
use std::rc::Rc;

/// Values of one variable that are told apart; what comes to a place on more ways is not listed.
pub(super) const ALTERNATIVES: usize = 8;

/// Variables that are copied together, and parts of the map.
const WIDTH: usize = 16;

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

/// What one variable may hold.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Held {
    of: Of,
    /// No way leaves what was there before the program.
    always: bool,
}

#[derive(Clone, Debug, PartialEq)]
enum Of {
    One(Rc<Value>),
    /// One of these: the way through the program decides.
    Several(Rc<[Rc<Value>]>),
}

impl Held {
    /// What one assignment writes.
    pub fn one(value: Rc<Value>) -> Held {
        Held { of: Of::One(value), always: true }
    }

    /// These in place of the ones that it has.
    pub fn with(&self, mut values: Vec<Rc<Value>>) -> Held {
        let of = match (values.len(), values.pop()) {
            (1, Some(value)) => Of::One(value),
            (_, last) => Of::Several(values.into_iter().chain(last).collect()),
        };
        Held { of, ..*self }
    }

    /// The same, where some way writes nothing.
    pub fn sometimes(&self) -> Held {
        Held { always: false, ..self.clone() }
    }

    /// Whether every way writes it.
    pub fn always(&self) -> bool {
        self.always
    }

    /// All that it may be, as far as the program writes it.
    pub fn all(&self) -> &[Rc<Value>] {
        match &self.of {
            Of::One(value) => std::slice::from_ref(value),
            Of::Several(values) => values,
        }
    }

    /// The only one.
    pub fn only(&self) -> Option<&Value> {
        match &self.of {
            Of::One(value) => Some(value),
            Of::Several(_) => None,
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
        let met = self.with(all);
        if other.always { met } else { met.sometimes() }
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

/// A part of the map; equal parts are mostly the same one.
#[derive(Clone, Debug)]
#[allow(clippy::large_enum_variant)] // most parts hold values, and each is behind an `Rc` already
enum Node {
    Held([Option<Held>; WIDTH]),
    Parts([Part; WIDTH]),
}

/// None: nothing is held there.
type Part = Option<Rc<Node>>;

/// What each variable holds, by the numbers of [`Names`]. What two maps share is neither copied nor compared: a program
/// with as many branches as variables takes time in proportion to its length.
#[derive(Clone, Debug, Default)]
pub(super) struct Values {
    top: Part,
    /// Levels of parts above those that hold.
    height: u32,
}

impl PartialEq for Values {
    fn eq(&self, other: &Self) -> bool {
        self.changed(other).is_empty()
    }
}

impl Values {
    /// What a variable holds; none: nothing wrote it.
    pub fn get(&self, id: usize) -> Option<&Held> {
        if id >= room(self.height) {
            return None;
        }
        let mut node = self.top.as_deref()?;
        for height in (0..=self.height).rev() {
            match node {
                Node::Held(held) => return held.get(place(id, height))?.as_ref(),
                Node::Parts(parts) => node = parts.get(place(id, height))?.as_deref()?,
            }
        }
        None
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
        while id >= room(self.height) {
            self.raise();
        }
        let mut part = &mut self.top;
        for height in (0..=self.height).rev() {
            let node = part.get_or_insert_with(|| Rc::new(Node::empty(height)));
            match Rc::make_mut(node) {
                Node::Held(all) => {
                    if let Some(one) = all.get_mut(place(id, height)) {
                        *one = held;
                    }
                    return;
                }
                Node::Parts(parts) => match parts.get_mut(place(id, height)) {
                    Some(next) => part = next,
                    None => return,
                },
            }
        }
    }

    /// Room for more variables.
    fn raise(&mut self) {
        let below = self.top.take();
        self.height += 1;
        self.top = below.map(|below| {
            let mut parts = [const { None }; WIDTH];
            parts[0] = Some(below);
            Rc::new(Node::Parts(parts))
        });
    }

    /// Both with the same height.
    fn level(&self, other: &Values) -> (Values, Values) {
        let (mut one, mut two) = (self.clone(), other.clone());
        while one.height < two.height {
            one.raise();
        }
        while two.height < one.height {
            two.raise();
        }
        (one, two)
    }

    /// The variables that are another in the other map, in order.
    pub fn changed(&self, other: &Values) -> Vec<usize> {
        let (one, two) = self.level(other);
        let mut found = Vec::new();
        changed(&one.top, &two.top, 0, one.height, &mut found);
        found
    }

    /// What holds where two ways meet. What one of them does not write is what the other left, if it comes there.
    pub fn meet(&self, other: &Values) -> Values {
        let (one, two) = self.level(other);
        Values { top: meet(&one.top, &two.top), height: one.height }
    }
}

impl Node {
    fn empty(height: u32) -> Node {
        if height == 0 { Node::Held([const { None }; WIDTH]) } else { Node::Parts([const { None }; WIDTH]) }
    }
}

/// How many variables a map of this height has room for.
fn room(height: u32) -> usize {
    WIDTH.saturating_pow(height + 1)
}

/// Place of a variable in a part of this height.
fn place(id: usize, height: u32) -> usize {
    id / WIDTH.saturating_pow(height) % WIDTH
}

/// Whether two parts are one.
fn shared(one: &Part, two: &Part) -> bool {
    match (one, two) {
        (Some(one), Some(two)) => Rc::ptr_eq(one, two),
        (one, two) => one.is_none() && two.is_none(),
    }
}

/// The variables that are another in two parts which begin with this one.
fn changed(one: &Part, two: &Part, from: usize, height: u32, found: &mut Vec<usize>) {
    if shared(one, two) {
        return;
    }
    let width = WIDTH.saturating_pow(height);
    for at in 0..WIDTH {
        let from = from + at * width;
        if height > 0 {
            changed(below(one, at), below(two, at), from, height - 1, found);
        } else if held(one, at) != held(two, at) {
            found.push(from);
        }
    }
}

fn below(part: &Part, at: usize) -> &Part {
    match part.as_deref() {
        Some(Node::Parts(parts)) => parts.get(at).unwrap_or(&None),
        _ => &None,
    }
}

fn held(part: &Part, at: usize) -> Option<&Held> {
    match part.as_deref() {
        Some(Node::Held(all)) => all.get(at)?.as_ref(),
        _ => None,
    }
}

/// What a part holds that the other way does not have; the part itself where no variable of it was always written.
fn sometimes(node: &Rc<Node>) -> Rc<Node> {
    match &**node {
        Node::Held(all) if all.iter().flatten().any(Held::always) => {
            Rc::new(Node::Held(std::array::from_fn(|at| all[at].as_ref().map(Held::sometimes))))
        }
        Node::Held(_) => Rc::clone(node),
        Node::Parts(parts) => {
            let others: [Part; WIDTH] = std::array::from_fn(|at| parts[at].as_ref().map(sometimes));
            let same = others.iter().zip(parts).all(|(other, part)| shared(other, part));
            if same { Rc::clone(node) } else { Rc::new(Node::Parts(others)) }
        }
    }
}

/// What both hold; one of the two where that is all of it, so that it stays shared.
fn meet(one: &Part, two: &Part) -> Part {
    let (first, second) = match (one, two) {
        (Some(first), Some(second)) if Rc::ptr_eq(first, second) => return one.clone(),
        (Some(first), Some(second)) => (first, second),
        (Some(alone), None) | (None, Some(alone)) => return Some(sometimes(alone)),
        (None, None) => return None,
    };
    let (met, as_first, as_second) = match (&**first, &**second) {
        (Node::Held(first), Node::Held(second)) => {
            let met: [Option<Held>; WIDTH] = std::array::from_fn(|at| match (&first[at], &second[at]) {
                (Some(one), Some(two)) => Some(one.meet(two)),
                (one, two) => one.as_ref().or(two.as_ref()).map(Held::sometimes),
            });
            let (as_first, as_second) = (met == *first, met == *second);
            (Node::Held(met), as_first, as_second)
        }
        (Node::Parts(first), Node::Parts(second)) => {
            let met: [Part; WIDTH] = std::array::from_fn(|at| meet(&first[at], &second[at]));
            let same = |parts: &[Part; WIDTH]| met.iter().zip(parts).all(|(met, part)| shared(met, part));
            let (as_first, as_second) = (same(first), same(second));
            (Node::Parts(met), as_first, as_second)
        }
        _ => return one.clone(), // both have the same height
    };
    match (as_first, as_second) {
        (true, _) => one.clone(),
        (_, true) => two.clone(),
        _ => Some(Rc::new(met)),
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;
    use crate::diagnostic::Span;
    use proptest::{collection, prelude::*};
    use std::collections::{BTreeMap, BTreeSet};

    fn value(number: f64) -> Rc<Value> {
        Rc::new(Value::at(number.to_string(), Some(number), Span::default()))
    }

    // oracle: hand
    #[test]
    fn a_copy_goes_its_own_way_and_meets_again() {
        let mut one = Values::default();
        for id in 0..50 {
            one.set(id, Some(Held::one(value(id as f64))));
        }
        let mut other = one.clone();
        assert!(one == other);
        other.set(3, Some(Held::one(value(77.0))));
        other.set(60, Some(Held::one(value(60.0))));
        assert_eq!(one.changed(&other), [3, 60]);
        assert_eq!(one.get(3).unwrap().number(), Some(3.0));
        let met = one.meet(&other);
        assert_eq!(met.get(3).unwrap().all().len(), 2);
        assert_eq!(met.get(3).unwrap().number(), None);
        assert_eq!(met.get(60).unwrap().number(), Some(60.0));
        assert!(met.get(3).unwrap().always() && !met.get(60).unwrap().always(), "one way writes the last");
        assert!(met.meet(&other) == met, "nothing new");
        assert!(shared(&met.meet(&other).top, &met.top), "nor copied");
    }

    // oracle: peer (a plain map, for any writing, copying and meeting)
    #[test]
    fn it_holds_what_a_plain_map_holds() {
        let at = |values: &Values, ids: &[usize]| -> Vec<Option<Held>> {
            ids.iter().map(|id| values.get(*id).cloned()).collect()
        };
        proptest!(|(steps in collection::vec((0..4_usize, 0..4_usize, 0..5000_usize, 0..3_u32), 1..120))| {
            let mut trees = vec![Values::default(); 4];
            let mut maps: Vec<BTreeMap<usize, Held>> = vec![BTreeMap::new(); 4];
            for (to, from, id, number) in steps {
                if number == 0 {
                    trees[to] = trees[to].meet(&trees[from]);
                    let others = maps[from].clone();
                    for (id, held) in others.clone() {
                        let met = maps[to].get(&id).map_or_else(|| held.sometimes(), |one| one.meet(&held));
                        maps[to].insert(id, met);
                    }
                    for (id, held) in &mut maps[to] {
                        if !others.contains_key(id) {
                            *held = held.sometimes();
                        }
                    }
                } else if id % 7 == 0 {
                    trees[to] = trees[from].clone();
                    maps[to] = maps[from].clone();
                } else {
                    let held = (number == 1).then(|| Held::one(value(id as f64)));
                    trees[to].set(id, held.clone());
                    maps[to].remove(&id);
                    maps[to].extend(held.map(|held| (id, held)));
                }
            }
            let more = [0, 15, 16, 4999, 9999];
            let ids: Vec<usize> = maps.iter().flat_map(|map| map.keys().copied()).chain(more).collect();
            for (tree, map) in trees.iter().zip(&maps) {
                prop_assert_eq!(at(tree, &ids), ids.iter().map(|id| map.get(id).cloned()).collect::<Vec<_>>());
                for (other, that) in trees.iter().zip(&maps) {
                    let all: BTreeSet<usize> = map.keys().chain(that.keys()).copied().collect();
                    let differ: Vec<usize> = all.into_iter().filter(|id| map.get(id) != that.get(id)).collect();
                    prop_assert_eq!(tree.changed(other), differ);
                }
            }
        });
    }

    // oracle: hand (what is told apart has an end, so that loops come to one)
    #[test]
    fn alternatives_have_an_end() {
        let mut all = Held::one(value(0.0));
        for number in 1..30 {
            all = all.meet(&Held::one(value(f64::from(number))));
        }
        assert_eq!(all.all().len(), ALTERNATIVES);
        assert_eq!(all.meet(&Held::one(value(99.0))), all);
        // The same number from many places leaves room for another one.
        let mut same = Held::one(value(1.0));
        for start in 1..30 {
            let place = Span { start, end: start };
            same = same.meet(&Held::one(Rc::new(Value::at("1".to_owned(), Some(1.0), place))));
        }
        assert_eq!(same.number(), Some(1.0));
        let other = same.meet(&Held::one(value(2.0)));
        assert_eq!((other.all().len(), other.number()), (ALTERNATIVES, None));
    }
}
