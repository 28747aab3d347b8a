//! The driver on a flow whose functional, moves and refusals are written down: what no real flow
//! shows one at a time.

use super::circle::CircleFlow;
use super::options::FlowOptions;
use super::rules::{Ceiling, NEGLIGIBLE, Rules};
use super::step_size::StepSize;
use super::{
    Clock, Cost, Decision, Driver, Flow, FlowError, Functional, Memory, Monitored, Move, Occasion,
    Phase, Proposal, Reading, Reason, Refusal, Search, Status, StepReport,
};
use crate::mesh::{HalfedgeMesh, build, shape};
use glam::DVec3;
use std::cell::{Cell, RefCell};
use std::rc::Rc;

mod endings;
mod phases;
mod trials;

type Function = Rc<dyn Fn(f64) -> f64>;

/// A flow of spheres about the origin: a function of the radius, moved by a speed.
#[derive(Clone)]
struct Script {
    monitored: Monitored,
    value: Function,
    /// dr/dt at a radius.
    speed: Function,
    /// Whether a trial at a radius is refused.
    refusal: Rc<dyn Fn(f64) -> Option<Refusal>>,
    bounded: Function,
    rules: Rules,
    dt: f64,
    search: Search,
    stationarity: f64,
    /// What replaces the surface at an ending of this kind.
    better: Option<(bool, f64)>,
    rests: bool,
    /// What begins once, when the functional has stopped falling; it is larger by one then.
    phase: Option<Phase>,
    has_begun: Rc<Cell<bool>>,
    /// Factor on the step size after a step.
    growth: f64,
    /// A step size below which nothing can be proposed.
    fails_below: f64,
    /// By how much the first vertex moves out further.
    spike: f64,
    /// Of the sphere's mesh.
    level: f64,
    /// Radii measured, in order.
    measured: Rc<RefCell<Vec<f64>>>,
}

impl Script {
    fn new(value: impl Fn(f64) -> f64 + 'static, speed: impl Fn(f64) -> f64 + 'static) -> Self {
        Self {
            monitored: Monitored::Willmore,
            value: Rc::new(value),
            speed: Rc::new(speed),
            refusal: Rc::new(|_| None),
            bounded: Rc::new(|_| f64::INFINITY),
            rules: Rules {
                ceiling: Ceiling::Descent,
                zero: f64::NEG_INFINITY,
                idle: Some(NEGLIGIBLE),
                ..Rules::unseen()
            },
            dt: 1.0,
            search: Search::Shorten,
            stationarity: 2.0,
            better: None,
            rests: false,
            phase: None,
            has_begun: Rc::default(),
            growth: 2.0,
            fails_below: 0.0,
            spike: 1.0,
            level: 1.0,
            measured: Rc::default(),
        }
    }

    /// A run from the unit sphere, for so many steps at most.
    fn run(&self, steps: usize) -> (Vec<StepReport>, Option<(Status, Reason)>, f64) {
        let (mesh, mut x) = ball(self.level);
        let options = FlowOptions {
            max_steps: Some(steps),
            ..FlowOptions::default()
        };
        let inner = CircleFlow::new(&mesh, &mut x, &options).expect("a flow");
        let flow = Scripted {
            script: self.clone(),
            inner,
            slope: 0.0,
        };
        let mut driver = Driver::of(Box::new(flow), mesh, &x, options);
        let mut reports = Vec::new();
        for _ in 0..steps + 2 {
            let (report, decision) = driver.step(&mut x).expect("a step");
            reports.extend(report);
            if let Decision::Stop(status, why) = decision {
                return (reports, Some((status, why)), radius(&x));
            }
        }
        (reports, None, radius(&x))
    }

    fn status(&self) -> (usize, Status) {
        let (reports, ending, _) = self.run(200);
        (reports.len(), ending.expect("an ending").0)
    }
}

fn ball(level: f64) -> (Rc<HalfedgeMesh>, Vec<DVec3>) {
    let sample = shape::make("icosphere", &[("level".into(), level)]).expect("a shape");
    let built = build(&sample.soup).expect("a surface");
    (Rc::new(built.mesh), built.positions)
}

fn radius(x: &[DVec3]) -> f64 {
    x.iter().map(|p| p.length()).fold(0.0, f64::max)
}

struct Scripted {
    script: Script,
    inner: CircleFlow,
    slope: f64,
}

impl Scripted {
    fn value(&self, r: f64) -> f64 {
        let is_other = self.script.phase.is_some() && self.script.has_begun.get();
        (self.script.value)(r) + f64::from(u8::from(is_other))
    }
}

impl Flow for Scripted {
    fn monitored(&self) -> Monitored {
        self.script.monitored
    }
    fn clock(&self) -> Clock {
        Clock::Own
    }
    fn rules(&self) -> Rules {
        self.script.rules
    }
    fn step_size(&self) -> StepSize {
        StepSize::adaptive(self.script.dt, 1e-9, 1e9).with_factors(self.script.growth, 0.25)
    }
    fn time_unit(&self) -> f64 {
        1.0
    }
    fn evaluate(&mut self, x: &[DVec3], _: &mut Cost) -> Result<Functional, FlowError> {
        Ok(Functional::plain(self.value(radius(x))))
    }
    fn propose(&mut self, x: &[DVec3], dt: f64, _: &mut Cost) -> Result<Proposal, FlowError> {
        if dt < self.script.fails_below {
            return Err(FlowError::Unfit { vertex: 7 });
        }
        let r = radius(x);
        let move_by = dt * (self.script.speed)(r);
        let slope = ((self.script.value)(r + 1e-6) - (self.script.value)(r - 1e-6)) / 2e-6;
        let mut d: Vec<DVec3> = x.iter().map(|p| move_by / r * *p).collect();
        d[0] *= self.script.spike;
        let mut step = Move::new(d, (slope * move_by).min(0.0), dt, self.script.search);
        step.rests = self.script.rests;
        Ok(Proposal::Move(Box::new(step)))
    }
    fn measure(&mut self, _: &[DVec3], y: &mut [DVec3]) -> Result<f64, Refusal> {
        let r = radius(y);
        self.script.measured.borrow_mut().push(r);
        self.slope = ((self.script.value)(r + 1e-6) - (self.script.value)(r - 1e-6)) / 2e-6;
        match (self.script.refusal)(r) {
            Some(refusal) => Err(refusal),
            None => Ok(self.value(r)),
        }
    }
    fn trial_slope(&self, d: &[DVec3]) -> f64 {
        self.slope * radius(d)
    }
    fn bounded(&self) -> f64 {
        let r = *self.script.measured.borrow().last().expect("a trial");
        (self.script.bounded)(r)
    }
    fn next_phase(
        &mut self,
        x: &[DVec3],
        occasion: &Occasion,
        _: &mut Cost,
    ) -> Result<Option<Phase>, FlowError> {
        if matches!(occasion, Occasion::Idle { .. }) && !self.script.has_begun.replace(true) {
            return Ok(self.script.phase.clone());
        }
        let Occasion::Ending { is_at_rest } = *occasion else {
            return Ok(None);
        };
        Ok(self
            .script
            .better
            .filter(|b| b.0 == is_at_rest)
            .map(|b| Phase {
                from: Some(x.iter().map(|p| b.1 * p.normalize()).collect()),
                ..Phase::default()
            }))
    }
    fn stationarity(&mut self, _: &[DVec3], _: &mut Cost) -> Result<f64, FlowError> {
        Ok(self.script.stationarity)
    }
    fn describe(&mut self, _: &[DVec3], _: &mut StepReport) {}
    fn reading(&mut self, x: &[DVec3]) -> Reading {
        self.inner.reading(x)
    }
    fn gradient(&self, x: &[DVec3]) -> Vec<DVec3> {
        self.inner.gradient(x)
    }
    fn mean_edge_length(&self) -> f64 {
        self.inner.mean_edge_length()
    }
    fn n_free(&self) -> usize {
        self.inner.n_free()
    }
    fn is_free(&self, v: usize) -> bool {
        self.inner.is_free(v)
    }
    fn memory(&self) -> Memory {
        self.inner.memory()
    }
    fn recall(&mut self, memory: Memory) {
        self.inner.recall(memory);
    }
}

/// Grows slowly, and gains nothing.
fn idle() -> Script {
    Script::new(|_| 1.0, |_| 1e-3)
}
