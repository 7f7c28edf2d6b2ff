//! Feeds between measurements (B:13726-13734).

use super::{FEED, Gud, Real, Unit, element, gud6};

pub(super) const DATA: &[Gud] = &[
    // Appendix A.1 delivers 100 % (B:16387).
    gud6("_SPEED", Real, &[4]).channel().elements(&[
        element("0", "B:13726-13731").initial(50.0).unit(Unit::Percent).between(0.0, 100.0),
        element("1", "B:13732").initial(1000.0).unit(FEED).positive(),
        element("2", "B:13733").initial(1000.0).unit(FEED).positive(),
        element("3", "B:13734").initial(900.0).unit(FEED).positive(),
    ]),
];
