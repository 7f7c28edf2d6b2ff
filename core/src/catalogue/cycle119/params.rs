//! The arrays that the program hands over, and what is to be done with the frame (B:8560-8576).

use crate::catalogue::common::KNUM_ZERO;
use crate::catalogue::prelude::*;

/// Frame to be corrected, as `_KNUM` of a zero offset.
pub const TARGET: Name = names::COR;
/// Limit of the distortion.
pub const LIMIT: Name = Name::new("_RESLIM");

/// Coordinates of three points along the geometry axes.
pub type Names = [[Name; 3]; 3];

/// The reference triangle.
pub const SET: Names = [
    [Name::new("_SETPOINT[0,0]"), Name::new("_SETPOINT[0,1]"), Name::new("_SETPOINT[0,2]")],
    [Name::new("_SETPOINT[1,0]"), Name::new("_SETPOINT[1,1]"), Name::new("_SETPOINT[1,2]")],
    [Name::new("_SETPOINT[2,0]"), Name::new("_SETPOINT[2,1]"), Name::new("_SETPOINT[2,2]")],
];
/// The points as measured.
pub const MEASURED: Names = [
    [Name::new("_MEASPOINT[0,0]"), Name::new("_MEASPOINT[0,1]"), Name::new("_MEASPOINT[0,2]")],
    [Name::new("_MEASPOINT[1,0]"), Name::new("_MEASPOINT[1,1]"), Name::new("_MEASPOINT[1,2]")],
    [Name::new("_MEASPOINT[2,0]"), Name::new("_MEASPOINT[2,1]"), Name::new("_MEASPOINT[2,2]")],
];

/// Set points, measured points, correction.
pub const PARAMS: &[Param] = &[
    set(0, 0, "10"),
    set(0, 1, "0"),
    set(0, 2, "0"),
    set(1, 0, "0"),
    set(1, 1, "20"),
    set(1, 2, "0"),
    set(2, 0, "0"),
    set(2, 1, "0"),
    set(2, 2, "30"),
    measured(0, 0, "11"),
    measured(0, 1, "0"),
    measured(0, 2, "0"),
    measured(1, 0, "1"),
    measured(1, 1, "20"),
    measured(1, 2, "0"),
    measured(2, 0, "1"),
    measured(2, 1, "0"),
    measured(2, 2, "30"),
    Param { name: TARGET, example: "1", source: "B:8566-8572", ..KNUM_ZERO },
    Param {
        unit: Unit::BasicLength,
        range: Range::POSITIVE,
        needs: &[required(When::Given(TARGET), "need-119-corrected")],
        example: "1.2",
        ..param(LIMIT, "119-limit", "B:8573;A:9412")
    },
];

const fn set(point: usize, axis: usize, example: &'static str) -> Param {
    let key = ["119-set-x", "119-set-y", "119-set-z"][axis];
    coordinate(SET[point][axis], key, example, "B:8563-8564")
}

const fn measured(point: usize, axis: usize, example: &'static str) -> Param {
    let key = ["119-measured-x", "119-measured-y", "119-measured-z"][axis];
    coordinate(MEASURED[point][axis], key, example, "B:8565")
}

/// Workpiece coordinate; the unit is not named (B:8563-8565).
const fn coordinate(name: Name, key: &'static str, example: &'static str, source: &'static str) -> Param {
    Param { unit: Unit::ActiveLength, needs: ALWAYS_REQUIRED, example, ..param(name, key, source) }
}
