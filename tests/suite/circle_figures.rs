//! The outcomes of the figures of Bobenko & Schröder, 2005, with default settings and in
//! the paper's scheme.

use crate::support::*;
use glam::DVec3;
use umbilic::app::library::measure::{TorusFit, off_surface};
use umbilic::app::library::{FigureRun, figure};
use umbilic::energy::circle::angle::Smoothing;
use umbilic::energy::circle::{Boundary, CircleEnergy};
use umbilic::flow::Decision;
use umbilic::flow::options::{FlowOptions, Goal, Integrator, Scheme};
use umbilic::flow::{Status, StepReport};
use umbilic::geometry::{measure, quality};
use umbilic::mesh::shape::{self, Sample};
use umbilic::mesh::{Edge, HalfedgeMesh, Vertex};

/// A run: the reports, the last positions, the last verdict.
struct Run {
    surface: Surface,
    start: Vec<DVec3>,
    reports: Vec<StepReport>,
    verdict: Decision,
}

fn sample(name: &str, values: &[(&str, f64)]) -> Sample {
    let values: Vec<(String, f64)> = values.iter().map(|(n, v)| ((*n).to_owned(), *v)).collect();
    shape::make(name, &values).expect("a shape")
}

fn run(sample: &Sample, options: FlowOptions, steps: usize) -> Run {
    let mut surface = surface(&sample.soup);
    let options = FlowOptions {
        fixed: sample.fixed.clone(),
        free: sample.free.clone(),
        max_steps: Some(steps),
        ..options
    };
    let monotone = options.scheme == Scheme::Auto;
    let start = surface.x.clone();
    let mut flow = drive(&surface.mesh, &mut surface.x, options).expect("a flow");
    let mut reports = Vec::new();
    loop {
        let (report, verdict) = flow.step(&mut surface.x).expect("a step");
        if let Some(report) = report {
            if monotone {
                assert!(
                    report.objective <= report.objective_before,
                    "rise at {}",
                    report.step
                );
            }
            reports.push(report);
        }
        if verdict != Decision::GoOn {
            return Run {
                surface,
                start,
                reports,
                verdict,
            };
        }
    }
}

impl Run {
    /// W after step `k`; the last one if the run was over before.
    fn energy(&self, k: usize) -> f64 {
        self.reports[(k - 1).min(self.reports.len() - 1)].energy
    }

    fn status(&self) -> Status {
        match &self.verdict {
            Decision::Stop(status, _) => *status,
            Decision::GoOn | Decision::GivenUp => Status::Ready,
        }
    }
}

fn paper(tau: f64) -> FlowOptions {
    FlowOptions {
        scheme: Scheme::Paper,
        tau: Some(tau),
        ..FlowOptions::default()
    }
}

fn energy_of(sample: &Sample, boundary: Boundary) -> f64 {
    let surface = surface(&sample.soup);
    CircleEnergy::new(&surface.mesh, boundary).value(&surface.x, Smoothing::EXACT)
}

#[test]
fn figure_6_subdivided_icosahedron_to_a_sphere() {
    let icosahedron = sample("icosahedron", &[("level", 4.0)]);
    let start = energy_of(&icosahedron, Boundary::Free);
    assert!(
        (start - 60.0 * std::f64::consts::PI).abs() < 1e-10,
        "starts at {start}"
    );

    let expected = numbers(&reference("figure_6")["energy"]);
    let options = FlowOptions {
        dt: Some(0.0345),
        ..paper(1.0)
    };
    let found = run(&icosahedron, options, 24);
    for (k, expected) in expected.iter().enumerate().skip(1) {
        let error = (found.energy(k) - expected).abs();
        assert!(
            error < 1e-4 * expected + 1e-11,
            "step {k}: {}",
            found.energy(k)
        );
    }
    assert!(found.energy(24) <= 1e-7);

    let found = run(&icosahedron, FlowOptions::default(), 24);
    let steps = found
        .reports
        .iter()
        .position(|r| r.energy <= 1e-7)
        .map(|k| k + 1);
    println!("Figure 6: W ≤ 1e-7 after {steps:?} steps");
    assert!(steps.is_some_and(|s| s <= 12), "W = {}", found.energy(24));
    assert_eq!(found.status(), Status::Converged);
    let centre = found.surface.x.iter().sum::<DVec3>() / found.surface.x.len() as f64;
    let radii: Vec<f64> = found.surface.x.iter().map(|p| p.distance(centre)).collect();
    let mean = radii.iter().sum::<f64>() / radii.len() as f64;
    let off = radii
        .iter()
        .map(|r| (r / mean - 1.0).abs())
        .fold(0.0, f64::max);
    assert!(off < 1e-3, "off the sphere by {off}");
}

/// A little stretched, a latitude–longitude sphere has next to no energy, but every diagonal
/// of its quads has β = 0: exact steps do not move it.
#[test]
fn nearly_round_latitude_longitude_spheres_do_not_freeze() {
    for stretch in [1.01, 1.05, 1.2] {
        let mut sphere = sample("uv-sphere", &[]);
        sphere
            .soup
            .positions
            .iter_mut()
            .for_each(|p| p.z *= stretch);
        let start = energy_of(&sphere, Boundary::Free);
        let found = run(&sphere, FlowOptions::default(), 40);
        println!(
            "{stretch}: W {start:.3} → {:.1e} in {} steps",
            found.energy(40),
            found.reports.len()
        );
        assert!(found.energy(40) < 1e-7, "{stretch}: {}", found.energy(40));
        assert_eq!(found.status(), Status::Converged);
        let highest = found.reports.iter().map(|r| r.energy).fold(0.0, f64::max);
        assert!(highest <= 2.0 * start, "{stretch}: W rose to {highest}");
    }
}

#[test]
fn figure_6_by_every_integrator() {
    let icosahedron = sample("icosahedron", &[("level", 3.0)]);
    for (integrator, steps, bound) in [
        (Integrator::SemiImplicit, 20, 1e-7),
        (Integrator::Lbfgs, 60, 1e-7),
        (Integrator::BackwardEuler, 20, 1e-7),
        (Integrator::ForwardEuler, 60, 20.0),
    ] {
        let found = run(
            &icosahedron,
            FlowOptions {
                integrator,
                ..FlowOptions::default()
            },
            steps,
        );
        let last = found.energy(steps);
        println!(
            "{integrator:?}: W = {last:.3e} after {} steps",
            found.reports.len()
        );
        assert!(last <= bound, "{integrator:?} ends at {last}");
    }
}

#[test]
fn forward_euler_is_stable_below_its_limit_only() {
    let icosahedron = sample("icosahedron", &[("level", 3.0)]);
    let options = |tau| FlowOptions {
        integrator: Integrator::ForwardEuler,
        ..paper(tau)
    };
    let stable = run(&icosahedron, options(0.03), 60);
    assert!(stable.energy(60) < stable.energy(1));
    let unstable = run(&icosahedron, options(0.1), 60);
    assert!(unstable.energy(60) > 10.0 * stable.energy(60));
}

#[test]
fn figure_8_torus() {
    let torus = sample("coarse-torus", &[]);
    // 764.397: independent of the code, by inversion in `shapes`.
    assert!((energy_of(&torus, Boundary::Free) - 764.397).abs() < 1e-3);
    let found = run(&torus, FlowOptions::default(), 30);
    println!(
        "Figure 8: W = {:.2} (20), {:.2} (30)",
        found.energy(20),
        found.energy(30)
    );
    assert!(found.energy(20) < 80.0 && found.energy(30) < 70.0);
    let rms = TorusFit::of(&found.surface.x).off;
    println!("Figure 8: rms to the geometric torus {rms:.4}");

    let slow = run(&torus, paper(0.003), 20);
    println!(
        "Figure 8, τ = 0.003: W {:.1} (5), {:.1} (20)",
        slow.energy(5),
        slow.energy(20)
    );
    assert!(
        (slow.energy(5) / 341.0 - 1.0).abs() < 0.05,
        "{}",
        slow.energy(5)
    );
    assert!(
        (slow.energy(20) / 126.0 - 1.0).abs() < 0.05,
        "{}",
        slow.energy(20)
    );
    // Left alone for long, the flow rounds the torus, turns edges along lines of
    // curvature and then fattens it: R/r creeps from 2.13 towards √2.
    let mesh = &slow.surface.mesh;
    let before = share_along_curvature(mesh, &slow.start);
    let mut long = FigureRun::new(figure("circle-8-long").expect("a figure"));
    let finding = loop {
        if let Some(finding) = long.advance().expect("a step") {
            break finding;
        }
    };
    assert!(finding.ok, "{finding:?}");
    let end = long.session().positions().expect("positions");
    let end: Vec<DVec3> = (end.chunks_exact(3))
        .map(|p| DVec3::new(p[0].into(), p[1].into(), p[2].into()))
        .collect();
    let aligned = share_along_curvature(mesh, &end);
    println!("Figure 8, τ = 0.003, 1000 steps: aligned {before:.3} → {aligned:.3}, {finding:?}");
    assert!(
        before < 0.28 && aligned > 0.38,
        "edges along curvature: {before} → {aligned}"
    );
}

/// Share of the edges within 5° of a line of curvature of the torus of revolution about z
/// that fits best: of a circle of latitude or of a meridian.
fn share_along_curvature(mesh: &HalfedgeMesh, x: &[DVec3]) -> f64 {
    let centre = x.iter().sum::<DVec3>() / x.len() as f64;
    let major = TorusFit::of(x).major;
    let along = |e: &Edge| {
        let [a, b] = mesh.ends(*e).map(|v| x[v.index()] - centre);
        let middle = 0.5 * (a + b);
        let outward = DVec3::new(middle.x, middle.y, 0.0).normalize();
        let latitude = DVec3::Z.cross(outward);
        let normal = (middle - major * outward).normalize();
        let meridian = latitude.cross(normal);
        let edge = b - a;
        let edge = edge - edge.dot(normal) * normal;
        let angle = edge.dot(latitude).abs().atan2(edge.dot(meridian).abs());
        angle.min(std::f64::consts::FRAC_PI_2 - angle) < 5f64.to_radians()
    };
    mesh.edges().filter(along).count() as f64 / mesh.n_edges() as f64
}

#[test]
fn figure_9_pipe() {
    let pipe = sample("pipe", &[]);
    // Σ W_i over interior vertices, and with the loops closed.
    assert!((energy_of(&pipe, Boundary::Clamped) - 398.650).abs() < 1e-3);
    assert!((energy_of(&pipe, Boundary::Fixed) - 430.564).abs() < 1e-3);
    let clamped = run(&pipe, FlowOptions::default(), 50);
    // 506 → 245, 208, 182 where edges to the boundary count twice: a constant 107.8 more.
    println!(
        "Figure 9: clamped {:.1} {:.1} {:.1}",
        clamped.energy(5),
        clamped.energy(20),
        clamped.energy(50)
    );
    assert!(clamped.energy(5) < 150.0);
    let options = FlowOptions {
        boundary: Some(Boundary::Fixed),
        ..FlowOptions::default()
    };
    let fixed = run(&pipe, options, 50);
    println!(
        "Figure 9: fixed {:.1} {:.1} {:.1}",
        fixed.energy(5),
        fixed.energy(20),
        fixed.energy(50)
    );
    assert!(fixed.energy(5) < 155.0 && fixed.energy(50) < 52.0);
    for found in [&clamped, &fixed] {
        for v in found
            .surface
            .mesh
            .vertices()
            .filter(|&v| found.surface.mesh.is_boundary_vertex(v))
        {
            assert_eq!(
                found.surface.x[v.index()],
                found.start[v.index()],
                "boundary moved"
            );
        }
    }
}

#[test]
fn figure_10_six_sided_hole_is_not_frozen() {
    let hole = sample("six-sided-hole", &[]);
    let start = energy_of(&hole, Boundary::Clamped);
    let found = run(&hole, FlowOptions::default(), 100);
    println!(
        "Figure 10: {start:.2} → {:.2} (10), {:.2} (100)",
        found.energy(10),
        found.energy(100)
    );
    assert!(
        found.energy(10) < start - 5.0,
        "frozen at {}",
        found.energy(10)
    );
    // The exact energy with a monotone line search does freeze there.
    let exact = FlowOptions {
        epsilon: 0.0,
        ..FlowOptions::default()
    };
    let frozen = run(&hole, exact, 100);
    println!(
        "Figure 10, exact: {:.2}",
        frozen.reports.last().map_or(start, |r| r.energy)
    );
    // The harmonic pre-fill is a smooth start for the same end.
    let filled = run(
        &hole,
        FlowOptions {
            prefill: true,
            ..FlowOptions::default()
        },
        100,
    );
    println!("Figure 10, pre-filled: {:.2}", filled.energy(100));
    assert!(filled.energy(100) < start - 40.0);
}

#[test]
fn figure_11_scar_is_gone_in_20_steps() {
    let scar = sample("scar", &[]);
    let clean = sample("scar", &[("depth", 0.0)]);
    let found = run(&scar, FlowOptions::default(), 20);
    let same = run(&clean, FlowOptions::default(), 20);
    let h = measure::mean_edge_length(&found.surface.mesh, &found.start);
    let free = scar.free.as_ref().expect("a selection");
    let is_free = |v: usize| free.contains(&(v as u32));
    let rms = |a: &[DVec3], b: &[DVec3]| off_surface(a, &same.surface.mesh, b, is_free) / h;
    let before = rms(&found.start, &same.start);
    let after = rms(&found.surface.x, &same.surface.x);
    println!(
        "Figure 11: W {:.3} → {:.3}, undamaged → {:.3}; apart {before:.3} h → {after:.4} h",
        energy_of(&scar, Boundary::Clamped),
        found.energy(20),
        same.energy(20)
    );
    assert!(after < 0.4 * before, "{after} of {before}");
    assert!((found.energy(20) / same.energy(20) - 1.0).abs() < 0.02);
}

#[test]
fn figure_12_scan_is_smoothed() {
    let scan = sample("scan", &[]);
    let clean = sample("scan-clean", &[]);
    let mut error = Vec::new();
    for steps in [10, 100] {
        let options = FlowOptions {
            goal: Goal::Smooth,
            smooth_steps: steps,
            tau: Some(0.01),
            boundary: Some(Boundary::Fixed),
            ..FlowOptions::default()
        };
        let found = run(&scan, options, steps);
        let mesh = &found.surface.mesh;
        let h = measure::mean_edge_length(mesh, &found.start);
        let rms = |x: &[DVec3]| {
            let is_inner = |v: usize| !mesh.is_boundary_vertex(Vertex(v as u32));
            off_surface(x, mesh, &clean.soup.positions, is_inner) / h
        };
        let turned = quality::newly_folded(mesh, &found.start, &found.surface.x).len();
        let moved = found.reports.last().expect("steps").max_displacement;
        println!(
            "Figure 12: {steps} steps: W {:.0}, error {:.4} h → {:.4} h, {turned} of {} faces turned, moved {moved:.2} h",
            found.energy(steps),
            rms(&found.start),
            rms(&found.surface.x),
            mesh.n_faces()
        );
        assert!(found.reports.len() == steps && moved < 2.0);
        assert!(turned as f64 <= 0.001 * mesh.n_faces() as f64);
        error.push((rms(&found.start), rms(&found.surface.x)));
    }
    // Ten steps take the noise; a hundred begin to take the face's own features, whose
    // quads are far from a minimum of W themselves.
    assert!(error[0].1 < 0.7 * error[0].0, "ten steps: {error:?}");
    assert!(error[1].1 < 1.5 * error[1].0, "a hundred steps: {error:?}");
}

#[test]
fn one_sided_surfaces_flow() {
    let klein = Sample::from(soup_of(&reference("closed_klein")));
    let moebius = sample("moebius", &[]);
    for (name, one_sided, boundary) in [
        ("Klein bottle", &klein, Boundary::Free),
        ("Möbius strip", &moebius, Boundary::Free),
        ("Möbius strip", &moebius, Boundary::Clamped),
    ] {
        let start = energy_of(one_sided, boundary);
        let options = FlowOptions {
            boundary: Some(boundary),
            ..FlowOptions::default()
        };
        let found = run(one_sided, options, 20);
        assert!(!found.surface.mesh.is_oriented());
        println!("{name}: {start:.2} → {:.2}", found.energy(20));
        assert!(
            found.energy(20) < 0.6 * start,
            "{name} {boundary:?}: {}",
            found.energy(20)
        );
    }
}

/// Figure 7, on the paper's own mesh.
#[test]
fn figure_7_cat_head() {
    let Some(cat) = real("cat_head.obj") else {
        return;
    };
    let cat = Sample::from(cat.mesh.to_soup(&cat.x));
    let at = |boundary| FlowOptions {
        boundary,
        ..FlowOptions::default()
    };
    assert!((energy_of(&cat, Boundary::Free) - 112.44949640).abs() < 1e-7);
    assert!((energy_of(&cat, Boundary::Clamped) - 94.34853072).abs() < 1e-7);

    let free = run(&cat, at(Some(Boundary::Free)), 100);
    println!(
        "Figure 7: free {:.2} (5) {:.2} (20) {:.2e} (100)",
        free.energy(5),
        free.energy(20),
        free.energy(100)
    );
    assert!(free.energy(5) < 25.0 && free.energy(20) < 12.0 && free.energy(100) < 1e-6);
    let (mesh, x) = (&free.surface.mesh, &free.surface.x);
    let normal = mesh
        .faces()
        .map(|f| measure::face_vector_area(mesh, x, f))
        .sum::<DVec3>()
        .normalize();
    let size = measure::bounding_diagonal(x);
    let off = x
        .iter()
        .map(|p| (*p - x[0]).dot(normal).abs())
        .fold(0.0, f64::max)
        / size;
    assert!(off < 1e-6, "not planar: {off}");
    // Convex: the boundary turns by 2π in all and nowhere back.
    let energy = CircleEnergy::new(mesh, Boundary::Free);
    let at_infinity =
        energy.value(x, Smoothing::EXACT) - energy.vertex_energies(x).iter().sum::<f64>();
    assert!(
        at_infinity.abs() < 1e-6,
        "boundary not convex: {at_infinity}"
    );

    let clamped = run(&cat, at(Some(Boundary::Clamped)), 200);
    println!(
        "Figure 7: clamped {:.2} (20) {:.2} (200)",
        clamped.energy(20),
        clamped.energy(200)
    );
    assert!(clamped.energy(20) < 17.0 && clamped.energy(200) < 14.0);
    let constant = run(
        &cat,
        FlowOptions {
            boundary: Some(Boundary::Free),
            ..paper(0.01)
        },
        100,
    );
    for (k, expected) in [(10, 32.35), (50, 15.64), (100, 11.60)] {
        assert!(
            (constant.energy(k) / expected - 1.0).abs() < 1e-3,
            "{k}: {}",
            constant.energy(k)
        );
    }
}
