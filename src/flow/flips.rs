//! Edge flips step by step: a step is a number of flips, and the positions stay.
//!
//! An optimiser of connectivity beside the flows, which change positions. Brink & Alboul
//! [BA](crate::bibliography#ba) compare three criteria from the same start; the others can run
//! beside the chosen one, flip by flip.

use super::options::FlowOptions;
use super::{Decision, FlowError, Reading, Reason, Status, StepReport};
use crate::geometry::measure;
use crate::interrupt;
use crate::mesh::{HalfedgeMesh, Vertex};
use crate::order;
use crate::remesh::flips::FlipOptimiser;
use crate::remesh::flips::reduction::Criterion;
use glam::DVec3;
use serde::Serialize;
use std::rc::Rc;
use web_time::Instant;

/// More edges than this would hide the mesh.
const SHOWN: usize = 100;

/// Where the optimisation by one criterion stands.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct FlipReading {
    /// What is to become small.
    pub criterion: Criterion,
    /// Flips made.
    pub flips: usize,
    /// Flips refused that would have gained.
    pub rejected: usize,
    /// Total area.
    pub area: f64,
    /// W = 2 Σ β − 2πV over interior edges.
    pub circle: f64,
    /// What the last flip gained.
    pub reduction: Option<f64>,
}

/// Edge-flip optimisation by one criterion, or by all three side by side.
pub struct EdgeFlips {
    start: Rc<HalfedgeMesh>,
    x: Rc<Vec<DVec3>>,
    guards_folds: bool,
    per_step: usize,
    /// The chosen criterion first.
    runs: Vec<FlipOptimiser>,
    /// Flips made before the last step.
    before: usize,
    mean_edge_length: f64,
}

impl EdgeFlips {
    /// Prepares the optimisation of a triangle mesh at fixed positions.
    ///
    /// # Errors
    /// [`FlowError::NotTriangular`].
    pub fn new(
        mesh: Rc<HalfedgeMesh>,
        x: &[DVec3],
        options: &FlowOptions,
    ) -> Result<Self, FlowError> {
        options.check()?;
        let corners = |f| mesh.face_vertices(f).count();
        if let Some(f) = mesh.faces().find(|&f| corners(f) != 3) {
            return Err(FlowError::NotTriangular {
                face: f.0,
                corners: corners(f),
            });
        }
        let mut this = Self {
            mean_edge_length: measure::mean_edge_length(&mesh, x),
            start: mesh,
            x: Rc::new(x.to_vec()),
            guards_folds: options.guard_folds,
            per_step: 1,
            runs: Vec::new(),
            before: 0,
        };
        this.runs.push(this.run(options.criterion));
        Ok(this)
    }

    fn run(&self, criterion: Criterion) -> FlipOptimiser {
        let mesh = HalfedgeMesh::clone(&self.start);
        FlipOptimiser::new(mesh, Rc::clone(&self.x), criterion, self.guards_folds)
    }

    /// Runs the other criteria beside the chosen one, or no longer; they catch up.
    pub fn compare(&mut self, all: bool) {
        let clock = self.clock();
        if !all {
            self.runs.truncate(1);
        } else if self.runs.len() == 1 {
            let chosen = self.runs[0].criterion();
            for criterion in Criterion::ALL.into_iter().filter(|c| *c != chosen) {
                let mut run = self.run(criterion);
                while run.flips() < clock && run.step().is_some() {}
                self.runs.push(run);
            }
        }
    }

    /// How many flips a step makes, as far as there are any.
    pub fn set_per_step(&mut self, flips: usize) {
        self.per_step = flips.max(1);
    }

    /// Flips made by the run that made most: the others have come to their ends.
    pub fn clock(&self) -> usize {
        let made = self.runs.iter().map(FlipOptimiser::flips);
        made.max().unwrap_or_default()
    }

    /// The optimisations, that of the chosen criterion first.
    pub fn runs(&self) -> &[FlipOptimiser] {
        &self.runs
    }

    /// Connectivity before the first flip.
    pub fn start(&self) -> &Rc<HalfedgeMesh> {
        &self.start
    }

    /// Ends of the edges that the last step made in a run, the latest hundred at most.
    pub fn last_edges(&self, run: &FlipOptimiser) -> Vec<[Vertex; 2]> {
        let made = run.made();
        let first = self.before.max(made.len().saturating_sub(SHOWN));
        let last = made.get(first..).unwrap_or_default();
        let mut edges: Vec<_> = last.iter().map(|flip| flip.edge).collect();
        order::sort(&mut edges);
        edges.dedup();
        edges.into_iter().map(|e| run.mesh().ends(e)).collect()
    }

    /// Readings of all runs.
    pub fn readings(&self) -> Vec<FlipReading> {
        let reading = |run: &FlipOptimiser| FlipReading {
            criterion: run.criterion(),
            flips: run.flips(),
            rejected: run.rejected(),
            area: run.area(),
            circle: run.willmore(),
            reduction: run.made().last().map(|flip| flip.reduction),
        };
        self.runs.iter().map(reading).collect()
    }

    /// Goes on to a number of flips, or to the end of every run, unless the work is given up; whether
    /// there were any.
    fn advance(&mut self, goal: usize) -> bool {
        self.before = self.clock();
        for run in &mut self.runs {
            while run.flips() < goal && run.step().is_some() {
                // How many there will be is not known: seldom more than a third of the edges.
                if run.flips().is_multiple_of(256) {
                    let expected = run.mesh().n_edges() as f64 / 3.0;
                    interrupt::tell("flips", (run.flips() as f64 / expected).min(0.99));
                    if interrupt::is_interrupted() {
                        break;
                    }
                }
            }
        }
        self.clock() > self.before
    }

    fn rewind(&mut self, goal: usize) {
        for run in &mut self.runs {
            while run.flips() > goal && run.back().is_some() {}
        }
        self.before = self.clock().saturating_sub(self.per_step);
    }

    /// Goes to a number of flips, from before or after it.
    pub fn seek(&mut self, goal: usize) {
        self.rewind(goal);
        if self.clock() < goal {
            self.advance(goal);
        }
    }

    fn end(&self) -> Reason {
        let criterion = match self.runs[0].criterion() {
            _ if self.runs.len() > 1 => "all",
            Criterion::Area => "area",
            Criterion::Willmore => "willmore",
            Criterion::Localised => "localised",
        };
        Reason::NoFlips { criterion }
    }
}

impl EdgeFlips {
    /// Flips as many edges as a step does; without a report where there are none left, or where the
    /// step is [given up](crate::interrupt): every flip is taken back then.
    pub fn step(&mut self, x: &[DVec3]) -> (Option<StepReport>, Decision) {
        let start = Instant::now();
        let before = self.runs[0].willmore();
        let flips = self.runs[0].flips();
        let (last, clock) = (self.before, self.clock());
        let is_any = self.advance(clock.saturating_add(self.per_step));
        if interrupt::commit().is_err() {
            self.rewind(clock);
            self.before = last;
            return (None, Decision::GivenUp);
        }
        if !is_any {
            return (None, Decision::Stop(Status::Converged, self.end()));
        }
        let reading = self.reading(x);
        let clock = self.clock();
        let taken = (clock - self.before) as f64;
        let report = StepReport {
            step: clock,
            time: clock as f64,
            dt: taken,
            tau: taken,
            energy: reading.energy,
            energy_normalised: reading.energy_normalised,
            objective_before: before,
            objective: reading.energy,
            area: reading.area,
            volume: reading.volume,
            min_angle_degrees: measure::min_angle_degrees(self.runs[0].mesh(), x),
            rejected: self.runs[0].rejected(),
            iterations: self.runs[0].flips() - flips,
            milliseconds: start.elapsed().as_secs_f64() * 1e3,
            flips: Some(self.readings()),
            ..StepReport::default()
        };
        (Some(report), Decision::GoOn)
    }

    /// Readings of the chosen run.
    pub fn reading(&self, x: &[DVec3]) -> Reading {
        let run = &self.runs[0];
        Reading {
            energy: run.willmore(),
            energy_normalised: 0.5 * run.willmore(),
            objective: run.willmore(),
            area: run.area(),
            volume: measure::volume(run.mesh(), x),
            ..Reading::default()
        }
    }

    /// Mean edge length at the start.
    pub fn mean_edge_length(&self) -> f64 {
        self.mean_edge_length
    }

    /// How many flips a step makes.
    pub fn per_step(&self) -> usize {
        self.per_step
    }
}
