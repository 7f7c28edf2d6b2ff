//! Data that say what is printed and how (B:11340-11441). They belong to the machine and keep their values, so that
//! none has to be written before a call. The example is a log of one line of values below a header, as in the sample of
//! the manual (B:11513-11600).

use super::{columns, names};
use crate::catalogue::prelude::*;
use crate::entry::ReadColumns;

/// Longest line of a log, characters (A:15947).
pub const LONGEST_LINE: f64 = 200.0;
/// Most lines of a block of values (B:11359, A:15907).
const MOST_LINES: f64 = 4.0;

/// The header is the one that the cycles print by themselves (B:11456).
pub const STANDARD_HEADER: When = When::Setting { name: super::OWN_HEADER, is: &[0.0] };

const fn text(most: usize, name: Name, key: &'static str, source: &'static str) -> Param {
    Param { kind: Kind::Text(most), ..param(name, key, source) }
}

const fn number(name: Name, key: &'static str, source: &'static str) -> Param {
    Param { kind: Kind::Integer, range: Range::NOT_NEGATIVE, ..param(name, key, source) }
}

/// What is printed, in CYCLE105 and CYCLE106, or which text is made, in CYCLE113: the variant.
pub const JOB: Param = Param { name: names::JOB, kind: Kind::Variant(&[]), needs: ALWAYS_REQUIRED, ..PARAM };
/// Name of the log file; the form asks for it where there is one, as the delivered one is empty.
pub const FILE: Param = Param {
    needs: &[required(When::Always, "need-log-file")],
    alarm: Some(Code::Alarm(61354)),
    example: "LOG_1",
    ..text(32, names::FILE, "log-file", "B:11192;B:11346")
};

/// The data of a log in the order of the manual's table, behind parameters of the cycle's own: those of the header are
/// asked for where the first condition holds, those of the values where the second one does.
macro_rules! log_params {
    ($($own:expr),*; header $header:expr; values $values:expr) => {{
        use crate::catalogue::logging::params::*;
        const AT_HEADER: &[Need] = &[of_header($header)];
        const AT_STANDARD: &[Need] = &[of_header(When::All(&[$header, STANDARD_HEADER]))];
        const AT_VALUES: &[Need] = &[of_values($values)];
        &[
            $($own,)*
            Param { needs: AT_STANDARD, ..PROGRAM },
            headline(0, "Part number: 123456789", &[of_header(When::All(&[$header, lines(0)]))]),
            headline(1, "Job number: 6878", &[of_header(When::All(&[$header, lines(1)]))]),
            headline(2, "Supervisor: Müller Phone: 1234", &[of_header(When::All(&[$header, lines(2)]))]),
            headline(3, "", &[of_header(When::All(&[$header, lines(3)]))]),
            headline(4, "", &[of_header(When::All(&[$header, lines(4)]))]),
            headline(5, "", &[of_header(When::All(&[$header, lines(5)]))]),
            headline(6, "", &[of_header(When::All(&[$header, lines(6)]))]),
            headline(7, "", &[of_header(When::All(&[$header, lines(7)]))]),
            headline(8, "", &[of_header(When::All(&[$header, lines(8)]))]),
            headline(9, "", &[of_header(When::All(&[$header, lines(9)]))]),
            Param { needs: AT_HEADER, ..PAGE },
            LINE,
            Param { needs: AT_STANDARD, ..FIRST_PAGE },
            Param { needs: AT_HEADER, ..HEAD_LINES },
            Param { needs: AT_VALUES, ..VALUE_LINES },
            COLUMN,
            SEPARATOR,
            Param { needs: AT_VALUES, ..MARK },
            title(0, "Meas.,Axis,Set,Act. value,Difference,Time", TITLED),
            title(1, "point,,value", AT_STANDARD),
            values(0, "_TXT[0],_AXIS,_OVR[0],_OVR[4],_OVR[16],_TIME", &[of_values(When::All(&[$values, rows(0)]))]),
            values(1, "", &[of_values(When::All(&[$values, rows(1)]))]),
            values(2, "", &[of_values(When::All(&[$values, rows(2)]))]),
            values(3, "", &[of_values(When::All(&[$values, rows(3)]))]),
            Param { needs: AT_VALUES, ..DIGITS },
        ]
    }};
}
pub(in crate::catalogue) use log_params;

/// A datum of the header.
pub const fn of_header(when: When) -> Need {
    optional(when, "need-log-header")
}

/// A datum of the values.
pub const fn of_values(when: When) -> Need {
    optional(when, "need-log-values")
}

/// More texts of the user are printed than this number.
pub const fn lines(index: usize) -> When {
    When::Above { param: names::HEAD_LINES, than: index as f64 }
}

/// A block of values has more lines than this number.
pub const fn rows(index: usize) -> When {
    When::Above { param: names::VALUE_LINES, than: index as f64 }
}

/// A text of the user.
pub const fn headline(index: usize, example: &'static str, needs: &'static [Need]) -> Param {
    Param { needs, example, ..text(80, names::HEADLINES[index], "log-headline", "B:11347") }
}

/// A title line; the definition of the data gives 100 characters, the text 80 (B:13167, B:11357).
pub const fn title(index: usize, example: &'static str, needs: &'static [Need]) -> Param {
    let columns = Some(columns::titles as ReadColumns);
    Param { needs, example, columns, ..text(100, names::TITLES[index], "log-title", "B:11357-11358;B:11404") }
}

/// What a line of values shows.
pub const fn values(index: usize, example: &'static str, needs: &'static [Need]) -> Param {
    let columns = Some(columns::values as ReadColumns);
    Param { needs, example, columns, ..text(100, names::VALUES[index], "log-values", "B:11359;B:11375-11411") }
}

/// The first title line also where the columns are made of it.
pub const TITLED: &[Need] = &[optional(When::Any(&[STANDARD_HEADER, WIDTHS_OF_TITLES]), "need-log-titles")];
const WIDTHS_OF_TITLES: When = When::Number { param: names::COLUMN, is: &[0.0] };
const FORMAT: &[Need] = &[optional(When::Always, "need-log-format")];

/// Program that is measured.
pub const PROGRAM: Param = Param { example: "MEASPROGRAM_1", ..text(32, names::PROGRAM, "log-program", "B:11345") };
/// Lines of a page.
pub const PAGE: Param = number(names::PAGE, "log-page", "B:11349;B:11435;A:12759");
/// Characters of a line.
pub const LINE: Param =
    Param { range: Range::POSITIVE, needs: FORMAT, ..number(names::LINE, "log-line", "B:11350;A:15947") };
/// First page number.
pub const FIRST_PAGE: Param = number(names::FIRST_PAGE, "log-first-page", "B:11351");
/// How many texts of the user there are.
pub const HEAD_LINES: Param = Param {
    range: Range::closed(0.0, names::HEADLINES.len() as f64),
    example: "3",
    ..number(names::HEAD_LINES, "log-head-lines", "B:11352;B:11347")
};
/// How many lines a block of values has.
pub const VALUE_LINES: Param = Param {
    range: Range::closed(0.0, MOST_LINES),
    alarm: Some(Code::Alarm(61363)),
    example: "1",
    ..number(names::VALUE_LINES, "log-value-lines", "B:11353;A:15907")
};
/// Width of a column.
pub const COLUMN: Param =
    Param { needs: FORMAT, example: "12", ..number(names::COLUMN, "log-column", "B:11354;B:11437") };
/// Between two values.
pub const SEPARATOR: Param =
    Param { needs: FORMAT, example: ",", ..text(1, names::SEPARATOR, "log-separator", "B:11355;B:13165") };
/// Behind a value out of tolerance.
pub const MARK: Param = Param { example: "*", ..text(1, names::MARK, "log-mark", "B:11356;B:11439-11441") };
/// Decimals of all real numbers.
pub const DIGITS: Param =
    Param { usual: Range::closed(0.0, 6.0), ..number(names::DIGITS, "log-digits", "B:11431;B:13174") };
