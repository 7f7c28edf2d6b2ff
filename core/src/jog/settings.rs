//! What the set-up of JOG makes of a measurement: `_JM_I`, `_JM_B`, `E_MESS_…` (B:14157-14368). Lengths in mm, feeds in
//! mm/min: the data of JOG are metric whatever the machine is (B:14170-14172).

use crate::control::{Control, OLDER_JOG, Plane};

/// Which tool probe is used, from 1 (B:14330).
pub const TOOL_PROBE: &str = "_JM_I[2]";
/// Attempts at a point until the probe switches, where `_JM_B[1]` is 0 (B:14356-14358).
const ATTEMPTS: u32 = 5;
/// Value of `_JM_I[4]` that leaves the zero offset to the machine data, whose reset value is G500 (B:14334).
const AS_MACHINE_DATA: f64 = 100.0;

/// How is touched and travelled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Data field of the probe, from 1, and whether it is a mono probe.
    pub probe: (i64, bool),
    /// Measuring path in front of and behind the point (`E_MESS_D_M`).
    pub path: f64,
    /// Measuring feed (`E_MESS_FM`).
    pub feed: f64,
    /// Feed of a first, fast touch (`_JM_B[3]`, `_SPEED[3]`).
    pub fast: Option<f64>,
    /// Positioning in the plane (`E_MESS_F`) and along the applicate (`E_MESS_FZ`).
    pub positioning: [f64; 2],
    /// Attempts until the probe switches (`_JM_B[1]`).
    pub attempts: u32,
    /// Whether the way back from the point is in rapid traverse (`_JM_B[2]`).
    pub rapid_return: bool,
    /// Whether the spindle follows a rotation of the WCS (`E_MESS_SETT[0]` = 0).
    pub follows: bool,
}

impl Settings {
    /// As the data of the control say.
    pub fn of(control: &Control) -> Settings {
        let number = |name: &str| control.number(name);
        Settings {
            probe: probe(control),
            path: number("E_MESS_D_M"),
            feed: number("E_MESS_FM"),
            fast: control.bit("_JM_B[3]").then(|| control.basic_length("_SPEED[3]")),
            positioning: [number("E_MESS_F"), number("E_MESS_FZ")],
            attempts: if control.bit("_JM_B[1]") { 1 } else { ATTEMPTS },
            rapid_return: control.bit("_JM_B[2]"),
            follows: !control.bit("E_MESS_SETT[0]"),
        }
    }
}

/// The probe: by the plane with `_JM_I[0]` = 1, G17 1, G18 2, G19 3; else `_JM_I[1]`, whose third digit 1 is a mono
/// probe (B:14321-14324).
fn probe(control: &Control) -> (i64, bool) {
    if control.number("_JM_I[0]") == 1.0 {
        let by_plane = match plane(control) {
            Plane::G17 => 1,
            Plane::G18 => 2,
            Plane::G19 => 3,
        };
        return (by_plane, false);
    }
    let number = control.number("_JM_I[1]") as i64;
    (number % 100, number / 100 % 10 == 1)
}

/// The plane while measuring; another number than 17 to 19 leaves that of the machine (B:14326-14330).
pub fn plane(control: &Control) -> Plane {
    Plane::of(control.number("_JM_I[3]") as u16).unwrap_or(control.plane)
}

/// Whether the masks are those up to measuring cycles SW 6.2.
pub fn older(control: &Control) -> bool {
    control.bit(OLDER_JOG)
}

/// The settable frame that is active while measuring (B:14331-14334).
pub fn measuring(control: &Control) -> usize {
    match control.number("_JM_I[4]") {
        AS_MACHINE_DATA => 0,
        number => number.clamp(0.0, 99.0) as usize,
    }
}

/// What `_JM_I[4]` is for a settable frame to be active while measuring.
pub fn number(settable: usize) -> f64 {
    if settable == 0 { AS_MACHINE_DATA } else { settable as f64 }
}

/// The preset of a field by a datum of the probe: diameter of the ring, height of the surface (B:2897-2900).
pub fn preset(control: &Control, name: &str) -> Option<f64> {
    let datum = match name {
        "d" => "E_MESS_CAL_D",
        "z0" => "E_MESS_CAL_L",
        _ => return None,
    };
    let (field, _) = probe(control);
    Some(control.number(&format!("{datum}[{}]", field - 1)))
}
