//! Every flow on meshes nobody tuned it for: the monitored functional never rises on an
//! accepted step, endings are true, and nothing goes below what theorems say.

use crate::support::*;
use glam::DVec3;
use std::f64::consts::PI;
use umbilic::flow::constraint::Kept;
use umbilic::flow::options::{FlowName, FlowOptions};
use umbilic::flow::{Monitored, Reason, Status, StepReport, Verdict};
use umbilic::geometry::measure;

const FLOWS: [FlowName; 6] = [
    FlowName::Circle,
    FlowName::PWillmore,
    FlowName::MeanCurvature,
    FlowName::SurfaceDiffusion,
    FlowName::Willmore,
    FlowName::Mmcv,
];

/// By how much a reading may lie above the least so far: fitted ones are not quite what the
/// discrete flow lowers, and a hundredth is for steps that contract to a rest.
fn tolerance(monitored: Monitored, flow: FlowName) -> f64 {
    match (monitored, flow) {
        (Monitored::SmoothedCircle | Monitored::PWillmore | Monitored::Helfrich, _)
        | (_, FlowName::PWillmore) => 1e-12,
        _ => 1.1e-2,
    }
}

struct Run {
    x: Vec<DVec3>,
    reports: Vec<StepReport>,
    status: Status,
    /// Why it ended, unless it failed.
    reason: Option<Reason>,
}

impl Run {
    fn last(&self) -> &StepReport {
        self.reports.last().expect("steps")
    }
}

/// Runs a flow, and checks what holds in every run.
fn run(s: &Surface, options: FlowOptions, what: &str) -> Run {
    let flow = options.flow;
    let mut x = s.x.clone();
    let mut driver = drive(&s.mesh, &mut x, options).expect("a flow");
    let mut reports: Vec<StepReport> = Vec::new();
    let (mut least, mut prepared) = (f64::INFINITY, false);
    let mut monitored = Monitored::default();
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
            // A phase may begin with another functional, or from the start.
            let begins = !report.warnings.is_empty() || report.monitored != monitored;
            if begins || prepared || reports.is_empty() {
                least = report.objective_before;
            }
            let first = reports
                .first()
                .map_or(least, |first| first.objective_before);
            let slack = 1e-12 + 2e-9 * first.abs();
            (prepared, monitored) = (report.prepares, report.monitored);
            let allowed = tolerance(monitored, flow) * least.abs() + slack;
            assert!(
                prepared || is_exchanged || report.objective <= least + allowed,
                "{what} {flow:?}, step {}: {} above {least}, {:?}",
                report.step,
                report.objective,
                reports.last()
            );
            least = least.min(report.objective);
            reports.push(report);
        }
        if let Verdict::Stop(status, reason) = verdict {
            return Run {
                x,
                reports,
                status,
                reason: Some(reason),
            };
        }
    }
}

fn options(flow: FlowName, steps: usize) -> FlowOptions {
    FlowOptions {
        flow,
        max_steps: Some(steps),
        ..FlowOptions::default()
    }
}

/// A sample with its vertices pushed about by `noise` mean edges in each coordinate.
fn noisy(name: &str, values: &[(&str, f64)], noise: f64, seed: u64) -> Surface {
    let mut s = surface(&sample(name, values));
    let h = measure::mean_edge_length(&s.mesh, &s.x);
    let mut random = Random(seed);
    for p in &mut s.x {
        *p += noise * h * random.vector();
    }
    s
}

/// ∫H² ≥ 4π for every closed surface (Willmore 1965): the fitted flow ends near the sphere,
/// and the flow by mean curvature stops at the time the one of p = 0 tells.
#[test]
fn an_ellipsoid_under_every_flow() {
    let s = surface(&sample(
        "ellipsoid",
        &[("level", 3.0), ("a", 1.5), ("c", 0.7)],
    ));
    let willmore = run(&s, options(FlowName::Willmore, 200), "ellipsoid");
    let ratio = willmore.last().energy / (4.0 * PI);
    assert!((1.0..1.03).contains(&ratio), "{ratio}");
    let mut last = f64::INFINITY;
    for report in willmore.reports.iter().take(10) {
        assert!(report.energy < last);
        last = report.energy;
    }
    let variation = run(&s, options(FlowName::Mmcv, 200), "ellipsoid");
    assert_eq!(
        variation.status,
        Status::Converged,
        "{:?}",
        variation.reason
    );
    assert!(variation.last().energy < 1e-9 * variation.reports[0].energy);

    let fitted = run(&s, options(FlowName::MeanCurvature, 400), "ellipsoid");
    let zero = FlowOptions {
        p: 0.0,
        ..options(FlowName::PWillmore, 400)
    };
    let elements = run(&s, zero, "ellipsoid");
    assert_eq!(
        (fitted.status, elements.status),
        (Status::Singular, Status::Singular)
    );
    // V = −H in the one, −2H in the other.
    let (a, b) = (fitted.last().time, 2.0 * elements.last().time);
    assert!((a / b - 1.0).abs() < 0.1, "{a} {b}");
    assert!(fitted.last().volume.expect("closed") >= 0.0);
}

/// R² = R₀² − 2t under V = −H.
#[test]
fn a_sphere_shrinks_by_its_law_and_vanishes() {
    let s = surface(&sample("icosphere", &[("level", 3.0)]));
    let slow = FlowOptions {
        tau: Some(1e-3),
        ..options(FlowName::MeanCurvature, 20)
    };
    let found = run(&s, slow, "sphere");
    let radius = (found.last().area / (4.0 * PI)).sqrt();
    let expected = (1.0 - 2.0 * found.last().time).sqrt();
    assert!(
        (radius / expected - 1.0).abs() < 0.05,
        "{radius} {expected}"
    );
    let end = run(&s, options(FlowName::MeanCurvature, 400), "sphere");
    assert_eq!(end.status, Status::Singular);
    assert!(
        matches!(end.reason, Some(Reason::Vanishes { .. })),
        "{:?}",
        end.reason
    );
}

/// W ≥ 4π² on tori (Marques & Neves): a noisy one comes near it, and what people see jumps up
/// by no more than 5 % in a step.
#[test]
fn a_noisy_torus_comes_near_the_least_energy() {
    let torus = [("around", 40.0), ("tube", 20.0)];
    let s = noisy("torus", &torus, 0.05, 3);
    let found = run(&s, options(FlowName::Circle, 200), "torus");
    let mut last = f64::INFINITY;
    for report in &found.reports {
        assert!(report.energy <= 1.05 * last + 1e-9, "step {}", report.step);
        assert!(report.objective >= report.energy - 1e-9);
        last = report.energy;
    }
    assert!(last < 0.6 * found.reports[0].energy, "{last}");
    assert!(last > 0.95 * 4.0 * PI * PI - 1e-9);
}

/// On a mesh ∫H² is least far out on the orbit of the conformal maps; with nothing kept the
/// torus stays where it is all the same.
#[test]
fn a_torus_of_quads_comes_to_rest_and_stays() {
    let Some(s) = case("torq.obj") else { return };
    let found = run(&s, options(FlowName::PWillmore, 1000), "torus of quads");
    assert_eq!(found.status, Status::Converged, "{:?}", found.reason);
    let area = found.last().area / measure::area(&s.mesh, &s.x);
    assert!((0.5..2.0).contains(&area), "{area}");
    let at_20 = found.reports[19].energy;
    assert!((found.last().energy / at_20 - 1.0).abs() < 0.01);
}

/// No surface of genus 2 has W < 64.6: what would go below is a handle that closes between the
/// vertices.
#[test]
fn a_handle_that_closes_is_a_collapse() {
    let Some(s) = case("genus2.obj") else { return };
    let found = run(&s, options(FlowName::Circle, 1000), "genus 2");
    assert_eq!(found.status, Status::Collapsed, "{:?}", found.reason);
    assert!(found.last().energy > 0.95 * (4.0 * PI * PI + 8.0 * PI) - 1e-9);
}

/// The reduced volume .868 has its least ∫H² on the prolate spheroid's branch, 1.2507 · 4π; a
/// rough start with both kept takes steps however small they must be.
#[test]
fn a_rough_vesicle_moves() {
    let Some(s) = case("vp_0.004.obj") else {
        return;
    };
    let both = FlowOptions {
        keep: vec![Kept::Area, Kept::Volume],
        ..options(FlowName::PWillmore, 200)
    };
    let found = run(&s, both, "vesicle");
    let energy = found.last().energy;
    assert!((energy / 15.81 - 1.0).abs() < 5e-3, "{energy}");
    assert_ne!(found.status, Status::Stalled, "{:?}", found.reason);
}

/// A surface that is small, large or far away is treated alike.
#[test]
fn random_surfaces_under_every_flow() {
    let shapes: [(&str, &[(&str, f64)]); 4] = [
        ("icosphere", &[("level", 2.0)]),
        ("torus", &[("around", 18.0), ("tube", 9.0)]),
        ("double-torus", &[("level", 2.0)]),
        ("hemisphere", &[("rings", 8.0)]),
    ];
    let frames = [(1.0, 0.0), (1e-4, 0.0), (1e4, 0.0), (1.0, 1e5)];
    for (k, (name, values)) in shapes.into_iter().enumerate() {
        for (seed, noise) in [(1, 0.02), (2, 0.1), (3, 0.2)] {
            let (scale, offset) = frames[(k + seed as usize) % frames.len()];
            let mut s = noisy(name, values, noise, seed);
            s.x.iter_mut()
                .for_each(|p| *p = scale * *p + DVec3::splat(offset));
            for flow in FLOWS {
                if flow == FlowName::PWillmore && !s.mesh.is_closed() {
                    continue;
                }
                run(&s, options(flow, 30), &format!("{name}, noise {noise}"));
            }
        }
    }
}

fn case(name: &str) -> Option<Surface> {
    let bytes = std::fs::read(shared_meshes()?.join("../cases/flows").join(name)).ok()?;
    let soup = umbilic::io::read(&bytes, name).expect("readable").soup;
    Some(surface(&soup))
}

/// Every real mesh, every flow that takes it: a table of endings.
#[test]
fn real_meshes_under_every_flow() {
    let names = [
        "bob_small.ply",
        "spot_low_resolution.obj",
        "cat_head.obj",
        "icosahedron_binary.stl",
        "hemisphere.off",
        "bunny.obj",
        "borromean.obj",
        "skull_low_resolution.obj",
    ];
    println!("mesh, flow, ending, steps, energy, smallest angle");
    for name in names {
        let Some(s) = real(name) else { return };
        for flow in FLOWS {
            if flow == FlowName::PWillmore && !s.mesh.is_closed() {
                continue;
            }
            let steps = if s.mesh.n_vertices() > 2000 { 12 } else { 100 };
            let found = run(&s, options(flow, steps), name);
            assert_eq!(found.x.len(), s.x.len());
            let last = found.reports.last().cloned().unwrap_or_default();
            println!(
                "{name}, {flow:?}, {:?}, {}, {:.6}, {:.1}",
                found.status,
                found.reports.len(),
                last.energy,
                last.min_angle_degrees
            );
        }
    }
}
