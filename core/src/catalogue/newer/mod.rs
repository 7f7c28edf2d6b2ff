//! Parameter lists of newer 840D sl and 828D controls (SINUMERIK Operate). They are not in our manuals: order and names
//! of the arguments are those of published lists of the calls and agree with programs that run on such controls. What a
//! number in an argument means is published for few of them; a list whose `S_MVAR` is not is read and never written.
//!
//! An argument that means what one of our parameters means has it beside its name. The measuring direction counts
//! differently there (1 plus, 2 minus), and the tool target has an argument of its own: these have none.

pub mod alarms;
pub mod arguments;

use crate::catalogue::prelude::*;
use crate::entry::Published;
use crate::entry::names::*;
use std::borrow::Cow;

/// What the cycle of a list does, where the older control does not have it: else its entry says it.
pub fn title(list: &ArgumentList) -> Option<Message> {
    let alone = super::CYCLES.iter().all(|cycle| cycle.name != list.name);
    alone.then(|| Message::new(format!("newer-{}", list.name.to_ascii_lowercase())))
}

/// Key of what a variant is called in a list: one that corrects a tool on the older control only measures there.
/// Argument 2 takes zero offsets alone, and the digits of `S_KNUM1` are not published.
pub fn variant_key(key: &'static str) -> Cow<'static, str> {
    key.strip_suffix("-tool").map_or(key.into(), |stem| format!("{stem}-measured").into())
}

/// What a call in a list is called, where that is not the name of the variant.
pub fn variant_title(key: &'static str) -> Option<Message> {
    let own = variant_key(key);
    (own != key).then(|| Message::new(own))
}

/// An argument that means what a parameter of the older control means.
const fn as_param(name: &'static str, param: Name) -> Arg {
    Arg::Newer(name, Some(param))
}

/// An argument that only newer controls have, or that means something else there.
const fn alone(name: &'static str) -> Arg {
    Arg::Newer(name, None)
}

const S_MVAR: Arg = as_param("S_MVAR", MVAR);
const S_KNUM: Arg = as_param("S_KNUM", KNUM);
const S_KNUM_OF_TOOL: Arg = alone("S_KNUM");
const S_KNUM1: Arg = alone("S_KNUM1");
const S_PRNUM: Arg = as_param("S_PRNUM", PRNUM);
const S_SETV: Arg = as_param("S_SETV", SETVAL);
const S_SETV0: Arg = as_param("S_SETV0", SETV0);
const S_SETV1: Arg = as_param("S_SETV1", SETV1);
const S_SETV2: Arg = as_param("S_SETV2", SETV2);
const S_SETV3: Arg = as_param("S_SETV3", SETV3);
const S_SETV4: Arg = as_param("S_SETV4", SETV4);
const S_SETV5: Arg = as_param("S_SETV5", SETV5);
const S_SETV6: Arg = as_param("S_SETV6", SETV6);
const S_SETV7: Arg = as_param("S_SETV7", SETV7);
const S_SETV8: Arg = as_param("S_SETV8", SETV8);
const S_MA: Arg = as_param("S_MA", MA);
const S_MD: Arg = alone("S_MD");
const S_RA: Arg = as_param("S_RA", RA);
const S_ID: Arg = as_param("S_ID", ID);
const S_FA: Arg = as_param("S_FA", FA);
const S_TSA: Arg = as_param("S_TSA", TSA);
const S_VMS: Arg = as_param("S_VMS", VMS);
const S_STA1: Arg = as_param("S_STA1", STA1);
const S_INCA: Arg = as_param("S_INCA", INCA);
const S_SZA: Arg = as_param("S_SZA", SZA);
const S_SZO: Arg = as_param("S_SZO", SZO);
const S_CPA: Arg = as_param("S_CPA", CPA);
const S_CPO: Arg = as_param("S_CPO", CPO);
const S_CALNUM: Arg = as_param("S_CALNUM", CALNUM);
const S_CORA: Arg = as_param("S_CORA", CORA);
const S_TNAME: Arg = as_param("S_TNAME", TNAME);
const S_DLNUM: Arg = as_param("S_DLNUM", DLNUM);
const S_TZL: Arg = as_param("S_TZL", TZL);
const S_TDIF: Arg = as_param("S_TDIF", TDIF);
const S_TUL: Arg = as_param("S_TUL", TUL);
const S_TLL: Arg = as_param("S_TLL", TLL);
const S_TMV: Arg = as_param("S_TMV", TMV);
const S_TNVL: Arg = as_param("S_TNVL", TNVL);
const S_NMSP: Arg = as_param("S_NMSP", NMSP);
const S_K: Arg = as_param("S_K", K);
const S_EVNUM: Arg = as_param("S_EVNUM", EVNUM);
const S_F1: Arg = as_param("S_F1", MFS[1]);
const S_S1: Arg = as_param("S_S1", MFS[0]);
const S_F2: Arg = as_param("S_F2", MFS[3]);
const S_S2: Arg = as_param("S_S2", MFS[2]);
const S_F3: Arg = as_param("S_F3", MFS[5]);
const S_S3: Arg = as_param("S_S3", MFS[4]);
const S_XM: Arg = alone("S_XM");
const S_YM: Arg = alone("S_YM");
const S_MPVAL1: Arg = alone("S_MPVAL1");
const S_MPVAL2: Arg = alone("S_MPVAL2");
const S_DZ: Arg = alone("S_DZ");
const S_TC: Arg = alone("S_TC");
const S_MEC_INDEX: Arg = alone("S_MEC_INDEX");
const S_MCBIT: Arg = alone("S_MCBIT");
const DMODE: Arg = alone("_DMODE");
const AMODE: Arg = alone("_AMODE");
const DP: Arg = alone("_DP");
/// The published lists of CYCLE971 and CYCLE982 end with an argument without a name.
const UNNAMED: Arg = alone("");

/// The measuring variants of CYCLE977 that are evidenced: hole, shaft, groove, web and both rectangles; measured, or
/// with correction of a zero offset; with a protection zone or without.
const ELEMENTS: When = When::Variant(&[
    1, 2, 3, 4, 5, 6, 101, 102, 103, 104, 105, 106, 1001, 1002, 1003, 1004, 1005, 1006, 1101, 1102, 1103, 1104, 1105,
    1106,
]);

/// Numbers of the arguments that every published program of the lists that are written has: 1 in `_DMODE`, 1 in
/// `_AMODE`, or 11 where the centre is given; an omitted one is 0.
const PLANE: (&str, Published) = ("_DMODE", Published::OneOf(&[0.0, 1.0]));
const MODE: (&str, Published) = ("_AMODE", Published::OneOf(&[0.0, 1.0, 11.0]));
/// The tool that is corrected, the options and the last argument: no number of theirs is published.
const TOOL: (&str, Published) = ("S_KNUM1", Published::OneOf(&[0.0]));
const OPTIONS: (&str, Published) = ("S_MCBIT", Published::OneOf(&[0.0]));
const LAST: (&str, Published) = ("_DP", Published::OneOf(&[0.0]));
/// Directions of two independent machine users.
const DIRECTIONS: (&str, Published) = ("S_MD", Published::OneOf(&[0.0, 1.0, 2.0]));

const fn list(name: &'static str, when: When) -> ArgumentList {
    let source = match when {
        When::Any([]) => "practice: superfestung/MyNotepad_plus_plus_tools: NC-Code.xml",
        _ => "practice: superfestung/MyNotepad_plus_plus_tools: NC-Code.xml; jakvok/Siemens_probing; mikejg/CamHelper",
    };
    ArgumentList { style: Style::Operate, name, when, base: 0, args: &[], published: &[], source }
}

/// Every list, in the order of the numbers. The last four have no counterpart among the cycles of the older control.
pub static LISTS: [ArgumentList; 16] = [
    CYCLE961, CYCLE971, CYCLE973, CYCLE974, CYCLE976, CYCLE977, CYCLE978, CYCLE979, CYCLE982, CYCLE994, CYCLE997,
    CYCLE998, CYCLE150, CYCLE995, CYCLE996, CYCLE9960,
];

pub const CYCLE961: ArgumentList = list("CYCLE961", NEVER).args(&[
    S_MVAR,
    S_KNUM,
    S_PRNUM,
    S_SETV0,
    S_SETV1,
    S_SETV2,
    S_SETV3,
    S_SETV4,
    S_SETV5,
    S_SETV6,
    S_SETV7,
    alone("S_SETV8"),
    alone("S_SETV9"),
    S_STA1,
    S_INCA,
    S_ID,
    S_FA,
    alone("S_TSA"),
    S_NMSP,
    S_MCBIT,
    DMODE,
    AMODE,
]);

pub const CYCLE971: ArgumentList = list("CYCLE971", NEVER).args(&[
    S_MVAR, S_KNUM_OF_TOOL, S_PRNUM, S_MA, S_MD, S_ID, S_FA, S_TSA, S_VMS, S_TZL, S_TDIF, S_NMSP, S_F1, S_S1, S_F2,
    S_S2, S_F3, S_S3, S_EVNUM, S_MCBIT, DMODE, AMODE, UNNAMED,
]);

pub const CYCLE973: ArgumentList = list("CYCLE973", NEVER)
    .args(&[S_MVAR, S_PRNUM, S_CALNUM, S_SETV, S_MA, S_MD, S_FA, S_TSA, S_VMS, S_NMSP, S_MCBIT, DMODE, AMODE]);

pub const CYCLE974: ArgumentList = list("CYCLE974", NEVER).args(&[
    S_MVAR, S_KNUM, S_KNUM1, S_PRNUM, S_SETV, S_MA, S_FA, S_TSA, S_STA1, S_NMSP, S_TNAME, S_DLNUM, S_TZL, S_TDIF,
    S_TUL, S_TLL, S_TMV, S_K, S_EVNUM, S_MCBIT, DMODE, AMODE, DP,
]);

pub const CYCLE976: ArgumentList = list("CYCLE976", NEVER).args(&[
    S_MVAR,
    S_PRNUM,
    S_SETV,
    alone("S_SETV0"),
    S_MA,
    S_MD,
    S_FA,
    S_TSA,
    S_VMS,
    S_STA1,
    S_NMSP,
    alone("S_SETV1"),
    DMODE,
    AMODE,
]);

/// CYCLE977. The older control has no probing angle (`S_STA1`) here.
pub const CYCLE977: ArgumentList = list("CYCLE977", ELEMENTS)
    .args(&[
        S_MVAR,
        S_KNUM,
        S_KNUM1,
        S_PRNUM,
        S_SETV,
        S_SETV0,
        S_SETV1,
        S_FA,
        S_TSA,
        alone("S_STA1"),
        S_ID,
        S_SZA,
        S_SZO,
        S_MA,
        S_NMSP,
        S_TNAME,
        S_DLNUM,
        S_TZL,
        S_TDIF,
        S_TUL,
        S_TLL,
        S_TMV,
        S_K,
        S_EVNUM,
        S_MCBIT,
        DMODE,
        AMODE,
        S_XM,
        S_YM,
        DP,
    ])
    // a generator of machine users asks for a probing angle from -359 to 359
    .publishing(&[TOOL, OPTIONS, LAST, PLANE, MODE, ("S_STA1", Published::Within(-359.0, 359.0))]);

/// CYCLE978. Programs leave out the measuring direction too; here the side on which the probe stands tells it.
pub const CYCLE978: ArgumentList = list("CYCLE978", When::Variant(&[0, 100]))
    .args(&[
        S_MVAR, S_KNUM, S_KNUM1, S_PRNUM, S_SETV, S_FA, S_TSA, S_MA, S_MD, S_NMSP, S_TNAME, S_DLNUM, S_TZL, S_TDIF,
        S_TUL, S_TLL, S_TMV, S_K, S_EVNUM, S_MCBIT, DMODE, AMODE, DP,
    ])
    .publishing(&[TOOL, OPTIONS, LAST, PLANE, MODE, DIRECTIONS]);

pub const CYCLE979: ArgumentList = list("CYCLE979", NEVER).args(&[
    S_MVAR, S_KNUM, S_KNUM1, S_PRNUM, S_SETV, S_FA, S_TSA, S_CPA, S_CPO, S_STA1, S_INCA, S_NMSP, S_TNAME, S_DLNUM,
    S_TZL, S_TDIF, S_TUL, S_TLL, S_TMV, S_K, S_EVNUM, S_MCBIT, DMODE, AMODE, S_MPVAL1, S_MPVAL2, DP,
]);

pub const CYCLE982: ArgumentList = list("CYCLE982", NEVER).args(&[
    S_MVAR,
    S_KNUM_OF_TOOL,
    S_PRNUM,
    S_MA,
    S_MD,
    alone("S_ID"),
    S_FA,
    S_TSA,
    S_VMS,
    S_STA1,
    S_CORA,
    S_TZL,
    S_TDIF,
    S_NMSP,
    S_EVNUM,
    S_MCBIT,
    DMODE,
    AMODE,
    UNNAMED,
]);

pub const CYCLE994: ArgumentList = list("CYCLE994", NEVER).args(&[
    S_MVAR, S_KNUM, S_KNUM1, S_PRNUM, S_SETV, S_MA, S_SZA, S_SZO, S_FA, S_TSA, S_NMSP, S_TNAME, S_DLNUM, S_TZL, S_TDIF,
    S_TUL, S_TLL, S_TMV, S_K, S_EVNUM, S_MCBIT, DMODE, AMODE, DP,
]);

pub const CYCLE997: ArgumentList = list("CYCLE997", NEVER).args(&[
    S_MVAR, S_KNUM, S_PRNUM, S_SETV, S_FA, S_TSA, S_STA1, S_INCA, S_SETV0, S_SETV1, S_SETV2, S_SETV3, S_SETV4, S_SETV5,
    S_SETV6, S_SETV7, S_SETV8, S_TNVL, S_NMSP, S_MCBIT, DMODE, AMODE,
]);

/// The rotary axis of a program on a Hermle (CamHelper cd6e996).
const ROTARY: (&str, Published) = ("S_RA", Published::Seen(&[6.0]));

/// CYCLE998, of which only one angle with positioning at an angle is known.
pub const CYCLE998: ArgumentList = list("CYCLE998", When::Variant(&[105]))
    .args(&[
        S_MVAR,
        S_KNUM,
        S_RA,
        S_PRNUM,
        S_SETV,
        S_STA1,
        S_INCA,
        S_FA,
        S_TSA,
        S_MA,
        S_MD,
        S_ID,
        S_SETV0,
        alone("S_SETV1"),
        alone("S_SETV2"),
        alone("S_SETV3"),
        S_NMSP,
        S_EVNUM,
        DMODE,
        AMODE,
    ])
    .publishing(&[PLANE, MODE, DIRECTIONS, ("S_MA", Published::OneOf(&[102.0, 103.0, 201.0])), ROTARY]);

/// CYCLE150 shows the results on a screen and writes the log. Two places of the published list have no name.
pub const CYCLE150: ArgumentList =
    list("CYCLE150", NEVER).args(&[alone("S_PICT"), UNNAMED, alone("S_PROT"), UNNAMED, alone("S_PATH")]);

/// CYCLE150 with three arguments at most: whether the two places without a name are an artefact of the published list
/// is open, and with it which argument is `S_PROT` and which `S_PATH`.
pub static CYCLE150_SHORT: ArgumentList = list("CYCLE150", NEVER).args(&[alone("S_PICT"), UNNAMED, UNNAMED]);

/// The list of a call with so many arguments.
pub fn of_count(list: &'static ArgumentList, count: usize) -> &'static ArgumentList {
    let is_short = list.name == CYCLE150_SHORT.name && count <= CYCLE150_SHORT.args.len();
    if is_short { &CYCLE150_SHORT } else { list }
}

/// CYCLE995, which measures how far a spindle is out of square.
pub const CYCLE995: ArgumentList = list("CYCLE995", NEVER).args(&[
    S_MVAR,
    S_KNUM,
    S_PRNUM,
    S_SETV,
    S_FA,
    S_TSA,
    S_STA1,
    S_INCA,
    S_DZ,
    alone("S_SETV0"),
    alone("S_SETV1"),
    alone("S_SETV2"),
    S_TUL,
    S_TZL,
    S_NMSP,
    S_MCBIT,
    DMODE,
    AMODE,
]);

/// CYCLE996, which measures kinematics; `S_SETV` is the diameter of the ball.
pub const CYCLE996: ArgumentList = list("CYCLE996", NEVER).args(&[
    S_MVAR,
    S_TC,
    S_PRNUM,
    alone("S_SETV"),
    S_STA1,
    alone("S_SETV0"),
    alone("S_SETV1"),
    alone("S_SETV2"),
    alone("S_SETV3"),
    alone("S_SETV4"),
    alone("S_SETV5"),
    S_TNVL,
    S_FA,
    S_TSA,
    S_NMSP,
    S_MCBIT,
    DMODE,
    AMODE,
]);

/// CYCLE9960, which measures kinematics as a whole.
pub const CYCLE9960: ArgumentList = list("CYCLE9960", NEVER).args(&[
    S_MVAR,
    S_TNAME,
    S_PRNUM,
    alone("S_SETV"),
    alone("S_SETV1"),
    alone("S_SETV2"),
    alone("S_SETV4"),
    S_FA,
    S_TSA,
    S_NMSP,
    DMODE,
    AMODE,
    S_KNUM,
    S_MEC_INDEX,
]);
