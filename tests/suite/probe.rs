//! A vertex looked at closely, circles, and lines of curvature.

use crate::support::surface;
use glam::DVec3;
use std::f64::consts::{PI, TAU};
use umbilic::app::{
    LookOptions, MAX_CIRCLES, Probe, RemeshOptions, SegmentKind, Session, edge_angle,
};
use umbilic::energy::circle::angle::Smoothing;
use umbilic::energy::circle::{Boundary, CircleEnergy};
use umbilic::flow::options::FlowOptions;
use umbilic::flow::spec::FlowName;
use umbilic::geometry::measure;
use umbilic::mesh::shape;
use umbilic::operator::fitted::principal::{Principal, aligned_edges, principal_directions};
use umbilic::remesh::adaptive::Kind;

fn session(name: &str, values: &[(&str, f64)], boundary: Boundary) -> Session {
    let values: Vec<(String, f64)> = values.iter().map(|(n, v)| ((*n).to_owned(), *v)).collect();
    let mut session = Session::new();
    session.sample(name, &values).expect("a sample");
    let options = FlowOptions {
        boundary: Some(boundary),
        ..FlowOptions::default()
    };
    session.configure(options).expect("options");
    session
}

fn probe(session: &Session, vertex: u32) -> Option<Probe> {
    let options = LookOptions {
        probe: Some(vertex),
        ..LookOptions::default()
    };
    session.look(options).expect("a mesh").probe
}

fn all(session: &Session) -> Vec<Probe> {
    (0..).map_while(|v| probe(session, v)).collect()
}

#[test]
fn vertices_add_up_to_the_surface() {
    for (name, boundary) in [
        ("icosahedron", Boundary::Clamped),
        ("torus", Boundary::Clamped),
        ("pipe", Boundary::Clamped),
        ("pipe", Boundary::Free),
        ("moebius", Boundary::Free),
    ] {
        let level = [("level", 1.0)];
        let few = if name == "icosahedron" || name == "pipe" {
            &level[..]
        } else {
            &[]
        };
        let session = session(name, few, boundary);
        let (probes, info) = (all(&session), session.info().expect("a mesh"));
        assert_eq!(probes.len(), info.vertices);
        // Less the W of vertices at infinity, Σβ₃ − 2π a loop.
        let turns: f64 = probes.iter().filter_map(|p| p.turn).sum();
        let loops = if boundary == Boundary::Free {
            info.boundary_loops
        } else {
            0
        };
        let infinity = turns - TAU * loops as f64;
        let energy: f64 = probes.iter().filter_map(|p| p.energy).sum();
        let whole = session.energy(boundary, &[]).expect("energies").circle;
        assert!(
            (energy + infinity - whole).abs() < 1e-10 * whole,
            "{name}: {energy} {whole}"
        );
        let defect: f64 = probes.iter().map(|p| p.defect).sum();
        let euler = TAU * info.euler_characteristic as f64;
        assert!((defect - euler).abs() < 1e-10, "{name}: {defect} {euler}");
        let area: f64 = probes.iter().map(|p| p.area).sum();
        assert!((area / info.area - 1.0).abs() < 1e-13, "{name}: {area}");
        for p in &probes {
            let angles: f64 = p.edges.iter().filter_map(|e| e.beta).chain(p.turn).sum();
            assert!((p.sum - angles).abs() < 1e-12);
            // Each edge has one angle, seen from both ends.
            for e in &p.edges {
                let other = &probes[e.neighbour as usize].edges;
                let same = other
                    .iter()
                    .find(|o| o.neighbour == p.vertex)
                    .expect("the edge");
                assert_eq!((same.beta, same.length), (e.beta, e.length));
            }
        }
    }
}

#[test]
fn angles_are_those_of_the_energy() {
    for (name, boundary) in [("torus", Boundary::Clamped), ("pipe", Boundary::Fixed)] {
        let crate::support::Surface { mesh, x, .. } =
            surface(&shape::make(name, &[]).expect("a sample").soup);
        let energy = CircleEnergy::new(&mesh, boundary);
        let sum: f64 = mesh
            .edges()
            .map(|e| {
                let counts = mesh.ends(e).iter().filter(|v| energy.counts(**v)).count();
                counts as f64 * edge_angle(&mesh, &x, e, boundary).expect("an angle")
            })
            .sum();
        let turns: f64 = energy.corners()[energy.first_turn()..]
            .iter()
            .map(|c| {
                let [p, v, n] = c.v.map(|v| x[v as usize]);
                2.0 * umbilic::energy::circle::angle::corner_angle(p, v, n).beta
            })
            .sum();
        let whole = energy.value(&x, Smoothing::EXACT) + TAU * energy.n_counted() as f64;
        assert!(
            (sum + turns - whole).abs() < 1e-9,
            "{name}: {} {whole}",
            sum + turns
        );
    }
}

#[test]
fn circles_pass_through_their_corners() {
    let session = session("icosahedron", &[("level", 2.0)], Boundary::Clamped);
    let options = LookOptions {
        probe: Some(40),
        circles: true,
        ..LookOptions::default()
    };
    let look = session.look(options).expect("a mesh");
    let loaded = session.loaded().expect("a mesh");
    let circles = look.circles.expect("circles");
    assert_eq!((circles.drawn, circles.total), (320, 320));
    let at = |k: u32| {
        DVec3::from_array([0, 1, 2].map(|i| f64::from(loaded.positions[3 * k as usize + i])))
    };
    let ends: Vec<DVec3> = look
        .ends
        .chunks(6)
        .map(|e| DVec3::new(e[0].into(), e[1].into(), e[2].into()))
        .collect();
    assert_eq!(ends.len(), look.kinds.len());
    // 32 points each, the circles in the order of the triangles.
    for (points, corners) in ends.chunks(32).zip(loaded.triangles.chunks(3)) {
        let centre = points.iter().sum::<DVec3>() / 32.0;
        let radius = points[0].distance(centre);
        for p in corners.iter().map(|&v| at(v)).chain(points.iter().copied()) {
            assert!((p.distance(centre) / radius - 1.0).abs() < 1e-5);
        }
    }
    let count = |kind| look.kinds.iter().filter(|k| **k == kind as u8).count();
    let valence = look.probe.as_ref().expect("a vertex").edges.len();
    assert_eq!(count(SegmentKind::Spoke), valence);
    assert_eq!(count(SegmentKind::ProbedCircle), 96 * valence);
    assert_eq!(count(SegmentKind::Circle), 32 * 320);
}

#[test]
fn of_many_circles_a_part_is_drawn_and_told() {
    let session = session("icosahedron", &[("level", 5.0)], Boundary::Clamped);
    let options = LookOptions {
        circles: true,
        ..LookOptions::default()
    };
    let circles = session
        .look(options)
        .expect("a mesh")
        .circles
        .expect("circles");
    assert_eq!(circles.total, 20_480);
    assert!(circles.drawn <= MAX_CIRCLES && circles.drawn > MAX_CIRCLES / 2);
    assert!(probe(&session, 1_000_000).is_none(), "no such vertex");
}

#[test]
fn curvatures_are_those_of_the_flow() {
    let session = session("torus", &[], Boundary::Clamped);
    for (name, of) in [
        (
            "mean-curvature",
            (|p| p.mean_curvature) as fn(&Probe) -> f64,
        ),
        ("gauss-curvature", |p| p.gauss_curvature),
        ("willmore", |p| p.energy.expect("counted")),
    ] {
        let field = session.field(name).expect("a field").expect("values");
        for v in [0, 17, 500] {
            let found = of(&probe(&session, v).expect("a vertex"));
            let value = f64::from(field.values[v as usize]);
            assert!(
                (found - value).abs() < 1e-6 * value.abs().max(1.0),
                "{name} {found} {value}"
            );
        }
    }
}

#[test]
fn what_the_boundary_lacks_is_left_out() {
    let clamped = session("pipe", &[("level", 1.0)], Boundary::Clamped);
    let free = session("pipe", &[("level", 1.0)], Boundary::Free);
    let (clamped, free) = (all(&clamped), all(&free));
    let mut seen = 0;
    for (c, f) in clamped.iter().zip(&free).filter(|(c, _)| c.boundary) {
        assert!(c.energy.is_none() && c.turn.is_none());
        assert!(c.edges.iter().all(|e| e.beta.is_none() == e.boundary));
        assert!(f.edges.iter().all(|e| e.beta.is_some()) && f.turn.is_some());
        assert!((f.energy.expect("counted") - (f.sum - TAU)).abs() < 1e-15);
        // β₂ = π − the angle opposite: in (0, π).
        let beta = f.edges.iter().find(|e| e.boundary).and_then(|e| e.beta);
        assert!(beta.is_some_and(|b| b > 0.0 && b < PI));
        seen += 1;
    }
    assert!(seen > 10);
}

/// Largest error of curvatures, and of the angle of directions, at vertices that `inner` keeps.
fn errors(
    name: &str,
    values: &[(&str, f64)],
    exact: impl Fn(DVec3) -> Option<([f64; 2], DVec3)>,
) -> [f64; 2] {
    let values: Vec<(String, f64)> = values.iter().map(|(n, v)| ((*n).to_owned(), *v)).collect();
    let crate::support::Surface { mesh, x, .. } =
        surface(&shape::make(name, &values).expect("a sample").soup);
    let found = principal_directions(&mesh, &x, |_| true);
    let mut worst = [0.0f64; 2];
    let mut counted = 0;
    for v in mesh.vertices().filter(|&v| !mesh.is_boundary_vertex(v)) {
        let (Some(p), Some((curvatures, first))) = (found[v.index()], exact(x[v.index()])) else {
            continue;
        };
        counted += 1;
        let Principal {
            curvatures: [a, b],
            directions: [d, e],
            normal,
        } = p;
        assert!(
            d.dot(e).abs() < 1e-14 && d.dot(normal).abs() < 1e-14 && e.dot(normal).abs() < 1e-14
        );
        let off = (a - curvatures[0]).abs().max((b - curvatures[1]).abs());
        worst[0] = worst[0].max(off);
        worst[1] = worst[1].max(d.cross(first).length());
    }
    assert!(counted > 50, "{name}: {counted}");
    worst
}

fn converges(
    name: &str,
    sizes: [&[(&str, f64)]; 2],
    exact: impl Fn(DVec3) -> Option<([f64; 2], DVec3)>,
    order: f64,
) {
    let [coarse, fine] = sizes.map(|values| errors(name, values, &exact));
    for (what, k) in [("curvatures", 0), ("directions", 1)] {
        let found = (coarse[k] / fine[k]).log2();
        println!(
            "{name}, {what}: {:.2e} {:.2e}, order {found:.2}",
            coarse[k], fine[k]
        );
        assert!(
            fine[k] < 1e-12 || found > order,
            "{name}, {what}: order {found}"
        );
    }
}

#[test]
fn principal_directions_of_a_torus_converge() {
    // About z; radii 1 and 0.35: curvatures 1/r along meridians, cos θ/(R + r cos θ) along circles of latitude.
    let exact = |p: DVec3| {
        let (major, minor) = (1.0, 0.35);
        let ring = major * DVec3::new(p.x, p.y, 0.0).normalize();
        let normal = (p - ring) / minor;
        let latitude = DVec3::Z.cross(ring);
        let along = (p.x.hypot(p.y) - major) / minor;
        Some((
            [1.0 / minor, along / (major + minor * along)],
            latitude.cross(normal).normalize(),
        ))
    };
    let sizes: [&[_]; 2] = [
        &[("around", 48.0), ("tube", 24.0)],
        &[("around", 96.0), ("tube", 48.0)],
    ];
    converges("torus", sizes, exact, 1.8);
}

#[test]
fn principal_directions_of_a_cylinder_converge() {
    let sizes: [&[_]; 2] = [
        &[("around", 32.0), ("along", 12.0)],
        &[("around", 64.0), ("along", 24.0)],
    ];
    let exact = |p: DVec3| {
        // Well within: fits beside the boundary are one-sided.
        let radial = DVec3::new(p.x, p.y, 0.0);
        (p.z.abs() < 0.6).then(|| {
            (
                [1.0 / radial.length(), 0.0],
                DVec3::Z.cross(radial).normalize(),
            )
        })
    };
    converges("cylinder", sizes, exact, 1.8);
}

#[test]
fn principal_directions_of_an_ellipsoid_converge() {
    let (a, b, c) = (1.5, 1.0, 0.7);
    let exact = move |p: DVec3| {
        // Shape operator of F = x²/a² + …: the Hessian on the tangent plane over |∇F|.
        let weights = DVec3::new(2.0 / (a * a), 2.0 / (b * b), 2.0 / (c * c));
        let gradient = weights * p;
        let normal = gradient.normalize();
        let u = normal.any_orthonormal_vector();
        let v = normal.cross(u);
        let second = |s: DVec3, t: DVec3| (weights * s).dot(t) / gradient.length();
        let (uu, uv, vv) = (second(u, u), second(u, v), second(v, v));
        let (mean, half) = (0.5 * (uu + vv), 0.5 * (uu - vv));
        let radius = half.hypot(uv);
        let angle = 0.5 * uv.atan2(half);
        // Off the umbilics, where directions turn ever faster.
        (radius > 0.3 * mean).then(|| {
            (
                [mean + radius, mean - radius],
                angle.cos() * u + angle.sin() * v,
            )
        })
    };
    let sizes: [&[_]; 2] = [&[("level", 4.0)], &[("level", 5.0)]];
    // An irregular mesh: of first order.
    converges("ellipsoid", sizes, exact, 0.8);
}

#[test]
fn umbilics_have_no_directions() {
    for name in ["icosphere", "disk"] {
        let session = session(name, &[], Boundary::Clamped);
        let options = LookOptions {
            directions: true,
            ..LookOptions::default()
        };
        let look = session.look(options).expect("a mesh");
        let crosses = look.directions.expect("crosses");
        assert_eq!(
            (crosses.drawn, crosses.left_out),
            (0, crosses.total),
            "{name}"
        );
        assert_eq!(look.alignment.map(|a| a.edges), Some(0));
    }
}

#[test]
fn edges_along_lines_of_curvature_are_aligned() {
    let share = |name: &str| {
        let crate::support::Surface { mesh, x, .. } =
            surface(&shape::make(name, &[]).expect("a sample").soup);
        let at = principal_directions(&mesh, &x, |_| true);
        let (aligned, edges) = aligned_edges(&mesh, &x, &at, measure::bounding_diagonal(&x), 5.0);
        assert_eq!(edges, mesh.n_edges(), "{name}");
        aligned as f64 / edges as f64
    };
    // Two of three edges of the lattice follow lines of curvature, its diagonals do not.
    let aligned = share("clifford-torus");
    assert!((aligned - 2.0 / 3.0).abs() < 0.02, "{aligned}");
    assert!(share("lattice-torus") < 0.5);
}

#[test]
fn double_curves_are_drawn_where_they_are_asked_for() {
    let session = session("klein-bottle", &[], Boundary::Clamped);
    let look = |crossings| {
        let options = LookOptions {
            crossings,
            ..LookOptions::default()
        };
        session.look(options).expect("a mesh")
    };
    assert!(look(false).kinds.is_empty());
    let found = session.self_intersections().expect("a mesh").expect("few");
    let seen = look(true);
    // A segment for each pair of triangles that pass through each other.
    assert_eq!(seen.kinds.len(), found.pairs.len() / 2);
    assert_eq!(seen.ends.len(), 6 * seen.kinds.len());
    let drawn = SegmentKind::Crossing as u8;
    assert!(seen.kinds.len() > 50 && seen.kinds.iter().all(|kind| *kind == drawn));
}

/// Where what is picked lies, its number and how large edges are.
fn picked(session: &mut Session) -> (DVec3, u32, f64) {
    let look = session.frame().expect("a frame").look.expect("a look");
    let probe = look.probe.expect("a vertex");
    let longest = probe.edges.iter().map(|edge| edge.length);
    (
        DVec3::from_array(probe.position),
        probe.vertex,
        longest.fold(0.0, f64::max),
    )
}

#[test]
fn what_is_picked_stays_where_it_is_on_a_surface_that_is_remeshed() {
    let shape = [("around", 28.0), ("tube", 14.0), ("jitter", 0.25)];
    let mut session = session("sampled-torus", &shape, Boundary::Clamped);
    let still = FlowOptions {
        flow: FlowName::PWillmore,
        // So short a step that the surface stays where it is.
        tau: Some(1e-7),
        ..FlowOptions::default()
    };
    session.configure(still).expect("options");
    let mut others = 0;
    for vertex in [31, 110, 200, 300, 390] {
        session.reset().expect("the start");
        let options = LookOptions {
            probe: Some(vertex),
            ..LookOptions::default()
        };
        session.look_at(options).expect("a mesh");
        let (start, ..) = picked(&mut session);
        let mut passes = 0;
        for _ in 0..24 {
            let report = session.step().expect("a step").expect("none is at rest");
            passes += usize::from(report.pass.is_some());
            let (place, number, edge) = picked(&mut session);
            assert!(place.distance(start) < edge, "{vertex}: {place} {start}");
            others += usize::from(number != vertex);
        }
        assert!(passes > 0);
        // By hand too, and both ways back.
        let remeshed = RemeshOptions {
            kind: Kind::Isotropic,
            vertices: Some(700),
            ..RemeshOptions::default()
        };
        session.remesh(&remeshed).expect("a mesh");
        let (place, number, edge) = picked(&mut session);
        assert!(place.distance(start) < edge, "{vertex}: {place} {start}");
        others += usize::from(number != vertex);
        session.undo_edit().expect("undone");
        session.seek(0).expect("the start");
        let (place, _, edge) = picked(&mut session);
        assert!(place.distance(start) < edge, "{vertex}: {place} {start}");
    }
    assert!(others > 30, "its number is another: {others}");
    // Not on another surface.
    session.sample("icosahedron", &[]).expect("a sample");
    session.configure(FlowOptions::default()).expect("options");
    let look = session.frame().expect("a frame").look;
    assert!(look.is_none_or(|look| look.probe.is_none()));
}
