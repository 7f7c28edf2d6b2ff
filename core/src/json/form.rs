//! A form at every keystroke: fields, findings, snippet, picture and what the call would do.

use super::setup::{PlaneName, Start, choose_units, plane};
use super::{Error, diagnostic, dialect, message, object, put};
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
use serde_json::Value;

#[derive(Deserialize)]
struct Request {
    control: String,
    cycle: String,
    #[serde(default)]
    values: Typed,
    #[serde(default)]
    setup: Option<Value>,
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
    let request: Request = super::request(request)?;
    let cycle = catalogue::find(dialect(&request.control)?, &request.cycle).ok_or_else(|| {
        Error::Unknown {
            what: "cycle",
            name: request.cycle.clone(),
        }
    })?;
    let Start {
        mut setup,
        described,
    } = super::setup::start(cycle.dialect, request.setup)?;
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
            described,
        );
        let outcome = predict(cycle, inputs, &setup);
        let mut outcome = super::outcome(inputs, &setup, &outcome);
        put(
            &mut outcome["trace"],
            "zones",
            super::setup_write::solids(&zones),
        );
        put(&mut view, "outcome", outcome);
        set_modal(&mut setup.control, start);
        put(&mut view, "setup", super::setup_to_json(&setup));
    }
    Ok(view)
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
) -> Value {
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
    let words = comments.map(|_| &word as &dyn Fn(&str, &str) -> String);
    let written = snippet(cycle, typed, control, style, words);
    object([
        (
            "fields",
            form::fields(cycle, typed, control)
                .iter()
                .map(field)
                .collect(),
        ),
        (
            "diagnostics",
            checked.diagnostics.iter().map(diagnostic).collect(),
        ),
        ("snippet", written.text.into()),
        (
            "snippetFindings",
            written.findings.iter().map(diagnostic).collect(),
        ),
        ("complete", (!errors).into()),
        ("picture", picture(&form::draw(cycle, typed, control))),
    ])
}

/// Puts the proposed part with its errors and the probe with its own into the setup, and the probe before it.
/// A machine that the user described keeps the tools it has. Gives the protection zones.
fn prepare(
    setup: &mut Setup,
    simulation: &Simulation,
    inputs: &Inputs,
    errors: &Errors,
    described: bool,
) -> Vec<Solid> {
    let proposal = (simulation.propose)(inputs, &setup.control);
    setup.workpiece = proposal.workpiece;
    for solid in &mut setup.workpiece.solids {
        solid.errors = part_errors(&errors.part);
    }
    setup.workpiece.solids.extend(proposal.fixture);
    probe_errors(&mut setup.probe, &errors.probe);
    setup.position = setup.control.to_machine(proposal.start);
    if described {
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
    object([
        ("view", view.into()),
        ("shapes", picture.shapes.iter().map(shape).collect()),
    ])
}

fn shape(shape: &PictureShape) -> Value {
    let mut view = object([
        ("kind", shape_kind(shape.kind).into()),
        ("points", shape.points.iter().copied().collect()),
    ]);
    if let Some((at, r)) = shape.circle {
        let circle = [("x", at[0].into()), ("y", at[1].into()), ("r", r.into())];
        put(&mut view, "circle", object(circle));
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

fn field(field: &form::Field) -> Value {
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
    if let Some(fallback) = field.fallback {
        put(&mut view, "fallback", fallback);
    }
    match &field.entry {
        form::Entry::Real | form::Entry::Integer => put(&mut view, "range", range(field.range)),
        form::Entry::Text(_) => {}
        form::Entry::Choice(list) => put(&mut view, "choices", choices(list)),
        form::Entry::Digits(groups) => {
            put(
                &mut view,
                "digits",
                groups.iter().map(group).collect::<Value>(),
            );
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
    let mut view = object([
        ("minIncluded", range.min_included.into()),
        ("maxIncluded", range.max_included.into()),
    ]);
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
    object([
        ("value", choice.value.into()),
        ("label", message(&choice.label)),
    ])
}

fn group(group: &form::Group) -> Value {
    object([
        ("label", message(&group.label)),
        ("place", group.place.into()),
        ("digits", group.digits.into()),
        ("value", group.value.into()),
        ("choices", choices(&group.choices)),
    ])
}
