//! A cycle carried out for its picture: on the core's own machine, and what of it is drawn.

use super::{Performed, Task, Touch, Way};
use crate::check;
use crate::control::{AXES, Edge, MachineSort, Plane, Transverse};
use crate::entry::stage::Staging;
use crate::entry::{Inputs, Proposal};
use crate::geometry::{Around, Mcs, V3};
use crate::machine::entries::Other;
use crate::machine::{InUse, MotionKind, Setup, Sim, Step, Trace, probe_place};
use crate::run::call::perform;
use crate::scene::Source;
use crate::scene::frames::{UNITS, system};
use crate::workpiece::{Boundary, Drawn, Tool, Workpiece, seen};

/// Entries of a trace after which nothing more is carried out, or looked at.
const STEPS: usize = 1000;
/// Pieces in which an arc is drawn.
const PIECES: u32 = 48;
/// Touches nearer to each other, mm, are one: in a picture, and of a part with errors that is touched several times.
const SAME: f64 = 1e-3;
const REPEATED: f64 = 0.2;

/// What was carried out: on what, what happened, in which plane; `same`: touches nearer than that, mm, are one.
struct Done<'a> {
    setup: &'a Setup,
    trace: &'a Trace,
    plane: Plane,
    same: f64,
}

impl Done<'_> {
    fn seen(&self, proposal: Proposal, staging: Staging) -> Performed {
        let steps: Vec<Step> = self.trace.entries.iter().take(STEPS).map(|entry| entry.step).collect();
        let steps: Vec<&Step> = steps.iter().collect();
        let to_ball = to_ball(&steps);
        let (ways, touches) = motions(&steps, to_ball, staging.all_ways, self.same);
        let (zero, axes) = system(&self.setup.control).unwrap_or(([0.0; 3], UNITS));
        Performed {
            complete: true,
            start: V3::from(self.setup.position.0) + to_ball,
            zero: zero.into(),
            axes: self.plane.axes().map(|axis| axes[axis].into()),
            letters: [""; 3],
            scale: 1.0,
            tool: before_touch(self.trace),
            proposal,
            staging,
            ways,
            touches,
        }
    }
}

impl Performed {
    pub(super) fn of(Task { inputs, staging }: &Task) -> Performed {
        let mut drawn = inputs.clone();
        drawn.plane = plane(inputs, staging);
        let mut setup = machine(inputs, staging);
        if staging.tool.is_some() {
            check::tool_in_use(&mut drawn, &setup.control);
        }
        vary(&mut drawn, staging.proposed.or(staging.variant));
        let proposal = inputs.cycle.work().map(|work| (work.propose)(&drawn, &setup.control)).unwrap_or_default();
        vary(&mut drawn, Some(staging.variant.unwrap_or(inputs.variant)));
        setup.workpiece = proposal.workpiece.clone();
        setup.tool_probes.clone_from(&proposal.tool_probes);
        let lying = proposal.real_tool.clone().map(|tool| (setup.control.active_place(), tool));
        setup.real_tools.extend(lying);
        for made in &proposal.tools {
            let tool = setup.control.tools.entry(made.tool).or_default();
            tool.edges.entry(made.edge).or_insert_with(|| made.data.clone());
        }
        setup.position = setup.control.to_machine(proposal.start);
        let mut sim = Sim::new(&setup);
        sim.trace_limit = STEPS;
        let complete = perform(&mut sim, &drawn).is_ok();
        let of = Done { setup: &setup, trace: &sim.trace, plane: drawn.plane, same: SAME };
        Performed {
            complete,
            letters: inputs.plane.axes().map(|axis| AXES[axis]),
            ..of.seen(proposal, staging.clone())
        }
    }

    /// The call as it was carried out on a setup, to be seen from where its picture is, in the size of a picture.
    pub(in crate::scene) fn done(inputs: &Inputs, mut staging: Staging, source: &Source) -> Performed {
        let Source { setup, outcome, zones, .. } = source;
        let proposal = Proposal {
            workpiece: setup.workpiece.clone(),
            tool_probes: setup.tool_probes.clone(),
            zones: zones.clone(),
            ..Proposal::default()
        };
        staging.ball = setup.probe.radius * staging.scale;
        let of = Done { setup, trace: &outcome.trace, plane: inputs.plane, same: REPEATED };
        let mut done = Performed { scale: staging.scale, ..of.seen(proposal, staging) };
        let touches = &done.touches;
        done.proposal.workpiece.solids.retain(|solid| {
            let boundary = Boundary::of(&Workpiece { solids: vec![solid.clone()] });
            touches.iter().any(|touch| boundary.distance(touch.at.into()).abs() < REPEATED)
        });
        done
    }
}

/// The plane in which it is carried out: that of the machine, where the cycle has one of its own.
fn plane(inputs: &Inputs, staging: &Staging) -> Plane {
    match inputs.cycle.purpose.machine {
        MachineSort::Turning => staging.plane.unwrap_or(Plane::G18),
        _ => inputs.plane,
    }
}

fn vary(inputs: &mut Inputs, variant: Option<i64>) {
    let Some(variant) = variant else { return };
    inputs.variant = variant;
    inputs.numbers.extend(inputs.cycle.variant_param().map(|name| (name, variant as f64)));
}

/// The core's own machine for the cycle, with the probe of the picture.
fn machine(inputs: &Inputs, staging: &Staging) -> Setup {
    let ball = staging.ball;
    let mut setup = Setup::for_variant(inputs.cycle, inputs.variant, plane(inputs, staging));
    for (name, value) in &staging.data {
        setup.control.set(name, *value);
    }
    if let Some(edge) = &staging.tool {
        let (tool, number) = setup.control.active_place();
        *setup.control.edge_made(tool, number) = edge.clone();
    }
    setup.control.transverse = if inputs.diameters { Transverse::Diameter } else { Transverse::Radius };
    setup.probe.radius = ball;
    setup.probe.stylus = Some(0.0); // out of the way
    let make = setup.control.make();
    let place = if make.registers { probe_place(make) } else { setup.control.active_place() };
    setup.control.calibrate(place, ball);
    let (tool, edge) = (setup.control.tool, setup.control.edge);
    if let Some(edge) = setup.control.edge_of_mut(tool, edge) {
        let lies = |tip: &i64| Edge { tip: *tip, ..edge.clone() }.body() == inputs.body;
        edge.tip = staging.tip.or_else(|| (5..=8).find(lies).filter(|_| inputs.body.is_some())).unwrap_or(edge.tip);
    }
    setup
}

/// The tool at the first touch, from the position of the machine on.
fn before_touch(trace: &Trace) -> Vec<Drawn> {
    let touches = |other: &Other| matches!(other.step, Step::Touch { .. });
    let used = trace.entries.others().find(touches).and_then(|entry| trace.in_use.get(entry.in_use));
    let tool = used.and_then(|used| Some((used, used.tool.as_ref()?)));
    let pieces = |(used, tool): (&InUse, &Tool)| seen::tool(tool, V3::from(used.length), used.plane, None).0;
    tool.map(pieces).unwrap_or_default()
}

/// From the point to which the tool length refers to the centre of the ball, as the first touch shows it.
fn to_ball(steps: &[&Step]) -> V3 {
    let touch = steps.windows(2).find_map(|pair| match pair {
        [Step::Motion { to, .. }, Step::Touch { ball, .. }] => Some(V3::from(*ball) - V3::from(*to)),
        _ => None,
    });
    touch.unwrap_or_default()
}

/// Ways and touches of a trace, each place touched once; `all`: retracting and finding nothing are ways too; `same`:
/// places nearer than that, mm, are one.
fn motions(steps: &[&Step], to_ball: V3, all: bool, same: f64) -> (Vec<Way>, Vec<Touch>) {
    let (mut ways, mut touches): (Vec<Way>, Vec<Touch>) = (Vec::new(), Vec::new());
    let mut measured = None;
    for (index, step) in steps.iter().enumerate() {
        if let Step::Motion { kind: MotionKind::Measuring, from, .. } = step {
            measured = Some(V3::from(*from) + to_ball);
        }
        match step {
            Step::Motion { kind, from, to, around, .. } if is_way(*kind, steps.get(index + 1), all) => {
                let points = course(*from, *to, around.as_ref());
                let points = points.into_iter().map(|point| V3::from(point) + to_ball).collect();
                ways.push(Way { points, round: around.is_some(), after: touches.len() });
            }
            Step::Touch { point, ball, .. } => {
                let near = |touch: &Touch| (touch.at - V3::from(*point)).norm() < same;
                if let (Some(start), false) = (measured, touches.iter().any(near)) {
                    touches.push(Touch { at: V3::from(*point), ball: V3::from(*ball), start });
                }
            }
            _ => {}
        }
    }
    (ways, touches)
}

/// Whether a motion is drawn as a way: one that measures is, where `all` are and no touch follows it.
fn is_way(kind: MotionKind, next: Option<&&Step>, all: bool) -> bool {
    match kind {
        MotionKind::Measuring => all && !matches!(next, Some(Step::Touch { .. })),
        MotionKind::Retract => all,
        _ => true,
    }
}

fn course(from: Mcs, to: Mcs, around: Option<&Around<Mcs>>) -> Vec<Mcs> {
    match around {
        Some(around) => (0..=PIECES).map(|piece| around.at(from, to, f64::from(piece) / f64::from(PIECES))).collect(),
        None => vec![from, to],
    }
}
