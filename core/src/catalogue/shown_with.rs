//! What a picture shows for a parameter that no figure can stand for: a feed is seen at the way, a correction target at
//! what is measured, the mean value at the tolerances.

use super::logging::names as log;
use crate::catalogue::prelude::*;
use crate::entry::address::{F, I, K, M, S, T, U, V, W, X, Y, Z};

/// Groups of parameters whose figures stand for a parameter without one; the first of which anything is drawn counts.
pub fn shown_with(name: Name) -> &'static [&'static [Name]] {
    TABLE.iter().find(|(names, _)| names.contains(&name)).map_or(&[], |(_, groups)| groups)
}

type Row = (&'static [Name], &'static [&'static [Name]]);

/// Limits of the correction.
const TOLERANCES: &[Name] = &[names::TUL, names::TLL];
/// What is measured and corrected, and the variant that says so.
const TARGET: &[Name] = &[names::MVAR, names::KNUM, names::TNUM, names::TNAME, names::DLNUM, names::TENV];
/// Axes that turn, a size or a position, a length in two axes, an angle, the work of a variant.
const MEASURED: &[&[Name]] =
    &[&[names::RA], &[names::SETVAL], &[names::SETV0, names::SETV1], &[names::STA1], &[names::MVAR]];
/// What an NCT macro moves to and measures.
const ADDRESSES: &[&[Name]] = &[&[address::D], &address::AXES];

const TABLE: &[Row] = &[
    (TARGET, MEASURED),
    (&[names::VMS, names::RF], &[&[names::FA], &[names::MVAR]]),
    (&[names::TZL, names::TMV, names::K, names::EVNUM], &[TOLERANCES, &[names::TDIF], &[names::TSA], &[names::SETVAL]]),
    (&[names::TSA], &[&[names::SETVAL]]),
    (LOG_FORMAT, &[&[log::LINE]]),
    (&[log::JOB], &[&[log::LINE], &[Name::new("PAR5")]]),
    (LOG_VALUES, &[&[log::VALUES[0]], &[log::LINE]]),
    (&[X, Y, Z, F, I, K, M, S, T, U, V, W], ADDRESSES),
];

/// Of the whole page, or of a part that this call does not print.
const LOG_FORMAT: &[Name] = &[log::PAGE, log::FIRST_PAGE, log::HEAD_LINES];
/// Of a block of values.
const LOG_VALUES: &[Name] = &[log::VALUE_LINES, log::MARK, log::DIGITS, log::TITLES[0]];
