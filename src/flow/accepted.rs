//! What becomes of a step that was found: positions, report, decision.

use super::driver::{Driver, Found};
use super::rules::Ceiling;
use super::search::Taken;
use super::termination::{Ending, Gain};
use super::{Cost, Decision, FlowError, Functional, Move, Search, Status, StepReport};
use crate::geometry::survey::survey;
use crate::geometry::{measure, quality};
use crate::interrupt;
use crate::mesh::Face;
use glam::DVec3;
use web_time::Instant;

impl Driver {
    /// A move to positions that are better than those a run would end with.
    pub(super) fn placed(
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
    pub(super) fn conclude(
        &mut self,
        before_x: &[DVec3],
        x: &mut Vec<DVec3>,
        found: Found,
        before: Functional,
        cost: &mut Cost,
    ) -> Result<(StepReport, Decision), FlowError> {
        let Found { step, taken, .. } = &found;
        interrupt::tell("regularise", 0.5);
        let watch = Instant::now();
        let slid = self.flow.slide(before_x, &taken.y, found.limit, cost)?;
        cost.regularise += watch.elapsed().as_secs_f64();
        interrupt::tell("finish", 0.9);
        interrupt::check()?;
        let (y, value) = match slid {
            Some(y) => {
                let value = self.evaluate(&y, cost)?.value;
                (y, value)
            }
            None => (taken.y.clone(), taken.value),
        };
        let dt = taken.share * step.dt;
        let after = self.evaluate(&y, cost)?;
        self.run.step += 1;
        // Steps of automatic size are implicit and long: less of the flow's time has passed.
        let is_long = self.flow.rules().ceiling != Ceiling::None && !self.run.step_size.is_given;
        let can_vanish = self.flow.rules().can_vanish;
        let passed = before.time_to(&after, can_vanish).filter(|_| is_long);
        // Near rest nothing but rounding is left of either reading.
        let most = if can_vanish { f64::INFINITY } else { dt };
        self.run.time += passed.map_or(dt, |time| time.min(most));
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
        interrupt::check()?;
        *x = y;
        self.flow.describe(x, &mut report);
        interrupt::pulse();
        self.warn(x, &mut report);
        interrupt::pulse();
        let rules = self.flow.rules();
        let gain = Gain {
            before: before.value,
            after: value,
            scale: after.scale,
            dt,
            long_dt: rules.long_dt,
            idle: rules.idle,
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
        if let Decision::Stop(Status::Converged, _) = decision
            && let Some(warning) = self.flow.rested(x)
        {
            self.run.given.give_once(warning, &mut report.warnings);
        }
        cost.enter(&mut report);
        Ok((report, decision))
    }

    /// What the report says of the mesh.
    fn measure_mesh(&mut self, x: &[DVec3], y: &[DVec3], report: &mut StepReport) {
        self.flipped.clear();
        if self.mesh.is_triangular() {
            let survey = survey(&self.mesh, x, y);
            interrupt::pulse();
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
