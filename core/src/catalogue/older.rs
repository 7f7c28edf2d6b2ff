//! The parameterizing calls of controls up to SW 5.4, which stand behind `CYCLE_PARA(…)` (B:11640-12133). Their
//! arguments have the names of the data that they fill (B:11728-11730). Where a list has no `_MVAR`, selections add up
//! to the number of the variant.

use super::common::args::*;
use super::{cycle961, cycle971, cycle973, cycle976, cycle979};
use crate::catalogue::prelude::*;
use crate::entry::Arg::{Down, Is, Open, Select};

const fn list(name: &'static str, when: When, source: &'static str) -> ArgumentList {
    ArgumentList { style: Style::Indirect, name, when, base: 0, args: &[], published: &[], source }
}

// which cycle is meant, and selections
const OF_977: Arg = Is(977);
const OUTSIDE: Arg = Select(&[(0, 0), (1, 1)]);
const SKEW: Arg = Select(&[(0, 0), (1, 10_000)]);
const BALL: Arg = Select(&[(0, 0), (1, 100)]);

/// CYCLE961 by distances and angles (B:12027-12078).
pub const CYCLE961_W: ArgumentList = list("CYCLE_961_W", cycle961::params::DISTANCES, "B:12033-12052;A:13373-13384")
    .selecting(105, &[OUTSIDE, EDGES, SETV0, SETV1, ID, STA1, INCA, KNUM, SETV4, SETV2, SETV3, PRNUM]);
/// Three points of a rectangle, or four.
const EDGES: Arg = Select(&[(3, 0), (4, 2)]);

/// CYCLE961 by points; the infeed has no sign there.
pub const CYCLE961_P: ArgumentList = list("CYCLE_961_P", cycle961::params::POINTS, "B:12066-12078;A:13400-13411")
    .selecting(117, &[OUTSIDE, Down(names::ID), SETV0, SETV1, SETV2, SETV3, SETV4, SETV5, SETV6, SETV7, KNUM, PRNUM]);

/// CYCLE973 on a surface: one call for it and CYCLE976 (B:11784-11821).
pub const CYCLE973_SURFACE: ArgumentList =
    surface(cycle973::params::SURFACE).args(&[Is(973), SETVAL, MA, MD, PRNUM, MVAR]);

/// CYCLE973 in a groove; the number of directions is always written (B:11811-11821).
pub const CYCLE973_GROOVE: ArgumentList = list("CYCLE_973", cycle973::params::GROOVE, "B:11811-11821;A:13158-13165")
    .selecting(13, &[SETVAL, SKEW, ONE_OR_TWO, BALL, MA, MD, CALNUM, PRNUM]);
const ONE_OR_TWO: Arg = Select(&[(1, 1000), (2, 2000)]);

/// CYCLE976 in a hole, put together from selections (B:11784-11854).
pub const CYCLE976_HOLE: ArgumentList = list("CYCLE_976", cycle976::params::HOLE, "B:11834-11854;A:13184-13192")
    .selecting(1, &[SETVAL, AT_ANGLE, SKEW, DIRECTIONS, BALL, MA, MD, STA1, PRNUM, CENTRE]);
const AT_ANGLE: Arg = Select(&[(0, 0), (1, 100_000)]);
const DIRECTIONS: Arg = Select(&[(1, 1000), (2, 2000), (4, 0)]);
/// From the known to the unknown centre: first digit 1 to 8.
const CENTRE: Arg = Select(&[(0, 0), (1, 7)]);

/// CYCLE976 on a surface.
pub const CYCLE976_SURFACE: ArgumentList = surface(When::Any(&[cycle976::params::SURFACE, cycle976::params::LENGTH]))
    .args(&[Is(976), SETVAL, MA, MD, PRNUM, MVAR]);

const fn surface(when: When) -> ArgumentList {
    list("CYCLE_CAL_PROBE", when, "B:11784-11797;A:13134-13139")
}

pub const CYCLE974: ArgumentList = list("CYCLE_974", When::Always, "B:12084-12098;A:13427-13434")
    .args(&[MVAR, SETVAL, MA, TNUM, TNAME, KNUM, PRNUM, STA1]);

/// CYCLE977: hole and shaft.
pub const CYCLE977_ROUND: ArgumentList = list("CYCLE_977_979A", mvar(1, &[1, 2]), "B:11894-11923;A:13046")
    .args(&[OF_977, MVAR, SETVAL, ID, SZA, TNUM, TNAME, KNUM, Open, Open, Open, Open, PRNUM]);

/// CYCLE977: groove and web.
pub const CYCLE977_WIDTH: ArgumentList = list("CYCLE_977_979B", mvar(1, &[3, 4]), "B:11925-11951")
    .args(&[OF_977, MVAR, SETVAL, ID, MA, TNUM, TNAME, KNUM, Open, Open, Open, SZA, PRNUM]);

/// CYCLE977: rectangles.
pub const CYCLE977_RECTANGLE: ArgumentList = list("CYCLE_977_979C", mvar(1, &[5, 6]), "B:11953-11985")
    .args(&[MVAR, SETV0, SETV1, ID, SZA, SZO, TNUM, TNAME, KNUM]);

pub const CYCLE978: ArgumentList =
    list("CYCLE_978", When::Always, "B:11987-11996").args(&[MVAR, SETVAL, MA, TNUM, TNAME, KNUM]);

/// CYCLE979: hole and shaft, in the call of CYCLE977.
pub const CYCLE979_ROUND: ArgumentList = list("CYCLE_977_979A", cycle979::params::ROUND, "B:11908-11923;A:13248-13260")
    .args(&[Is(979), MVAR, SETVAL, ID, Open, TNUM, TNAME, KNUM, CPA, CPO, STA1, INCA, PRNUM]);

/// CYCLE979: groove and web.
pub const CYCLE979_WIDTH: ArgumentList = list("CYCLE_977_979B", cycle979::params::WIDTH, "B:11937-11951;A:13276-13289")
    .args(&[Is(979), MVAR, SETVAL, ID, Open, TNUM, TNAME, KNUM, CPA, CPO, STA1, Open, PRNUM]);

pub const CYCLE994: ArgumentList = list("CYCLE_994", When::Always, "B:12108-12121;A:13450-13458")
    .args(&[MVAR, SETVAL, MA, TNUM, TNAME, KNUM, SZA, SZO, PRNUM]);

pub const CYCLE998: ArgumentList =
    list("CYCLE_998", When::Always, "B:12008-12015;A:13350-13357").args(&[MVAR, SETVAL, ID, RA, MA, KNUM, STA1, PRNUM]);

/// Calibrating the tool probe of a milling machine, in the machine (B:11755-11772).
pub const CYCLE971_CALIBRATION: ArgumentList =
    calibration(When::Variant(&[0, 10_000])).args(&[Is(971), MA, PRNUM, Select(&[(0, 0), (1, 10_000)]), FA]);

/// CYCLE971 (B:11856-11879). The speeds and feeds `_MFS[]` are printed the other way round than the data are defined
/// (B:13515-13520), which count.
pub const CYCLE971: ArgumentList = list("CYCLE_971", cycle971::params::MEASURE, "B:11870-11879;A:13210-13219")
    .args(&[MVAR, MA, ID, PRNUM, MFS0, MFS1, MFS2, MFS3, MFS4, MFS5]);

/// Calibrating the tool probe of a turning machine (B:11755-11772); the selection counts for CYCLE971 only.
pub const CYCLE972_CALIBRATION: ArgumentList =
    calibration(When::Variant(&[0])).args(&[Is(972), MA, PRNUM, Select(&[(0, 0), (1, 0)]), FA]);

/// CYCLE972 (B:11881-11888).
pub const CYCLE972: ArgumentList =
    list("CYCLE_972", When::Variant(&[1]), "B:11887-11888;A:13231-13232").selecting(1, &[MA, PRNUM]);

/// A call that calibrates a tool probe.
const fn calibration(when: When) -> ArgumentList {
    list("CYCLE_CAL_TOOLSETTER", when, "B:11767-11772;A:13108-13112")
}
