//! CYCLE971: monitoring of a turning tool, or feeds and speeds of the user (B:13498-13520).

use super::{FEED, Gud, LENGTH, Real, SPEED, Unit, element, gud6};

pub(super) const DATA: &[Gud] = &[
    gud6("_CM", Real, &[8]).elements(&[
        element("0", "B:13498").initial(100.0).unit(SPEED).positive(),
        element("1", "B:13499").initial(1000.0).unit(Unit::Rpm).positive(),
        element("2", "B:13500").initial(1.0).unit(FEED).not_negative(),
        element("3", "B:13501").initial(0.005).unit(LENGTH).positive(),
        element("4", "B:13502").initial(20.0).unit(FEED).positive(),
        element("5", "B:13503").initial(4.0).choices(&[3, 4]),
        element("6", "B:13504").initial(10.0).not_negative(),
        element("7", "B:13505").not_negative(),
    ]),
    gud6("_MFS", Real, &[6]).elements(&[
        element("0", "B:13515").unit(Unit::Rpm).not_negative(),
        element("1", "B:13516").unit(FEED).not_negative(),
        element("2", "B:13517").unit(Unit::Rpm).not_negative(),
        element("3", "B:13518").unit(FEED).not_negative(),
        element("4", "B:13519").unit(Unit::Rpm).not_negative(),
        element("5", "B:13520").unit(FEED).not_negative(),
    ]),
];
