//! Runs of a flow that check at each step what holds in every run.

use super::{Surface, surface};
use glam::DVec3;
use std::rc::Rc;
use umbilic::flow::options::FlowOptions;
use umbilic::flow::spec::FlowName;
use umbilic::flow::{Decision, Driver, Reason, Status, StepReport};

pub struct Run {
    pub x: Vec<DVec3>,
    pub reports: Vec<StepReport>,
    pub status: Status,
    /// Why it ended, unless it failed.
    pub reason: Option<Reason>,
}

impl Run {
    pub fn last(&self) -> &StepReport {
        self.reports.last().expect("steps")
    }
}

/// Runs a flow to its end; a mesh with other faces than triangles is cut into them where the
/// flow takes nothing else.
pub fn watch(s: &Surface, options: FlowOptions, what: &str) -> Run {
    let flow = options.flow;
    let mut x = s.x.clone();
    let triangles = if s.mesh.is_triangular() {
        Rc::clone(&s.mesh)
    } else {
        surface(&s.mesh.to_soup(&s.x).triangulated()).mesh
    };
    let mut driver = Driver::start(&triangles, &s.mesh, &mut x, options).expect("a flow");
    let mut reports: Vec<StepReport> = Vec::new();
    // Of a patch under surface diffusion the area need not fall: volume goes through its rim.
    let is_exchanged = flow == FlowName::SurfaceDiffusion && !s.mesh.is_closed();
    loop {
        let before = x.clone();
        let (report, verdict) = match driver.step(&mut x) {
            Ok(outcome) => outcome,
            Err(error) => {
                assert_eq!(x, before, "{what} {flow:?}: {error}");
                return Run {
                    x,
                    reports,
                    status: Status::Failed,
                    reason: None,
                };
            }
        };
        if let Some(report) = report {
            assert!(x.iter().all(|p| p.is_finite()), "{what} {flow:?}");
            assert!(report.objective.is_finite() && report.energy.is_finite());
            // What is monitored may rise between steps only where a phase begins, which is told
            // with the step before or after, or where steps prepare a rough start.
            if let Some(last) = reports.last() {
                let is_told = !report.warnings.is_empty() || !last.warnings.is_empty();
                let begins = is_told || last.prepares || report.monitored != last.monitored;
                let has_risen =
                    report.objective_before > last.objective + 1e-9 * last.objective.abs() + 1e-12;
                assert!(
                    begins || !has_risen,
                    "{what} {flow:?}, before step {}: {last:?}",
                    report.step
                );
            }
            let is_exempt = report.prepares || is_exchanged;
            // A billionth of the first reading cannot be told from zero by fits.
            let first = reports.first().unwrap_or(&report).objective_before;
            let is_nothing = report.objective <= 1e-9 * first;
            assert!(
                is_exempt || is_nothing || report.objective <= report.objective_before,
                "{what} {flow:?}, step {}: a rise by {}",
                report.step,
                report.objective - report.objective_before
            );
            reports.push(report);
        }
        if let Decision::Stop(status, reason) = verdict {
            // W is what people see fall.
            let seen = reports.iter().map(|report| report.energy);
            if flow == FlowName::Circle
                && status == Status::Converged
                && let Some(last) = reports.last()
            {
                let least = seen.fold(f64::INFINITY, f64::min);
                assert!(
                    last.energy <= (1.0 + 1e-6) * least + 1e-9,
                    "{what}: at rest at {}, having passed {least}",
                    last.energy
                );
            }
            return Run {
                x,
                reports,
                status,
                reason: Some(reason),
            };
        }
    }
}

pub fn limited(flow: FlowName, steps: usize) -> FlowOptions {
    FlowOptions {
        flow,
        max_steps: Some(steps),
        ..FlowOptions::default()
    }
}
