//! How a variant is found by who knows what to measure and not its number: the element that is measured, what is
//! corrected, and what is left to choose. So the manual shows its functions: for milling (B:1427, B:1450, B:1460,
//! B:1489, B:1546, B:1566, B:1585), for turning (B:1617, B:1639, B:1650).

use super::{Cycle, Inputs, Kind, Typed, When};
use crate::control::MachineSort;
use crate::name::Name;
use serde::Serialize;

/// What is measured, in the order in which it is offered.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum Element {
    /// Bore, hole.
    Hole,
    /// Shaft, round boss.
    Shaft,
    /// Groove, slot.
    Groove,
    /// Web, ridge.
    Web,
    /// Rectangle from inside.
    Pocket,
    /// Rectangle from outside.
    Boss,
    /// One surface.
    Edge,
    /// Two edges.
    Corner,
    /// How an edge or a plane lies.
    Angle,
    /// Ball.
    Sphere,
    /// Diameter or face of a turned part.
    Turned,
    /// Tool, at the tool probe.
    Tool,
    /// The probe itself.
    Probe,
    /// What follows from points that are known.
    Points,
    /// A free surface, point by point.
    Surface,
    /// Nothing: the probe is moved.
    Move,
}

impl Element {
    /// All of them, in their order.
    pub const ALL: [Element; 16] = [
        Element::Hole,
        Element::Shaft,
        Element::Groove,
        Element::Web,
        Element::Pocket,
        Element::Boss,
        Element::Edge,
        Element::Corner,
        Element::Angle,
        Element::Sphere,
        Element::Turned,
        Element::Tool,
        Element::Probe,
        Element::Points,
        Element::Surface,
        Element::Move,
    ];

    /// Keys of its name and of what is measured of it.
    pub fn keys(self) -> [&'static str; 2] {
        match self {
            Element::Hole => ["aim-hole", "aim-hole-what"],
            Element::Shaft => ["aim-shaft", "aim-shaft-what"],
            Element::Groove => ["aim-groove", "aim-groove-what"],
            Element::Web => ["aim-web", "aim-web-what"],
            Element::Pocket => ["aim-pocket", "aim-pocket-what"],
            Element::Boss => ["aim-boss", "aim-boss-what"],
            Element::Edge => ["aim-edge", "aim-edge-what"],
            Element::Corner => ["aim-corner", "aim-corner-what"],
            Element::Angle => ["aim-angle", "aim-angle-what"],
            Element::Sphere => ["aim-sphere", "aim-sphere-what"],
            Element::Turned => ["aim-turned", "aim-turned-what"],
            Element::Tool => ["aim-tool", "aim-tool-what"],
            Element::Probe => ["aim-probe", "aim-probe-what"],
            Element::Points => ["aim-points", "aim-points-what"],
            Element::Surface => ["aim-surface", "aim-surface-what"],
            Element::Move => ["aim-move", "aim-move-what"],
        }
    }
}

/// What is corrected, in the order in which it is offered.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum Corrects {
    /// A zero offset.
    Zero,
    /// A tool.
    Tool,
    /// The data of the workpiece probe.
    Probe,
    /// The data of the tool probe.
    Setter,
    /// Nothing: only measured.
    Nothing,
}

impl Corrects {
    /// Key of its name.
    pub fn key(self) -> &'static str {
        match self {
            Corrects::Zero => "aim-corrects-zero",
            Corrects::Tool => "aim-corrects-tool",
            Corrects::Probe => "aim-corrects-probe",
            Corrects::Setter => "aim-corrects-setter",
            Corrects::Nothing => "aim-corrects-nothing",
        }
    }
}

/// What is corrected under a condition, and the values, as typed, that the example of the variant has for it instead.
pub type MayCorrect = (When, Corrects, &'static [(Name, &'static str)]);

/// What the variants of a cycle are for.
pub struct Aims {
    /// What is measured; the first condition that holds decides.
    pub elements: &'static [(When, Element)],
    /// What is corrected; each that holds.
    pub corrects: &'static [MayCorrect],
    /// Keys of a question and its answer that no digit of the number gives; each that holds.
    pub options: &'static [(When, &'static str, &'static str)],
}

impl Aims {
    /// Of a cycle that measures nothing that is offered.
    pub const NONE: Aims = Aims { elements: &[], corrects: &[], options: &[] };
}

/// What a variant is for.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Aim {
    /// What is measured.
    pub element: Element,
    /// What is corrected.
    pub corrects: Vec<Corrected>,
    /// What is left to choose: keys of question and answer.
    pub options: Vec<[&'static str; 2]>,
}

/// What a variant corrects.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Corrected {
    /// What it is.
    pub corrects: Corrects,
    /// Key of its name.
    pub key: &'static str,
    /// Values, as typed, that the worked measurement has for it instead.
    pub values: Typed,
}

impl Cycle {
    /// What the variant of a call is for; none: it is not looked for by that.
    pub fn aim(&self, inputs: &Inputs) -> Option<Aim> {
        let (_, element) = self.aims.elements.iter().find(|(when, _)| when.holds(inputs))?;
        let corrects = self.aims.corrects.iter().filter(|(when, ..)| when.holds(inputs));
        Some(Aim {
            element: *element,
            corrects: corrects.map(|(_, corrects, given)| corrected(*corrects, given)).collect(),
            options: self.options(inputs),
        })
    }

    fn options(&self, inputs: &Inputs) -> Vec<[&'static str; 2]> {
        let machine = match self.purpose.machine {
            MachineSort::Milling => Some(["aim-machine", "aim-machine-milling"]),
            MachineSort::Turning => Some(["aim-machine", "aim-machine-turning"]),
            MachineSort::Any => None,
        };
        let own = self.aims.options.iter().filter(|(when, ..)| when.holds(inputs));
        let digits = self.params.iter().flat_map(|param| match param.kind {
            Kind::Variant(groups) => groups,
            _ => &[],
        });
        let digits = digits.filter_map(|group| Some([group.key, group.choice(inputs.variant)?]));
        machine.into_iter().chain(own.map(|(_, question, answer)| [*question, *answer])).chain(digits).collect()
    }
}

fn corrected(corrects: Corrects, given: &'static [(Name, &'static str)]) -> Corrected {
    let mut values = Typed::new();
    values.extend(given.iter().map(|(name, value)| (name.to_string(), (*value).to_owned())));
    Corrected { corrects, key: corrects.key(), values }
}
