//! The surface of least W on the way.
//!
//! U_ε falls, W as printed may rise by the angles that a step opens: on an aligned lattice of the
//! Clifford torus, whose W lies below that of the smooth surface, by 0.2 %. A run does not end
//! above a surface it has passed: it goes back there and on by the exact energy.

use super::{CircleFlow, Phase};
use crate::flow::Warning;
use glam::DVec3;
use std::rc::Rc;

/// The end of a run is worse than a surface on the way by more than this share of W.
const WORSE: f64 = 1e-6;

/// W, and where it was that.
pub(super) type Surface = (f64, Rc<Vec<DVec3>>);

/// What a run has passed.
#[derive(Debug, Default)]
pub(super) struct Passed {
    /// Where the step in hand begins.
    last: Option<Surface>,
    /// Where W was least, if it has risen since.
    pub(super) least: Option<Surface>,
}

impl Passed {
    /// A step begins at `x`.
    pub(super) fn begin(&mut self, energy: f64, x: &[DVec3]) {
        self.last = Some((energy, Rc::new(x.to_vec())));
    }

    /// It has led to a surface of this W.
    pub(super) fn note(&mut self, energy: f64) {
        let last = self.last.take();
        if self.least.is_none() {
            self.least = last;
        }
        self.least = self.least.take().filter(|(least, _)| *least < energy);
    }
}

impl CircleFlow {
    /// The phase that goes on from the least W on the way, where the run would end above it. Asked
    /// again before it has begun, it is the same.
    pub(super) fn back_to_least(&mut self) -> Option<Phase> {
        let worst = (1.0 - WORSE) * self.evaluation.exact;
        let (energy, x) = self.passed.least.clone()?;
        if energy >= worst || !self.schedule.goes_exact(energy) {
            return None;
        }
        Some(Phase {
            from: Some(x.to_vec()),
            goes_on: true,
            ..self.began(Some(Warning::BetterBefore))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_least_is_known_from_where_it_rose_to_where_it_is_reached_again() {
        let mut passed = Passed::default();
        let mut take = |from: f64, to: f64| {
            passed.begin(from, &[DVec3::splat(from)]);
            passed.note(to);
            passed.least.as_ref().map(|(energy, x)| (*energy, x[0].x))
        };
        assert_eq!(take(5.0, 4.0), None);
        assert_eq!(take(4.0, 4.5), Some((4.0, 4.0)));
        assert_eq!(take(4.5, 4.2), Some((4.0, 4.0)));
        assert_eq!(take(4.2, 3.9), None);
        assert_eq!(take(3.9, 4.1), Some((3.9, 3.9)));
    }
}
