//! Workpiece probes: sizes, trigger points, skew (B:13442-13452), stylus ratio for balls (B:13240).

use super::{Element, Gud, Kind, System, Unit, element, gud6};
use crate::range::Range;

/// All of this subject.
pub(super) const DATA: &[Gud] = &[
    gud6("_WP", Kind::Real, &[99, 11], WP).counted("_CVAL[1]"),
    gud6("_MC_MTL", Kind::Real, &[99], MC_MTL).channel().counted("_CVAL[1]"),
];

/// `_PRNUM` has two digits (B:2277).
const WP: &[Element] = &[
    element("k,0", "B:13442").initial(6.0).unit(Unit::Length(System::Basic)).within(Range::NOT_NEGATIVE),
    element("k,1", "B:13443").initial(3.0).unit(Unit::Length(System::Basic)),
    element("k,2", "B:13444").initial(-3.0).unit(Unit::Length(System::Basic)),
    element("k,3", "B:13445").initial(3.0).unit(Unit::Length(System::Basic)),
    element("k,4", "B:13446").initial(-3.0).unit(Unit::Length(System::Basic)),
    element("k,5", "B:13447").initial(3.0).unit(Unit::Length(System::Basic)),
    element("k,6", "B:13448").initial(-3.0).unit(Unit::Length(System::Basic)),
    element("k,7", "B:13449").unit(Unit::Length(System::Basic)),
    element("k,8", "B:13450").unit(Unit::Length(System::Basic)),
    element("k,9", "B:13451"),
    element("k,10", "B:13452"),
];

/// Printed as INT with a value that only REAL holds (B:13240).
const MC_MTL: &[Element] = &[element("k", "B:13240-13244").initial(33.3).within(Range::NOT_NEGATIVE)];
