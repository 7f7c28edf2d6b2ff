//! Measuring in JOG, block GUD7 (B:14170-14305).

use super::{Element, Gud, Kind, System, Unit, element, gud7};
use crate::range::Range;

/// All of this subject.
pub(super) const DATA: &[Gud] = &[
    gud7("E_MESS_IS_METRIC", Kind::Integer, &[], E_MESS_IS_METRIC),
    gud7("E_MESS_IS_METRIC_SPEZ_VAR", Kind::Integer, &[], E_MESS_IS_METRIC_SPEZ_VAR),
    gud7("E_MESS_MS_IN", Kind::Bool, &[], E_MESS_MS_IN),
    gud7("E_MESS_MT_IN", Kind::Bool, &[], E_MESS_MT_IN),
    gud7("E_MESS_D", Kind::Real, &[], E_MESS_D),
    gud7("E_MESS_D_M", Kind::Real, &[], E_MESS_D_M),
    gud7("E_MESS_D_L", Kind::Real, &[], E_MESS_D_L),
    gud7("E_MESS_D_R", Kind::Real, &[], E_MESS_D_R),
    gud7("E_MESS_FM", Kind::Real, &[], E_MESS_FM),
    gud7("E_MESS_F", Kind::Real, &[], E_MESS_F),
    gud7("E_MESS_FZ", Kind::Real, &[], E_MESS_FZ),
    gud7("E_MESS_CAL_D", Kind::Real, &[3], E_MESS_CAL_D),
    gud7("E_MESS_CAL_L", Kind::Real, &[3], E_MESS_CAL_L),
    gud7("E_MESS_MAX_V", Kind::Real, &[], E_MESS_MAX_V),
    gud7("E_MESS_MAX_S", Kind::Real, &[], E_MESS_MAX_S),
    gud7("E_MESS_MAX_F", Kind::Real, &[], E_MESS_MAX_F),
    gud7("E_MESS_MIN_F", Kind::Real, &[], E_MESS_MIN_F),
    gud7("E_MESS_F_FAK1", Kind::Real, &[], E_MESS_F_FAK1),
    gud7("E_MESS_F_FAK2", Kind::Real, &[], E_MESS_F_FAK2),
    gud7("E_MESS_MIN_D", Kind::Real, &[], E_MESS_MIN_D),
    gud7("E_MESS_MS_SOUTH", Kind::Integer, &[], E_MESS_MS_SOUTH),
    gud7("E_MESS_MS_MONO", Kind::Integer, &[], E_MESS_MS_MONO),
    gud7("E_MESS_MT_TYP", Kind::Integer, &[3], E_MESS_MT_TYP),
    gud7("E_MESS_MT_AX", Kind::Integer, &[3], E_MESS_MT_AX),
    gud7("E_MESS_MT_DL", Kind::Real, &[3], E_MESS_MT_DL),
    gud7("E_MESS_MT_DR", Kind::Real, &[3], E_MESS_MT_DR),
    gud7("E_MESS_MT_DZ", Kind::Real, &[3], E_MESS_MT_DZ),
    gud7("E_MESS_MT_DIR", Kind::Integer, &[3], E_MESS_MT_DIR),
    gud7("E_MESS_MT_D", Kind::Real, &[], E_MESS_MT_D),
    gud7("E_MESS_MT_FM", Kind::Real, &[], E_MESS_MT_FM),
    gud7("E_MESS_MT_CF", Kind::Integer, &[], E_MESS_MT_CF),
    gud7("E_MESS_MT_COMP", Kind::Integer, &[], E_MESS_MT_COMP),
    gud7("E_MESS", Kind::Real, &[3], E_MESS),
    gud7("E_MEAS", Kind::Real, &[], E_MEAS),
    gud7("E_MESS_RETT", Kind::Frame, &[], E_MESS_RETT),
    gud7("E_MESS_SETT", Kind::Bool, &[10], E_MESS_SETT),
    gud7("E_MESS_AM", Kind::Bool, &[], E_MESS_AM),
];

const E_MESS_IS_METRIC: &[Element] = &[element("", "B:14170").initial(1.0).switch()];

const E_MESS_IS_METRIC_SPEZ_VAR: &[Element] = &[element("", "B:14171").initial(1.0).switch()];

const E_MESS_MS_IN: &[Element] = &[element("", "B:14172").switch()];

const E_MESS_MT_IN: &[Element] = &[element("", "B:14173").initial(1.0).switch()];

const E_MESS_D: &[Element] = &[element("", "B:14174").initial(5.0).unit(Unit::Length(System::Metric)).internal()];

const E_MESS_D_M: &[Element] =
    &[element("", "B:14175").initial(50.0).unit(Unit::Length(System::Metric)).within(Range::POSITIVE)];

const E_MESS_D_L: &[Element] =
    &[element("", "B:14176").initial(2.0).unit(Unit::Length(System::Metric)).within(Range::POSITIVE)];

const E_MESS_D_R: &[Element] =
    &[element("", "B:14177").initial(1.0).unit(Unit::Length(System::Metric)).within(Range::POSITIVE)];

const E_MESS_FM: &[Element] =
    &[element("", "B:14178").initial(300.0).unit(Unit::Feed(System::Metric)).within(Range::POSITIVE)];

const E_MESS_F: &[Element] =
    &[element("", "B:14179").initial(2000.0).unit(Unit::Feed(System::Metric)).within(Range::POSITIVE)];

const E_MESS_FZ: &[Element] =
    &[element("", "B:14180").initial(2000.0).unit(Unit::Feed(System::Metric)).within(Range::POSITIVE)];

const E_MESS_CAL_D: &[Element] =
    &[element("k", "B:14260").unit(Unit::Length(System::Metric)).within(Range::NOT_NEGATIVE)];

const E_MESS_CAL_L: &[Element] = &[element("k", "B:14261").unit(Unit::Length(System::Metric))];

const E_MESS_MAX_V: &[Element] =
    &[element("", "B:14181").initial(100.0).unit(Unit::Speed(System::Metric)).within(Range::POSITIVE)];

const E_MESS_MAX_S: &[Element] = &[element("", "B:14182").initial(1000.0).unit(Unit::Rpm).within(Range::POSITIVE)];

const E_MESS_MAX_F: &[Element] =
    &[element("", "B:14183").initial(20.0).unit(Unit::Feed(System::Metric)).within(Range::POSITIVE)];

const E_MESS_MIN_F: &[Element] =
    &[element("", "B:14184").initial(1.0).unit(Unit::Feed(System::Metric)).within(Range::NOT_NEGATIVE)];

const E_MESS_F_FAK1: &[Element] = &[element("", "B:14185").initial(10.0).within(Range::NOT_NEGATIVE)];

const E_MESS_F_FAK2: &[Element] = &[element("", "B:14186").within(Range::NOT_NEGATIVE)];

const E_MESS_MIN_D: &[Element] =
    &[element("", "B:14188").initial(0.01).unit(Unit::Length(System::Metric)).within(Range::POSITIVE)];

const E_MESS_MS_SOUTH: &[Element] = &[element("", "B:14189").initial(1.0).switch()];

const E_MESS_MS_MONO: &[Element] = &[element("", "B:14190").switch()];

const E_MESS_MT_TYP: &[Element] = &[element("k", "B:14191").choices(&[0, 101, 201, 301])];

const E_MESS_MT_AX: &[Element] = &[element("k", "B:14192").initial(133.0).within(Range::closed(0.0, 333.0))];

const E_MESS_MT_DL: &[Element] =
    &[element("k", "B:14193").unit(Unit::Length(System::Metric)).within(Range::NOT_NEGATIVE)];

const E_MESS_MT_DR: &[Element] =
    &[element("k", "B:14194").unit(Unit::Length(System::Metric)).within(Range::NOT_NEGATIVE)];

const E_MESS_MT_DZ: &[Element] =
    &[element("k", "B:14195").initial(2.0).unit(Unit::Length(System::Metric)).within(Range::NOT_NEGATIVE)];

const E_MESS_MT_DIR: &[Element] = &[element("k", "B:14196").initial(-1.0).within(Range::closed(-2.0, 2.0))];

const E_MESS_MT_D: &[Element] =
    &[element("", "B:14197").initial(10.0).unit(Unit::Length(System::Metric)).within(Range::POSITIVE)];

const E_MESS_MT_FM: &[Element] =
    &[element("", "B:14198").initial(100.0).unit(Unit::Feed(System::Metric)).within(Range::POSITIVE)];

const E_MESS_MT_CF: &[Element] = &[element("", "B:14199").choices(&[0, 1, 2])];

const E_MESS_MT_COMP: &[Element] = &[element("", "B:14200").choices(&[0, 1, 2])];

const E_MESS: &[Element] = &[element("k", "B:14201").internal()];

const E_MEAS: &[Element] = &[element("", "B:14202").internal()];

const E_MESS_RETT: &[Element] = &[element("", "B:14288").internal()];

const E_MESS_SETT: &[Element] = &[element("0", "B:14203").switch(), element("1..9", "B:14305").internal()];

const E_MESS_AM: &[Element] = &[element("", "B:14290").internal()];
