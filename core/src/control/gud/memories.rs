//! Empirical and mean values, and how many there are (B:13097-13098, B:13693-13718).

use super::{Gud, Integer, LENGTH, Real, element, gud5, gud6};

pub(super) const DATA: &[Gud] = &[
    gud6("_EVMVNUM", Integer, &[2]).channel().elements(&[
        element("0", "B:13717").initial(20.0).between(0.0, 9999.0),
        element("1", "B:13718").initial(20.0).between(0.0, 9999.0),
    ]),
    // `_EVNUM` allows 1 to 9999 (B:2325).
    gud5("_EV", Real, &[9999]).counted("_EVMVNUM[0]").elements(&[element("k", "B:13097").unit(LENGTH)]),
    gud5("_MV", Real, &[9999]).counted("_EVMVNUM[1]").elements(&[element("k", "B:13098").unit(LENGTH)]),
];
