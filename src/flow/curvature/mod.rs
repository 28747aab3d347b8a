//! Flows by mean curvature and its derivatives, after Xu & Zhang
//! [XZ06](crate::bibliography#xz06): mean-curvature flow, surface diffusion, Willmore flow, and
//! the minimal mean-curvature-variation flow of sixth order, which joins a free patch to its
//! surroundings with continuous curvature.
//!
//! All four move vertices along their normals, r' = r + s φn, with φ from one semi-implicit
//! system (see `system`) and the operators of [`crate::operator::fitted`]. A flow's own file
//! holds its velocity law. Time is scale-free, dt = τ L^k, k the order of the flow and L the
//! size of the free patches. At τ = 1 a step is one of a quasi-Newton iteration for the steady
//! state; where there is one near by it is the best step, and where there is none, as of a
//! closed surface under the flow by mean curvature, the driver finds smaller ones. The share s
//! of a step that is taken is such that no vertex moves by more than half an edge.
//!
//! Area falls under surface diffusion of a whole surface, and the volume stays what it was. Of a
//! patch with a held rim it need not, and no functional is known that the discrete flow lowers:
//! whole steps, which find the steady state in a few, are taken there without a test for descent.
//!
//! A rest of the fitted flow is not quite the least of the fitted energy, so that a good fill may
//! end a little above an earlier step: by a thousandth of the least so far, and where whole steps
//! contract (the natural monotonicity test of Newton's method, Deuflhard
//! [D04](crate::bibliography#d04)) by a hundredth at most.
//!
//! Vertices are not moved along the surface: smoothing them each step keeps the flow from
//! converging.

mod curvature_variation;
mod curvatures;
mod gauge;
mod kept;
mod ladder;
mod law;
mod mean_curvature;
mod memory;
mod region;
mod solver;
mod step;
mod surface_diffusion;
mod system;
mod velocity;
mod warning;
mod willmore;

pub use memory::{Learnt, Memory};

use super::bounds::lower_bounds;
use super::options::{FlowOptions, Scheme};
use super::rules::{Ceiling, Folds, NEGLIGIBLE};
use super::step_size::StepSize;
use super::warning::WarningsGiven;
use super::{
    Advice, Cause, Clock, Cost, Flow, FlowError, Functional, Monitored, Move, Occasion, Phase,
    Proposal, Reading, Refusal, Rules, StepReport, boundary, prefill,
};
use crate::geometry::measure;
use crate::mesh::HalfedgeMesh;
use crate::operator::FittedOperators;
use curvatures::Curvatures;
use glam::DVec3;
use kept::KeptVolume;
use ladder::Ladder;
use law::Law;
use region::{Region, check_mesh};
use std::rc::Rc;
use system::CurvatureSystem;
use web_time::Instant;

/// No vertex moves by more than this share of a mean edge; a step size that leads so far is as
/// large as is good, and one that leads less far than this may grow.
const CAP: f64 = 0.5;
const SHORT: f64 = 0.35;
/// On a closed surface no face turns by more than the angle of this cosine in a step: curvatures
/// fitted to needles say nothing, and lead to flat bits of what was there.
const TURN: f64 = 0.5;
/// Passes of the smooth pre-fill.
const PREFILL_PASSES: usize = 3;
/// Refusals in a row, each to a quarter, that end a run.
const MAX_REFUSALS: i32 = 24;
/// Fitted curvatures are not quite those that the reading falls along, and the last steps to a rest
/// may raise it. None is taken that does: the surface counts as at rest where whole steps, each at
/// most this share of the one before …
const CONTRACTING: f64 = 0.7;
/// … and at most so many, would come to one …
const MAX_SETTLING: usize = 30;
/// … with a reading that all the way is no further from this one than by this share of it.
const SETTLED: f64 = 1e-2;
/// A reading that has come to this share of the first cannot be told from zero by fits.
const NOTHING: f64 = 1e-9;
/// On the ladder the flow's own energy may rise, but not above so many times that at the start:
/// a tube may pinch off there.
const LADDER: f64 = 10.0;
/// A reading that has come to this share of the first is zero; and so is one that without a unit
/// is roundoff, as of a round sphere from the start.
const ZERO: f64 = 1e-13;
const ROUNDOFF: f64 = 1e-20;
/// A surface is at rest if a whole step moves no vertex by more than this share of an edge …
const AT_REST: f64 = 1e-6;
/// … or by more than this, where its reading does not change any more either.
const NEARLY_AT_REST: f64 = 1e-3;
/// Share of the smooth minimum of ∫H² that no healthy mesh goes below.
const LEAST: f64 = 0.95;

/// The flow on one mesh with one set of options.
pub struct CurvatureFlow {
    mesh: Rc<HalfedgeMesh>,
    options: FlowOptions,
    law: Law,
    region: Region,
    system: CurvatureSystem,
    start: Vec<DVec3>,
    /// The monitored functional at the start.
    first_energy: f64,
    /// ∫H² of the best smooth surface of the topology, which a mesh that has less does not resolve:
    /// of the flows that go by curvatures alone.
    smooth_minimum: Option<f64>,
    ladder: Ladder,
    /// What surface diffusion keeps, of a closed surface all of which moves.
    kept_volume: Option<KeptVolume>,
    /// Whether the last proposal from here was a whole step.
    has_tried_whole: bool,
    /// At the present positions, once they are needed; and at a trial.
    curvatures: Option<Curvatures>,
    trial: Option<Curvatures>,
    trial_energy: f64,
    /// ∫H² of the trial, where it is bounded.
    trial_willmore: f64,
    /// Largest |φ| of the last proposal, in mean edges.
    size: f64,
    /// A proposal that was made to see how long it is, with its step size.
    known: Option<(f64, Rc<Move>)>,
    /// Where the flow came to before it went back to the start, and where the ladder ended, if
    /// that is known.
    reached: Option<Rc<Vec<DVec3>>>,
    top: Option<Rc<Vec<DVec3>>>,
    is_iterative: bool,
}

impl CurvatureFlow {
    /// Prepares the flow at positions `x`, which a smooth pre-fill may change.
    ///
    /// # Errors
    /// [`FlowError::NotTriangular`], [`FlowError::NotOriented`], [`FlowError::Option`],
    /// [`FlowError::SelectionOutOfRange`], [`FlowError::NothingFree`],
    /// [`FlowError::Linear`].
    pub fn new(
        mesh: &Rc<HalfedgeMesh>,
        x: &mut [DVec3],
        options: &FlowOptions,
    ) -> Result<Self, FlowError> {
        check_mesh(mesh)?;
        let law = Law::of(options.flow)?;
        let is_free = boundary::free_vertices(
            mesh,
            options.boundary(),
            options.free.as_deref(),
            options.fixed.as_deref(),
        )?;
        if options.prefill {
            prefill::smooth(mesh, &is_free, x, PREFILL_PASSES)?;
        }
        let region = Region::new(mesh, x, is_free, law.depth());
        let at = Curvatures::of(mesh, x, &region);
        let is_whole = region.free.len() == x.len();
        let is_bounded = matches!(law, Law::Willmore | Law::CurvatureVariation) && is_whole;
        let is_kept = law == Law::SurfaceDiffusion && is_whole && options.scheme != Scheme::Paper;
        let mut flow = Self {
            kept_volume: KeptVolume::of(mesh, x).filter(|_| is_kept),
            system: CurvatureSystem::new(law, &region),
            start: x.to_vec(),
            has_tried_whole: false,
            first_energy: law.energy(&at, || measure::area(mesh, x)),
            smooth_minimum: lower_bounds(mesh)
                .filter(|_| is_bounded)
                .map(|bounds| bounds.willmore),
            ladder: Ladder::new(law, options.rungs),
            mesh: Rc::clone(mesh),
            options: options.clone(),
            law,
            region,
            curvatures: Some(at),
            trial: None,
            trial_energy: f64::NAN,
            trial_willmore: f64::NAN,
            size: 0.0,
            known: None,
            reached: None,
            top: None,
            is_iterative: false,
        };
        flow.choose_law();
        Ok(flow)
    }

    /// The law of the next step.
    fn present_law(&self) -> Law {
        if self.ladder.is_climbing() {
            Law::SurfaceDiffusion
        } else {
            self.law
        }
    }

    /// The law whose functional is watched: on the ladder that of the flow itself, which rungs
    /// may raise, but not without bounds.
    fn watched(&self) -> Law {
        if self.ladder.is_climbing() {
            self.law
        } else {
            self.present_law()
        }
    }

    /// Below this the functional cannot be told from zero. No area comes to zero but by vanishing,
    /// which ends the run.
    fn nothing(&self) -> f64 {
        match self.watched() {
            Law::MeanCurvature | Law::SurfaceDiffusion => 0.0,
            Law::Willmore | Law::CurvatureVariation => NOTHING * self.first_energy,
        }
    }

    /// Whether the present law lowers its functional.
    fn descends(&self) -> bool {
        self.present_law() != Law::SurfaceDiffusion || self.is_whole()
    }

    /// Whether every vertex moves.
    fn is_whole(&self) -> bool {
        self.region.free.len() == self.start.len()
    }

    /// Makes the system that of the present law.
    fn choose_law(&mut self) {
        let law = self.present_law();
        if self.system.law() != law {
            self.system = CurvatureSystem::new(law, &self.region);
        }
    }

    /// Raw size of a whole step: L^k.
    fn full_dt(&self) -> f64 {
        self.region.length.powi(self.present_law().order())
    }

    fn is_paper(&self) -> bool {
        self.options.scheme == Scheme::Paper
    }

    /// Whether the surface can shrink to a point.
    fn can_vanish(&self) -> bool {
        self.present_law() == Law::MeanCurvature && self.is_whole()
    }

    /// A vertex to be moved that has no fit, as where positions are not numbers.
    fn unfit(&self, at: &Curvatures) -> Option<u32> {
        let mut free = self.region.free.iter().copied();
        free.find(|&v| at.operators.row(v as usize).is_none())
    }

    fn take_curvatures(&mut self, x: &[DVec3]) -> Curvatures {
        let known = self.curvatures.take();
        known.unwrap_or_else(|| Curvatures::of(&self.mesh, x, &self.region))
    }
}

impl Flow for CurvatureFlow {
    fn monitored(&self) -> Monitored {
        match self.watched() {
            Law::MeanCurvature | Law::SurfaceDiffusion => Monitored::Area,
            Law::Willmore => Monitored::Willmore,
            Law::CurvatureVariation => Monitored::CurvatureVariation,
        }
    }

    fn rules(&self) -> Rules {
        let can_vanish = self.can_vanish();
        if self.is_paper() {
            return Rules {
                can_vanish,
                ..Rules::unseen()
            };
        }
        if self.ladder.is_climbing() {
            let is_whole = self.is_whole();
            return Rules {
                ceiling: Ceiling::Below(LADDER * self.first_energy),
                turn: is_whole.then_some(TURN),
                folds: if is_whole { Folds::None } else { Folds::Any },
                bound: self.smooth_minimum,
                bound_share: LEAST,
                ..Rules::unseen()
            };
        }
        Rules {
            ceiling: if self.descends() {
                Ceiling::NoRise(self.nothing())
            } else {
                Ceiling::None
            },
            reach: can_vanish.then_some(CAP),
            turn: self.is_whole().then_some(TURN),
            folds: Folds::None,
            least_angle: None,
            bound: self.smooth_minimum,
            bound_share: LEAST,
            roundoff: 0.0,
            zero: match self.watched() {
                Law::MeanCurvature | Law::SurfaceDiffusion => 0.0,
                Law::Willmore | Law::CurvatureVariation => {
                    let roundoff = ROUNDOFF / self.law.normalised(1.0, self.region.length);
                    roundoff.max(ZERO * self.first_energy)
                }
            },
            can_vanish,
            grows: false,
            ends_at_rest: true,
            idle: self.descends().then_some(NEGLIGIBLE),
            long_dt: f64::INFINITY,
        }
    }

    fn step_size(&self) -> StepSize {
        let full = self.full_dt();
        // A raw step size is one of the flow's own unit of time.
        let given = self.options.dt.filter(|_| !self.ladder.is_climbing());
        match given.or(self.options.tau.map(|tau| tau * full)) {
            Some(dt) => StepSize::constant(dt, 0.25f64.powi(MAX_REFUSALS) * dt),
            None => StepSize::adaptive(full, 0.25f64.powi(MAX_REFUSALS) * full, full),
        }
    }

    fn time_unit(&self) -> f64 {
        self.full_dt()
    }

    fn evaluate(&mut self, x: &[DVec3], cost: &mut Cost) -> Result<Functional, FlowError> {
        let watch = Instant::now();
        let at = self.take_curvatures(x);
        let unfit = self.unfit(&at);
        let energy = self.watched().energy(&at, || measure::area(&self.mesh, x));
        let rate = self.watched().rate(&at, &self.region.is_free);
        self.curvatures = Some(at);
        cost.assemble += watch.elapsed().as_secs_f64();
        let plain = Functional::plain(energy);
        let found = Functional { rate, ..plain };
        unfit.map_or(Ok(found), |vertex| Err(FlowError::Unfit { vertex }))
    }

    fn propose(&mut self, x: &[DVec3], dt: f64, cost: &mut Cost) -> Result<Proposal, FlowError> {
        // A whole step was refused: it may be that none is needed.
        let may_rest = self.has_tried_whole && !self.is_paper() && !self.ladder.is_climbing();
        if may_rest && self.rest_size(x, cost)? <= NEARLY_AT_REST {
            return Ok(Proposal::Nothing);
        }
        self.has_tried_whole = dt >= self.full_dt();
        let step = match self.known.take() {
            Some((known, step)) if known == dt => Rc::unwrap_or_clone(step),
            _ => self.solve(x, dt, cost)?,
        };
        Ok(Proposal::Move(Box::new(step)))
    }

    fn measure(&mut self, _x: &[DVec3], y: &mut [DVec3]) -> Result<f64, Refusal> {
        if let Some(kept) = &self.kept_volume {
            kept.restore(&self.mesh, y)?;
        }
        let next = Curvatures::of(&self.mesh, y, &self.region);
        let unfit = self.unfit(&next);
        let energy = self
            .watched()
            .energy(&next, || measure::area(&self.mesh, y));
        if let Some(vertex) = unfit {
            return Err(Refusal::at(Cause::Unfit, vertex));
        }
        if self.smooth_minimum.is_some() {
            self.trial_willmore = next.integrate(willmore::density);
        }
        self.trial = Some(next);
        self.trial_energy = energy;
        Ok(energy)
    }

    fn bounded(&self) -> f64 {
        self.trial_willmore
    }

    fn accept(&mut self, _step: &Move, _share: f64) {
        self.forget();
        self.curvatures = self.trial.take();
    }

    fn next_phase(
        &mut self,
        x: &[DVec3],
        occasion: &Occasion,
        cost: &mut Cost,
    ) -> Result<Option<Phase>, FlowError> {
        if *occasion == Occasion::Before {
            self.has_tried_whole = false;
        }
        self.climb_or_descend(x, occasion, cost)
    }

    /// By how much a whole step would move the surface, over what it may.
    fn stationarity(&mut self, x: &[DVec3], cost: &mut Cost) -> Result<f64, FlowError> {
        match self.rest_size(x, cost) {
            Ok(size) => Ok(size / NEARLY_AT_REST),
            // Where a whole step cannot be solved for, the surface is not at rest.
            Err(_) => Ok(f64::INFINITY),
        }
    }

    fn describe(&mut self, x: &[DVec3], report: &mut StepReport) {
        let at = self.take_curvatures(x);
        report.energy = self.law.energy(&at, || report.area);
        report.energy_normalised = self.law.normalised(report.energy, self.region.length);
        report.gradient_norm = self.speed(&at);
        report.prepares = self.ladder.is_climbing();
        self.curvatures = Some(at);
    }

    fn warn(&self, _x: &[DVec3], report: &mut StepReport, given: &mut WarningsGiven) {
        self.warn_of(report, given);
    }

    fn clock(&self) -> Clock {
        match self.law {
            Law::MeanCurvature => Clock::MeanCurvature,
            _ => Clock::Own,
        }
    }

    fn advice(&self) -> Advice {
        match self.law {
            Law::MeanCurvature => Advice::PWillmoreZero,
            _ if self.is_whole() => Advice::RegularOrPWillmore,
            _ => Advice::FirstGuess,
        }
    }

    fn reading(&mut self, x: &[DVec3]) -> Reading {
        self.forget();
        let at = Curvatures::of(&self.mesh, x, &self.region);
        let area = measure::area(&self.mesh, x);
        let energy = self.law.energy(&at, || area);
        let gradient_norm = self.speed(&at);
        let objective = self.watched().energy(&at, || area);
        let monitored = self.monitored();
        self.curvatures = Some(at);
        Reading {
            energy,
            monitored,
            objective,
            energy_normalised: self.law.normalised(energy, self.region.length),
            gradient_norm,
            area,
            volume: measure::volume(&self.mesh, x),
            reduced_volume: None,
        }
    }

    fn gradient(&self, x: &[DVec3]) -> Vec<DVec3> {
        let at = Curvatures::of(&self.mesh, x, &self.region);
        let mut system = CurvatureSystem::new(self.law, &self.region);
        let mut field = vec![DVec3::ZERO; x.len()];
        if let Ok(velocities) = system.velocities(&at, &self.region) {
            for (&v, velocity) in self.region.free.iter().zip(velocities) {
                if let Some(row) = at.operators.row(v as usize) {
                    field[v as usize] = -velocity * at.operators.normal(row);
                }
            }
        }
        field
    }

    /// By quadratic fits, also beside and on the boundary.
    fn mean_curvature(&self, x: &[DVec3]) -> Option<Vec<f64>> {
        let operators = FittedOperators::everywhere(&self.mesh, x);
        let value = |v: usize| operators.row(v).map(|row| operators.mean_curvature(row, x));
        Some((0..x.len()).map(|v| value(v).unwrap_or_default()).collect())
    }

    fn mean_edge_length(&self) -> f64 {
        self.region.h
    }

    fn n_free(&self) -> usize {
        self.region.free.len()
    }

    fn is_free(&self, v: usize) -> bool {
        self.region.is_free[v]
    }

    fn memory(&self) -> super::Memory {
        super::Memory::Curvature(self.own_memory())
    }

    fn recall(&mut self, memory: super::Memory) {
        if let super::Memory::Curvature(memory) = memory {
            self.recall_own(memory);
        }
    }

    fn learnt(&self) -> super::Learnt {
        super::Learnt::Curvature(self.own_learnt())
    }

    fn relearn(&mut self, learnt: super::Learnt) {
        if let super::Learnt::Curvature(learnt) = learnt {
            self.relearn_own(learnt);
        }
    }

    fn release(&mut self) {
        self.system.release();
    }
}
