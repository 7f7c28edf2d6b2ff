//! Names of the data of the log, so that a slip does not compile.

/// Program that the log is about, printed in the header.
pub const PROGRAM: &str = "_PROTNAME[0]";
/// Name of the log file.
pub const FILE: &str = "_PROTNAME[1]";
/// Texts of the user in the header.
pub const HEADLINES: [&str; 10] = [
    "_HEADLINE[0]",
    "_HEADLINE[1]",
    "_HEADLINE[2]",
    "_HEADLINE[3]",
    "_HEADLINE[4]",
    "_HEADLINE[5]",
    "_HEADLINE[6]",
    "_HEADLINE[7]",
    "_HEADLINE[8]",
    "_HEADLINE[9]",
];
/// Lines of a page.
pub const PAGE: &str = "_PROTFORM[0]";
/// Characters of a line.
pub const LINE: &str = "_PROTFORM[1]";
/// Number of the first page.
pub const FIRST_PAGE: &str = "_PROTFORM[2]";
/// How many of the texts of the user are printed.
pub const HEAD_LINES: &str = "_PROTFORM[3]";
/// Lines of a block of values.
pub const VALUE_LINES: &str = "_PROTFORM[4]";
/// Characters of a column; 0: as in the first title line.
pub const COLUMN: &str = "_PROTFORM[5]";
/// Between two values.
pub const SEPARATOR: &str = "_PROTSYM[0]";
/// Behind a value out of tolerance.
pub const MARK: &str = "_PROTSYM[1]";
/// Decimals.
pub const DIGITS: &str = "_DIGIT";
/// Title lines.
pub const TITLES: [&str; 2] = ["_PROTVAL[0]", "_PROTVAL[1]"];
/// What the lines of a block of values show.
pub const VALUES: [&str; 4] = ["_PROTVAL[2]", "_PROTVAL[3]", "_PROTVAL[4]", "_PROTVAL[5]"];
/// First parameter of the calls with arguments.
pub const JOB: &str = "PAR1";
