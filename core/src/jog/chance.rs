//! The part as parts lie: moved, turned and of another size than in the setup, as somebody says or by a seed. The same
//! seed makes the same part on every machine.

use crate::geometry::{Mcs, Rpy, V3, rigid};
use crate::machine::Setup;
use crate::workpiece::{Noise, Solid};

/// How a part was put: what a measurement should find.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Truth {
    /// Seed that made it; 0: none did.
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

impl Truth {
    /// As the seed says.
    pub fn by(seed: u64) -> Truth {
        let mut noise = Noise::new(seed);
        let mut spread = |most: f64| most * (2.0 * noise.uniform() - 1.0);
        let shift = SHIFT.map(&mut spread);
        let tilt = Rpy(TILT.map(&mut spread));
        Truth { seed, shift, tilt, size: spread(SIZE) }
    }

    /// Puts the part of a setup so, all of it in one piece, about the first solid.
    pub fn put(&self, setup: &mut Setup) {
        let turn = rigid::rotation(self.tilt);
        let about = middle(setup);
        for Solid { at, errors, .. } in &mut setup.workpiece.solids {
            let arm = V3::from(*at) - about;
            let moved: [f64; 3] = (turn * arm - arm).into();
            errors.shift = std::array::from_fn(|axis| errors.shift[axis] + self.shift[axis] + moved[axis]);
            errors.tilt = rigid::angles(&(turn * rigid::rotation(errors.tilt)));
            errors.size += self.size;
        }
    }

    /// Where a point of the part lies that lay there before; `back`: where it lay before that lies there.
    pub fn moved(&self, setup: &Setup, point: Mcs, back: bool) -> Mcs {
        let (turn, about, shift) = (rigid::rotation(self.tilt), middle(setup), V3::from(self.shift));
        let point = V3::from(point);
        let to = if back {
            about + turn.inverse() * (point - shift - about)
        } else {
            about + turn * (point - about) + shift
        };
        to.into()
    }
}

/// About what a part is turned.
fn middle(setup: &Setup) -> V3 {
    setup.workpiece.solids.first().map_or(V3::zeros(), |solid| V3::from(solid.at))
}

/// Puts the part of a setup as the seed says.
pub fn put(setup: &mut Setup, seed: u64) -> Truth {
    let truth = Truth::by(seed);
    truth.put(setup);
    truth
}
