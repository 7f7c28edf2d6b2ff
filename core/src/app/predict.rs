//! What a call would do, on a part and with a probe that have the errors of the page's sliders.

use super::outcome::Outcome;
use super::start::Start;
use crate::control::Plane;
use crate::entry::{Inputs, ProbeUse, Work};
use crate::geometry::{Degrees, Mcs, Rpy, V3, rigid};
use crate::machine::{Setup, Stop, possible};
use crate::message::Message;
use crate::refused::Path;
use crate::run;
use crate::run::survives;
use crate::scene::Source;
use crate::workpiece::tool::{Cut, Tool};
use crate::workpiece::{PartErrors, Probe, Solid};
use serde::{Deserialize, Serialize};

/// What is wrong with part and probe, as the sliders of the page set it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize)]
#[serde(default)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct ErrorSliders {
    /// The part; a tool probe in its place.
    pub part: PartSliders,
    /// The workpiece probe; of a tool at a tool probe the tool.
    pub probe: ProbeSliders,
}

/// What is wrong with a part, mm and degree.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize)]
#[serde(default, rename_all = "camelCase")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct PartSliders {
    /// Displacement along X of the machine.
    pub dx: f64,
    /// Along Y.
    pub dy: f64,
    /// Along Z.
    pub dz: f64,
    /// Added to every diameter, width and length.
    pub size: f64,
    /// Turned about the applicate, degree.
    pub tilt: Degrees,
    /// Growth of the diameter per mm of depth.
    pub taper: f64,
    /// Amplitude of the three lobes of the radius.
    pub out_of_round: f64,
}

/// What is wrong with a probe, mm.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize)]
#[serde(default, rename_all = "camelCase")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct ProbeSliders {
    /// Centre of the ball off the axis, along the abscissa; of a tool its length L1.
    pub skew_x: f64,
    /// Centre of the ball off the axis, along the ordinate; of a tool its length L2.
    pub skew_y: f64,
    /// Added to the radius of the ball, or of the tool.
    pub radius: f64,
    /// Travel after contact until the signal.
    pub pre_travel: f64,
    /// Standard deviation of the switching point.
    pub repeatability: f64,
}

/// Up to which errors of the part a call comes to its end, the others being as they are.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct ErrorLimit {
    /// Name of the error among those of the part.
    #[cfg_attr(test, ts(type = "keyof PartSliders"))]
    pub error: &'static str,
    /// The smallest; none: any.
    pub low: Option<f64>,
    /// The largest; none: any.
    pub high: Option<f64>,
}

/// Carries out the call on the proposed part: what it does, with what is to be seen of it.
pub(super) fn predict(work: &Work, inputs: &Inputs, start: Start, errors: &ErrorSliders, limits: bool) -> Outcome {
    let limits = limits.then(|| survived(work, inputs, &start, errors));
    let Start { mut setup, described } = start;
    let zones = prepare(&mut setup, work, inputs, errors, described);
    let outcome = carried_out(inputs, &mut setup);
    let (limits, solids) = limits.unzip();
    let (limited, call) = (solids.unwrap_or_default(), Some(inputs.clone()));
    let source = Source { setup, outcome, zones, limits: limited, call, apart: false };
    Outcome::new(inputs, source, limits)
}

/// What the call does. With errors as large as what they change, and from a place that is beyond all numbers, nothing
/// is simulated, and drawn is what can exist.
fn carried_out(inputs: &Inputs, setup: &mut Setup) -> run::Outcome {
    let somewhere = setup.position.iter().all(|value| value.is_finite());
    let problem = match setup.exists().is_ok() {
        true if somewhere => return run::predict(inputs.cycle, inputs, setup),
        true => "run-not-finite",
        false => "run-errors",
    };
    if !somewhere {
        setup.position = Mcs([0.0; 3]);
    }
    setup.workpiece.solids.retain(|one| possible::solid(&Path::default(), one).is_ok());
    setup.tool_probes.retain(|one| possible::solid(&Path::default(), &one.solid).is_ok());
    run::Outcome { stop: Some(Stop::Fault(Message::new(problem))), ..run::Outcome::new(setup) }
}

/// An error of the part by the name of its slider.
type Slider = (&'static str, fn(&mut PartSliders) -> &mut f64);

/// Sliders whose limits are looked for.
const SLIDERS: [Slider; 4] = [
    ("size", |part| &mut part.size),
    ("dx", |part| &mut part.dx),
    ("dy", |part| &mut part.dy),
    ("dz", |part| &mut part.dz),
];

/// The largest errors that the call survives, the others being as they are, and the part with the first of them that is
/// limited: as it is on both sides.
fn survived(work: &Work, inputs: &Inputs, start: &Start, errors: &ErrorSliders) -> (Vec<ErrorLimit>, Vec<Solid>) {
    let with = |(_, slider): Slider, error: f64| {
        let (mut setup, mut errors) = (start.setup.clone(), *errors);
        *slider(&mut errors.part) = error;
        prepare(&mut setup, work, inputs, &errors, start.described);
        setup
    };
    let mut limits = Vec::new();
    let mut solids = Vec::new();
    for slider in SLIDERS {
        let possible = |error| Some(with(slider, error)).filter(|setup| setup.exists().is_ok());
        let Some(found) = survives::survived(inputs, possible) else { continue };
        limits.push(ErrorLimit { error: slider.0, low: found.low, high: found.high });
        if solids.is_empty() {
            let sides = [found.low, found.high].into_iter().flatten();
            solids.extend(sides.flat_map(|error| with(slider, error).workpiece.solids));
        }
    }
    (limits, solids)
}

/// Puts the proposed part with its errors and the probe with its own into the setup, and the probe before it.
/// A machine that the user described keeps the tools it has. Gives the protection zones.
fn prepare(setup: &mut Setup, work: &Work, inputs: &Inputs, errors: &ErrorSliders, described: bool) -> Vec<Solid> {
    let proposal = (work.propose)(inputs, &setup.control);
    setup.workpiece = proposal.workpiece;
    let part = part_errors(&errors.part, setup.control.plane);
    spoil(&mut setup.workpiece.solids, &part);
    setup.workpiece.solids.extend(proposal.fixture);
    let in_use = setup.control.active_place();
    if let Some(tool) = proposal.real_tool {
        setup.real_tools.entry(in_use).or_insert(tool);
    }
    if setup.tool_probes.is_empty() {
        setup.tool_probes = proposal.tool_probes;
        tool_errors(setup, inputs, errors);
    }
    probe_errors(&mut setup.probe, &errors.probe);
    setup.position = setup.control.to_machine(proposal.start);
    if !described {
        for proposed in proposal.tools {
            let tool = setup.control.tools.entry(proposed.tool).or_default();
            tool.name = proposed.name;
            tool.edges.entry(proposed.edge).or_insert(proposed.data);
        }
    }
    proposal.zones
}

/// Gives a tool probe the errors of part and probe, and the tool before it those of ball and skew: so much wider and,
/// in L1 and L2, longer it is than the control believes.
fn tool_errors(setup: &mut Setup, inputs: &Inputs, errors: &ErrorSliders) {
    let part = part_errors(&errors.part, setup.control.plane);
    for tool_probe in &mut setup.tool_probes {
        spoil(std::slice::from_mut(&mut tool_probe.solid), &part);
        tool_probe.pre_travel += errors.probe.pre_travel;
        tool_probe.repeatability.0 += errors.probe.repeatability;
    }
    let control = &setup.control;
    let edge = control.active_edge();
    let Some(edge) = edge.filter(|_| inputs.cycle.purpose.probe == ProbeUse::Tool) else { return };
    let nominal = || Tool::nominal(edge, control).recoded(inputs.recodes());
    let key = control.active_place();
    let tool = setup.real_tools.entry(key).or_insert_with(nominal);
    tool.length[0] += errors.probe.skew_x;
    tool.length[1] += errors.probe.skew_y;
    match &mut tool.cut {
        Cut::Cutter(cutter) => cutter.radius += errors.probe.radius,
        Cut::Nose(nose) => nose.radius += errors.probe.radius,
    }
}

/// Gives the part its errors. One of several solids is tilted as a whole, about the origin of the first.
fn spoil(solids: &mut [Solid], errors: &PartErrors) {
    let Some(about) = solids.first().map(|solid| V3::from(solid.at)) else { return };
    let turn = rigid::rotation(errors.tilt);
    for solid in solids {
        let away = V3::from(solid.at) - about;
        let shift = V3::from(errors.shift) + turn * away - away;
        solid.errors = PartErrors { shift: shift.into(), ..*errors };
    }
}

/// The errors of the sliders on top of what the probe has.
fn probe_errors(probe: &mut Probe, sliders: &ProbeSliders) {
    probe.skew = [probe.skew[0] + sliders.skew_x, probe.skew[1] + sliders.skew_y];
    probe.radius += sliders.radius;
    probe.pre_travel.0 += sliders.pre_travel;
    probe.repeatability.0 += sliders.repeatability;
}

/// Three lobes, as a three-jaw chuck leaves them.
const LOBES: u32 = 3;

/// The part is tilted about the applicate: about the axis of a hole, and askew in a chuck.
fn part_errors(sliders: &PartSliders, plane: Plane) -> PartErrors {
    PartErrors {
        shift: [sliders.dx, sliders.dy, sliders.dz],
        size: sliders.size,
        tilt: Rpy::about(plane.axes()[2], sliders.tilt),
        taper: sliders.taper,
        out_of_round: (sliders.out_of_round, LOBES),
    }
}
