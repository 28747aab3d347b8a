//! The one loop of all flows: trials and acceptance, step size, budget, phases, and the report.

use super::circle::CircleFlow;
use super::curvature::CurvatureFlow;
use super::guard::Guard;
use super::option::Allowed;
use super::options::FlowOptions;
use super::p_willmore::PWillmoreFlow;
use super::rules::Ceiling;
use super::run::{Run, Start};
use super::search::{Taken, Trials};
use super::spec::{self, Family};
use super::termination::{Ending, Gain, Window};
use super::warning::WarningsGiven;
use super::{
    Cause, Cost, Decision, Flow, FlowError, Functional, Move, Occasion, Phase, Progress, Proposal,
    Refusal, Search, Status, StepReport, Warning,
};
use crate::geometry::survey::survey;
use crate::geometry::{measure, quality};
use crate::mesh::{Face, HalfedgeMesh};
use crate::operator::Elements;
use glam::DVec3;
use std::rc::Rc;
use web_time::Instant;

/// Times a flow may begin another phase before one step.
const MAX_PHASES: usize = 12;

/// A flow that is run, on one mesh with one set of options; positions are the caller's.
pub struct Driver {
    pub(super) flow: Box<dyn Flow>,
    pub(super) mesh: Rc<HalfedgeMesh>,
    pub(super) options: FlowOptions,
    pub(super) start: Start,
    pub(super) run: Run,
    pub(super) refusal: Option<Refusal>,
    pub(super) flipped: Vec<u32>,
    pub(super) progress: Option<Progress>,
}

/// A step that was found.
struct Found {
    step: Move,
    taken: Taken,
    limit: f64,
    rejected: usize,
    is_guarded: bool,
    met_bound: bool,
}

/// What a step came to: its report, none where no step was taken, and what to do next.
pub type Stepped = (Option<StepReport>, Decision);

impl Driver {
    /// The flow that the options ask for, on a triangle mesh; on `polygons`, the same surface
    /// before it was cut into triangles, where the flow takes its faces. A pre-fill or a
    /// perturbation may change `x`.
    ///
    /// # Errors
    /// See [`FlowError`]; [`FlowError::Option`] of edge flips, which are no flow.
    pub fn start(
        triangles: &Rc<HalfedgeMesh>,
        polygons: &Rc<HalfedgeMesh>,
        x: &mut [DVec3],
        options: FlowOptions,
    ) -> Result<Self, FlowError> {
        options.check()?;
        let options = options.settled();
        let row = spec::of(options.flow);
        let as_it_is = row.meshes.quads && Elements::of(polygons).is_some();
        let mesh = Rc::clone(if as_it_is { polygons } else { triangles });
        let flow: Box<dyn Flow> = match row.family {
            Family::Circle => Box::new(CircleFlow::new(&mesh, x, &options)?),
            Family::PWillmore => Box::new(PWillmoreFlow::new(&mesh, x, &options)?),
            Family::Curvature => Box::new(CurvatureFlow::new(&mesh, x, &options)?),
            Family::Flips => {
                let allowed = Allowed::MovingFlow;
                return Err(FlowError::option("flow", "flips", allowed));
            }
        };
        Ok(Self::of(flow, mesh, x, options))
    }

    /// Runs a flow that was prepared at `x` on that mesh with these options.
    pub fn of(
        flow: Box<dyn Flow>,
        mesh: Rc<HalfedgeMesh>,
        x: &[DVec3],
        options: FlowOptions,
    ) -> Self {
        let start = Start {
            area: measure::area(&mesh, x),
            angle: measure::min_angle_degrees(&mesh, x),
            largest_face: quality::largest_face(&mesh, x).1,
            x: x.to_vec(),
        };
        let run = Run {
            step_size: flow.step_size(),
            time: 0.0,
            step: 0,
            first_step: 0,
            seconds: 0.0,
            least: f64::INFINITY,
            window: Window::default(),
            given: WarningsGiven::default(),
            is_exhausted: false,
        };
        Self {
            flow,
            mesh,
            options,
            start,
            run,
            refusal: None,
            flipped: Vec::new(),
            progress: None,
        }
    }

    /// Takes one step: `x` becomes the next state, or is left as it is with a decision.
    ///
    /// # Errors
    /// Numerical failures; `x` and the run are as before.
    pub fn step(&mut self, x: &mut Vec<DVec3>) -> Result<Stepped, FlowError> {
        let before = self.checkpoint();
        self.try_step(x).inspect_err(|_| self.restore(before))
    }

    fn try_step(&mut self, x: &mut Vec<DVec3>) -> Result<Stepped, FlowError> {
        let watch = Instant::now();
        let mut cost = Cost::telling(self.progress.clone());
        cost.tell("assemble", 0.0);
        if !self.run.is_exhausted {
            self.refusal = None;
        }
        let mut restarted: Option<Vec<DVec3>> = None;
        let mut before = self.evaluate(x, &mut cost)?;
        if let Some(decision) = self.out_of_budget() {
            return Ok((None, decision));
        }
        let mut found = None;
        for _ in 0..MAX_PHASES {
            let here = restarted.as_deref().unwrap_or(x);
            let occasion = Occasion::Before;
            if let Some(phase) = self.flow.next_phase(here, &occasion, &mut cost)? {
                restarted = self.begin(phase, &mut cost.warnings).or(restarted);
                before = self.evaluate(restarted.as_deref().unwrap_or(x), &mut cost)?;
            }
            if let Some(decision) = self.is_zero(before.value) {
                return Ok((None, decision));
            }
            let here = restarted.as_deref().unwrap_or(x);
            if !self.run.is_exhausted {
                found = self.find(here, before, &mut cost)?;
            }
            if found.is_some() {
                break;
            }
            let occasion = Occasion::Stuck {
                dt: self.dt(),
                is_guarded: self.refusal.is_some_and(|refusal| refusal.is_of_mesh()),
            };
            let Some(phase) = self.flow.next_phase(here, &occasion, &mut cost)? else {
                break;
            };
            self.run.is_exhausted = false;
            restarted = self.begin(phase, &mut cost.warnings).or(restarted);
            before = self.evaluate(restarted.as_deref().unwrap_or(x), &mut cost)?;
        }
        let here = restarted.as_deref().unwrap_or(x);
        let (found, ending) = match found {
            Some(found) => (found, None),
            None => {
                let ending = self.stuck(here, before, &mut cost)?;
                let better = match &ending {
                    Decision::Stop(status @ (Status::Stalled | Status::Converged), _) => {
                        self.better(here, *status, &mut cost)?
                    }
                    _ => None,
                };
                let Some(from) = better.and_then(|phase| self.begin(phase, &mut cost.warnings))
                else {
                    return Ok((None, ending));
                };
                (
                    self.placed(here, from, &mut cost)?,
                    Some(self.replaced(ending)),
                )
            }
        };
        let here = here.to_vec();
        let (mut report, decision) = self.conclude(&here, x, found, before, &mut cost)?;
        report.milliseconds = watch.elapsed().as_secs_f64() * 1e3;
        self.run.seconds += watch.elapsed().as_secs_f64();
        Ok((Some(report), ending.unwrap_or(decision)))
    }

    /// The functional at `x`.
    fn evaluate(&mut self, x: &[DVec3], cost: &mut Cost) -> Result<Functional, FlowError> {
        let found = self.flow.evaluate(x, cost)?;
        if !found.value.is_finite() {
            return Err(FlowError::NonFiniteEnergy {
                step: self.run.step + 1,
            });
        }
        self.run.least = self.run.least.min(found.value);
        Ok(found)
    }

    /// Begins a phase; the positions it begins from, if they are not those there are.
    pub(super) fn begin(
        &mut self,
        phase: Phase,
        warnings: &mut Vec<Warning>,
    ) -> Option<Vec<DVec3>> {
        if phase.resets_step_size {
            self.run.step_size = self.flow.step_size();
        }
        if phase.raises_step_size {
            let first = self.flow.step_size().dt;
            self.run.step_size.dt = self.run.step_size.dt.max(first);
        }
        if phase.resets_functional {
            self.run.least = f64::INFINITY;
        }
        self.run.window = Window::default();
        warnings.extend(phase.event);
        phase.from
    }

    /// The next state by falling step sizes, or `None` where none is accepted.
    fn find(
        &mut self,
        x: &[DVec3],
        before: Functional,
        cost: &mut Cost,
    ) -> Result<Option<Found>, FlowError> {
        let watch = Instant::now();
        let rules = self.flow.rules();
        let angles = [
            self.start.angle,
            if rules.least_angle.is_some() {
                measure::sharpest_face(&self.mesh, x).map_or(0.0, |(_, angle)| angle)
            } else {
                0.0
            },
        ];
        let mut trials = Trials {
            mesh: &self.mesh,
            x,
            rules,
            guard: Guard::new(rules, &self.mesh, x, angles),
            before,
            least: self.run.least,
            rejected: 0,
            refusal: None,
            is_guarded: false,
            met_bound: false,
        };
        cost.search += watch.elapsed().as_secs_f64();
        let mut resolved = 0;
        let found = loop {
            cost.tell("factor", 0.1);
            let dt = self.run.step_size.dt;
            let refusal = match self.flow.propose(x, dt, cost)? {
                Proposal::Nothing => break None,
                Proposal::Refused(refusal) => {
                    trials.rejected += 1;
                    trials.refusal = Some(refusal);
                    refusal
                }
                Proposal::Move(step) => {
                    if -step.slope < rules.roundoff && step.slope != 0.0 {
                        break None;
                    }
                    cost.tell("trial", 0.4);
                    let watch = Instant::now();
                    let taken = trials.run(&mut *self.flow, &step, cost);
                    cost.search += watch.elapsed().as_secs_f64();
                    match taken {
                        Ok(taken) => {
                            self.flow.accept(&step, taken.share);
                            self.run
                                .step_size
                                .accepted(taken.share, resolved, step.grows);
                            break Some(Found {
                                limit: trials.limit(&step),
                                step: *step,
                                taken,
                                rejected: trials.rejected,
                                is_guarded: trials.is_guarded,
                                met_bound: trials.met_bound,
                            });
                        }
                        Err(refusal) if step.search == Search::Unseen => {
                            return Err(match refusal.cause {
                                Cause::Unfit => FlowError::Unfit {
                                    vertex: refusal.vertex,
                                },
                                _ => FlowError::NonFiniteEnergy {
                                    step: self.run.step + 1,
                                },
                            });
                        }
                        Err(refusal) => refusal,
                    }
                }
            };
            resolved += 1;
            if !self.run.step_size.refused(refusal.ratio) {
                break None;
            }
        };
        self.refusal = trials.refusal;
        Ok(found)
    }

    /// A move to positions that are better than those a run would end with.
    fn placed(
        &mut self,
        here: &[DVec3],
        mut y: Vec<DVec3>,
        cost: &mut Cost,
    ) -> Result<Found, FlowError> {
        let d = here.iter().zip(&y).map(|(x, y)| *y - *x).collect();
        let value = match self.flow.measure(here, &mut y) {
            Ok(value) => value,
            Err(_) => self.evaluate(&y, cost)?.value,
        };
        let step = Move::new(d, 0.0, 0.0, Search::Unseen);
        self.flow.accept(&step, 1.0);
        Ok(Found {
            step,
            taken: Taken {
                y,
                value,
                share: 1.0,
            },
            limit: value,
            rejected: 0,
            is_guarded: false,
            met_bound: false,
        })
    }

    /// Takes a step over: positions, report, warnings, decision.
    fn conclude(
        &mut self,
        before_x: &[DVec3],
        x: &mut Vec<DVec3>,
        found: Found,
        before: Functional,
        cost: &mut Cost,
    ) -> Result<(StepReport, Decision), FlowError> {
        let Found { step, taken, .. } = &found;
        cost.tell("regularise", 0.5);
        let watch = Instant::now();
        let slid = self.flow.slide(before_x, &taken.y, found.limit, cost)?;
        cost.regularise += watch.elapsed().as_secs_f64();
        cost.tell("finish", 0.9);
        let (y, value) = match slid {
            Some(y) => {
                let value = self.evaluate(&y, cost)?.value;
                (y, value)
            }
            None => (taken.y.clone(), taken.value),
        };
        let dt = taken.share * step.dt;
        self.run.step += 1;
        self.run.time += dt;
        let after = self.evaluate(&y, cost)?;
        let mut report = StepReport {
            step: self.run.step,
            time: self.run.time,
            dt,
            tau: dt / self.flow.time_unit(),
            monitored: self.flow.monitored(),
            objective_before: before.value,
            objective: value,
            rejected: found.rejected,
            is_guarded: found.is_guarded,
            update: step.update,
            warnings: std::mem::take(&mut cost.warnings),
            ..StepReport::default()
        };
        self.measure_mesh(before_x, &y, &mut report);
        *x = y;
        self.flow.describe(x, &mut report);
        self.run.least = self.run.least.min(value);
        self.warn(x, &mut report);
        let gain = Gain {
            before: before.value,
            after: value,
            scale: after.scale,
            dt,
            long_dt: self.flow.rules().long_dt,
            refused: found.rejected,
            is_guarded: found.is_guarded,
            met_bound: found.met_bound,
        };
        let ending = Ending {
            after,
            before,
            gain,
            rests: step.rests,
            is_leading: step.ceiling == Some(Ceiling::None),
        };
        let decision = self.decision(x, &ending, &mut report, cost)?;
        cost.enter(&mut report);
        Ok((report, decision))
    }

    /// What the report says of the mesh.
    fn measure_mesh(&mut self, x: &[DVec3], y: &[DVec3], report: &mut StepReport) {
        self.flipped.clear();
        if self.mesh.is_triangular() {
            let survey = survey(&self.mesh, x, y);
            let folded = |f: &&Face| quality::is_folded(&self.mesh, y, **f);
            self.flipped
                .extend(survey.turned.iter().filter(folded).map(|f| f.0));
            report.area = survey.area;
            report.volume = survey.volume;
            report.min_angle_degrees = survey.min_angle_degrees;
        } else {
            report.area = measure::area(&self.mesh, y);
            report.volume = measure::volume(&self.mesh, y);
            report.min_angle_degrees = measure::min_angle_degrees(&self.mesh, y);
        }
        report.flipped_faces = self.flipped.len();
        let moved = y.iter().zip(&self.start.x).map(|(p, q)| p.distance(*q));
        report.max_displacement = moved.fold(0.0, f64::max) / self.flow.mean_edge_length();
    }
}
