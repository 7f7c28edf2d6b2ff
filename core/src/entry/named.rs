//! An entry that speaks of a parameter which it does not have does not compile: the catalogue looks through all of
//! them while it is built.

use super::{ArgumentList, Cycle, Kind, Param, When};
use crate::name::Name;

impl Cycle {
    /// Stops the build where parameters, lists, results, tasks, aims, help or examples name a parameter that is none of
    /// the entry's, or a condition looks at a datum of the machine that is none of its settings.
    pub const fn names_its_own(&self) {
        let mut params = self.params;
        while let [param, rest @ ..] = params {
            self.param_names(param);
            params = rest;
        }
        let mut lists = self.lists;
        while let [list, rest @ ..] = lists {
            self.list_names(list);
            lists = rest;
        }
        let mut results = self.results;
        while let [result, rest @ ..] = results {
            self.when_names(&result.when);
            results = rest;
        }
        let mut tasks = self.purpose.tasks;
        while let [task, rest @ ..] = tasks {
            self.when_names(&task.when);
            tasks = rest;
        }
        self.when_names(&self.purpose.calibrates);
        self.aims_name();
        let mut examples = self.examples;
        while let [(when, values), rest @ ..] = examples {
            self.when_names(when);
            self.values_names(values);
            examples = rest;
        }
    }

    const fn aims_name(&self) {
        let mut elements = self.aims.elements;
        while let [(when, _), rest @ ..] = elements {
            self.when_names(when);
            elements = rest;
        }
        let mut corrects = self.aims.corrects;
        while let [(when, _, values), rest @ ..] = corrects {
            self.when_names(when);
            self.values_names(values);
            corrects = rest;
        }
        let mut options = self.aims.options;
        while let [(when, ..), rest @ ..] = options {
            self.when_names(when);
            options = rest;
        }
    }

    const fn param_names(&self, param: &Param) {
        let mut needs = param.needs;
        while let [need, rest @ ..] = needs {
            self.when_names(&need.when);
            needs = rest;
        }
        let mut chooses = param.chooses;
        while let [one, rest @ ..] = chooses {
            self.when_names(&one.when);
            chooses = rest;
        }
        let mut labels = param.labels;
        while let [(when, _), rest @ ..] = labels {
            self.when_names(when);
            labels = rest;
        }
        match param.kind {
            Kind::ChoiceIf(ref when, _) => self.when_names(when),
            Kind::ChoiceBy(mut lists) => {
                while let [(when, _), rest @ ..] = lists {
                    self.when_names(when);
                    lists = rest;
                }
            }
            _ => {}
        }
    }

    const fn list_names(&self, list: &ArgumentList) {
        self.when_names(&list.when);
        let mut args = list.args;
        while let [arg, rest @ ..] = args {
            if let Some(name) = arg.param() {
                self.has(name);
            }
            args = rest;
        }
    }

    const fn values_names(&self, mut values: &[(Name, &str)]) {
        while let [(name, _), rest @ ..] = values {
            self.has(*name);
            values = rest;
        }
    }

    const fn when_names(&self, when: &When) {
        match *when {
            When::Digit { param, .. } | When::Given(param) | When::Number { param, .. } | When::Above { param, .. } => {
                self.has(param);
            }
            When::All(mut all) | When::Any(mut all) => {
                while let [when, rest @ ..] = all {
                    self.when_names(when);
                    all = rest;
                }
            }
            When::Not(when) => self.when_names(when),
            When::Setting { name, .. } => {
                let mut settings = self.settings;
                while let [setting, rest @ ..] = settings
                    && !same(setting, name)
                {
                    settings = rest;
                }
                assert!(!settings.is_empty(), "a condition looks at a datum that is none of the settings of the entry");
            }
            When::Always | When::Variant(_) | When::ToolType(..) | When::Plane(_) | When::Diameters => {}
        }
    }

    const fn has(&self, name: Name) {
        let mut params = self.params;
        while let [param, rest @ ..] = params
            && !same(param.name.as_str(), name.as_str())
        {
            params = rest;
        }
        assert!(!params.is_empty(), "the entry names a parameter that it does not have");
    }
}

/// Whether two names are one; a constant has no `==` for them.
const fn same(one: &str, other: &str) -> bool {
    let (mut one, mut other) = (one.as_bytes(), other.as_bytes());
    while let ([first, one_rest @ ..], [second, other_rest @ ..]) = (one, other)
        && *first == *second
    {
        (one, other) = (one_rest, other_rest);
    }
    one.is_empty() && other.is_empty()
}
