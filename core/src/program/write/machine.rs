//! The changed data of a machine as text: assignments for a part program.

use crate::control::gud::Gud;
use crate::control::nct_data::NctDatum;
use crate::control::{Control, Value, gud, nct_data};
use std::fmt::Write;

/// Whether it is a datum of the machine.
fn of_machine(name: &str) -> bool {
    gud::named(name).is_some_and(Gud::of_machine) || nct_data::find(name).is_some_and(assigned)
}

/// Whether a program can write an NCT datum: the variables that stay, no parameter and no input.
fn assigned(datum: &NctDatum) -> bool {
    datum.name.starts_with("#5")
}

/// Names of the user data that differ, in the order of the tables.
pub(super) fn differing(control: &Control, delivered: &Control) -> Vec<String> {
    let names = control.data.keys().chain(delivered.data.keys());
    let mut names: Vec<String> =
        names.filter(|name| of_machine(name) && value(control, name) != value(delivered, name)).cloned().collect();
    let order = |name: &String| {
        let (gud, at) = gud::place(name)?;
        Some((gud::all().position(|one| one.name == gud.name)?, at))
    };
    names.sort_by_cached_key(order);
    names.dedup();
    names
}

/// A datum; one that was never set is 0 or empty.
pub(super) fn value(control: &Control, name: &str) -> Value {
    let text = gud::named(name).is_some_and(Gud::text);
    match control.data.get(name) {
        Some(value) => value.clone(),
        None if text => Value::Text(String::new()),
        None => Value::Number(0.0),
    }
}

pub(super) fn written(value: &Value) -> String {
    match value {
        Value::Number(value) => value.to_string(),
        Value::Text(text) => format!("\"{text}\""),
    }
}

/// Assignments that make a control as delivered into this one.
pub fn assignments(control: &Control, delivered: &Control) -> String {
    let mut text = String::new();
    for name in differing(control, delivered) {
        let _ = writeln!(text, "{name}={}", written(&value(control, &name)));
    }
    text
}

/// `DEF NCK REAL _KB`.
pub(super) fn head(gud: &Gud) -> String {
    format!("DEF {} {} {}", if gud.channel { "CHAN" } else { "NCK" }, gud.kind.name(), gud.name)
}

/// Values of a list as it is written: those of one dimension complete, as the manual prints them (B:13276, B:13286);
/// what a longer one leaves out at the end is 0. Empty: all are 0.
pub(super) fn listed(values: impl Iterator<Item = Value>, dimensions: usize) -> String {
    let mut values: Vec<String> = values.map(|value| written(&value)).collect();
    let last = values.iter().rposition(|value| value != "0");
    values.truncate(if dimensions == 1 && last.is_some() { values.len() } else { last.map_or(0, |last| last + 1) });
    values.join(",")
}

/// Indices of every element, the last one counting first.
pub(super) fn places(sizes: &[usize]) -> Vec<Vec<usize>> {
    sizes.iter().fold(vec![Vec::new()], |places, size| {
        let longer = |place: &Vec<usize>| {
            let place = place.clone();
            (0..*size).map(move |i| [place.as_slice(), &[i]].concat())
        };
        places.iter().flat_map(longer).collect()
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::control::delivery;
    use crate::dialect::Dialect;

    #[test]
    fn only_what_differs_is_written() {
        let delivered = delivery(Dialect::Sinumerik);
        let mut control = delivered.clone();
        assert_eq!(assignments(&control, &delivered), "");
        control.set("_CVAL[1]", 2.0);
        control.set("_CBIT[2]", 1.0);
        control.set("_WP[0,0]", 5.995);
        control.set("_DIGIT", 4.0);
        control.data.insert("_PROTNAME[1]".into(), Value::Text("LOG1".into()));
        control.set("R10", 7.0); // not of the machine
        // oracle: hand
        assert_eq!(
            assignments(&control, &delivered),
            "_CVAL[1]=2\n_WP[0,0]=5.995\n_CBIT[2]=1\n_PROTNAME[1]=\"LOG1\"\n_DIGIT=4\n"
        );
    }
}
