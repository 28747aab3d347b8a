//! The only place that decides on the step size.

/// Sufficient decrease: the fraction of the slope that a step must gain (Armijo).
const SUFFICIENT: f64 = 1e-4;

/// An adaptive step size: doubled after a step accepted at its first trial, quartered
/// at a rejection. A constant one has `growth` 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StepSize {
    /// The size the next trial uses.
    pub dt: f64,
    /// Factor after a step accepted at once.
    pub growth: f64,
    /// Below this the run is stuck.
    pub smallest: f64,
    /// Never above this; rejections of a constant step recover up to it.
    pub largest: f64,
}

impl StepSize {
    /// Starts at `dt` and adapts within 1e-12 h² and 1e6 h².
    ///
    /// Beyond the upper end the mass term is lost in the roundoff of the stiffness, whose
    /// largest eigenvalue is about 60/h².
    pub fn adaptive(dt: f64, h: f64) -> Self {
        Self {
            dt,
            growth: 2.0,
            smallest: 1e-12 * h * h,
            largest: 1e6 * h * h,
        }
    }

    /// Stays at `dt`, going below only for a step that would be refused.
    pub fn constant(dt: f64) -> Self {
        Self {
            dt,
            growth: 2.0,
            smallest: 1e-9 * dt,
            largest: dt,
        }
    }

    /// After a step accepted with `rejections` before it.
    pub fn accepted(&mut self, rejections: usize) {
        if rejections == 0 {
            self.dt = (self.dt * self.growth).min(self.largest);
        }
    }

    /// After a refused trial; `false` when there is no smaller step left to try.
    pub fn refused(&mut self) -> bool {
        self.dt /= 4.0;
        self.dt >= self.smallest
    }
}

/// Whether `after` is a sufficient decrease from `before` along a step with directional
/// derivative `slope` (negative).
pub fn sufficient_decrease(before: f64, after: f64, slope: f64) -> bool {
    after.is_finite() && after <= before + SUFFICIENT * slope.min(0.0) && after <= before
}
