//! What the help pages of the SINUMERIK workpiece cycles have in common, in groups.

use crate::catalogue::common::{DIFFERENTIAL as TURNED_OVER, TOOL_OFFSET, ZERO_OFFSET};
use crate::catalogue::prelude::*;

/// What every SINUMERIK cycle with the probe in the milling spindle asks for.
pub const PROBE: &[HelpLine] = &[
    before(When::Always, "help-probe-loaded", "B:744;B:4147-4152"),
    before(When::Always, "help-probe-turning", "B:4148-4152;B:5358"),
];

/// What goes wrong in every measurement of a workpiece.
pub const MEASURING: &[HelpLine] = &[
    wrong(TOOL_OFFSET, "help-wrong-tool", "B:1872-1928"),
    wrong(TOOL_OFFSET, "help-wrong-chip", "B:1334-1340"),
    wrong(When::Always, "help-wrong-conditions", "B:4158;B:13658-13667"),
    wrong(When::Always, "help-wrong-kept", "B:1740-1766"),
];

/// The measuring block.
pub const BLOCK: &[HelpLine] = &[
    order(When::Always, "help-order-block", "B:1111-1121;B:2344-2356"),
    wrong(When::Always, "help-wrong-reach", "B:13999-14001"),
    wrong(When::Always, "help-wrong-in-the-way", "B:13743-13763"),
];

/// What is corrected where the third digit of `_MVAR` chooses between a tool and a zero offset.
pub const CORRECTION: &[HelpLine] = &[
    corrects(TOOL_OFFSET, "help-corrects-tool", "B:1894-2043;B:13928-13931"),
    corrects(TOOL_OFFSET, "help-corrects-chain", "B:1286-1394"),
    corrects(ZERO_OFFSET, "help-corrects-zero", "B:1930-2003;B:14035-14044"),
    corrects(ZERO_OFFSET, "help-corrects-zero-area", "B:1316-1330"),
];

/// A corrected zero offset waits for its G function; a cycle says for which variants.
pub const AGAIN: &[HelpLine] = &[corrects(ZERO_OFFSET, "help-corrects-when", "B:1965")];

/// What calibrating a workpiece probe stores.
pub const STORED: &[HelpLine] = &[
    corrects(When::Always, "help-corrects-trigger", "B:5134;B:5148"),
    wrong(When::Always, "help-wrong-first", "B:5148;B:10263"),
    wrong(When::Always, "help-wrong-later", "B:4158;B:8212"),
];

/// A measurement takes its trigger values from the data of the probe.
pub const CALIBRATED: &[HelpLine] = &[before(When::Always, "help-calibrated", "B:4158;B:8212")];

/// Differential measurement, in the cycles whose fourth digit of `_MVAR` asks for it.
pub const DIFFERENTIAL: &[HelpLine] = &[
    before(When::Not(&TURNED_OVER), "help-calibrated", "B:4158;B:8212"),
    before(TURNED_OVER, "help-uncalibrated", "B:6402-6418;B:7570-7582"),
    order(TURNED_OVER, "help-turned-over", "B:6402-6418;B:7570-7582"),
    corrects(TURNED_OVER, "help-turned-over-stored", "A:7281-7291"),
    wrong(TURNED_OVER, "help-no-spindle", "B:6402-6418"),
];
