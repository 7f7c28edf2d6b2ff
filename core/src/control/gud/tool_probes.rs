//! Tool probes in machine and in workpiece coordinates (B:13357-13421), their make and correction tables
//! (B:13780-13821).

use super::{Gud, Integer, LENGTH, Real, SPEED, element, gud6};

pub(super) const DATA: &[Gud] = &[
    gud6("_TP", Real, &[99, 10]).counted("_CVAL[0]").elements(&[
        element("k,0", "B:13357").unit(LENGTH),
        element("k,1", "B:13358").unit(LENGTH),
        element("k,2", "B:13359").unit(LENGTH),
        element("k,3", "B:13360").unit(LENGTH),
        element("k,4", "B:13362").unit(LENGTH),
        element("k,5", "B:13363").unit(LENGTH),
        element("k,6", "B:13363").unit(LENGTH).not_negative(),
        element("k,7", "B:13365").initial(133.0).between(0.0, 333.0),
        element("k,8", "B:13366").choices(&[0, 101, 201, 301]),
        element("k,9", "B:13369").initial(2.0).unit(LENGTH).not_negative(),
    ]),
    gud6("_TPW", Real, &[99, 10]).counted("_CVAL[3]").elements(&[
        element("k,0", "B:13409").unit(LENGTH),
        element("k,1", "B:13410").unit(LENGTH),
        element("k,2", "B:13411").unit(LENGTH),
        element("k,3", "B:13412").unit(LENGTH),
        element("k,4", "B:13413").unit(LENGTH),
        element("k,5", "B:13414").unit(LENGTH),
        element("k,6", "B:13415").unit(LENGTH).not_negative(),
        element("k,7", "B:13416").initial(133.0).between(0.0, 333.0),
        element("k,8", "B:13417").choices(&[0, 101, 201, 301]),
        element("k,9", "B:13421").initial(2.0).unit(LENGTH).not_negative(),
    ]),
    gud6("_TP_CF", Integer, &[]).channel().elements(&[element("", "B:13222").choices(&[0, 1, 2])]),
    gud6("_MT_COMP", Integer, &[]).channel().elements(&[element("", "B:13226").choices(&[0, 1, 2])]),
    gud6("_MT_EC_R", Real, &[6, 5]).channel().elements(&[
        element("0,1..4", "B:13807").unit(LENGTH).not_negative(),
        element("1..5,0", "B:13808").unit(SPEED).not_negative(),
        element("1..5,1..4", "B:13809-13810").unit(LENGTH),
    ]),
    gud6("_MT_EC_L", Real, &[6, 5]).channel().elements(&[
        element("0,1..4", "B:13818").unit(LENGTH).not_negative(),
        element("1..5,0", "B:13819").unit(SPEED).not_negative(),
        element("1..5,1..4", "B:13820-13821").unit(LENGTH),
    ]),
];
