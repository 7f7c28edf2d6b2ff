//! How many data fields there are (B:13345-13348), and the gauging blocks (B:13474-13481).

use super::{Element, Gud, Kind, System, Unit, element, gud6};
use crate::range::Range;

/// All of this subject.
pub(super) const DATA: &[Gud] =
    &[gud6("_CVAL", Kind::Integer, &[4], CVAL), gud6("_KB", Kind::Real, &[99, 7], KB).counted("_CVAL[2]")];

const CVAL: &[Element] = &[
    element("0", "B:13110").initial(3.0).within(Range::closed(0.0, 99.0)),
    element("1", "B:13346").initial(3.0).within(Range::closed(0.0, 99.0)),
    element("2", "B:13347").initial(3.0).within(Range::closed(0.0, 99.0)),
    element("3", "B:13348").initial(3.0).within(Range::closed(0.0, 99.0)),
];

const KB: &[Element] = &[
    element("k,0", "B:13474").unit(Unit::Length(System::Basic)),
    element("k,1", "B:13475").unit(Unit::Length(System::Basic)),
    element("k,2", "B:13476").unit(Unit::Length(System::Basic)),
    element("k,3", "B:13478").unit(Unit::Length(System::Basic)),
    element("k,4", "B:13479").unit(Unit::Length(System::Basic)),
    element("k,5", "B:13480").unit(Unit::Length(System::Basic)),
    element("k,6", "B:13481").unit(Unit::Length(System::Basic)),
];
