//! Whether something that moves can touch the part at all; what is far away need not be looked at.

use super::body::Body;
use super::contact::Boundary;
use crate::geometry::V3;
use crate::geometry::swept::Swept;

impl Boundary {
    /// Whether a ball or rod may touch the part on its stretch, or is within it: false is sure.
    pub fn may_meet(&self, swept: &Swept) -> bool {
        self.bodies.iter().any(|body| may_meet(body, swept))
    }

    /// How many solids there are.
    pub fn solids(&self) -> usize {
        self.bodies.len()
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
        return free.mesh.reaches_into(&extent)
            && (!ball || free.mesh.nearest(&swept.way.at(0.5), reach).is_some());
    }
    let mut features = body.features.iter().zip(&body.extents);
    features.any(|(feature, place)| place.meets(&extent) && !swept.clears(feature))
        || body.inside(&swept.way.at(0.0))
}
