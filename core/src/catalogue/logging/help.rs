//! What the help pages of CYCLE100, CYCLE105 and CYCLE106 have in common.

use crate::catalogue::prelude::*;

/// What is printed, and how.
pub const FORMAT: &[HelpLine] = &[
    before(When::Always, "help-log-data", "B:11340-11359"),
    wrong(When::Always, "help-log-title", "B:11404"),
    wrong(When::Always, "help-log-column", "B:11437;A:15946"),
    wrong(When::Always, "help-log-line", "A:15915"),
];

/// The file.
pub const FILE: &[HelpLine] = &[
    before(When::Always, "help-log-name", "B:11192"),
    corrects(When::Always, "help-log-files", "B:11194-11196"),
    wrong(When::Always, "help-log-full", "B:11198-11200"),
    wrong(When::Always, "help-log-refused", "A:15894-15898"),
];

/// What the header shows.
pub const fn header(when: When) -> HelpLine {
    order(when, "help-log-header", "B:11338;B:11451-11475")
}

/// What a block of values shows.
pub const fn block(when: When) -> HelpLine {
    order(when, "help-log-block", "B:11336;B:11371-11375;B:11439-11441")
}

/// What the lines of a block name.
pub const fn chosen(when: When) -> HelpLine {
    before(when, "help-log-chosen", "B:11396-11402")
}
