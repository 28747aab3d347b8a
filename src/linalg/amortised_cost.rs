//! When the factor of an earlier matrix is replaced.

use super::ldlt::Inertia;
use super::symbolic::Symbolic;

/// Operations of a factorisation that take as long as one iteration spends on one
/// entry of a factor.
///
/// From timings in wasm: a factorisation does 6 to 8 operations a nanosecond, an
/// iteration with a factor takes 4 to 5 ns an entry.
pub(super) const FLOPS_PER_ENTRY: f64 = 32.0;

/// What the factor at hand has cost so far: its own making, spread over the solves with it.
///
/// The unit is an iteration with the factor.
pub(super) struct AmortisedCost {
    /// Of a factorisation.
    pub(super) factorisation: f64,
    is_definite: bool,
    /// Iterations of the first solve with the factor.
    pub(super) first_iterations: usize,
    total: f64,
    n_solves: usize,
    /// Of the last solve.
    pub(super) last: f64,
}

impl AmortisedCost {
    pub(super) fn new(symbolic: &Symbolic) -> Self {
        let entries = symbolic.factor_len().max(1) as f64;
        Self {
            factorisation: symbolic.flops() / (FLOPS_PER_ENTRY * entries),
            is_definite: false,
            first_iterations: 0,
            total: 0.0,
            n_solves: 0,
            last: 0.0,
        }
    }

    /// There is no factor.
    pub(super) fn clear(&mut self) {
        self.is_definite = false;
    }

    /// There is a new factor, and a first solve was done with it.
    pub(super) fn restart(&mut self, inertia: Inertia, iterations: usize) {
        self.is_definite = inertia.negative == 0;
        self.first_iterations = iterations;
        (self.total, self.n_solves) = (self.factorisation, 0);
        self.add(iterations);
    }

    /// Adds a solve of so many iterations.
    pub(super) fn add(&mut self, iterations: usize) {
        self.last = 1.0 + iterations as f64;
        self.total += self.last;
        self.n_solves += 1;
    }

    /// Whether the last solve cost no more than the average, the factorisation included.
    /// Conjugate gradients take no preconditioner that is not positive definite.
    pub(super) fn is_factor_worth_keeping(&self) -> bool {
        self.is_definite && self.last <= self.total / self.n_solves as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::linalg::Pattern;

    #[test]
    fn a_factor_is_kept_while_solves_cost_no_more_than_the_average() {
        let none = Pattern::from_cliques(1, std::iter::empty::<[u32; 1]>());
        let mut cost = AmortisedCost::new(&Symbolic::analyse(&none, None).unwrap());
        assert!(!cost.is_factor_worth_keeping(), "there is none yet");
        cost.factorisation = 6.0;
        cost.restart(
            Inertia {
                positive: 1,
                negative: 0,
            },
            0,
        );
        // Costs 7 + 4 + 4 + 5 for four solves: 5 each.
        for iterations in [3, 3, 4] {
            assert!(cost.is_factor_worth_keeping());
            cost.add(iterations);
        }
        assert!(cost.is_factor_worth_keeping());
        cost.add(5);
        assert!(
            !cost.is_factor_worth_keeping(),
            "6 is above the average of 5.2"
        );
    }
}
