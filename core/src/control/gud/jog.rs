//! Measuring in JOG (B:14321-14368) and its settings.

use super::{Bool, Frame, Gud, Integer, M_MIN, MM, MM_MIN, Real, Unit, element, gud6, gud7};

pub(super) const DATA: &[Gud] = &[
    // The active zero offset is 100 in the definition (B:14313), 0 in the text (B:14335).
    gud6("_JM_I", Integer, &[10]).channel().elements(&[
        element("0", "B:14321-14323").switch(),
        element("1", "B:14324").initial(1.0).not_negative(),
        element("2", "B:14325").initial(1.0).not_negative(),
        element("3", "B:14326-14330").initial(17.0).not_negative(),
        element("4", "B:14331-14334").initial(100.0).between(0.0, 100.0),
        element("5", "B:14335-14336").switch(),
        element("6", "B:14337").internal(),
        element("7", "B:14338").internal(),
        element("8", "B:14339").internal(),
        element("9", "B:14340").internal(),
    ]),
    gud6("_JM_B", Bool, &[10]).channel().elements(&[
        element("0", "B:14353-14355").switch(),
        element("1", "B:14356-14358").initial(1.0).switch(),
        element("2", "B:14359-14361").switch(),
        element("3", "B:14362-14364").switch(),
        element("4", "B:14365-14366").switch(),
        element("5", "B:14367").internal(),
        element("6", "B:14368").internal(),
        element("7", "B:13236").internal(),
        element("8", "B:13236").internal(),
        element("9", "B:13236").internal(),
    ]),
];

/// Measuring in JOG, block GUD7 (B:14170-14305).
pub(super) const SETTINGS: &[Gud] = &[
    gud7("E_MESS_IS_METRIC", Integer, &[]).elements(&[element("", "B:14170").initial(1.0).switch()]),
    gud7("E_MESS_IS_METRIC_SPEZ_VAR", Integer, &[]).elements(&[element("", "B:14171").initial(1.0).switch()]),
    gud7("E_MESS_MS_IN", Bool, &[]).elements(&[element("", "B:14172").switch()]),
    gud7("E_MESS_MT_IN", Bool, &[]).elements(&[element("", "B:14173").initial(1.0).switch()]),
    gud7("E_MESS_D", Real, &[]).elements(&[element("", "B:14174").initial(5.0).unit(MM).internal()]),
    gud7("E_MESS_D_M", Real, &[]).elements(&[element("", "B:14175").initial(50.0).unit(MM).positive()]),
    gud7("E_MESS_D_L", Real, &[]).elements(&[element("", "B:14176").initial(2.0).unit(MM).positive()]),
    gud7("E_MESS_D_R", Real, &[]).elements(&[element("", "B:14177").initial(1.0).unit(MM).positive()]),
    gud7("E_MESS_FM", Real, &[]).elements(&[element("", "B:14178").initial(300.0).unit(MM_MIN).positive()]),
    gud7("E_MESS_F", Real, &[]).elements(&[element("", "B:14179").initial(2000.0).unit(MM_MIN).positive()]),
    gud7("E_MESS_FZ", Real, &[]).elements(&[element("", "B:14180").initial(2000.0).unit(MM_MIN).positive()]),
    gud7("E_MESS_CAL_D", Real, &[3]).elements(&[element("k", "B:14260").unit(MM).not_negative()]),
    gud7("E_MESS_CAL_L", Real, &[3]).elements(&[element("k", "B:14261").unit(MM)]),
    gud7("E_MESS_MAX_V", Real, &[]).elements(&[element("", "B:14181").initial(100.0).unit(M_MIN).positive()]),
    gud7("E_MESS_MAX_S", Real, &[]).elements(&[element("", "B:14182").initial(1000.0).unit(Unit::Rpm).positive()]),
    gud7("E_MESS_MAX_F", Real, &[]).elements(&[element("", "B:14183").initial(20.0).unit(MM_MIN).positive()]),
    gud7("E_MESS_MIN_F", Real, &[]).elements(&[element("", "B:14184").initial(1.0).unit(MM_MIN).not_negative()]),
    gud7("E_MESS_F_FAK1", Real, &[]).elements(&[element("", "B:14185").initial(10.0).not_negative()]),
    gud7("E_MESS_F_FAK2", Real, &[]).elements(&[element("", "B:14186").not_negative()]),
    gud7("E_MESS_MIN_D", Real, &[]).elements(&[element("", "B:14188").initial(0.01).unit(MM).positive()]),
    gud7("E_MESS_MS_SOUTH", Integer, &[]).elements(&[element("", "B:14189").initial(1.0).switch()]),
    gud7("E_MESS_MS_MONO", Integer, &[]).elements(&[element("", "B:14190").switch()]),
    gud7("E_MESS_MT_TYP", Integer, &[3]).elements(&[element("k", "B:14191").choices(&[0, 101, 201, 301])]),
    gud7("E_MESS_MT_AX", Integer, &[3]).elements(&[element("k", "B:14192").initial(133.0).between(0.0, 333.0)]),
    gud7("E_MESS_MT_DL", Real, &[3]).elements(&[element("k", "B:14193").unit(MM).not_negative()]),
    gud7("E_MESS_MT_DR", Real, &[3]).elements(&[element("k", "B:14194").unit(MM).not_negative()]),
    gud7("E_MESS_MT_DZ", Real, &[3]).elements(&[element("k", "B:14195").initial(2.0).unit(MM).not_negative()]),
    gud7("E_MESS_MT_DIR", Integer, &[3]).elements(&[element("k", "B:14196").initial(-1.0).choices(&[-2, -1, 1, 2])]),
    gud7("E_MESS_MT_D", Real, &[]).elements(&[element("", "B:14197").initial(10.0).unit(MM).positive()]),
    gud7("E_MESS_MT_FM", Real, &[]).elements(&[element("", "B:14198").initial(100.0).unit(MM_MIN).positive()]),
    gud7("E_MESS_MT_CF", Integer, &[]).elements(&[element("", "B:14199").choices(&[0, 1, 2])]),
    gud7("E_MESS_MT_COMP", Integer, &[]).elements(&[element("", "B:14200").choices(&[0, 1, 2])]),
    gud7("E_MESS", Real, &[3]).elements(&[element("k", "B:14201").internal()]),
    gud7("E_MEAS", Real, &[]).elements(&[element("", "B:14202").internal()]),
    gud7("E_MESS_RETT", Frame, &[]).elements(&[element("", "B:14288").internal()]),
    gud7("E_MESS_SETT", Bool, &[10])
        .elements(&[element("0", "B:14203").switch(), element("1..9", "B:14305").internal()]),
    gud7("E_MESS_AM", Bool, &[]).elements(&[element("", "B:14290").internal()]),
];
