//! Parameters of a call, block GUD5 (B:1744-1785), and its results; their ranges, defaults and words: the catalogue.

use super::{ACTIVE, FEED, Gud, Integer, LENGTH, MM, Real, Text, Unit, element, gud5};

pub(super) const DATA: &[Gud] = &[
    gud5("_SETVAL", Real, &[]).elements(&[element("", "B:1744").unit(ACTIVE)]),
    // Three balls need nine values (B:16655); A.1 lists eight.
    gud5("_SETV", Real, &[9]).elements(&[element("k", "B:1745").unit(ACTIVE)]),
    gud5("_ID", Real, &[]).elements(&[element("", "B:1746").unit(ACTIVE)]),
    gud5("_CPA", Real, &[]).elements(&[element("", "B:1747").unit(ACTIVE)]),
    gud5("_CPO", Real, &[]).elements(&[element("", "B:1748").unit(ACTIVE)]),
    gud5("_SZA", Real, &[]).elements(&[element("", "B:1749").unit(ACTIVE)]),
    gud5("_SZO", Real, &[]).elements(&[element("", "B:1750").unit(ACTIVE)]),
    gud5("_STA1", Real, &[]).elements(&[element("", "B:1751").unit(Unit::Degree)]),
    gud5("_INCA", Real, &[]).elements(&[element("", "B:1752").unit(Unit::Degree)]),
    gud5("_MVAR", Integer, &[]).elements(&[element("", "B:1753")]),
    gud5("_MA", Integer, &[]).elements(&[element("", "B:1754")]),
    gud5("_MD", Integer, &[]).elements(&[element("", "B:1755")]),
    gud5("_TNUM", Integer, &[]).elements(&[element("", "B:1756")]),
    gud5("_TNAME", Text, &[]).elements(&[element("", "B:1757")]),
    gud5("_KNUM", Integer, &[]).elements(&[element("", "B:1758")]),
    gud5("_RA", Integer, &[]).elements(&[element("", "B:1759")]),
    gud5("_TENV", Text, &[]).elements(&[element("", "B:1760")]),
    gud5("_DLNUM", Integer, &[]).elements(&[element("", "B:1761")]),
    gud5("_VMS", Real, &[]).elements(&[element("", "B:1769").unit(FEED)]),
    gud5("_RF", Real, &[]).elements(&[element("", "B:1770").unit(FEED)]),
    gud5("_CORA", Real, &[]).elements(&[element("", "B:1771").unit(Unit::Degree)]),
    gud5("_TZL", Real, &[]).elements(&[element("", "B:1772").unit(LENGTH)]),
    gud5("_TMV", Real, &[]).elements(&[element("", "B:1773").unit(LENGTH)]),
    gud5("_TNVL", Real, &[]).elements(&[element("", "B:1774").unit(LENGTH)]),
    gud5("_TUL", Real, &[]).elements(&[element("", "B:1775").unit(ACTIVE)]),
    gud5("_TLL", Real, &[]).elements(&[element("", "B:1776").unit(ACTIVE)]),
    gud5("_TDIF", Real, &[]).elements(&[element("", "B:1777").unit(LENGTH)]),
    gud5("_TSA", Real, &[]).elements(&[element("", "B:1778").unit(LENGTH)]),
    gud5("_FA", Real, &[]).elements(&[element("", "B:1779").unit(MM)]),
    gud5("_PRNUM", Integer, &[]).elements(&[element("", "B:1781")]),
    gud5("_EVNUM", Integer, &[]).elements(&[element("", "B:1782")]),
    gud5("_CALNUM", Integer, &[]).elements(&[element("", "B:1783")]),
    gud5("_NMSP", Integer, &[]).elements(&[element("", "B:1784")]),
    gud5("_K", Integer, &[]).elements(&[element("", "B:1785")]),
];

/// Results of a call (B:1837-1838, B:16642).
pub(super) const RESULTS: &[Gud] = &[
    gud5("_OVR", Real, &[32]).elements(&[element("k", "B:1837")]),
    gud5("_OVI", Integer, &[20]).elements(&[element("k", "B:1838")]),
];
