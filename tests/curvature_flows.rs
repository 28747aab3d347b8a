//! Flows by mean curvature and its derivatives.
#![allow(missing_docs, reason = "tests")]

mod support;

use glam::DVec3;
use std::rc::Rc;
use support::*;
use umbilic::energy::curvature_jump::curvature_jump;
use umbilic::flow::curvature::CurvatureFlow;
use umbilic::flow::options::{FlowName, FlowOptions};
use umbilic::flow::stop::Verdict;
use umbilic::flow::{Flow, FlowError, Status, StepReport};
use umbilic::mesh::shape;

struct Case {
    surface: Surface,
    free: Option<Vec<u32>>,
    fixed: Option<Vec<u32>>,
}

fn sample(name: &str, values: &[(&str, f64)]) -> Case {
    let values: Vec<(String, f64)> = values.iter().map(|(n, v)| ((*n).to_owned(), *v)).collect();
    let made = shape::make(name, &values).expect("a shape");
    Case {
        surface: surface(&made.soup),
        free: made.free,
        fixed: made.fixed,
    }
}

struct Run {
    x: Vec<DVec3>,
    reports: Vec<StepReport>,
    status: Status,
    flow: CurvatureFlow,
}

impl Case {
    fn options(&self, flow: FlowName) -> FlowOptions {
        FlowOptions {
            flow,
            free: self.free.clone(),
            fixed: self.fixed.clone(),
            max_steps: 60,
            ..FlowOptions::default()
        }
    }

    fn start(&self, options: FlowOptions) -> Result<(CurvatureFlow, Vec<DVec3>), FlowError> {
        let mut x = self.surface.x.clone();
        let flow = CurvatureFlow::new(Rc::clone(&self.surface.mesh), &mut x, options)?;
        Ok((flow, x))
    }

    fn run(&self, options: FlowOptions) -> Run {
        let (mut flow, mut x) = self.start(options).expect("a flow");
        let mut reports = Vec::new();
        loop {
            let (report, verdict) = flow.step(&mut x).expect("a step");
            if let Some(report) = report {
                if std::env::var("VERBOSE").is_ok() {
                    println!(
                        "step {} φ/h {:.2e} E {:.6e} V {:.2e} residual {:.0e} ms {:.1} = {:.1}+{:.1}+{:.1} {:?}",
                        report.step,
                        report.update.unwrap_or_default(),
                        report.energy,
                        report.gradient_norm,
                        report.linear_residual.unwrap_or_default(),
                        report.milliseconds,
                        report.assemble_milliseconds,
                        report.factor_milliseconds,
                        report.solve_milliseconds,
                        report.warnings
                    );
                }
                reports.push(report);
            }
            if let Verdict::Stop(status, _) = verdict {
                return Run {
                    x,
                    reports,
                    status,
                    flow,
                };
            }
        }
    }
}

fn largest(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(0.0, f64::max)
}

#[test]
fn a_cylinder_is_restored() {
    let case = sample("cylinder-gaps", &[]);
    for prefill in [false, true] {
        let options = FlowOptions {
            prefill,
            ..case.options(FlowName::Mmcv)
        };
        let run = case.run(options);
        let error = largest(run.x.iter().map(|p| (p.truncate().length() - 1.0).abs()));
        let start = largest(
            case.surface
                .x
                .iter()
                .map(|p| (p.truncate().length() - 1.0).abs()),
        );
        println!(
            "cylinder, {} free, prefill {prefill}: {start:.3} -> {error:.1e} in {} steps",
            run.flow.n_free(),
            run.reports.len()
        );
        assert_eq!(run.status, Status::Converged);
        assert!(error < 5e-4);
        assert!(run.reports.len() <= 15);
    }
}

#[test]
fn a_sphere_is_restored() {
    for level in [4.0, 5.0] {
        for prefill in [false, true] {
            let case = sample("sphere-openings", &[("level", level)]);
            let options = FlowOptions {
                prefill,
                ..case.options(FlowName::Mmcv)
            };
            let run = case.run(options);
            let error = largest(run.x.iter().map(|p| (p.length() - 1.0).abs()));
            println!(
                "sphere, {} free, prefill {prefill}: {error:.1e} in {} steps",
                run.flow.n_free(),
                run.reports.len()
            );
            assert_eq!(run.status, Status::Converged);
            assert!(error < 5e-4);
            assert!(run.reports.len() <= 15);
        }
    }
}

#[test]
fn a_dodecahedron_becomes_the_sphere_through_its_corners() {
    for prefill in [false, true] {
        let case = sample("dodecahedron", &[]);
        let options = FlowOptions {
            prefill,
            ..case.options(FlowName::Mmcv)
        };
        let run = case.run(options);
        let error = largest(run.x.iter().map(|p| (p.length() - 1.0).abs()));
        println!(
            "dodecahedron, {} free, prefill {prefill}: {error:.1e} in {} steps",
            run.flow.n_free(),
            run.reports.len()
        );
        assert_eq!(run.flow.n_free(), 1134);
        assert_eq!(run.status, Status::Converged);
        assert!(error < 1e-3);
    }
}

#[test]
fn bumps() {
    for n in [31.0, 61.0, 121.0] {
        for flow in [
            FlowName::MeanCurvature,
            FlowName::SurfaceDiffusion,
            FlowName::Willmore,
            FlowName::Mmcv,
        ] {
            let case = sample("four-bumps", &[("vertices", n)]);
            let run = case.run(case.options(flow));
            let top = largest(run.x.iter().map(|p| p.z));
            let free: Vec<bool> = (0..run.x.len()).map(|v| run.flow.is_free(v)).collect();
            let jump = curvature_jump(&case.surface.mesh, &run.x, &free).expect("a rim");
            println!("  jump {:.4}, {} vertices", jump.relative, jump.vertices);
            println!(
                "bumps {n}, {} free, {flow:?}: top {top:.4} in {} steps",
                run.flow.n_free(),
                run.reports.len()
            );
            assert_eq!(run.status, Status::Converged);
        }
    }
}
