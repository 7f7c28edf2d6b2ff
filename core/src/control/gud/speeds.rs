//! Feeds between measurements (B:13726-13734).

use super::{Element, Gud, Kind, System, Unit, element, gud6};
use crate::range::Range;

/// All of this subject.
pub(super) const DATA: &[Gud] = &[gud6("_SPEED", Kind::Real, &[4], SPEED).channel()];

/// Appendix A.1 delivers 100 % (B:16387).
const SPEED: &[Element] = &[
    element("0", "B:13726-13731").initial(50.0).unit(Unit::Percent).within(Range::closed(0.0, 100.0)),
    element("1", "B:13732").initial(1000.0).unit(Unit::Feed(System::Basic)).within(Range::POSITIVE),
    element("2", "B:13733").initial(1000.0).unit(Unit::Feed(System::Basic)).within(Range::POSITIVE),
    element("3", "B:13734").initial(900.0).unit(Unit::Feed(System::Basic)).within(Range::POSITIVE),
];
