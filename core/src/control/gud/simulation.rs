//! How cycles behave in the control's own simulation (B:13245-13247).

use super::{Element, Gud, Kind, System, Unit, element, gud6};

/// All of this subject.
pub(super) const DATA: &[Gud] = &[
    gud6("_MC_SIMSIM", Kind::Integer, &[], MC_SIMSIM).channel(),
    gud6("_MC_SIMDIFF", Kind::Real, &[], MC_SIMDIFF).channel(),
];

const MC_SIMSIM: &[Element] = &[element("", "B:13245").initial(1.0).switch()];

const MC_SIMDIFF: &[Element] = &[element("", "B:13247").unit(Unit::Length(System::Basic))];
