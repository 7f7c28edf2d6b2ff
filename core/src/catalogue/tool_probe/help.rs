//! What the help pages of the cycles at a tool probe have in common.

use crate::entry::{HelpLine, When, before, corrects, order, wrong};

/// Lines of a cycle that positions at the probe (`known`) to calibrate it or to measure, or touches it from where the
/// tool stands (`here`), to calibrate it.
pub const fn lines([known, calibrates, measures]: [When; 3], [here, calibrates_here]: [When; 2]) -> [HelpLine; 11] {
    [
        before(known, "help-tool-probe-known", "B:4204-4215;B:13357-13384"),
        before(here, "help-tool-in-front", "B:4587;B:9825;B:9875;B:10004"),
        before(When::Always, "help-tool-in-use", "B:4251;B:9214-9216"),
        order(known, "help-tool-block", "B:1111-1121;B:2344-2356"),
        order(here, "help-tool-from-here", "B:4432;B:9825;B:9990"),
        corrects(calibrates, "help-tool-trigger", "B:4326"),
        corrects(measures, "help-tool-data", "B:4324;B:4930-4937"),
        corrects(calibrates_here, "help-tool-trigger-always", "B:4432;B:9840"),
        wrong(known, "help-tool-reach", "B:13999-14001"),
        wrong(here, "help-tool-unwatched", "B:4432;B:9840"),
        wrong(When::Always, "help-tool-chip", "B:4324"),
    ]
}
