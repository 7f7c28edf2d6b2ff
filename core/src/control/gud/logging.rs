//! Logging (B:11345-11431, B:13153-13174) and what the control is (`_SI`, B:13681-13687).

use super::{Element, Gud, Kind, element, gud6};
use crate::range::Range;

/// All of this subject.
pub(super) const DATA: &[Gud] = &[
    gud6("_SI", Kind::Text, &[3], SI),
    gud6("_PROTNAME", Kind::Text, &[2], PROTNAME),
    gud6("_HEADLINE", Kind::Text, &[10], HEADLINE),
    gud6("_PROTFORM", Kind::Integer, &[6], PROTFORM),
    gud6("_PROTSYM", Kind::Text, &[2], PROTSYM),
    gud6("_PROTVAL", Kind::Text, &[13], PROTVAL),
    gud6("_PMI", Kind::Integer, &[4], PMI),
    gud6("_SP_B", Kind::Integer, &[20], SP_B),
    gud6("_TXT", Kind::Text, &[100], TXT),
    gud6("_DIGIT", Kind::Integer, &[], DIGIT),
];

const SI: &[Element] =
    &[element("0", "B:13681").internal(), element("1", "B:13682").text("6"), element("2", "B:13683").internal()];

const PROTNAME: &[Element] = &[element("0", "B:11345"), element("1", "B:11346")];

const HEADLINE: &[Element] = &[element("0..9", "B:11347")];

const PROTFORM: &[Element] = &[
    element("0", "B:11349").initial(60.0).within(Range::NOT_NEGATIVE),
    element("1", "B:11350").initial(80.0).within(Range::NOT_NEGATIVE),
    element("2", "B:11351").initial(1.0).within(Range::NOT_NEGATIVE),
    element("3", "B:11352").initial(3.0).within(Range::NOT_NEGATIVE),
    element("4", "B:11353").initial(1.0).within(Range::NOT_NEGATIVE),
    element("5", "B:11354").initial(12.0).within(Range::NOT_NEGATIVE),
];

/// B:11355 prints a comma, B:13165 and B:16309 a semicolon.
const PROTSYM: &[Element] = &[element("0", "B:11355").text(";"), element("1", "B:11356").text("#")];

const PROTVAL: &[Element] =
    &[element("0..1", "B:11357-11358"), element("2..5", "B:11359"), element("6..12", "B:13170").internal()];

const PMI: &[Element] = &[
    element("0", "B:13171").internal(),
    element("1", "B:13171").internal(),
    element("2", "B:13171").internal(),
    element("3", "B:13171").internal(),
];

const SP_B: &[Element] = &[element("0..19", "B:13172").internal()];

const TXT: &[Element] = &[element("0..99", "B:11360").internal()];

const DIGIT: &[Element] = &[element("", "B:13174").initial(3.0).within(Range::NOT_NEGATIVE)];
