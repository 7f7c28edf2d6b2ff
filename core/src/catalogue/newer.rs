//! Parameter lists of newer 840D sl and 828D controls (SINUMERIK Operate). They are not in our manuals: order and names
//! of the arguments are those of published lists of the calls and agree with programs that run on such controls. What a
//! number in an argument means is published for few of them; a list whose `_MVAR` is not is read and never written.
//!
//! Where an argument has the name and the meaning of one of our parameters it is that parameter. Others are named as
//! there: the measuring direction counts differently (1 plus, 2 minus), and the tool target has an argument of its own.

use super::common::args::*;
use crate::catalogue::prelude::*;

const S_KNUM: Arg = Arg::Newer("S_KNUM");
const S_KNUM1: Arg = Arg::Newer("S_KNUM1");
const S_MD: Arg = Arg::Newer("S_MD");
const S_ID: Arg = Arg::Newer("S_ID");
const S_TSA: Arg = Arg::Newer("S_TSA");
const S_STA1: Arg = Arg::Newer("S_STA1");
const S_SETV0: Arg = Arg::Newer("S_SETV0");
const S_SETV1: Arg = Arg::Newer("S_SETV1");
const S_SETV2: Arg = Arg::Newer("S_SETV2");
const S_SETV3: Arg = Arg::Newer("S_SETV3");
const S_SETV8: Arg = Arg::Newer("S_SETV8");
const S_SETV9: Arg = Arg::Newer("S_SETV9");
const S_XM: Arg = Arg::Newer("S_XM");
const S_YM: Arg = Arg::Newer("S_YM");
const S_MPVAL1: Arg = Arg::Newer("S_MPVAL1");
const S_MPVAL2: Arg = Arg::Newer("S_MPVAL2");
const S_MCBIT: Arg = Arg::Newer("S_MCBIT");
const DMODE: Arg = Arg::Newer("_DMODE");
const AMODE: Arg = Arg::Newer("_AMODE");
const DP: Arg = Arg::Newer("_DP");

/// The measuring variants of CYCLE977 that are evidenced: hole, shaft, groove, web and both rectangles; measured, or
/// with correction of a zero offset; with a protection zone or without.
const ELEMENTS: When = When::Variant(&[
    1, 2, 3, 4, 5, 6, 101, 102, 103, 104, 105, 106, 1001, 1002, 1003, 1004, 1005, 1006, 1101, 1102, 1103, 1104, 1105,
    1106,
]);

const fn list(name: &'static str, when: When) -> ArgumentList {
    let source = "practice: published lists and generated programs of newer controls";
    ArgumentList { style: Style::Operate, name, when, base: 0, args: &[], source }
}

pub const CYCLE961: ArgumentList = list("CYCLE961", NEVER).args(&[
    MVAR, KNUM, PRNUM, SETV0, SETV1, SETV2, SETV3, SETV4, SETV5, SETV6, SETV7, S_SETV8, S_SETV9, STA1, INCA, ID, FA,
    S_TSA, NMSP, S_MCBIT, DMODE, AMODE,
]);

pub const CYCLE971: ArgumentList = list("CYCLE971", NEVER).args(&[
    MVAR, S_KNUM, PRNUM, MA, S_MD, ID, FA, TSA, VMS, TZL, TDIF, NMSP, MFS1, MFS0, MFS3, MFS2, MFS5, MFS4, EVNUM,
    S_MCBIT, DMODE, AMODE,
]);

pub const CYCLE973: ArgumentList =
    list("CYCLE973", NEVER).args(&[MVAR, PRNUM, CALNUM, SETVAL, MA, S_MD, FA, TSA, VMS, NMSP, S_MCBIT, DMODE, AMODE]);

pub const CYCLE974: ArgumentList = list("CYCLE974", NEVER).args(&[
    MVAR, KNUM, S_KNUM1, PRNUM, SETVAL, MA, FA, TSA, STA1, NMSP, TNAME, DLNUM, TZL, TDIF, TUL, TLL, TMV, K, EVNUM,
    S_MCBIT, DMODE, AMODE, DP,
]);

pub const CYCLE976: ArgumentList = list("CYCLE976", NEVER)
    .args(&[MVAR, PRNUM, SETVAL, S_SETV0, MA, S_MD, FA, TSA, VMS, STA1, NMSP, S_SETV1, DMODE, AMODE]);

pub const CYCLE977: ArgumentList = list("CYCLE977", ELEMENTS).args(&[
    MVAR, KNUM, S_KNUM1, PRNUM, SETVAL, SETV0, SETV1, FA, TSA, S_STA1, ID, SZA, SZO, MA, NMSP, TNAME, DLNUM, TZL, TDIF,
    TUL, TLL, TMV, K, EVNUM, S_MCBIT, DMODE, AMODE, S_XM, S_YM, DP,
]);

/// CYCLE978. Programs leave out the measuring direction too; here the side on which the probe stands tells it.
pub const CYCLE978: ArgumentList = list("CYCLE978", When::Variant(&[0, 100])).args(&[
    MVAR, KNUM, S_KNUM1, PRNUM, SETVAL, FA, TSA, MA, S_MD, NMSP, TNAME, DLNUM, TZL, TDIF, TUL, TLL, TMV, K, EVNUM,
    S_MCBIT, DMODE, AMODE, DP,
]);

pub const CYCLE979: ArgumentList = list("CYCLE979", NEVER).args(&[
    MVAR, KNUM, S_KNUM1, PRNUM, SETVAL, FA, TSA, CPA, CPO, STA1, INCA, NMSP, TNAME, DLNUM, TZL, TDIF, TUL, TLL, TMV, K,
    EVNUM, S_MCBIT, DMODE, AMODE, S_MPVAL1, S_MPVAL2, DP,
]);

pub const CYCLE982: ArgumentList = list("CYCLE982", NEVER).args(&[
    MVAR, S_KNUM, PRNUM, MA, S_MD, S_ID, FA, TSA, VMS, STA1, CORA, TZL, TDIF, NMSP, EVNUM, S_MCBIT, DMODE, AMODE,
]);

pub const CYCLE994: ArgumentList = list("CYCLE994", NEVER).args(&[
    MVAR, KNUM, S_KNUM1, PRNUM, SETVAL, MA, SZA, SZO, FA, TSA, NMSP, TNAME, DLNUM, TZL, TDIF, TUL, TLL, TMV, K, EVNUM,
    S_MCBIT, DMODE, AMODE, DP,
]);

pub const CYCLE997: ArgumentList = list("CYCLE997", NEVER).args(&[
    MVAR, KNUM, PRNUM, SETVAL, FA, TSA, STA1, INCA, SETV0, SETV1, SETV2, SETV3, SETV4, SETV5, SETV6, SETV7, SETV8,
    TNVL, NMSP, S_MCBIT, DMODE, AMODE,
]);

/// CYCLE998, of which only one angle with positioning at an angle is known.
pub const CYCLE998: ArgumentList = list("CYCLE998", When::Variant(&[105])).args(&[
    MVAR, KNUM, RA, PRNUM, SETVAL, STA1, INCA, FA, TSA, MA, S_MD, ID, SETV0, S_SETV1, S_SETV2, S_SETV3, NMSP, EVNUM,
    DMODE, AMODE,
]);
