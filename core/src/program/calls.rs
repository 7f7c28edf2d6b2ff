//! The measuring calls of a program with the values that arrive there: along calls, past branches, through loops.

mod data;
mod listed;
pub(super) mod macros;
mod site;
mod sorts;
mod subprograms;
mod uses;

use super::flow::{Forces, State, follow};
use super::held::{ALTERNATIVES, Names, Values};
use super::lists::findings::of_call;
use super::tools::{ToolInUse, Tools};
use super::write::is_expression;
use crate::catalogue::Functions;
use crate::catalogue::newer::variant_title;
use crate::check::{newer, variants};
use crate::control::{Control, Plane, Transverse, UnitFunction, delivery};
use crate::diagnostic::{Diagnostic, Span};
use crate::entry::{ArgumentList, Cycle, Style, Typed};
use crate::message::Message;
use crate::name::Name;
use crate::syntax::programs::programs;
use crate::syntax::{BETWEEN, Program};
use site::Found;
use std::collections::{BTreeMap, BTreeSet, HashMap};
use subprograms::Subprograms;
use uses::calls_cycle;

/// A measuring call. Lines count from 0.
pub struct CallSite {
    /// What is called.
    pub cycle: &'static Cycle,
    /// Line of the call.
    pub line: u32,
    /// First line behind the call before it with an assignment for this one; the call's own line if there is none.
    pub first_line: u32,
    /// The call itself.
    pub span: Span,
    /// Values as a form takes them: known at run time only, the expression; differing by the way, the parameter's name.
    pub values: Typed,
    /// As they are written, those of the values that are the worth of an expression: `R2` of 50.02.
    pub expressions: Typed,
    /// Of the values that are expressions without a known worth: a variable in each that nothing gave a value.
    pub missing: BTreeMap<Name, String>,
    /// Place of each value, its newest assignment, also that of an earlier call; none where several come here.
    pub places: BTreeMap<Name, Span>,
    /// Where the values were written that come from other programs of the text, or on more ways than one.
    pub origins: BTreeMap<Name, Vec<Origin>>,
    /// Of the values that differ by the way or from pass to pass, those that arrive first.
    pub first: BTreeMap<Name, Origin>,
    /// Of the values those that some way to the call does not write, and those that only others write.
    pub sometimes: BTreeSet<Name>,
    /// Parameters whose place gives a value to others too (`REP`), so that it cannot be changed for one of them.
    pub shared: BTreeSet<Name>,
    /// The argument list that was called; none: the bare name, or a block of addresses.
    pub list: Option<&'static ArgumentList>,
    /// Places before this byte belong to an earlier call as well.
    pub own_from: u32,
    /// End of the last call of a program of the text before this one; it may write values anew.
    pub behind: u32,
    /// Bits that the control's own support writes with a call, as the program has set them: name, value as text, place.
    pub bits: Vec<(&'static str, String, Span)>,
    /// Working plane at the call.
    pub plane: Plane,
    /// How X is given at the call; diameters where the text does not tell.
    pub transverse: Transverse,
    /// Number of the G function of units active at the call: 70, 71, 700, 710 (NCT 20, 21).
    pub unit_function: UnitFunction,
    /// A main program of the text may end with tool radius compensation on: without G40 behind its last G41 or G42.
    pub left_on: bool,
    /// The ways on which a program comes to it that differ in what is active, or in values.
    pub ways: Vec<Way>,
    /// Assignments for this call that do not reach it, since a called program writes the same: name, place, that call.
    pub overwritten: Vec<(Name, Span, Span)>,
    /// Findings with their places.
    pub diagnostics: Vec<Diagnostic>,
}

impl CallSite {
    /// The place of a value that is written for this call, and for nothing else with it.
    pub fn own_place(&self, name: &str) -> Option<Span> {
        self.place_of_its_own(name).filter(|_| !self.shared.contains(name))
    }

    /// The place of a value that is written for this call, in the same program.
    pub fn place_of_its_own(&self, name: &str) -> Option<Span> {
        let place = *self.places.get(name)?;
        (place.start >= self.own_from && !self.is_foreign(name, place)).then_some(place)
    }

    /// A value as the program has it, where that is no plain number or text.
    pub fn expression(&self, name: &str) -> Option<&str> {
        let open = || {
            let param = self.cycle.param(name)?;
            self.values.get(name).filter(|text| is_expression(param, text))
        };
        self.expressions.get(name).or_else(open).map(String::as_str)
    }

    /// The list of a newer control in which it is written.
    pub fn newer_list(&self) -> Option<&'static ArgumentList> {
        self.list.filter(|list| list.style == Style::Operate)
    }

    /// Number of its measuring variant on a control in the state of the call, where that is known.
    pub fn variant(&self, control: &Control) -> Option<i64> {
        let open = self.newer_list().is_some_and(|list| newer::is_open(self.cycle, list, &self.values, control));
        variants::chosen(self.cycle, &self.values, control).filter(|_| !open)
    }

    /// What it is called on a control in its state: its variant, in a list by the words of lists; none: not known.
    pub fn title(&self, control: &Control) -> Option<Message> {
        let number = self.variant(control)?;
        let key = self.cycle.variants.iter().find(|one| one.number == number)?.key;
        let of_list = self.newer_list().and_then(|_| variant_title(key));
        Some(of_list.unwrap_or_else(|| Message::new(key)))
    }

    /// A control with the plane and the units that are active at the call.
    pub fn control_at(&self, control: &Control) -> Control {
        let mut control = control.clone();
        control.plane = self.plane;
        control.choose_units(self.unit_function as u16);
        control
    }

    /// The values on one of its ways.
    pub fn values_on<'a>(&'a self, way: &'a Way) -> &'a Typed {
        way.values.as_ref().unwrap_or(&self.values)
    }

    /// Whether a value is written in another program of the text.
    fn is_foreign(&self, name: &str, place: Span) -> bool {
        self.origins.get(name).into_iter().flatten().any(|origin| origin.place == place)
    }

    /// Whether a value depends on the way to the call.
    pub fn differs(&self, name: &str) -> bool {
        let origins = self.origins.get(name).and_then(|all| all.split_first());
        origins.is_some_and(|(first, rest)| rest.iter().any(|other| other.text != first.text))
    }

    /// Whether more places may give a value than are known.
    pub fn is_of_many(&self, name: &str) -> bool {
        self.origins.get(name).is_some_and(|origins| origins.len() >= ALTERNATIVES)
    }
}

/// A value that comes to a call from somewhere else.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Origin {
    /// As a form takes it.
    pub text: String,
    /// Where it is written.
    pub place: Span,
    /// It is the argument of a call.
    pub argument: bool,
    /// No other measuring call takes it before.
    pub own: bool,
}

/// A way to a call.
#[derive(Clone, Debug, PartialEq)]
pub struct Way {
    /// Place among all ways of the program, in the order of the run.
    pub order: usize,
    /// What is active at the call.
    pub state: State,
    /// Tool in use, where program and machine tell its type.
    pub tool: Option<ToolInUse>,
    /// The values on this way, where they are not those of the call.
    pub values: Option<Typed>,
}

/// Every measuring call in the order of the text, also one that is skipped, on a metric control as delivered.
pub fn calls(program: &Program) -> Vec<CallSite> {
    calls_on(program, delivery(program.dialect))
}

/// Every measuring call, in the order of the text, of a program that starts on a control in this state.
pub fn calls_on(program: &Program, control: Control) -> Vec<CallSite> {
    calls_told(program, control, &mut |_| {})
}

/// Every measuring call, as [`calls_on`], telling from time to time which share of the program is looked through.
pub fn calls_told(program: &Program, control: Control, told: &mut dyn FnMut(f64)) -> Vec<CallSite> {
    if !program.grammar().by_address && !program.words.iter().any(|word| calls_cycle(program, word)) {
        return Vec::new(); // most programs of machines measure nothing
    }
    let programs = programs(program);
    let mut walk = Walk {
        program,
        forces: Forces::of(program),
        around: Subprograms::of(program, &programs),
        names: Names::of(program),
        arrays: HashMap::new(),
        tools: Tools { start: control.clone() },
        functions: Functions::of(&control),
        control,
        found: Found::default(),
        first_numbers: HashMap::new(),
        left_on: false,
        passed: 0,
        told,
    };
    if program.grammar().by_address {
        walk.macros(&mut Place::default());
    } else {
        follow(program, &programs, &mut walk);
    }
    let mut sites = walk.finished();
    for site in &mut sites {
        if let Some(found) = of_call(program, site) {
            site.diagnostics = found;
        }
    }
    sites
}

/// What holds at a place of the program.
#[derive(Clone, Debug, Default, PartialEq)]
struct Place {
    force: State,
    values: Values,
}

struct Walk<'a> {
    program: &'a Program,
    forces: Forces<'a>,
    around: Subprograms<'a>,
    names: Names,
    /// Arrays that the program declares, with their sizes.
    arrays: HashMap<String, Vec<usize>>,
    tools: Tools,
    /// By which functions the machine calls the macros of NCT.
    functions: Functions,
    control: Control,
    found: Found,
    /// Worth of right sides on their first pass, where a later one may bring another number, by their first byte.
    first_numbers: HashMap<u32, Option<f64>>,
    /// See [`CallSite::left_on`].
    left_on: bool,
    /// Blocks that were passed.
    passed: usize,
    told: &'a mut dyn FnMut(f64),
}

impl Walk<'_> {
    /// Tells from time to time how far it is; what is passed again is not counted anew.
    fn pass(&mut self) {
        self.passed += 1;
        let all = self.program.blocks.len();
        if self.passed.is_multiple_of(BETWEEN) && self.passed < all {
            (self.told)(self.passed as f64 / all as f64);
        }
    }
}
