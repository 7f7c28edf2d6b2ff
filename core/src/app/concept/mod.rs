//! Live pictures of concepts: a worked measurement carried out with a dragged value, or what is calculated, drawn.

mod sketch;

use super::form::{FormRequest, FormView, form};
use super::{Error, unknown};
use crate::catalogue::CYCLES;
use crate::catalogue::example::example as worked;
use crate::dialect::Dialect;
use crate::entry::{Cycle, Kind, ProbeUse, Typed, Variant};
use crate::manual::explained::{CONCEPTS, Example};
use crate::message::Message;
use crate::picture::figures::line;
use crate::picture::{Picture, ShapeKind};
use crate::refused::Path;
use crate::scene::plan::{extent, to_scale};
use serde::{Deserialize, Serialize};
use sketch::Sketch;
use std::cell::RefCell;
use std::collections::BTreeMap;

/// Steps over the range of a value that is dragged.
const STEPS: f64 = 100.0;

/// What is dragged in the picture of a concept.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct ConceptExample {
    /// Name of the parameter; empty: it is none.
    pub name: &'static str,
    /// What it is, in words.
    pub label: Message,
    /// Unit of its values.
    pub unit: &'static str,
    /// Least value.
    pub from: f64,
    /// Greatest value.
    pub to: f64,
    /// Value with which the picture begins.
    pub value: f64,
    /// Smallest step.
    pub step: f64,
    /// Whether only whole numbers are values of it.
    pub whole: bool,
}

/// Which picture.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct ConceptRequest {
    /// The concept.
    pub concept: String,
    /// What is dragged, in its unit; beyond an end of its range that end counts.
    pub value: f64,
}

/// The picture of a concept.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(optional_fields))]
pub struct ConceptPicture {
    /// The same paper for each value: what grows is seen to grow.
    pub picture: Picture,
    /// Values of its parameters.
    pub values: Typed,
    /// What it comes to.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub told: Option<Message>,
}

/// A worked measurement of which one value is dragged.
struct Call {
    cycle: &'static Cycle,
    variant: &'static Variant,
    drag: &'static str,
}

impl Call {
    fn of(example: &Example) -> Option<Call> {
        let (name, number) = example.of.split_once('/')?;
        let cycle = CYCLES.iter().find(|one| one.dialect == Dialect::Sinumerik && one.name == name)?;
        let variant = cycle.variants.iter().find(|one| number.parse() == Ok(one.number))?;
        Some(Call { cycle, variant, drag: example.drag })
    }

    /// The form with a value; none: with that of the worked measurement.
    fn form(&self, value: Option<f64>, predict: bool) -> Result<FormView, Error> {
        let mut values = worked(self.cycle, self.variant);
        values.extend(value.map(|value| (self.drag.to_owned(), value.to_string())));
        form(FormRequest { predict, ..FormRequest::new(self.cycle.dialect, self.cycle.name, values) })
    }

    /// The picture of a value: a part as it was measured. Of a tool, whose length is many times its probe, the help
    /// picture.
    fn drawn(&self, value: f64) -> Option<ConceptPicture> {
        let of_tool = self.cycle.purpose.probe == ProbeUse::Tool;
        let view = self.form(Some(value), !of_tool).ok()?;
        let picture = if of_tool { view.picture? } else { to_scale(&view.outcome?.trace)? };
        let values = view.fields.into_iter().map(|field| (field.name.to_string(), field.value)).collect();
        Some(ConceptPicture { picture, values, told: None })
    }

    fn example(&self, example: &Example) -> Option<ConceptExample> {
        let view = self.form(None, false).ok()?;
        let field = view.fields.into_iter().find(|field| field.name == self.drag)?;
        let whole = self.cycle.param(self.drag).is_some_and(|param| !matches!(param.kind, Kind::Real));
        let middle = field.value.parse().unwrap_or_default();
        let shown = dragged(example, self.drag, field.label, field.unit, if whole { 1.0 } else { 0.0 }).at(middle);
        Some(ConceptExample { whole, ..shown })
    }
}

impl ConceptExample {
    fn at(self, value: f64) -> ConceptExample {
        ConceptExample { value: value.clamp(self.from, self.to), ..self }
    }
}

/// `step`: 0: a hundredth of the range.
fn dragged(example: &Example, name: &'static str, label: Message, unit: &'static str, step: f64) -> ConceptExample {
    let Example { from, to, .. } = *example;
    let fine = 10_f64.powf(((to - from) / STEPS).log10().floor());
    let step = if step > 0.0 { step } else { fine };
    ConceptExample { name, label, unit, from, to, value: from, step, whole: false }
}

/// What is dragged in the picture of a concept.
pub(super) fn example(example: &Example) -> Option<ConceptExample> {
    match Sketch::of(example.of) {
        Some(sketch) => Some(sketch.example(example)),
        None => Call::of(example)?.example(example),
    }
}

/// The picture of a concept with a value.
///
/// # Errors
/// No such concept, or no picture carries it.
pub fn concept_picture(asked: ConceptRequest) -> Result<ConceptPicture, Error> {
    let none = || unknown("document-concept", &asked.concept);
    let concept = CONCEPTS.iter().find(|one| one.id == asked.concept).ok_or_else(none)?;
    let example = concept.shown.as_ref().map_err(|_| none())?;
    if !asked.value.is_finite() {
        return Err(Error::new("document-concept", Path::of(&["value"])).text("name", asked.concept));
    }
    let mut drawn = drawn(example, asked.value.clamp(example.from, example.to)).ok_or_else(none)?;
    // its corners are figures that nobody sees
    let corners = paper(concept.id, example).ok_or_else(none)?;
    drawn.picture.shapes.extend(corners.into_iter().map(|corner| line(ShapeKind::Path, vec![corner])));
    Ok(ConceptPicture { picture: drawn.picture.rounded(), ..drawn })
}

fn drawn(example: &Example, value: f64) -> Option<ConceptPicture> {
    match Sketch::of(example.of) {
        Some(sketch) => Some(sketch.draw(value)),
        None => Call::of(example)?.drawn(value),
    }
}

thread_local! {
    /// The paper of each concept: while a value is dragged, only its own measurement is carried out.
    static PAPERS: RefCell<BTreeMap<&'static str, Vec<[f64; 2]>>> = const { RefCell::new(BTreeMap::new()) };
}

/// Corners of a paper that is as large as the pictures of both ends need.
fn paper(concept: &'static str, example: &Example) -> Option<Vec<[f64; 2]>> {
    if let Some(known) = PAPERS.with_borrow(|papers| papers.get(concept).cloned()) {
        return Some(known);
    }
    let ends = [drawn(example, example.from)?, drawn(example, example.to)?];
    let corners: Vec<[f64; 2]> = ends.iter().flat_map(|end| extent(&end.picture.shapes)).collect();
    PAPERS.with_borrow_mut(|papers| papers.insert(concept, corners.clone()));
    Some(corners)
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]
    use super::*;

    // oracle: self: what is dragged is a field of the form or a quantity of the sketch, and the picture follows it
    #[test]
    fn each_picture_changes_with_what_is_dragged() {
        let mut wrong = Vec::new();
        for concept in CONCEPTS.iter() {
            let Ok(live) = &concept.shown else { continue };
            if example(live).is_none() {
                wrong.push(format!("{}: {} has no field {}", concept.id, live.of, live.drag));
                continue;
            }
            let at = |value| concept_picture(ConceptRequest { concept: concept.id.to_owned(), value });
            match (at(live.from), at(live.to)) {
                (Ok(first), Ok(last)) if first.picture != last.picture => {}
                other => wrong.push(format!("{}: no picture that changes, {:?}", concept.id, other.0.err())),
            }
        }
        assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    }

    // oracle: self: no value of the range raises an alarm, which would end the measurement in the picture
    #[test]
    fn a_dragged_measurement_comes_to_its_end() {
        for concept in CONCEPTS.iter() {
            let Ok(live) = &concept.shown else { continue };
            let Some(call) = Call::of(live) else { continue };
            for value in [live.from, (live.from + live.to) / 2.0, live.to] {
                let value = if call.drag == "_MA" { value.round() } else { value };
                let outcome = call.form(Some(value), true).unwrap().outcome;
                let stopped = outcome.map(|one| one.alarms.into_iter().filter(|alarm| alarm.stops).collect::<Vec<_>>());
                assert_eq!(stopped, Some(Vec::new()), "{} {} = {value}", concept.id, call.drag);
            }
        }
    }

    // oracle: hand
    #[test]
    fn what_has_no_picture_is_refused() {
        for (concept, value) in [("nobody", 1.0), ("bits", 1.0), ("mean-value", f64::NAN)] {
            assert!(concept_picture(ConceptRequest { concept: concept.to_owned(), value }).is_err(), "{concept}");
        }
    }
}
