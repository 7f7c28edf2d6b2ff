//! Switches of the whole control, `_CBIT` (B:13534-13669).

use super::{Element, Gud, Kind, element, gud6};

/// All of this subject.
pub(super) const DATA: &[Gud] = &[gud6("_CBIT", Kind::Bool, &[30], CBIT)];

/// B:13132 prints 16 switches, appendix C 30 (B:16617); index 16 exists.
const CBIT: &[Element] = &[
    element("0", "B:13534").switch(),
    element("1", "B:13536").switch(),
    element("2", "B:13537").switch(),
    element("3", "B:13539").initial(1.0).switch(),
    element("4", "B:13540").internal(),
    element("5", "B:13541-13544").switch(),
    element("6", "B:13545-13546").switch(),
    element("7", "B:13547-13548").switch(),
    element("8", "B:13549-13550").initial(1.0).switch(),
    element("9", "B:13551").internal(),
    element("10", "B:13552").internal(),
    element("11", "B:13556-13557").switch(),
    element("12", "B:13558-13559").switch(),
    element("13", "B:13560").switch(),
    element("14", "B:13561-13562").switch(),
    element("15", "B:13563-13564").switch(),
    element("16", "B:13565").initial(1.0).switch(),
];
