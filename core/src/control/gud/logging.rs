//! Logging (B:11345-11431, B:13153-13174) and what the control is (`_SI`, B:13681-13687).

use super::{Gud, Integer, Text, element, gud6};

pub(super) const DATA: &[Gud] = &[
    gud6("_SI", Text, &[3]).elements(&[
        element("0", "B:13681").internal(),
        element("1", "B:13682").text("6"),
        element("2", "B:13683").internal(),
    ]),
    gud6("_PROTNAME", Text, &[2]).elements(&[element("0", "B:11345"), element("1", "B:11346")]),
    gud6("_HEADLINE", Text, &[10]).elements(&[element("0..9", "B:11347")]),
    gud6("_PROTFORM", Integer, &[6]).elements(&[
        element("0", "B:11349").initial(60.0).not_negative(),
        element("1", "B:11350").initial(80.0).not_negative(),
        element("2", "B:11351").initial(1.0).not_negative(),
        element("3", "B:11352").initial(3.0).not_negative(),
        element("4", "B:11353").initial(1.0).not_negative(),
        element("5", "B:11354").initial(12.0).not_negative(),
    ]),
    // B:11355 prints a comma, B:13165 and B:16309 a semicolon.
    gud6("_PROTSYM", Text, &[2]).elements(&[element("0", "B:11355").text(";"), element("1", "B:11356").text("#")]),
    gud6("_PROTVAL", Text, &[13]).elements(&[
        element("0..1", "B:11357-11358"),
        element("2..5", "B:11359"),
        element("6..12", "B:13170").internal(),
    ]),
    gud6("_PMI", Integer, &[4]).elements(&[
        element("0", "B:13171").internal(),
        element("1", "B:13171").internal(),
        element("2", "B:13171").internal(),
        element("3", "B:13171").internal(),
    ]),
    gud6("_SP_B", Integer, &[20]).elements(&[element("0..19", "B:13172").internal()]),
    gud6("_TXT", Text, &[100]).elements(&[element("0..99", "B:11360").internal()]),
    gud6("_DIGIT", Integer, &[]).elements(&[element("", "B:13174").initial(3.0).not_negative()]),
];
