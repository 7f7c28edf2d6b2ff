//! Parameters of a call, block GUD5 (B:1744-1785). Ranges, defaults and words of the forms stand in the catalogue.

use super::{Element, Gud, Kind, System, Unit, element, gud5};

/// All of this subject.
pub(super) const DATA: &[Gud] = &[
    gud5("_SETVAL", Kind::Real, &[], SETVAL),
    gud5("_SETV", Kind::Real, &[9], SETV),
    gud5("_ID", Kind::Real, &[], ID),
    gud5("_CPA", Kind::Real, &[], CPA),
    gud5("_CPO", Kind::Real, &[], CPO),
    gud5("_SZA", Kind::Real, &[], SZA),
    gud5("_SZO", Kind::Real, &[], SZO),
    gud5("_STA1", Kind::Real, &[], STA1),
    gud5("_INCA", Kind::Real, &[], INCA),
    gud5("_MVAR", Kind::Integer, &[], MVAR),
    gud5("_MA", Kind::Integer, &[], MA),
    gud5("_MD", Kind::Integer, &[], MD),
    gud5("_TNUM", Kind::Integer, &[], TNUM),
    gud5("_TNAME", Kind::Text, &[], TNAME),
    gud5("_KNUM", Kind::Integer, &[], KNUM),
    gud5("_RA", Kind::Integer, &[], RA),
    gud5("_TENV", Kind::Text, &[], TENV),
    gud5("_DLNUM", Kind::Integer, &[], DLNUM),
    gud5("_VMS", Kind::Real, &[], VMS),
    gud5("_RF", Kind::Real, &[], RF),
    gud5("_CORA", Kind::Real, &[], CORA),
    gud5("_TZL", Kind::Real, &[], TZL),
    gud5("_TMV", Kind::Real, &[], TMV),
    gud5("_TNVL", Kind::Real, &[], TNVL),
    gud5("_TUL", Kind::Real, &[], TUL),
    gud5("_TLL", Kind::Real, &[], TLL),
    gud5("_TDIF", Kind::Real, &[], TDIF),
    gud5("_TSA", Kind::Real, &[], TSA),
    gud5("_FA", Kind::Real, &[], FA),
    gud5("_PRNUM", Kind::Integer, &[], PRNUM),
    gud5("_EVNUM", Kind::Integer, &[], EVNUM),
    gud5("_CALNUM", Kind::Integer, &[], CALNUM),
    gud5("_NMSP", Kind::Integer, &[], NMSP),
    gud5("_K", Kind::Integer, &[], K),
];

const SETVAL: &[Element] = &[element("", "B:1744").unit(Unit::Length(System::Active))];

/// Three balls need nine values (B:16655); A.1 lists eight.
const SETV: &[Element] = &[element("k", "B:1745").unit(Unit::Length(System::Active))];

const ID: &[Element] = &[element("", "B:1746").unit(Unit::Length(System::Active))];

const CPA: &[Element] = &[element("", "B:1747").unit(Unit::Length(System::Active))];

const CPO: &[Element] = &[element("", "B:1748").unit(Unit::Length(System::Active))];

const SZA: &[Element] = &[element("", "B:1749").unit(Unit::Length(System::Active))];

const SZO: &[Element] = &[element("", "B:1750").unit(Unit::Length(System::Active))];

const STA1: &[Element] = &[element("", "B:1751").unit(Unit::Degree)];

const INCA: &[Element] = &[element("", "B:1752").unit(Unit::Degree)];

const MVAR: &[Element] = &[element("", "B:1753")];

const MA: &[Element] = &[element("", "B:1754")];

const MD: &[Element] = &[element("", "B:1755")];

const TNUM: &[Element] = &[element("", "B:1756")];

const TNAME: &[Element] = &[element("", "B:1757")];

const KNUM: &[Element] = &[element("", "B:1758")];

const RA: &[Element] = &[element("", "B:1759")];

const TENV: &[Element] = &[element("", "B:1760")];

const DLNUM: &[Element] = &[element("", "B:1761")];

const VMS: &[Element] = &[element("", "B:1769").unit(Unit::Feed(System::Basic))];

const RF: &[Element] = &[element("", "B:1770").unit(Unit::Feed(System::Basic))];

const CORA: &[Element] = &[element("", "B:1771").unit(Unit::Degree)];

const TZL: &[Element] = &[element("", "B:1772").unit(Unit::Length(System::Basic))];

const TMV: &[Element] = &[element("", "B:1773").unit(Unit::Length(System::Basic))];

const TNVL: &[Element] = &[element("", "B:1774").unit(Unit::Length(System::Basic))];

const TUL: &[Element] = &[element("", "B:1775").unit(Unit::Length(System::Active))];

const TLL: &[Element] = &[element("", "B:1776").unit(Unit::Length(System::Active))];

const TDIF: &[Element] = &[element("", "B:1777").unit(Unit::Length(System::Basic))];

const TSA: &[Element] = &[element("", "B:1778").unit(Unit::Length(System::Basic))];

const FA: &[Element] = &[element("", "B:1779").unit(Unit::Length(System::Metric))];

const PRNUM: &[Element] = &[element("", "B:1781")];

const EVNUM: &[Element] = &[element("", "B:1782")];

const CALNUM: &[Element] = &[element("", "B:1783")];

const NMSP: &[Element] = &[element("", "B:1784")];

const K: &[Element] = &[element("", "B:1785")];
