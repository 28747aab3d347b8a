//! The semi-implicit step, how long a whole one is, and what is better than its outcome.

use super::curvatures::Curvatures;
use super::gauge;
use super::system::Setting;
use super::{
    AT_REST, CAP, CONTRACTING, CurvatureFlow, MAX_SETTLING, NEARLY_AT_REST, SETTLED, SHORT,
};
use crate::flow::{Cost, FlowError, Move, Search};
use crate::geometry::measure;
use glam::DVec3;
use std::rc::Rc;

impl CurvatureFlow {
    /// The move of step size dt.
    pub(super) fn solve(
        &mut self,
        x: &[DVec3],
        dt: f64,
        cost: &mut Cost,
    ) -> Result<Move, FlowError> {
        self.choose_law();
        let at = self.take_curvatures(x);
        let setting = Setting {
            mesh: &self.mesh,
            region: &self.region,
            start: &self.start,
        };
        let solved = self.system.solve(&setting, x, &at, dt);
        let (mut phi, quality) = match solved {
            Ok(solved) => solved,
            Err(error) => {
                self.curvatures = Some(at);
                return Err(error);
            }
        };
        quality.tell(cost);
        self.is_iterative |= quality.is_iterative;
        let largest_of = |phi: &[f64]| phi.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
        let is_free_to_creep = self.smooth_minimum.is_some() && !self.is_paper();
        if is_free_to_creep && largest_of(&phi) < SHORT * self.region.h {
            gauge::remove(&mut phi, &at, &self.region, x);
        }
        self.size = largest_of(&phi) / self.region.h;
        let share = if self.is_paper() || self.can_vanish() {
            1.0
        } else {
            (CAP / self.size).min(1.0)
        };
        let mut d = vec![DVec3::ZERO; x.len()];
        for (&v, phi) in self.region.free.iter().zip(&phi) {
            d[v as usize] = match at.row(v as usize) {
                Ok(row) => share * phi * at.operators.normal(row),
                Err(error) => {
                    self.curvatures = Some(at);
                    return Err(error);
                }
            };
        }
        self.curvatures = Some(at);
        let search = if self.is_paper() {
            Search::Unseen
        } else {
            Search::Solve
        };
        let mut step = Move::new(d, 0.0, share * dt, search);
        step.update = Some(self.size);
        step.grows = self.size < SHORT;
        let is_whole = dt >= self.full_dt();
        step.rests = is_whole && self.size < AT_REST && !self.ladder.is_climbing();
        Ok(step)
    }

    /// Largest |φ| of a whole step of the present law, in mean edges; the step is kept, as it
    /// may be the next that is asked for.
    pub(super) fn whole_size(&mut self, x: &[DVec3], cost: &mut Cost) -> Result<f64, FlowError> {
        let dt = self.full_dt();
        let step = self.solve(x, dt, cost)?;
        self.known = Some((dt, Rc::new(step)));
        Ok(self.size)
    }

    /// The same of a surface that is not at rest: or else how far from its rest the whole steps
    /// are of which none was taken, where they come to one.
    pub(super) fn rest_size(&mut self, x: &[DVec3], cost: &mut Cost) -> Result<f64, FlowError> {
        let size = self.whole_size(x, cost)?;
        if size <= NEARLY_AT_REST || !self.descends() {
            return Ok(size);
        }
        if self.energy_of(x) <= self.nothing() {
            return Ok(0.0);
        }
        if size > SHORT {
            return Ok(size);
        }
        let known = self.known.take();
        let rest = self.settle(x, size, cost);
        self.forget();
        (self.known, self.size) = (known, size);
        Ok(rest?.unwrap_or(size))
    }

    /// The size of the last of whole steps from `x` that come to a rest; of none otherwise.
    fn settle(
        &mut self,
        x: &[DVec3],
        mut last: f64,
        cost: &mut Cost,
    ) -> Result<Option<f64>, FlowError> {
        let here = self.energy_of(x);
        let mut y = x.to_vec();
        for k in 0..MAX_SETTLING {
            self.forget();
            let step = self.solve(&y, self.full_dt(), cost)?;
            if k > 0 && self.size > CONTRACTING * last {
                return Ok(None);
            }
            last = self.size;
            for (y, d) in y.iter_mut().zip(&step.d) {
                *y += *d;
            }
            if (self.energy_of(&y) - here).abs() > SETTLED * here {
                return Ok(None);
            }
            if last <= NEARLY_AT_REST {
                return Ok(Some(last));
            }
        }
        Ok(None)
    }

    /// Root mean square of V over the free vertices, times L^(k−1): without a unit.
    pub(super) fn speed(&mut self, at: &Curvatures) -> f64 {
        self.choose_law();
        let power = self.present_law().order() - 1;
        match self.system.velocities(at, &self.region) {
            Ok(v) => {
                let mean = v.iter().map(|v| v * v).sum::<f64>() / v.len().max(1) as f64;
                mean.sqrt() * self.region.length.powi(power)
            }
            Err(_) => f64::NAN,
        }
    }

    /// The law's energy at positions that are no trial.
    pub(super) fn energy_of(&self, x: &[DVec3]) -> f64 {
        let at = Curvatures::of(&self.mesh, x, &self.region);
        self.law.energy(&at, || measure::area(&self.mesh, x))
    }

    /// The best of the start, of where the flow came to without the ladder and of the ladder's
    /// end, where that is better than `x`: by more than a rest may lie above it, if `x` is one.
    pub(super) fn better_than(&self, x: &[DVec3], is_at_rest: bool) -> Option<Vec<DVec3>> {
        let known = [
            Some(&self.start),
            self.reached.as_deref(),
            self.top.as_deref(),
        ];
        let tolerance = if is_at_rest { SETTLED } else { 0.0 };
        let energies = known.into_iter().flatten().map(|y| (self.energy_of(y), y));
        let best = energies.min_by(|a, b| a.0.total_cmp(&b.0))?;
        let least = (1.0 - tolerance) * self.energy_of(x);
        (best.0 < least).then(|| best.1.clone())
    }
}
