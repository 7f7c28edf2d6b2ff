//! The measuring calls of a program, each with the values that count at it.

use super::fold::{self, Known};
use super::tree::{Block, Expr, Program, Word, WordKind};
use super::values::{self, Value};
use crate::catalogue::{self, Cycle, Dialect};
use crate::check::{Typed, check};
use crate::control::{Control, Plane, delivery};
use crate::diagnostic::{Diagnostic, Span};
use std::collections::{BTreeMap, HashMap};

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
    /// Values as a form takes them; a value that is known at run time only is its expression.
    pub values: Typed,
    /// Place of each value, its newest assignment. Values of earlier calls count until they are overwritten.
    pub places: BTreeMap<&'static str, Span>,
    /// Places before this byte belong to an earlier call as well.
    pub own_from: u32,
    /// Working plane at the call.
    pub plane: Plane,
    /// Number of the G function of units in force at the call: 70, 71, 700, 710 (NCT 20, 21).
    pub unit_function: u16,
    /// Findings with their places.
    pub diagnostics: Vec<Diagnostic>,
}

/// Every measuring call, in the order of the text; also those that are skipped or jumped over. The control is a
/// metric one as delivered.
pub fn calls(program: &Program) -> Vec<CallSite> {
    calls_on(program, delivery(program.dialect))
}

/// The same for a program that starts on a control in this state.
pub fn calls_on(program: &Program, control: Control) -> Vec<CallSite> {
    let mut walk = Walk {
        program,
        known: Known::new(),
        unsteady: unsteady(program),
        newest: HashMap::new(),
        own_from: 0,
        control,
        found: Vec::new(),
    };
    for (line, block) in program.blocks.iter().enumerate() {
        for word in program.words_of(block) {
            walk.word(line as u32, block, word);
        }
    }
    walk.found
}

struct Walk<'a> {
    program: &'a Program,
    known: Known,
    /// Variables whose number depends on the way through the program.
    unsteady: HashMap<String, u32>,
    /// Newest value of every variable with its line.
    newest: HashMap<String, (Value, u32)>,
    own_from: u32,
    control: Control,
    found: Vec<CallSite>,
}

/// How often each variable is assigned, if the program can run a line twice; else nothing.
fn unsteady(program: &Program) -> HashMap<String, u32> {
    const BACK: [&str; 6] = ["FOR", "WHILE", "REPEAT", "LOOP", "GOTOB", "GOTO"];
    let repeats = |word: &Word| match word.kind {
        WordKind::Keyword { name, .. } => BACK.iter().any(|keyword| program.is(name, keyword)),
        _ => false,
    };
    let mut counts = HashMap::new();
    if program.words.iter().any(repeats) {
        for word in &program.words {
            if let WordKind::Assign { name, index, .. } = &word.kind
                && let Some(name) = fold::name(program, *name, index, &Known::new())
            {
                *counts.entry(name).or_default() += 1;
            }
        }
    }
    counts.retain(|_, count| *count > 1);
    counts
}

impl Walk<'_> {
    fn word(&mut self, line: u32, block: &Block, word: &Word) {
        match &word.kind {
            WordKind::Assign {
                name,
                index,
                value_span,
                value,
            } => {
                if let Some(name) = fold::name(self.program, *name, index, &self.known) {
                    let elements = elements(self.program, *value);
                    if elements.is_empty() {
                        let value = values::value(self.program, *value, *value_span, &self.known);
                        self.assign(name, value, line);
                    } else {
                        self.assign_elements(&name, &elements, line);
                    }
                }
            }
            WordKind::Declare {
                name,
                index,
                value: Some(value),
            } if index.is_empty() => {
                let name = self.program.name(*name);
                if let Some(number) = fold::number(self.program, *value, &self.known) {
                    self.learn(name, Some(number));
                }
            }
            WordKind::Call { name, .. } => {
                let cycle = self.cycle(&self.program.name(*name));
                if let Some(cycle) = cycle.filter(|_| self.program.dialect == Dialect::Sinumerik) {
                    self.sinumerik(cycle, line, word.span);
                }
                // Any cycle may read the same data, so what stands before it is not this call's own.
                if self
                    .program
                    .text(*name)
                    .get(..5)
                    .is_some_and(|start| start.eq_ignore_ascii_case(b"CYCLE"))
                {
                    self.own_from = word.span.end;
                }
            }
            WordKind::Address { name, value, .. } if self.program.is(*name, "G") => {
                if let Some(Expr::Number(number, _)) = self.program.expr(*value) {
                    modal(&mut self.control, *number);
                    if let Some(cycle) = self
                        .cycle(&format!("G{number}"))
                        .filter(|_| self.program.dialect == Dialect::Nct)
                    {
                        self.nct(cycle, line, block, word.span);
                    }
                }
            }
            _ => {}
        }
    }

    fn cycle(&self, name: &str) -> Option<&'static Cycle> {
        catalogue::find(self.program.dialect, name)
    }

    fn learn(&mut self, name: String, number: Option<f64>) {
        match number.filter(|_| !self.unsteady.contains_key(&name)) {
            Some(number) => {
                self.control.set(name.clone(), number);
                self.known.insert(name, number);
            }
            None => drop(self.known.remove(&name)),
        }
    }

    fn assign(&mut self, name: String, value: Value, line: u32) {
        self.learn(name.clone(), value.number);
        self.newest.insert(name, (value, line));
    }

    /// `_SETV[0]=SET(1,,3)` writes `_SETV[0]` and `_SETV[2]`.
    fn assign_elements(&mut self, name: &str, elements: &[u32], line: u32) {
        let Some((array, first)) = name.trim_end_matches(']').split_once('[') else {
            return;
        };
        let Ok(first) = first.parse::<usize>() else {
            return;
        };
        for (step, id) in elements.iter().enumerate() {
            if matches!(self.program.expr(*id), None | Some(Expr::Omitted(_))) {
                continue;
            }
            if let Some(place) = values::place(self.program, *id) {
                let value = values::value(self.program, *id, place, &self.known);
                self.assign(format!("{array}[{}]", first + step), value, line);
            }
        }
    }

    fn sinumerik(&mut self, cycle: &'static Cycle, line: u32, span: Span) {
        let mut site = self.site(cycle, line, span);
        for param in cycle.params {
            if let Some((value, assigned)) = self.newest.get(param.name) {
                site.values.insert(param.name.into(), value.text.clone());
                site.places.insert(param.name, value.place);
                if value.place.start >= self.own_from {
                    site.first_line = site.first_line.min(*assigned);
                }
            }
        }
        self.finish(site);
    }

    /// The addresses of the block are the values.
    fn nct(&mut self, cycle: &'static Cycle, line: u32, block: &Block, span: Span) {
        let mut site = self.site(cycle, line, span);
        site.own_from = block.span.start;
        for word in self.program.words_of(block) {
            let WordKind::Address { name, value, .. } = &word.kind else {
                continue;
            };
            let Some(param) = cycle
                .params
                .iter()
                .find(|param| self.program.is(*name, param.name))
            else {
                continue;
            };
            let place = Span {
                start: name.end,
                end: word.span.end,
            };
            let value = values::value(self.program, *value, place, &self.known);
            site.values.insert(param.name.into(), value.text);
            site.places.insert(param.name, value.place);
        }
        self.finish(site);
    }

    fn site(&self, cycle: &'static Cycle, line: u32, span: Span) -> CallSite {
        CallSite {
            cycle,
            line,
            first_line: line,
            span,
            values: Typed::new(),
            places: BTreeMap::new(),
            own_from: self.own_from,
            plane: self.control.plane,
            unit_function: self.control.unit_function(),
            diagnostics: Vec::new(),
        }
    }

    fn finish(&mut self, mut site: CallSite) {
        site.diagnostics = check(site.cycle, &site.values, &self.control).diagnostics;
        for finding in &mut site.diagnostics {
            let place = finding.param.and_then(|name| site.places.get(name));
            finding.span = Some(place.copied().unwrap_or(site.span));
        }
        self.found.push(site);
    }
}

/// Elements of `SET(…)` or of a list; none for any other value.
fn elements(program: &Program, value: u32) -> Vec<u32> {
    match program.expr(value) {
        Some(Expr::Call(name, elements)) if program.is(*name, "SET") => elements.to_vec(),
        Some(Expr::List(elements)) => elements.to_vec(),
        _ => Vec::new(),
    }
}

/// Plane and units by the G functions before the call.
fn modal(control: &mut Control, number: f64) {
    if number.fract() != 0.0 || !(0.0..1000.0).contains(&number) {
        return;
    }
    match number as u16 {
        17 => control.plane = Plane::G17,
        18 => control.plane = Plane::G18,
        19 => control.plane = Plane::G19,
        code => drop(control.choose_units(code)),
    }
}
