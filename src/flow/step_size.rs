//! The only place that decides on the step size.

/// A step size that adapts: it grows after a step accepted at its first trial and shrinks at
/// a refusal. A constant one recovers up to what was asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepSize {
    /// The size the next trial uses.
    pub dt: f64,
    /// Factor after a step accepted at once.
    pub growth: f64,
    /// Whether it is squared from the second such step in a row on.
    pub quickens: bool,
    /// Whether the last step was accepted at once.
    pub was_whole: bool,
    /// Factor after a refusal that names none.
    pub shrink: f64,
    /// Below this the run is stuck.
    pub smallest: f64,
    /// Never above this.
    pub largest: f64,
    /// Whether it was asked for: then slow steps are no sign of anything.
    pub is_given: bool,
}

/// A refusal that knows by how much a move was too long shrinks the step by no more and no
/// less than this.
const RATIO: (f64, f64) = (0.1, 0.7);
/// Once its move was taken shortened, the step size shrinks by no more than this.
const LEAST_SHARE: f64 = 0.25;

impl StepSize {
    /// Starts at `dt` and adapts between `smallest` and `largest`.
    pub fn adaptive(dt: f64, smallest: f64, largest: f64) -> Self {
        Self {
            dt,
            growth: 2.0,
            quickens: false,
            was_whole: false,
            shrink: 0.25,
            smallest,
            largest,
            is_given: false,
        }
    }

    /// Stays at `dt`, going below only for a step that would be refused.
    pub fn constant(dt: f64, smallest: f64) -> Self {
        Self {
            is_given: true,
            ..Self::adaptive(dt, smallest, dt)
        }
    }

    /// With other factors after a step accepted at once, and after a refusal.
    #[must_use]
    pub fn with_factors(self, growth: f64, shrink: f64) -> Self {
        Self {
            growth,
            shrink,
            ..self
        }
    }

    /// Whether its growth quickens: a move that is too long costs little where it is shortened along its
    /// own direction, and one too short a solve.
    #[must_use]
    pub fn quickening(self, quickens: bool) -> Self {
        Self { quickens, ..self }
    }

    /// After `share` of a move was accepted, solved for anew `resolved` times.
    pub fn accepted(&mut self, share: f64, resolved: usize, grows: bool) {
        let is_whole = share >= 1.0 && resolved == 0 && grows;
        let powers = if self.quickens && self.was_whole {
            2
        } else {
            1
        };
        self.was_whole = is_whole;
        if share < 1.0 {
            self.dt *= share.max(LEAST_SHARE);
        } else if is_whole {
            self.dt = (self.dt * self.growth.powi(powers)).min(self.largest);
        }
    }

    /// After all trials of a move were refused, the first by this factor too long; `false`
    /// when there is no smaller step left to try.
    pub fn refused(&mut self, ratio: Option<f64>) -> bool {
        self.dt *= match ratio {
            Some(ratio) if ratio.is_finite() => ratio.clamp(RATIO.0, RATIO.1),
            Some(_) => RATIO.0,
            None => self.shrink,
        };
        self.dt >= self.smallest
    }

    /// On another mesh of the same surface: half of an adaptive size, a given one anew.
    pub fn restart(&mut self) {
        let dt = if self.is_given {
            self.largest
        } else {
            0.5 * self.dt
        };
        self.dt = dt.max(self.smallest);
    }

    /// Whether it is as large as it may become.
    pub fn is_full(&self) -> bool {
        self.dt >= self.largest
    }
}

/// Sufficient decrease: the fraction of the slope that a step must gain (Armijo).
const SUFFICIENT: f64 = 1e-4;

/// Whether `after` is a sufficient decrease from `before` along a step with directional
/// derivative `slope` (negative).
pub fn sufficient_decrease(before: f64, after: f64, slope: f64) -> bool {
    after.is_finite() && after <= before + SUFFICIENT * slope.min(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_grows_only_after_whole_moves_taken_at_once() {
        let mut size = StepSize::adaptive(1.0, 1e-3, 3.0);
        size.accepted(1.0, 0, true);
        assert_eq!(size.dt, 2.0);
        size.accepted(1.0, 0, true);
        assert!(size.dt == 3.0 && size.is_full());
        size.dt = 1.0;
        size.accepted(1.0, 1, true);
        size.accepted(1.0, 0, false);
        assert_eq!(size.dt, 1.0);
        size.dt = 3.0;
        size.accepted(0.5, 0, true);
        assert_eq!(size.dt, 1.5);
        size.accepted(0.01, 0, true);
        assert_eq!(size.dt, 0.375);
    }

    #[test]
    fn one_that_quickens_grows_faster_from_the_second_whole_move_on() {
        let mut size = StepSize::adaptive(1.0, 1e-3, 1e3).quickening(true);
        let mut after = |share: f64, resolved: usize| {
            size.accepted(share, resolved, true);
            size.dt
        };
        assert_eq!([1.0; 3].map(|share| after(share, 0)), [2.0, 8.0, 32.0]);
        assert_eq!(
            [after(0.5, 0), after(1.0, 0), after(1.0, 0)],
            [16.0, 32.0, 128.0]
        );
        assert_eq!([after(1.0, 1), after(1.0, 0)], [128.0, 256.0]);
    }

    #[test]
    fn refusals_shrink_it_down_to_the_floor() {
        let mut size = StepSize::adaptive(1.0, 0.01, 1.0);
        assert!(size.refused(Some(0.5)) && size.dt == 0.5);
        assert!(size.refused(Some(0.9)) && size.dt == 0.35);
        size.dt = 0.5;
        assert!(size.refused(Some(1e-9)) && size.dt == 0.05);
        assert!(size.refused(None) && size.dt == 0.0125);
        assert!(!size.refused(None));
        let mut size = StepSize::constant(1.0, 1e-9);
        assert!(size.refused(Some(f64::NAN)) && size.dt == 0.1);
        (0..9).for_each(|_| size.accepted(1.0, 0, true));
        assert_eq!(size.dt, 1.0);
    }

    #[test]
    fn a_decrease_must_be_a_ten_thousandth_of_the_slope() {
        assert!(sufficient_decrease(1.0, 1.0 - 1.1e-4, -1.0));
        assert!(!sufficient_decrease(1.0, 1.0 - 0.9e-4, -1.0));
        // A slope that rises, by roundoff or of a step that mends a constraint, allows no rise.
        assert!(sufficient_decrease(1.0, 1.0, 3.0) && !sufficient_decrease(1.0, 1.0 + 1e-9, 3.0));
        assert!(!sufficient_decrease(1.0, f64::NAN, 0.0));
        assert!(!sufficient_decrease(1.0, f64::NEG_INFINITY, 0.0));
    }
}
