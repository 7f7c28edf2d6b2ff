//! What several values of CYCLE998 say together.

use super::angles::{Surface, ways};
use super::params::{AT_ANGLE, DIFFERENTIAL, ONE};
use crate::catalogue::prelude::*;
use crate::catalogue::spread;
use crate::evaluate::spread::Touched;

/// Cosine of 1 degree: a rotary axis that is no nearer to the direction about which the angle turns cannot take it.
const ALIKE: f64 = 0.9998;

/// All of them.
pub fn checks(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    shared_checks::probe(inputs, control, found);
    shared_checks::mirror(control, found);
    shared_checks::memories(inputs, control, found);
    shared_checks::takes_rotation(names::KNUM, inputs, found);
    shared_checks::lathe_length(inputs, control, found);
    if DIFFERENTIAL.holds(inputs) {
        shared_checks::differential(inputs, control, found);
    }
    rotary_axis(inputs, control, found);
    found.extend(bases(inputs));
    let said = if AT_ANGLE.holds(inputs) { along_the_angle } else { along_the_axis };
    found.extend(legs(inputs).find_map(|leg| said(inputs, &leg)));
}

/// A way from the first point to another one.
struct Leg {
    /// Names of the angle that the surface should have along it, and of the distance.
    name: Name,
    by: Name,
    /// Set angle without its sign, degree.
    angle: f64,
    /// Distance of the points, mm.
    distance: f64,
}

impl Leg {
    /// How far the surface rises when it is steeper by this angle, mm.
    fn rise(&self, more: f64) -> f64 {
        self.distance * (self.angle + more).to_radians().tan()
    }
}

/// The ways of this variant whose values are known.
fn legs(inputs: &Inputs) -> impl Iterator<Item = Leg> {
    ways(inputs).iter().filter_map(|[name, by]| {
        Some(Leg { name: *name, by: *by, angle: inputs.given(*name)?.abs(), distance: inputs.given(*by)? })
    })
}

/// The shortest of the ways, where it is too short for an angle. The surface is touched along the measuring axis.
fn bases(inputs: &Inputs) -> Option<Diagnostic> {
    let mut legs: Vec<Leg> = legs(inputs).filter(|leg| leg.distance > 0.0).collect();
    legs.sort_by(|one, other| one.distance.total_cmp(&other.distance));
    legs.iter().find_map(|leg| {
        let touched = [[0.0; 2], [leg.distance, leg.rise(0.0)]].map(|at| Touched { at, towards: [0.0, 1.0] });
        spread::angle(touched, leg.by)
    })
}

/// Between the points the probe keeps `_TSA` away from the set surface, which the path has to bridge (B:7422, B:7546).
fn along_the_angle(inputs: &Inputs, leg: &Leg) -> Option<Diagnostic> {
    let (area, path) = (inputs.given(names::TSA)?, inputs.given(names::FA)?);
    if leg.angle + area >= 90.0 {
        let finding = own::ANGLE_STEEP.finding().text("param", leg.name).number("sum", leg.angle + area);
        return Some(finding.hint_number("limit", 90.0 - leg.angle).at(names::TSA));
    }
    let away = leg.rise(area) - leg.rise(0.0);
    let worst = leg.rise(area) - leg.rise(-area);
    let finding = if away > path {
        let ahead = ((path + away) * 1e3).round() / 1e3;
        own::ANGLE_REACH.finding().number("away", ahead).number("path", 2.0 * path)
    } else if worst > path {
        own::ANGLE_REACH_WORST.finding().number("area", area)
    } else {
        return None;
    };
    // µm are enough for a reader, and what is advised must be enough as well
    Some(finding.hint_number("needed", (worst * 1e3).ceil() / 1e3).at(names::FA))
}

/// Without a set position both points have to lie within the whole measuring path (B:7554).
fn along_the_axis(inputs: &Inputs, leg: &Leg) -> Option<Diagnostic> {
    let path = inputs.given(names::FA)?;
    let rise = leg.rise(0.0);
    let finding = own::ANGLE_PARAXIAL.finding().number("rise", rise).number("path", 2.0 * path);
    (rise > 2.0 * path).then(|| finding.hint_number("needed", rise / 2.0).at(names::FA))
}

/// The channel axis has to have a name and to be rotary (MD20080, MD30300, A:15872).
fn rotary_axis(inputs: &Inputs, control: &Control, found: &mut Vec<Diagnostic>) {
    let Some(axis) = inputs.given(names::RA).filter(|axis| *axis > 0.0) else { return };
    let Some(rotary) = control.rotary_channel_axis(axis as i64) else {
        found.push(refused(61329, "check-rotary-axis", names::RA).number("axis", axis));
        return;
    };
    let alike = |surface: Surface| surface.alike(control, rotary).abs() > ALIKE;
    if ONE.holds(inputs) && !Surface::of(inputs).is_none_or(alike) {
        found.push(own::ROTARY_ACROSS.finding().at(names::RA));
    }
}
