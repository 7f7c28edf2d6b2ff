//! Measuring in JOG (B:14321-14368).

use super::{Element, Gud, Kind, element, gud6};
use crate::range::Range;

/// All of this subject.
pub(super) const DATA: &[Gud] =
    &[gud6("_JM_I", Kind::Integer, &[10], JM_I).channel(), gud6("_JM_B", Kind::Bool, &[10], JM_B).channel()];

/// The active zero offset is 100 in the definition (B:14313), 0 in the text (B:14335).
const JM_I: &[Element] = &[
    element("0", "B:14321-14323").switch(),
    element("1", "B:14324").initial(1.0).within(Range::NOT_NEGATIVE),
    element("2", "B:14325").initial(1.0).within(Range::NOT_NEGATIVE),
    element("3", "B:14326-14330").initial(17.0).within(Range::NOT_NEGATIVE),
    element("4", "B:14331-14334").initial(100.0).within(Range::closed(0.0, 100.0)),
    element("5", "B:14335-14336").switch(),
    element("6", "B:14337").internal(),
    element("7", "B:14338").internal(),
    element("8", "B:14339").internal(),
    element("9", "B:14340").internal(),
];

const JM_B: &[Element] = &[
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
];
