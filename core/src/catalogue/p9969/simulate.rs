//! The macro at work: scans the rectangle and sends what it found, block by block.

use super::follow;
use crate::catalogue::nct::correct;
use crate::check::Inputs;
use crate::message::Message;
use crate::run::trace::Step;
use crate::run::{Machine, Stop};
use crate::scan::session::too_many;
use crate::scan::text::{Form, piece};
use crate::scan::{Cloud, Layout, Scanner, Sent, TOLD};

/// What the control does. Of a long scan every motion of the first points is recorded, and their blocks.
pub fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    let mut scanner = follow::scanner(machine, inputs)?;
    let mut cloud = Cloud::default();
    let outcome = scan(machine, scanner.as_mut(), &mut cloud);
    machine.quiet(false);
    let (all, layout) = (cloud.points().len(), scanner.layout().clone());
    let text = piece(&cloud, &layout, Form::Program, 0..all.min(TOLD));
    for line in text.lines() {
        machine.record(Step::Sent(line.into()));
    }
    if all > TOLD {
        let message = Message::new("decision-p9969-told");
        let message = message
            .number("told", TOLD as f64)
            .number("all", all as f64);
        machine.record(Step::Decision(message));
    }
    if outcome.is_ok() {
        results(machine, &cloud, &layout);
    }
    machine.send(Sent { cloud, layout });
    outcome
}

fn scan(
    machine: &mut dyn Machine,
    scanner: &mut dyn Scanner,
    cloud: &mut Cloud,
) -> Result<(), Stop> {
    while let Some(point) = scanner.next(machine)? {
        cloud.push(point);
        machine.quiet(cloud.points().len() >= TOLD);
        if cloud.points().len() == machine.point_limit() {
            return Err(too_many(machine.point_limit()));
        }
    }
    Ok(())
}

fn results(machine: &mut dyn Machine, cloud: &Cloud, layout: &Layout) {
    let [.., axial] = layout.axes;
    correct::datum(machine, "POINTS", cloud.points().len() as f64);
    correct::datum(machine, "LINES", cloud.lines() as f64);
    if !cloud.points().is_empty() {
        let [low, high] = cloud.extent(axial);
        correct::results(machine, &[("LOWEST", low), ("HIGHEST", high)]);
    }
}
