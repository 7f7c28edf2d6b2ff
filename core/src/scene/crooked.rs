//! The part with its errors exaggerated, so that a crooked part is seen to be one.

use super::made::extent;
use super::{LineKind, Scene, Source, fit, solid};
use crate::control::Control;
use crate::geometry::{Mcs, Rpy, V3};
use crate::machine::{Entry, MotionKind, Step};
use crate::workpiece::{Boundary, Contact, PartErrors, Solid, Workpiece};

/// How far a solid may leave its place, share of its size: beyond that it would no longer be told what it is.
const MOST: f64 = 0.1;

impl Scene {
    /// What is to be seen of a run where the errors of the part are so many times as large, or as many times as still
    /// draw a part, which `View::exaggerated` says. Touches lie on the drawn surface, and measuring motions end there;
    /// labels tell the true values, all other motions are true. The part without errors is drawn in dashes.
    pub fn exaggerated(source: &Source, times: f64) -> Scene {
        let times = if times > 1.0 { possible(&source.setup.workpiece.solids, times) } else { 1.0 };
        if times <= 1.0 {
            return Scene::of(source);
        }
        let mut drawn = source.clone();
        let solids = drawn.setup.workpiece.solids.iter_mut();
        solids.for_each(|solid| solid.errors = scaled(&solid.errors, times));
        drawn.limits.clear();
        drawn.outcome.trace.entries = moved(source, times).into_iter().collect();
        let mut scene = Scene::made(&drawn, source);
        scene.view.exaggerated = Some(times);
        scene.add_nominal(source);
        scene
    }

    fn add_nominal(&mut self, source: &Source) {
        for (standing, (_, part)) in standings(source).into_iter().enumerate() {
            for nominal in part.iter().map(exact) {
                let place = nominal.place();
                let point = |at: V3| place.transform_point(&at.into()).coords;
                let edges: Vec<_> = solid::figure(&nominal).edges.iter().map(|ends| ends.map(point)).collect();
                self.add_lines(&edges, LineKind::Nominal, None, Some(standing));
            }
        }
    }
}

fn exact(solid: &Solid) -> Solid {
    Solid { errors: PartErrors::default(), ..solid.clone() }
}

fn scaled(errors: &PartErrors, times: f64) -> PartErrors {
    let PartErrors { shift, size, tilt: Rpy(tilt), taper, out_of_round: (amplitude, lobes) } = errors;
    PartErrors {
        shift: shift.map(|one| one * times),
        size: size * times,
        tilt: Rpy(tilt.map(|one| one * times)),
        taper: taper * times,
        out_of_round: (amplitude * times, *lobes),
    }
}

/// How many times errors can be as large, to two digits.
fn possible(solids: &[Solid], asked: f64) -> f64 {
    let room = |solid: &Solid| {
        let size = fit::size(&extent(&solid::figure(&exact(solid))));
        let PartErrors { shift, size: grown, tilt: Rpy(tilt), taper, out_of_round: (amplitude, _) } = &solid.errors;
        let leans = tilt.iter().map(|angle| angle.to_radians().abs()).sum::<f64>();
        let off = V3::from(*shift).norm() + (grown / 2.0).abs() + amplitude.abs() + (leans + taper.abs()) * size / 2.0;
        if off > 0.0 { MOST * size / off } else { f64::INFINITY }
    };
    let most = solids.iter().map(room).fold(asked, f64::min);
    if most >= asked || most <= 1.0 {
        return most.min(asked);
    }
    let digit = 10_f64.powf(most.log10().floor() - 1.0);
    (most / digit).floor() * digit
}

/// The part as it stands from which entry on.
fn standings(source: &Source) -> Vec<(usize, Vec<Solid>)> {
    let control: &Control = &source.setup.control;
    let part = source.setup.workpiece.solids.iter().map(|solid| control.on_table(solid)).collect();
    let turned = source.outcome.trace.entries.others().filter_map(|other| match other.step {
        Step::Table { solids, .. } => Some((other.at, solids.clone())),
        _ => None,
    });
    std::iter::once((0, part)).chain(turned).collect()
}

/// What happened, with touches and the ends of measuring motions on the part whose errors are so many times as large.
fn moved(source: &Source, times: f64) -> Vec<Entry> {
    let mut entries = source.outcome.trace.entries.to_vec();
    let mut stands = standings(source).into_iter();
    let boundary = |part: Vec<Solid>| {
        let solids = part.into_iter().map(|solid| Solid { errors: scaled(&solid.errors, times), ..solid });
        Boundary::of(&Workpiece { solids: solids.collect() })
    };
    let mut part = boundary(stands.next().map(|(_, part)| part).unwrap_or_default());
    let mut measuring = None;
    for index in 0..entries.len() {
        match &mut entries[index].step {
            Step::Table { solids, .. } => {
                solids.iter_mut().for_each(|solid| solid.errors = scaled(&solid.errors, times));
                part = boundary(stands.next().map(|(_, part)| part).unwrap_or_default());
            }
            Step::Motion { kind: MotionKind::Measuring, .. } => measuring = Some(index),
            Step::Motion { .. } => measuring = None,
            Step::Touch { by, .. } if by.measures() => {
                if let Some(motion) = measuring.take() {
                    meet(&mut entries, motion, index, &part, source.setup.probe.radius);
                }
            }
            _ => {}
        }
    }
    entries
}

/// Lets a measuring motion end where the ball meets the drawn part on the same line, and the motion behind it begin
/// there. A way that does not meet it, or that begins in it, stays true.
fn meet(entries: &mut [Entry], motion: usize, touch: usize, part: &Boundary, radius: f64) {
    let Step::Motion { from, to, .. } = entries[motion].step else { return };
    let Step::Touch { ball, .. } = entries[touch].step else { return };
    let way = V3::from(to) - V3::from(from);
    let Some(along) = way.try_normalize(1e-9) else { return };
    let ball = V3::from(ball);
    let begin = ball - way;
    let Contact::Hit(met) = part.first(radius, begin.into(), (ball + along * REACH).into()) else { return };
    let off = V3::from(met.ball) - ball;
    if let Step::Touch { ball, point, normal, .. } = &mut entries[touch].step {
        (*ball, *point, *normal) = (met.ball, met.point, met.normal);
    }
    let end: Mcs = (V3::from(to) + off).into();
    if let Step::Motion { to, .. } = &mut entries[motion].step {
        *to = end;
    }
    let next = entries[touch..].iter_mut().find_map(|entry| match &mut entry.step {
        Step::Motion { from, .. } => Some(from),
        _ => None,
    });
    if let Some(from) = next.filter(|from| **from == to) {
        *from = end;
    }
}

/// How far behind its true place a surface is looked for, mm.
const REACH: f64 = 500.0;
