//! When a factor is replaced and when what failed is tried again.

use super::ldlt::Inertia;
use super::symbolic::Symbolic;

/// Operations of a factorisation that take as long as one iteration spends on one
/// entry of a factor.
///
/// From timings in wasm: a factorisation does 6 to 8 operations a nanosecond, an
/// iteration with a factor takes 4 to 5 ns an entry.
pub(super) const FLOPS_PER_ENTRY: f64 = 32.0;

/// Most solves that go by after a failure before the same economy is tried again.
const LONGEST_WAIT: u32 = 15;

/// What the factor at hand has cost so far, in iterations with it.
pub(super) struct Ledger {
    /// Cost of a factorisation.
    pub(super) price: f64,
    is_definite: bool,
    pub(super) fresh_iterations: usize,
    spent: f64,
    n_solves: usize,
    pub(super) last: f64,
}

impl Ledger {
    pub(super) fn new(symbolic: &Symbolic) -> Self {
        let price = symbolic.flops() / (FLOPS_PER_ENTRY * symbolic.factor_len().max(1) as f64);
        Self {
            price,
            is_definite: false,
            fresh_iterations: 0,
            spent: 0.0,
            n_solves: 0,
            last: 0.0,
        }
    }

    /// There is no factor.
    pub(super) fn forget(&mut self) {
        self.is_definite = false;
    }

    /// There is a new factor, and a first solve was done with it.
    pub(super) fn open(&mut self, inertia: Inertia, iterations: usize) {
        self.is_definite = inertia.negative == 0;
        self.fresh_iterations = iterations;
        (self.spent, self.n_solves) = (self.price, 0);
        self.book(iterations);
    }

    pub(super) fn book(&mut self, iterations: usize) {
        self.last = 1.0 + iterations as f64;
        self.spent += self.last;
        self.n_solves += 1;
    }

    /// Whether the last solve cost no more than the average, the factorisation included.
    /// Conjugate gradients take no preconditioner that is not positive definite.
    pub(super) fn is_worth_keeping(&self) -> bool {
        self.is_definite && self.last <= self.spent / self.n_solves as f64
    }
}

/// When to try again what has failed: after 1, 3, 7, … solves.
#[derive(Default)]
pub(super) struct Patience {
    wait: u32,
    last_wait: u32,
}

impl Patience {
    pub(super) fn is_due(&mut self) -> bool {
        let due = self.wait == 0;
        self.wait = self.wait.saturating_sub(1);
        due
    }

    /// Takes note of an attempt, and hands on whether it succeeded.
    pub(super) fn learn(&mut self, succeeded: bool) -> bool {
        self.last_wait = if succeeded {
            0
        } else {
            (2 * self.last_wait + 1).min(LONGEST_WAIT)
        };
        self.wait = self.last_wait;
        succeeded
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::linalg::Pattern;

    #[test]
    fn a_factor_is_kept_while_solves_cost_no_more_than_the_average() {
        let none = Pattern::from_cliques(1, std::iter::empty::<[u32; 1]>());
        let mut ledger = Ledger::new(&Symbolic::analyse(&none, None).unwrap());
        assert!(!ledger.is_worth_keeping(), "there is none yet");
        ledger.price = 6.0;
        ledger.open(
            Inertia {
                positive: 1,
                negative: 0,
            },
            0,
        );
        // Costs 7 + 4 + 4 + 5 for four solves: 5 each.
        for iterations in [3, 3, 4] {
            assert!(ledger.is_worth_keeping());
            ledger.book(iterations);
        }
        assert!(ledger.is_worth_keeping());
        ledger.book(5);
        assert!(!ledger.is_worth_keeping(), "6 is above the average of 5.2");
    }

    #[test]
    fn what_failed_is_tried_again_after_ever_longer_waits() {
        let mut patience = Patience::default();
        let mut attempts = Vec::new();
        for solve in 0..60 {
            if patience.is_due() {
                patience.learn(false);
                attempts.push(solve);
            }
        }
        assert_eq!(attempts, [0, 2, 6, 14, 30, 46]);
        patience.learn(true);
        assert!(patience.is_due() && patience.is_due());
    }
}
