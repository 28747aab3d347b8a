//! The pass on surfaces whose shape is known.

use super::*;
use crate::geometry::curvature::area_gradient;
use crate::geometry::measure::{area, edge_length, min_angle_degrees, vertex_areas, volume};
use crate::mesh::noise::SplitMix64;
use crate::mesh::shape::{blocks, make};
use crate::mesh::{Built, Vertex, build};
use glam::DQuat;
use std::collections::BTreeSet;

fn sample(name: &str, values: &[(&str, f64)]) -> Built {
    let values: Vec<_> = values.iter().map(|(n, v)| ((*n).into(), *v)).collect();
    build(&make(name, &values).expect("a shape").soup).expect("a surface")
}

fn clifford(n: f64) -> Built {
    sample("clifford-torus", &[("around", n), ("tube", n)])
}

/// A mesh with its vertices displaced by a share of the mean edge in every direction.
fn shaken(mut s: Built, share: f64) -> Built {
    let h = share * measure::mean_edge_length(&s.mesh, &s.positions);
    let mut random = SplitMix64::new(7);
    for p in &mut s.positions {
        let [x, y, z] = std::array::from_fn(|_| 2.0 * random.uniform() - 1.0);
        *p += h * DVec3::new(x, y, z);
    }
    s
}

/// ∫H² with the lumped mass.
fn willmore(mesh: &HalfedgeMesh, x: &[DVec3]) -> f64 {
    let (g, a) = (area_gradient(mesh, x), vertex_areas(mesh, x));
    let terms = g.iter().zip(&a);
    terms.map(|(g, a)| g.length_squared() / (4.0 * a)).sum()
}

fn kept(s: &Built) -> Targets {
    Targets {
        area: area(&s.mesh, &s.positions),
        volume: None,
    }
}

fn passed(s: &Built, kind: Kind) -> Remeshed {
    pass(&s.mesh, &s.positions, kind, s.positions.len(), kept(s)).expect("a pass")
}

fn bits(r: &Remeshed) -> (Vec<u32>, Vec<[u64; 3]>) {
    let x = r.positions.iter().map(|p| p.to_array().map(f64::to_bits));
    (r.mesh.triangle_indices(), x.collect())
}

#[test]
fn a_pass_over_the_clifford_torus_keeps_energy_volume_and_topology() {
    let s = clifford(40.0);
    let (w, v) = (
        willmore(&s.mesh, &s.positions),
        volume(&s.mesh, &s.positions).expect("closed"),
    );
    for kind in [Kind::Adaptive, Kind::Isotropic] {
        let r = passed(&s, kind);
        r.mesh.validate().expect("valid");
        assert_eq!(r.mesh.euler_characteristic(), 0);
        assert!(r.mesh.is_closed() && r.mesh.is_oriented());
        let drift = area(&r.mesh, &r.positions) / kept(&s).area - 1.0;
        assert!(drift.abs() < 1e-13, "{kind:?}: area {drift:e}");
        let change = willmore(&r.mesh, &r.positions) / w - 1.0;
        assert!(change.abs() < 0.015, "{kind:?}: energy {change:e}");
        // Not turned inside out, and no flatter.
        let change = volume(&r.mesh, &r.positions).expect("closed") / v - 1.0;
        let most = if kind == Kind::Adaptive { 1e-4 } else { 2e-3 };
        assert!(change.abs() < most, "{kind:?}: volume {change:e}");
        let count = r.positions.len() as f64 / s.positions.len() as f64;
        let most = if kind == Kind::Adaptive { 0.02 } else { 0.25 };
        assert!(
            (count - 1.0).abs() < most,
            "{kind:?}: {count} of the vertices"
        );
    }
}

#[test]
fn a_sphere_at_rest_is_left_alone() {
    let s = sample("icosphere", &[("level", 4.0)]);
    let r = passed(&s, Kind::Adaptive);
    let touched = r.counts.splits + r.counts.collapses;
    assert!(100 * touched < s.positions.len(), "{:?}", r.counts);
    let change = willmore(&r.mesh, &r.positions) / willmore(&s.mesh, &s.positions) - 1.0;
    assert!(change.abs() < 1e-3, "{change:e}");
    let sound = Soundness::of(&r.mesh, &r.positions, willmore(&r.mesh, &r.positions));
    assert!(sound.is_sound);
    assert!(!is_due(
        &r.mesh,
        &r.positions,
        Kind::Adaptive,
        s.positions.len()
    ));
}

/// Root mean square of the distances from the torus of revolution with radii √2 and 1.
fn off_the_torus(x: &[DVec3]) -> f64 {
    let off = |p: &DVec3| (p.x.hypot(p.y) - 2f64.sqrt()).hypot(p.z) - 1.0;
    let squares: f64 = x.iter().map(|p| off(p).powi(2)).sum();
    (squares / x.len() as f64).sqrt()
}

#[test]
fn vertices_stay_on_a_smooth_surface_to_the_third_order() {
    let errors = [24.0, 48.0, 96.0].map(|n| {
        let s = clifford(n);
        let draft = Draft::of(&s.mesh, &s.positions, &vec![false; s.positions.len()]);
        let mut draft = draft;
        // Without the scaling, which makes up for chords being shorter than arcs.
        for _ in 0..ROUNDS {
            round(
                &mut draft,
                Kind::Adaptive,
                s.positions.len(),
                &mut Counts::default(),
            );
        }
        off_the_torus(&draft.x)
    });
    for pair in errors.windows(2) {
        let order = (pair[0] / pair[1]).log2();
        assert!(order > 2.7, "{errors:?}: order {order}");
    }
}

#[test]
fn angles_become_better_and_the_same_input_gives_the_same_mesh() {
    let s = shaken(
        sample("ellipsoid", &[("level", 3.0), ("jitter", 0.2)]),
        0.02,
    );
    let before = min_angle_degrees(&s.mesh, &s.positions);
    let r = passed(&s, Kind::Adaptive);
    let after = min_angle_degrees(&r.mesh, &r.positions);
    assert!(before < 12.0 && after > 25.0, "{before} -> {after}");
    assert!(bits(&r) == bits(&passed(&s, Kind::Adaptive)));
}

#[test]
fn size_and_place_change_nothing() {
    let s = shaken(sample("ellipsoid", &[("level", 3.0)]), 0.01);
    let counts = passed(&s, Kind::Adaptive).counts;
    assert!(counts.flips > 0);
    let turn = DQuat::from_axis_angle(DVec3::new(0.6, 0.0, 0.8), 0.7);
    for scale in [1e-4, 1e4] {
        let mut other = s.clone();
        for p in &mut other.positions {
            *p = scale * (turn * *p + DVec3::new(0.3, 0.2, 0.1));
        }
        assert_eq!(passed(&other, Kind::Adaptive).counts, counts, "{scale}");
    }
}

#[test]
fn a_volume_is_kept_with_the_area() {
    let s = shaken(sample("ellipsoid", &[("level", 3.0)]), 0.01);
    let v = volume(&s.mesh, &s.positions);
    let targets = Targets {
        volume: v,
        ..kept(&s)
    };
    let n = s.positions.len();
    let r = pass(&s.mesh, &s.positions, Kind::Adaptive, n, targets).expect("a pass");
    let [a, v] = [
        area(&r.mesh, &r.positions) / targets.area - 1.0,
        volume(&r.mesh, &r.positions).expect("closed") / v.expect("closed") - 1.0,
    ];
    assert!(a.abs() < 1e-13 && v.abs() < 1e-10, "{a:e}, {v:e}");
}

/// Edges between held vertices, as positions.
fn held_edges(mesh: &HalfedgeMesh, x: &[DVec3], held: &[bool]) -> BTreeSet<[[u64; 3]; 2]> {
    let bits = |v: Vertex| x[v.index()].to_array().map(f64::to_bits);
    let edges = mesh.edges().map(|e| mesh.ends(e));
    let both = edges.filter(|ends| ends.iter().all(|v| held[v.index()]));
    both.map(|ends| {
        let mut ends = ends.map(bits);
        ends.sort_unstable();
        ends
    })
    .collect()
}

#[test]
fn what_is_held_and_the_boundary_stay_bit_for_bit() {
    for name in ["icosphere", "hemisphere"] {
        let s = shaken(sample(name, &[]), 0.01);
        let held: Vec<bool> = s.positions.iter().map(|p| p.x > 0.4).collect();
        let n = 2 * s.positions.len();
        let r = remesh(
            &s.mesh,
            &s.positions,
            Kind::Adaptive,
            n,
            &held,
            Creases::Keep,
        )
        .expect("a mesh");
        r.mesh.validate().expect("valid");
        assert_eq!(r.mesh.euler_characteristic(), s.mesh.euler_characteristic());
        let rim = s.mesh.vertices().map(|v| s.mesh.is_boundary_vertex(v));
        let held: Vec<bool> = rim.zip(held).map(|(rim, held)| rim || held).collect();
        let before = held_edges(&s.mesh, &s.positions, &held);
        let after = held_edges(&r.mesh, &r.positions, &r.held);
        assert!(before.len() > 100 && before == after, "{name}");
        let count = |held: &[bool]| held.iter().filter(|h| **h).count();
        assert_eq!(count(&held), count(&r.held));
        let ratio = r.positions.len() as f64 / n as f64;
        assert!((ratio - 1.0).abs() < 0.15, "{name}: {ratio} of the budget");
        // Each held vertex knows where it was.
        for (v, _) in r.held.iter().enumerate().filter(|(_, held)| **held) {
            assert_eq!(s.positions[r.origins[v].nearest() as usize], r.positions[v]);
            assert_eq!(r.origins[v].weights, [1.0, 0.0, 0.0]);
        }
    }
}

#[test]
fn origins_carry_what_was_known() {
    let s = clifford(48.0);
    let r = remesh(
        &s.mesh,
        &s.positions,
        Kind::Adaptive,
        4000,
        &vec![false; 48 * 48],
        Creases::Keep,
    );
    let r = r.expect("a mesh");
    let height = |v: u32| s.positions[v as usize].z;
    let errors = r.origins.iter().zip(&r.positions);
    let worst = errors
        .map(|(o, p)| (o.mean(height) - p.z).abs())
        .fold(0.0, f64::max);
    // Linear on faces with edges of 0.13: h²/8 of it.
    assert!(worst < 6e-3, "{worst}");
    for origin in &r.origins {
        assert!((origin.weights.iter().sum::<f64>() - 1.0).abs() < 1e-12);
    }
}

#[test]
fn edges_follow_the_curvature_within_the_budget() {
    let s = sample(
        "ellipsoid",
        &[("a", 3.0), ("b", 1.0), ("c", 1.0), ("level", 4.0)],
    );
    let free = vec![false; s.positions.len()];
    for vertices in [800, 6000] {
        let made = |kind| {
            let r = remesh(&s.mesh, &s.positions, kind, vertices, &free, Creases::Keep)
                .expect("a mesh");
            let ratio = r.positions.len() as f64 / vertices as f64;
            assert!((ratio - 1.0).abs() < 0.1, "{kind:?}: {ratio} of {vertices}");
            assert!(min_angle_degrees(&r.mesh, &r.positions) > 25.0);
            let mean = |near_tip: bool| {
                let ends = |e| r.mesh.ends(e).map(|v| r.positions[v.index()].x.abs());
                let there = r.mesh.edges().filter(|&e| (ends(e)[0] > 2.8) == near_tip);
                let lengths: Vec<f64> = there
                    .map(|e| edge_length(&r.mesh, &r.positions, e))
                    .collect();
                lengths.iter().sum::<f64>() / lengths.len() as f64
            };
            mean(false) / mean(true)
        };
        let (adaptive, isotropic) = (made(Kind::Adaptive), made(Kind::Isotropic));
        assert!(adaptive > 1.5 && (isotropic - 1.0).abs() < 0.1);
    }
}

#[test]
fn what_cannot_be_remeshed_is_named() {
    let s = sample("icosphere", &[("level", 2.0)]);
    let refused = |s: &Built, held: bool| {
        let held = vec![held; s.positions.len()];
        remesh(
            &s.mesh,
            &s.positions,
            Kind::Adaptive,
            100,
            &held,
            Creases::Keep,
        )
        .err()
    };
    assert_eq!(refused(&s, false), None);
    assert_eq!(refused(&s, true), Some(RemeshError::AllHeld));
    let moebius = sample("moebius", &[]);
    assert_eq!(refused(&moebius, false), Some(RemeshError::NotOriented));
    // A pass that would have to move vertices far for the volume is none.
    let targets = Targets {
        volume: Some(1.0),
        ..kept(&s)
    };
    let spoilt = pass(&s.mesh, &s.positions, Kind::Adaptive, 162, targets).err();
    assert_eq!(spoilt, Some(RemeshError::Spoilt));
}
/// A mesh folded over in places, with a fifth more area than its surface.
#[test]
fn folds_are_smoothed_away() {
    let values = [("level", 3.0), ("jitter", 0.5)];
    let s = sample("ellipsoid", &values);
    let smooth = sample("ellipsoid", &[("level", 3.0)]);
    let [folded, expected] = [&s, &smooth].map(|s| area(&s.mesh, &s.positions));
    assert!(folded > 1.15 * expected);
    let free = vec![false; s.positions.len()];
    for kind in [Kind::Adaptive, Kind::Isotropic] {
        let r = remesh(
            &s.mesh,
            &s.positions,
            kind,
            free.len(),
            &free,
            Creases::Keep,
        )
        .expect("a mesh");
        let found = area(&r.mesh, &r.positions) / expected - 1.0;
        assert!(found.abs() < 5e-3, "{kind:?}: area {found:e}");
        let angle = min_angle_degrees(&r.mesh, &r.positions);
        assert!(angle > 25.0, "{kind:?}: {angle}");
    }
}

/// Edges have the length that is asked for, of an open surface those away from its boundary, which
/// stays: counted with it they were up to a sixth longer.
#[test]
fn edges_have_the_length_that_is_asked_for() {
    for name in ["disk", "hemisphere", "icosphere"] {
        let s = sample(name, &[]);
        for times in [0.6, 1.5] {
            let length = times * measure::mean_edge_length(&s.mesh, &s.positions);
            let held = vec![false; s.positions.len()];
            let wanted = vertices_for(&s.mesh, &s.positions, &held, length).expect("a number");
            let kind = Kind::Isotropic;
            let made = remesh(
                &s.mesh,
                &s.positions,
                kind,
                wanted.round() as usize,
                &held,
                Creases::Keep,
            );
            let made = made.expect("a mesh");
            let inside = |e: &crate::mesh::Edge| {
                let ends = made.mesh.ends(*e);
                ends.iter().all(|v| !made.mesh.is_boundary_vertex(*v))
            };
            let lengths = made.mesh.edges().filter(inside);
            let lengths: Vec<f64> = lengths
                .map(|e| edge_length(&made.mesh, &made.positions, e))
                .collect();
            let mean = lengths.iter().sum::<f64>() / lengths.len() as f64;
            assert!(
                (mean / length - 1.0).abs() < 0.06,
                "{name} {times}: {}",
                mean / length
            );
        }
    }
}

/// Blocks of unit cubes, a bar and a letter C, with right angles outwards and inwards.
#[test]
fn edges_of_the_shape_stay_where_they_are() {
    for (soup, cubes) in [(blocks::handles(0, 0), 3.0), (blocks::letter_c(0), 11.0)] {
        let built = build(&soup.expect("triangles")).expect("a surface");
        let x = &built.positions;
        let free = vec![false; x.len()];
        let whole = [
            area(&built.mesh, x),
            volume(&built.mesh, x).expect("closed"),
        ];
        assert!((whole[1] - cubes).abs() < 1e-12);
        let bounds = |x: &[DVec3]| {
            let low = x.iter().fold(DVec3::INFINITY, |low, p| low.min(*p));
            (
                low,
                x.iter().fold(DVec3::NEG_INFINITY, |high, p| high.max(*p)),
            )
        };
        for kind in [Kind::Adaptive, Kind::Isotropic] {
            let mut before = (built.mesh.clone(), x.clone());
            // Finer and coarser again: along edges too there are fewer.
            for wanted in [1500, 300] {
                let held = vec![false; before.1.len()];
                let made = remesh(&before.0, &before.1, kind, wanted, &held, Creases::Keep);
                let made = made.expect("a mesh");
                let y = &made.positions;
                let count = y.len() as f64 / wanted as f64;
                assert!((count - 1.0).abs() < 0.05, "{kind:?}: {}", y.len());
                let now = [area(&made.mesh, y), volume(&made.mesh, y).expect("closed")];
                for (now, whole) in now.iter().zip(whole) {
                    assert!((now / whole - 1.0).abs() < 1e-12, "{kind:?}: {now} {whole}");
                }
                let ((low, high), (first, last)) = (bounds(y), bounds(x));
                assert!((low - first).abs().max_element() < 1e-12, "{low} {high}");
                assert!((high - last).abs().max_element() < 1e-12, "{low} {high}");
                assert!(!made.held.contains(&true));
                if wanted == 1500 {
                    assert!(min_angle_degrees(&made.mesh, y) > 24.0);
                }
                before = (made.mesh, made.positions);
            }
        }
        // Taken for noise they are rounded.
        let rounded = remesh(
            &built.mesh,
            x,
            Kind::Isotropic,
            1500,
            &free,
            Creases::Smooth,
        );
        let corner = |r: Remeshed| r.positions.contains(&bounds(x).0);
        assert!(!rounded.is_ok_and(corner));
    }
}
