//! Möbius inversion: what it leaves, what it changes, what it refuses.

use crate::support::{Surface, surface};
use glam::DVec3;
use umbilic::app::{FieldName, LookOptions, Session};
use umbilic::energy::circle::angle::Smoothing;
use umbilic::energy::circle::{Boundary, CircleEnergy};
use umbilic::energy::p_willmore::integrated_power;
use umbilic::flow::options::FlowOptions;
use umbilic::geometry::inversion::{Inversion, distance_to_surface};
use umbilic::geometry::measure;
use umbilic::mesh::shape;

fn sample(name: &str) -> Surface {
    surface(&shape::make(name, &[]).expect("a sample").soup)
}

/// Points of a low-discrepancy sequence in [−1, 1]³.
fn spread() -> impl Iterator<Item = DVec3> {
    let g = 1.220_744_084_605_759_5;
    let steps = DVec3::new(1.0 / g, 1.0 / (g * g), 1.0 / (g * g * g));
    (1..).map(move |k| 2.0 * (f64::from(k) * steps).fract() - 1.0)
}

/// Centres around and within the surface, no nearer to it than `least` diagonals.
fn centres(surface: &Surface, least: f64) -> impl Iterator<Item = DVec3> + '_ {
    let (low, high) = measure::bounding_box(&surface.x);
    let (middle, size) = (0.5 * (low + high), (high - low).length());
    spread()
        .map(move |p| middle + size * p)
        .filter(move |&c| distance_to_surface(&surface.mesh, &surface.x, c) >= least * size)
}

fn inverted(surface: &Surface, centre: DVec3) -> Vec<DVec3> {
    let map = Inversion::framed(&surface.mesh, &surface.x, centre);
    surface.x.iter().map(|&p| map.apply(p)).collect()
}

const SAMPLES: [&str; 8] = [
    "icosahedron",
    "bumpy-sphere",
    "torus",
    "double-torus",
    "klein-bottle",
    "moebius",
    "pipe",
    "disk",
];

#[test]
fn the_circle_energy_stays() {
    for name in SAMPLES {
        let surface = sample(name);
        let energy = CircleEnergy::new(&surface.mesh, Boundary::Clamped);
        let before = energy.value(&surface.x, Smoothing::EXACT);
        let stars = energy.vertex_energies(&surface.x);
        for centre in centres(&surface, 1e-3).take(20) {
            let y = inverted(&surface, centre);
            let change = energy.value(&y, Smoothing::EXACT) - before;
            assert!(change.abs() < 1e-10 * before.max(1.0), "{name}: {change:e}");
            for (was, is) in stars.iter().zip(energy.vertex_energies(&y)) {
                assert!((was - is).abs() < 1e-10, "{name}: W_i {was} → {is}");
            }
        }
    }
}

#[test]
fn close_to_the_surface_it_stays_too() {
    // Right-angled lattices are the worst case: β = 0 on every diagonal, where the angle has a cone.
    for (name, bound) in [("clifford-torus", 1e-12), ("bumpy-sphere", 1e-12)] {
        let surface = sample(name);
        let energy = CircleEnergy::new(&surface.mesh, Boundary::Clamped);
        let before = energy.value(&surface.x, Smoothing::EXACT);
        let angles = before + std::f64::consts::TAU * energy.n_counted() as f64;
        let size = measure::bounding_diagonal(&surface.x);
        let centre = surface.x[5] * (1.0 + 1.2e-3 * size / surface.x[5].length());
        let distance = distance_to_surface(&surface.mesh, &surface.x, centre) / size;
        assert!((1e-3..2e-3).contains(&distance), "{name}: {distance}");
        let change = energy.value(&inverted(&surface, centre), Smoothing::EXACT) - before;
        assert!(change.abs() < bound * angles, "{name}: {change:e}");
    }
}

#[test]
fn closed_by_infinity_it_does_not_stay() {
    let surface = sample("pipe");
    let energy = CircleEnergy::new(&surface.mesh, Boundary::Free);
    let before = energy.value(&surface.x, Smoothing::EXACT);
    for centre in centres(&surface, 0.05).take(5) {
        let change = energy.value(&inverted(&surface, centre), Smoothing::EXACT) - before;
        // That of interior vertices changes by 10⁻¹⁴.
        assert!(change.abs() > 1e-5 * before, "{change:e} of {before}");
    }
}

#[test]
fn the_lumped_willmore_energy_does_not_stay() {
    let surface = sample("double-torus");
    let lumped = |x: &[DVec3]| integrated_power(&surface.mesh, x, 2.0);
    let before = lumped(&surface.x);
    for centre in centres(&surface, 0.05).take(5) {
        let change = lumped(&inverted(&surface, centre)) - before;
        assert!(change.abs() > 1e-4 * before, "{change:e} of {before}");
    }
}

#[test]
fn an_inversion_undoes_itself() {
    let centre = DVec3::new(0.3, -0.2, 1.4);
    for mirror in [None, Some(DVec3::new(2.0, -1.0, 0.5).normalize())] {
        let map = Inversion {
            centre,
            radius: 1.7,
            mirror,
            image: centre,
        };
        for p in spread().take(50) {
            assert!(map.apply(map.apply(p)).distance(p) < 1e-14);
            // Points of the sphere stay on it.
            let on = centre + 1.7 * p.normalize();
            assert!((map.apply(on).distance(centre) - 1.7).abs() < 1e-14);
        }
    }
}

#[test]
fn normals_stay_outside_and_the_frame_is_kept() {
    for name in ["icosahedron", "torus", "double-torus"] {
        let surface = sample(name);
        let (low, high) = measure::bounding_box(&surface.x);
        let (mut mirrored, mut plain) = (0, 0);
        // A point within the tube of the torus is a rare one.
        let within = (name == "torus").then_some(DVec3::new(0.0, 1.1, 0.05));
        for centre in centres(&surface, 0.02).take(60).chain(within) {
            let map = Inversion::framed(&surface.mesh, &surface.x, centre);
            let y: Vec<DVec3> = surface.x.iter().map(|&p| map.apply(p)).collect();
            let volume = measure::volume(&surface.mesh, &y).expect("closed");
            assert!(volume > 0.0, "{name}: volume {volume}");
            let (to_low, to_high) = measure::bounding_box(&y);
            let size = (high - low).length();
            assert!(((to_high - to_low).length() / size - 1.0).abs() < 1e-12);
            assert!((low + high).distance(to_low + to_high) < 1e-12 * size);
            *if map.mirror.is_some() {
                &mut mirrored
            } else {
                &mut plain
            } += 1;
        }
        let both = name == "double-torus" || plain > 0;
        assert!(mirrored > 0 && both, "{name}: {mirrored} {plain}");
    }
}

#[test]
fn from_far_away_it_does_nothing() {
    let surface = sample("torus");
    let size = measure::bounding_diagonal(&surface.x);
    for (factor, bound) in [(30.0, 0.05), (300.0, 0.005)] {
        let y = inverted(&surface, factor * size * DVec3::new(0.6, 0.0, 0.8));
        let moved = y.iter().zip(&surface.x).map(|(a, b)| a.distance(*b));
        assert!(moved.fold(0.0, f64::max) < bound * size);
    }
}

fn session(name: &str) -> Session {
    let mut session = Session::new();
    session.sample(name, &[]).expect("a sample");
    session.configure(FlowOptions::default()).expect("options");
    session
}

#[test]
fn an_inversion_is_previewed_kept_and_undone() {
    let mut session = session("icosahedron");
    session.run(2).expect("steps");
    let (x, state) = (
        session.positions().expect("x"),
        session.state().expect("state"),
    );
    let centre = [0.1, 0.2, 0.6];
    let seen = session
        .preview_inversion(
            centre,
            Some(FieldName::MeanCurvature),
            LookOptions::default(),
        )
        .expect("a preview");
    assert_eq!(
        session.positions().expect("x"),
        x,
        "a preview changes nothing"
    );
    assert_eq!(
        seen.field.as_ref().map(|f| f.values.len()),
        Some(x.len() / 3)
    );
    let report = &seen.report;
    assert!((report.after.circle - report.before.circle).abs() < 1e-10);
    assert!(report.largest_change < 1e-10 && report.before.circle_closed.is_none());
    let (loaded, again) = session.invert(centre).expect("an edit");
    assert_eq!((&loaded.positions, &again), (&seen.positions, report));
    session.configure(FlowOptions::default()).expect("options");
    let energy = session.state().expect("state").energy;
    assert!(
        (energy - state.energy).abs() < 1e-10,
        "{energy} {}",
        state.energy
    );
    session.undo_edit().expect("the edit before");
    assert_eq!(session.positions().expect("x"), x);
    assert_eq!(session.state().expect("state"), state);
}

#[test]
fn bad_centres_are_refused_in_words() {
    let mut session = session("icosahedron");
    let x = session.positions().expect("x");
    // A corner and the middle of a face of the icosahedron: the box is a cube about it.
    let corner = [f64::from(x[0]), f64::from(x[1]), f64::from(x[2])];
    let x: Vec<DVec3> = x
        .chunks(3)
        .map(|p| DVec3::new(p[0].into(), p[1].into(), p[2].into()))
        .collect();
    let size = measure::bounding_diagonal(&x);
    for (centre, kind) in [
        (corner.map(|c| c / size), "CentreTooNear"),
        (corner.map(|c| 1.0005 * c / size), "CentreTooNear"),
        ([2e3, 0.0, 0.0], "CentreTooFar"),
        ([f64::NAN, 0.0, 0.0], "CentreTooFar"),
    ] {
        let fault = session.invert(centre).expect_err("refused");
        assert_eq!(fault.kind, kind);
        assert!(!session.can_undo_edit());
        assert!(
            session
                .preview_inversion(centre, None, LookOptions::default())
                .is_err()
        );
    }
}
