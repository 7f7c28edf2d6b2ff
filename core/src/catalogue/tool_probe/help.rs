//! What the help pages of the cycles at a tool probe have in common.

use crate::entry::{HelpLine, When, before, wrong};

/// What all cycles at a tool probe have in common.
pub const ALL: &[HelpLine] =
    &[before(When::Always, "help-tool-in-use", "B:4251;B:9214-9216"), wrong(When::Always, "help-tool-chip", "B:4324")];
