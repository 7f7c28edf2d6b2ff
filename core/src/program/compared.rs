//! What a call says otherwise than before: the difference between the values of both.

use super::arguments;
use super::calls::CallSite;
use crate::check::{Parsed, parse};
use crate::syntax::Program;
use std::collections::BTreeSet;

/// A value that a call has in one way of writing only, or otherwise in the other.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct ComparedValue {
    /// Line of the call as it is, from 1.
    pub line: u32,
    /// Cycle.
    pub cycle: &'static str,
    /// Parameter, or the argument of a newer control.
    pub param: String,
    /// Key of its label; empty: it has none.
    pub key: String,
    /// As it arrives at the call now; null: it does not, and the value is added.
    pub before: Option<String>,
    /// As it would arrive; null: it would not, and the value is lost.
    pub after: Option<String>,
}

/// The values that differ between a call of `program` and the same call of another text, in the order of their names.
pub fn compared(program: &Program, site: &CallSite, after: &CallSite) -> Vec<ComparedValue> {
    let names: BTreeSet<&String> = site.values.keys().chain(after.values.keys()).collect();
    let value = |name: &str, before: Option<String>, after: Option<String>| ComparedValue {
        line: site.line + 1,
        cycle: site.cycle.name,
        param: name.to_owned(),
        key: site.cycle.param(name).map_or_else(String::new, |param| format!("param-{}", param.key)),
        before,
        after,
    };
    let names = names.into_iter().filter(|name| site.cycle.param(name).is_some());
    let differing = names.filter(|name| !same(site, after, name));
    let mut all: Vec<_> = differing
        .map(|name| match (written(site, name), written(after, name)) {
            // of the same expression it is its worth that differs
            (before, now) if before == now => {
                value(name, site.values.get(name).cloned(), after.values.get(name).cloned())
            }
            (before, now) => value(name, before, now),
        })
        .collect();
    if let (Some(list), None) = (site.newer_list(), after.newer_list()) {
        let lost = arguments::only_newer(program, list, site.span).into_iter();
        all.extend(lost.map(|(name, text)| value(name, Some(text), None)));
        let beyond = arguments::beyond(program, list, site.span);
        all.extend(beyond.map(|(place, text)| value(&place.to_string(), Some(text), None)));
    }
    all
}

/// A value as the program has it.
fn written(site: &CallSite, name: &str) -> Option<String> {
    site.expressions.get(name).or_else(|| site.values.get(name)).cloned()
}

/// Whether both have the value, written the same but for zeros and blanks, or neither has it.
fn same(one: &CallSite, other: &CallSite, name: &str) -> bool {
    let plain = |text: String| match parse(&text) {
        Parsed::Number(number) => number.to_string(),
        _ => text.split_whitespace().collect(),
    };
    let worth = |site: &CallSite| site.values.get(name).cloned().map(plain);
    written(one, name).map(plain) == written(other, name).map(plain) && worth(one) == worth(other)
}
