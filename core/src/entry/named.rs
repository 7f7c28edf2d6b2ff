//! An entry that speaks of a parameter which it does not have does not compile: the catalogue looks through all of
//! them while it is built.

use super::{Arg, ArgumentList, Cycle, Kind, Need, Param, When};
use crate::name::Name;

impl Cycle {
    /// Stops the build where parameters, lists, results, tasks, help or examples name a parameter that is none of the
    /// entry's, or a condition looks at a datum of the machine that is none of its settings.
    pub const fn names_its_own(&self) {
        let mut i = 0;
        while i < self.params.len() {
            self.param_names(&self.params[i]);
            i += 1;
        }
        i = 0;
        while i < self.lists.len() {
            self.list_names(&self.lists[i]);
            i += 1;
        }
        i = 0;
        while i < self.results.len() {
            self.when_names(&self.results[i].when);
            i += 1;
        }
        i = 0;
        while i < self.purpose.tasks.len() {
            self.when_names(&self.purpose.tasks[i].when);
            i += 1;
        }
        self.when_names(&self.purpose.calibrates);
        self.values_names(self.example);
        let Some(simulation) = &self.simulation else {
            return;
        };
        i = 0;
        while i < simulation.examples.len() {
            self.when_names(&simulation.examples[i].0);
            self.values_names(simulation.examples[i].1);
            i += 1;
        }
    }

    const fn param_names(&self, param: &Param) {
        self.needs_names(param.needs);
        let mut i = 0;
        while i < param.chooses.len() {
            self.when_names(&param.chooses[i].when);
            i += 1;
        }
        i = 0;
        while i < param.labels.len() {
            self.when_names(&param.labels[i].0);
            i += 1;
        }
        match &param.kind {
            Kind::ChoiceIf(when, _) => self.when_names(when),
            Kind::ChoiceBy(lists) => {
                i = 0;
                while i < lists.len() {
                    self.when_names(&lists[i].0);
                    i += 1;
                }
            }
            _ => {}
        }
    }

    const fn needs_names(&self, needs: &[Need]) {
        let mut i = 0;
        while i < needs.len() {
            self.when_names(&needs[i].when);
            i += 1;
        }
    }

    const fn list_names(&self, list: &ArgumentList) {
        self.when_names(&list.when);
        let mut i = 0;
        while i < list.args.len() {
            if let Arg::Param(name) | Arg::Down(name) = list.args[i] {
                self.has(name);
            }
            i += 1;
        }
    }

    const fn values_names(&self, values: &[(Name, &str)]) {
        let mut i = 0;
        while i < values.len() {
            self.has(values[i].0);
            i += 1;
        }
    }

    const fn when_names(&self, when: &When) {
        match when {
            When::Digit { param, .. } | When::Given(param) | When::Number { param, .. } | When::Above { param, .. } => {
                self.has(*param);
            }
            When::All(all) | When::Any(all) => {
                let mut i = 0;
                while i < all.len() {
                    self.when_names(&all[i]);
                    i += 1;
                }
            }
            When::Not(when) => self.when_names(when),
            When::Setting { name, .. } => {
                let mut i = 0;
                while i < self.settings.len() && !same(self.settings[i], name) {
                    i += 1;
                }
                assert!(
                    i < self.settings.len(),
                    "a condition looks at a datum that is none of the settings of the entry"
                );
            }
            When::Always | When::Variant(_) | When::ToolType(..) | When::Plane(_) | When::Diameters => {}
        }
    }

    const fn has(&self, name: Name) {
        let mut i = 0;
        while i < self.params.len() && !same(self.params[i].name.as_str(), name.as_str()) {
            i += 1;
        }
        assert!(i < self.params.len(), "the entry names a parameter that it does not have");
    }
}

/// Whether two names are one; a constant has no `==` for them.
const fn same(one: &str, other: &str) -> bool {
    let (one, other) = (one.as_bytes(), other.as_bytes());
    let mut i = 0;
    while i < one.len() && i < other.len() && one[i] == other[i] {
        i += 1;
    }
    i == one.len() && i == other.len()
}
