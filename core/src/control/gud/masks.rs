//! What the screens of the measuring cycle support show and write, `_MZ_MASK` (B:12501-12539).

use super::{Gud, Integer, element, gud6};

pub(super) const DATA: &[Gud] = &[gud6("_MZ_MASK", Integer, &[20]).elements(&[
    element("0", "B:12501-12502").initial(1.0).switch(),
    element("1", "B:12503-12504").switch(),
    element("2", "B:12505-12506").switch(),
    element("3", "B:12507").switch(),
    element("4", "B:12518-12532").switch(),
    element("5", "B:12533-12535").switch(),
    element("6", "B:12536").internal(),
    element("7", "B:12537-12539").switch(),
    element("8..19", "B:13175").internal(),
])];
