//! Names of parameters, so that a slip does not compile.

/// Measuring variant.
pub const MVAR: &str = "_MVAR";
/// Set size or set position.
pub const SETVAL: &str = "_SETVAL";
/// Set length of a rectangle in the abscissa.
pub const SETV0: &str = "_SETV[0]";
/// Set length of a rectangle in the ordinate.
pub const SETV1: &str = "_SETV[1]";
/// Set centre of sphere 1, applicate; or corner: offset of the zero point or P2, abscissa.
pub const SETV2: &str = "_SETV[2]";
/// Set centre of sphere 2, abscissa; or corner: offset of the zero point or P2, ordinate.
pub const SETV3: &str = "_SETV[3]";
/// Set centre of sphere 2, ordinate; or corner: selection of the offset, or P3, abscissa.
pub const SETV4: &str = "_SETV[4]";
/// Set centre of sphere 2, applicate; or corner: P3, ordinate.
pub const SETV5: &str = "_SETV[5]";
/// Set centre of sphere 3, abscissa; or corner: P4, abscissa.
pub const SETV6: &str = "_SETV[6]";
/// Set centre of sphere 3, ordinate; or corner: P4, ordinate.
pub const SETV7: &str = "_SETV[7]";
/// Set centre of sphere 3, applicate.
pub const SETV8: &str = "_SETV[8]";
/// Infeed from the start height to the measuring height, signed.
pub const ID: &str = "_ID";
/// Protection zone: diameter, width or length in the abscissa.
pub const SZA: &str = "_SZA";
/// Protection zone: length in the ordinate.
pub const SZO: &str = "_SZO";
/// Measuring axis.
pub const MA: &str = "_MA";
/// Measuring direction.
pub const MD: &str = "_MD";
/// What is corrected.
pub const KNUM: &str = "_KNUM";
/// The same in CYCLE119.
pub const COR: &str = "_COR";
/// T number of the tool to be corrected.
pub const TNUM: &str = "_TNUM";
/// Name of the tool to be corrected.
pub const TNAME: &str = "_TNAME";
/// DL number of the setup or additive offset.
pub const DLNUM: &str = "_DLNUM";
/// Tool environment.
pub const TENV: &str = "_TENV";
/// Probe type and number.
pub const PRNUM: &str = "_PRNUM";
/// Measuring path.
pub const FA: &str = "_FA";
/// Safe area.
pub const TSA: &str = "_TSA";
/// Measuring feed.
pub const VMS: &str = "_VMS";
/// Measurements at the same place.
pub const NMSP: &str = "_NMSP";
/// Spindle offset of a mono probe.
pub const CORA: &str = "_CORA";
/// Zero offset area.
pub const TZL: &str = "_TZL";
/// Limit of mean value formation.
pub const TMV: &str = "_TMV";
/// Upper tolerance.
pub const TUL: &str = "_TUL";
/// Lower tolerance.
pub const TLL: &str = "_TLL";
/// Permissible dimensional difference.
pub const TDIF: &str = "_TDIF";
/// Memories of empirical and mean value.
pub const EVNUM: &str = "_EVNUM";
/// Weighting factor of the mean value.
pub const K: &str = "_K";
/// Set centre in the abscissa.
pub const CPA: &str = "_CPA";
/// Set centre in the ordinate.
pub const CPO: &str = "_CPO";
/// Starting angle.
pub const STA1: &str = "_STA1";
/// Indexing angle.
pub const INCA: &str = "_INCA";
/// Feed along circular paths.
pub const RF: &str = "_RF";
/// Rotary axis that takes the angle.
pub const RA: &str = "_RA";
/// Number of the reference groove or gauging block.
pub const CALNUM: &str = "_CALNUM";
/// Limit of the distortion of a triangle of spheres.
pub const TNVL: &str = "_TNVL";
