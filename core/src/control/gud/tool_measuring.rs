//! CYCLE971: monitoring of a turning tool, or feeds and speeds of the user (B:13498-13520).

use super::{Element, Gud, Kind, System, Unit, element, gud6};
use crate::range::Range;

/// All of this subject.
pub(super) const DATA: &[Gud] = &[gud6("_CM", Kind::Real, &[8], CM), gud6("_MFS", Kind::Real, &[6], MFS)];

const CM: &[Element] = &[
    element("0", "B:13498").initial(100.0).unit(Unit::Speed(System::Basic)).within(Range::POSITIVE),
    element("1", "B:13499").initial(1000.0).unit(Unit::Rpm).within(Range::POSITIVE),
    element("2", "B:13500").initial(1.0).unit(Unit::Feed(System::Basic)).within(Range::NOT_NEGATIVE),
    element("3", "B:13501").initial(0.005).unit(Unit::Length(System::Basic)).within(Range::POSITIVE),
    element("4", "B:13502").initial(20.0).unit(Unit::Feed(System::Basic)).within(Range::POSITIVE),
    element("5", "B:13503").initial(4.0).choices(&[3, 4]),
    element("6", "B:13504").initial(10.0).within(Range::NOT_NEGATIVE),
    element("7", "B:13505").within(Range::NOT_NEGATIVE),
];

const MFS: &[Element] = &[
    element("0", "B:13515").unit(Unit::Rpm).within(Range::NOT_NEGATIVE),
    element("1", "B:13516").unit(Unit::Feed(System::Basic)).within(Range::NOT_NEGATIVE),
    element("2", "B:13517").unit(Unit::Rpm).within(Range::NOT_NEGATIVE),
    element("3", "B:13518").unit(Unit::Feed(System::Basic)).within(Range::NOT_NEGATIVE),
    element("4", "B:13519").unit(Unit::Rpm).within(Range::NOT_NEGATIVE),
    element("5", "B:13520").unit(Unit::Feed(System::Basic)).within(Range::NOT_NEGATIVE),
];
