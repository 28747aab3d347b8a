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
pub(super) type Surface = Rc<(f64, Vec<DVec3>)>;

/// What a run has passed.
#[derive(Debug, Default)]
pub(super) struct Passed {
    /// Where the step in hand begins.
    last: (f64, Vec<DVec3>),
    /// Where W was least, if it has risen since.
    pub(super) least: Option<Surface>,
}

impl Passed {
    /// A step begins at `x`.
    pub(super) fn begin(&mut self, energy: f64, x: &[DVec3]) {
        self.last.0 = energy;
        self.last.1.clear();
        self.last.1.extend_from_slice(x);
    }

    /// It has led to a surface of this W.
    pub(super) fn note(&mut self, energy: f64) {
        let least = self.least.as_ref().map_or(self.last.0, |least| least.0);
        if energy <= least {
            self.least = None;
        } else if self.least.is_none() {
            self.least = Some(Rc::new(std::mem::take(&mut self.last)));
        }
    }
}

impl CircleFlow {
    /// The phase that goes on from the least W on the way, where the run would end above it. Asked
    /// again before it has begun, it is the same.
    pub(super) fn back_to_least(&mut self) -> Option<Phase> {
        let worst = (1.0 - WORSE) * self.evaluation.exact;
        let least = self.passed.least.clone()?;
        if least.0 >= worst || !self.schedule.goes_exact(least.0) {
            return None;
        }
        Some(Phase {
            from: Some(least.1.clone()),
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
            passed.least.as_ref().map(|least| (least.0, least.1[0].x))
        };
        assert_eq!(take(5.0, 4.0), None);
        assert_eq!(take(4.0, 4.5), Some((4.0, 4.0)));
        assert_eq!(take(4.5, 4.2), Some((4.0, 4.0)));
        assert_eq!(take(4.2, 3.9), None);
        assert_eq!(take(3.9, 4.1), Some((3.9, 3.9)));
    }
}
