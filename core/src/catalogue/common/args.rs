//! The arguments of parameter lists that are parameters, by their names: a list of them is one table.

use crate::entry::{Arg, names};

pub const MVAR: Arg = Arg::Param(names::MVAR);
pub const SETVAL: Arg = Arg::Param(names::SETVAL);
pub const SETV0: Arg = Arg::Param(names::SETV0);
pub const SETV1: Arg = Arg::Param(names::SETV1);
pub const SETV2: Arg = Arg::Param(names::SETV2);
pub const SETV3: Arg = Arg::Param(names::SETV3);
pub const SETV4: Arg = Arg::Param(names::SETV4);
pub const SETV5: Arg = Arg::Param(names::SETV5);
pub const SETV6: Arg = Arg::Param(names::SETV6);
pub const SETV7: Arg = Arg::Param(names::SETV7);
pub const ID: Arg = Arg::Param(names::ID);
pub const SZA: Arg = Arg::Param(names::SZA);
pub const SZO: Arg = Arg::Param(names::SZO);
pub const MA: Arg = Arg::Param(names::MA);
pub const MD: Arg = Arg::Param(names::MD);
pub const KNUM: Arg = Arg::Param(names::KNUM);
pub const TNUM: Arg = Arg::Param(names::TNUM);
pub const TNAME: Arg = Arg::Param(names::TNAME);
pub const PRNUM: Arg = Arg::Param(names::PRNUM);
pub const FA: Arg = Arg::Param(names::FA);
pub const CPA: Arg = Arg::Param(names::CPA);
pub const CPO: Arg = Arg::Param(names::CPO);
pub const STA1: Arg = Arg::Param(names::STA1);
pub const INCA: Arg = Arg::Param(names::INCA);
pub const RA: Arg = Arg::Param(names::RA);
pub const CALNUM: Arg = Arg::Param(names::CALNUM);
pub const MFS0: Arg = Arg::Param(names::MFS[0]);
pub const MFS1: Arg = Arg::Param(names::MFS[1]);
pub const MFS2: Arg = Arg::Param(names::MFS[2]);
pub const MFS3: Arg = Arg::Param(names::MFS[3]);
pub const MFS4: Arg = Arg::Param(names::MFS[4]);
pub const MFS5: Arg = Arg::Param(names::MFS[5]);
