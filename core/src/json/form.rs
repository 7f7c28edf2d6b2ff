//! A form at every keystroke: fields, findings, snippet, picture and what the call would do.

use super::setup::{Machine, PlaneName, choose_units, plane};
use super::{Error, diagnostic, dialect, message, number};
use crate::catalogue::{self, Cycle, Range, Simulation, Style};
use crate::check::{self, Checked, Inputs, Typed};
use crate::control::{Control, Plane, Units};
use crate::diagnostic::Severity;
use crate::form;
use crate::form::picture::{Picture, PictureShape, ShapeKind, View};
use crate::program::write::snippet;
use crate::run::predict::predict;
use crate::run::setup::Setup;
use crate::workpiece::{PartErrors, Probe, Solid};
use serde::Deserialize;
use serde_json::{Map, Value, json};

#[derive(Deserialize)]
struct Request {
    control: String,
    cycle: String,
    #[serde(default)]
    values: Typed,
    #[serde(default)]
    setup: Option<Value>,
    #[serde(default)]
    machine: Machine,
    /// G function of units in force at the call (`G70`), where it is not that of the setup.
    #[serde(default)]
    units: Option<String>,
    /// Working plane at the call, where it is not that of the setup.
    #[serde(default)]
    plane: Option<PlaneName>,
    #[serde(default)]
    errors: Option<Errors>,
    /// Words by parameter name for a comment line each; the core has no words of its own.
    #[serde(default)]
    comments: Option<Typed>,
    /// Way of writing; absent: direct.
    #[serde(default)]
    style: Option<String>,
    #[serde(default)]
    predict: bool,
}

/// What is wrong with part and probe, as the sliders of the page set it.
#[derive(Default, Deserialize)]
#[serde(default)]
struct Errors {
    part: PartSliders,
    probe: ProbeSliders,
}

#[derive(Clone, Copy, Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
struct PartSliders {
    dx: f64,
    dy: f64,
    dz: f64,
    size: f64,
    tilt: f64,
    taper: f64,
    out_of_round: f64,
}

#[derive(Clone, Copy, Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
struct ProbeSliders {
    skew_x: f64,
    skew_y: f64,
    radius: f64,
    pre_travel: f64,
    repeatability: f64,
}

/// Answers a `FormRequest` with a `FormView`.
pub fn form(request: &str) -> Result<Value, Error> {
    let request: Request = serde_json::from_str(request)?;
    let cycle = catalogue::find(dialect(&request.control)?, &request.cycle).ok_or_else(|| {
        Error::Unknown {
            what: "cycle",
            name: request.cycle.clone(),
        }
    })?;
    let own_machine = request.setup.is_some();
    let mut setup = super::setup::start(cycle.dialect, request.setup, &request.machine)?;
    let start = modal(&setup.control);
    if let Some(name) = &request.units {
        choose_units(&mut setup.control, name)?;
    }
    if let Some(name) = request.plane {
        setup.control.plane = plane(name);
    }
    let style = request
        .style
        .as_deref()
        .map_or(Ok(Style::Direct), super::style)?;
    let checked = check::check(cycle, &request.values, &setup.control);
    let mut view = view(
        cycle,
        &request.values,
        &setup,
        &checked,
        style,
        request.comments.as_ref(),
    );
    let simulation = cycle.simulation.as_ref().filter(|_| request.predict);
    if let (Some(simulation), Some(inputs)) = (simulation, &checked.inputs) {
        let zones = prepare(
            &mut setup,
            simulation,
            inputs,
            &request.errors.unwrap_or_default(),
            own_machine,
        );
        let outcome = predict(cycle, inputs, &setup);
        let mut outcome = super::outcome(inputs, &setup, &outcome)?;
        outcome["trace"]["zones"] = super::trace::solids(&zones)?;
        view.insert("outcome".into(), outcome);
        set_modal(&mut setup.control, start);
        view.insert("setup".into(), super::setup_to_json(&setup)?);
    }
    Ok(Value::Object(view))
}

/// Plane and units of a control: what a program begins with is not what counts at one of its calls.
type Modal = (Plane, Units, bool);

fn modal(control: &Control) -> Modal {
    (control.plane, control.active_units, control.data_follow)
}

fn set_modal(control: &mut Control, (plane, units, data_follow): Modal) {
    control.plane = plane;
    control.active_units = units;
    control.data_follow = data_follow;
}

fn view(
    cycle: &'static Cycle,
    typed: &Typed,
    setup: &Setup,
    checked: &Checked,
    style: Style,
    comments: Option<&Typed>,
) -> Map<String, Value> {
    let word = |name: &str, _: &str| {
        comments
            .and_then(|words| words.get(name))
            .cloned()
            .unwrap_or_default()
    };
    let control = &setup.control;
    let errors = checked
        .diagnostics
        .iter()
        .any(|found| found.severity == Severity::Error);
    let mut view = Map::new();
    let fields: Vec<Value> = form::fields(cycle, typed, control)
        .iter()
        .map(field)
        .collect();
    view.insert("fields".into(), json!(fields));
    view.insert(
        "diagnostics".into(),
        checked.diagnostics.iter().map(diagnostic).collect(),
    );
    let words = comments.map(|_| &word as &dyn Fn(&str, &str) -> String);
    let written = snippet(cycle, typed, control, style, words);
    view.insert("snippet".into(), json!(written.text));
    view.insert(
        "snippetFindings".into(),
        written.findings.iter().map(diagnostic).collect(),
    );
    view.insert("complete".into(), json!(!errors));
    view.insert(
        "picture".into(),
        picture(&form::draw(cycle, typed, control)),
    );
    view
}

/// Puts the proposed part with its errors and the probe with its own into the setup, and the probe before it.
/// A machine that the user described keeps the tools it has. Gives the protection zones.
fn prepare(
    setup: &mut Setup,
    simulation: &Simulation,
    inputs: &Inputs,
    errors: &Errors,
    own_machine: bool,
) -> Vec<Solid> {
    let proposal = (simulation.propose)(inputs, &setup.control);
    setup.workpiece = proposal.workpiece;
    for solid in &mut setup.workpiece.solids {
        solid.errors = part_errors(&errors.part);
    }
    setup.workpiece.solids.extend(proposal.fixture);
    probe_errors(&mut setup.probe, &errors.probe);
    setup.position = setup.control.to_machine(proposal.start);
    if own_machine {
        return proposal.zones;
    }
    for proposed in proposal.tools {
        let tool = setup.control.tools.entry(proposed.tool).or_default();
        tool.name = proposed.name;
        tool.edges.entry(proposed.edge).or_insert(proposed.data);
    }
    proposal.zones
}

/// The errors of the sliders on top of what the probe has.
fn probe_errors(probe: &mut Probe, sliders: &ProbeSliders) {
    probe.skew = [
        probe.skew[0] + sliders.skew_x,
        probe.skew[1] + sliders.skew_y,
    ];
    probe.radius += sliders.radius;
    probe.pre_travel.0 += sliders.pre_travel;
    probe.repeatability.0 += sliders.repeatability;
}

/// Three lobes, as a three-jaw chuck leaves them.
const LOBES: u32 = 3;

fn part_errors(sliders: &PartSliders) -> PartErrors {
    PartErrors {
        shift: [sliders.dx, sliders.dy, sliders.dz],
        size: sliders.size,
        tilt: [0.0, 0.0, sliders.tilt],
        taper: sliders.taper,
        out_of_round: (sliders.out_of_round, LOBES),
    }
}

fn picture(picture: &Picture) -> Value {
    let view = match picture.view {
        View::Plane => "plane",
        View::Section => "section",
    };
    json!({ "view": view, "shapes": picture.shapes.iter().map(shape).collect::<Vec<_>>() })
}

fn shape(shape: &PictureShape) -> Value {
    let mut object = Map::new();
    object.insert("kind".into(), json!(shape_kind(shape.kind)));
    object.insert("points".into(), json!(shape.points));
    if let Some((at, r)) = shape.circle {
        object.insert("circle".into(), json!({ "x": at[0], "y": at[1], "r": r }));
    }
    if shape.closed {
        object.insert("closed".into(), json!(true));
    }
    if let Some(text) = &shape.text {
        object.insert("text".into(), json!(text));
    }
    if let Some(field) = shape.field {
        object.insert("field".into(), json!(field));
    }
    Value::Object(object)
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

fn field(field: &form::Field) -> Value {
    let mut object = Map::new();
    object.insert("name".into(), json!(field.name));
    object.insert("label".into(), message(&field.label));
    object.insert("help".into(), message(&field.help));
    object.insert("value".into(), json!(field.value));
    object.insert("unit".into(), json!(field.unit));
    object.insert("required".into(), json!(field.required));
    object.insert("reason".into(), message(&field.reason));
    object.insert("source".into(), json!(field.source));
    if let Some(fallback) = field.fallback {
        object.insert("fallback".into(), number(fallback));
    }
    let kind = match &field.entry {
        form::Entry::Real => "real",
        form::Entry::Integer => "integer",
        form::Entry::Text(_) => "text",
        form::Entry::Choice(choices) => {
            object.insert("choices".into(), choices.iter().map(choice).collect());
            "choice"
        }
        form::Entry::Digits(groups) => {
            object.insert("digits".into(), groups.iter().map(group).collect());
            "digits"
        }
    };
    object.insert("kind".into(), json!(kind));
    if matches!(field.entry, form::Entry::Real | form::Entry::Integer) {
        object.insert("range".into(), range(field.range));
    }
    Value::Object(object)
}

/// An open end is left out.
fn range(range: Range) -> Value {
    let mut object = Map::new();
    if range.min.is_finite() {
        object.insert("min".into(), number(range.min));
    }
    if range.max.is_finite() {
        object.insert("max".into(), number(range.max));
    }
    object.insert("minIncluded".into(), json!(range.min_included));
    object.insert("maxIncluded".into(), json!(range.max_included));
    Value::Object(object)
}

fn choice(choice: &form::Choice) -> Value {
    json!({ "value": choice.value, "label": message(&choice.label) })
}

fn group(group: &form::Group) -> Value {
    json!({
        "label": message(&group.label),
        "place": group.place,
        "digits": group.digits,
        "value": group.value,
        "choices": group.choices.iter().map(choice).collect::<Vec<_>>(),
    })
}
