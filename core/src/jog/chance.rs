//! The part as parts lie: moved, turned and of another size than in the setup, by a seed. The same seed makes the same
//! part on every machine.

use crate::geometry::{Rpy, V3, rigid};
use crate::machine::Setup;
use crate::workpiece::{Noise, Solid};

/// How a part was put: what a measurement should find.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct Truth {
    /// Seed that made it.
    pub seed: u64,
    /// Displacement X Y Z of the first solid, mm.
    pub shift: [f64; 3],
    /// Rotation about the machine's X Y Z (RPY), degree.
    pub tilt: Rpy,
    /// Added to every diameter, width and length, mm.
    pub size: f64,
}

/// Most displacement along the axes, mm; most rotation about them, degree; most oversize, mm.
const SHIFT: [f64; 3] = [3.0, 3.0, 1.0];
const TILT: [f64; 3] = [0.4, 0.4, 3.0];
const SIZE: f64 = 0.1;

/// Puts the part of a setup as the seed says, all of it in one piece, about the first solid.
pub fn put(setup: &mut Setup, seed: u64) -> Truth {
    let mut noise = Noise::new(seed);
    let mut spread = |most: f64| most * (2.0 * noise.uniform() - 1.0);
    let shift = SHIFT.map(&mut spread);
    let tilt = Rpy(TILT.map(&mut spread));
    let size = spread(SIZE);
    let turn = rigid::rotation(tilt);
    let about = setup.workpiece.solids.first().map_or(V3::zeros(), |solid| V3::from(solid.at));
    for Solid { at, errors, .. } in &mut setup.workpiece.solids {
        let arm = V3::from(*at) - about;
        let moved: [f64; 3] = (turn * arm - arm).into();
        errors.shift = std::array::from_fn(|axis| errors.shift[axis] + shift[axis] + moved[axis]);
        errors.tilt = rigid::angles(&(turn * rigid::rotation(errors.tilt)));
        errors.size += size;
    }
    Truth { seed, shift, tilt, size }
}
