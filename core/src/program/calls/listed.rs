//! Calls of SINUMERIK cycles: by their name alone, or with arguments.

use super::site::Called;
use super::{Place, Walk};
use crate::catalogue;
use crate::catalogue::list;
use crate::check::listed::{count, refused};
use crate::diagnostic::Span;
use crate::entry::{AUXILIARY, AUXILIARY_ARGS, Arg, ArgumentList, Cycle, Style};
use crate::name::Name;
use crate::program::arguments;
use crate::program::held::Held;
use crate::program::values::Value;
use crate::syntax::tree::ExprId;
use std::rc::Rc;

/// Values of a call by the names of its parameters.
pub(super) type Given = Vec<(Name, Held)>;

impl Walk<'_> {
    /// A call of any cycle.
    pub(super) fn cycle(&mut self, place: &mut Place, span: Span, name: Span, args: &[Option<ExprId>]) {
        let name = self.program.name(name);
        let arguments: Vec<Option<Value>> = arguments::places(self.program, span)
            .into_iter()
            .enumerate()
            .map(|(index, at)| {
                let id = args.get(index).copied().flatten()?;
                Some(self.value(place, id, at))
            })
            .collect();
        if name == AUXILIARY {
            return self.auxiliary(place, arguments);
        }
        let number = |index: usize| arguments.get(index)?.as_ref()?.number;
        let listed = list::called(self.program.dialect, &name, arguments.len(), number);
        let cycle = match listed {
            Some((cycle, _)) => Some(cycle),
            None => catalogue::find(self.program.dialect, &name),
        };
        let Some(cycle) = cycle else { return };
        let list = listed.map(|(_, list)| list);
        let written = |index: usize| {
            let value = arguments.get(index).and_then(Option::as_ref);
            value.map_or(Some(0.0), |value| value.number)
        };
        let called = Called { list, refused: refused(cycle, list, count(&arguments), written) };
        match list {
            Some(list) => self.listed(place, cycle, (list, &called), span, &arguments),
            None => self.meet_call(place, cycle, span, &called, self.assigned(place, cycle)),
        }
    }

    /// `CYCLE_PARA`: what is not 0 goes into the data (B:11734).
    fn auxiliary(&mut self, place: &mut Place, arguments: Vec<Option<Value>>) {
        for (name, value) in AUXILIARY_ARGS.iter().zip(arguments) {
            if let Some(value) = value.filter(|value| value.number != Some(0.0)) {
                self.assign(place, name, value);
            }
        }
    }

    fn listed(
        &mut self,
        place: &mut Place,
        cycle: &'static Cycle,
        (list, called): (&'static ArgumentList, &Called),
        span: Span,
        arguments: &[Option<Value>],
    ) {
        let values = arguments::given(cycle, list, span, arguments);
        if list.style == Style::Indirect {
            // The called program puts every argument into the data, also those that are omitted.
            for (name, value) in values {
                self.assign(place, name.as_str(), value);
            }
            let assigned = self.assigned(place, cycle);
            return self.meet_call(place, cycle, span, called, assigned);
        }
        let values = values.into_iter().filter(|(_, value)| !value.text.is_empty());
        let mut given: Given = values.map(|(name, value)| (name, Held::One(Rc::new(value)))).collect();
        for (arg, value) in list.args.iter().zip(arguments) {
            if let (Arg::Variable(array), Some(value)) = (arg, value) {
                let variable = value.text.to_ascii_uppercase();
                self.elements_of(place, cycle, array, &variable, &mut given);
            }
        }
        if list.style == Style::Direct {
            given.extend(self.assigned(place, cycle).into_iter().filter(|(name, _)| !list.gives(*name)));
        }
        self.meet_call(place, cycle, span, called, given);
    }

    /// The parameters that are elements of a variable of the program.
    fn elements_of(&self, place: &Place, cycle: &'static Cycle, array: &str, variable: &str, found: &mut Given) {
        for param in cycle.params {
            let element = param.name.strip_prefix(array).filter(|rest| rest.starts_with('['));
            let held = element.and_then(|rest| self.newest(place, &format!("{variable}{rest}")));
            found.extend(held.map(|held| (param.name, held)));
        }
    }

    /// The values that the data of a cycle hold.
    fn assigned(&self, place: &Place, cycle: &'static Cycle) -> Given {
        cycle.params.iter().filter_map(|param| Some((param.name, self.newest(place, param.name.as_str())?))).collect()
    }

    pub(super) fn newest(&self, place: &Place, name: &str) -> Option<Held> {
        place.values.get(self.names.find(name)?).cloned()
    }
}
