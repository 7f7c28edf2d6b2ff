//! Switches of the whole control, `_CBIT` (B:13534-13669), and of the channel.

use super::{Bool, Gud, element, gud6};

pub(super) const DATA: &[Gud] = &[
    // B:13132 prints 16 switches, appendix C 30 (B:16617); index 16 exists.
    gud6("_CBIT", Bool, &[30]).elements(&[
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
    ]),
];

/// Switches of the channel, `_CHBIT` (B:13834-14061).
pub(super) const OF_CHANNEL: &[Gud] = &[gud6("_CHBIT", Bool, &[30]).channel().elements(&[
    element("0", "B:13834-13836").switch(),
    element("1", "B:13836-13837").initial(1.0).switch(),
    element("2", "B:13838").initial(1.0).switch(),
    element("3", "B:13839-13840").switch(),
    element("4", "B:13841-13842").switch(),
    element("5", "B:13843-13844").switch(),
    element("6", "B:13845-13849").switch(),
    element("7", "B:13850-13851").switch(),
    element("8", "B:13852-13853").switch(),
    element("9", "B:13854").internal(),
    element("10", "B:13855").switch(),
    element("11", "B:13864-13865").switch(),
    element("12", "B:13866").internal(),
    element("13", "B:13867-13868").switch(),
    element("14", "B:13869").switch(),
    element("15", "B:13870").switch(),
    element("16", "B:13871").switch(),
    element("17", "B:13872").switch(),
    element("18", "B:13873").switch(),
    element("19", "B:13874").switch(),
    element("20", "B:13875").switch(),
    element("21", "B:13876").switch(),
    element("22", "B:13880-13881").switch(),
    element("23", "B:13882").switch(),
    element("24", "B:13883-13884").initial(1.0).switch(),
    element("25..29", "B:13221").internal(),
])];
