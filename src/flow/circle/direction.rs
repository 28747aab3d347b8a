//! Moves along one direction: semi-implicit, the paper's, forward Euler.

use super::CircleFlow;
use crate::flow::options::{Goal, Scheme};
use crate::flow::{Cause, Cost, FlowError, Move, Proposal, Refusal, Search, Warning};
use crate::geometry::measure;
use crate::interrupt;
use crate::linalg::Method;
use glam::DVec3;

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

    /// A move along the rows' directions. A set amount of smoothing is taken in whole steps.
    pub(super) fn along(&self, rows: &[DVec3], n: usize, dt: f64) -> Proposal {
        let d = self.problem.field(rows, n);
        let slope = self.problem.dot(&self.evaluation.gradient, &d);
        let search = match (self.options.scheme, self.options.goal) {
            (Scheme::Paper, _) => Search::Unseen,
            (_, Goal::Smooth) => Search::Solve,
            (_, Goal::Relax) => Search::Shorten,
        };
        Proposal::Move(Box::new(Move::new(d, slope, dt, search)))
    }

    /// K at the current positions, projected star by star where that is asked for.
    pub(super) fn assemble(&mut self, projects: bool, cost: &mut Cost) {
        if !self.is_assembled {
            self.problem.assemble(&self.evaluation, projects, cost);
            self.is_assembled = true;
        }
        interrupt::pulse();
    }

    /// (M/dt + K₊) Δx = −∇E with the projected K₊.
    pub(super) fn semi_implicit(
        &mut self,
        x: &[DVec3],
        dt: f64,
        cost: &mut Cost,
    ) -> Result<Proposal, FlowError> {
        self.assemble(true, cost);
        let mass = self.mass(x);
        let gradient = &self.evaluation.gradient;
        let d = self
            .problem
            .solve(gradient, &mass, dt, Method::Multigrid, cost)?;
        Ok(self.along(&d, x.len(), dt))
    }

    /// Δx = −dt M⁻¹ ∇E.
    pub(super) fn forward_euler(&self, x: &[DVec3], dt: f64) -> Proposal {
        let mass = self.mass(x);
        let gradient = self.problem.rows(&self.evaluation.gradient);
        let d: Vec<DVec3> = gradient.zip(&mass).map(|(g, m)| -dt / m * g).collect();
        self.along(&d, x.len(), dt)
    }

    /// The paper's step: (I/dt + K) Δx = −∇E, exact energy, plain K, constant dt. Where the
    /// matrix is not positive definite the step would be amplified; dt is halved for this
    /// step only.
    pub(super) fn printed(
        &mut self,
        x: &[DVec3],
        mut dt: f64,
        cost: &mut Cost,
    ) -> Result<Proposal, FlowError> {
        self.assemble(false, cost);
        let mass = self.mass(x);
        for halvings in 0..MAX_HALVINGS {
            interrupt::tell("factor", 0.2);
            let gradient = &self.evaluation.gradient;
            let d = self
                .problem
                .solve(gradient, &mass, dt, Method::Direct, cost)?;
            if cost.negative_pivots == 0 {
                if halvings > 0 {
                    let times = halvings;
                    cost.warnings.push(Warning::HalvedStep { times });
                }
                return Ok(self.along(&d, x.len(), dt));
            }
            dt /= 2.0;
        }
        Ok(Proposal::Refused(Refusal::of(Cause::NotFinite)))
    }
}
