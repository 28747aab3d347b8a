//! Repeatable random numbers.
//!
//! Sample shapes and tests need noise that is the same on every run, not noise
//! that is hard to predict, so sixty-four bits of state are enough and no
//! dependency is needed.

/// The SplitMix64 generator (Steele, Lea & Flood [SLF14](crate::bibliography#slf14)):
/// equidistributed, period 2^64.
///
/// Integers and [`Self::uniform`] are the same on every platform;
/// [`Self::gaussian`] goes through the platform's `ln` and `cos`, which may
/// differ in the last bit between native and wasm builds.
#[derive(Clone, Debug)]
pub struct SplitMix64 {
    state: u64,
}

impl SplitMix64 {
    /// A generator whose whole sequence is given by `seed`.
    pub fn new(seed: u64) -> Self {
        Self { state: seed }
    }

    /// The next 64 random bits.
    pub fn next_u64(&mut self) -> u64 {
        self.state = self.state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.state ^ (self.state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Uniform in `[0, 1)`, a multiple of 2^-53.
    pub fn uniform(&mut self) -> f64 {
        (self.next_u64() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Uniform integer in `[0, n)`, `n > 0`; the bias is below `n`·2^-53.
    pub fn below(&mut self, n: usize) -> usize {
        (self.uniform() * n as f64) as usize
    }

    /// Standard normal: mean 0, variance 1 (Box & Muller [BM58](crate::bibliography#bm58)).
    pub fn gaussian(&mut self) -> f64 {
        // 1 - u lies in (0, 1]: the logarithm is finite.
        let radius = (-2.0 * (1.0 - self.uniform()).ln()).sqrt();
        radius * (std::f64::consts::TAU * self.uniform()).cos()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn matches_the_published_sequence() {
        let mut random = SplitMix64::new(1_234_567);
        let expected = [
            6_457_827_717_110_365_317,
            3_203_168_211_198_807_973,
            9_817_491_932_198_370_423,
            4_593_380_528_125_082_431,
            16_408_922_859_458_223_821,
        ];
        assert_eq!(expected, std::array::from_fn(|_| random.next_u64()));
    }

    #[test]
    fn moments() {
        let n = 200_000;
        let mut random = SplitMix64::new(7);
        let sample: Vec<f64> = (0..n).map(|_| random.gaussian()).collect();
        let moment = |k| sample.iter().map(|x: &f64| x.powi(k)).sum::<f64>() / n as f64;
        // Four standard errors of each moment: sqrt(var(x^k) / n).
        assert!(moment(1).abs() < 0.009, "{}", moment(1));
        assert!((moment(2) - 1.0).abs() < 0.013, "{}", moment(2));
        assert!((moment(4) - 3.0).abs() < 0.09, "{}", moment(4));
        let mean = (0..n).map(|_| random.uniform()).sum::<f64>() / n as f64;
        assert!((mean - 0.5).abs() < 0.0026, "{mean}");
    }
}
