//! The one loop of all flows: trials and acceptance, step size, budget, phases, and the report.

use super::circle::CircleFlow;
use super::curvature::CurvatureFlow;
use super::guard::Guard;
use super::option::Allowed;
use super::options::FlowOptions;
use super::p_willmore::PWillmoreFlow;
use super::run::{Run, Start};
use super::search::{Taken, Trials};
use super::spec::{self, Family};
use super::termination::Window;
use super::warning::WarningsGiven;
use super::{
    Cause, Cost, Decision, Flow, FlowError, Functional, Move, Occasion, Phase, Proposal, Refusal,
    Search, Status, StepReport, Warning,
};
use crate::geometry::{measure, quality};
use crate::interrupt;
use crate::mesh::HalfedgeMesh;
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
}

/// A step that was found.
pub(super) struct Found {
    pub(super) step: Move,
    pub(super) taken: Taken,
    pub(super) limit: f64,
    pub(super) rejected: usize,
    pub(super) is_guarded: bool,
    pub(super) met_bound: bool,
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
        let as_it_is = row.meshes.quads && Elements::convex(polygons, x).is_some();
        let mesh = Rc::clone(if as_it_is { polygons } else { triangles });
        let flow: Box<dyn Flow> = match row.family {
            Family::Circle => Box::new(CircleFlow::new(&mesh, x, &options)?),
            Family::PWillmore => p_willmore(&mesh, x, &options)?,
            Family::Curvature => curvature(&mesh, x, &options)?,
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
            first_area: start.area,
            first_size: measure::bounding_diagonal(x),
            first_step: 0,
            seconds: 0.0,
            window: Window::default(),
            given: WarningsGiven::default(),
            least: (f64::INFINITY, 0),
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
        }
    }

    /// Takes one step: `x` becomes the next state, or is left as it is with a decision. Where the
    /// step is [given up](crate::interrupt), the next is the same as it would have been.
    ///
    /// # Errors
    /// Numerical failures; `x` and the run are as before.
    pub fn step(&mut self, x: &mut Vec<DVec3>) -> Result<Stepped, FlowError> {
        let (before, mark) = (self.checkpoint(), self.mark());
        let mut y = x.clone();
        let outcome = self.try_step(&mut y);
        if interrupt::is_interrupted() {
            // It may have come of half a result, whatever it is.
            self.go_back(mark);
            return Ok((None, Decision::GivenUp));
        }
        match outcome {
            Ok((Some(_), _)) => *x = y,
            // Asked again, it ends the same.
            Ok((None, _)) => {
                let told = (self.refusal, std::mem::take(&mut self.flipped));
                self.restore(before);
                (self.refusal, self.flipped) = told;
            }
            Err(_) => {
                self.restore(before);
                if let Some(flat) = self.flat_at_first(x) {
                    return Ok((None, flat));
                }
            }
        }
        outcome
    }

    fn try_step(&mut self, x: &mut Vec<DVec3>) -> Result<Stepped, FlowError> {
        let watch = Instant::now();
        let mut cost = Cost::default();
        interrupt::tell("assemble", 0.0);
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
                    Decision::Stop(Status::Collapsed, _) => None,
                    Decision::Stop(status, _) => self.better(here, *status, &mut cost)?,
                    _ => None,
                };
                let goes_on = better.as_ref().is_some_and(|phase| phase.goes_on);
                let Some(from) = better.and_then(|phase| self.begin(phase, &mut cost.warnings))
                else {
                    return Ok((None, ending));
                };
                self.run.is_exhausted &= !goes_on;
                let ending = match goes_on {
                    true => Decision::GoOn,
                    false => self.replaced(ending),
                };
                (self.placed(here, from, &mut cost)?, Some(ending))
            }
        };
        let here = here.to_vec();
        let (mut report, decision) = self.conclude(&here, x, found, before, &mut cost)?;
        report.milliseconds = watch.elapsed().as_secs_f64() * 1e3;
        self.run.seconds += watch.elapsed().as_secs_f64();
        Ok((Some(report), ending.unwrap_or(decision)))
    }

    /// The functional at `x`.
    pub(super) fn evaluate(
        &mut self,
        x: &[DVec3],
        cost: &mut Cost,
    ) -> Result<Functional, FlowError> {
        let found = self.flow.evaluate(x, cost)?;
        interrupt::check()?;
        if !found.value.is_finite() {
            return Err(FlowError::NonFiniteEnergy {
                step: self.run.step + 1,
            });
        }
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
            rejected: 0,
            refusal: None,
            is_guarded: false,
            met_bound: false,
        };
        cost.search += watch.elapsed().as_secs_f64();
        let mut resolved = 0;
        let found = loop {
            interrupt::tell("factor", 0.1);
            let dt = self.run.step_size.dt;
            let proposal = self.flow.propose(x, dt, cost)?;
            interrupt::check()?;
            let refusal = match proposal {
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
                    interrupt::tell("finish", 0.4);
                    let watch = Instant::now();
                    let taken = trials.run(&mut *self.flow, &step, cost);
                    cost.search += watch.elapsed().as_secs_f64();
                    interrupt::check()?;
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
}

type Prepared = Result<Box<dyn Flow>, FlowError>;

deferred! {
    fn p_willmore(mesh: &Rc<HalfedgeMesh>, x: &mut [DVec3], options: &FlowOptions) -> Prepared {
        Ok(Box::new(PWillmoreFlow::new(mesh, x, options)?))
    }
}

deferred! {
    fn curvature(mesh: &Rc<HalfedgeMesh>, x: &mut [DVec3], options: &FlowOptions) -> Prepared {
        Ok(Box::new(CurvatureFlow::new(mesh, x, options)?))
    }
}
