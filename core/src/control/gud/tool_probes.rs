//! Tool probes in machine and in workpiece coordinates (B:13357-13421), their make and correction tables
//! (B:13780-13821).

use super::{Element, Gud, Kind, System, Unit, element, gud6};
use crate::range::Range;

/// All of this subject.
pub(super) const DATA: &[Gud] = &[
    gud6("_TP", Kind::Real, &[99, 10], TP).counted("_CVAL[0]"),
    gud6("_TPW", Kind::Real, &[99, 10], TPW).counted("_CVAL[3]"),
    gud6("_TP_CF", Kind::Integer, &[], TP_CF).channel(),
    gud6("_MT_COMP", Kind::Integer, &[], MT_COMP).channel(),
    gud6("_MT_EC_R", Kind::Real, &[6, 5], MT_EC_R).channel(),
    gud6("_MT_EC_L", Kind::Real, &[6, 5], MT_EC_L).channel(),
];

const TP: &[Element] = &[
    element("k,0", "B:13357").unit(Unit::Length(System::Basic)),
    element("k,1", "B:13358").unit(Unit::Length(System::Basic)),
    element("k,2", "B:13359").unit(Unit::Length(System::Basic)),
    element("k,3", "B:13360").unit(Unit::Length(System::Basic)),
    element("k,4", "B:13362").unit(Unit::Length(System::Basic)),
    element("k,5", "B:13363").unit(Unit::Length(System::Basic)),
    element("k,6", "B:13363").unit(Unit::Length(System::Basic)).within(Range::NOT_NEGATIVE),
    element("k,7", "B:13365").initial(133.0).within(Range::closed(0.0, 333.0)),
    element("k,8", "B:13366").choices(&[0, 101, 201, 301]),
    element("k,9", "B:13369").initial(2.0).unit(Unit::Length(System::Basic)).within(Range::NOT_NEGATIVE),
];

const TPW: &[Element] = &[
    element("k,0", "B:13409").unit(Unit::Length(System::Basic)),
    element("k,1", "B:13410").unit(Unit::Length(System::Basic)),
    element("k,2", "B:13411").unit(Unit::Length(System::Basic)),
    element("k,3", "B:13412").unit(Unit::Length(System::Basic)),
    element("k,4", "B:13413").unit(Unit::Length(System::Basic)),
    element("k,5", "B:13414").unit(Unit::Length(System::Basic)),
    element("k,6", "B:13415").unit(Unit::Length(System::Basic)).within(Range::NOT_NEGATIVE),
    element("k,7", "B:13416").initial(133.0).within(Range::closed(0.0, 333.0)),
    element("k,8", "B:13417").choices(&[0, 101, 201, 301]),
    element("k,9", "B:13421").initial(2.0).unit(Unit::Length(System::Basic)).within(Range::NOT_NEGATIVE),
];

const TP_CF: &[Element] = &[element("", "B:13222").choices(&[0, 1, 2])];

const MT_COMP: &[Element] = &[element("", "B:13226").choices(&[0, 1, 2])];

const MT_EC_R: &[Element] = &[
    element("0,1..4", "B:13807").unit(Unit::Length(System::Basic)).within(Range::NOT_NEGATIVE),
    element("1..5,0", "B:13808").unit(Unit::Speed(System::Basic)).within(Range::NOT_NEGATIVE),
    element("1..5,1..4", "B:13809-13810").unit(Unit::Length(System::Basic)),
];

const MT_EC_L: &[Element] = &[
    element("0,1..4", "B:13818").unit(Unit::Length(System::Basic)).within(Range::NOT_NEGATIVE),
    element("1..5,0", "B:13819").unit(Unit::Speed(System::Basic)).within(Range::NOT_NEGATIVE),
    element("1..5,1..4", "B:13820-13821").unit(Unit::Length(System::Basic)),
];
