//! A form at every keystroke: fields, findings, snippet, picture, and what the call would do.

use super::finding::Finding;
use super::outcome::{Outcome, Raised};
use super::places::{self, Places};
use super::predict::{ErrorSliders, predict};
use super::record::probe_of;
use super::start::{Machine, start};
use super::supply::{Supply, corrected};
use super::twin::{TwinView, twins};
use super::unsimulated;
use super::{Error, choose_units, cycle};
use crate::catalogue::find;
use crate::catalogue::newer::arguments::Argument;
use crate::catalogue::newer::variant_title;
use crate::check::{Checked, Parsed, expression, newer, parse, variants};
use crate::control::{Control, MachineSort, Plane, Transverse, UnitFunction};
use crate::diagnostic::{Diagnostic, Severity};
use crate::dialect::Dialect;
use crate::entry::{ArgumentList, Cycle, Inputs, Kind, Style, Typed, names};
use crate::form::{Chain, Field, Listed};
use crate::machine::Setup;
use crate::message::Message;
use crate::name::Name;
use crate::picture::Picture;
use crate::program::convert;
use crate::program::write::{self, Values, snippet_of};
use crate::scene::Source;
use crate::support::{Before, Support};
use crate::{check, form, own, support};
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;

/// What a form is asked for.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct FormRequest {
    /// Control.
    pub control: Dialect,
    /// Cycle.
    pub cycle: String,
    /// Values as typed, by parameter; absent: never typed.
    #[serde(default)]
    pub values: Typed,
    /// Of the values that are the worth of an expression of the program: as it is written. The snippet carries it.
    #[serde(default)]
    #[cfg_attr(test, ts(optional, as = "Option<Typed>"))]
    pub expressions: Typed,
    /// Values that an outcome counts with instead of those of the form, which depend on the way to the call.
    #[serde(default)]
    #[cfg_attr(test, ts(optional, as = "Option<Typed>"))]
    pub assumed: Typed,
    /// Machine; absent: the core's own as it is.
    pub setup: Option<Machine>,
    /// G function of units active at the call, where it is not that of the machine.
    pub units: Option<UnitFunction>,
    /// Working plane at the call, where it is not that of the machine.
    pub plane: Option<Plane>,
    /// How X is given at the call; absent: as diameters in a turning cycle.
    pub transverse: Option<Transverse>,
    /// What is wrong with part and probe; absent: nothing.
    pub errors: Option<ErrorSliders>,
    /// Words by parameter for a comment line each in the snippet.
    pub comments: Option<Typed>,
    /// Call style of the call of a program that the form shows: a list of newer controls has rules of its own.
    pub written: Option<Style>,
    /// Call style of the snippet; absent: as the machine's forms have it, else direct.
    pub style: Option<Style>,
    /// The measuring calls of the program, where the form is about a log: what it prints is named as these name it.
    #[serde(default)]
    #[cfg_attr(test, ts(optional, as = "Option<Vec<LoggedCall>>"))]
    pub measured: Vec<LoggedCall>,
    /// Whether to simulate.
    #[serde(default)]
    #[cfg_attr(test, ts(optional, as = "Option<bool>"))]
    pub predict: bool,
    /// Whether to look for the largest errors of the part that the call survives: takes a hundred runs.
    #[serde(default)]
    #[cfg_attr(test, ts(optional, as = "Option<bool>"))]
    pub limits: bool,
    /// Whether to look for the same task on other controls.
    #[serde(default)]
    #[cfg_attr(test, ts(optional, as = "Option<bool>"))]
    pub twin: bool,
}

impl FormRequest {
    /// Of a cycle with these values, on the core's own machine and nothing else.
    pub fn new(control: Dialect, cycle: impl Into<String>, values: Typed) -> FormRequest {
        FormRequest {
            control,
            cycle: cycle.into(),
            values,
            expressions: Typed::new(),
            assumed: Typed::new(),
            setup: None,
            units: None,
            plane: None,
            transverse: None,
            errors: None,
            comments: None,
            written: None,
            style: None,
            measured: Vec::new(),
            predict: false,
            limits: false,
            twin: false,
        }
    }
}

/// A measuring call.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct LoggedCall {
    /// Its cycle.
    pub cycle: String,
    /// Number of its variant.
    pub variant: i64,
}

/// A form.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct FormView {
    /// Fields in the order in which they are shown; hidden ones are left out.
    pub fields: Vec<Field>,
    /// All findings; those of a field name its parameter.
    pub diagnostics: Vec<Finding>,
    /// Text of the program, also for incomplete values as far as it can be written; empty: not in this way.
    pub snippet: String,
    /// Where the values are written in it: first UTF-16 unit, and one past the end.
    pub snippet_places: Places,
    /// What this call style cannot say.
    pub snippet_findings: Vec<Finding>,
    /// Call style that counts until another is chosen: the machine may say so.
    pub preset: Style,
    /// Whether there is no error.
    pub complete: bool,
    /// The variant that the values choose.
    #[cfg_attr(test, ts(optional = false))]
    pub mvar: Option<i64>,
    /// The limits of the tolerances as a picture, where there are any.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub chain: Option<Chain>,
    /// What the call is called, where a list of newer controls says less than the name of the variant.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub title: Option<Message>,
    /// What the values mean, drawn.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub picture: Option<Picture>,
    /// When asked for: the same task on other controls; empty where none has it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub twins: Option<Vec<TwinView>>,
    /// When simulating was asked for and there is no outcome: parameters whose values only a run tells.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unknown: Option<Vec<Name>>,
    /// When simulating was asked for, of a complete form of a cycle that is simulated.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub outcome: Option<Outcome>,
    /// When simulating was asked for: the machine, for an outcome with the proposed part, its errors and the start.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub setup: Option<Setup>,
    /// Whether the calibration data in that setup agree with its probe, for the probe that the call names.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub calibrated: Option<bool>,
}

/// Answers what is asked at every keystroke.
///
/// ```
/// use probewright_core::{app, json};
///
/// let asked = r#"{ "control": "sinumerik", "cycle": "CYCLE977", "values": { "_MVAR": "1" } }"#;
/// let view = app::form(json::question(asked)?)?;
/// assert!(view.fields.iter().any(|field| field.name == "_SETVAL" && field.required));
/// assert!(!view.complete); // no setpoint yet, and the findings say so
/// assert!(view.diagnostics.iter().any(|found| found.param.is_some_and(|name| name == "_SETVAL")));
/// # Ok::<(), app::Error>(())
/// ```
///
/// # Errors
/// A cycle or a G function of units that the control does not have.
pub fn form(mut asked: FormRequest) -> Result<FormView, Error> {
    let cycle = cycle(asked.control, &asked.cycle)?;
    let mut start = start(cycle.dialect, asked.setup.take())?;
    let begun = |name: &str| expression::begun(&start.setup.control, name).filter(|_| asked.written.is_none());
    let pointed = pointed(cycle, &asked.values);
    reckon(cycle, &mut asked.values, &mut asked.expressions, &begun);
    if !start.described {
        suit(&mut start.setup, cycle, &asked);
    }
    let Control { plane, transverse, active_units, data_follow, .. } = start.setup.control;
    at_call(&mut start.setup.control, cycle, &asked)?;
    let control = &mut start.setup.control;
    let support = Support::of(cycle, control);
    // a program tells its generation by what it writes
    let listed = match asked.written {
        None => write::is_listed_on(cycle, control),
        written => written == Some(Style::Operate),
    };
    let listed = newer_list(cycle, listed.then_some(Style::Operate)).filter(|list| list.is_written());
    let newer = newer_list(cycle, asked.written).or(listed);
    let preset = match newer {
        Some(_) => Style::Operate,
        None => support.map_or(Style::Direct, |support| support.style(cycle)),
    };
    let support = support.filter(|_| newer.is_none());
    if let (Some(_), None) = (newer, asked.written) {
        without_worked_target(cycle, &mut asked.values, control);
    }
    let (values, before) = entered(support, cycle, asked.values, control);
    let judge = |values: &Typed, control: &Control| match newer {
        // what a new call omits is written with what the form shows
        Some(list) if asked.written.is_none() => newer::check_simulated(cycle, list, values, control),
        Some(list) => newer::check_simulated(cycle, list, &newer::with_omitted(cycle, values), control),
        None => check::check(cycle, values, control),
    };
    let mut checked = judge(&values, control);
    if let (Some(support), Some(inputs)) = (support, &checked.inputs) {
        let found = cycle.params.iter().filter_map(|param| support::finding(support, param, inputs));
        checked.diagnostics.extend(found);
    }
    if asked.written.is_none() {
        checked.diagnostics.iter_mut().for_each(|found| name_missing(found, &values, control));
    }
    let written = newer.filter(|_| asked.written.is_some());
    let kept = written.map(|list| with_unused(cycle, list, &values, control));
    let values_of = Values { typed: kept.as_ref().unwrap_or(&values), expressions: &asked.expressions };
    let style = asked.style.unwrap_or(preset);
    let mut view = view(cycle, &values_of, control, &checked, style, asked.comments.as_ref());
    view.preset = preset;
    let shown = newer.or_else(|| newer_list(cycle, Some(style)));
    if let Some(list) = newer {
        let listed = Listed { cycle, list, written: asked.written.is_some() };
        view.fields = listed.fields(view.fields, &values, control);
        keep_to_list(&mut view, cycle, list, &values, style, control);
        tell_at_fields(&mut view, asked.written.is_none());
    } else if let Some(list) = shown {
        view.fields.extend(form::beside(list, &values, control));
        form::name_arguments(list, &mut view.fields);
    }
    if asked.written.is_none() {
        let other = write::other_generation(cycle, style, control);
        view.diagnostics.extend(other.iter().map(Finding::of));
    }
    name_columns(&mut view.fields, asked.control, &asked.measured);
    for field in &mut view.fields {
        field.written = pointed.get(field.name.as_str()).cloned();
    }
    view.twins = asked.twin.then(|| twins(cycle, &values, &start.setup.control));
    if let Some(list) = newer {
        let notes = unsimulated::notes(cycle, list, &values, checked.inputs.as_ref(), &start.setup.control);
        if !notes.is_empty() {
            checked.inputs = None; // what is shown would not be what the call says
        }
        view.diagnostics.extend(notes.iter().map(Finding::of));
    }
    if !asked.predict {
        return Ok(view);
    }
    let mut values = values;
    if !asked.assumed.is_empty() {
        values.extend(asked.assumed);
        checked.inputs = judge(&values, &start.setup.control).inputs;
    }
    view.unknown = checked.inputs.is_none().then(|| unknown(&checked));
    if newer.is_some() {
        start.setup.control.set(newer::COARSE, f64::from(u8::from(newer::is_coarse(&values))));
    }
    let mut setup = match (cycle.work(), &checked.inputs) {
        (Some(work), Some(inputs)) => {
            let outcome = predict(work, inputs, start, &asked.errors.unwrap_or_default(), asked.limits);
            view.diagnostics.extend(missing_tool(cycle, &values, &outcome.trace));
            view.outcome.insert(outcome).trace.setup.clone()
        }
        _ => start.setup,
    };
    // what a program begins with is not what counts at one of its calls
    setup.control = Control { plane, transverse, active_units, data_follow, ..setup.control };
    support::restore(&mut setup.control, before);
    let inputs = checked.inputs.unwrap_or_else(|| check::read(cycle, &values, &setup.control, &mut Vec::new()));
    view.calibrated = Some(setup.calibration_fits(probe_of(&inputs)));
    view.setup = Some(setup);
    Ok(view)
}

/// The values of a call of a program with those that its variant does not use on the older control, by the names of
/// their arguments: whatever they mean there, the list keeps them.
fn with_unused(cycle: &'static Cycle, list: &'static ArgumentList, values: &Typed, control: &Control) -> Typed {
    let inputs = check::read(cycle, values, control, &mut Vec::new());
    let mut all = values.clone();
    for argument in Argument::all(list) {
        let Some(param) = argument.param.and_then(|name| cycle.param(name.as_str())) else { continue };
        let unused = param.need(&inputs).is_none() && cycle.variant_param() != Some(param.name);
        if let (true, Some(text)) = (unused, values.get(param.name.as_str())) {
            all.entry(argument.name.to_owned()).or_insert_with(|| text.clone());
        }
    }
    all
}

/// What of a call in the list of a newer control is not known: the variant has no name and no picture then, and no
/// other call style says it.
fn keep_to_list(
    view: &mut FormView,
    cycle: &'static Cycle,
    list: &'static ArgumentList,
    values: &Typed,
    style: Style,
    control: &Control,
) {
    if newer::is_open(cycle, list, values, control) {
        view.mvar = None;
        view.picture = None;
    }
    let variant = cycle.variants.iter().find(|one| view.mvar == Some(one.number));
    view.title = variant.and_then(|one| variant_title(one.key));
    let refused = (style != Style::Operate).then(|| convert::only_listed(cycle, list, values, control)).flatten();
    if let Some(finding) = refused {
        view.snippet.clear();
        view.snippet_places = Places::default();
        view.snippet_findings = vec![Finding::of(&finding)];
    }
}

/// What the list has no place for is told at the field that keeps it, and not below the text; so is, of a call that is
/// still to be written (`new`), why it cannot be.
fn tell_at_fields(view: &mut FormView, new: bool) {
    let lost = own::WRITE_LOST.code();
    let at_field = |one: &Finding| one.code == lost || new && one.severity == Severity::Error;
    let (at_fields, rest): (Vec<Finding>, _) =
        std::mem::take(&mut view.snippet_findings).into_iter().partition(at_field);
    view.snippet_findings = rest;
    view.complete &= at_fields.iter().all(|one| one.severity != Severity::Error);
    view.diagnostics.extend(at_fields);
}

/// The worked measurement of the older control corrects a tool; a list starts without: argument 2 takes zero offsets.
fn without_worked_target(cycle: &'static Cycle, values: &mut Typed, control: &Control) {
    let worked = cycle.example().find(|(name, _)| *name == names::KNUM);
    let held = values.get(names::KNUM.as_str());
    if worked.is_some_and(|(_, text)| held.is_some_and(|held| held == text))
        && newer::has_tool_target(cycle, values, control)
    {
        values.remove(names::KNUM.as_str());
    }
}

/// Names columns that show a result as the measuring calls name it, where they agree.
fn name_columns(fields: &mut [Field], dialect: Dialect, measured: &[LoggedCall]) {
    let calls = measured.iter().filter_map(|one| Some(Inputs::new(find(dialect, &one.cycle)?, one.variant)));
    let calls: Vec<Inputs> = calls.collect();
    let name = |text: &str| {
        let of_call = |inputs: &Inputs| {
            let mut results = inputs.cycle.results.iter();
            Some(results.find(|one| one.name.eq_ignore_ascii_case(text) && one.when.holds(inputs))?.key)
        };
        let keys: BTreeSet<&str> = calls.iter().filter_map(of_call).collect();
        keys.first().filter(|_| keys.len() == 1).map(|key| Message::new(*key))
    };
    for field in fields {
        let Some(columns) = field.columns() else { continue };
        for column in &mut columns.list {
            column.label = name(&column.text).unwrap_or_else(|| column.label.clone());
        }
        for offer in &mut columns.offers {
            offer.label = name(&offer.text).unwrap_or_else(|| offer.label.clone());
        }
    }
}

/// Brings to the core's own machine what the cycle needs: which probe that is may depend on the plane at the call.
fn suit(setup: &mut Setup, cycle: &'static Cycle, asked: &FormRequest) {
    let variant = asked.assumed.get(names::MVAR.as_str()).or_else(|| asked.values.get(names::MVAR.as_str()));
    let variant = variant.and_then(|text| text.trim().parse().ok());
    let own = setup.control.plane;
    setup.control.plane = asked.plane.unwrap_or(own);
    setup.suit(cycle, variant.unwrap_or(0));
    setup.control.plane = own;
}

/// What is active at the call. A form has no DIAMON before its call; it asks for diameters (B:10623).
fn at_call(control: &mut Control, cycle: &Cycle, asked: &FormRequest) -> Result<(), Error> {
    if cycle.purpose.machine == MachineSort::Turning {
        control.transverse = asked.transverse.unwrap_or(Transverse::Diameter);
    }
    if let Some(function) = asked.units {
        choose_units(control, function)?;
    }
    control.plane = asked.plane.unwrap_or(control.plane);
    Ok(())
}

/// The list of a newer control, where the call that the form shows is written in it.
fn newer_list(cycle: &Cycle, written: Option<Style>) -> Option<&'static ArgumentList> {
    let of_newer = |list: &&ArgumentList| list.style == Style::Operate;
    cycle.lists.iter().find(of_newer).filter(|_| written == Some(Style::Operate))
}

/// The values that were typed with a decimal comma, as a program has them: with a point.
fn pointed(cycle: &Cycle, values: &Typed) -> Typed {
    let commas = |text: &str| text.matches(',').count();
    let with_point = |(name, text): (&String, &String)| {
        let param = cycle.param(name).filter(|param| commas(text) > 0 && !matches!(param.kind, Kind::Text(_)))?;
        let written = write::value(cycle.dialect, param, text).filter(|written| commas(written) < commas(text))?;
        Some((name.clone(), written))
    };
    values.iter().filter_map(with_point).collect()
}

/// What the values are worth that are expressions of what is known, and how these are written.
fn reckon(cycle: &Cycle, values: &mut Typed, expressions: &mut Typed, known: &dyn Fn(&str) -> Option<f64>) {
    for (name, text) in values {
        let number = cycle.param(name).is_some_and(|param| !matches!(param.kind, Kind::Text(_)));
        if !number || expressions.contains_key(name) || parse(text) != Parsed::Expression {
            continue;
        }
        let Some(written) = expression::written(cycle.dialect, text) else { continue };
        if let Some(worth) = expression::worth(cycle.dialect, &written, known) {
            *text = expression::shown(worth);
            expressions.insert(name.clone(), written);
        }
    }
}

/// Says of a value that is known at run time only which variable in it nothing gave a value.
fn name_missing(found: &mut Diagnostic, values: &Typed, control: &Control) {
    let text = found.param.filter(|_| found.code == own::EXPRESSION.code()).and_then(|name| values.get(name.as_str()));
    let names = text.map(|text| expression::names(control.dialect, text)).unwrap_or_default();
    let missing = |name: &String| expression::is_parameter(name) && expression::begun(control, name).is_none();
    if let Some(name) = names.into_iter().find(missing) {
        let told = own::NO_VALUE.finding().text("name", &*name).hint_text("name", name);
        *found = Diagnostic { param: found.param, ..told };
    }
}

/// The parameters whose values are known at run time only.
fn unknown(checked: &Checked) -> Vec<Name> {
    let found = checked.diagnostics.iter().filter(|one| one.code == own::EXPRESSION.code());
    found.filter_map(|one| one.param).collect()
}

/// The values of the form, those included that the settings of the machine give; the control gets what they write into
/// its data.
fn entered(support: Option<Support>, cycle: &'static Cycle, typed: Typed, control: &mut Control) -> (Typed, Before) {
    let Some(support) = support else { return (typed, Before::new()) };
    let entered = support.entered(cycle, &typed, control);
    let before = entered.write(control);
    (entered.values, before)
}

/// The tool to be corrected is not on the machine: at the field that names it, with what gives it.
fn missing_tool(cycle: &Cycle, values: &Typed, done: &Source) -> Option<Finding> {
    let control = &done.setup.control;
    let missing = |code| Some((code, corrected(code, cycle, values, control)?));
    let (code, new) = done.outcome.alarms().into_iter().find_map(missing)?;
    let param = if new.name.is_empty() { names::TNUM } else { names::TNAME };
    let Raised { message, hint, .. } = Raised::alarm(code).on(control);
    let found = Diagnostic { hint, ..Diagnostic::new(Severity::Error, code, message) }.at(param);
    Some(Finding { offers: vec![Supply::Tool(new).offer()], ..Finding::of(&found) })
}

/// The form without what is simulated.
fn view(
    cycle: &'static Cycle,
    values: &Values,
    control: &Control,
    checked: &Checked,
    style: Style,
    comments: Option<&Typed>,
) -> FormView {
    let word = |name: &str, _: &str| comments.and_then(|words| words.get(name)).cloned().unwrap_or_default();
    let words = comments.map(|_| &word as &dyn Fn(&str, &str) -> String);
    let written = snippet_of(cycle, values, control, style, words);
    let inputs = check::read(cycle, values.typed, control, &mut Vec::new());
    let with_expression = |field: Field| {
        let expression = values.expressions.get(field.name.as_str()).cloned();
        Field { expression, ..field }
    };
    let findings = |list: &[Diagnostic]| list.iter().map(Finding::of).collect();
    let fields: Vec<Field> = form::fields_by(&inputs, values.typed, control).into_iter().map(with_expression).collect();
    FormView {
        chain: form::chain(&fields, &inputs, control),
        fields,
        diagnostics: findings(&checked.diagnostics),
        snippet_places: places::in_snippet(&written),
        snippet: written.text,
        snippet_findings: findings(&written.findings),
        preset: style,
        complete: checked.diagnostics.iter().all(|found| found.severity != Severity::Error),
        mvar: variants::chosen_by(&inputs, values.typed),
        title: None,
        picture: form::draw(cycle, values.typed, control).map(Picture::rounded),
        twins: None,
        unknown: None,
        outcome: None,
        setup: None,
        calibrated: None,
    }
}
