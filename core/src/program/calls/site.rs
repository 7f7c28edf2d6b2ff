//! What is known of a call after each way to it, and after all of them.

use super::listed::Given;
use super::sorts::of_wrong_sort;
use super::{CallSite, Origin, Place, Walk, Way};
use crate::check::{check, newer, upkeep};
use crate::control::Control;
use crate::diagnostic::{Diagnostic, Span};
use crate::entry::{ArgumentList, Cycle, Typed};
use crate::name::Name;
use crate::own;
use crate::program::held::Held;
use crate::program::values::Value;
use crate::support::BITS;
use crate::syntax::Program;
use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::rc::Rc;

/// A call of a cycle.
pub(super) struct Called {
    pub cycle: &'static Cycle,
    pub span: Span,
    /// The list; none: the bare name, or a block of addresses.
    pub list: Option<&'static ArgumentList>,
    /// Why the control refuses the arguments.
    pub refused: Option<Diagnostic>,
}

/// The calls that were met.
#[derive(Default)]
pub(super) struct Found {
    /// In the order in which they were met first.
    met: Vec<Met>,
    /// Places of the calls in `met`, by their first byte.
    at: HashMap<u32, usize>,
    /// The call that first takes a value, by its first byte, by that of the value.
    takers: HashMap<u32, u32>,
    ways: usize,
}

/// A call, and what arrives at it on all ways so far.
struct Met {
    site: CallSite,
    given: Given,
}

impl Walk<'_> {
    /// A way comes to a measuring call with these values.
    pub(super) fn meet_call(&mut self, place: &Place, called: &Called, given: Given) {
        let span = called.span;
        let shown = |(name, held): &(Name, Held)| (name.to_string(), shown(self.program, name, held));
        let values: Typed = given.iter().map(shown).collect();
        let mut found = std::mem::take(&mut self.found);
        if self.around.several() {
            for value in given.iter().flat_map(|(_, held)| held.all()) {
                found.takers.entry(value.source().start).or_insert(span.start);
            }
        }
        let index = *found.at.entry(span.start).or_insert(found.met.len());
        if index == found.met.len() {
            let site = self.first(place, called, &given, values.clone());
            found.met.push(Met { site, given: given.clone() });
        }
        if let Some(Met { site, given: known }) = found.met.get_mut(index) {
            self.way(site, &mut found.ways, place, values, &given, called.refused.as_ref());
            overwritten(site, &given, self.around.unit(span));
            also(site, known, &given);
        }
        self.found = found;
    }

    /// The first way to a call.
    fn first(&mut self, place: &Place, called: &Called, given: &Given, values: Typed) -> CallSite {
        let Called { cycle, span, list, .. } = *called;
        let line = self.program.line_of(span.start);
        let mut site = CallSite {
            cycle,
            line,
            first_line: line,
            span,
            values,
            expressions: Typed::new(),
            missing: BTreeMap::new(),
            places: BTreeMap::new(),
            origins: BTreeMap::new(),
            first: BTreeMap::new(),
            sometimes: BTreeSet::new(),
            shared: BTreeSet::new(),
            list,
            own_from: self.own_from(span, line),
            behind: self.around.behind(span),
            bits: self.bits(place),
            plane: self.control.plane,
            transverse: self.control.transverse,
            unit_function: self.control.unit_function(),
            left_on: false,
            ways: Vec::new(),
            overwritten: Vec::new(),
            diagnostics: Vec::new(),
        };
        let unit = self.around.unit(span);
        for (name, held) in given {
            if let Some(at) = held.common(|value| value.place) {
                site.places.insert(*name, at);
                if at.start >= site.own_from && at.start < unit.end {
                    site.first_line = site.first_line.min(self.program.line_of(at.start));
                }
            }
            if held.all().iter().any(|value| value.shared) {
                site.shared.insert(*name);
            }
        }
        site
    }

    /// On NCT the block alone gives the values.
    fn own_from(&self, span: Span, line: u32) -> u32 {
        match self.program.blocks.get(line as usize) {
            Some(block) if self.program.grammar().by_address => block.span.start,
            _ => self.around.own_from(span),
        }
    }

    /// Checks the values of a way with what is active on it.
    fn way(
        &mut self,
        site: &mut CallSite,
        ways: &mut usize,
        place: &Place,
        values: Typed,
        given: &Given,
        refused: Option<&Diagnostic>,
    ) {
        let known = site.ways.iter().any(|way| way.state == place.force && *site.values_on(way) == values);
        // The same values may be written somewhere else.
        let mut held = given.iter().flat_map(|(_, held)| held.all());
        if known && !held.any(|value| value.argument) {
            return;
        }
        let by_address = self.program.grammar().by_address;
        let tool = if by_address { None } else { self.tools.use_at(&mut self.control, &place.force) };
        site.plane = self.control.plane;
        site.transverse = self.control.transverse;
        site.unit_function = self.control.unit_function();
        let found = match refused {
            Some(finding) => vec![finding.clone()],
            None => {
                let of_wrong_sort = of_wrong_sort(self.program, site.cycle, given);
                checked(site, &values, given, &self.control).into_iter().chain(of_wrong_sort).collect()
            }
        };
        for mut one in found {
            if !self.tools.told(&self.control, one.code) {
                continue;
            }
            one.span = one.span.or(Some(site.span));
            if !site.diagnostics.contains(&one) {
                site.diagnostics.push(one);
            }
        }
        upkeep::settle(&mut self.control, site.cycle);
        if !by_address && !known {
            site.ways.push(Way {
                order: *ways,
                state: place.force.clone(),
                tool,
                values: (values != site.values).then_some(values),
            });
            *ways += 1;
        }
    }

    fn bits(&self, place: &Place) -> Vec<(&'static str, String, Span)> {
        let set = |name: &'static str| {
            self.newest(place, name)?.all().first().map(|value| (name, value.text.clone(), value.place))
        };
        BITS.into_iter().filter_map(set).collect()
    }

    /// All calls in the order of the text, once every way was followed.
    pub(super) fn finished(self) -> Vec<CallSite> {
        let Found { met, takers, .. } = self.found;
        let mut finished: Vec<CallSite> = Vec::with_capacity(met.len());
        let mut told = BTreeSet::new();
        for Met { mut site, given } in met {
            site.left_on = self.left_on;
            // What a call took was of use, and what the first call behind misses is told there.
            let mut missed = |start| !takers.contains_key(&start) && told.insert(start);
            site.overwritten.retain(|(_, before, _)| missed(before.start));
            let unit = self.around.unit(site.span);
            for (name, held) in &given {
                let all = held.all();
                site.sometimes.extend((!held.always()).then_some(*name));
                let own = |source: u32| {
                    let taker = takers.get(&source) == Some(&site.span.start);
                    taker || !self.around.several() && source >= site.own_from
                };
                let origin = |value: &Rc<Value>| Origin {
                    text: value.text.clone(),
                    place: value.source(),
                    argument: value.argument,
                    own: own(value.source().start),
                };
                let mut origins: Vec<Origin> = all.iter().map(origin).collect();
                let first = arrives_first(held, &self.first_numbers, origin);
                site.first.extend(first.map(|first| (*name, first)));
                site.expressions.extend(expression(held).map(|text| (name.to_string(), text)));
                let missing = held.common(|value| &value.missing).and_then(Option::clone);
                site.missing.extend(missing.map(|variable| (*name, variable)));
                if all.len() < 2 && all.iter().all(|value| unit.holds(value.source())) {
                    continue;
                }
                if all.len() > 1 {
                    let text = shown(self.program, name, held);
                    if site.values.get(name.as_str()) != Some(&text) {
                        keep(&mut site);
                        site.values.insert((*name).to_string(), text);
                    }
                    if held.common(|value| value.place).is_none() {
                        site.places.remove(name);
                    }
                }
                origins.sort_by_key(|origin| origin.place.start);
                site.origins.insert(*name, origins);
            }
            finished.push(site);
        }
        finished.sort_by_key(|site| site.span.start);
        finished
    }
}

/// Of values that differ by the way or the pass, the one that arrives first; `numbers` are those of the first pass.
fn arrives_first(
    held: &Held,
    numbers: &HashMap<u32, Option<f64>>,
    origin: impl Fn(&Rc<Value>) -> Origin,
) -> Option<Origin> {
    let first = held.all().first()?;
    if let (None, Some(Some(number))) = (first.number, numbers.get(&first.place.start)) {
        return Some(Origin { text: number.to_string(), ..origin(first) });
    }
    held.common(|value| &value.text).is_none().then(|| origin(first))
}

/// Another way to a call: what the first one does not give, no form shows.
fn also(site: &mut CallSite, known: &mut Given, given: &Given) {
    let new = given.iter().filter(|(name, _)| known.iter().all(|(other, _)| other != name));
    site.sometimes.extend(new.map(|(name, _)| *name));
    for (name, held) in known {
        match given.iter().find(|(other, _)| other == name) {
            Some((_, other)) => *held = held.meet(other),
            None => *held = held.sometimes(),
        }
    }
}

/// The ways keep the values that they have before those of the call change.
fn keep(site: &mut CallSite) {
    for way in site.ways.iter_mut().filter(|way| way.values.is_none()) {
        way.values = Some(site.values.clone());
    }
}

/// What a form shows where one of these arrives.
fn shown(program: &Program, name: &str, held: &Held) -> String {
    match (held.common(|value| &value.text), held.common(|value| value.place)) {
        (Some(text), _) => text.clone(),
        (None, Some(place)) => program.written(place).trim().to_owned(),
        (None, None) => name.to_owned(),
    }
}

/// The expression whose worth these are, where they are written in one place and worth the same.
fn expression(held: &Held) -> Option<String> {
    held.common(|value| (value.place, &value.text))?;
    held.all().first()?.expression.clone()
}

/// Findings about the values of a way, each at its value. Of several that may arrive each is checked by itself.
fn checked(site: &CallSite, values: &Typed, given: &Given, control: &Control) -> Vec<Diagnostic> {
    let findings = |values: &Typed| match site.newer_list() {
        Some(list) => {
            let values = newer::with_omitted(site.cycle, values);
            newer::check_listed(site.cycle, list, &values, control).diagnostics
        }
        None => check(site.cycle, values, control).diagnostics,
    };
    let mut found = findings(values);
    for one in &mut found {
        let held = one.param.and_then(|name| given.iter().find(|(other, _)| *other == name));
        let value = held.and_then(|(_, held)| held.all().last());
        one.span = value.map(|value| value.written_at());
    }
    for (name, held) in given.iter().filter(|(_, held)| held.all().len() > 1) {
        let all = held.all();
        if all.iter().all(|value| value.number.is_some()) {
            found.retain(|one| one.code != own::EXPRESSION.code() || one.param != Some(*name));
        }
        for value in all {
            let mut values = values.clone();
            values.insert((*name).to_string(), value.text.clone());
            let alone = findings(&values).into_iter();
            let alone = alone.filter(|one| one.param == Some(*name) && one.code != own::EXPRESSION.code());
            found.extend(alone.map(|one| one.on(value.written_at())));
        }
    }
    found
}

/// The assignments of this program that a called one took the place of.
fn overwritten(site: &mut CallSite, given: &Given, unit: Span) {
    for (name, held) in given {
        for value in held.all() {
            let Some((before, call)) = value.instead else { continue };
            let known = site.overwritten.iter().any(|(other, ..)| other == name);
            if unit.holds(before) && before.end <= site.span.start && !known {
                site.overwritten.push((*name, before, call));
            }
        }
    }
}
