//! Data that say what is printed and how (B:11340-11441). They belong to the machine and keep their values, so that
//! none has to be written before a call.

use super::names;
use crate::catalogue::common::{PARAM, alarms, optional};
use crate::entry::{Kind, Need, Param, When};
use crate::range::Range;

/// Longest line of a log, characters (A:15947).
pub const LONGEST_LINE: f64 = 200.0;
/// Most lines of a block of values (B:11359, A:15907).
const MOST_LINES: f64 = 4.0;

/// The header is the one that the cycles print by themselves (B:11456).
pub const STANDARD_HEADER: When = When::Setting { name: super::OWN_HEADER, is: &[0.0] };

const fn text(most: usize) -> Param {
    Param { kind: Kind::Text(most), ..PARAM }
}

const NUMBER: Param = Param { kind: Kind::Integer, range: Range::NOT_NEGATIVE, ..PARAM };

/// Name of the log file; the form asks for it, as the delivered one is empty.
pub const FILE: Param = Param { name: names::FILE, key: "log-file", source: "B:11192;B:11346", ..text(32) };

/// The data of a log in the order of the manual's table, behind parameters of the cycle's own: those of the header are
/// asked for where the first condition holds, those of the values where the second one does.
macro_rules! log_params {
    ($($own:expr),*; header $header:expr; values $values:expr) => {
        &[
            $($own,)*
            params::program(&[optional(When::All(&[$header, params::STANDARD_HEADER]), "need-log-header")]),
            params::headline(0, &[optional(When::All(&[$header, params::lines(0)]), "need-log-header")]),
            params::headline(1, &[optional(When::All(&[$header, params::lines(1)]), "need-log-header")]),
            params::headline(2, &[optional(When::All(&[$header, params::lines(2)]), "need-log-header")]),
            params::headline(3, &[optional(When::All(&[$header, params::lines(3)]), "need-log-header")]),
            params::headline(4, &[optional(When::All(&[$header, params::lines(4)]), "need-log-header")]),
            params::headline(5, &[optional(When::All(&[$header, params::lines(5)]), "need-log-header")]),
            params::headline(6, &[optional(When::All(&[$header, params::lines(6)]), "need-log-header")]),
            params::headline(7, &[optional(When::All(&[$header, params::lines(7)]), "need-log-header")]),
            params::headline(8, &[optional(When::All(&[$header, params::lines(8)]), "need-log-header")]),
            params::headline(9, &[optional(When::All(&[$header, params::lines(9)]), "need-log-header")]),
            params::page(&[optional($header, "need-log-header")]),
            params::LINE,
            params::first_page(&[optional(When::All(&[$header, params::STANDARD_HEADER]), "need-log-header")]),
            params::head_lines(&[optional($header, "need-log-header")]),
            params::value_lines(&[optional($values, "need-log-values")]),
            params::COLUMN,
            params::SEPARATOR,
            params::mark(&[optional($values, "need-log-values")]),
            params::title(0, &[optional(params::STANDARD_HEADER, "need-log-titles")]),
            params::title(1, &[optional(When::All(&[$header, params::STANDARD_HEADER]), "need-log-header")]),
            params::values(0, &[optional(When::All(&[$values, params::rows(0)]), "need-log-values")]),
            params::values(1, &[optional(When::All(&[$values, params::rows(1)]), "need-log-values")]),
            params::values(2, &[optional(When::All(&[$values, params::rows(2)]), "need-log-values")]),
            params::values(3, &[optional(When::All(&[$values, params::rows(3)]), "need-log-values")]),
            params::digits(&[optional($values, "need-log-values")]),
        ]
    };
}
pub(in crate::catalogue) use log_params;

/// More texts of the user are printed than this number.
pub const fn lines(index: usize) -> When {
    When::Above { param: names::HEAD_LINES, than: index as f64 }
}

/// A block of values has more lines than this number.
pub const fn rows(index: usize) -> When {
    When::Above { param: names::VALUE_LINES, than: index as f64 }
}

/// Program that is measured.
pub const fn program(needs: &'static [Need]) -> Param {
    Param { name: names::PROGRAM, key: "log-program", needs, source: "B:11345", ..text(32) }
}

/// A text of the user.
pub const fn headline(index: usize, needs: &'static [Need]) -> Param {
    Param { name: names::HEADLINES[index], key: "log-headline", needs, source: "B:11347", ..text(80) }
}

/// Lines of a page.
pub const fn page(needs: &'static [Need]) -> Param {
    Param { name: names::PAGE, key: "log-page", needs, source: "B:11349;B:11435;A:12759", ..NUMBER }
}

/// Characters of a line.
pub const LINE: Param = Param {
    name: names::LINE,
    key: "log-line",
    range: Range::POSITIVE,
    needs: &[optional(When::Always, "need-log-format")],
    source: "B:11350;A:15947",
    ..NUMBER
};

/// First page number.
pub const fn first_page(needs: &'static [Need]) -> Param {
    Param { name: names::FIRST_PAGE, key: "log-first-page", needs, source: "B:11351", ..NUMBER }
}

/// How many texts of the user there are.
pub const fn head_lines(needs: &'static [Need]) -> Param {
    Param {
        name: names::HEAD_LINES,
        key: "log-head-lines",
        range: Range::closed(0.0, names::HEADLINES.len() as f64),
        needs,
        source: "B:11352;B:11347",
        ..NUMBER
    }
}

/// How many lines a block of values has.
pub const fn value_lines(needs: &'static [Need]) -> Param {
    Param {
        name: names::VALUE_LINES,
        key: "log-value-lines",
        range: Range::closed(0.0, MOST_LINES),
        alarm: Some(alarms([61363])[0]),
        needs,
        source: "B:11353;A:15907",
        ..NUMBER
    }
}

/// Width of a column.
pub const COLUMN: Param = Param {
    name: names::COLUMN,
    key: "log-column",
    needs: &[optional(When::Always, "need-log-format")],
    source: "B:11354;B:11437",
    ..NUMBER
};

/// Between two values.
pub const SEPARATOR: Param = Param {
    name: names::SEPARATOR,
    key: "log-separator",
    needs: &[optional(When::Always, "need-log-format")],
    source: "B:11355;B:13165",
    ..text(1)
};

/// Behind a value out of tolerance.
pub const fn mark(needs: &'static [Need]) -> Param {
    Param { name: names::MARK, key: "log-mark", needs, source: "B:11356;B:11439-11441", ..text(1) }
}

/// A title line; the definition of the data gives 100 characters, the text 80 (B:13167, B:11357).
pub const fn title(index: usize, needs: &'static [Need]) -> Param {
    Param { name: names::TITLES[index], key: "log-title", needs, source: "B:11357-11358;B:11404", ..text(100) }
}

/// What a line of values shows.
pub const fn values(index: usize, needs: &'static [Need]) -> Param {
    Param { name: names::VALUES[index], key: "log-values", needs, source: "B:11359;B:11375-11411", ..text(100) }
}

/// Decimals of all real numbers.
pub const fn digits(needs: &'static [Need]) -> Param {
    Param {
        name: names::DIGITS,
        key: "log-digits",
        usual: Range::closed(0.0, 6.0),
        needs,
        source: "B:11431;B:13174",
        ..NUMBER
    }
}
