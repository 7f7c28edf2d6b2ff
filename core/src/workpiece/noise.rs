//! A repeatable pseudo-random sequence (xorshift64* with Box–Muller): same seed, same numbers, on every machine.

/// State of the sequence.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Noise {
    state: u64,
}

impl Noise {
    /// Start of the sequence of this seed.
    pub fn new(seed: u64) -> Noise {
        // splitmix64 spreads neighbouring seeds and never leaves the forbidden state 0
        let mut z = seed.wrapping_add(0x9e37_79b9_7f4a_7c15);
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        Noise { state: (z ^ (z >> 31)) | 1 }
    }

    /// Next number, evenly spread over `(0, 1]`.
    pub fn uniform(&mut self) -> f64 {
        self.state ^= self.state >> 12;
        self.state ^= self.state << 25;
        self.state ^= self.state >> 27;
        let bits = self.state.wrapping_mul(0x2545_f491_4f6c_dd1d) >> 11;
        (bits + 1) as f64 / (1u64 << 53) as f64
    }

    /// Next number of the normal distribution with mean 0 and standard deviation 1.
    pub fn normal(&mut self) -> f64 {
        let spread = (-2.0 * self.uniform().ln()).sqrt();
        spread * (std::f64::consts::TAU * self.uniform()).cos()
    }

    /// Next number of the normal distribution with mean 0 and this standard deviation; with 0 none is drawn.
    pub fn scatter(&mut self, deviation: f64) -> f64 {
        if deviation == 0.0 { 0.0 } else { deviation * self.normal() }
    }
}

#[cfg(test)]
mod tests {
    use super::Noise;

    // oracle: definition (mean 0, variance 1; same seed, same sequence)
    #[test]
    fn is_normal_and_repeats() {
        let mut noise = Noise::new(7);
        let numbers: Vec<f64> = (0..20_000).map(|_| noise.normal()).collect();
        let mean = numbers.iter().sum::<f64>() / numbers.len() as f64;
        let variance = numbers.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / numbers.len() as f64;
        assert!(mean.abs() < 0.03 && (variance - 1.0).abs() < 0.05, "{mean} {variance}");
        let mut again = Noise::new(7);
        assert!(numbers.iter().all(|&x| x == again.normal()));
        assert_ne!(Noise::new(8).normal(), numbers[0]);
    }
}
