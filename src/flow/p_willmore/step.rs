//! The recommended step: semi-implicit, with multipliers, projected onto the constraints.

use super::{PWillmoreFlow, gauge};
use crate::energy::p_willmore::{Evaluation, integrated_power};
use crate::flow::constraint::{dot, multipliers, project};
use crate::flow::rules::Ceiling;
use crate::flow::{Cause, Cost, Flow, FlowError, Move, Occasion, Phase, Proposal, Refusal, Search};
use crate::interrupt;
use crate::remesh::adaptive::Soundness;
use glam::DVec3;
use web_time::Instant;

/// A led volume is followed with steps of at most this τ/L^(p+2), so that a surface stays on
/// its branch: an oblate vesicle, given time, would turn over into a prolate one.
const LEADING_TAU: f64 = 1e-3;
/// The relative violation of a constraint beyond which a step is meant to mend it.
const VIOLATED: f64 = 1e-10;

/// (∇J · n) n at every vertex, n along the gradient of the volume: the part of the gradient
/// that moves the surface and not only its vertices.
pub(super) fn normal_part(evaluation: &Evaluation) -> Vec<DVec3> {
    let pairs = evaluation.gradient.iter().zip(&evaluation.volume_gradient);
    pairs
        .map(|(g, n)| {
            let n = n.normalize_or_zero();
            g.dot(n) * n
        })
        .collect()
}

impl PWillmoreFlow {
    /// The move that solves (M/τ + L diag(c) L) d = −P∇W^p, with multipliers of what is kept;
    /// or, where nothing is, without a part along the conformal maps.
    pub(super) fn semi_implicit(
        &mut self,
        x: &[DVec3],
        dt: f64,
        cost: &mut Cost,
    ) -> Result<Proposal, FlowError> {
        let watch = Instant::now();
        if !self.is_assembled {
            let c = self.functional.stiffness(&self.evaluation);
            self.system.assemble(self.functional.elements(), x, &c);
            self.is_assembled = true;
        }
        interrupt::check()?;
        let is_leading = self.kept.is_leading();
        let longest = LEADING_TAU * self.scale.powf(self.options.p + 2.0);
        let is_asked = self.options.dt.is_some();
        let dt = if is_leading && !is_asked {
            dt.min(longest)
        } else {
            dt
        };
        // A step refused for its length leads the volume less far, too.
        self.next_volume = self.kept.next_volume((dt / longest).min(1.0));
        let n = x.len();
        let e = &self.evaluation;
        let fixed_size =
            self.options.p == 2.0 && !self.kept.any() && self.functional.helfrich().is_zero();
        let gauges = if fixed_size {
            gauge::fields(x, e)
        } else {
            Vec::new()
        };
        let force: Vec<DVec3> = normal_part(e).iter().map(|g| -*g).collect();
        let mut rhs = force.clone();
        for gradient in self.kept.gradients(e) {
            rhs.extend_from_slice(gradient);
        }
        rhs.extend_from_slice(&gauges);
        cost.assemble += watch.elapsed().as_secs_f64();
        let mut solution = vec![DVec3::ZERO; rhs.len()];
        let info = self.system.solve(&e.mass, dt, &rhs, &mut solution)?;
        cost.add(&info);
        interrupt::check()?;
        if self.is_normal {
            let normals = self.evaluation.volume_gradient.iter().cycle();
            for (d, n) in solution.iter_mut().zip(normals) {
                let n = n.normalize_or_zero();
                *d = d.dot(n) * n;
            }
        }
        let directions = solution.split_off(n);
        let mut d = solution;
        if fixed_size {
            gauge::remove(&mut d, &directions, &gauges);
            self.multipliers.clear();
            self.directions.clear();
        } else {
            let constraints = self.kept.constraints(self.next_volume, e);
            self.multipliers = multipliers(&constraints, &d, &directions);
            for (lambda, u) in self.multipliers.iter().zip(directions.chunks_exact(n)) {
                d.iter_mut().zip(u).for_each(|(d, u)| *d += *lambda * *u);
            }
            self.directions = directions;
        }
        let constraints = self.kept.constraints(self.next_volume, e);
        let is_kept = constraints.iter().all(|c| c.violation() < VIOLATED);
        let search = if is_kept {
            Search::Shorten
        } else {
            Search::Solve
        };
        let slope = -self.shown(dot(&force, &d));
        let mut step = Move::new(d, slope.min(0.0), dt, search);
        step.ceiling = is_leading.then_some(Ceiling::None);
        Ok(Proposal::Move(Box::new(step)))
    }

    /// Begins to move along the normals alone where other moves have ceased to descend. Near rest
    /// what a smoothed move slides vertices by can raise the energy by more than it lowers it along
    /// the normals; moves along these alone are shorter, but have the slope that they are thought
    /// to have. Not on a mesh that shows no surface: it would come to a rest that is none.
    pub(super) fn along_normals(
        &mut self,
        x: &[DVec3],
        occasion: &Occasion,
        cost: &mut Cost,
    ) -> Result<Option<Phase>, FlowError> {
        let is_stuck = matches!(occasion, Occasion::Stuck { is_guarded, .. } if !is_guarded);
        let may_be = is_stuck && !self.is_normal && !self.is_paper() && self.options.p == 2.0;
        if !may_be || self.stationarity(x, cost)? <= 1.0 || !self.is_sound(x) {
            return Ok(None);
        }
        self.is_normal = true;
        Ok(Some(Phase {
            raises_step_size: true,
            ..Phase::default()
        }))
    }

    /// Whether the readings can be believed; quadrilaterals are.
    fn is_sound(&self, x: &[DVec3]) -> bool {
        let willmore = || integrated_power(&self.mesh, x, 2.0);
        !self.mesh.is_triangular() || Soundness::of(&self.mesh, x, willmore()).is_sound
    }

    /// Puts a trial onto the constraints; the functional there.
    pub(super) fn constrained(&mut self, y: &mut [DVec3]) -> Result<f64, Refusal> {
        let directions = std::mem::take(&mut self.directions);
        let is_met = self.project(y, &directions);
        self.directions = directions;
        if !is_met {
            return Err(Refusal::of(Cause::Constraints));
        }
        let integrals = self.functional.integrals(y, &mut self.scratch);
        Ok(self.shown(integrals.objective))
    }

    /// Moves `y` along the directions until what is kept is what it should be.
    pub(super) fn project(&mut self, y: &mut [DVec3], directions: &[DVec3]) -> bool {
        if !self.kept.any() || directions.is_empty() {
            return true;
        }
        let (kept, volume) = (self.kept, self.next_volume);
        let (functional, scratch) = (&self.functional, &mut self.scratch);
        project(y, directions, |y, take| {
            functional.measure(y, scratch);
            take(&kept.constraints(volume, scratch));
        })
    }
}
