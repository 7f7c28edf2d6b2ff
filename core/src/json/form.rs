//! A form at every keystroke: fields, findings, snippet, picture; what the call would do is [`super::predict`].

use super::predict::predict;
use super::setup_active::{PlaneName, TransverseName, choose_units, plane, transverse};
use super::{Error, diagnostic, dialect, message, object, put};
use crate::SIMULATES;
use crate::check::{self, Checked, newer, variants};
use crate::control::MachineSort;
use crate::control::{Control, Plane, Transverse, Units};
use crate::diagnostic::Severity;
use crate::entry::Typed;
use crate::entry::{ArgumentList, Cycle, Style, names};
use crate::form;
use crate::machine::setup::Setup;
use crate::own;
use crate::picture::{Picture, PictureShape, ShapeKind, View};
use crate::program::write::{Values, snippet_of};
use crate::range::Range;
use crate::scene::Source;
use crate::support::{self, Before, Support};
use serde::Deserialize;
use serde_json::Value;

#[derive(Deserialize)]
struct Request {
    control: String,
    cycle: String,
    #[serde(default)]
    values: Typed,
    /// Values that are the worth of an expression of the program, as that is written: the snippet carries them.
    #[serde(default)]
    expressions: Typed,
    /// Values that an outcome counts with instead of those of the form, which depend on the way to the call.
    #[serde(default)]
    assumed: Typed,
    #[serde(default)]
    setup: Option<Value>,
    /// G function of units in force at the call (`G70`), where it is not that of the setup.
    #[serde(default)]
    units: Option<String>,
    /// Working plane at the call, where it is not that of the setup.
    #[serde(default)]
    plane: Option<PlaneName>,
    /// How X is given at the call; absent: as diameters in a turning cycle.
    #[serde(default)]
    transverse: Option<TransverseName>,
    #[serde(default)]
    errors: Option<Value>,
    /// Words by parameter name for a comment line each; the core has no words of its own.
    #[serde(default)]
    comments: Option<Typed>,
    /// Way of writing of the call of a program that the form shows; absent: none, or one whose rules are those of the
    /// form.
    #[serde(default)]
    written: Option<String>,
    /// Way of writing; absent: as the machine's forms have it, else direct.
    #[serde(default)]
    style: Option<String>,
    #[serde(default)]
    predict: bool,
    /// Whether to look for the largest errors of the part that the call survives.
    #[serde(default)]
    limits: bool,
    /// Whether the same task on the other control is asked for.
    #[serde(default)]
    twin: bool,
}

/// Answers a `FormRequest` with a `FormView`.
pub fn form(request: &str) -> Result<Value, Error> {
    Ok(form_seen(request)?.0)
}

/// The same, and what is to be seen of a call that was carried out.
pub fn form_seen(request: &str) -> Result<(Value, Option<Source>), Error> {
    let request: Request = super::request(request)?;
    let cycle = super::cycle(dialect(&request.control)?, &request.cycle)?;
    let mut start = super::start::start(cycle.dialect, request.setup)?;
    if !start.described {
        let assumed = request.assumed.get(names::MVAR.as_str());
        let variant = assumed.or_else(|| request.values.get(names::MVAR.as_str()));
        let variant = variant.and_then(|text| text.trim().parse().ok());
        // which probe a machine brings may depend on the plane at the call
        let own = start.setup.control.plane;
        start.setup.control.plane = request.plane.map_or(own, plane);
        start.setup.suit(cycle, variant.unwrap_or(0));
        start.setup.control.plane = own;
    }
    let control = &mut start.setup.control;
    let at_start = modal(control);
    // a form has no DIAMON before its call; it asks for diameters (B:10623)
    if cycle.purpose.machine == MachineSort::Turning {
        control.transverse = request.transverse.map_or(Transverse::Diameter, transverse);
    }
    if let Some(name) = &request.units {
        choose_units(control, name)?;
    }
    if let Some(name) = request.plane {
        control.plane = plane(name);
    }
    let support = Support::of(cycle, control);
    let preset = support.map_or(Style::Direct, |support| support.style(cycle));
    let style = request.style.as_deref();
    let style = style.map_or(Ok(preset), super::style)?;
    let newer = newer_list(cycle, request.written.as_deref())?;
    let support = support.filter(|_| newer.is_none());
    let (values, before) = entered(support, cycle, request.values, control);
    let judge = |values: &Typed, control: &Control| match newer {
        Some(list) => newer::check_listed(cycle, list, values, control),
        None => check::check(cycle, values, control),
    };
    let mut checked = judge(&values, control);
    if let (Some(support), Some(inputs)) = (support, &checked.inputs) {
        let params = cycle.params.iter();
        let found = params.filter_map(|param| support::finding(support, param, inputs));
        checked.diagnostics.extend(found);
    }
    let comments = request.comments.as_ref();
    let values_of = Values { typed: &values, expressions: &request.expressions };
    let mut view = view(cycle, &values_of, &start.setup, &checked, style, comments);
    put(&mut view, "preset", super::style_name(preset));
    if request.twin && SIMULATES {
        let there = super::twin::view(cycle, &values, &start.setup.control);
        put(&mut view, "twin", there);
    }
    let mut seen = None;
    if request.predict && SIMULATES {
        if !request.assumed.is_empty() {
            let mut values = values;
            values.extend(request.assumed);
            checked.inputs = judge(&values, &start.setup.control).inputs;
        }
        if checked.inputs.is_none() {
            put(&mut view, "unknown", unknown(&checked));
        }
        let mut setup = match (cycle.work(), &checked.inputs) {
            (Some(work), Some(inputs)) => {
                let (outcome, source) = predict(work, inputs, start, request.errors, request.limits)?;
                put(&mut view, "outcome", outcome);
                seen.insert(source).setup.clone()
            }
            _ => start.setup,
        };
        set_modal(&mut setup.control, at_start);
        support::restore(&mut setup.control, before);
        put(&mut view, "setup", super::setup_to_json(&setup));
    }
    Ok((view, seen))
}

/// The list of a newer control, where the call that the form shows is written in it.
fn newer_list(cycle: &Cycle, written: Option<&str>) -> Result<Option<&'static ArgumentList>, Error> {
    let style = written.map(super::style).transpose()?;
    let mut lists = cycle.lists.iter();
    let of_newer = |list: &&ArgumentList| list.style == Style::Operate;
    let asked = style == Some(Style::Operate);
    Ok(lists.find(of_newer).filter(|_| asked))
}

/// The parameters whose values are known at run time only.
fn unknown(checked: &Checked) -> Value {
    let found = checked.diagnostics.iter();
    let found = found.filter(|one| one.code == own::EXPRESSION.code());
    found.filter_map(|one| one.param).collect()
}

/// The values of the form, those included that the settings of the machine give; the control gets what they write into
/// its data.
fn entered(support: Option<Support>, cycle: &'static Cycle, typed: Typed, control: &mut Control) -> (Typed, Before) {
    let Some(support) = support else {
        return (typed, Before::new());
    };
    let entered = support.entered(cycle, &typed, control);
    let before = entered.write(control);
    (entered.values, before)
}

/// Plane, diameters and units of a control: what a program begins with is not what counts at one of its calls.
type Modal = (Plane, Transverse, Units, bool);

fn modal(control: &Control) -> Modal {
    let Control { plane, transverse, active_units, data_follow, .. } = *control;
    (plane, transverse, active_units, data_follow)
}

fn set_modal(control: &mut Control, (plane, transverse, units, data_follow): Modal) {
    control.plane = plane;
    control.transverse = transverse;
    control.active_units = units;
    control.data_follow = data_follow;
}

fn view(
    cycle: &'static Cycle,
    values: &Values,
    setup: &Setup,
    checked: &Checked,
    style: Style,
    comments: Option<&Typed>,
) -> Value {
    let word = |name: &str, _: &str| comments.and_then(|words| words.get(name)).cloned().unwrap_or_default();
    let control = &setup.control;
    let errors = checked.diagnostics.iter().any(|found| found.severity == Severity::Error);
    let words = comments.map(|_| &word as &dyn Fn(&str, &str) -> String);
    let written = snippet_of(cycle, values, control, style, words);
    let typed = values.typed;
    let expression = |name: &str| values.expressions.get(name).map(String::as_str);
    let mut view = object([
        (
            "fields",
            form::fields(cycle, typed, control).iter().map(|one| field(one, expression(one.name.as_str()))).collect(),
        ),
        ("diagnostics", checked.diagnostics.iter().map(diagnostic).collect()),
        ("snippet", written.text.into()),
        ("snippetFindings", written.findings.iter().map(diagnostic).collect()),
        ("complete", (!errors).into()),
        ("mvar", variants::chosen(cycle, typed, control).into()),
    ]);
    if let Some(drawn) = form::draw(cycle, typed, control) {
        put(&mut view, "picture", picture(&drawn));
    }
    view
}

fn picture(picture: &Picture) -> Value {
    let view = match picture.view {
        View::Plane => "plane",
        View::Section => "section",
    };
    let parts = parts(picture);
    object([("view", view.into()), ("shapes", picture.shapes.iter().map(|one| shape(one, parts)).collect())])
}

/// Into how many parts of a mm the coordinates of a picture are rounded: far finer than a pixel, and a third of the
/// text that is sent at every keystroke.
fn parts(picture: &Picture) -> f64 {
    let points = picture.shapes.iter().flat_map(|shape| &shape.points);
    let largest = points.flatten().fold(0.0_f64, |most, value| most.max(value.abs()));
    10_f64.powi(6 - largest.max(1e-9).log10().ceil() as i32)
}

fn shape(shape: &PictureShape, parts: f64) -> Value {
    let near = |value: f64| (value * parts).round() / parts;
    let points = shape.points.iter().map(|point| point.map(near));
    let mut view = object([("kind", shape_kind(shape.kind).into()), ("points", points.collect())]);
    if let Some((at, r)) = shape.circle {
        let [x, y] = at.map(near);
        let circle = [("x", x.into()), ("y", y.into()), ("r", near(r).into())];
        put(&mut view, "circle", object(circle));
    }
    if let Some((at, r)) = shape.opening {
        let [x, y] = at.map(near);
        put(&mut view, "opening", object([("x", x.into()), ("y", y.into()), ("r", near(r).into())]));
    }
    if shape.closed {
        put(&mut view, "closed", true);
    }
    if let Some(text) = &shape.text {
        put(&mut view, "text", text.as_str());
    }
    if let Some(field) = shape.field {
        put(&mut view, "field", field);
    }
    if !shape.also.is_empty() {
        put(&mut view, "also", shape.also.as_slice());
    }
    view
}

fn shape_kind(kind: ShapeKind) -> &'static str {
    match kind {
        ShapeKind::Material => "material",
        ShapeKind::Cut => "cut",
        ShapeKind::Edge => "edge",
        ShapeKind::Zone => "zone",
        ShapeKind::Probe => "probe",
        ShapeKind::Path => "path",
        ShapeKind::Dimension => "dimension",
        ShapeKind::Label => "label",
        ShapeKind::Tolerance => "tolerance",
        ShapeKind::Axis => "axis",
        ShapeKind::Touch => "touch",
    }
}

fn field(field: &form::Field, expression: Option<&str>) -> Value {
    let mut view = object([
        ("name", field.name.into()),
        ("label", message(&field.label)),
        ("help", message(&field.help)),
        ("value", field.value.as_str().into()),
        ("unit", field.unit.into()),
        ("required", field.required.into()),
        ("reason", message(&field.reason)),
        ("source", field.source.into()),
        ("kind", kind(&field.entry).into()),
    ]);
    if let Some(expression) = expression {
        put(&mut view, "expression", expression);
    }
    if field.chooses {
        put(&mut view, "chooses", true);
    }
    if let Some(code) = field.code {
        put(&mut view, "code", code);
    }
    if let Some(fallback) = field.fallback {
        put(&mut view, "fallback", fallback);
    }
    match &field.entry {
        form::Entry::Real | form::Entry::Integer => put(&mut view, "range", range(field.range)),
        form::Entry::Text(_) => {}
        form::Entry::Choice(list) => put(&mut view, "choices", choices(list)),
        form::Entry::Digits(groups) => {
            put(&mut view, "digits", groups.iter().map(group).collect::<Value>());
        }
    }
    view
}

fn kind(entry: &form::Entry) -> &'static str {
    match entry {
        form::Entry::Real => "real",
        form::Entry::Integer => "integer",
        form::Entry::Text(_) => "text",
        form::Entry::Choice(_) => "choice",
        form::Entry::Digits(_) => "digits",
    }
}

/// An open end is left out.
pub(super) fn range(range: Range) -> Value {
    let mut view = object([("minIncluded", range.min_included.into()), ("maxIncluded", range.max_included.into())]);
    if range.min.is_finite() {
        put(&mut view, "min", range.min);
    }
    if range.max.is_finite() {
        put(&mut view, "max", range.max);
    }
    view
}

fn choices(list: &[form::Choice]) -> Value {
    list.iter().map(choice).collect()
}

fn choice(choice: &form::Choice) -> Value {
    object([("value", choice.value.into()), ("label", message(&choice.label))])
}

fn group(group: &form::Group) -> Value {
    let mut view = object([
        ("label", message(&group.label)),
        ("place", group.place.into()),
        ("digits", group.digits.into()),
        ("value", group.value.into()),
        ("choices", choices(&group.choices)),
    ]);
    if !group.leads.is_empty() {
        put(&mut view, "leads", group.leads.clone());
    }
    view
}
