//! How cycles behave in the control's own simulation (B:13245-13247).

use super::{Gud, Integer, LENGTH, Real, element, gud6};

pub(super) const DATA: &[Gud] = &[
    gud6("_MC_SIMSIM", Integer, &[]).channel().elements(&[element("", "B:13245").initial(1.0).switch()]),
    gud6("_MC_SIMDIFF", Real, &[]).channel().elements(&[element("", "B:13247").unit(LENGTH)]),
];
