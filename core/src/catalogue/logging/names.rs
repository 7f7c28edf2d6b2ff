//! Names of the data of the log.

use crate::name::Name;

/// Program that the log is about, printed in the header.
pub const PROGRAM: Name = Name::new("_PROTNAME[0]");
/// Name of the log file.
pub const FILE: Name = Name::new("_PROTNAME[1]");
/// Texts of the user in the header.
pub const HEADLINES: [Name; 10] = [
    Name::new("_HEADLINE[0]"),
    Name::new("_HEADLINE[1]"),
    Name::new("_HEADLINE[2]"),
    Name::new("_HEADLINE[3]"),
    Name::new("_HEADLINE[4]"),
    Name::new("_HEADLINE[5]"),
    Name::new("_HEADLINE[6]"),
    Name::new("_HEADLINE[7]"),
    Name::new("_HEADLINE[8]"),
    Name::new("_HEADLINE[9]"),
];
/// Lines of a page.
pub const PAGE: Name = Name::new("_PROTFORM[0]");
/// Characters of a line.
pub const LINE: Name = Name::new("_PROTFORM[1]");
/// Number of the first page.
pub const FIRST_PAGE: Name = Name::new("_PROTFORM[2]");
/// How many of the texts of the user are printed.
pub const HEAD_LINES: Name = Name::new("_PROTFORM[3]");
/// Lines of a block of values.
pub const VALUE_LINES: Name = Name::new("_PROTFORM[4]");
/// Characters of a column; 0: as in the first title line.
pub const COLUMN: Name = Name::new("_PROTFORM[5]");
/// Between two values.
pub const SEPARATOR: Name = Name::new("_PROTSYM[0]");
/// Behind a value out of tolerance.
pub const MARK: Name = Name::new("_PROTSYM[1]");
/// Decimals.
pub const DIGITS: Name = Name::new("_DIGIT");
/// Title lines.
pub const TITLES: [Name; 2] = [Name::new("_PROTVAL[0]"), Name::new("_PROTVAL[1]")];
/// What the lines of a block of values show.
pub const VALUES: [Name; 4] =
    [Name::new("_PROTVAL[2]"), Name::new("_PROTVAL[3]"), Name::new("_PROTVAL[4]"), Name::new("_PROTVAL[5]")];
/// First parameter of the calls with arguments.
pub const JOB: Name = Name::new("PAR1");
