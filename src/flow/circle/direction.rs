//! Steps along one direction: semi-implicit, the paper's, forward Euler.

use super::problem::Cost;
use super::{Accepted, CircleFlow, Outcome};
use crate::energy::circle::angle::Smoothing;
use crate::flow::FlowError;
use crate::flow::Refusal;
use crate::flow::options::Scheme;
use crate::flow::refusal::{Cause, farthest};
use crate::flow::step_size::sufficient_decrease;
use crate::geometry::{measure, quality};
use crate::linalg::Refactor;
use glam::DVec3;

/// Roundoff of the energy per vertex: no decrease smaller than it can be seen.
const ROUNDOFF_PER_VERTEX: f64 = 1e-15;
/// A trial that folds over more than this share of the faces is refused …
const FOLDED_SHARE: f64 = 1e-5;
/// … but so many times a step at most: a sliver may fold at any step size.
const MAX_FOLD_REFUSALS: usize = 3;
/// Halvings of the paper's step before the matrix is given up as indefinite.
const MAX_HALVINGS: usize = 60;

impl CircleFlow {
    /// Mass at the current positions; areas are taken anew each step, as the flow is
    /// that of the moving surface.
    pub(super) fn mass(&self, x: &[DVec3]) -> Vec<f64> {
        let areas = self
            .is_area_mass()
            .then(|| measure::vertex_areas(&self.mesh, x));
        self.problem.mass(areas)
    }

    /// Whether a decrease of this size would drown in roundoff.
    pub(super) fn is_negligible(&self, decrease: f64) -> bool {
        decrease.abs() < ROUNDOFF_PER_VERTEX * self.problem.energy.n_counted() as f64
    }

    /// (M/dt + K₊) Δx = −∇E with the projected K₊; dt falls until the step descends.
    pub(super) fn semi_implicit(
        &mut self,
        x: &[DVec3],
        smoothing: Smoothing,
        cost: &mut Cost,
    ) -> Result<Outcome, FlowError> {
        self.problem.assemble(&self.evaluation, true, cost);
        let mass = self.mass(x);
        self.descend(x, smoothing, |flow, dt| {
            flow.tell("factor", 0.2);
            let gradient = &flow.evaluation.gradient;
            flow.problem
                .solve(gradient, &mass, dt, Refactor::WhenCheaper, cost)
        })
    }

    /// Δx = −dt M⁻¹ ∇E. The paper's scheme takes it as it comes.
    pub(super) fn forward_euler(
        &mut self,
        x: &[DVec3],
        smoothing: Smoothing,
    ) -> Result<Outcome, FlowError> {
        let mass = self.mass(x);
        let direction = |flow: &Self, dt: f64| {
            flow.problem
                .rows(&flow.evaluation.gradient)
                .zip(&mass)
                .map(|(g, m)| -dt / m * g)
                .collect()
        };
        if self.options.scheme == Scheme::Paper {
            let dt = self.pace.step_size.dt;
            let d: Vec<DVec3> = direction(self, dt);
            return self.accept_unseen(x, &d, dt, 0);
        }
        self.descend(x, smoothing, |flow, dt| Ok(direction(flow, dt)))
    }

    /// Tries directions for falling dt until one yields a sufficient decrease.
    fn descend(
        &mut self,
        x: &[DVec3],
        smoothing: Smoothing,
        mut direction: impl FnMut(&mut Self, f64) -> Result<Vec<DVec3>, FlowError>,
    ) -> Result<Outcome, FlowError> {
        let (mut rejected, mut fold_refusals) = (0, 0);
        loop {
            let dt = self.pace.step_size.dt;
            let d = direction(self, dt)?;
            let slope = self.problem.dot(&self.evaluation.gradient, &d);
            if self.is_negligible(slope) {
                return Ok(Outcome::Stuck);
            }
            let trial = self.problem.moved(x, &d, 1.0);
            self.problem
                .energy
                .evaluate(&trial, smoothing, &mut self.trial);
            let objective = self.trial.value;
            let descends = sufficient_decrease(self.evaluation.value, objective, slope);
            let folds = descends && fold_refusals < MAX_FOLD_REFUSALS && self.folds(x, &trial);
            fold_refusals += usize::from(folds);
            if descends && !folds {
                self.pace.step_size.accepted(rejected);
                return Ok(Outcome::Accepted(Accepted {
                    x: trial,
                    objective,
                    dt,
                    rejected,
                    is_evaluated: true,
                }));
            }
            rejected += 1;
            self.refusal = Some(Refusal {
                cause: if folds { Cause::Fold } else { Cause::Rise },
                vertex: farthest(x, &trial, |_| 1.0).0,
                face: None,
            });
            if !self.pace.step_size.refused() {
                return Ok(Outcome::Stuck);
            }
        }
    }

    /// Whether a trial folds over more faces than a step may.
    fn folds(&self, x: &[DVec3], trial: &[DVec3]) -> bool {
        let folded = quality::newly_folded(&self.mesh, x, trial).len();
        folded as f64 > FOLDED_SHARE * self.mesh.n_faces() as f64
    }

    /// The paper's step: (I/dt + K) Δx = −∇E, exact energy, plain K, constant dt, no test
    /// for descent. Where the matrix is not positive definite the step would be
    /// amplified; dt is halved for this step only.
    pub(super) fn paper_step(
        &mut self,
        x: &[DVec3],
        cost: &mut Cost,
    ) -> Result<Outcome, FlowError> {
        self.problem.assemble(&self.evaluation, false, cost);
        let mass = self.mass(x);
        let mut dt = self.pace.step_size.dt;
        for halvings in 0..MAX_HALVINGS {
            self.tell("factor", 0.2);
            let gradient = &self.evaluation.gradient;
            let d = self
                .problem
                .solve(gradient, &mass, dt, Refactor::Always, cost)?;
            if cost.negative_pivots == 0 {
                if halvings > 0 {
                    cost.warnings.push(format!(
                        "I/dt + K was not positive definite: this step was halved {halvings} times."
                    ));
                }
                return self.accept_unseen(x, &d, dt, halvings);
            }
            dt /= 2.0;
        }
        Ok(Outcome::Stuck)
    }

    /// Accepts a step without asking whether the energy falls, as long as it is finite.
    fn accept_unseen(
        &self,
        x: &[DVec3],
        d: &[DVec3],
        dt: f64,
        rejected: usize,
    ) -> Result<Outcome, FlowError> {
        let x = self.problem.moved(x, d, 1.0);
        let objective = self.problem.energy.value(&x, Smoothing::EXACT);
        if !objective.is_finite() {
            return Err(FlowError::NonFiniteEnergy {
                step: self.pace.step + 1,
            });
        }
        Ok(Outcome::Accepted(Accepted {
            x,
            objective,
            dt,
            rejected,
            is_evaluated: false,
        }))
    }
}
