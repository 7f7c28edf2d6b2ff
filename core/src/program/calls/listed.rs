//! Calls of SINUMERIK cycles: by their name alone, or with arguments.

use super::site::Called;
use super::{Place, Walk};
use crate::catalogue;
use crate::catalogue::list;
use crate::check::listed::{count, numbers_for_variables, refused};
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
    pub(super) fn cycle(&mut self, place: &mut Place, span: Span, name: Span, args: &[ExprId]) {
        let name = self.program.name(name);
        let given = args.iter().map(|id| self.program.given(*id));
        let arguments: Vec<_> = given.map(|id| Some(self.value(place, id?))).collect();
        if name == AUXILIARY {
            return self.auxiliary(place, arguments);
        }
        let number = |index: usize| arguments.get(index)?.as_ref()?.number;
        let (cycle, list) = match list::called(self.program.dialect, &name, arguments.len(), number) {
            Some((cycle, list)) => (Some(cycle), Some(list)),
            None => (catalogue::find(self.program.dialect, &name), None),
        };
        let Some(cycle) = cycle else { return };
        // as it is written: a variable may hold a number
        let numbers = args.iter().map(|id| self.program.number(*id).is_some());
        let refused = list
            .and_then(|list| numbers_for_variables(list, numbers))
            .or_else(|| refused(cycle, list, count(&arguments), |index| arguments::number(&arguments, index)));
        let called = Called { cycle, span, list, refused };
        let given = match list {
            Some(list) => self.listed(place, &called, list, &arguments),
            None => self.assigned(place, cycle),
        };
        self.meet_call(place, &called, given);
    }

    /// `CYCLE_PARA`: what is not 0 goes into the data (B:11734).
    fn auxiliary(&mut self, place: &mut Place, arguments: Vec<Option<Value>>) {
        for (name, value) in AUXILIARY_ARGS.iter().zip(arguments) {
            if let Some(value) = value.filter(|value| value.number != Some(0.0)) {
                self.assign(place, name, value);
            }
        }
    }

    /// The values of a call with arguments.
    fn listed(
        &mut self,
        place: &mut Place,
        call: &Called,
        list: &'static ArgumentList,
        arguments: &[Option<Value>],
    ) -> Given {
        let cycle = call.cycle;
        let values = arguments::given(cycle, list, call.span, arguments);
        if list.style == Style::Indirect {
            // The called program puts every argument into the data, also those that are omitted.
            for (name, value) in values {
                self.assign(place, name.as_str(), value);
            }
            return self.assigned(place, cycle);
        }
        let values = values.into_iter().filter(|(_, value)| !value.text.is_empty());
        let mut given: Given = values.map(|(name, value)| (name, Held::one(Rc::new(value)))).collect();
        for (arg, value) in list.args.iter().zip(arguments) {
            if let (Arg::Variable(array), Some(value)) = (arg, value) {
                self.elements_of(place, cycle, array, &value.text.to_ascii_uppercase(), &mut given);
            }
        }
        if list.style == Style::Direct {
            given.extend(self.assigned(place, cycle).into_iter().filter(|(name, _)| !list.gives(*name)));
        }
        given
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
