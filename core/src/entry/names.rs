//! Names of parameters that entries share.

use crate::name::Name;

/// Measuring variant.
pub const MVAR: Name = Name::new("_MVAR");
/// Set size or set position.
pub const SETVAL: Name = Name::new("_SETVAL");
/// Set length of a rectangle in the abscissa.
pub const SETV0: Name = Name::new("_SETV[0]");
/// Set length of a rectangle in the ordinate.
pub const SETV1: Name = Name::new("_SETV[1]");
/// Set centre of sphere 1, applicate; or corner: offset of the zero point or P2, abscissa.
pub const SETV2: Name = Name::new("_SETV[2]");
/// Set centre of sphere 2, abscissa; or corner: offset of the zero point or P2, ordinate.
pub const SETV3: Name = Name::new("_SETV[3]");
/// Set centre of sphere 2, ordinate; or corner: selection of the offset, or P3, abscissa.
pub const SETV4: Name = Name::new("_SETV[4]");
/// Set centre of sphere 2, applicate; or corner: P3, ordinate.
pub const SETV5: Name = Name::new("_SETV[5]");
/// Set centre of sphere 3, abscissa; or corner: P4, abscissa.
pub const SETV6: Name = Name::new("_SETV[6]");
/// Set centre of sphere 3, ordinate; or corner: P4, ordinate.
pub const SETV7: Name = Name::new("_SETV[7]");
/// Set centre of sphere 3, applicate.
pub const SETV8: Name = Name::new("_SETV[8]");
/// Infeed from the start height to the measuring height, signed.
pub const ID: Name = Name::new("_ID");
/// Protection zone: diameter, width or length in the abscissa.
pub const SZA: Name = Name::new("_SZA");
/// Protection zone: length in the ordinate.
pub const SZO: Name = Name::new("_SZO");
/// Measuring axis.
pub const MA: Name = Name::new("_MA");
/// Measuring direction.
pub const MD: Name = Name::new("_MD");
/// What is corrected.
pub const KNUM: Name = Name::new("_KNUM");
/// What CYCLE119 corrects.
pub const COR: Name = Name::new("_COR");
/// T number of the tool to be corrected.
pub const TNUM: Name = Name::new("_TNUM");
/// Name of the tool to be corrected.
pub const TNAME: Name = Name::new("_TNAME");
/// DL number of the setup or additive offset.
pub const DLNUM: Name = Name::new("_DLNUM");
/// Tool environment.
pub const TENV: Name = Name::new("_TENV");
/// Probe type and number.
pub const PRNUM: Name = Name::new("_PRNUM");
/// Measuring path.
pub const FA: Name = Name::new("_FA");
/// Safe area.
pub const TSA: Name = Name::new("_TSA");
/// Measuring feed.
pub const VMS: Name = Name::new("_VMS");
/// Measurements at the same place.
pub const NMSP: Name = Name::new("_NMSP");
/// Spindle offset of a mono probe.
pub const CORA: Name = Name::new("_CORA");
/// Zero offset area.
pub const TZL: Name = Name::new("_TZL");
/// Limit of mean value formation.
pub const TMV: Name = Name::new("_TMV");
/// Upper tolerance.
pub const TUL: Name = Name::new("_TUL");
/// Lower tolerance.
pub const TLL: Name = Name::new("_TLL");
/// Permissible dimensional difference.
pub const TDIF: Name = Name::new("_TDIF");
/// Memories of empirical and mean value.
pub const EVNUM: Name = Name::new("_EVNUM");
/// Weighting factor of the mean value.
pub const K: Name = Name::new("_K");
/// Set centre in the abscissa.
pub const CPA: Name = Name::new("_CPA");
/// Set centre in the ordinate.
pub const CPO: Name = Name::new("_CPO");
/// Starting angle.
pub const STA1: Name = Name::new("_STA1");
/// Indexing angle.
pub const INCA: Name = Name::new("_INCA");
/// Feed along circular paths.
pub const RF: Name = Name::new("_RF");
/// Rotary axis that takes the angle.
pub const RA: Name = Name::new("_RA");
/// Number of the reference groove or gauging block.
pub const CALNUM: Name = Name::new("_CALNUM");
/// Limit of the distortion of a triangle of spheres.
pub const TNVL: Name = Name::new("_TNVL");
/// Speed and feed of each probing with a rotating tool (B:13515-13520).
pub const MFS: [Name; 6] = [
    Name::new("_MFS[0]"),
    Name::new("_MFS[1]"),
    Name::new("_MFS[2]"),
    Name::new("_MFS[3]"),
    Name::new("_MFS[4]"),
    Name::new("_MFS[5]"),
];
