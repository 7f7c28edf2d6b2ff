//! A help picture as the projection of a cycle at work: the proposed part, the touches and the ways of the simulation
//! on it, carried out with values that can be drawn, seen onto the plane and in sections beside that.

mod performing;
pub mod reference;
mod solid;
mod view;

pub use view::extent;

use super::Source;
use crate::catalogue::example::example;
use crate::check;
use crate::entry::stage::{SIZE, Seen, Staging};
use crate::entry::{Inputs, Proposal, Staged, address, names};
use crate::geometry::V3;
use crate::name::Name;
use crate::picture::{Picture, PictureShape, View};
use crate::workpiece::Drawn;
use std::cell::RefCell;
use std::collections::VecDeque;
use std::rc::Rc;

/// Free paper between two views, mm.
const GAP: f64 = 0.24 * SIZE;
/// Values that no picture shows and that no nominal part needs: nothing is corrected, and each place is touched once.
const NEUTRAL: [(Name, f64); 14] = [
    (names::KNUM, 0.0),
    (names::TNUM, 0.0),
    (names::DLNUM, 0.0),
    (names::EVNUM, 0.0),
    (names::K, 1.0),
    (names::PRNUM, 1.0),
    (names::NMSP, 1.0),
    (names::VMS, 0.0),
    (names::TSA, 50.0),
    (names::TDIF, 50.0),
    (names::TUL, 50.0),
    (names::TLL, -50.0),
    (names::TZL, 0.0),
    (names::TMV, 0.1),
];

/// What a macro corrects and allows.
const CORRECTIONS: [Name; 7] = [address::S, address::T, address::M, address::H, address::U, address::V, address::W];

/// Views that are kept: those of a call, and those of the worked example where the cycle stops at its values.
const KEPT: usize = 2;

thread_local! {
    /// The views that were asked for last, the newest first.
    static MADE: RefCell<VecDeque<Rc<Views>>> = const { RefCell::new(VecDeque::new()) };
}

/// The picture of a call; where the cycle stops at its values, that of the worked example.
pub fn draw(inputs: &Inputs, staged: &Staged) -> Picture {
    let views = Views::of(inputs, staged);
    if views.complete {
        return drawn(&views, inputs, staged);
    }
    let example = worked(inputs);
    drawn(&Views::of(&example, staged), &example, staged)
}

/// A call as it was carried out, a mm of the machine as a mm of the paper, with the dimensions of its picture; none:
/// its picture shows no cycle at work.
pub fn to_scale(source: &Source) -> Option<Picture> {
    let inputs = source.call.as_ref()?;
    let staged = inputs.cycle.picture.at_work()?;
    let staging = Staging { scale: 1.0, then: None, ..(staged.stage)(inputs) };
    let upright = staging.looks.first().is_some_and(|look| look.up[2] != 0.0);
    let performed = Performed::done(inputs, staging, source);
    let Laid { mut shapes, seen, .. } = laid(std::slice::from_ref(&performed), GAP);
    shapes.extend((staged.marks)(inputs, &seen));
    Some(Picture { view: if upright { View::Section } else { View::Plane }, shapes })
}

/// A cycle at work, laid out on the paper.
struct Views {
    /// All that decides over them: they are made of this alone.
    tasks: Vec<Task>,
    laid: Laid,
    complete: bool,
}

/// What is carried out for a picture: values that draw well, and how it is seen.
#[derive(PartialEq)]
struct Task {
    inputs: Inputs,
    staging: Staging,
}

impl Views {
    /// The views of a call. They have few of its values, so that at most keystrokes they are those of the one before.
    fn of(inputs: &Inputs, staged: &Staged) -> Rc<Views> {
        let tasks = tasks(inputs, staged);
        let known = |made: &VecDeque<Rc<Views>>| made.iter().find(|views| views.tasks == tasks).map(Rc::clone);
        if let Some(known) = MADE.with_borrow(known) {
            return known;
        }
        let all: Vec<Performed> = tasks.iter().map(Performed::of).collect();
        let complete = all.iter().all(|one| one.complete);
        let views = Rc::new(Views { tasks, laid: laid(&all, GAP), complete });
        MADE.with_borrow_mut(|made| {
            made.push_front(Rc::clone(&views));
            made.truncate(KEPT);
        });
        views
    }
}

fn tasks(inputs: &Inputs, staged: &Staged) -> Vec<Task> {
    let mut all = Vec::new();
    let mut next = Some((staged.stage)(inputs));
    while let Some(mut staging) = next {
        next = staging.then.take().map(|staging| *staging);
        all.push(Task::of(inputs, staging));
    }
    all
}

/// All views of it, one beside the other, with their marks.
fn drawn(views: &Views, inputs: &Inputs, staged: &Staged) -> Picture {
    let Laid { shapes, seen, .. } = &views.laid;
    let mut shapes = shapes.clone();
    shapes.extend((staged.marks)(inputs, seen));
    let upright = views.tasks.iter().flat_map(|task| &task.staging.looks).next().is_some_and(|look| look.up[2] != 0.0);
    Picture { view: if upright { View::Section } else { View::Plane }, shapes }
}

/// Views on the paper: their figures, and of each what it shows and how far it was moved there.
#[derive(Default)]
pub(super) struct Laid {
    shapes: Vec<PictureShape>,
    pub(super) seen: Vec<Seen>,
    pub(super) moved: Vec<[f64; 2]>,
}

/// Lays out all views; `gap`: free paper between two of them, mm.
pub(super) fn laid(all: &[Performed], gap: f64) -> Laid {
    let mut laid = Laid::default();
    for (one, look) in all.iter().flat_map(|one| one.staging.looks.iter().map(move |look| (one, look))) {
        let (mut figures, mut view) = one.view(look);
        let middle = |extent: [[f64; 2]; 2]| (extent[0][1] + extent[1][1]) / 2.0;
        let by = match (laid.seen.first(), laid.seen.last()) {
            (Some(first), _) if look.below => {
                [first.middle()[0] - view.middle()[0], first.extent[0][1] - gap - view.extent[1][1]]
            }
            (Some(first), Some(before)) => {
                [before.extent[1][0] + gap - view.extent[0][0], middle(first.extent) - middle(view.extent)]
            }
            _ => [0.0; 2],
        };
        figures.iter_mut().for_each(|figure| figure.shift(by));
        view.shift(by);
        laid.shapes.extend(figures);
        laid.seen.push(view);
        laid.moved.push(by);
    }
    laid
}

/// The worked example of the variant in this plane.
fn worked(inputs: &Inputs) -> Inputs {
    let cycle = inputs.cycle;
    let variants = cycle.variants.iter();
    let variant = variants.clone().find(|one| one.number == inputs.variant).or(variants.clone().next());
    let typed = variant.map(|variant| example(cycle, variant)).unwrap_or_default();
    let control = crate::control::delivery(cycle.dialect);
    let Inputs { plane, diameters, body, nose, tool_type, minus, .. } = *inputs;
    Inputs { plane, diameters, body, nose, tool_type, minus, ..check::read(cycle, &typed, &control, &mut Vec::new()) }
}

/// A way that is not measured, machine coordinates, and after how many touches it comes.
struct Way {
    points: Vec<V3>,
    round: bool,
    after: usize,
}

/// A touch, machine coordinates: point, centre of the ball there and where its measuring block begins.
struct Touch {
    at: V3,
    ball: V3,
    start: V3,
}

/// Work of a cycle, as it is drawn.
pub(super) struct Performed {
    proposal: Proposal,
    pub(super) staging: Staging,
    /// The tool at the first touch, from the position of the machine on.
    tool: Vec<Drawn>,
    ways: Vec<Way>,
    touches: Vec<Touch>,
    start: V3,
    /// Zero of the call's coordinate system, and its abscissa, ordinate and applicate, machine coordinates.
    zero: V3,
    axes: [V3; 3],
    letters: [&'static str; 3],
    /// mm of the paper for a mm of the machine.
    scale: f64,
    complete: bool,
}

impl Task {
    /// With the values that draw well in place of those of the call.
    fn of(inputs: &Inputs, staging: Staging) -> Task {
        let mut inputs = inputs.clone();
        let cycle = inputs.cycle;
        let known = |name: &Name| cycle.param(name).is_some();
        inputs.numbers.extend(NEUTRAL.into_iter().filter(|(name, _)| known(name)));
        inputs.numbers.retain(|name, _| !CORRECTIONS.contains(name) && !staging.left_out.contains(name));
        inputs.numbers.extend(staging.values.iter().copied());
        inputs.texts.clear();
        Task { inputs, staging: Staging { scale: 1.0, ..staging } } // the values are those of the picture already
    }
}

#[cfg(all(test, feature = "json"))]
mod pictogram;
#[cfg(test)]
mod tests;
