//! Volume-preserving mean-curvature flow, dx/dt = 2(H̄ − H)n with H̄ the mean of H by area:
//! Huisken, The volume preserving mean curvature flow, 1987.

use crate::support::*;
use glam::DVec3;
use std::f64::consts::PI;
use umbilic::app::library::measure::off_sphere;
use umbilic::app::{RemedyId, Session};
use umbilic::flow::constraint::Kept;
use umbilic::flow::options::FlowOptions;
use umbilic::flow::spec::FlowName;
use umbilic::flow::{Advice, Decision, Driver, FlowError, Reason, Status, StepReport};
use umbilic::geometry::measure;
use umbilic::io::Format;
use umbilic::mesh::shape;
use umbilic::remesh::Mode;
use umbilic::soup::PolygonSoup;

/// How far the volume may be from that at the start, as a share of it.
const KEPT: f64 = 1e-10;
/// A ratio of integrals in double precision.
const ROUNDOFF: f64 = 1e-12;

fn sample(name: &str, values: &[(&str, f64)]) -> Surface {
    let values: Vec<(String, f64)> = values.iter().map(|(n, v)| ((*n).to_owned(), *v)).collect();
    surface(&shape::make(name, &values).expect("a shape").soup)
}

/// The ellipsoid of revolution with semi-axes 2, 1, 1.
fn spheroid(level: f64) -> Surface {
    let values = [("a", 2.0), ("b", 1.0), ("c", 1.0), ("level", level)];
    sample("ellipsoid", &values)
}

fn options() -> FlowOptions {
    FlowOptions {
        flow: FlowName::VolumePreserving,
        max_steps: Some(400),
        ..FlowOptions::default()
    }
}

fn volume(s: &Surface, x: &[DVec3]) -> f64 {
    measure::volume(&s.mesh, x).expect("closed")
}

/// 36πV²/A³, at most 1, and 1 of a round sphere only.
fn isoperimetric(s: &Surface, x: &[DVec3]) -> f64 {
    36.0 * PI * volume(s, x).powi(2) / measure::area(&s.mesh, x).powi(3)
}

struct Run {
    x: Vec<DVec3>,
    reports: Vec<StepReport>,
    status: Status,
    reason: Option<Reason>,
}

/// A whole run, and what holds in each step of any: the volume stays, the area does not rise, and
/// so the isoperimetric ratio does not fall.
fn run(s: &Surface, options: FlowOptions) -> Run {
    let mut x = s.x.clone();
    let mut flow = drive(&s.mesh, &mut x, options).expect("a flow");
    let first = volume(s, &x);
    let mut ratio = isoperimetric(s, &x);
    let mut reports: Vec<StepReport> = Vec::new();
    loop {
        let before = measure::area(&s.mesh, &x);
        let (report, decision) = flow.step(&mut x).expect("a step");
        let drift = (volume(s, &x) / first - 1.0).abs();
        assert!(
            drift <= KEPT,
            "step {}: volume {drift:e} off",
            reports.len()
        );
        let area = measure::area(&s.mesh, &x);
        assert!(area <= before * (1.0 + ROUNDOFF), "{before} {area}");
        let now = isoperimetric(s, &x);
        assert!(now >= ratio * (1.0 - 2.0 * KEPT), "{ratio} {now}");
        ratio = now;
        reports.extend(report);
        if let Decision::Stop(status, reason) = decision {
            let reason = Some(reason);
            return Run {
                x,
                reports,
                status,
                reason,
            };
        }
    }
}

/// The part of ρ = 1 + aP₂ that vertices near the unit sphere have, spread evenly, a.
fn second_harmonic(x: &[DVec3]) -> f64 {
    let p2 = |p: &DVec3| 1.5 * p.normalize().z.powi(2) - 0.5;
    let of: f64 = x.iter().map(|p| p.length() * p2(p)).sum();
    of / x.iter().map(|p| p2(p).powi(2)).sum::<f64>()
}

#[test]
fn small_bumps_are_no_rest() {
    // Of 0.4 % of the radius, a twentieth of an edge; and of 2 % in short steps of constant size.
    for (bump, dt) in [(0.004, None), (0.02, Some(0.001))] {
        let mut s = sample("icosphere", &[("level", 4.0)]);
        let round = second_harmonic(&s.x);
        for p in &mut s.x {
            let z = p.z;
            *p *= 1.0 + bump * (1.5 * z * z - 0.5);
        }
        let before = second_harmonic(&s.x) - round;
        assert!((before / bump - 1.0).abs() < 0.02, "{before}");
        let run = run(
            &s,
            FlowOptions {
                dt,
                max_steps: Some(4000),
                ..options()
            },
        );
        let left = (second_harmonic(&run.x) - round) / before;
        let steps = run.reports.len();
        assert_eq!(run.status, Status::Converged, "{bump}, {steps} steps");
        assert!(left.abs() < 0.05, "{bump}: {left} after {steps} steps");
    }
}

#[test]
fn a_sphere_is_at_rest() {
    let s = sample("icosphere", &[("level", 3.0)]);
    let found = run(&s, options());
    assert_eq!(found.status, Status::Converged, "{:?}", found.reason);
    // Vertices may slide along it.
    let off = found.x.iter().map(|p| (p.length() - 1.0).abs());
    let off = off.fold(0.0, f64::max);
    println!("{} steps, off by {off:.1e}", found.reports.len());
    assert!(off < 2e-3, "{off}");
}

/// The radius is that of the ball of the mesh's own volume, up to what the mesh of a sphere is
/// smaller than its sphere by.
#[test]
fn an_ellipsoid_becomes_the_sphere_of_its_volume() {
    let s = spheroid(3.0);
    let found = run(&s, options());
    assert_eq!(found.status, Status::Converged, "{:?}", found.reason);
    let round = sample("icosphere", &[("level", 3.0)]);
    let share = isoperimetric(&s, &found.x) / isoperimetric(&round, &round.x);
    let first = isoperimetric(&s, &s.x);
    let radius = (3.0 * volume(&s, &s.x) / (4.0 * PI)).cbrt();
    let n = found.x.len() as f64;
    let centre = found.x.iter().sum::<DVec3>() / n;
    let mean = found.x.iter().map(|p| p.distance(centre)).sum::<f64>() / n;
    let off = off_sphere(&found.x);
    println!(
        "{} steps, ratio {first:.4} to {share:.6} of the sphere's, radius {mean:.5} for {radius:.5}, off {off:.2e}",
        found.reports.len()
    );
    assert!(share >= 0.99, "{share}");
    assert!((mean / radius - 1.0).abs() < 6e-3, "{mean} {radius}");
    assert!(off < 5e-3, "{off}");
}

/// H of the spheroid: w³(Σa² − |x|²)/(2(abc)²) with 1/w² = Σ x²/a⁴; and its mean by area.
fn speed(p: DVec3) -> (DVec3, f64) {
    let axes = DVec3::new(2.0, 1.0, 1.0);
    let squares = axes * axes;
    let mean_curvature = |p: DVec3| {
        let w = 1.0 / (p / squares).length();
        w.powi(3) * (squares.element_sum() - p.length_squared()) / (2.0 * squares.element_product())
    };
    // By the midpoint rule along a meridian, of order two, beyond any mesh here.
    let (mut integral, mut area) = (0.0, 0.0);
    let rings = 2000;
    for k in 0..rings {
        let (sin, cos) = (PI * (f64::from(k) + 0.5) / f64::from(rings)).sin_cos();
        let strip = sin * DVec3::new(axes.x * sin, axes.y * cos, 0.0).length();
        integral += strip * mean_curvature(DVec3::new(axes.x * cos, axes.y * sin, 0.0));
        area += strip;
    }
    let normal = (p / squares).normalize();
    (normal, 2.0 * (integral / area - mean_curvature(p)))
}

/// At a time so short that a step is the velocity, on finer and finer meshes: the velocity itself
/// in the mean square, and the fall of the area, dA/dt = −4∫(H − H̄)² dA.
#[test]
fn the_velocity_converges_to_that_of_a_spheroid() {
    let errors = [2.0, 3.0, 4.0, 5.0].map(|level| {
        let s = spheroid(level);
        let mut x = s.x.clone();
        let short = FlowOptions {
            dt: Some(1e-7),
            regularise: Mode::Off,
            ..options()
        };
        let mut flow = drive(&s.mesh, &mut x, short).expect("a flow");
        let (report, _) = flow.step(&mut x).expect("a step");
        let dt = report.expect("a step").dt;
        let areas = measure::vertex_areas(&s.mesh, &s.x);
        let (mut error, mut size) = (0.0, 0.0);
        for ((p, q), area) in s.x.iter().zip(&x).zip(&areas) {
            let (normal, exact) = speed(*p);
            error += area * ((*q - *p).dot(normal) / dt - exact).powi(2);
            size += area * exact.powi(2);
        }
        let fall = (measure::area(&s.mesh, &s.x) - measure::area(&s.mesh, &x)) / dt;
        [(error / size).sqrt(), (fall / size - 1.0).abs()]
    });
    let orders = [0, 1].map(|k| (errors[2][k] / errors[3][k]).log2());
    println!("relative errors {errors:.5?}, orders {orders:.2?}");
    assert!(orders[0] > 0.95 && orders[1] > 1.8, "{errors:?}");
    assert!(errors[3][0] < 0.02 && errors[3][1] < 2e-3, "{errors:?}");
}

#[test]
fn the_unit_of_time_and_of_length_agree() {
    let s = spheroid(2.0);
    let times = [1.0, 10.0].map(|scale: f64| {
        let large = Surface {
            mesh: s.mesh.clone(),
            x: s.x.iter().map(|p| scale * *p).collect(),
            repairs: Vec::new(),
        };
        let found = run(&large, options());
        found.reports.last().expect("steps").time / scale.powi(2)
    });
    assert!((times[0] / times[1] - 1.0).abs() < 1e-6, "{times:?}");
}

/// Two balls of radius 1 and a neck of radius `neck` between them, turned about the x axis.
fn two_balls(neck: f64) -> PolygonSoup {
    const ALONG: usize = 80;
    const AROUND: usize = 24;
    const END: f64 = 2.8;
    let mut soup = PolygonSoup::default();
    soup.positions.push(DVec3::new(-END, 0.0, 0.0));
    for i in 1..ALONG {
        let t = -(PI * i as f64 / ALONG as f64).cos();
        let x = END * (0.5 * t + 0.5 * (2.0 * i as f64 / ALONG as f64 - 1.0));
        let ball = (1.0 - (x.abs() - END + 1.0).powi(2)).max(0.0);
        let r = (ball + neck.powi(2) * (1.0 - (x / END).powi(2))).sqrt();
        for k in 0..AROUND {
            let (sin, cos) = (2.0 * PI * k as f64 / AROUND as f64).sin_cos();
            soup.positions.push(DVec3::new(x, r * cos, r * sin));
        }
    }
    soup.positions.push(DVec3::new(END, 0.0, 0.0));
    let last = soup.positions.len() as u32 - 1;
    let at = |i: usize, k: usize| (1 + (i - 1) * AROUND + k % AROUND) as u32;
    for k in 0..AROUND {
        soup.push_face(&[0, at(1, k), at(1, k + 1)]);
        soup.push_face(&[last, at(ALONG - 1, k + 1), at(ALONG - 1, k)]);
        for i in 1..ALONG - 1 {
            soup.push_face(&[at(i, k), at(i + 1, k), at(i + 1, k + 1)]);
            soup.push_face(&[at(i, k), at(i + 1, k + 1), at(i, k + 1)]);
        }
    }
    soup
}

/// The neck bends more than the mean; a wide one opens.
#[test]
fn a_thin_neck_pinches_and_a_wide_one_does_not() {
    let found = run(&surface(&two_balls(0.2)), options());
    println!(
        "{:?} {:?} after {} steps",
        found.status,
        found.reason,
        found.reports.len()
    );
    assert_eq!(found.status, Status::Singular);
    let Some(Reason::PinchedNeck { place, advice, .. }) = found.reason else {
        panic!("{:?}", found.reason)
    };
    // To keep the volume is no advice here.
    assert_eq!(advice, Advice::FinerMesh);
    assert!(place[0].abs() < 0.5, "{place:?}");
    let found = run(&surface(&two_balls(0.7)), options());
    println!("{:?} after {} steps", found.status, found.reports.len());
    assert_eq!(found.status, Status::Converged, "{:?}", found.reason);
    assert!(off_sphere(&found.x) < 5e-3, "{}", off_sphere(&found.x));
}

/// The hole of a torus so thick closes, with all the vertices around it that it began with: rings of
/// short edges, far apart.
#[test]
fn the_hole_of_a_thick_torus_closes() {
    let soup = sample("torus", &[("major", 1.0), ("minor", 0.7)]);
    let found = run(&soup, options());
    let Some(Reason::PinchedNeck { place, .. }) = found.reason else {
        panic!("{:?}", found.reason)
    };
    assert_eq!(found.status, Status::Singular);
    assert!(DVec3::from(place).length() < 0.05, "{place:?}");
}

/// What is offered is something else than to keep the volume.
#[test]
fn of_a_neck_that_pinches_the_reason_is_found() {
    let bytes = umbilic::io::write(&two_balls(0.2), Format::Obj, "").expect("OBJ");
    let mut session = Session::new();
    session.load(&bytes, "balls.obj").expect("a surface");
    session.configure(options()).expect("a flow");
    session.run(200).expect("steps");
    let found = session.why().expect("a mesh").expect("a reason");
    assert_eq!(found.kind, "Pinch", "{}", found.message);
    let offered: Vec<RemedyId> = found.remedies.iter().map(|remedy| remedy.id).collect();
    assert_eq!(offered, [RemedyId::Back, RemedyId::Regularise]);
}

/// With p = 0 and the volume kept, to the last bit; area and volume are those of the curved faces.
#[test]
fn on_quadrilaterals_it_is_the_p_willmore_flow_with_p_0() {
    let Some(folder) = shared_meshes() else {
        return;
    };
    let bytes = std::fs::read(folder.join("spot_quadrangulated.obj")).expect("a mesh");
    let soup = umbilic::io::read(&bytes, "quads.obj")
        .expect("readable")
        .soup;
    let quads = surface(&soup);
    let triangles = surface(&soup.triangulated());
    let p_willmore = FlowOptions {
        flow: FlowName::PWillmore,
        p: 0.0,
        keep: vec![Kept::Volume],
        ..options()
    };
    let ends = [options(), p_willmore].map(|options| {
        let mut x = quads.x.clone();
        let flow = Driver::start(&triangles.mesh, &quads.mesh, &mut x, options);
        let mut flow = flow.expect("a flow");
        let start = flow.reading(&x);
        let flat = measure::area(&triangles.mesh, &x);
        assert!((start.area / flat - 1.0).abs() > 1e-6, "{flat}");
        let mut area = start.area;
        for _ in 0..10 {
            let (report, _) = flow.step(&mut x).expect("a step");
            let report = report.expect("a step");
            let drift = report.volume.expect("closed") / start.volume.expect("closed") - 1.0;
            assert!(drift.abs() <= KEPT, "{drift:e}");
            assert!(report.area < area, "{} {area}", report.area);
            area = report.area;
        }
        assert!(area < 0.97 * start.area, "{} {area}", start.area);
        x
    });
    assert_eq!(ends[0], ends[1]);
}

/// Options of the p-Willmore flow that were set before change nothing.
#[test]
fn what_the_flow_does_not_read_is_of_no_consequence() {
    let s = spheroid(2.0);
    let other = FlowOptions {
        p: 4.0,
        keep: Vec::new(),
        tension: 7.0,
        reduced_volume: Some(0.5),
        ..options()
    };
    assert_eq!(run(&s, options()).x, run(&s, other).x);
}

#[test]
fn open_and_one_sided_surfaces_are_refused() {
    for (name, is_open) in [("hemisphere", true), ("klein-bottle", false)] {
        let s = sample(name, &[]);
        let refused = drive(&s.mesh, &mut s.x.clone(), options()).err();
        let expected = match &refused {
            Some(FlowError::NotClosed { loops }) => is_open && *loops == 1,
            Some(FlowError::NotOriented) => !is_open,
            _ => false,
        };
        assert!(expected, "{name}: {refused:?}");
    }
}
