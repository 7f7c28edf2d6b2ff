//! What happened in a run, with what is needed to draw it.

pub mod columns;
#[cfg(test)]
mod tool_tests;
#[cfg(test)]
mod turned_tests;

use super::Raised;
use crate::control::Control;
use crate::machine::{Entries, Setup, Step};
use crate::scene::Source;
use crate::scene::frames::{Frame, frames};
use crate::scene::tool::{Tool, tools};
use crate::scene::turned::{Drawing, drawing};
use crate::workpiece::{ProbeBody, Solid};
use serde::{Serialize, Serializer};
use std::borrow::Cow;

/// Everything that happened, with what is needed to draw it. Machine coordinates, mm.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct Trace<'a> {
    /// In order, with lines of the program from 1.
    #[cfg_attr(test, ts(type = "Array<Step & { line?: number }>"))]
    entries: Told<'a>,
    /// The probe.
    ball: Ball,
    /// Whatever was in use.
    tools: Vec<Tool>,
    /// From which entry on which of them.
    in_use: Vec<[usize; 2]>,
    /// Whether the machine turns.
    turning: bool,
    /// The part as it stands at the start.
    solids: Vec<Solid>,
    /// The caps of the tool probes.
    tool_probes: Vec<&'a Solid>,
    /// Coordinate systems.
    frames: Vec<Frame>,
    /// The part of a turning machine as on a drawing.
    #[serde(skip_serializing_if = "Option::is_none")]
    drawing: Option<Drawing>,
    /// Walls of protection zones, as shaft, web or island; shown, not touched.
    zones: &'a [Solid],
    /// The part with the largest errors on both sides.
    limits: &'a [Solid],
}

/// A step, its alarm and its line.
#[derive(Clone, Debug, PartialEq, Serialize)]
struct Happened<'a> {
    #[serde(flatten)]
    step: Cow<'a, Step>,
    #[serde(flatten)]
    alarm: Option<Raised>,
    #[serde(skip_serializing_if = "Option::is_none")]
    line: Option<u32>,
}

/// Ball, stylus and body of the probe.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
struct Ball {
    /// Radius of the ball.
    radius: f64,
    /// From the spindle nose to its centre.
    length: f64,
    /// Radius of the stylus above it.
    stylus: f64,
    /// What holds the stylus, where that is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    body: Option<ProbeBody>,
}

impl Serialize for Source {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        Trace::of(self).serialize(to)
    }
}

impl Trace<'_> {
    fn of(source: &Source) -> Trace<'_> {
        let Source { setup, outcome, zones, limits, apart, .. } = source;
        let entries = Told((!*apart).then_some(&outcome.trace.entries), &outcome.control);
        let (tools, in_use) = tools(setup, outcome);
        // a program may begin without a tool that tells
        let turning = outcome.before.turns() || outcome.control.turns();
        Trace {
            entries,
            ball: ball(setup),
            tools,
            in_use,
            turning,
            solids: setup.workpiece.solids.iter().map(|solid| setup.control.on_table(solid)).collect(),
            tool_probes: setup.tool_probes.iter().map(|probe| &probe.solid).collect(),
            frames: frames(&outcome.before, &outcome.control),
            drawing: turning.then(|| drawing(setup, outcome)),
            zones,
            limits,
        }
    }
}

/// The entries, each made as it is written; none: they are handed over apart.
#[derive(Clone, Debug, PartialEq)]
struct Told<'a>(Option<&'a Entries>, &'a Control);

impl Serialize for Told<'_> {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        to.collect_seq(self.0.into_iter().flat_map(|entries| happened(entries, self.1)))
    }
}

/// Each entry as it is told; an alarm with the remedy that this control has.
pub fn happened(entries: &Entries, control: &Control) -> impl Iterator<Item = impl Serialize> {
    entries.iter().map(|entry| Happened::new(Cow::Owned(entry.step), entry.line, control))
}

impl<'a> Happened<'a> {
    fn new(step: Cow<'a, Step>, line: Option<u32>, control: &Control) -> Happened<'a> {
        let alarm = match *step {
            Step::Alarm(code) => Some(Raised::alarm(code).on(control)),
            _ => None,
        };
        Happened { step, alarm, line: line.map(|line| line + 1) }
    }
}

fn ball(Setup { probe, .. }: &Setup) -> Ball {
    Ball { radius: probe.radius, length: probe.length, stylus: probe.stylus_radius(), body: probe.body }
}
