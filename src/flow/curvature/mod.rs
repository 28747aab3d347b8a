//! Flows by mean curvature and its derivatives, after Xu & Zhang: mean-curvature flow,
//! surface diffusion, Willmore flow, and the minimal mean-curvature-variation flow of
//! sixth order, which joins a free patch to its surroundings with continuous curvature.
//!
//! All four move vertices along their normals, r' = r + s φn, with φ from one semi-implicit
//! system (see `system`) and the operators of [`crate::operator::fitted`]. A flow's own file
//! holds its velocity law. Time is scale-free, dt = τ L^k, k the order of the flow and L the
//! size of the free patches. With τ ≥ 0.01 a step is one of a quasi-Newton iteration for the
//! steady state, and there is no upper limit for τ from a smooth start. The share s of a
//! step that is taken is such that no vertex moves by more than half an edge.
//!
//! Vertices are not moved along the surface: smoothing them each step keeps the flow from
//! converging.

mod curvature_variation;
mod curvatures;
mod law;
mod mean_curvature;
mod region;
mod solver;
mod surface_diffusion;
mod system;
mod verdict;
mod willmore;

use super::options::{FlowOptions, Scheme};
use super::stop::Verdict;
use super::{Flow, FlowError, Progress as Callback, Reading, StepReport, boundary, prefill};
use crate::energy::circle::Boundary;
use crate::geometry::measure;
use crate::mesh::HalfedgeMesh;
use crate::operator::FittedOperators;
use curvatures::Curvatures;
use glam::DVec3;
use law::Law;
use region::Region;
use std::rc::Rc;
use system::{Quality, System};
use web_time::Instant;

/// No vertex moves by more than this share of a mean edge.
const CAP: f64 = 0.5;
/// Passes of the smooth pre-fill.
const PREFILL_PASSES: usize = 3;
/// A first update of the sixth-order flow longer than so many edges comes from a start too
/// rough for it …
const ROUGH: f64 = 8.0;
/// … and up to this many steps of surface diffusion go before.
const RUNGS: usize = 40;
/// A run of the sixth-order flow that has not come to rest in so many steps …
const PATIENCE: usize = 60;
/// … or that after this many still wants to move by more than [`LOST`] edges …
const TRIAL: usize = 20;
/// … begins anew, once, with those steps of surface diffusion.
const LOST: f64 = 10.0;
/// Surface diffusion has done its part when no vertex moves by more than this share of an
/// edge.
const RUNG_REST: f64 = 1e-2;

/// The flow on one mesh with one set of options.
pub struct CurvatureFlow {
    mesh: Rc<HalfedgeMesh>,
    options: FlowOptions,
    law: Law,
    region: Region,
    system: System,
    start: Vec<DVec3>,
    pace: Pace,
    /// At the present positions, once they are needed.
    curvatures: Option<Curvatures>,
    flipped: Vec<u32>,
    on_progress: Option<Callback>,
}

/// The small state that a step back restores along with the positions.
#[derive(Clone, Copy, Debug)]
pub struct Pace {
    time: f64,
    step: usize,
    first_step: usize,
    /// Steps of surface diffusion still to be taken first.
    rungs: usize,
    /// Steps taken by the flow's own law since.
    own_steps: usize,
    /// Whether the ladder of surface diffusion was used.
    has_climbed: bool,
    warned: verdict::Warned,
}

/// A step before it is taken.
struct Update {
    phi: Vec<f64>,
    /// |φ|max over the mean edge length.
    size: f64,
    dt: f64,
    quality: Quality,
}

impl CurvatureFlow {
    /// Prepares the flow at positions `x`, which a smooth pre-fill may change.
    ///
    /// # Errors
    /// [`FlowError::NotTriangular`], [`FlowError::NotOriented`], [`FlowError::BadOption`],
    /// [`FlowError::SelectionOutOfRange`], [`FlowError::NothingFree`],
    /// [`FlowError::Linear`].
    pub fn new(
        mesh: Rc<HalfedgeMesh>,
        x: &mut [DVec3],
        options: FlowOptions,
    ) -> Result<Self, FlowError> {
        options.check()?;
        check_mesh(&mesh)?;
        let law = Law::of(options.flow)?;
        let is_free = boundary::free_vertices(
            &mesh,
            options.boundary.unwrap_or(Boundary::Fixed),
            options.free.as_deref(),
            options.fixed.as_deref(),
        )?;
        if options.prefill {
            prefill::smooth(&mesh, &is_free, x, PREFILL_PASSES)?;
        }
        let region = Region::new(&mesh, x, is_free, law.depth());
        let rungs = if law == Law::CurvatureVariation {
            options.rungs.unwrap_or(0)
        } else {
            0
        };
        let pace = Pace {
            time: 0.0,
            step: 0,
            first_step: 0,
            rungs,
            own_steps: 0,
            has_climbed: false,
            warned: verdict::Warned::default(),
        };
        let mut flow = Self {
            system: System::new(law, &region),
            start: x.to_vec(),
            mesh,
            options,
            law,
            region,
            pace,
            curvatures: None,
            flipped: Vec::new(),
            on_progress: None,
        };
        flow.choose_law();
        Ok(flow)
    }

    /// The law of the next step.
    fn present_law(&self) -> Law {
        if self.pace.rungs > 0 {
            Law::SurfaceDiffusion
        } else {
            self.law
        }
    }

    /// Makes the system that of the present law.
    fn choose_law(&mut self) {
        let law = self.present_law();
        if self.system.law() != law {
            self.system = System::new(law, &self.region);
        }
    }

    /// Raw step size of a law: given for the flow itself, or τ L^k.
    fn dt_of(&self, law: Law) -> f64 {
        let given = self.options.dt.filter(|_| law == self.law);
        let tau = self.options.tau.unwrap_or(1.0);
        given.unwrap_or_else(|| tau * self.region.length.powi(law.order()))
    }

    fn tell(&self, stage: &str, share: f64) {
        if let Some(callback) = &self.on_progress {
            callback(stage, share);
        }
    }

    fn take_curvatures(&mut self, x: &[DVec3]) -> Curvatures {
        let known = self.curvatures.take();
        known.unwrap_or_else(|| Curvatures::of(&self.mesh, x, &self.region))
    }

    /// Whether steps of surface diffusion must go before, the flow being about to move by
    /// `size` edges: why, and whether from the start.
    fn must_climb(&self, size: f64) -> Option<(String, bool)> {
        let is_automatic = self.options.scheme == Scheme::Auto && self.options.rungs.is_none();
        let pace = &self.pace;
        if self.law != Law::CurvatureVariation || !is_automatic || pace.has_climbed {
            return None;
        }
        let ladder = format!("up to {RUNGS} steps of surface diffusion go before");
        if pace.step == 0 && size > ROUGH {
            let why = format!(
                "The start is too rough for the sixth-order flow, which would move it by {size:.0} \
                 edge lengths: {ladder}."
            );
            return Some((why, false));
        }
        let steps = pace.own_steps;
        let is_lost = steps >= PATIENCE || steps >= TRIAL && size > LOST;
        is_lost.then(|| {
            let why = format!("No rest in sight after {steps} steps: back to the start, {ladder}.");
            (why, true)
        })
    }

    fn update(&mut self, at: &Curvatures, x: &[DVec3]) -> Result<Update, FlowError> {
        self.choose_law();
        let dt = self.dt_of(self.present_law());
        let callback = self.on_progress.clone();
        let tell = move |stage: &str, share: f64| {
            if let Some(callback) = &callback {
                callback(stage, share);
            }
        };
        let (phi, quality) = self.system.solve(at, &self.region, x, dt, &tell)?;
        let largest = phi.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
        if !phi.iter().all(|v| v.is_finite()) {
            return Err(FlowError::NonFiniteEnergy {
                step: self.pace.step + 1,
            });
        }
        Ok(Update {
            size: largest / self.region.h,
            phi,
            dt,
            quality,
        })
    }

    /// Root mean square of V over the free vertices, times L^(k−1): without a unit.
    fn speed(&mut self, at: &Curvatures) -> f64 {
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
}

impl Flow for CurvatureFlow {
    fn set_progress(&mut self, callback: Option<Callback>) {
        self.on_progress = callback;
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

    fn reading(&mut self, x: &[DVec3]) -> Reading {
        let at = Curvatures::of(&self.mesh, x, &self.region);
        let area = measure::area(&self.mesh, x);
        let energy = self.law.energy(&at, area);
        let gradient_norm = self.speed(&at);
        self.curvatures = Some(at);
        Reading {
            energy,
            energy_normalised: self.law.normalised(energy, self.region.length),
            gradient_norm,
            area,
            volume: measure::volume(&self.mesh, x),
            reduced_volume: None,
        }
    }

    fn gradient(&self, x: &[DVec3]) -> Vec<DVec3> {
        let at = Curvatures::of(&self.mesh, x, &self.region);
        let mut system = System::new(self.law, &self.region);
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

    fn pace(&self) -> super::Pace {
        super::Pace::Curvature(self.pace)
    }

    fn set_pace(&mut self, pace: super::Pace) {
        if let super::Pace::Curvature(pace) = pace {
            self.pace = pace;
        }
        self.curvatures = None;
        self.flipped.clear();
    }

    fn set_clock(&mut self, step: usize, time: f64) {
        self.pace.step = step;
        self.pace.time = time;
        self.curvatures = None;
        self.flipped.clear();
    }

    fn extend_budget(&mut self) {
        self.pace.first_step = self.pace.step;
    }

    fn dt(&self) -> f64 {
        self.dt_of(self.present_law())
    }

    fn tau(&self) -> f64 {
        let law = self.present_law();
        self.dt_of(law) / self.region.length.powi(law.order())
    }

    fn flipped_faces(&self) -> &[u32] {
        &self.flipped
    }

    fn step(&mut self, x: &mut Vec<DVec3>) -> Result<(Option<StepReport>, Verdict), FlowError> {
        let pace = self.pace;
        self.try_step(x).inspect_err(|_| self.pace = pace)
    }
}

impl CurvatureFlow {
    fn try_step(&mut self, x: &mut Vec<DVec3>) -> Result<(Option<StepReport>, Verdict), FlowError> {
        let start = Instant::now();
        if let Some(verdict) = self.done_before_step() {
            return Ok((None, verdict));
        }
        self.tell("assemble", 0.0);
        let mut at = self.take_curvatures(x);
        let fitted = start.elapsed().as_secs_f64();
        let mut update = self.update(&at, x)?;
        let mut y = x.clone();
        let mut warnings = Vec::new();
        if let Some((why, restart)) = self.must_climb(update.size) {
            warnings.push(why);
            self.pace.rungs = RUNGS;
            self.pace.own_steps = 0;
            self.pace.has_climbed = true;
            if restart {
                y.clone_from(&self.start);
                at = Curvatures::of(&self.mesh, &y, &self.region);
            }
            update = self.update(&at, &y)?;
        }
        update.quality.assemble += fitted;
        let share = match self.options.scheme {
            Scheme::Auto => (CAP / update.size).min(1.0),
            Scheme::Paper => 1.0,
        };
        let area = measure::area(&self.mesh, &y);
        let before = self.present_law().energy(&at, area);
        for (&v, phi) in self.region.free.iter().zip(&update.phi) {
            let row = at.row(v as usize)?;
            y[v as usize] += share * phi * at.operators.normal(row);
        }
        let watch = Instant::now();
        let next = Curvatures::of(&self.mesh, &y, &self.region);
        // Also refuses what is not a number.
        if let Some(&vertex) = self
            .region
            .free
            .iter()
            .find(|&&v| next.operators.row(v as usize).is_none())
        {
            return Err(FlowError::Unfit { vertex });
        }
        update.quality.assemble += watch.elapsed().as_secs_f64();
        let (mut report, verdict) = self.conclude(x, y, &update, share, next, before);
        warnings.append(&mut report.warnings);
        report.warnings = warnings;
        report.milliseconds = start.elapsed().as_secs_f64() * 1e3;
        Ok((Some(report), verdict))
    }
}

/// The preconditions on a mesh.
fn check_mesh(mesh: &HalfedgeMesh) -> Result<(), FlowError> {
    let wrong = mesh
        .faces()
        .map(|f| (f, mesh.face_vertices(f).count()))
        .find(|(_, corners)| *corners != 3);
    if let Some((face, corners)) = wrong {
        return Err(FlowError::NotTriangular {
            face: face.0,
            corners,
        });
    }
    if !mesh.is_oriented() {
        return Err(FlowError::NotOriented);
    }
    Ok(())
}
