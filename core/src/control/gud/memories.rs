//! Empirical and mean values, and how many there are (B:13097-13098, B:13693-13718).

use super::{Element, Gud, Kind, System, Unit, element, gud5, gud6};
use crate::range::Range;

/// All of this subject.
pub(super) const DATA: &[Gud] = &[
    gud6("_EVMVNUM", Kind::Integer, &[2], EVMVNUM).channel(),
    gud5("_EV", Kind::Real, &[9999], EV).counted("_EVMVNUM[0]"),
    gud5("_MV", Kind::Real, &[9999], MV).counted("_EVMVNUM[1]"),
];

const EVMVNUM: &[Element] = &[
    element("0", "B:13717").initial(20.0).within(Range::closed(0.0, 9999.0)),
    element("1", "B:13718").initial(20.0).within(Range::closed(0.0, 9999.0)),
];

/// `_EVNUM` allows 1 to 9999 (B:2325).
const EV: &[Element] = &[element("k", "B:13097").unit(Unit::Length(System::Basic))];

const MV: &[Element] = &[element("k", "B:13098").unit(Unit::Length(System::Basic))];
