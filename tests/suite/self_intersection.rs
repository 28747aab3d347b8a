//! Where surfaces pass through themselves: closed forms, brute force by another formula,
//! invariance.

use crate::support::*;
use glam::{DMat3, DVec3};
use proptest::prelude::*;
use std::collections::BTreeMap;
use std::f64::consts::TAU;
use umbilic::app::{Notice, Session};
use umbilic::flow::options::FlowOptions;
use umbilic::geometry::measure::{bounding_diagonal, triangle_points};
use umbilic::geometry::self_intersection::{
    CONTACT, curves_within, pairs, pairs_within, triangles,
};
use umbilic::io::{self, Format};
use umbilic::mesh::{Face, Vertex, shape};
use umbilic::soup::PolygonSoup;

/// Several surfaces in one soup.
fn together(parts: &[PolygonSoup]) -> PolygonSoup {
    let mut all = PolygonSoup::default();
    for part in parts {
        let first = all.positions.len() as u32;
        all.positions.extend(&part.positions);
        for face in part.faces() {
            let corners: Vec<u32> = face.iter().map(|v| v + first).collect();
            all.push_face(&corners);
        }
    }
    all
}

fn moved(mut soup: PolygonSoup, map: impl Fn(DVec3) -> DVec3) -> PolygonSoup {
    soup.positions.iter_mut().for_each(|p| *p = map(*p));
    soup
}

/// A rotation by no special angle.
fn turned() -> DMat3 {
    DMat3::from_axis_angle(DVec3::new(0.3, -0.5, 0.8).normalize(), 0.7)
}

fn tetrahedron(corners: [DVec3; 4]) -> PolygonSoup {
    let faces = [[0u32, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
    PolygonSoup::from_faces(corners.to_vec(), &faces)
}

/// The box `[low, high]`, each side cut into `cells` × `cells` squares of two triangles.
fn block(low: DVec3, high: DVec3, cells: u32) -> PolygonSoup {
    let mut index = BTreeMap::new();
    let mut soup = PolygonSoup::default();
    for (axis, side) in (0..3).flat_map(|axis| [(axis, 0), (axis, cells)]) {
        let mut at = |i: u32, j: u32| {
            let mut key = [0; 3];
            key[axis] = side;
            key[(axis + 1) % 3] = i;
            key[(axis + 2) % 3] = j;
            *index.entry(key).or_insert_with(|| {
                let share = DVec3::from_array(key.map(f64::from)) / f64::from(cells);
                soup.positions.push(low + share * (high - low));
                soup.positions.len() as u32 - 1
            })
        };
        let mut faces = Vec::new();
        for (i, j) in (0..cells).flat_map(|i| (0..cells).map(move |j| (i, j))) {
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            let outwards = side > 0;
            faces.push(if outwards { [a, b, c] } else { [a, c, b] });
            faces.push(if outwards { [a, c, d] } else { [a, d, c] });
        }
        faces.iter().for_each(|face| soup.push_face(face));
    }
    soup
}

/// Sweeps a closed curve of the half-plane about the z axis; `flips` turns it over once on the
/// way round.
fn swept(
    around: usize,
    along: usize,
    flips: bool,
    curve: impl Fn(f64, f64) -> DVec3,
) -> PolygonSoup {
    let mut soup = PolygonSoup::default();
    for k in 0..around * along {
        let (u, v) = (k / along, k % along);
        let [u, v] = [u as f64 / around as f64, v as f64 / along as f64];
        soup.positions.push(curve(TAU * u, TAU * v));
    }
    let at = |i: usize, j: usize| {
        let j = if i == around && flips {
            2 * along - j
        } else {
            j
        };
        ((i % around) * along + j % along) as u32
    };
    for (i, j) in (0..around).flat_map(|i| (0..along).map(move |j| (i, j))) {
        let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        soup.push_face(&[a, b, c]);
        soup.push_face(&[a, c, d]);
    }
    soup
}

/// The torus with a figure eight for a cross-section, Lawson's way of immersing it; its row
/// `v = phase` and the one opposite lie on each other for phase 0.
fn figure_eight_torus(around: usize, along: usize, phase: f64) -> PolygonSoup {
    swept(around, along, false, |u, v| {
        let v = v + phase;
        let radius = 2.0 + v.sin();
        DVec3::new(radius * u.cos(), radius * u.sin(), (2.0 * v).sin() / 2.0)
    })
}

/// The Klein bottle of a figure eight that makes half a turn on the way round.
fn figure_eight_klein(around: usize, along: usize) -> PolygonSoup {
    swept(around, along, true, |u, v| {
        let (p, q) = (v.sin(), (2.0 * v).sin());
        let half = 0.5 * u;
        let radius = 2.0 + half.cos() * p - half.sin() * q;
        let z = half.sin() * p + half.cos() * q;
        DVec3::new(radius * u.cos(), radius * u.sin(), z)
    })
}

fn count(soup: &PolygonSoup) -> usize {
    let Surface { mesh, x, .. } = surface(soup);
    pairs(&mesh, &x).len()
}

/// The same count in other places, of other sizes and turned.
fn counts(soup: &PolygonSoup) -> Vec<usize> {
    let turn = turned();
    let moves: [&dyn Fn(DVec3) -> DVec3; 8] = [
        &|p| p,
        &|p| turn * p,
        &|p| p * 1e-4,
        &|p| turn * p * 1e4,
        &|p| p / 3.0,
        &|p| p + DVec3::splat(1e5),
        &|p| turn * p + DVec3::new(1e5, -1e5, 1e5),
        &|p| (turn * p) * 1e-4 + DVec3::new(3.0, 7.0, -10.0),
    ];
    moves.map(|map| count(&moved(soup.clone(), map))).to_vec()
}

/// Signed volume of a tetrahedron, times six.
fn volume([a, b, c, d]: [DVec3; 4]) -> f64 {
    (b - a).cross(c - a).dot(d - a)
}

/// Whether a segment goes through a triangle; `None` if that changes as a volume changes by
/// `margin`.
fn pierces([p, q]: [DVec3; 2], [a, b, c]: [DVec3; 3], margin: f64) -> Option<bool> {
    let ends = [volume([a, b, c, p]), volume([a, b, c, q])];
    let about = [[a, b], [b, c], [c, a]].map(|[u, v]| volume([p, q, u, v]));
    let any = |of: &[f64], sign: f64| of.iter().any(|v| sign * v > margin);
    let all = |of: &[f64], sign: f64| of.iter().all(|v| sign * v > margin);
    let misses = all(&ends, 1.0) || all(&ends, -1.0) || (any(&about, 1.0) && any(&about, -1.0));
    let hits = any(&ends, 1.0) && any(&ends, -1.0) && (all(&about, 1.0) || all(&about, -1.0));
    (misses || hits).then_some(hits)
}

/// An edge of one triangle that goes through another: the edge's ends and the triangle.
type Piercing = ([Vertex; 2], Face);

/// By brute force, which edges of two triangles without a common edge go through the other, and
/// whether `margin` could add one.
fn piercings(s: &Surface, [f, g]: [Face; 2], margin: f64) -> (Vec<Piercing>, bool) {
    let at = |v: Vertex| s.x[v.index()];
    let (own, other) = (s.mesh.triangle(f), s.mesh.triangle(g));
    let (mut found, mut is_sure) = (Vec::new(), true);
    for (edges, through, face) in [(own, other, g), (other, own, f)] {
        for k in 0..3 {
            let [p, q] = [edges[k], edges[(k + 1) % 3]];
            if through.contains(&p) || through.contains(&q) {
                continue;
            }
            match pierces([at(p), at(q)], through.map(at), margin) {
                Some(true) => found.push(([p.min(q), p.max(q)], face)),
                Some(false) => {}
                None => is_sure = false,
            }
        }
    }
    (found, is_sure)
}

/// Compares with brute force, leaving out what depends on `margin`; answers the number of pairs
/// found and of pairs left out.
fn check(s: &Surface, margin: f64) -> Result<(usize, usize), String> {
    let found = pairs(&s.mesh, &s.x);
    if !found.is_sorted() || found.iter().any(|[f, g]| f >= g) {
        return Err("not sorted, or not each once".into());
    }
    let boxes: Vec<[DVec3; 2]> = s
        .mesh
        .faces()
        .map(|f| triangle_points(&s.mesh, &s.x, f))
        .map(|[a, b, c]| [a.min(b).min(c), a.max(b).max(c)])
        .collect();
    let is_apart = |f: Face, g: Face| {
        let ([low, high], [l, h]) = (boxes[f.index()], boxes[g.index()]);
        low.cmpgt(h).any() || l.cmpgt(high).any()
    };
    let mut left_out = 0;
    for g in s.mesh.faces() {
        let other = s.mesh.triangle(g);
        for f in (0..g.0).map(Face) {
            let is_found = found.binary_search(&[f, g]).is_ok();
            if is_apart(f, g) && !is_found {
                continue;
            }
            let common = s
                .mesh
                .triangle(f)
                .iter()
                .filter(|v| other.contains(v))
                .count();
            if common > 1 {
                continue;
            }
            let (crossings, is_sure) = piercings(s, [f, g], margin);
            if crossings.is_empty() && !is_sure {
                left_out += 1;
            } else if crossings.is_empty() == is_found {
                return Err(format!("{f:?} and {g:?}: {crossings:?}, found: {is_found}"));
            }
        }
    }
    Ok((found.len(), left_out))
}

#[test]
fn crossing_tetrahedra_have_the_pairs_that_can_be_counted() {
    let corners = [
        [1.0, 1.0, 1.0],
        [1.0, -1.0, -1.0],
        [-1.0, 1.0, -1.0],
        [-1.0, -1.0, 1.0],
    ];
    let regular = tetrahedron(corners.map(DVec3::from_array));
    let opposite = moved(regular.clone(), |p| -p);
    // Kepler's stella octangula: the inside of both is an octahedron, each of whose twelve edges
    // is where a face of one meets a face of the other. Edges cross edges, at the six corners.
    let stella = together(&[regular.clone(), opposite]);
    assert_eq!(counts(&stella), [12; 8]);

    // A needle with its point inside goes through one face with three of its own; longer, it
    // comes out through the corner's three faces: through one of them only, off the axis.
    let needle = |tip: f64| {
        let axis = DVec3::new(1.0, 1.1, 1.2).normalize();
        let (u, v) = axis.any_orthonormal_pair();
        let at = |along: f64, angle: f64| along * axis + 0.02 * (angle.cos() * u + angle.sin() * v);
        let base = |k: f64| at(-2.0, 0.4 + k * TAU / 3.0);
        together(&[
            regular.clone(),
            tetrahedron([base(0.0), base(1.0), base(2.0), tip * axis]),
        ])
    };
    assert_eq!(counts(&needle(-1.0)), [0; 8]);
    assert_eq!(counts(&needle(0.0)), [3; 8]);
    let Surface { mesh, x, .. } = surface(&needle(0.0));
    let found = pairs(&mesh, &x);
    assert_eq!(triangles(&found).len(), 4, "{found:?}");
    // Out again through one more.
    let skewer = needle(0.0);
    let pushed = PolygonSoup {
        positions: skewer
            .positions
            .iter()
            .enumerate()
            .map(|(v, &p)| {
                if v == 7 {
                    DVec3::new(-0.1, 0.1, 2.0)
                } else {
                    p
                }
            })
            .collect(),
        ..skewer
    };
    assert_eq!(counts(&pushed), [6; 8]);
}

#[test]
fn crossing_spheres_meet_in_closed_curves() {
    for (level, shift) in [
        (2.0, DVec3::new(0.81, 0.33, -0.47)),
        (3.0, DVec3::new(1.13, -0.61, 0.29)),
    ] {
        let sphere = sample("icosphere", &[("level", level)]);
        let other = moved(sphere.clone(), |p| turned() * p + shift);
        let s = surface(&together(&[sphere, other]));
        let (found, left_out) = check(&s, 0.0).expect("as by brute force");
        assert!(found > 20 && left_out == 0, "{found}");
        // Each pair meets in a segment with two ends, and each end is that of one more pair.
        let mut ends: BTreeMap<Piercing, usize> = BTreeMap::new();
        for [f, g] in pairs(&s.mesh, &s.x) {
            let (crossings, _) = piercings(&s, [f, g], 0.0);
            assert_eq!(crossings.len(), 2, "{f:?}, {g:?}");
            crossings
                .into_iter()
                .for_each(|p| *ends.entry(p).or_default() += 1);
        }
        assert!(ends.values().all(|&n| n == 2), "{ends:?}");
        assert_eq!(ends.len(), found);
    }
}

#[test]
fn what_touches_does_not_cross() {
    let cube = block(DVec3::ZERO, DVec3::ONE, 2);
    let at = |low: [f64; 3], size: f64, cells: u32| {
        let low = DVec3::from_array(low);
        block(low, low + size, cells)
    };
    for (name, other) in [
        ("apart", at([1.5, 0.0, 0.0], 1.0, 2)),
        ("face on face", at([1.0, 0.0, 0.0], 1.0, 2)),
        ("with another grid", at([1.0, 0.0, 0.0], 1.0, 3)),
        ("smaller face", at([1.0, 0.3, 0.2], 0.5, 2)),
        ("larger face", at([1.0, -0.5, -0.7], 3.0, 3)),
        ("half a face", at([1.0, 0.5, 0.0], 1.0, 2)),
        ("edge on edge", at([1.0, 1.0, 0.0], 1.0, 2)),
        ("half an edge", at([1.0, 1.0, 0.25], 1.0, 3)),
        ("corner to corner", at([1.0, 1.0, 1.0], 1.0, 2)),
        ("inside", at([0.2, 0.2, 0.2], 0.5, 1)),
    ] {
        assert_eq!(counts(&together(&[cube.clone(), other])), [0; 8], "{name}");
    }
    // A roof that stands on the cube with its ridge, and one with its edge.
    for point in [[0.5, 0.5, 1.0], [0.3, 0.0, 1.0]] {
        let tip = DVec3::from_array(point);
        let up = [[0.3, 0.1, 1.0], [-0.3, 0.2, 1.1], [0.1, -0.4, 1.3]].map(DVec3::from_array);
        let cone = tetrahedron([tip + up[0], tip + up[1], tip + up[2], tip]);
        assert_eq!(
            counts(&together(&[cube.clone(), cone])),
            [0; 8],
            "tip at {point:?}"
        );
        let ridge = [tip - 0.2 * DVec3::X, tip + 0.2 * DVec3::X];
        let roof = tetrahedron([ridge[0], ridge[1], tip + up[0], tip + up[2]]);
        assert_eq!(
            counts(&together(&[cube.clone(), roof])),
            [0; 8],
            "ridge at {point:?}"
        );
    }
}

#[test]
fn a_depth_beyond_contact_is_a_crossing() {
    let cube = block(DVec3::ZERO, DVec3::ONE, 2);
    let shifted = |depth: f64| {
        let low = DVec3::new(1.0 - depth, 0.31, 0.17);
        counts(&together(&[cube.clone(), block(low, low + 1.0, 3)]))
    };
    assert_eq!(shifted(1e-7), [0; 8]);
    let deep = shifted(1e-5);
    assert!(
        deep[0] > 10 && deep.iter().all(|&n| n == deep[0]),
        "{deep:?}"
    );
}

#[test]
fn healthy_surfaces_have_none() {
    for shape in shape::all() {
        let s = surface(&sample(shape.name, &[]));
        let found = pairs(&s.mesh, &s.x).len();
        match shape.name {
            // No Klein bottle and no projective plane can be embedded; what is halfway between the
            // two sides of a sphere passes through itself, and so does a surface that winds three
            // times about a branch point.
            "klein-bottle" | "boy" | "morin" | "inverted-enneper" => {
                assert!(found > 50, "{}: {found}", shape.name);
            }
            _ => assert_eq!(found, 0, "{}", shape.name),
        }
    }
    // Flat fans, turned so that their corners are in one plane only nearly.
    let plane = sample("disk", &[]);
    assert_eq!(counts(&plane), [0; 8]);
    let poles = sample("uv-sphere", &[]);
    assert_eq!(counts(&poles), [0; 8]);
    assert_eq!(
        counts(&block(DVec3::ZERO, DVec3::new(1.0, 0.1, 7.0), 9)),
        [0; 8]
    );
    // A plane as rough as single precision leaves it.
    let rough = moved(plane, |p| (turned() * p).as_vec3().as_dvec3());
    assert_eq!(counts(&rough), [0; 8]);
}

#[test]
fn immersions_cross_along_their_double_curves() {
    let mut random = Random(5);
    let generic = figure_eight_torus(40, 31, 0.1);
    let positions = generic
        .positions
        .iter()
        .map(|p| *p + 1e-3 * random.vector());
    let generic = surface(&PolygonSoup {
        positions: positions.collect(),
        ..generic
    });
    let (found, left_out) = check(&generic, 1e-9).expect("as by brute force");
    // The double curve is a circle of forty columns, on both sheets.
    assert!(found >= 40 && left_out < 10, "{found}, {left_out}");

    // Rows that lie on each other: along each of their edges, four pairs.
    for s in [figure_eight_torus(40, 32, 0.0), figure_eight_klein(40, 32)] {
        let all = counts(&s);
        assert!(all.iter().all(|&n| n == all[0]), "{all:?}");
        assert_eq!(all[0], 4 * 40);
    }
    let bottle = surface(&sample("klein-bottle", &[]));
    let (found, _) = check(&bottle, 1e-12).expect("as by brute force");
    assert!(found > 50, "{found}");
}

/// That of the torus with a figure eight for a section is a circle of radius 2, and as many pieces of
/// it as there are pairs make it up once.
#[test]
fn double_curves_are_those_of_the_smooth_surface() {
    let s = surface(&figure_eight_torus(80, 61, 0.1));
    let curves = curves_within(&s.mesh, &s.x, usize::MAX).expect("all");
    assert_eq!(curves.len(), pairs(&s.mesh, &s.x).len());
    let length: f64 = curves.iter().map(|[a, b]| a.distance(*b)).sum();
    assert!((length - 2.0 * TAU).abs() < 0.01, "{length}");
    for p in curves.iter().flatten() {
        let off = (p.truncate().length() - 2.0).hypot(p.z);
        assert!(off < 0.01, "{off}");
    }
    assert_eq!(curves_within(&s.mesh, &s.x, 10), None);
}

/// Around one vertex: the opposite edge of one triangle goes through another.
#[test]
fn triangles_with_a_common_vertex_may_cross() {
    let mut random = Random(3);
    let (mut crossing, mut left_out) = (0, 0);
    for _ in 0..200 {
        let spokes: Vec<DVec3> = (0..7).map(|_| random.vector()).collect();
        let mut positions = vec![DVec3::ZERO];
        positions.extend(spokes);
        let faces: Vec<[u32; 3]> = (0..7).map(|k| [0, k + 1, (k + 1) % 7 + 1]).collect();
        let s = surface(&PolygonSoup::from_faces(positions, &faces));
        let (found, unsure) = check(&s, 1e-5).expect("as by brute force");
        crossing += found;
        left_out += unsure;
    }
    assert!(crossing > 100 && left_out < 40, "{crossing}, {left_out}");
}

#[test]
fn triangles_with_a_common_edge_cross_when_folded() {
    let flap = |degrees: f64, height: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let positions = [
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [0.4, 0.8, 0.0],
            [0.7, height * cos, height * sin],
        ];
        PolygonSoup::from_faces(
            positions.map(DVec3::from_array).to_vec(),
            &[[0, 1, 2], [1, 0, 3]],
        )
    };
    for height in [0.5, 2.0, 1e-3] {
        assert_eq!(counts(&flap(0.0, height)), [1; 8], "{height}");
        for degrees in [0.1, 90.0, 179.0, 180.0, 181.0, 270.0, 359.9] {
            assert_eq!(
                counts(&flap(degrees, height)),
                [0; 8],
                "{degrees}, {height}"
            );
        }
    }
}

/// A sheet with a row of edges in the faces of another one crosses it, if it goes on beyond.
#[test]
fn edges_inside_of_triangles_cross_if_their_faces_part() {
    let corners = [[-1.0, -1.0], [2.0, -1.0], [2.0, 2.0], [-1.0, 2.0]];
    let floor = PolygonSoup::from_faces(
        corners.map(|[x, y]| DVec3::new(x, y, 0.0)).to_vec(),
        &[[0u32, 1, 2], [0, 2, 3]],
    );
    // Rows of four edges, at these heights.
    let wall = |rows: &[f64]| {
        let mut soup = PolygonSoup::default();
        for &z in rows {
            let row = (0..5).map(|k| DVec3::new(0.37, 0.25 * f64::from(k), z));
            soup.positions.extend(row);
        }
        for (i, k) in (1..rows.len() as u32).flat_map(|i| (0..4).map(move |k| (i, k))) {
            let (a, b) = (5 * (i - 1) + k, 5 * i + k);
            soup.push_face(&[a, a + 1, b + 1]);
            soup.push_face(&[a, b + 1, b]);
        }
        soup
    };
    let on = |wall: PolygonSoup| counts(&together(&[floor.clone(), wall]));
    // One of the edges lies in both triangles of the floor: five places with two faces each.
    assert_eq!(on(wall(&[-1.0, 0.0, 1.0])), [10; 8]);
    // It ends there, or turns back.
    assert_eq!(on(wall(&[0.0, 1.0])), [0; 8]);
    assert_eq!(on(wall(&[1.0, 0.5, 0.0])), [0; 8]);
    let bent = moved(wall(&[-1.0, 0.0, 1.0]), |p| {
        p.with_z(p.z.abs()) + DVec3::X * p.z
    });
    assert_eq!(on(bent), [0; 8]);
}

/// Heights about what counts as contact, on either side of it: noise must make no crossings of
/// triangles that lie beside each other.
#[test]
fn nearly_flat_fans_have_none() {
    let mut random = Random(23);
    for trial in 0..200 {
        let size = 1e-9 * 10f64.powf(f64::from(trial) / 40.0);
        let mut positions = vec![DVec3::ZERO];
        for ring in [1.0, 1.8] {
            for k in 0..7 {
                let angle = TAU * (f64::from(k) + 0.15 * random.next()) / 7.0;
                let p = ring * DVec3::new(angle.cos(), angle.sin(), 0.0);
                positions.push(p + size * random.next() * DVec3::Z);
            }
        }
        let mut soup = PolygonSoup {
            positions,
            ..PolygonSoup::default()
        };
        for k in 0..7 {
            let [a, b, c, d] = [1 + k, 1 + (k + 1) % 7, 8 + (k + 1) % 7, 8 + k];
            soup.push_face(&[0, a, b]);
            soup.push_face(&[a, d, c]);
            soup.push_face(&[a, c, b]);
        }
        assert_eq!(counts(&soup), [0; 8], "{size}");
    }
}

/// An edge that is in the plane of a triangle within contact, and beside it: the line in which the
/// planes meet goes through both, but at an angle to the edge, which is not on it.
#[test]
fn an_edge_beside_a_triangle_is_not_in_it() {
    let tent = |contact: f64| {
        // Heights over the triangle's plane, in which the first three corners are.
        let height = |x: f64, y: f64| (1.8 * y - x) * contact;
        let at = |x: f64, y: f64| DVec3::new(x, y, height(x, y));
        let beside = [[0.1, -3.0], [0.1, 3.0], [2.0, 0.0]].map(|[x, y]| DVec3::new(x, y, 0.0));
        let mut positions = beside.to_vec();
        positions.extend([at(0.0, -0.5), at(0.0, 0.5), at(-1.0, 1.0), -DVec3::Z]);
        PolygonSoup::from_faces(positions, &[[0u32, 1, 2], [3, 4, 5], [4, 3, 6]])
    };
    let contact = CONTACT * bounding_diagonal(&tent(0.0).positions);
    assert_eq!(counts(&tent(contact)), [0; 8]);
}

/// Two open sheets on the same line: four half-planes, which cross if they alternate.
#[test]
fn sheets_along_a_common_line_cross_if_they_alternate() {
    // A strip of three segments, bent along the x axis, its sides at these angles.
    let bent = |degrees: [f64; 2], offset: f64| {
        let mut soup = PolygonSoup::default();
        for k in 0..4 {
            let x = f64::from(k) + offset;
            soup.positions.push(DVec3::new(x, 0.0, 0.0));
            for angle in degrees.map(f64::to_radians) {
                soup.positions.push(DVec3::new(x, angle.cos(), angle.sin()));
            }
        }
        for k in 0..3u32 {
            for side in [1, 2] {
                let (a, b, c, d) = (3 * k, 3 * k + 3, 3 * k + 3 + side, 3 * k + side);
                soup.push_face(&[a, b, c]);
                soup.push_face(&[a, c, d]);
            }
        }
        soup
    };
    let crossing = |a: [f64; 2], b: [f64; 2], offset: f64| {
        let all = counts(&together(&[bent(a, 0.0), bent(b, offset)]));
        assert!(all.iter().all(|&n| n == all[0]), "{all:?}");
        all[0]
    };
    // Four pairs along each of the three common segments; shifted by half a segment, along five.
    assert_eq!(crossing([10.0, 190.0], [100.0, 280.0], 0.0), 12);
    assert_eq!(crossing([10.0, 190.0], [100.0, 280.0], 0.5), 20);
    assert_eq!(crossing([10.0, 100.0], [50.0, 200.0], 0.0), 12);
    // Wedges that touch with their ridges: beside each other, and one in the other.
    assert_eq!(crossing([-10.0, 10.0], [100.0, 260.0], 0.0), 0);
    assert_eq!(crossing([-10.0, 100.0], [20.0, 70.0], 0.5), 0);
    assert_eq!(crossing([10.0, 100.0], [20.0, 200.0], 3.5), 0);
    // One side on a side of the other: they touch along all of it.
    assert_eq!(crossing([10.0, 190.0], [10.0, 280.0], 0.0), 0);
}

#[test]
fn numbering_changes_nothing() {
    let sphere = sample("icosphere", &[("level", 2.0)]);
    let other = moved(sphere.clone(), |p| turned() * p + DVec3::new(0.8, 0.3, 0.5));
    let soup = together(&[sphere, other]);
    let named = |s: &Surface| {
        let corners = |f: Face| {
            let mut at = s
                .mesh
                .triangle(f)
                .map(|v| s.x[v.index()].to_array().map(f64::to_bits));
            at.sort_unstable();
            at
        };
        let mut all: Vec<_> = pairs(&s.mesh, &s.x)
            .iter()
            .map(|&[f, g]| (corners(f).min(corners(g)), corners(f).max(corners(g))))
            .collect();
        all.sort_unstable();
        all
    };
    // Every vertex and face to another place, corners and sides turned about.
    let (v, f) = (soup.positions.len(), soup.n_faces());
    let place = |i: usize| (i * 101 + 7) % v;
    let mut positions = vec![DVec3::ZERO; v];
    for (i, &p) in soup.positions.iter().enumerate() {
        positions[place(i)] = p;
    }
    let faces: Vec<[u32; 3]> = (0..f)
        .map(|k| {
            let [a, b, c] =
                [0, 1, 2].map(|i| place(soup.face(k * 77 % f)[(i + k) % 3] as usize) as u32);
            [b, a, c]
        })
        .collect();
    let renumbered = PolygonSoup::from_faces(positions, &faces);
    let (before, after) = (named(&surface(&soup)), named(&surface(&renumbered)));
    assert!(before.len() > 20);
    assert_eq!(before, after);
}

#[test]
fn real_meshes_as_by_brute_force() {
    for name in [
        "bunny.obj",
        "spot_low_resolution.obj",
        "cat_head.obj",
        "skull_low_resolution.obj",
        "double_torus_10k.obj",
        "borromean.obj",
        "trefoil_tube.obj",
    ] {
        let Some(s) = real(name) else { return };
        let size = bounding_diagonal(&s.x);
        let scaled = Surface {
            x: s.x.iter().map(|p| *p / size).collect(),
            ..s
        };
        assert_eq!(check(&scaled, 1e-12), Ok((0, 0)), "{name}");
    }
}

#[test]
fn a_heap_of_triangles_is_given_up() {
    let mut random = Random(11);
    let positions: Vec<DVec3> = (0..3 * 4500).map(|_| random.vector()).collect();
    let faces: Vec<[u32; 3]> = (0..4500).map(|k| [3 * k, 3 * k + 1, 3 * k + 2]).collect();
    let soup = PolygonSoup::from_faces(positions, &faces);
    let Surface { mesh, x, .. } = surface(&soup);
    assert_eq!(pairs_within(&mesh, &x, 100_000), None);
    // A sphere of as many triangles takes far fewer comparisons than that.
    let s = surface(&sample("icosphere", &[("level", 4.0)]));
    assert_eq!(
        pairs_within(&s.mesh, &s.x, 40 * s.mesh.n_faces()),
        Some(Vec::new())
    );

    let mut session = Session::new();
    let bytes = io::write(&soup, Format::Ply, "").expect("a file");
    let info = session.load(&bytes, "heap.ply").expect("a mesh").info;
    assert_eq!(info.self_intersections, None);
    assert!(
        info.warnings
            .iter()
            .all(|w| &*w.id != "notice-self-intersections")
    );
    // Asked for, it takes its time.
    let found = session.self_intersections().expect("a mesh");
    assert_eq!(found.map(|f| f.triangles.len()), Some(4500));
}

#[test]
fn a_session_tells_of_the_surface_as_it_is() {
    let mut session = Session::new();
    assert_eq!(
        session.self_intersections().expect_err("none").kind,
        "NoMesh"
    );
    let soup = figure_eight_torus(40, 31, 0.1);
    let bytes = io::write(&soup, Format::Obj, "").expect("a file");
    let loaded = session.load(&bytes, "eight.obj").expect("a mesh");
    let n = loaded.info.self_intersections.expect("counted");
    let told = Notice::SelfIntersections { count: n }.into();
    assert!(
        loaded.info.warnings.contains(&told),
        "{:?}",
        loaded.info.warnings
    );
    let found = session.self_intersections().expect("a mesh").expect("few");
    assert_eq!(found.pairs.len(), 2 * n);
    let mut own: Vec<u32> = found.pairs.to_vec();
    own.sort_unstable();
    own.dedup();
    assert_eq!(found.triangles, own);
    // About the circle of radius 2, where both sheets are.
    for t in found.triangles.0 {
        let corners = &loaded.triangles[3 * t as usize..][..3];
        let near = corners.iter().any(|&v| {
            let p = soup.positions[v as usize];
            (p.truncate().length() - 2.0).hypot(p.z) < 0.5
        });
        assert!(near, "triangle {t}");
    }
    session.configure(FlowOptions::default()).expect("options");
    session.run(3).expect("steps");
    let (now, info) = (
        session.self_intersections(),
        session.info().expect("a mesh"),
    );
    assert_eq!(
        now.expect("a mesh").map(|f| f.pairs.len() / 2),
        info.self_intersections
    );
    session.sample("icosphere", &[]).expect("a sample");
    let info = session.info().expect("a mesh");
    assert_eq!(
        (info.self_intersections, info.warnings),
        (Some(0), Vec::new())
    );
}

fn soup_of_triangles() -> impl Strategy<Value = PolygonSoup> {
    let point = || [-1.0..1.0, -1.0..1.0, -1.0..1.0].prop_map(DVec3::from_array);
    let triangle = (point(), 0.1..1.0, [point(), point(), point()])
        .prop_map(|(centre, size, corners)| corners.map(|p| centre + size * p));
    prop::collection::vec(triangle, 2..40).prop_map(|triangles| {
        let faces: Vec<[u32; 3]> = (0..triangles.len() as u32)
            .map(|k| [3 * k, 3 * k + 1, 3 * k + 2])
            .collect();
        PolygonSoup::from_faces(triangles.into_iter().flatten().collect(), &faces)
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn random_triangles_as_by_brute_force(soup in soup_of_triangles()) {
        let s = surface(&soup);
        let checked = check(&s, 1e-5);
        prop_assert!(checked.is_ok(), "{checked:?}");
    }
}
