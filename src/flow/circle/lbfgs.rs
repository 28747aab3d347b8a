//! L-BFGS with the semi-implicit matrix as its initial Hessian: not a flow, but the
//! quickest way to where it ends. One step is one iteration.

use super::problem::Cost;
use super::{Accepted, CircleFlow, Outcome};
use crate::energy::circle::Evaluation;
use crate::energy::circle::angle::Smoothing;
use crate::flow::FlowError;
use crate::linalg::Ldlt;
use glam::DVec3;
use std::collections::VecDeque;
use std::sync::Arc;
use web_time::Instant;

/// Pairs remembered.
const LENGTH: usize = 20;
/// The preconditioner is taken anew after so many iterations.
const REFRESH: usize = 10;
/// τ of the mass term in the preconditioner: enough to fix the kernel of K₊.
const TAU: f64 = 100.0;
/// Weak Wolfe conditions: sufficient decrease …
const ARMIJO: f64 = 1e-4;
/// … and sufficient flattening of the slope.
const CURVATURE: f64 = 0.9;
/// Trials of the bisection for a step that meets them.
const MAX_TRIALS: usize = 30;

/// What is remembered between iterations.
#[derive(Default)]
pub(super) struct Memory {
    pairs: VecDeque<Pair>,
    preconditioner: Option<Ldlt>,
    age: usize,
    smoothing: Option<Smoothing>,
}

/// A step and the change of the gradient along it.
struct Pair {
    s: Vec<DVec3>,
    y: Vec<DVec3>,
    /// 1/⟨s, y⟩.
    rho: f64,
}

fn dot(a: &[DVec3], b: &[DVec3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.dot(*b)).sum()
}

fn add_scaled(a: &mut [DVec3], s: f64, b: &[DVec3]) {
    a.iter_mut().zip(b).for_each(|(a, b)| *a += s * *b);
}

impl Memory {
    /// −H ∇E by the two-loop recursion.
    fn direction(&mut self, gradient: Vec<DVec3>) -> Vec<DVec3> {
        let mut d = gradient;
        let mut alphas = Vec::with_capacity(self.pairs.len());
        for pair in self.pairs.iter().rev() {
            let alpha = pair.rho * dot(&pair.s, &d);
            add_scaled(&mut d, -alpha, &pair.y);
            alphas.push(alpha);
        }
        if let Some(preconditioner) = &mut self.preconditioner {
            preconditioner.solve_in_place(&mut d);
        }
        for (pair, alpha) in self.pairs.iter().zip(alphas.into_iter().rev()) {
            let beta = pair.rho * dot(&pair.y, &d);
            add_scaled(&mut d, alpha - beta, &pair.s);
        }
        d.iter_mut().for_each(|d| *d = -*d);
        d
    }
}

impl CircleFlow {
    pub(super) fn lbfgs_step(
        &mut self,
        x: &[DVec3],
        smoothing: Smoothing,
        cost: &mut Cost,
    ) -> Result<Outcome, FlowError> {
        let stale = self.lbfgs.age >= REFRESH || self.lbfgs.smoothing != Some(smoothing);
        if stale || self.lbfgs.preconditioner.is_none() {
            self.refresh(smoothing, cost)?;
        }
        let mut outcome = self.lbfgs_iteration(x, smoothing, cost);
        if matches!(outcome, Outcome::Stuck) && self.lbfgs.age > 0 {
            // A stale model may point nowhere: once more from a fresh one.
            self.refresh(smoothing, cost)?;
            outcome = self.lbfgs_iteration(x, smoothing, cost);
        }
        Ok(outcome)
    }

    /// Factors M/dt + K₊ at the current positions and forgets the pairs.
    fn refresh(&mut self, smoothing: Smoothing, cost: &mut Cost) -> Result<(), FlowError> {
        self.problem.assemble(&self.evaluation, true, cost);
        let watch = Instant::now();
        let shift = 1.0 / (TAU * self.problem.h * self.problem.h);
        let mut values = self.problem.stiffness.clone();
        for &slot in self.problem.matrix.pattern().diagonal_slots() {
            values[slot as usize] += shift;
        }
        let kept = self.lbfgs.preconditioner.take();
        let mut factor = match kept {
            Some(factor) => factor,
            None => Ldlt::new(Arc::clone(self.problem.solver.symbolic()))?,
        };
        factor.factor(&values)?;
        cost.factor += watch.elapsed().as_secs_f64();
        self.lbfgs = Memory {
            preconditioner: Some(factor),
            smoothing: Some(smoothing),
            ..Memory::default()
        };
        Ok(())
    }

    fn lbfgs_iteration(&mut self, x: &[DVec3], smoothing: Smoothing, cost: &mut Cost) -> Outcome {
        let watch = Instant::now();
        let gradient: Vec<DVec3> = self.problem.rows(&self.evaluation.gradient).collect();
        let d = self.lbfgs.direction(gradient.clone());
        cost.solve += watch.elapsed().as_secs_f64();
        let slope = dot(&gradient, &d);
        if slope >= 0.0 || self.is_negligible(slope) {
            return Outcome::Stuck;
        }
        let before = self.evaluation.value;
        let mut trial = Evaluation::default();
        let (mut low, mut high, mut t) = (0.0, f64::INFINITY, 1.0);
        let mut best: Option<(f64, Vec<DVec3>)> = None;
        for rejected in 0..MAX_TRIALS {
            let y = self.problem.moved(x, &d, t);
            self.problem.energy.evaluate(&y, smoothing, &mut trial);
            cost.iterations += 1;
            let descends = trial.value.is_finite() && trial.value <= before + ARMIJO * t * slope;
            if !descends {
                high = t;
            } else if self.problem.dot(&trial.gradient, &d) < CURVATURE * slope {
                low = t;
                best = Some((trial.value, y));
            } else {
                self.remember(t, &d, &gradient, &trial);
                return self.accepted(y, trial.value, rejected);
            }
            t = if high.is_finite() {
                0.5 * (low + high)
            } else {
                2.0 * t
            };
        }
        // On the rim of a cone no step flattens the slope; descent is enough.
        match best {
            Some((value, y)) => {
                self.lbfgs.age = REFRESH;
                self.accepted(y, value, MAX_TRIALS)
            }
            None => Outcome::Stuck,
        }
    }

    fn accepted(&self, x: Vec<DVec3>, objective: f64, rejected: usize) -> Outcome {
        Outcome::Accepted(Accepted {
            x,
            objective,
            dt: 0.0,
            rejected,
            is_evaluated: false,
        })
    }

    fn remember(&mut self, t: f64, d: &[DVec3], gradient: &[DVec3], trial: &Evaluation) {
        let s: Vec<DVec3> = d.iter().map(|d| t * *d).collect();
        let mut y: Vec<DVec3> = self.problem.rows(&trial.gradient).collect();
        add_scaled(&mut y, -1.0, gradient);
        let sy = dot(&s, &y);
        self.lbfgs.age += 1;
        if sy > 0.0 {
            if self.lbfgs.pairs.len() == LENGTH {
                self.lbfgs.pairs.pop_front();
            }
            self.lbfgs.pairs.push_back(Pair {
                s,
                y,
                rho: 1.0 / sy,
            });
        }
    }
}
