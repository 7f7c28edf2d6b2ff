//! How many data fields there are (B:13345-13348), and the gauging blocks (B:13474-13481).

use super::{Gud, Integer, LENGTH, Real, element, gud6};

pub(super) const DATA: &[Gud] = &[
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
