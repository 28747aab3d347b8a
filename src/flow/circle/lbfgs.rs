//! L-BFGS with the semi-implicit matrix as its initial Hessian: not a flow, but the
//! quickest way to where it ends. One step is one iteration.

use super::CircleFlow;
use crate::energy::circle::angle::Smoothing;
use crate::flow::{Cost, FlowError, Move, Proposal, Search};
use crate::linalg::Ldlt;
use glam::DVec3;
use std::collections::VecDeque;
use std::rc::Rc;
use std::sync::Arc;
use web_time::Instant;

/// Pairs remembered.
const LENGTH: usize = 20;
/// The preconditioner is taken anew after so many iterations.
const REFRESH: usize = 10;
/// τ of the mass term in the preconditioner: enough to fix the kernel of K₊.
const TAU: f64 = 100.0;
/// A step that flattens the slope by less ends on the rim of a cone: nothing is learnt of
/// the curvature there.
const FLATTENED: f64 = 0.9;

/// What is known of the Hessian, from one iteration to the next.
#[derive(Default)]
pub(super) struct QuasiNewton {
    pub(super) model: Model,
    /// The factor of a matrix: of that of the model, unless a step was given up meanwhile.
    pub(super) preconditioner: Option<(Ldlt, Rc<Vec<f64>>)>,
}

/// All of it but the factor: a copy costs little.
#[derive(Clone, Default)]
pub(super) struct Model {
    pairs: VecDeque<Rc<Pair>>,
    /// Of the preconditioner.
    matrix: Option<Rc<Vec<f64>>>,
    age: usize,
    smoothing: Option<Smoothing>,
    /// Whether the last move has not been accepted yet.
    is_tried: bool,
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

impl QuasiNewton {
    /// −H ∇E by the two-loop recursion.
    fn direction(&mut self, gradient: Vec<DVec3>) -> Vec<DVec3> {
        let pairs = &self.model.pairs;
        let mut d = gradient;
        let mut alphas = Vec::with_capacity(pairs.len());
        for pair in pairs.iter().rev() {
            let alpha = pair.rho * dot(&pair.s, &d);
            add_scaled(&mut d, -alpha, &pair.y);
            alphas.push(alpha);
        }
        if let Some((preconditioner, _)) = &mut self.preconditioner {
            preconditioner.solve_in_place(&mut d);
        }
        for (pair, alpha) in pairs.iter().zip(alphas.into_iter().rev()) {
            let beta = pair.rho * dot(&pair.y, &d);
            add_scaled(&mut d, alpha - beta, &pair.s);
        }
        d.iter_mut().for_each(|d| *d = -*d);
        d
    }
}

impl CircleFlow {
    /// The next quasi-Newton move. Asked again before one is accepted, it is from a fresh
    /// model, as a stale one may point nowhere; asked once more there is none.
    pub(super) fn quasi_newton_move(
        &mut self,
        x: &[DVec3],
        cost: &mut Cost,
    ) -> Result<Proposal, FlowError> {
        let smoothing = self.schedule.smoothing();
        let model = &self.quasi_newton.model;
        if model.is_tried && model.age == 0 {
            self.quasi_newton = QuasiNewton::default();
            return Ok(Proposal::Nothing);
        }
        let is_stale = model.age >= REFRESH || model.smoothing != Some(smoothing);
        if model.is_tried || is_stale || model.matrix.is_none() {
            self.refresh(smoothing, cost);
        }
        self.factor_model(cost)?;
        self.quasi_newton.model.is_tried = true;
        let watch = Instant::now();
        let gradient: Vec<DVec3> = self.problem.rows(&self.evaluation.gradient).collect();
        let d = self.quasi_newton.direction(gradient);
        cost.solve += watch.elapsed().as_secs_f64();
        let d = self.problem.field(&d, x.len());
        let slope = self.problem.dot(&self.evaluation.gradient, &d);
        if slope >= 0.0 {
            return Ok(Proposal::Nothing);
        }
        Ok(Proposal::Move(Box::new(Move::new(
            d,
            slope,
            0.0,
            Search::Wolfe,
        ))))
    }

    /// Makes M/dt + K₊ at the current positions the model's matrix. Pairs are of the Hessian and not
    /// of the matrix: they are forgotten where the energy is another, or has led nowhere.
    fn refresh(&mut self, smoothing: Smoothing, cost: &mut Cost) {
        self.assemble(true, cost);
        let shift = 1.0 / (TAU * self.problem.h * self.problem.h);
        let mut values = self.problem.stiffness.clone();
        for &slot in self.problem.matrix.pattern().diagonal_slots() {
            values[slot as usize] += shift;
        }
        let model = &mut self.quasi_newton.model;
        if model.is_tried || model.smoothing != Some(smoothing) {
            model.pairs.clear();
        }
        model.matrix = Some(Rc::new(values));
        model.smoothing = Some(smoothing);
        model.age = 0;
        model.is_tried = false;
    }

    /// Factors the model's matrix, unless that was done.
    fn factor_model(&mut self, cost: &mut Cost) -> Result<(), FlowError> {
        let Some(matrix) = &self.quasi_newton.model.matrix else {
            return Ok(());
        };
        let watch = Instant::now();
        let mut factor = match self.quasi_newton.preconditioner.take() {
            Some(known) if Rc::ptr_eq(&known.1, matrix) => {
                self.quasi_newton.preconditioner = Some(known);
                return Ok(());
            }
            Some((factor, _)) => factor,
            None => Ldlt::new(Arc::clone(self.problem.solver.symbolic()?))?,
        };
        factor.factor(matrix)?;
        self.quasi_newton.preconditioner = Some((factor, Rc::clone(matrix)));
        cost.factor += watch.elapsed().as_secs_f64();
        Ok(())
    }

    /// Learns from the move that is taken; called while `trial` is not yet the state.
    pub(super) fn remember(&mut self, step: &Move, share: f64) {
        if step.search != Search::Wolfe {
            return;
        }
        let slope = self.problem.dot(&self.trial.gradient, &step.d);
        let model = &mut self.quasi_newton.model;
        model.is_tried = false;
        model.age += 1;
        if slope < FLATTENED * step.slope {
            model.age = REFRESH;
            return;
        }
        let s: Vec<DVec3> = self.problem.rows(&step.d).map(|d| share * d).collect();
        let mut y: Vec<DVec3> = self.problem.rows(&self.trial.gradient).collect();
        for (y, g) in y
            .iter_mut()
            .zip(self.problem.rows(&self.evaluation.gradient))
        {
            *y -= g;
        }
        let sy = dot(&s, &y);
        if sy > 0.0 {
            if model.pairs.len() == LENGTH {
                model.pairs.pop_front();
            }
            let rho = 1.0 / sy;
            model.pairs.push_back(Rc::new(Pair { s, y, rho }));
        }
    }
}
