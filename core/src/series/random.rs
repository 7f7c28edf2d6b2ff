//! Random numbers by their place: a number is a function of seed, source and index. No number depends on which was
//! asked for before, so that one run alone, or runs on several threads, get the same ones.

use super::normal::quantile;

/// A source of numbers under a seed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Source {
    start: u64,
}

impl Source {
    /// The source of this name.
    pub fn new(seed: u64, name: &str) -> Source {
        // FNV-1a: names that differ in one letter are far apart after mixing
        let hash = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
        let name = name.bytes().fold(0xcbf2_9ce4_8422_2325, hash);
        Source { start: mix(mix(seed.wrapping_add(GAP)) ^ name) }
    }

    /// 64 bits of this index.
    pub fn bits(self, index: u64) -> u64 {
        mix(self.start.wrapping_add(GAP.wrapping_mul(index.wrapping_add(1))))
    }

    /// Evenly spread over `(0, 1)`, both ends excluded.
    pub fn uniform(self, index: u64) -> f64 {
        ((self.bits(index) >> 12) as f64 + 0.5) / (1u64 << 52) as f64
    }

    /// Of the normal distribution with mean 0 and standard deviation 1.
    pub fn normal(self, index: u64) -> f64 {
        quantile(self.uniform(index))
    }
}

/// The odd number next to 2^64 over the golden ratio: its multiples lie evenly (SplitMix64, Steele et al. 2014).
const GAP: u64 = 0x9e37_79b9_7f4a_7c15;

/// The mixing of SplitMix64: each bit in changes half of the bits out.
fn mix(mut bits: u64) -> u64 {
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    bits ^ (bits >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::series::spread::Spread;

    // oracle: peer: the published SplitMix64 (S. Vigna, prng.di.unimi.it) begins so from the state 1234567
    #[test]
    fn mixes_as_published() {
        let numbers = [1, 2, 3].map(|index: u64| mix(1_234_567u64.wrapping_add(GAP.wrapping_mul(index))));
        assert_eq!(numbers, [6_457_827_717_110_365_317, 3_203_168_211_198_807_973, 9_817_491_932_198_370_423]);
    }

    // oracle: definition: mean 0 and variance 1 within 4 standard errors, and sources that know nothing of each other
    #[test]
    fn is_normal_and_independent() {
        let [a, b] = ["probe", "probf"].map(|name| Source::new(7, name));
        let draws = |source: Source| (0..40_000).map(move |index| source.normal(index));
        let spread = Spread::of(draws(a).collect());
        assert!(spread.mean.abs() < 4.0 * spread.mean_error(), "{}", spread.mean);
        assert!((spread.deviation - 1.0).abs() < 4.0 * spread.deviation_error, "{}", spread.deviation);
        let common = draws(a).zip(draws(b)).map(|(a, b)| a * b).sum::<f64>() / 40_000.0;
        assert!(common.abs() < 4.0 / 200.0, "{common}");
        let next = draws(a).zip(draws(a).skip(1)).map(|(a, b)| a * b).sum::<f64>() / 40_000.0;
        assert!(next.abs() < 4.0 / 200.0, "{next}");
        assert_ne!(Source::new(8, "probe").bits(0), a.bits(0));
    }
}
