//! What holds along the ways of a program: what a called program takes from its caller and leaves it.

use super::uses::{Uses, is_cycle, measures_itself, measuring, uses};
use super::{Place, Walk};
use crate::diagnostic::Span;
use crate::program::flow::{Called, Entry, Follow, LEVELS, Meet, Mode, State, called};
use crate::program::held::{Held, Names, Values, stem};
use crate::program::values::Value;
use crate::syntax::programs::{Programs, Unit};
use crate::syntax::{Expr, ExprId, Program, Word, WordKind, fold};
use std::collections::{BTreeSet, HashMap};
use std::rc::Rc;

/// The programs of a text, as far as values go through them.
pub(super) struct Subprograms<'a> {
    programs: &'a Programs,
    /// First byte of each program.
    starts: Vec<u32>,
    /// Ends of the calls that measure, or call a program that does.
    measured: Vec<u32>,
    /// Ends of the calls of programs of the text.
    called: Vec<u32>,
    /// What each program names; found when it is called.
    own: HashMap<usize, Rc<Uses>>,
    /// Variables that it and the programs that it calls name.
    all: HashMap<usize, Rc<BTreeSet<String>>>,
    /// Numbers of these variables, of as many names as had been met.
    taken: HashMap<usize, (usize, Rc<[usize]>)>,
}

impl<'a> Subprograms<'a> {
    /// The programs of this text.
    pub fn of(program: &Program, programs: &'a Programs) -> Self {
        let first = |unit: &Unit| program.blocks.get(unit.blocks.start).map(|block| block.span.start);
        let starts = programs.units.iter().map(first);
        let mut found = Self {
            programs,
            starts: starts.map(|start| start.unwrap_or(u32::MAX)).collect(),
            measured: Vec::new(),
            called: Vec::new(),
            own: HashMap::new(),
            all: HashMap::new(),
            taken: HashMap::new(),
        };
        let measures = measuring(program, programs);
        for block in &program.blocks {
            let words = program.words_of(block);
            for (at, word) in words.iter().enumerate() {
                if measures_itself(program, word) {
                    found.measured.push(word.span.end);
                } else if programs.units.len() > 1
                    && let Some(Called::Here(unit)) = called(program, programs, words, at)
                {
                    found.called.push(word.span.end);
                    if measures.contains(&unit) {
                        found.measured.push(word.span.end);
                    }
                }
            }
        }
        found
    }

    /// First byte behind the last call that measures before this one, in the same program.
    pub fn own_from(&self, call: Span) -> u32 {
        last_before(&self.measured, call).max(self.unit(call).start)
    }

    /// End of the last call of a program before this one, in the same program; 0: there is none.
    pub fn behind(&self, call: Span) -> u32 {
        let last = last_before(&self.called, call);
        if last > self.unit(call).start { last } else { 0 }
    }

    /// The bytes of the program in which a place stands.
    pub fn unit(&self, place: Span) -> Span {
        let behind = self.starts.partition_point(|start| *start <= place.start);
        let start = behind.checked_sub(1).and_then(|unit| self.starts.get(unit));
        Span { start: start.copied().unwrap_or(0), end: self.starts.get(behind).copied().unwrap_or(u32::MAX) }
    }

    /// Whether the text holds more than one program.
    pub fn several(&self) -> bool {
        self.starts.len() > 1
    }

    fn own(&mut self, program: &Program, unit: usize) -> Rc<Uses> {
        Rc::clone(self.own.entry(unit).or_insert_with(|| Rc::new(uses(program, self.programs, unit))))
    }

    /// The numbers of those variables.
    fn taken(&mut self, program: &Program, names: &Names, unit: usize) -> Rc<[usize]> {
        if let Some((count, ids)) = self.taken.get(&unit)
            && *count == names.count()
        {
            return Rc::clone(ids);
        }
        let all = self.all(program, unit);
        let ids: Rc<[usize]> = all.iter().flat_map(|name| names.of_variable(name)).copied().collect();
        self.taken.insert(unit, (names.count(), Rc::clone(&ids)));
        ids
    }

    /// The variables that a program and those that it calls name.
    fn all(&mut self, program: &Program, unit: usize) -> Rc<BTreeSet<String>> {
        if let Some(known) = self.all.get(&unit) {
            return Rc::clone(known);
        }
        let mut names = BTreeSet::new();
        let (mut reached, mut level) = (BTreeSet::from([unit]), vec![unit]);
        for _ in 0..LEVELS {
            let mut deeper = Vec::new();
            for unit in level {
                let own = self.own(program, unit);
                names.extend(own.names.iter().cloned());
                deeper.extend(own.calls.iter().filter(|unit| reached.insert(**unit)));
            }
            level = deeper;
        }
        Rc::clone(self.all.entry(unit).or_insert(Rc::new(names)))
    }
}

fn last_before(ends: &[u32], call: Span) -> u32 {
    let behind = ends.partition_point(|end| *end <= call.start);
    behind.checked_sub(1).and_then(|last| ends.get(last)).copied().unwrap_or(0)
}

impl Follow for Walk<'_> {
    type State = Place;

    fn block(&mut self, place: &mut Place, words: &[Word]) {
        self.pass();
        self.data(place, words);
        let known = |name: &str| place.values.number(&self.names, name);
        self.forces.block(&mut place.force, words, &known);
    }

    fn call(&mut self, place: &mut Place, word: &Word) {
        if let WordKind::Call { name, args, .. } = &word.kind
            && is_cycle(self.program, *name)
        {
            self.cycle(place, word.span, *name, args);
        }
    }

    fn elsewhere(&self, place: &mut Place) {
        place.force = State::elsewhere();
    }

    /// What a called program begins with: of the values those that it or a deeper one names, and its parameters.
    fn enter(&mut self, caller: &Place, entry: &Entry) -> Place {
        let mut values = Values::default();
        for id in self.around.taken(self.program, &self.names, entry.unit).iter() {
            if let Some(held) = caller.values.get(*id) {
                values.set(*id, Some(held.clone()));
            }
        }
        let own = self.around.own(self.program, entry.unit);
        let arguments = arguments_of(entry);
        for (at, formal) in own.formal.iter().enumerate() {
            let argument = arguments.get(at).and_then(|id| self.program.given(*id));
            let held = match (argument, formal.default) {
                (Some(id), _) => Value { argument: true, ..self.value(caller, id) },
                (None, Some(id)) => self.value(caller, id),
                (None, None) => Value { argument: true, ..Value::at("0".to_owned(), Some(0.0), entry.place()) },
            };
            values.set(self.names.number(&formal.name), Some(Held::one(Rc::new(held))));
        }
        Place { force: caller.force.clone(), values }
    }

    /// What holds behind a call: the caller's own values, but for those that the called program wrote.
    fn leave(&mut self, caller: &Place, (begin, after): (&Place, &Place), entry: &Entry, saves: bool) -> Place {
        let mut place = Place { force: after.force.clone(), values: caller.values.clone() };
        if saves {
            place.force.restore(&caller.force);
        }
        let own = self.around.own(self.program, entry.unit);
        for id in begin.values.changed(&after.values) {
            if !own.declared.contains(stem(self.names.text(id))) {
                place.values.set(id, after.values.get(id).map(|held| self.written(caller, id, held, entry.place())));
            }
        }
        if !own.formal.iter().any(|formal| formal.by_reference) {
            return place;
        }
        let arguments = own.formal.iter().zip(arguments_of(entry));
        for (formal, argument) in arguments.filter(|(formal, _)| formal.by_reference) {
            if let Some((variable, formal)) = self.variable(caller, *argument).zip(self.names.find(&formal.name)) {
                place.values.set(variable, after.values.get(formal).cloned());
            }
        }
        place
    }

    fn end(&mut self, place: &Place) {
        self.left_on |= match &place.force.compensation {
            Mode::Is(compensation) => compensation.code != 40,
            Mode::Open => self.forces.compensates,
            Mode::Unset => false,
        };
    }
}

impl Meet for Place {
    fn meet(&self, other: &Place) -> Place {
        Place { force: self.force.meet(&other.force), values: self.values.meet(&other.values) }
    }
}

impl Walk<'_> {
    /// A value that a called program wrote, with the assignment of the caller whose place it took.
    fn written(&self, caller: &Place, id: usize, held: &Held, call: Span) -> Held {
        let Some(before) = caller.values.get(id).and_then(Held::only) else { return held.clone() };
        let after = held.all().iter().map(|value| {
            if value.number.is_some() && value.number == before.number || **value == *before {
                return Rc::clone(value);
            }
            Rc::new(Value { instead: Some((before.place, call)), ..Value::clone(value) })
        });
        held.with(after.collect())
    }

    /// The variable that an expression is.
    pub(super) fn variable(&self, place: &Place, id: ExprId) -> Option<usize> {
        let Some(Expr::Name { name, index }) = self.program.expr(id) else { return None };
        self.names.find(&fold::name(self.program, *name, index, &self.numbers(place))?)
    }
}

/// The arguments of a call of a program.
fn arguments_of<'a>(entry: &Entry<'a>) -> &'a [ExprId] {
    let word = entry.words.get(entry.at);
    if let Some(Word { kind: WordKind::Call { args, .. }, .. }) = word { args } else { &[] }
}
