//! ∫H² with a lumped, a mixed and a consistent mass: order, accuracy, and what they make of
//! meshes that crumple.

use crate::p_willmore_energy::{quad_torus, roughened};
use crate::support::*;
use glam::DVec3;
use std::collections::HashMap;
use std::f64::consts::PI;
use std::rc::Rc;
use umbilic::app::Session;
use umbilic::energy::circle::Boundary;
use umbilic::energy::p_willmore::integrated_power;
use umbilic::energy::p_willmore::{Evaluation, Helfrich, PWillmore, WillmoreBounds};
use umbilic::flow::Decision;
use umbilic::flow::constraint::Kept;
use umbilic::flow::options::FlowOptions;
use umbilic::flow::spec::FlowName;
use umbilic::geometry::measure;
use umbilic::operator::Mass;
use umbilic::soup::PolygonSoup;

const MASSES: [Mass; 3] = [Mass::Lumped, Mass::Mixed, Mass::Consistent];

/// The unit sphere as a cube of n × n quadrilaterals a face, its vertices pushed out.
fn cube_sphere(n: i32) -> Surface {
    let mut soup = PolygonSoup::default();
    let mut index = HashMap::new();
    let mut at = |key: [i32; 3], soup: &mut PolygonSoup| {
        *index.entry(key).or_insert_with(|| {
            let p = DVec3::from_array(key.map(|k| f64::from(k) / f64::from(n)));
            soup.positions.push(p.normalize());
            soup.positions.len() as u32 - 1
        })
    };
    for (axis, side) in (0..3).flat_map(|axis| [(axis, -n), (axis, n)]) {
        for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (2 * i - n, 2 * j - n))) {
            let mut face = [(i, j), (i + 2, j), (i + 2, j + 2), (i, j + 2)].map(|(a, b)| {
                let mut key = [side; 3];
                (key[(axis + 1) % 3], key[(axis + 2) % 3]) = (a, b);
                at(key, &mut soup)
            });
            if side < 0 {
                face.reverse();
            }
            soup.push_face(&face);
        }
    }
    surface(&soup)
}

fn icosphere(level: f64) -> Surface {
    surface(&sample("icosphere", &[("level", level)]))
}

fn clifford(around: f64, tube: f64) -> Surface {
    let radii = [("major", 2f64.sqrt()), ("minor", 1.0)];
    let steps = [("around", around), ("tube", tube)];
    surface(&sample("torus", &[&radii[..], &steps].concat()))
}

fn evaluated(s: &Surface, p: f64, mass: Mass) -> Evaluation {
    let mesh = Rc::clone(&s.mesh);
    let f = PWillmore::new(mesh, &s.x, p, Helfrich::default(), mass).expect("elements");
    let mut at = Evaluation::default();
    f.evaluate(&s.x, &mut at);
    at
}

/// ∫|H|^p dA.
fn integral(s: &Surface, p: f64, mass: Mass) -> f64 {
    evaluated(s, p, mass).integrals.energy / 2f64.powf(p)
}

#[test]
fn lumped_is_least_and_consistent_largest_on_any_mesh() {
    let mut widest = 0.0f64;
    for seed in 0..12 {
        let amount = 0.04 * (seed + 1) as f64;
        for s in [
            icosphere(2.0),
            clifford(18.0, 12.0),
            quad_torus(14, 9, 1.0, 0.4),
        ] {
            let s = roughened(s, amount, seed);
            let [lumped, mixed, consistent] = MASSES.map(|mass| integral(&s, 2.0, mass));
            assert!(lumped < mixed && mixed < consistent, "seed {seed}");
            let bounds = WillmoreBounds::of(&s.mesh, &s.x).expect("elements");
            assert!((bounds.lumped / lumped - 1.0).abs() < 1e-12);
            assert!((bounds.consistent / consistent - 1.0).abs() < 1e-12);
            // A convex function of α: the dual norm of a matrix that is linear in it.
            assert!(mixed < 0.25 * lumped + 0.75 * consistent);
            widest = widest.max(bounds.disagreement());
        }
    }
    println!("they part by up to {:.0} %", 100.0 * widest);
    assert!(widest > 0.3, "none of the meshes is rough: {widest}");
}

/// Hölder's inequality holds of the discrete integrals too, as all are sums over one set of
/// samples.
#[test]
fn what_bounds_the_square_bounds_higher_powers() {
    for seed in 0..6 {
        for s in [icosphere(2.0), quad_torus(14, 9, 1.0, 0.4)] {
            let s = roughened(s, 0.1 * seed as f64, seed);
            for mass in MASSES {
                let at = evaluated(&s, 2.0, mass).integrals;
                for (p, sign) in [(1.0, -1.0), (1.5, -1.0), (3.0, 1.0), (4.0, 1.0)] {
                    let power = evaluated(&s, p, mass).integrals.energy;
                    let bound = at.energy.powf(0.5 * p) * at.area.powf(1.0 - 0.5 * p);
                    assert!(sign * (power / bound - 1.0) > -1e-12, "p = {p}, {mass:?}");
                }
            }
        }
    }
}

#[test]
fn the_mixed_mass_errs_least_on_spheres_and_on_the_clifford_torus() {
    let (sphere, torus) = (4.0 * PI, 2.0 * PI * PI);
    let cases = [
        ("icosphere 3", icosphere(3.0), sphere, 1.0001, 2e-4),
        (
            "triangles, 40 × 24",
            clifford(40.0, 24.0),
            torus,
            1.0021,
            3e-4,
        ),
        ("cube, 16²", cube_sphere(16), sphere, 1.0002, 2e-4),
        (
            "quadrilaterals, 36 × 18",
            quad_torus(36, 18, 2f64.sqrt(), 1.0),
            torus,
            1.0035,
            3e-4,
        ),
    ];
    for (name, s, exact, expected, bound) in cases {
        let [lumped, mixed, consistent] = MASSES.map(|mass| integral(&s, 2.0, mass) / exact);
        println!("{name}: {lumped:.5}, {mixed:.5}, {consistent:.5}");
        assert!((mixed - expected).abs() < bound, "{name}: {mixed}");
        let error = (mixed - 1.0).abs();
        assert!(error < 0.2 * (lumped - 1.0).abs() && error < 0.31 * (consistent - 1.0).abs());
    }
}

/// Over ∫|H|^p dA of the sphere with the mesh's own area: an inscribed mesh is too small,
/// which for p ≠ 2 is an error that no mass is to blame for.
#[test]
fn on_spheres_the_error_is_of_second_order_for_all_exponents() {
    let error = |s: &Surface, p: f64, mass: Mass| {
        let radius = (evaluated(s, p, mass).integrals.area / (4.0 * PI)).sqrt();
        integral(s, p, mass) / (4.0 * PI * radius.powf(2.0 - p)) - 1.0
    };
    let ladders = [
        ("icosphere", [2.0, 3.0, 4.0].map(icosphere)),
        ("cube", [8, 16, 32].map(cube_sphere)),
    ];
    for (name, ladder) in &ladders {
        for p in [1.0, 2.0, 3.0, 4.0] {
            for mass in MASSES {
                let errors = ladder.each_ref().map(|s| error(s, p, mass));
                println!("{name}, p = {p}, {mass:?}: {errors:?}");
                if (*name, mass, p) == ("icosphere", Mass::Mixed, 2.0) {
                    // What is left there is too little to have an order.
                    assert!(errors.iter().all(|e| e.abs() < 1e-4), "{errors:?}");
                    continue;
                }
                let order = (errors[1] / errors[2]).log2();
                assert!(order > 1.85, "{name}, p = {p}, {mass:?}: order {order}");
            }
            let [lumped, mixed] = [Mass::Lumped, Mass::Mixed].map(|m| error(&ladder[1], p, m));
            assert!(mixed.abs() < 0.4 * lumped.abs(), "{name}, p = {p}");
        }
    }
}

#[test]
fn energies_and_gradients_scale_as_their_units_do() {
    for s in [
        roughened(icosphere(2.0), 0.2, 3),
        roughened(quad_torus(14, 9, 1.0, 0.4), 0.2, 4),
    ] {
        for (p, mass) in [1.0, 2.0, 4.0].iter().flat_map(|p| MASSES.map(|m| (*p, m))) {
            let at = evaluated(&s, p, mass);
            for scale in [1e6, 1e-6] {
                let scaled = Surface {
                    mesh: Rc::clone(&s.mesh),
                    x: s.x.iter().map(|q| scale * *q).collect(),
                    repairs: Vec::new(),
                };
                let found = evaluated(&scaled, p, mass);
                let ratio = found.integrals.energy / at.integrals.energy;
                let unit = scale.powf(2.0 - p);
                assert!(
                    (ratio / unit - 1.0).abs() < 1e-11,
                    "p = {p}, {mass:?}: {ratio}"
                );
                let back: Vec<DVec3> = found.gradient.iter().map(|g| *g / (unit / scale)).collect();
                let size = at.gradient.iter().map(|g| g.length()).fold(0.0, f64::max);
                assert!(
                    largest_difference(&back, &at.gradient) < 1e-9 * size,
                    "p = {p}, {mass:?}"
                );
            }
        }
    }
}

#[test]
fn a_crumpled_mesh_is_told_by_what_the_two_values_part() {
    let smooth = icosphere(3.0);
    let f = PWillmore::new(
        Rc::clone(&smooth.mesh),
        &smooth.x,
        2.0,
        Helfrich::default(),
        Mass::Mixed,
    )
    .expect("triangles");
    let resolved = f.disagreement(&smooth.x);
    let rough = roughened(smooth, 0.05, 5);
    let crumpled = f.disagreement(&rough.x);
    println!("disagreement {resolved:.4} of a sphere, {crumpled:.4} of a crumpled one");
    assert!((resolved - 0.0061).abs() < 5e-4, "{resolved}");
    assert!(crumpled > 0.05, "{crumpled}");
    let bounds = WillmoreBounds::of(&rough.mesh, &rough.x).expect("triangles");
    let expected = 1.0 - bounds.lumped / bounds.consistent;
    assert!((crumpled - expected).abs() < 1e-12);
    let flat = WillmoreBounds::default();
    assert_eq!(flat.disagreement(), 0.0);
}

#[test]
fn solves_take_few_iterations() {
    for s in [
        icosphere(4.0),
        roughened(clifford(40.0, 24.0), 0.4, 3),
        roughened(quad_torus(36, 18, 2.0, 1.0), 0.3, 3),
    ] {
        for p in [2.0, 4.0] {
            let [lumped, mixed] =
                [Mass::Lumped, Mass::Mixed].map(|m| evaluated(&s, p, m).iterations);
            println!("p = {p}: {mixed} iterations");
            let solves = if p == 2.0 { 1 } else { 2 };
            assert_eq!(lumped, 0);
            assert!((1..=40 * solves).contains(&mixed), "{mixed}");
        }
    }
}

#[test]
fn a_session_reads_both_values() {
    let mut session = Session::new();
    let level = [("level".to_owned(), 3.0)];
    session.sample("icosphere", &level).expect("a sample");
    let sphere = session.energy(Boundary::Fixed, &[]).expect("energies");
    assert!((sphere.willmore / (4.0 * PI) - 0.99556).abs() < 1e-4);
    assert!((sphere.willmore_consistent / (4.0 * PI) - 1.0017).abs() < 1e-4);
    // On an open surface, over the interior.
    let half = surface(&sample("hemisphere", &[]));
    let bounds = WillmoreBounds::of(&half.mesh, &half.x).expect("triangles");
    let lumped = integrated_power(&half.mesh, &half.x, 2.0);
    assert!((bounds.lumped / lumped - 1.0).abs() < 1e-12);
    assert!(bounds.lumped < bounds.consistent && bounds.consistent < 2.1 * PI);
}

/// A noisy ellipsoid with area and volume kept: the lumped energy falls below 4π there, the
/// least of all closed surfaces, its mesh crumpling. The vesicle of its reduced volume
/// .868 has 1.2507 · 4π by an axisymmetric minimisation.
#[test]
fn a_rough_ellipsoid_ends_as_the_prolate_vesicle_and_not_below_all_surfaces() {
    let Some(s) = case("flows", "rough_ell.obj") else {
        return;
    };
    let options = FlowOptions {
        flow: FlowName::PWillmore,
        keep: vec![Kept::Area, Kept::Volume],
        max_steps: Some(100),
        ..FlowOptions::default()
    };
    let mut x = s.x.clone();
    let mut flow = drive(&s.mesh, &mut x, options).expect("a flow");
    let mut steps = 0;
    while flow.step(&mut x).expect("a step").1 == Decision::GoOn {
        steps += 1;
    }
    let bounds = WillmoreBounds::of(&s.mesh, &x).expect("triangles");
    let ratio = flow.reading(&x).energy / (4.0 * PI);
    let angle = measure::min_angle_degrees(&s.mesh, &x);
    println!("{steps} steps, ∫H² = {ratio:.4} · 4π, {bounds:?}, angle {angle:.1}°");
    assert!((ratio / 1.2507 - 1.0).abs() < 0.012, "{ratio}");
    assert!(bounds.disagreement() < 0.05 && angle > 40.0);
}
