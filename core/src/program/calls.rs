//! The measuring calls of a program, each with the values that count at it.

mod data;

use super::arguments;
use super::block::BETWEEN;
use super::flow::Way;
use super::fold::{self, Known};
use super::tools::Tools;
use super::tree::{Block, Expr, ExprId, Program, Word, WordKind};
use super::values::{self, Value};
use crate::catalogue::{self, Arg, ArgumentList, Cycle, Dialect, Style, list, nct};
use crate::check::{Typed, check};
use crate::control::{Control, Plane, delivery};
use crate::diagnostic::{Diagnostic, Span};
use crate::support::BITS;
use std::collections::{BTreeMap, BTreeSet, HashMap};

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
    /// Parameters whose place gives a value to others too (`REP`), so that it cannot be changed for one of them.
    pub shared: BTreeSet<&'static str>,
    /// The argument list that was called; none: the bare name, or a block of addresses.
    pub list: Option<&'static ArgumentList>,
    /// Places before this byte belong to an earlier call as well.
    pub own_from: u32,
    /// Bits that the control's own support writes with a call, as the program has set them: name, value as text, place.
    pub bits: Vec<(&'static str, String, Span)>,
    /// Working plane at the call.
    pub plane: Plane,
    /// Number of the G function of units in force at the call: 70, 71, 700, 710 (NCT 20, 21).
    pub unit_function: u16,
    /// The ways on which a program comes to it that differ in what is in force.
    pub ways: Vec<Way>,
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
    calls_told(program, control, &mut |_| {})
}

/// The same, telling from time to time which share of the program is looked through.
pub fn calls_told(program: &Program, control: Control, told: &mut dyn FnMut(f64)) -> Vec<CallSite> {
    let mut walk = Walk {
        program,
        known: Known::new(),
        unsteady: fold::unsteady(program),
        newest: HashMap::new(),
        arrays: HashMap::new(),
        own_from: 0,
        tools: Tools::of(program, &control),
        control,
        found: Vec::new(),
    };
    for (line, block) in program.blocks.iter().enumerate() {
        for word in program.words_of(block) {
            walk.word(line as u32, block, word);
        }
        if line % BETWEEN == BETWEEN - 1 {
            told(line as f64 / program.blocks.len() as f64);
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
    /// Arrays that the program declares, with their sizes.
    arrays: HashMap<String, Vec<usize>>,
    own_from: u32,
    tools: Tools,
    control: Control,
    found: Vec<CallSite>,
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
                    self.write(name, *value, *value_span, line);
                }
            }
            WordKind::Declare { name, index, value } => self.declare(*name, index, *value, line),
            WordKind::Call { name, args, .. } => {
                let start = self.program.text(*name).get(..5);
                if start.is_some_and(|start| start.eq_ignore_ascii_case(b"CYCLE")) {
                    self.call(line, word.span, *name, args);
                }
            }
            WordKind::Address { name, value, .. } if self.program.is(*name, "G") => {
                if let Some(Expr::Number(number, _)) = self.program.expr(*value) {
                    modal(&mut self.control, *number);
                    if let Some((cycle, span)) = self.macro_call(*number, block, word.span) {
                        self.nct(cycle, line, block, span);
                    }
                }
            }
            _ => {}
        }
    }

    /// The NCT macro that a G function calls: by its own number, or G65 by the program number at P (C:58). With the
    /// place of the words that name it.
    fn macro_call(&self, code: f64, block: &Block, span: Span) -> Option<(&'static Cycle, Span)> {
        if self.program.dialect != Dialect::Nct {
            return None;
        }
        if code != 65.0 {
            return Some((self.cycle(&format!("G{code}"))?, span));
        }
        let words = self.program.words_of(block).iter();
        let (place, number) = words.into_iter().find_map(|word| match &word.kind {
            WordKind::Address { name, value, .. } if self.program.is(*name, "P") => {
                Some((word.span, fold::number(self.program, *value, &self.known)?))
            }
            _ => None,
        })?;
        let named = Span {
            start: span.start.min(place.start),
            end: span.end.max(place.end),
        };
        Some((nct::by_program(number)?, named))
    }

    /// A call of any cycle. Each may read the same data, so what stands before it is not the next call's own.
    fn call(&mut self, line: u32, span: Span, name: Span, args: &[Option<ExprId>]) {
        let name = self.program.name(name);
        let arguments: Vec<Option<Value>> = arguments::places(self.program, span)
            .into_iter()
            .enumerate()
            .map(|(index, place)| {
                let id = args.get(index).copied().flatten()?;
                Some(values::value(self.program, id, place, &self.known))
            })
            .collect();
        if name == list::AUXILIARY {
            return self.auxiliary(line, arguments);
        }
        let number = |index: usize| arguments.get(index)?.as_ref()?.number;
        let listed = (!arguments.is_empty())
            .then(|| list::called(self.program.dialect, &name, number))
            .flatten();
        if let Some((cycle, list)) = listed {
            self.listed(cycle, list, line, span, &arguments);
        } else if let Some(cycle) = self.cycle(&name) {
            self.sinumerik(cycle, line, span, None);
        }
        self.own_from = span.end;
    }

    /// `CYCLE_PARA`: what is not 0 goes into the data (B:11734).
    fn auxiliary(&mut self, line: u32, arguments: Vec<Option<Value>>) {
        for (name, value) in list::AUXILIARY_ARGS.iter().zip(arguments) {
            if let Some(value) = value.filter(|value| value.number != Some(0.0)) {
                self.assign((*name).to_owned(), value, line);
            }
        }
    }

    fn listed(
        &mut self,
        cycle: &'static Cycle,
        list: &'static ArgumentList,
        line: u32,
        span: Span,
        arguments: &[Option<Value>],
    ) {
        let mut values = arguments::given(cycle, list, span, arguments);
        if list.style == Style::Indirect {
            // The called program puts every argument into the data, also those that are omitted.
            for (name, value) in values {
                self.assign(name.to_owned(), value, line);
            }
            return self.sinumerik(cycle, line, span, Some(list));
        }
        for (arg, value) in list.args.iter().zip(arguments) {
            if let (Arg::Variable(array), Some(value)) = (arg, value) {
                self.elements_of(cycle, array, &value.text.to_ascii_uppercase(), &mut values);
            }
        }
        if list.style == Style::Direct {
            let beside = cycle.params.iter().filter(|param| !list.gives(param.name));
            let assigned =
                beside.filter_map(|param| Some((param.name, self.newest.get(param.name)?)));
            values.extend(assigned.map(|(name, (value, _))| (name, value.clone())));
        }
        let mut site = self.site(cycle, line, span);
        site.list = Some(list);
        for (name, value) in values
            .into_iter()
            .filter(|(_, value)| !value.text.is_empty())
        {
            if value.place.start >= self.own_from {
                let assigned = self.program.line_of(value.place.start);
                site.first_line = site.first_line.min(assigned);
            }
            site.values.insert(name.into(), value.text);
            site.places.insert(name, value.place);
        }
        self.finish(site);
    }

    /// The parameters that are elements of a variable of the program.
    fn elements_of(
        &self,
        cycle: &'static Cycle,
        array: &str,
        variable: &str,
        found: &mut Vec<(&'static str, Value)>,
    ) {
        for param in cycle.params {
            let element = param
                .name
                .strip_prefix(array)
                .filter(|rest| rest.starts_with('['));
            let value = element.and_then(|rest| self.newest.get(&format!("{variable}{rest}")));
            found.extend(value.map(|(value, _)| (param.name, value.clone())));
        }
    }

    fn cycle(&self, name: &str) -> Option<&'static Cycle> {
        catalogue::find(self.program.dialect, name)
    }

    fn sinumerik(
        &mut self,
        cycle: &'static Cycle,
        line: u32,
        span: Span,
        list: Option<&'static ArgumentList>,
    ) {
        let mut site = self.site(cycle, line, span);
        site.list = list;
        for param in cycle.params {
            if let Some((value, assigned)) = self.newest.get(param.name) {
                site.values.insert(param.name.into(), value.text.clone());
                site.places.insert(param.name, value.place);
                if value.shared {
                    site.shared.insert(param.name);
                }
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
            shared: BTreeSet::new(),
            list: None,
            own_from: self.own_from,
            bits: self.bits(),
            plane: self.control.plane,
            unit_function: self.control.unit_function(),
            ways: Vec::new(),
            diagnostics: Vec::new(),
        }
    }

    fn bits(&self) -> Vec<(&'static str, String, Span)> {
        let set = |name: &'static str| {
            let (value, _) = self.newest.get(name)?;
            Some((name, value.text.clone(), value.place))
        };
        BITS.into_iter().filter_map(set).collect()
    }

    fn finish(&mut self, mut site: CallSite) {
        site.ways = self.tools.ways(site.span.start);
        for way in &mut site.ways {
            way.tool = self.tools.use_at(&mut self.control, &way.state);
            site.plane = self.control.plane;
            let found = check(site.cycle, &site.values, &self.control).diagnostics;
            let found = found
                .into_iter()
                .filter(|one| self.tools.told(&self.control, one.code));
            for one in found {
                if !site.diagnostics.contains(&one) {
                    site.diagnostics.push(one);
                }
            }
        }
        if site.ways.is_empty() {
            site.diagnostics = check(site.cycle, &site.values, &self.control).diagnostics;
        }
        for finding in &mut site.diagnostics {
            let place = finding.param.and_then(|name| site.places.get(name));
            finding.span = Some(place.copied().unwrap_or(site.span));
        }
        self.found.push(site);
    }
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
