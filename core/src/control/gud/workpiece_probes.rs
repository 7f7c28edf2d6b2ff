//! Workpiece probes: sizes, trigger points, skew (B:13442-13452), stylus ratio for balls (B:13240).

use super::{Gud, LENGTH, Real, element, gud6};

pub(super) const DATA: &[Gud] = &[
    // `_PRNUM` has two digits (B:2277).
    gud6("_WP", Real, &[99, 11]).counted("_CVAL[1]").elements(&[
        element("k,0", "B:13442").initial(6.0).unit(LENGTH).not_negative(),
        element("k,1", "B:13443").initial(3.0).unit(LENGTH),
        element("k,2", "B:13444").initial(-3.0).unit(LENGTH),
        element("k,3", "B:13445").initial(3.0).unit(LENGTH),
        element("k,4", "B:13446").initial(-3.0).unit(LENGTH),
        element("k,5", "B:13447").initial(3.0).unit(LENGTH),
        element("k,6", "B:13448").initial(-3.0).unit(LENGTH),
        element("k,7", "B:13449").unit(LENGTH),
        element("k,8", "B:13450").unit(LENGTH),
        element("k,9", "B:13451"),
        element("k,10", "B:13452"),
    ]),
    // Printed as INT with a value that only REAL holds (B:13240).
    gud6("_MC_MTL", Real, &[99])
        .channel()
        .counted("_CVAL[1]")
        .elements(&[element("k", "B:13240-13244").initial(33.3).not_negative()]),
];
