//! The macro at work: scans the rectangle and sends what it found, block by block.

use super::follow;
use crate::catalogue::nct::correct;
use crate::catalogue::prelude::*;
use crate::machine::{Scanner, too_many};
use crate::scan::text::{Form, piece};
use crate::scan::{Cloud, Layout, POINTS, Sent, TOLD};

/// What the control does. Of a long scan every motion of the first points is recorded, and their blocks. A form follows
/// only so many points as a keystroke bears, which is told and no error of the call.
pub fn simulate(machine: &mut dyn Machine, inputs: &Inputs) -> Result<(), Stop> {
    let mut scanner = follow::scanner(machine, inputs)?;
    let mut cloud = Cloud::default();
    let outcome = scan(machine, scanner.as_mut(), &mut cloud);
    machine.quiet(false);
    let (all, layout) = (cloud.points().len(), scanner.layout().clone());
    let text = piece(&cloud, &layout, Form::Program, 0..all.min(TOLD));
    for line in text.lines() {
        machine.record(Step::Sent { text: line.into() });
    }
    if let Some(message) = told(all, outcome.as_ref()) {
        machine.record(Step::Decision { message });
    }
    if outcome == Ok(Reached::End) {
        results(machine, &cloud, &layout);
    }
    machine.send(Sent { cloud, layout });
    outcome.map(|_| ())
}

/// How far a scan came.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Reached {
    End,
    /// As many points as a form follows.
    FormLimit,
}

/// What is not recorded of so many points.
fn told(all: usize, outcome: Result<&Reached, &Stop>) -> Option<Message> {
    if outcome == Ok(&Reached::FormLimit) {
        let message = Message::new("decision-p9969-form").number("followed", all as f64);
        return Some(message.number("most", POINTS as f64));
    }
    let message = Message::new("decision-p9969-told").number("told", TOLD as f64);
    (all > TOLD).then(|| message.number("all", all as f64))
}

fn scan(machine: &mut dyn Machine, scanner: &mut dyn Scanner, cloud: &mut Cloud) -> Result<Reached, Stop> {
    let limit = machine.point_limit();
    while let Some(point) = scanner.next(machine)? {
        cloud.push(point);
        machine.quiet(cloud.points().len() >= TOLD);
        if cloud.points().len() == limit {
            let form = limit < POINTS;
            return form.then_some(Reached::FormLimit).ok_or(too_many(limit));
        }
    }
    Ok(Reached::End)
}

fn results(machine: &mut dyn Machine, cloud: &Cloud, layout: &Layout) {
    let [.., axial] = layout.axes;
    machine.write("POINTS", cloud.points().len() as f64);
    machine.write("LINES", cloud.lines() as f64);
    if !cloud.points().is_empty() {
        let [low, high] = cloud.extent(axial);
        correct::results(machine, &[("LOWEST", low), ("HIGHEST", high)]);
    }
}
