//! Whether something that moves can touch the part at all; what is far away need not be looked at.

use super::{Body, Boundary};
use crate::geometry::{Feature, Swept, V3};

/// A wall out of round is searched all round for its nearest place.
const LOBED: usize = 50;

impl Boundary {
    /// Whether a ball or rod may touch the part on its stretch, or is within it: false is sure.
    pub fn may_meet(&self, swept: &Swept) -> bool {
        self.bodies.iter().any(|body| may_meet(body, swept))
    }

    /// How long something is held against the part, in solids that are quick to look at; one out of round is not.
    pub fn weight(&self) -> usize {
        let lobed = |feature: &Feature| matches!(feature, Feature::Lobed(_));
        let weight = |body: &Body| if body.features.iter().any(lobed) { LOBED } else { 1 };
        self.bodies.iter().map(weight).sum()
    }
}

fn may_meet(body: &Body, swept: &Swept) -> bool {
    let swept = swept.seen(&body.place);
    let extent = swept.extent();
    if !extent.meets(&body.extent) {
        return false;
    }
    if let Some(free) = &body.free {
        let ball = swept.rise == V3::zeros();
        let reach = swept.way.half() + swept.radius;
        return free.mesh.reaches_into(&extent) && (!ball || free.mesh.nearest(&swept.way.at(0.5), reach).is_some());
    }
    let mut features = body.features.iter().zip(&body.extents);
    features.any(|(feature, place)| place.meets(&extent) && !swept.clears(feature)) || body.inside(&swept.way.at(0.0))
}
