//! The fields of a call in the list of a newer control: what the list has an argument for, in its words and numbers.

use super::codes;
use super::fields::{Entry, Field, fields};
use crate::catalogue::newer::arguments::Argument;
use crate::check::{self, newer};
use crate::control::Control;
use crate::entry::{ArgumentList, Cycle, Inputs, Kind, Param, ProbeUse, Topic, Typed, Unit, names, unit_name};
use crate::manual::Cited;
use crate::message::Message;
use crate::name::Name;
use crate::range::Range;

/// Reasons of the older control that say what counts for an omitted value.
const OMITTED: [&str; 7] = [
    "need-default", "need-tolerance", "need-distortion", "need-memory", "need-memory-empirical", "need-offset-edge",
    "need-start-angle-spindle",
];

/// A form in a list.
pub struct Listed {
    /// Cycle.
    pub cycle: &'static Cycle,
    /// Its list.
    pub list: &'static ArgumentList,
    /// Whether a program has the call: a new one is written with the defaults that the form shows.
    pub written: bool,
}

/// The fields of a call of a program in such a list.
pub fn fields_of_call(
    cycle: &'static Cycle,
    list: &'static ArgumentList,
    typed: &Typed,
    control: &Control,
) -> Vec<Field> {
    Listed { cycle, list, written: true }.fields(fields(cycle, typed, control), typed, control)
}

impl Listed {
    /// The fields of the list, from those that the cycle has on the older control.
    pub fn fields(&self, mut fields: Vec<Field>, typed: &Typed, control: &Control) -> Vec<Field> {
        // a value without an argument is shown, so that the form can say that it is not written
        fields.retain(|field| self.list.position(field.name).is_some() || !field.value.trim().is_empty());
        let inputs = check::read(self.cycle, typed, control, &mut Vec::new());
        for field in &mut fields {
            self.suit(field, &inputs);
        }
        let all = Argument::all(self.list).filter(|argument| !argument.is_open());
        let hidden = all.filter_map(|one| Some((one, self.cycle.param(one.param?.as_str())?)));
        let hidden: Vec<Field> = hidden
            .filter(|(_, param)| fields.iter().all(|field| field.name != param.name))
            .map(|(argument, param)| self.hidden(&argument, param, &inputs, typed, control))
            .collect();
        fields.extend(hidden);
        fields.extend(beside(self.list, typed, control));
        for field in &mut fields {
            field.source = Cited(self.list.source); // what stands there and what an omitted one is, is known from it
        }
        name_arguments(self.list, &mut fields);
        fields
    }

    /// A field of the older control in the words and numbers of the list.
    fn suit(&self, field: &mut Field, inputs: &Inputs) {
        let argument = Argument::all(self.list).find(|argument| argument.param == Some(field.name));
        if field.chooses {
            field.entry = match argument.is_some_and(|argument| argument.is_open()) {
                true => Entry::Integer { range: Range::ANY },
                false => Entry::Choice { choices: codes::known_variants(self.cycle, self.list) },
            };
            return;
        }
        // omitted in a call it is 0, which alarm 61308 refuses
        let path = self.written && field.name == names::FA;
        field.required = path || field.required && newer::is_needed(field.name);
        if OMITTED.contains(&&*field.reason.key) {
            let writes = !self.written && !newer::is_unsaid(field.name, inputs);
            let usual = argument.as_ref().and_then(|argument| argument.usual().parse().ok());
            field.fallback = usual.or(field.fallback).filter(|number| writes && *number != 0.0);
            let default = field.fallback.is_some();
            field.reason = Message::new(if default { "need-listed" } else { "need-omitted" });
        }
        if field.name == names::KNUM {
            field.code = None;
            field.entry = Entry::Choice { choices: codes::newer_zero_offsets() };
            field.label = Message::new("argument-zero");
            field.help = Message::new("argument-zero-help");
            field.reason = Message::new("need-omitted");
        }
        if field.name == names::PRNUM {
            let tool = self.cycle.purpose.probe != ProbeUse::Workpiece;
            let most = if tool { newer::TOOL_PROBES } else { newer::PROBES };
            field.entry = Entry::Integer { range: Range::closed(1.0, most) };
            field.label = Message::new(if tool { "argument-tool-probe" } else { "argument-probe" });
            field.help = Message::new(if tool { "argument-tool-probe-help" } else { "argument-probe-help" });
        }
    }

    /// An argument that has a counterpart which the variant does not use on the older control.
    fn hidden(
        &self,
        argument: &Argument,
        param: &'static Param,
        inputs: &Inputs,
        typed: &Typed,
        control: &Control,
    ) -> Field {
        // of a call that is not written yet a value of the older form would come back here from another variant
        let name = if self.written { param.name } else { Name::new(argument.name) };
        let entry = match param.kind {
            Kind::Text(_) => Entry::Text { columns: None },
            Kind::Integer | Kind::Digits(_) => Entry::Integer { range: Range::ANY },
            _ => Entry::Real { range: Range::ANY },
        };
        let unit = unit_name(param.unit_with(inputs), control);
        Field { name, entry, unit, ..plain(argument, typed.get(name.as_str())) }
    }
}

/// The fields of what only the list of a newer control asks for; what is kept as written has one where it is written.
pub(crate) fn beside(list: &'static ArgumentList, typed: &Typed, control: &Control) -> Vec<Field> {
    let written = |argument: &Argument| typed.get(argument.key()).is_some_and(|text| !text.trim().is_empty());
    let all = Argument::all(list).filter(|one| one.param.is_none() && !one.key().is_empty());
    let all = all.filter(|one| one.is_field() || written(one));
    all.map(|argument| argument_field(&argument, typed, control)).collect()
}

/// Says of each field which argument of the list it is.
pub(crate) fn name_arguments(list: &'static ArgumentList, fields: &mut [Field]) {
    for argument in Argument::all(list).filter(|one| !one.name.is_empty()) {
        let taken = |field: &&mut Field| argument.param == Some(field.name) || field.name == argument.name;
        let Some(field) = fields.iter_mut().find(taken) else { continue };
        let key = if argument.screen().is_empty() { "argument-shown" } else { "argument-shown-screen" };
        let message = Message::new(key).number("place", argument.place as f64).text("name", argument.name);
        field.argument = Some(message.text("screen", argument.screen()));
    }
}

/// What an argument without counterpart takes.
pub fn argument_entry(name: &str) -> Entry {
    match name {
        newer::DIRECTION => Entry::Choice { choices: codes::choices(DIRECTIONS) },
        _ => Entry::Real { range: Range::ANY },
    }
}

fn argument_field(argument: &Argument, typed: &Typed, control: &Control) -> Field {
    let unit = match argument.name {
        "S_STA1" => Unit::Degree,
        "S_XM" | "S_YM" => Unit::ActiveLength,
        _ => Unit::None,
    };
    Field {
        entry: argument_entry(argument.name),
        unit: unit_name(unit, control),
        reason: Message::new(if argument.is_open() { "argument-open" } else { "argument-values" }),
        ..plain(argument, typed.get(argument.key()))
    }
}

/// An argument as a field in the section of the list.
fn plain(argument: &Argument, value: Option<&String>) -> Field {
    let meaning = argument.meaning();
    Field {
        name: Name::new(argument.key()),
        help: Message::new(format!("{meaning}-help")),
        label: Message::new(meaning),
        topic: Topic::List,
        entry: Entry::Real { range: Range::ANY },
        value: value.cloned().unwrap_or_default(),
        expression: None,
        written: None,
        chooses: false,
        code: None,
        fallback: None,
        unit: "",
        required: false,
        reason: Message::new("need-omitted"),
        argument: None,
        source: Cited(""),
        concept: None,
    }
}

/// Measuring directions in these lists.
const DIRECTIONS: &[(i64, &str)] = &[(1, "argument-direction-plus"), (2, "argument-direction-minus")];

#[cfg(all(test, feature = "cli"))]
mod tests {
    use super::*;
    use crate::catalogue::CYCLES;
    use crate::catalogue::example::example;
    use crate::control::delivery;
    use crate::dialect::Dialect;
    use crate::entry::Style;
    use crate::words::Words;

    /// The form of each variant of each list, of a call of a program and of a new one, with its worked values.
    fn all(mut look: impl FnMut(&Listed, &[Field])) {
        let control = delivery(Dialect::Sinumerik);
        for cycle in CYCLES {
            let Some(list) = cycle.lists.iter().find(|list| list.style == Style::Operate) else { continue };
            for variant in cycle.variants {
                let typed = example(cycle, variant);
                for written in [true, false] {
                    let listed = Listed { cycle, list, written };
                    let fields = listed.fields(fields(cycle, &typed, &control), &typed, &control);
                    look(&listed, &fields);
                }
            }
        }
    }

    // oracle: self (what a call can say, its form can change; what it cannot say, nobody has to enter)
    #[test]
    fn each_known_argument_has_one_field_and_nothing_else_is_required() {
        all(|Listed { list, .. }, fields| {
            for argument in Argument::all(list).filter(|one| !one.is_open() || one.param.is_some()) {
                let own = |field: &&Field| field.name == argument.name || argument.param == Some(field.name);
                let mode = matches!(argument.name, "_DMODE" | "_AMODE");
                let few = argument.param.is_none() && !argument.is_field();
                let count = fields.iter().filter(own).count();
                assert_eq!(count, usize::from(!mode && !few), "{} {}", list.name, argument.name);
            }
            let required = fields.iter().filter(|field| field.required && list.position(field.name).is_none());
            assert_eq!(required.count(), 0, "{}", list.name);
        });
    }

    // oracle: peer (an omitted argument is 0; argument 2 takes zero offsets; a probe has a number from 1)
    #[test]
    fn no_word_of_a_field_is_of_the_older_control() {
        let english = Words::english();
        all(|Listed { list, .. }, fields| {
            for field in fields {
                let reason = english.text(&field.reason);
                let earlier = reason.contains("earlier") && field.reason.key != "need-omitted";
                assert!(!earlier, "{} {}: {reason}", list.name, field.name);
                let digits = field.name == names::KNUM || field.name == names::PRNUM || field.chooses;
                assert!(!digits || !matches!(field.entry, Entry::Digits { .. }), "{} {}", list.name, field.name);
                if let Entry::Choice { choices } = &field.entry {
                    let tool = choices.iter().find(|one| field.chooses && one.label.key.ends_with("-tool"));
                    assert_eq!(tool, None, "{}", list.name);
                }
            }
        });
    }
}
