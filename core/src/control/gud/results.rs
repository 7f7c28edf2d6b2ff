//! Results of a call (B:1837-1838, B:16642).

use super::{Element, Gud, Kind, element, gud5};

/// All of this subject.
pub(super) const DATA: &[Gud] = &[gud5("_OVR", Kind::Real, &[32], OVR), gud5("_OVI", Kind::Integer, &[20], OVI)];

const OVR: &[Element] = &[element("k", "B:1837")];

const OVI: &[Element] = &[element("k", "B:1838")];
