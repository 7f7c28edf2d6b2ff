//! A sequence of pseudo-random numbers, and the numbers that nobody thinks of.

/// Numbers that break what is calculated with them.
const HOSTILE: [f64; 36] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.01,
    -0.01,
    1e-3,
    -1e-3,
    1e-6,
    1e-9,
    -1e-9,
    1e-12,
    5e-324,
    -5e-324,
    1e-300,
    -1e-300,
    1e6,
    -1e6,
    999_999.0,
    -999_999.0,
    1e9,
    -1e9,
    2_147_483_648.0,
    -2_147_483_649.0,
    9e15,
    9_223_372_036_854_775_808.0,
    -1.9e19,
    1e150,
    -1e155,
    1e300,
    -1e300,
    f64::MAX,
    f64::MIN,
    45.0,
    90.0,
    -180.0,
];

/// Where a sequence of numbers stands (SplitMix64).
pub struct Draw {
    state: u64,
    /// Of a hundred numbers so many are such as nobody thinks of; the others are near what they were.
    pub wild: u64,
}

impl Draw {
    /// The sequence with this seed.
    pub fn new(seed: u64) -> Draw {
        let mut draw = Draw { state: seed, wild: 0 };
        draw.wild = draw.of(&[0, 0, 5, 30, 100]);
        draw
    }

    fn next(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = self.state;
        mixed = (mixed ^ mixed >> 30).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ mixed >> 27).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ mixed >> 31
    }

    /// A number from 0 on, below `count`.
    pub fn below(&mut self, count: usize) -> usize {
        (self.next() % count.max(1) as u64) as usize
    }

    /// True so many times of a hundred.
    pub fn chance(&mut self, percent: u64) -> bool {
        self.next() % 100 < percent
    }

    /// One of these.
    pub fn of<T: Copy>(&mut self, list: &[T]) -> T {
        list[self.below(list.len())]
    }

    /// Evenly between two numbers.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.next() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Instead of this number another one.
    pub fn number(&mut self, near: f64) -> f64 {
        if self.chance(self.wild) {
            return self.hostile();
        }
        match self.below(8) {
            0 => near * self.between(0.2, 3.0),
            1 => -near,
            2 => self.between(-200.0, 200.0),
            3 => self.sized(-6.0, 6.0),
            4 => near + self.sized(-9.0, 0.0),
            5 => near.round(),
            6 => near + self.between(-3.0, 3.0),
            _ => near,
        }
    }

    /// The same, mostly one that a setup file may have.
    pub fn within(&mut self, near: f64) -> f64 {
        let number = self.number(near);
        match number.abs() > 1e6 && self.chance(95) {
            true => 1e6_f64.copysign(number),
            false => number,
        }
    }

    /// The same, mostly one that a size may have.
    pub fn size(&mut self, near: f64) -> f64 {
        let number = self.within(near);
        match self.chance(97) {
            true => number.abs().max(f64::MIN_POSITIVE),
            false => number,
        }
    }

    /// Any sign, and between two powers of ten.
    pub fn sized(&mut self, low: f64, high: f64) -> f64 {
        let size = 10_f64.powf(self.between(low, high));
        if self.chance(50) { size } else { -size }
    }

    fn hostile(&mut self) -> f64 {
        match self.below(3) {
            0 => self.sized(-320.0, 308.0),
            _ => self.of(&HOSTILE),
        }
    }
}
