//! Probes: how many there are, of workpieces, of tools.

use super::{Gud, Integer, LENGTH, Real, SPEED, element, gud6};

/// How many data fields there are (B:13345-13348), and the gauging blocks (B:13474-13481).
pub(super) const FIELDS: &[Gud] = &[
    gud6("_CVAL", Integer, &[4]).elements(&[
        element("0", "B:13110").initial(3.0).between(0.0, 99.0),
        element("1", "B:13346").initial(3.0).between(0.0, 99.0),
        element("2", "B:13347").initial(3.0).between(0.0, 99.0),
        element("3", "B:13348").initial(3.0).between(0.0, 99.0),
    ]),
    gud6("_KB", Real, &[99, 7]).counted("_CVAL[2]").elements(&[
        element("k,0", "B:13474").unit(LENGTH),
        element("k,1", "B:13475").unit(LENGTH),
        element("k,2", "B:13476").unit(LENGTH),
        element("k,3", "B:13478").unit(LENGTH),
        element("k,4", "B:13479").unit(LENGTH),
        element("k,5", "B:13480").unit(LENGTH),
        element("k,6", "B:13481").unit(LENGTH),
    ]),
];

/// Workpiece probes: sizes, trigger points, skew (B:13442-13452), stylus ratio for balls (B:13240).
pub(super) const OF_WORKPIECES: &[Gud] = &[
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

/// Tool probes, machine and workpiece coordinates (B:13357-13421), their make and corrections (B:13780-13821).
pub(super) const OF_TOOLS: &[Gud] = &[
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
