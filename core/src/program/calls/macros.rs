//! Calls of NCT macros: the addresses of the block are the values.

use super::site::Called;
use super::{Place, Walk};
use crate::catalogue::functions::Calls;
use crate::catalogue::{self, Functions};
use crate::control::{Control, Plane};
use crate::diagnostic::{Diagnostic, Edit, Span};
use crate::entry::Cycle;
use crate::message::Message;
use crate::own;
use crate::program::held::Held;
use crate::syntax::{Block, Program, WordKind, fold};
use std::rc::Rc;

impl Walk<'_> {
    /// Looks through a program block by block.
    pub(super) fn macros(&mut self, place: &mut Place) {
        let program = self.program;
        for block in &program.blocks {
            self.pass();
            let words = program.words_of(block);
            self.data(place, words);
            for word in words {
                let Some(number) = program.literal(word, "G") else { continue };
                modal(&mut self.control, number);
                if let Some((cycle, span)) = self.macro_call(place, number, block, word.span) {
                    self.addressed(place, cycle, block, span);
                }
            }
        }
    }

    /// The macro that a G function calls, G65 by the number at P (C:58), with the place of the words that name it.
    fn macro_call(&self, place: &Place, code: f64, block: &Block, span: Span) -> Option<(&'static Cycle, Span)> {
        if code != 65.0 {
            let cycle = self.functions.cycle(code)?;
            return (!foreign(self.program, cycle, block)).then_some((cycle, span));
        }
        let (named, number) = self.program.words_of(block).iter().find_map(|word| {
            let value = self.program.address(word, "P")?;
            Some((word.span, fold::number(self.program, value, &self.numbers(place))?))
        })?;
        let whole = Span { start: span.start.min(named.start), end: span.end.max(named.end) };
        Some((catalogue::by_program(number)?, whole))
    }

    fn addressed(&mut self, place: &Place, cycle: &'static Cycle, block: &Block, span: Span) {
        let mut given = Vec::new();
        for word in self.program.words_of(block) {
            let WordKind::Address { name, value, .. } = &word.kind else { continue };
            if let Some(param) = cycle.params.iter().find(|param| self.program.is(*name, param.name.as_str())) {
                let value = self.right_side(place, *value);
                given.push((param.name, Held::one(Rc::new(value))));
            }
        }
        self.meet_call(place, &Called { cycle, span, list: None, refused: None }, given);
    }
}

/// Whether a block that names the G function of a macro is no call of it.
fn foreign(program: &Program, cycle: &'static Cycle, block: &Block) -> bool {
    let names = program.words_of(block).iter().filter_map(|word| match &word.kind {
        WordKind::Address { name, .. } => Some(program.name(*name)),
        _ => None,
    });
    let names: Vec<String> = names.collect();
    cycle.is_foreign(names.iter().map(String::as_str))
}

/// What is said of G functions that call a macro on this machine or on another one, at each of them.
pub fn of_functions(program: &Program, functions: &Functions) -> Vec<Diagnostic> {
    let mut found = Vec::new();
    for block in &program.blocks {
        for word in program.words_of(block) {
            let Some(code) = program.literal(word, "G") else { continue };
            let one = match functions.called(code) {
                Some(Calls { cycle, .. }) if foreign(program, cycle, block) => Some(cycle.foreign(&format!("G{code}"))),
                Some(calls) => twice(code, &calls),
                None => elsewhere(program, functions, code, block, word.span),
            };
            found.extend(one.map(|one| one.on(word.span)));
        }
    }
    found
}

/// Two parameters of the machine have the number of the function.
fn twice(code: f64, calls: &Calls) -> Option<Diagnostic> {
    let also = calls.also.as_ref()?;
    let finding = own::NCT_TWICE.finding().text("word", format!("G{code}"));
    Some(finding.text("parameter", &calls.parameter).text("also", also).text("cycle", calls.cycle.name))
}

/// A block that calls a macro as the manual sets the parameters, and none on this machine.
fn elsewhere(program: &Program, functions: &Functions, code: f64, block: &Block, at: Span) -> Option<Diagnostic> {
    let missed = functions.missed(code).filter(|missed| !foreign(program, missed.cycle, block))?;
    let instead = functions.written(missed.cycle);
    let finding = own::NCT_ELSEWHERE.finding().text("word", format!("G{code}")).text("parameter", missed.parameter);
    let write = Message::new("syntax-write").text("value", &instead);
    Some(finding.cured(write, vec![Edit::replace(at, &instead)]))
}

/// Plane and units by the G functions before the call.
fn modal(control: &mut Control, number: f64) {
    if number.fract() != 0.0 || !(0.0..1000.0).contains(&number) {
        return;
    }
    match Plane::of(number as u16) {
        Some(plane) => control.plane = plane,
        None => drop(control.choose_units(number as u16)),
    }
}
