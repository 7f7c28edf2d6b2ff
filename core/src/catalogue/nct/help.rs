//! What the help pages of the probing macros have in common, in groups.

use crate::catalogue::prelude::*;

/// What every probing macro of the NCT controls asks for.
pub const MEASURING: &[HelpLine] = &[
    before(When::Always, "help-stylus", "C:125-132;C:195-204"),
    before(When::Always, "help-oriented", "C:62-72;C:234"),
    before(When::Always, "help-guarded", "C:106-144"),
    order(When::Always, "help-steps", "C:96-98"),
    order(When::Always, "help-ends-at-start", "C:179-218"),
    wrong(When::Always, "help-position-lost", "C:121-123"),
];

/// What corrects a work offset or a tool.
pub const SHIFTS: &[HelpLine] = &[
    corrects(When::Always, "help-result", "C:474-551"),
    corrects(When::Always, "help-limits", "C:1142-1143"),
    wrong(When::Always, "help-both-targets", "C:472-551"),
    wrong(When::Always, "help-middle-tolerance", "C:491-513"),
];

/// What goes wrong with every calibration.
pub const CALIBRATING: &[HelpLine] = &[wrong(When::Always, "help-one-system", "C:92-94")];

/// A macro that calls no other macro; subprograms it calls on two levels.
pub const NO_MACRO: &[HelpLine] = &[before(When::Always, "help-levels-none", "C:142-144")];

/// A macro that calls others on one level.
pub const ONE_MACRO: &[HelpLine] = &[before(When::Always, "help-levels-one", "C:216-218;C:345;C:419;C:551;C:674")];

/// A macro that calls others on two levels.
pub const TWO_MACROS: &[HelpLine] = &[before(When::Always, "help-levels-two", "C:766;C:849;C:999;C:1157")];
