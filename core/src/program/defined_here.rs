//! Data of the measuring cycles in a definition file beside a program: the machine has them already, with values that
//! its control may have changed since that file was activated.

use super::write::definition_files::{counter, size};
use crate::control::{Control, Value, arrays, gud};
use crate::diagnostic::Diagnostic;
use crate::own;
use crate::syntax::definitions::{Defined, Measuring};

/// That the machine has other values or counts, which are those that count.
pub fn finding(found: &Defined, control: &Control) -> Option<Diagnostic> {
    let other: Vec<&Measuring> = found.measuring.iter().filter(|one| differs(one, control)).collect();
    let mut names: Vec<&str> = other.iter().map(|one| one.name.as_str()).collect();
    names.dedup();
    Some(own::DEFINED_HERE.finding().texts("names", &names).on(other.first()?.place))
}

fn differs(one: &Measuring, control: &Control) -> bool {
    let fields = |gud| counter(gud).is_some() && !one.sizes.is_empty() && size(control, gud) != one.sizes;
    gud::find(&one.name).is_some_and(fields) || values(one).any(|(name, value)| !has(control, &name, value))
}

/// The values that it gives, by the names of the elements.
fn values(one: &Measuring) -> impl Iterator<Item = (String, &Value)> {
    let names: Vec<String> = match one.sizes.is_empty() {
        true => vec![one.name.clone()],
        false => arrays::following(&one.name, &one.sizes).take(one.first.count()).collect(),
    };
    names.into_iter().enumerate().filter_map(|(at, name)| Some((name, one.first.begins(at)?)))
}

fn has(control: &Control, name: &str, value: &Value) -> bool {
    match value {
        Value::Number(number) => control.number(name) == *number,
        Value::Text(text) => control.text(name) == text,
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use crate::control::delivery;
    use crate::dialect::Dialect;
    use crate::program::findings_on;

    /// The names that are told of a definition file with these lines beside a program.
    fn told(lines: &str, set: &[(&str, f64)]) -> Option<String> {
        let text = format!("M30\n%_N_GUD6_DEF\n{lines}\nM17\n");
        let program = crate::syntax::read(Dialect::Sinumerik, text.as_bytes());
        let mut control = delivery(Dialect::Sinumerik);
        set.iter().for_each(|(name, value)| control.set(*name, *value));
        let found = findings_on(&program, control);
        let found = found.into_iter().find(|finding| finding.message.key == "defined-here")?;
        Some(found.message.word("names").unwrap().to_owned())
    }

    // oracle: manual B:13276-13288 (the lines of the example), hand (what the machine has already needs no word)
    #[test]
    fn other_values_and_counts_than_those_of_the_machine_are_told() {
        let lines = "DEF NCK INT _CVAL[4]=(2,2,0,0)\nDEF NCK REAL _TP[2,10]=SET(0,,,,,,,133)\nDEF NCK REAL MYV=3\n\
                     DEF CHAN REAL _SPEED[4]=(10,20,30,40)\nDEF NCK INT _DIGIT=3\nDEF NCK BOOL _CBIT[17]=REP(1)";
        assert_eq!(told(lines, &[]).as_deref(), Some("_CVAL, _TP, _SPEED, _CBIT"));
        let counts = [("_CVAL[0]", 2.0), ("_CVAL[1]", 2.0), ("_CVAL[2]", 0.0), ("_CVAL[3]", 0.0)];
        assert_eq!(told("DEF NCK INT _CVAL[4]=(2,2,0,0)\nDEF NCK REAL _TP[2,10]", &counts), None);
        assert_eq!(told("DEF NCK INT _CVAL[4]\nDEF NCK REAL _TP[3,10]\nDEF NCK REAL MYV[2]=REP(4)", &[]), None);
    }
}
