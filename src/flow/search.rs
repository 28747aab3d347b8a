//! Trials of one proposal: which share of the move is taken.

use super::guard::Guard;
use super::refusal::farthest;
use super::rules::{Ceiling, Rules};
use super::step_size::sufficient_decrease;
use super::{Cause, Cost, Flow, Functional, Move, Refusal, Search};
use crate::interrupt;
use crate::mesh::HalfedgeMesh;
use glam::DVec3;

/// So often a move is shortened along its own direction before it is solved for anew.
const MAX_SHORTENINGS: usize = 6;
/// A shortened move is between these shares of the last.
const SHORTENED: (f64, f64) = (0.1, 0.5);
/// The weak Wolfe conditions' second: the slope must have flattened to this share.
const FLATTENED: f64 = 0.9;
/// Bisections for a step that meets them, and once one descends.
const MAX_BISECTIONS: usize = 30;
const MAX_BISECTIONS_DESCENDING: usize = 10;

/// A trial that is taken.
pub(super) struct Taken {
    pub(super) y: Vec<DVec3>,
    pub(super) value: f64,
    pub(super) share: f64,
}

/// Trials from one state.
pub(super) struct Trials<'a> {
    pub(super) mesh: &'a HalfedgeMesh,
    pub(super) x: &'a [DVec3],
    pub(super) rules: Rules,
    pub(super) guard: Guard,
    /// The functional at `x`.
    pub(super) before: Functional,
    /// Trials refused, and why the last was.
    pub(super) rejected: usize,
    pub(super) refusal: Option<Refusal>,
    /// Whether any was refused for what it would make of the mesh, or for a theorem's bound.
    pub(super) is_guarded: bool,
    /// Whether any was refused for the bound.
    pub(super) met_bound: bool,
}

impl Trials<'_> {
    /// The share of a move that is taken, or why the first trial was refused.
    pub(super) fn run(
        &mut self,
        flow: &mut dyn Flow,
        step: &Move,
        cost: &mut Cost,
    ) -> Result<Taken, Refusal> {
        match step.search {
            Search::Unseen => self.unseen(flow, step),
            Search::Solve => self.shorten(flow, step, 0),
            Search::Shorten => self.shorten(flow, step, MAX_SHORTENINGS),
            Search::Wolfe => self.bisect(flow, step, cost),
        }
    }

    fn unseen(&mut self, flow: &mut dyn Flow, step: &Move) -> Result<Taken, Refusal> {
        let mut y = self.moved(step, 1.0);
        let value = flow.measure(self.x, &mut y)?;
        let share = 1.0;
        if value.is_finite() {
            Ok(Taken { y, value, share })
        } else {
            Err(self.note(Refusal::of(Cause::NotFinite), &y))
        }
    }

    /// Tries the whole move, and shares of it so many times more.
    fn shorten(
        &mut self,
        flow: &mut dyn Flow,
        step: &Move,
        times: usize,
    ) -> Result<Taken, Refusal> {
        let mut share = 1.0;
        let mut first = None;
        for _ in 0..=times {
            if interrupt::check().is_err() {
                break;
            }
            let (refusal, value) = match self.test(flow, step, share) {
                Ok(taken) => return Ok(taken),
                Err(refused) => refused,
            };
            first.get_or_insert(refusal);
            share *= match (refusal.cause, refusal.ratio) {
                (_, Some(ratio)) => ratio,
                (Cause::Rise, None) => self.shorter(step, share, value),
                _ => SHORTENED.1,
            };
            if share.is_nan() || share <= 0.0 {
                break;
            }
        }
        Err(first.unwrap_or(Refusal::of(Cause::Rise)))
    }

    /// Where the parabola through value and slope at the start and the value at `share` has
    /// its minimum, over `share`.
    fn shorter(&self, step: &Move, share: f64, value: f64) -> f64 {
        let bend = value - self.before.value - share * step.slope;
        let factor = -step.slope * share / (2.0 * bend);
        if factor.is_finite() {
            factor.clamp(SHORTENED.0, SHORTENED.1)
        } else {
            SHORTENED.0
        }
    }

    /// Weak Wolfe conditions by bisection. On the rim of a cone no step flattens the slope;
    /// descent is enough there.
    fn bisect(
        &mut self,
        flow: &mut dyn Flow,
        step: &Move,
        cost: &mut Cost,
    ) -> Result<Taken, Refusal> {
        let (mut low, mut high, mut share) = (0.0, f64::INFINITY, 1.0);
        let mut best: Option<Taken> = None;
        let mut first = None;
        for trial in 0..MAX_BISECTIONS {
            let is_enough = best.is_some() && trial >= MAX_BISECTIONS_DESCENDING;
            if is_enough || interrupt::check().is_err() {
                break;
            }
            cost.iterations += 1;
            match self.test(flow, step, share) {
                Err((refusal, _)) => {
                    first.get_or_insert(refusal);
                    high = share;
                }
                Ok(taken) => {
                    if flow.trial_slope(&step.d) >= FLATTENED * step.slope {
                        return Ok(taken);
                    }
                    low = share;
                    best = Some(taken);
                }
            }
            share = if high.is_finite() {
                0.5 * (low + high)
            } else {
                2.0 * share
            };
        }
        let Some(mut best) = best else {
            return Err(first.unwrap_or(Refusal::of(Cause::Rise)));
        };
        // Not the one that was measured last.
        best.value = flow.measure(self.x, &mut best.y)?;
        Ok(best)
    }

    fn moved(&self, step: &Move, share: f64) -> Vec<DVec3> {
        let pairs = self.x.iter().zip(&step.d);
        pairs.map(|(x, d)| *x + share * *d).collect()
    }

    /// One trial: the refusal comes with the functional's value where it was measured.
    fn test(
        &mut self,
        flow: &mut dyn Flow,
        step: &Move,
        share: f64,
    ) -> Result<Taken, (Refusal, f64)> {
        let mut y = self.moved(step, share);
        let mut value = f64::NAN;
        let result = self.judge(flow, step, share, &mut y, &mut value);
        match result {
            Ok(()) => Ok(Taken { y, value, share }),
            Err(refusal) => Err((self.note(refusal, &y), value)),
        }
    }

    fn judge(
        &mut self,
        flow: &mut dyn Flow,
        step: &Move,
        share: f64,
        y: &mut [DVec3],
        value: &mut f64,
    ) -> Result<(), Refusal> {
        self.guard.check_distance(self.x, y)?;
        *value = flow.measure(self.x, y)?;
        // Whatever is said of half a value: nobody will hear it.
        interrupt::check().map_err(|_| Refusal::of(Cause::NotFinite))?;
        if !value.is_finite() {
            return Err(Refusal::of(Cause::NotFinite));
        }
        let is_invisible = step.slope != 0.0 && -share * step.slope < self.rules.roundoff;
        if is_invisible || !self.descends(step, *value, share * step.slope) {
            return Err(Refusal::of(Cause::Rise));
        }
        let least = self.rules.bound.map(|bound| self.rules.bound_share * bound);
        if least.is_some_and(|least| flow.bounded() < least) {
            self.met_bound = true;
            return Err(Refusal::of(Cause::Bound));
        }
        self.guard.check_mesh(self.mesh, self.x, y)
    }

    fn descends(&self, step: &Move, value: f64, slope: f64) -> bool {
        match step.ceiling.unwrap_or(self.rules.ceiling) {
            Ceiling::Descent => sufficient_decrease(self.before.value, value, slope),
            Ceiling::NoRise(zero) => value <= self.before.value.max(zero),
            Ceiling::Below(most) => value <= most,
            Ceiling::None => true,
        }
    }

    /// The highest value that a step may be left with.
    pub(super) fn limit(&self, step: &Move) -> f64 {
        match step.ceiling.unwrap_or(self.rules.ceiling) {
            Ceiling::Descent => self.before.value,
            Ceiling::NoRise(zero) => self.before.value.max(zero),
            Ceiling::Below(most) => most,
            Ceiling::None => f64::INFINITY,
        }
    }

    /// Takes note of a refusal, with the vertex that moves most where no other is named.
    fn note(&mut self, refusal: Refusal, y: &[DVec3]) -> Refusal {
        let names_vertex = matches!(refusal.cause, Cause::TooFar | Cause::Unfit);
        let refusal = if names_vertex {
            refusal
        } else {
            Refusal {
                vertex: farthest(self.x, y, |_| 1.0).0,
                ..refusal
            }
        };
        self.rejected += 1;
        self.is_guarded |= refusal.is_of_mesh();
        self.refusal = Some(refusal);
        refusal
    }
}
