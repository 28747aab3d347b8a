//! Edge flips of Brink & Alboul: exact reductions, the greedy optimiser against a search of
//! all edges, and the conjecture of the paper, which is false.
#![allow(
    clippy::excessive_precision,
    reason = "as they were computed, to 20 digits"
)]

use crate::support::*;
use glam::DVec3;
use umbilic::energy::circle::angle::{Smoothing, diamond_angle};
use umbilic::energy::circle::{Boundary, CircleEnergy};
use umbilic::geometry::measure;
use umbilic::mesh::flip::Flippable;
use umbilic::mesh::{Edge, HalfedgeMesh, shape};
use umbilic::remesh::flips::FlipOptimiser;
use umbilic::remesh::flips::reduction::{Criterion, Quad, willmore_reduction};
use umbilic::soup::PolygonSoup;

const ALL: [Criterion; 3] = Criterion::ALL;

fn sample(name: &str, values: &[(&str, f64)]) -> Surface {
    let values: Vec<(String, f64)> = values.iter().map(|(n, v)| ((*n).to_owned(), *v)).collect();
    surface(&shape::make(name, &values).expect("a shape").soup)
}

fn optimiser(s: &Surface, criterion: Criterion) -> FlipOptimiser {
    FlipOptimiser::new((*s.mesh).clone(), s.x.clone().into(), criterion, false)
}

/// Rough surfaces, closed and open.
fn surfaces() -> Vec<(&'static str, Surface)> {
    let jittered = |name, values: &[(&str, f64)], amount: f64, seed| {
        let mut s = sample(name, values);
        let h = measure::mean_edge_length(&s.mesh, &s.x);
        let mut random = Random(seed);
        s.x.iter_mut()
            .for_each(|p| *p += amount * h * random.vector());
        s
    };
    vec![
        (
            "torus",
            jittered("torus", &[("around", 24.0), ("tube", 12.0)], 0.25, 7),
        ),
        (
            "ellipsoid",
            sample("ellipsoid", &[("level", 3.0), ("jitter", 0.2)]),
        ),
        // Three steps about the tube: many other diagonals are edges already.
        (
            "thin torus",
            jittered(
                "torus",
                &[("around", 40.0), ("tube", 3.0), ("minor", 0.1)],
                0.3,
                5,
            ),
        ),
        (
            "hemisphere",
            jittered("hemisphere", &[("rings", 8.0)], 0.2, 9),
        ),
        ("monkey saddle", jittered("monkey-saddle", &[], 0.3, 11)),
        ("scrambled sphere", scrambled()),
    ]
}

/// A sphere after a thousand random flips: flips that would gain have to wait for others.
fn scrambled() -> Surface {
    let s = sample("icosphere", &[("level", 2.0)]);
    let mut mesh = (*s.mesh).clone();
    let mut random = Random(13);
    let mut flips = 0;
    while flips < 1000 {
        let at = (0.5 * (random.next() + 1.0) * mesh.n_edges() as f64) as usize;
        let e = Edge::new(at.min(mesh.n_edges() - 1));
        if mesh.flippable(e) == Flippable::Yes {
            mesh.flip(e);
            flips += 1;
        }
    }
    Surface {
        mesh: mesh.into(),
        ..s
    }
}

fn quad([i, j, k, l]: [[f64; 3]; 4]) -> Quad {
    let [i, j, k, l] = [i, j, k, l].map(DVec3::from_array);
    Quad { i, j, k, l }
}

/// To 20 digits by an independent route; the first three can be checked by hand.
#[test]
fn reductions_of_single_quadrilaterals() {
    let cases = [
        // The explicit counterexample: f_a = 7.5 − 2√2 − √89/2.
        (
            [[0., 0., 0.], [3., 0., 0.], [0., 4., 0.], [1., 0., 1.]],
            -0.045417690774492003,
            0.0067911450624690873,
        ),
        (
            [[0., 0., 0.], [4., 0., 0.], [0., 1., 0.], [3., 4., 3.]],
            0.15756860882856708,
            -0.047924666108374246,
        ),
        (
            [[0., 0., 0.], [4., 0., 0.], [1., 0.5, 0.], [1., -0.5, 0.]],
            0.0,
            2.5740044351731375,
        ),
        (
            [[0., 0., 0.], [4., 0., 0.], [0., 1., 0.], [3., 4., 0.]],
            1.0,
            -0.05261943450584438,
        ),
        (
            [[0., 0., 0.], [4., 0., 0.], [2., 1., 0.], [2., -1., 1.]],
            0.24585142979035009,
            0.40905413582242114,
        ),
        (
            [[2., 1., 0.], [2., -1., 1.], [0., 0., 0.], [4., 0., 0.]],
            -0.24585142979035009,
            -0.40905413582242114,
        ),
    ];
    for (points, area, localised) in cases {
        let quad = quad(points);
        assert!(
            (quad.area_reduction() - area).abs() < 1e-14,
            "{points:?}: {}",
            quad.area_reduction()
        );
        let found = quad.localised_reduction();
        assert!((found - localised).abs() < 1e-13, "{points:?}: {found}");
    }
    assert!((7.5 - 8f64.sqrt() - 0.5 * 89f64.sqrt() + 0.045417690774492003).abs() < 1e-15);
    let samples = [
        (
            [
                [-0.524, 0.088, -0.26],
                [0.208, 0.251, -0.869],
                [-0.974, 0.675, -0.481],
                [-0.531, 0.991, -0.059],
            ],
            2.56268929118962709,
        ),
        (
            [
                [0.673, -0.047, 0.278],
                [-0.699, 0.27, 0.736],
                [0.046, 0.483, 0.343],
                [-0.872, 0.516, 0.182],
            ],
            1.85073483002388877,
        ),
    ];
    for (points, beta) in samples {
        let Quad { i, j, k, l } = quad(points);
        let found = diamond_angle(k, j, l, i).beta;
        assert!((found - beta).abs() < 1e-14, "β = {found}");
        // The two identities (3).
        assert!((diamond_angle(i, l, j, k).beta - found).abs() < 1e-14);
        assert!((diamond_angle(k, i, l, j).beta - found).abs() < 1e-14);
    }
}

/// Σβ over interior edges, twice, from scratch.
fn willmore(mesh: &HalfedgeMesh, x: &[DVec3]) -> f64 {
    let inner = mesh.edges().filter(|&e| !mesh.is_boundary_edge(e));
    let angles = inner.map(|e| {
        let Quad { i, j, k, l } = Quad::of(mesh, x, e);
        diamond_angle(k, j, l, i).beta
    });
    2.0 * angles.sum::<f64>() - std::f64::consts::TAU * mesh.n_vertices() as f64
}

#[test]
fn reductions_are_what_a_flip_takes_off() {
    for (name, s) in surfaces() {
        let mut mesh = (*s.mesh).clone();
        for e in s.mesh.edges().step_by(3) {
            if mesh.flippable(e) != Flippable::Yes {
                continue;
            }
            let (area, w) = (measure::area(&mesh, &s.x), willmore(&mesh, &s.x));
            let by_area = Quad::of(&mesh, &s.x, e).area_reduction();
            let by_angles = willmore_reduction(&mesh, &s.x, e);
            mesh.flip(e);
            let gained = area - measure::area(&mesh, &s.x);
            assert!(
                (gained - by_area).abs() < 1e-12 * area,
                "{name}, edge {}",
                e.0
            );
            let gained = w - willmore(&mesh, &s.x);
            assert!(
                (gained - by_angles).abs() < 1e-10,
                "{name}, edge {}: {gained}, {by_angles}",
                e.0
            );
        }
    }
}

/// The optimiser without a queue: all edges are searched before each flip.
fn naive(s: &Surface, criterion: Criterion) -> Vec<[u32; 2]> {
    let mut mesh = (*s.mesh).clone();
    let mut flipped = Vec::new();
    loop {
        let value = |e: Edge| match criterion {
            Criterion::Area => {
                let quad = Quad::of(&mesh, &s.x, e);
                (quad.area_reduction(), 1e-12 * quad.area())
            }
            Criterion::Willmore => (willmore_reduction(&mesh, &s.x, e), 1e-11),
            Criterion::Localised => (Quad::of(&mesh, &s.x, e).localised_reduction(), 1e-11),
        };
        let ends = |e: Edge| {
            let [a, b] = mesh.ends(e).map(|v| v.0);
            [a.min(b), a.max(b)]
        };
        let mut best: Option<(f64, [u32; 2], Edge)> = None;
        for e in mesh
            .edges()
            .filter(|&e| mesh.flippable(e) == Flippable::Yes)
        {
            let (f, threshold) = value(e);
            let is_better = best.is_none_or(|(g, key, _)| f > g || (f == g && ends(e) < key));
            if f > threshold && is_better {
                best = Some((f, ends(e), e));
            }
        }
        let Some((_, key, e)) = best else {
            return flipped;
        };
        mesh.flip(e);
        flipped.push(key);
    }
}

#[test]
fn the_queue_flips_what_a_search_of_all_edges_flips() {
    // Of nearly 5000 edges, about 1000 of them flipped.
    let large = sample("sampled-torus", &[("around", 56.0), ("tube", 28.0)]);
    for (name, s) in surfaces().into_iter().chain([("sampled torus", large)]) {
        for criterion in ALL {
            let mut optimiser = optimiser(&s, criterion);
            let mut flipped = Vec::new();
            while let Some(flip) = optimiser.step() {
                let [a, b] = flip.before.map(|v| v.0);
                flipped.push([a.min(b), a.max(b)]);
            }
            println!(
                "{name}, {criterion:?}: {} flips of {} edges, {} refused",
                flipped.len(),
                s.mesh.n_edges(),
                optimiser.rejected()
            );
            assert_eq!(flipped, naive(&s, criterion), "{name}, {criterion:?}");
            assert!(!flipped.is_empty());
            optimiser.mesh().validate().expect("valid");
        }
    }
}

#[test]
fn running_totals_are_exact_and_the_cost_only_falls() {
    for (name, s) in surfaces() {
        for criterion in ALL {
            let mut optimiser = optimiser(&s, criterion);
            let (mut area, mut w) = (optimiser.area(), optimiser.willmore());
            let mut step = 0;
            while let Some(flip) = optimiser.step() {
                step += 1;
                match criterion {
                    Criterion::Area => assert!(flip.area < area, "{name}: area rose"),
                    Criterion::Willmore => assert!(flip.willmore < w, "{name}: W rose"),
                    Criterion::Localised => assert!(flip.reduction > 0.0),
                }
                (area, w) = (flip.area, flip.willmore);
                if step % 50 == 0 {
                    let exact = measure::area(optimiser.mesh(), &s.x);
                    assert!((area - exact).abs() < 1e-9 * exact);
                    assert!((w - willmore(optimiser.mesh(), &s.x)).abs() < 1e-9);
                }
            }
            assert_eq!(step, optimiser.flips());
            let mesh = optimiser.mesh();
            assert!((area - measure::area(mesh, &s.x)).abs() < 1e-9 * area);
            assert!((w - willmore(mesh, &s.x)).abs() < 1e-9);
            if mesh.is_closed() {
                let energy = CircleEnergy::new(mesh, Boundary::Free).value(&s.x, Smoothing::EXACT);
                assert!(
                    (w - energy).abs() < 1e-9 * energy.abs().max(1.0),
                    "{name}: {w}, {energy}"
                );
            }
        }
    }
}

/// Cocircular corners: no flip gains anything, and none is made.
#[test]
fn no_flip_cuts_along_a_straight_boundary() {
    // A saddle over a square: three vertices of its boundary are on a line.
    for n in [4_u32, 11] {
        let points = (0..n * n).map(|i| {
            let [x, y] = [i % n, i / n].map(|c| f64::from(c) / f64::from(n - 1) - 0.5);
            DVec3::new(x, y, 0.5 * x * y)
        });
        let mut faces = Vec::new();
        for i in (0..n * (n - 1)).filter(|i| i % n < n - 1) {
            faces.extend([[i, i + 1, i + n + 1], [i, i + n + 1, i + n]]);
        }
        let s = surface(&PolygonSoup::from_faces(points.collect(), &faces));
        for criterion in ALL {
            let mut optimiser = optimiser(&s, criterion);
            while optimiser.step().is_some() {}
            let angle = measure::min_angle_degrees(optimiser.mesh(), &s.x);
            assert!(angle > 1.0, "{n}, {criterion:?}: {angle}");
        }
    }
}

#[test]
fn a_regular_torus_stays() {
    let torus = sample("torus", &[("around", 20.0), ("tube", 10.0)]);
    for criterion in [Criterion::Area, Criterion::Localised] {
        let mut optimiser = optimiser(&torus, criterion);
        assert!(optimiser.step().is_none(), "{criterion:?}");
    }
}

/// Figures 7 and 8: minimising area or localised Willmore energy leads to a lower Willmore
/// energy than minimising that itself.
#[test]
fn willmore_energy_is_lower_by_the_other_criteria() {
    let s = sample("ellipsoid", &[("level", 4.0), ("jitter", 0.25)]);
    let ends = ALL.map(|criterion| {
        let mut optimiser = optimiser(&s, criterion);
        let start = optimiser.willmore();
        while optimiser.step().is_some() {}
        println!(
            "{criterion:?}: {} flips, W {start:.2} → {:.3}, area {:.5}",
            optimiser.flips(),
            optimiser.willmore(),
            optimiser.area()
        );
        assert!(optimiser.willmore() < 0.5 * start);
        (optimiser.willmore(), optimiser.area())
    });
    let [by_area, by_willmore, localised] = ends;
    assert!(by_area.0 < by_willmore.0 && localised.0 < by_willmore.0);
    assert!(by_area.1 <= localised.1 && by_area.1 < by_willmore.1);
}

/// The conjecture f_a ≤ 0 ⇔ f_l ≤ 0 fails for 0.37 % of random tetrahedra, in both
/// directions alike, and for none of a million nearly flat ones.
#[test]
fn the_conjecture_fails_at_its_known_rate() {
    let mut random = Random(17);
    let mut gaussian = || {
        let (u, v) = (0.5 * random.next() + 0.5, random.next());
        (-2.0 * u.max(1e-300).ln()).sqrt() * (std::f64::consts::PI * v).cos()
    };
    let n = 200_000;
    let (mut up, mut down) = (0, 0);
    for _ in 0..n {
        let mut point = || DVec3::new(gaussian(), gaussian(), gaussian());
        let quad = Quad {
            i: point(),
            j: point(),
            k: point(),
            l: point(),
        };
        let (f, g) = (quad.area_reduction(), quad.localised_reduction());
        up += usize::from(f <= 0.0 && g > 0.0);
        down += usize::from(f > 0.0 && g <= 0.0);
    }
    let rate = (up + down) as f64 / f64::from(n);
    println!("{up} and {down} of {n}: {:.3} %", 100.0 * rate);
    // 7467 of two million, three standard deviations of this many.
    assert!((rate - 0.003734).abs() < 0.00042, "{rate}");
    assert!(up.abs_diff(down) < 110);
    for _ in 0..n {
        let mut near = |x: f64, y: f64| {
            DVec3::new(
                x + 0.05 * gaussian(),
                y + 0.05 * gaussian(),
                0.05 * gaussian(),
            )
        };
        let half = 0.75f64.sqrt();
        let quad = Quad {
            i: near(0.0, -0.5),
            j: near(0.0, 0.5),
            k: near(-half, 0.0),
            l: near(half, 0.0),
        };
        let agree = (quad.area_reduction() <= 0.0) == (quad.localised_reduction() <= 0.0);
        assert!(agree, "{quad:?}");
    }
}

/// Flips and their undoing leave nothing behind: totals to the last bit, the same queue, the
/// same edges waiting.
#[test]
fn flips_go_back_and_come_again() {
    let mut waited = 0;
    for (name, s) in surfaces() {
        for (criterion, guard) in ALL
            .map(|c| (c, false))
            .into_iter()
            .chain(ALL.map(|c| (c, true)))
        {
            let new =
                || FlipOptimiser::new((*s.mesh).clone(), s.x.clone().into(), criterion, guard);
            let faces = |o: &FlipOptimiser| o.mesh().to_soup(&s.x);
            let mut straight = new();
            let mut states = vec![(straight.area(), straight.willmore(), 0)];
            while straight.step().is_some() {
                states.push((straight.area(), straight.willmore(), straight.rejected()));
            }
            let ended = straight.rejected();
            waited += ended;
            let mut wandering = new();
            let mut random = Random(23);
            let mut budget = 400;
            loop {
                let go_back = budget > 0 && random.next() > -0.2;
                if go_back {
                    budget -= 1;
                    for _ in 0..(8.0 * random.next().abs()) as usize {
                        wandering.back();
                        wandering.mesh().validate().expect("valid");
                    }
                    let (area, w, _) = states[wandering.flips()];
                    assert_eq!(
                        (wandering.area(), wandering.willmore()),
                        (area, w),
                        "{name}"
                    );
                }
                let ahead = (12.0 * random.next().abs()) as usize + 1;
                if (0..ahead).map_while(|_| wandering.step()).count() < ahead && budget == 0 {
                    break;
                }
                let (.., rejected) = states[wandering.flips()];
                if wandering.flips() + 1 < states.len() {
                    assert_eq!(wandering.rejected(), rejected, "{name}, {criterion:?}");
                }
            }
            assert_eq!(wandering.made(), straight.made(), "{name}, {criterion:?}");
            assert_eq!(wandering.rejected(), ended);
            assert_eq!(faces(&wandering), faces(&straight), "{name}");
            while wandering.back().is_some() {}
            let start = new();
            assert_eq!(wandering.willmore(), start.willmore());
            assert_eq!(wandering.rejected(), 0);
            for e in s.mesh.edges() {
                assert_eq!(wandering.mesh().ends(e), s.mesh.ends(e), "{name}");
                if !s.mesh.is_boundary_edge(e) {
                    let apexes = |m: &HalfedgeMesh| m.opposite_vertices(e);
                    assert_eq!(apexes(wandering.mesh()), apexes(&s.mesh), "{name}");
                }
            }
        }
    }
    assert!(waited > 100, "{waited} refusals were undone");
}
