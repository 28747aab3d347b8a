//! Conformal regularisation of meshes at rest, and readings of the printed paper that fail.

use crate::p_willmore_energy::roughened;
use crate::support::parts::{self, Ends};
use crate::support::session::{flowing, shown};
use crate::support::*;
use glam::{DQuat, DVec3};
use std::rc::Rc;
use umbilic::app::Session;
use umbilic::energy::conformal::{conformal_distortion, reference_angles};
use umbilic::flow::spec::FlowName;
use umbilic::geometry::measure;
use umbilic::io::Format;
use umbilic::mesh::shape;
use umbilic::operator::Elements;
use umbilic::remesh::static_pass::{
    RegulariseError, RegulariseOptions, Regularised, quality, regularise,
};
use umbilic::remesh::{Mode, Regulariser};
use umbilic::soup::PolygonSoup;

fn shape_of(name: &str, values: &[(&str, f64)]) -> PolygonSoup {
    let values: Vec<(String, f64)> = values.iter().map(|(n, v)| ((*n).to_owned(), *v)).collect();
    shape::make(name, &values).expect("a shape").soup
}

fn sample(name: &str, values: &[(&str, f64)]) -> Surface {
    surface(&shape_of(name, values))
}

fn regulariser(surface: &Surface) -> Regulariser {
    let elements = Elements::of(&surface.mesh).expect("one kind of face");
    Regulariser::new(elements, &surface.x).expect("memory")
}

/// An ellipsoid with its vertices pushed along the surface until triangles turn over.
fn jittered() -> Surface {
    sample("ellipsoid", &[("level", 4.0), ("jitter", 0.35)])
}

#[test]
fn the_distortion_is_that_of_the_energy_and_falls() {
    let surface = jittered();
    let mut regulariser = regulariser(&surface);
    let before = regulariser.distortion(&surface.x);
    let expected = conformal_distortion(&surface.mesh, &surface.x);
    assert!((before / expected - 1.0).abs() < 1e-12);
    for mode in [Mode::Linear, Mode::Nonlinear] {
        let v = regulariser
            .displacement(&surface.x, mode, 1e-2)
            .expect("a solution");
        let y: Vec<DVec3> = surface.x.iter().zip(&v).map(|(x, v)| *x + *v).collect();
        assert!(regulariser.distortion(&y) < before);
    }
}

#[test]
fn an_inverted_mesh_is_repaired_and_keeps_its_shape() {
    let surface = jittered();
    let mut regulariser = regulariser(&surface);
    let settings = RegulariseOptions {
        features: 0.0,
        ..RegulariseOptions::default()
    };
    let mut x = surface.x.clone();
    let outcome = regularise(&mut regulariser, &surface.mesh, &mut x, &settings).expect("passes");
    println!("{outcome:?}");
    let (before, after) = (outcome.before, outcome.after);
    assert!(before.inverted > 100 && before.min_angle_degrees < 2.0);
    assert_eq!(after.inverted, 0);
    assert!(
        after.min_angle_degrees > 35.0,
        "{}",
        after.min_angle_degrees
    );
    assert!(after.distortion < 0.05 * before.distortion);
    // Distance from the ellipsoid that the vertices were jittered on.
    let off = x
        .iter()
        .map(|p| ((*p / DVec3::new(1.5, 1.0, 0.7)).length() - 1.0).abs())
        .fold(0.0, f64::max);
    println!("off the ellipsoid by {off:.4}");
    assert!(off < 0.04, "off the ellipsoid by {off}");
    let volume = |s: Option<f64>| s.expect("closed");
    assert!((volume(after.volume) / volume(before.volume) - 1.0).abs() < 1e-2);
}

/// In one pass vertices slide along tangent planes if it is linear, along the surface if it
/// is not: the same quality for a much smaller change of volume.
#[test]
fn nonlinear_passes_keep_the_volume_better() {
    for name in ["torus", "letter-c", "double-torus", "dumbbell"] {
        let surface = sample(name, &[]);
        let mut regulariser = regulariser(&surface);
        let volume = measure::volume(&surface.mesh, &surface.x).expect("closed");
        let [linear, nonlinear] = [Mode::Linear, Mode::Nonlinear].map(|mode| {
            let v = regulariser
                .displacement(&surface.x, mode, 1e-2)
                .expect("a solution");
            let y: Vec<DVec3> = surface.x.iter().zip(&v).map(|(x, v)| *x + *v).collect();
            let after = measure::volume(&surface.mesh, &y).expect("closed");
            ((after / volume - 1.0).abs(), regulariser.distortion(&y))
        });
        println!(
            "{name}: change of volume {:.1e} and {:.1e}, CD {:.5} and {:.5}",
            linear.0, nonlinear.0, linear.1, nonlinear.1
        );
        assert!(nonlinear.0 < 0.5 * linear.0, "{name}");
        assert!(nonlinear.1 < 1.1 * linear.1, "{name}");
    }
}

/// The preconditioner is made of the connectivity alone, and serves meshes of any fineness, of
/// quadrilaterals, and of vertices pushed about.
#[test]
fn a_pass_takes_as_few_iterations_on_fine_meshes_as_on_coarse_ones() {
    let iterations = |surface: &Surface| {
        let mut regulariser = regulariser(surface);
        regulariser
            .displacement(&surface.x, Mode::Linear, 1e-2)
            .expect("a solution");
        regulariser.iterations()
    };
    let torus = |around: f64| sample("torus", &[("around", around), ("tube", around / 2.0)]);
    let [coarse, fine] = [64.0, 160.0].map(|around| iterations(&torus(around)));
    println!("torus: {coarse} and {fine} iterations");
    assert!(coarse <= 16 && fine <= 16, "{coarse} and {fine}");
    let pushed = |level| iterations(&sample("ellipsoid", &[("level", level), ("jitter", 0.2)]));
    let [coarse, fine] = [3.0, 5.0].map(pushed);
    println!("ellipsoid, jittered: {coarse} and {fine} iterations");
    assert!(coarse <= 60 && fine <= 60, "{coarse} and {fine}");
    let quads = iterations(&sample("sampled-torus", &[]));
    println!("sampled torus: {quads} iterations");
    assert!(quads <= 30, "{quads}");
}

#[test]
fn epsilon_has_no_unit() {
    let surface = jittered();
    let large: Vec<DVec3> = surface.x.iter().map(|p| 1e3 * *p).collect();
    let mut regulariser = regulariser(&surface);
    let small = regulariser
        .displacement(&surface.x, Mode::Nonlinear, 1e-2)
        .expect("a solution");
    let scaled = regulariser
        .displacement(&large, Mode::Nonlinear, 1e-2)
        .expect("a solution");
    let shrunk: Vec<DVec3> = scaled.iter().map(|v| *v / 1e3).collect();
    let size = small.iter().map(|v| v.length()).fold(0.0, f64::max);
    assert!(largest_difference(&small, &shrunk) < 1e-3 * size);
}

#[test]
fn a_round_icosphere_stays_and_quadrilaterals_are_taken() {
    let sphere = sample("icosphere", &[("level", 3.0)]);
    let mut x = sphere.x.clone();
    let outcome = regularise(
        &mut regulariser(&sphere),
        &sphere.mesh,
        &mut x,
        &RegulariseOptions::default(),
    )
    .expect("passes");
    assert!(outcome.distance < 1e-3, "{outcome:?}");
    assert!(outcome.after.min_angle_degrees > 53.0);
}

/// α_i = 2π/m_i. The printed loop, α_i ← α_i/m_i, gives (15°, 82.5°, 82.5°) to a right
/// triangle whose corners all have six triangles.
#[test]
fn reference_angles_are_those_of_equal_shares() {
    let degrees = |m: [usize; 3]| reference_angles(m).map(f64::to_degrees);
    let close = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 0.06);
    assert!(close(degrees([6, 6, 6]), [60.0; 3]));
    assert!(
        close(degrees([5, 5, 6]), [63.5, 63.5, 52.9]),
        "{:?}",
        degrees([5, 5, 6])
    );
    assert!(close(degrees([4, 6, 6]), [90.0, 45.0, 45.0]));
    let printed = |angles: [f64; 3], m: f64| {
        // The largest kept, the others sharing the rest.
        let a = angles.map(|x| x / m);
        let i = (0..3)
            .max_by(|&i, &j| a[i].total_cmp(&a[j]))
            .expect("three");
        let rest: f64 = (0..3).filter(|&j| j != i).map(|j| a[j]).sum();
        [0, 1, 2].map(|j| {
            if j == i {
                a[j]
            } else {
                a[j] * (180.0 - a[i]) / rest
            }
        })
    };
    assert!(close(printed([90.0, 45.0, 45.0], 6.0), [15.0, 82.5, 82.5]));
}

/// Problems 4.3 and 5.3 as printed have + ε∫ρ², which makes the reduced energy
/// CD − (1/2ε)∫⟨v, n⟩²: indefinite, and its stationary point is no minimum.
#[test]
fn the_printed_sign_of_the_penalty_does_not_regularise() {
    let surface = jittered();
    let mut regulariser = regulariser(&surface);
    let size = measure::bounding_diagonal(&surface.x);
    // Where the penalty is as large as the entries of the matrix; off the ellipsoid, as
    // vertices may slide along it.
    let axes = DVec3::new(1.5, 1.0, 0.7);
    let mut farthest = |epsilon: f64| {
        let v = regulariser
            .displacement(&surface.x, Mode::Linear, epsilon)
            .expect("a solution");
        let off = v.iter().zip(&surface.x).map(|(v, x)| {
            let normal = (*x / (axes * axes)).normalize();
            v.dot(normal).abs()
        });
        off.fold(0.0, f64::max) / size
    };
    let (right, printed) = (farthest(0.3), farthest(-0.3));
    println!("off the surface by {right:.3} of the size and, as printed, {printed:.3}");
    assert!(right < 0.03, "{right}");
    assert!(printed > 10.0 * right, "{printed}");
}

/// Real meshes, one robust run each.
#[test]
fn real_meshes_gain_and_keep_their_shape() {
    for name in [
        "bunny.obj",
        "spot_low_resolution.obj",
        "skull_low_resolution.obj",
        "bob_small.ply",
    ] {
        let Some(surface) = real(name) else { return };
        let mut regulariser = regulariser(&surface);
        let mut x = surface.x.clone();
        let watch = std::time::Instant::now();
        let outcome = regularise(
            &mut regulariser,
            &surface.mesh,
            &mut x,
            &RegulariseOptions::default(),
        )
        .expect("passes");
        println!("{name}: {outcome:?} {:.2} s", watch.elapsed().as_secs_f64());
        assert!(
            outcome.after.distortion < 0.8 * outcome.before.distortion,
            "{name}"
        );
        assert!(outcome.after.inverted <= outcome.before.inverted, "{name}");
        // 250 vertices are few for a torus: there an edge is a fifth of the size.
        let bound = if surface.x.len() < 500 { 6e-2 } else { 5e-3 };
        assert!(outcome.distance < bound, "{name}: {}", outcome.distance);
        let again = quality(&regulariser, &surface.mesh, &x);
        assert_eq!(again, outcome.after);
        assert!(Rc::strong_count(&surface.mesh) >= 1);
    }
}

/// Distance from a point to a triangle by the regions of its plane: another way than the
/// library's.
fn brute_distance(p: DVec3, [a, b, c]: [DVec3; 3]) -> f64 {
    let (ab, ac) = (b - a, c - a);
    let (d1, d2) = (ab.dot(p - a), ac.dot(p - a));
    let (d3, d4) = (ab.dot(p - b), ac.dot(p - b));
    let (d5, d6) = (ab.dot(p - c), ac.dot(p - c));
    let (vc, vb, va) = (d1 * d4 - d3 * d2, d5 * d2 - d1 * d6, d3 * d6 - d5 * d4);
    let nearest = if d1 <= 0.0 && d2 <= 0.0 {
        a
    } else if d3 >= 0.0 && d4 <= d3 {
        b
    } else if d6 >= 0.0 && d5 <= d6 {
        c
    } else if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        a + d1 / (d1 - d3) * ab
    } else if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        a + d2 / (d2 - d6) * ac
    } else if va <= 0.0 && d4 >= d3 && d5 >= d6 {
        b.lerp(c, (d4 - d3) / (d4 - d3 + d5 - d6))
    } else {
        a + (vb * ab + vc * ac) / (va + vb + vc)
    };
    p.distance(nearest)
}

/// Every vertex of each surface against every triangle of the other.
fn brute_two_sided(s: &Surface, y: &[DVec3]) -> f64 {
    let one_side = |x: &[DVec3], points: &[DVec3]| {
        let triangles: Vec<[DVec3; 3]> = s
            .mesh
            .faces()
            .map(|f| measure::triangle_points(&s.mesh, x, f))
            .collect();
        let distance = |p: &DVec3| {
            let all = triangles.iter().map(|t| brute_distance(*p, *t));
            all.fold(f64::INFINITY, f64::min)
        };
        points.iter().map(distance).fold(0.0, f64::max)
    };
    one_side(&s.x, y).max(one_side(y, &s.x))
}

/// Largest change of a side of the bounding box and of its size, as a share of the extent.
fn change_of_box(x: &[DVec3], y: &[DVec3]) -> f64 {
    let ((low, high), (lower, higher)) = (measure::bounding_box(x), measure::bounding_box(y));
    let [down, up] = [lower - low, higher - high].map(|change| change / (high - low));
    [down, up, up - down]
        .map(|c| c.abs().max_element())
        .into_iter()
        .fold(0.0, f64::max)
}

/// Asserts that the surface is still the same one, or was refused, with its mesh unchanged;
/// returns the outcome and the positions.
fn keeps_its_shape(
    what: &str,
    s: &Surface,
    settings: &RegulariseOptions,
) -> Option<(Regularised, Vec<DVec3>)> {
    let mut y = s.x.clone();
    let outcome = match regularise(&mut regulariser(s), &s.mesh, &mut y, settings) {
        Ok(outcome) => outcome,
        Err(refusal) => {
            println!("{what}: {refusal}");
            assert!(
                !matches!(refusal, RegulariseError::Linear(_)),
                "{what}: {refusal}"
            );
            assert_eq!(y, s.x, "{what}");
            return None;
        }
    };
    let [volume, after] = [&s.x, &y].map(|x| measure::volume(&s.mesh, x).expect("closed"));
    let change = (after / volume - 1.0).abs();
    let [angle, angle_after] = [&s.x, &y].map(|x| measure::min_angle_degrees(&s.mesh, x));
    let distance = brute_two_sided(s, &y) / measure::bounding_diagonal(&s.x);
    let of_box = change_of_box(&s.x, &y);
    println!(
        "{what}: {} of {} pinned, {} passes, inverted {} → {}, angle {angle:.2}° → \
         {angle_after:.2}°, CD/A {:.4} → {:.4}, off by {:.3} %, volume {:.3} %, box {:.3} %",
        outcome.pinned,
        y.len(),
        outcome.passes,
        outcome.before.inverted,
        outcome.after.inverted,
        outcome.before.distortion,
        outcome.after.distortion,
        100.0 * distance,
        100.0 * change,
        100.0 * of_box,
    );
    assert!(distance <= 0.01, "{what}: off by {distance}");
    assert!(
        (outcome.distance - distance).abs() < 1e-9,
        "{what}: {outcome:?}, not {distance}"
    );
    assert!(change <= 0.02, "{what}: volume by {change}");
    assert!(of_box <= 0.02, "{what}: bounding box by {of_box}");
    assert!(
        angle_after >= angle.min(5.0) - 1e-9,
        "{what}: {angle}° → {angle_after}°"
    );
    assert!(
        outcome.after.inverted <= outcome.before.inverted,
        "{what}: {outcome:?}"
    );
    if outcome.passes == 0 {
        assert_eq!(y, s.x, "{what}");
    } else {
        let [before, after] = [outcome.before, outcome.after].map(|q| q.distortion * q.area);
        assert!(after < before, "{what}: CD {before} → {after}");
    }
    Some((outcome, y))
}

fn rod() -> PolygonSoup {
    parts::prism(&parts::circle(32, 5.0), &[0.0, 100.0], Ends::Fan)
}

/// Least distorted it would be a ball, and without creases to hold it becomes one.
#[test]
fn a_rod_of_needles_is_refused_and_stays_as_it_is() {
    let refusal = |s: &Surface| {
        let mut y = s.x.clone();
        let settings = RegulariseOptions::default();
        let error = regularise(&mut regulariser(s), &s.mesh, &mut y, &settings);
        assert!(y == s.x);
        error.expect_err("refused")
    };
    let expected = RegulariseError::OnlyCreases { vertices: 64 };
    let rod = surface(&rod());
    assert_eq!(refusal(&rod), expected);
    // With features left to slide it is the bounds that hold it.
    let sliding = RegulariseOptions {
        features: 0.0,
        ..RegulariseOptions::default()
    };
    keeps_its_shape("a rod", &rod, &sliding);
    let Some(rod) = case("files", "cad_rod.stl") else {
        return;
    };
    assert_eq!(refusal(&rod), expected);
}

fn session_on(soup: &PolygonSoup) -> Session {
    let mut session = Session::new();
    let bytes = umbilic::io::write(soup, Format::Obj, "").expect("a file");
    session.load(&bytes, "part.obj").expect("a surface");
    session
        .configure(flowing(FlowName::PWillmore))
        .expect("options");
    session
}

/// The session refuses as well, with nothing to be undone; refined, the rod is taken.
#[test]
fn a_session_refuses_a_rod_of_needles_and_says_why() {
    let mut session = session_on(&rod());
    let before = shown(&session);
    let fault = session
        .regularise(&RegulariseOptions::default())
        .expect_err("refused");
    assert_eq!(fault.kind, "OnlyCreases");
    assert_eq!(fault.message.number("vertices"), Some(64.0));
    assert!(shown(&session) == before);
    assert!(!session.state().expect("a mesh").can_step_back);
    let mut session = session_on(&parts::refined(&rod(), 2));
    let outcome = session
        .regularise(&RegulariseOptions::default())
        .expect("refined");
    assert!(
        outcome.pinned >= 256 && outcome.distance <= 0.01,
        "{outcome:?}"
    );
    assert!(session.state().expect("a mesh").can_step_back);
}

/// Vertices inside flat sides slide in them; edges and corners stay where they are, to the
/// last bit.
#[test]
fn parts_with_flat_sides_are_meshed_better_and_stay_the_same() {
    let box_of = |w, d, h| parts::prism(&parts::chamfered(w, d, 0.0), &[0.0, h], Ends::Fan);
    let chamfered = parts::prism(
        &parts::chamfered(4.0, 3.0, 0.5),
        &[0.0, 1.0, 2.0],
        Ends::Hub,
    );
    let gear = parts::prism(&parts::gear(12, 2.0, 2.4), &[0.0, 0.5, 1.0], Ends::Hub);
    let cases = [
        (
            "a bar",
            parts::crumpled(&parts::refined(&box_of(10.0, 6.0, 1.0), 3), 0.4, 1),
            true,
        ),
        (
            "a plate",
            parts::crumpled(&parts::refined(&box_of(9.0, 7.0, 0.1), 4), 0.3, 2),
            true,
        ),
        (
            "chamfers",
            parts::crumpled(&parts::refined(&chamfered, 2), 0.4, 3),
            true,
        ),
        (
            "a gear",
            parts::crumpled(&parts::refined(&gear, 1), 0.4, 4),
            true,
        ),
        (
            "a can of needles",
            parts::prism(&parts::circle(24, 1.0), &[0.0, 2.0], Ends::Hub),
            false,
        ),
    ];
    for (what, soup, gains) in cases {
        let s = surface(&soup);
        let (outcome, y) = keeps_its_shape(what, &s, &RegulariseOptions::default()).expect("taken");
        let size = measure::bounding_diagonal(&s.x);
        assert!(change_of_box(&s.x, &y) < 1e-9, "{what}");
        assert!(brute_two_sided(&s, &y) < 1e-9 * size, "{what}");
        assert_eq!(outcome.passes > 0, gains, "{what}");
        if gains {
            assert!(
                outcome.after.min_angle_degrees > outcome.before.min_angle_degrees,
                "{what}"
            );
        }
        let still = s.x.iter().zip(&y).filter(|(x, y)| x == y).count();
        assert!(
            still >= outcome.pinned,
            "{what}: {still} of {}",
            outcome.pinned
        );
    }
}

/// On a box the vertices on creases can be counted, folded faces in a side or not; on a prism
/// of twelve sides, whose dihedral angles are 30°, only the rims are creases, and on one of
/// eight all edges are.
#[test]
fn creases_are_the_edges_of_over_forty_degrees() {
    let bar = parts::prism(&parts::chamfered(10.0, 6.0, 0.0), &[0.0, 1.0], Ends::Fan);
    let readings = |s: &Surface| {
        let none = RegulariseOptions {
            iterations: 0,
            ..RegulariseOptions::default()
        };
        let mut x = s.x.clone();
        regularise(&mut regulariser(s), &s.mesh, &mut x, &none).expect("readings")
    };
    // Twelve edges of 8 segments and eight corners.
    let regular = surface(&parts::refined(&bar, 3));
    assert_eq!(readings(&regular).pinned, 12 * 7 + 8);
    let mut folded = surface(&parts::refined(&bar, 3));
    let inside = folded.mesh.vertices().find(|v| {
        let p = folded.x[v.index()];
        p.z == 1.0 && p.x.abs() < 2.0 && p.y.abs() < 1.0
    });
    let v = inside.expect("a vertex inside the top");
    folded.x[v.index()].x += 1.6;
    let found = readings(&folded);
    assert!(found.before.inverted > 0);
    assert_eq!(found.pinned, 12 * 7 + 8);
    for (sides, expected) in [(12, 2 * 24), (8, 2 * 16 + 8 * 3)] {
        let can = parts::prism(&parts::circle(sides, 1.0), &[0.0, 0.7, 1.4], Ends::Hub);
        let s = surface(&parts::refined(&can, 1));
        assert_eq!(readings(&s).pinned, expected, "{sides} sides");
    }
    // Roughness is no crease, nor is what folds where a mesh is folded.
    assert_eq!(readings(&jittered()).pinned, 0);
    let noisy = noisy_ellipsoid();
    let pinned = readings(&noisy).pinned;
    assert!(pinned < noisy.x.len() / 10, "{pinned}");
    for seed in 0..6 {
        let rough = roughened(sample("ellipsoid", &[("level", 3.0)]), 0.2, seed);
        assert_eq!(readings(&rough).pinned, 0, "seed {seed}");
    }
}

/// An ellipsoid, each vertex pushed about by up to a fifth of an edge along each axis.
fn noisy_ellipsoid() -> Surface {
    let mut s = sample("ellipsoid", &[("level", 3.0)]);
    let mut random = Random(11);
    let edge = measure::mean_edge_length(&s.mesh, &s.x);
    for p in &mut s.x {
        *p += 0.2 * edge * random.vector();
    }
    s
}

#[test]
fn a_noisy_ellipsoid_gains_and_keeps_its_shape() {
    let s = noisy_ellipsoid();
    let settings = RegulariseOptions::default();
    let (outcome, _) = keeps_its_shape("a noisy ellipsoid", &s, &settings).expect("taken");
    assert!(outcome.after.min_angle_degrees > 1.5 * outcome.before.min_angle_degrees);
    assert!(outcome.after.distortion < 0.5 * outcome.before.distortion);
}

#[test]
fn a_sphere_with_a_thousand_inverted_faces_is_repaired() {
    let axes = [("a", 1.0), ("b", 1.0), ("c", 1.0)];
    let jitter = [("level", 5.0), ("jitter", 0.35)];
    let s = sample("ellipsoid", &[&axes[..], &jitter].concat());
    let mut y = s.x.clone();
    let settings = RegulariseOptions::default();
    let outcome = regularise(&mut regulariser(&s), &s.mesh, &mut y, &settings).expect("passes");
    println!("{outcome:?}");
    assert!(outcome.before.inverted > 1000, "{outcome:?}");
    assert_eq!(outcome.after.inverted, 0);
    assert!(outcome.after.min_angle_degrees > 5.0);
    assert!(outcome.distance <= 0.01 && change_of_box(&s.x, &y) <= 0.02);
    let off = y
        .iter()
        .map(|p| (p.length() - 1.0).abs())
        .fold(0.0, f64::max);
    assert!(off < 0.02, "{off}");
}

/// A closed surface of some kind, badly meshed in some way.
fn any_closed(random: &mut Random) -> (String, Surface) {
    let mut between = |low: f64, high: f64| low + 0.5 * (random.next() + 1.0) * (high - low);
    let kind = between(0.0, 8.0) as usize;
    let count = |share: f64, low: u32, high: u32| low + (share * f64::from(high - low)) as u32;
    let soup = match kind {
        0 => {
            let outline = parts::circle(count(between(0.0, 1.0), 3, 40), between(0.3, 3.0));
            let ends = if between(0.0, 1.0) < 0.5 {
                Ends::Fan
            } else {
                Ends::Hub
            };
            parts::prism(&outline, &[0.0, between(0.01, 30.0)], ends)
        }
        1 => {
            let cut = between(-0.5, 0.9).max(0.0);
            let outline = parts::chamfered(between(2.0, 20.0), between(2.0, 6.0), cut);
            parts::prism(&outline, &[0.0, between(0.02, 5.0)], Ends::Fan)
        }
        2 => {
            let inner = between(0.5, 2.0);
            let outline = parts::gear(count(between(0.0, 1.0), 3, 20), inner, 1.2 * inner);
            parts::prism(&outline, &[0.0, between(0.1, 2.0)], Ends::Hub)
        }
        3 => {
            let outline = parts::circle(count(between(0.0, 1.0), 3, 40), 1.0);
            parts::prism(
                &outline,
                &[0.0, between(0.05, 1.0)],
                Ends::Tip(between(0.0, 10.0)),
            )
        }
        4 => shape_of("ellipsoid", &[("level", 2.0), ("c", between(0.05, 2.0))]),
        5 => shape_of("sampled-torus", &[("jitter", between(0.0, 0.5))]),
        6 => shape_of(
            "uv-sphere",
            &[("rings", 9.0), ("segments", between(3.0, 40.0).floor())],
        ),
        _ => shape_of("dumbbell", &[("level", 2.0), ("waist", between(0.02, 0.9))]),
    };
    let levels = if soup.positions.len() < 150 {
        between(0.0, 3.0) as usize
    } else {
        0
    };
    let (share, noise) = (between(-0.3, 0.6), between(-0.3, 0.5));
    let mut soup = parts::refined(&soup, levels);
    if share > 0.0 {
        soup = parts::crumpled(&soup, share, kind as u64);
    }
    let turn = DQuat::from_scaled_axis(random.vector() * 3.0);
    let scale = 10f64.powf(3.0 * random.next());
    let mut s = surface(&soup);
    let edge = measure::mean_edge_length(&s.mesh, &s.x);
    let (is_noisy, is_turned) = (noise > 0.0, random.next() > 0.0);
    for p in &mut s.x {
        if is_noisy {
            *p += noise * edge * random.vector();
        }
        if is_turned {
            *p = scale * (turn * *p);
        }
    }
    let what = format!("kind {kind}, {levels} levels, {share:.2}, {noise:.2}");
    (what, s)
}

/// Whatever comes, with whatever settings, is the same surface afterwards or refused.
#[test]
fn any_closed_surface_keeps_its_shape_or_is_refused() {
    let mut random = Random(18);
    let mut refused = 0;
    for n in 0..80 {
        let (what, s) = any_closed(&mut random);
        let mut settings = RegulariseOptions::default();
        if n % 3 == 2 {
            let one_of =
                |values: &[f64], r: f64| values[(0.5 * (r + 1.0) * values.len() as f64) as usize];
            settings.epsilon = one_of(&[1e-3, 1e-1, 1e1], random.next());
            settings.features = one_of(&[0.0, 0.3], random.next());
            settings.iterations = one_of(&[1.0, 20.0], random.next()) as usize;
            if random.next() > 0.0 {
                settings.mode = Mode::Linear;
            }
        }
        let what = format!("{n}: {what}");
        refused += usize::from(keeps_its_shape(&what, &s, &settings).is_none());
    }
    println!("{refused} refused");
    assert!(refused < 40, "{refused}");
}
