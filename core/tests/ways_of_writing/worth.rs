//! A value written as an expression counts as the number that it is worth, and is changed where its variable is
//! assigned.

use super::sites;
use probewright_core::app::{
    Beginning, Catalogue, ChangeRequest, FormRequest, FormView, Machine, OwnMachine, ReadRequest,
};
use probewright_core::app::{catalogue, change, form};
use probewright_core::check::{Parsed, parse};
use probewright_core::control::Value;
use probewright_core::dialect::Dialect;
use probewright_core::entry::{Kind, Typed};
use probewright_core::form::Field;
use probewright_core::program::change::apply;
use probewright_core::program::variables::variables;
use probewright_core::syntax::read;
use std::collections::BTreeMap;

fn asked(control: Dialect, cycle: &str, values: Typed, predict: bool) -> FormRequest {
    FormRequest { predict, ..FormRequest::new(control, cycle, values) }
}

/// What does not say how a value is written.
fn without_text(view: FormView) -> FormView {
    let fields = view.fields.into_iter().map(|field| Field { expression: None, written: None, ..field }).collect();
    FormView {
        fields,
        snippet: String::new(),
        snippet_places: Default::default(),
        snippet_findings: Vec::new(),
        ..view
    }
}

fn same(one: &FormView, other: &FormView, of: &str) {
    assert_eq!(one.fields, other.fields, "{of}");
    assert_eq!(one.diagnostics, other.diagnostics, "{of}");
    assert_eq!(one.outcome.is_some(), other.outcome.is_some(), "{of}");
    assert!(one == other, "{of}");
}

/// Every number of the worked measurements as the control writes it, so that only the expression differs.
fn numbers(values: &Typed) -> Typed {
    let plain = |text: &String| match parse(text) {
        Parsed::Number(number) => number.to_string(),
        _ => text.clone(),
    };
    values.iter().map(|(name, text)| (name.clone(), plain(text))).collect()
}

fn is_number(text: &str) -> bool {
    matches!(parse(text), Parsed::Number(_))
}

// oracle: self (every cycle and variant; each numeric parameter of the first variants by itself)
#[test]
fn an_expression_counts_as_what_it_is_worth() {
    let Catalogue { cycles, .. } = catalogue();
    for info in &cycles {
        for (at, variant) in info.variants.iter().enumerate() {
            let values = numbers(&variant.usual.example);
            let calculated = |text: &String| if is_number(text) { format!("{text}+0,0") } else { text.clone() };
            let all: Typed = values.iter().map(|(name, text)| (name.clone(), calculated(text))).collect();
            let ask = |values: &Typed, predict| form(asked(info.control, info.cycle, values.clone(), predict)).unwrap();
            let plain = without_text(ask(&values, true));
            let reckoned = ask(&all, true);
            for field in reckoned
                .fields
                .iter()
                .filter(|field| values.get(field.name.as_str()).is_some_and(|text| is_number(text)))
            {
                assert!(field.expression.is_some(), "{} {}", info.cycle, field.name);
            }
            same(&without_text(reckoned), &plain, &format!("{} {}", info.cycle, variant.mvar));
            let single = values.iter().filter(|(_, text)| at == 0 && is_number(text));
            let plain = without_text(ask(&values, false));
            for (name, text) in single {
                let mut one = values.clone();
                one.insert(name.clone(), calculated(text));
                same(&without_text(ask(&one, false)), &plain, &format!("{} {name}", info.cycle));
            }
        }
    }
}

// oracle: hand: R parameters of the machine count in a form, and in a program that does not assign them
#[test]
fn what_the_machine_holds_counts_where_nothing_assigns_it() {
    let data = BTreeMap::from([("R2".into(), Value::Number(40.0)), ("R3".into(), Value::Number(7.0))]);
    let setup = || Machine::Own(OwnMachine { own: Beginning { data: data.clone(), ..Beginning::default() } });
    let values = Typed::from([("_MVAR".into(), "1".into()), ("_SETVAL".into(), "2*R2".into())]);
    let question = FormRequest { setup: Some(setup()), ..asked(Dialect::Sinumerik, "CYCLE977", values, false) };
    let view = form(question).unwrap();
    let field = view.fields.iter().find(|field| field.name == "_SETVAL").unwrap();
    assert_eq!((field.value.as_str(), field.expression.as_deref()), ("80", Some("2*R2")));
    assert!(view.snippet.contains("_SETVAL=2*R2"), "{}", view.snippet);
    let text = "R3=30\n_MVAR=1 _SETVAL=R2+R3 _PRNUM=1 _FA=R9\nCYCLE977\n".to_owned();
    let asked = ReadRequest { control: Dialect::Sinumerik, text: text.into(), setup: Some(setup()), with: None };
    let read = probewright_core::app::read(asked, &mut |_| {}).unwrap();
    assert_eq!(read.calls[0].values["_SETVAL"], "70");
    let said: Vec<_> = read.calls[0].arrivals.iter().map(|one| one.message.key.to_string()).collect();
    assert_eq!(said, ["check-no-value"], "R9");
}

// oracle: self (for every numeric parameter of every variant)
#[test]
fn a_variable_is_changed_in_one_line_and_the_expression_stays() {
    for cycle in probewright_core::catalogue::CYCLES.iter().filter(|cycle| cycle.dialect == Dialect::Sinumerik) {
        let name = cycle.name;
        let numeric = cycle.params.iter().filter(|param| !matches!(param.kind, Kind::Text(_) | Kind::Variant(_)));
        let words: Vec<String> =
            numeric.clone().enumerate().map(|(at, one)| format!("{}=R{at}-1\n", one.name)).collect();
        let given: String = (0..words.len()).map(|at| format!("R{at}=3 ; {at}\n")).collect();
        let text = format!("{given}{}{name}\nX=R1\n", words.concat());
        let program = read(Dialect::Sinumerik, text.as_bytes());
        let Some(site) = sites(&text).pop() else { continue };
        for (at, param) in numeric.enumerate() {
            let found = variables(&program, &site, param.name.as_str(), "7");
            let change = found[0].change.as_ref().unwrap_or_else(|why| panic!("{name} {}: {why:?}", param.name));
            let after = apply(text.as_bytes(), std::slice::from_ref(&change.edit));
            let after = String::from_utf8(after).unwrap();
            assert_eq!(after, text.replace(&format!("R{at}=3 ; {at}\n"), &format!("R{at}=8 ; {at}\n")));
            let site = sites(&after).pop().unwrap();
            assert_eq!(site.values[param.name.as_str()], "7", "{name} {}", param.name);
            assert_eq!(site.expressions[param.name.as_str()], format!("R{at}-1"));
        }
    }
}

// oracle: hand
#[test]
fn a_change_tells_which_expression_it_takes_away() {
    let text = "R2=50\n_MVAR=1 _SETVAL=R2 _PRNUM=1 _FA=2\nCYCLE977\nX=R2\n";
    let ask =
        |value: &str| change(ChangeRequest::new(Dialect::Sinumerik, text.to_owned(), 0, "_SETVAL", value)).unwrap();
    let replaced = ask("51").replaced.unwrap();
    assert_eq!((replaced.text.as_str(), replaced.worth.as_deref()), ("R2", Some("50")));
    let variable = &replaced.variables[0];
    assert_eq!((&variable.uses[..], &variable.assigned[..]), (&[2, 4][..], &[1][..]));
    assert_eq!(variable.change.as_ref().unwrap().line.after, "R2=51");
    assert!(ask("").replaced.is_some());
    assert!(ask("R9").replaced.is_some(), "worth nothing");
    assert!(ask("R2+1").replaced.is_none(), "an expression with a worth is what the user wants");
}
