mod blocks;

use super::*;
use crate::mesh::{HalfedgeMesh, build, shape};

fn sphere(level: f64) -> PolygonSoup {
    shape::make("icosphere", &[("level".into(), level)])
        .expect("a sphere")
        .soup
}

fn built(soup: &PolygonSoup) -> HalfedgeMesh {
    build(soup).expect("a surface").mesh
}

/// Closed, in one piece, of genus 0.
fn is_sphere(soup: &PolygonSoup) -> bool {
    let mesh = built(soup);
    let closed = mesh.halfedges().all(|h| mesh.face(h).is_some());
    closed && mesh.n_vertices() + mesh.n_faces() == mesh.n_edges() + 2
}

/// Every face on vertices of its own, moved by up to `noise`.
fn torn(soup: &PolygonSoup, noise: f64) -> PolygonSoup {
    let mut out = PolygonSoup::default();
    let mut state = 1_u64;
    let mut random = || {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        (state >> 11) as f64 / (1_u64 << 53) as f64 * 2.0 - 1.0
    };
    for face in soup.faces() {
        let first = out.positions.len() as u32;
        for &v in face {
            let off = DVec3::new(random(), random(), random()) * noise;
            out.positions.push(soup.positions[v as usize] + off);
        }
        out.push_face(&[first, first + 1, first + 2]);
    }
    out
}

fn kinds(repaired: &Repaired) -> Vec<(&'static str, usize)> {
    let changes = repaired.changes.iter();
    changes.map(|change| (change.kind, change.count)).collect()
}

#[test]
fn a_heap_of_triangles_is_welded_at_any_size_and_place() {
    for (scale, shift) in [(1.0, 0.0), (1e-4, 0.0), (1e4, 0.0), (1.0, 100.0)] {
        let mut soup = torn(&sphere(3.0), 3e-7);
        for p in &mut soup.positions {
            *p = *p * scale + DVec3::splat(shift);
        }
        let repaired = repair(&soup, Weld::Auto);
        assert_eq!(kinds(&repaired), [("Welded", 3 * 1280 - 642)], "{scale}");
        assert!(is_sphere(&repaired.soup));
        assert_eq!(repair(&soup, Weld::Off).changes, []);
        // Once is enough.
        assert_eq!(repair(&repaired.soup, Weld::Auto).changes, []);
    }
}

/// As STL files have them: each corner of each face is rounded by itself, and the whole is moved near the
/// origin when it is read.
#[test]
fn corners_that_were_rounded_far_from_the_origin_are_welded() {
    for far in [10.0, 100.0, 1000.0] {
        let mut soup = torn(&sphere(2.0), 1e-8 * far);
        for p in &mut soup.positions {
            let single = (*p + DVec3::splat(far)).as_vec3().as_dvec3();
            *p = single - DVec3::splat(far);
        }
        assert!(is_sphere(&repair(&soup, Weld::Auto).soup), "{far}");
    }
    // A design may have few places along an axis, and a gap along another.
    let strips = repair(&strips(1e-4), Weld::Auto).soup;
    assert_eq!(strips.positions.len(), 2 * 18);
}

/// Two strips of squares, each on corners of its own, with a gap between them.
fn strips(gap: f64) -> PolygonSoup {
    let mut soup = PolygonSoup::default();
    for side in [-1.0, 1.0] {
        for i in 0..8_u32 {
            let first = soup.positions.len() as u32;
            for (u, v) in [(0, 0.5 * gap), (1, 0.5 * gap), (1, 1.0), (0, 1.0)] {
                soup.positions
                    .push(DVec3::new(f64::from(i + u), side * v, 0.0));
            }
            let mut square = [first, first + 1, first + 2, first + 3];
            if side < 0.0 {
                square.reverse();
            }
            soup.push_face(&square);
        }
    }
    soup
}

#[test]
fn a_slit_is_stitched_and_a_gap_is_left() {
    // The first ring of faces about a vertex, on vertices of its own.
    let slit = |gap: f64| {
        let mut soup = sphere(2.0);
        let n = soup.positions.len() as u32;
        let copies: Vec<DVec3> = soup.positions.iter().map(|p| *p * (1.0 + gap)).collect();
        soup.positions.extend(copies);
        for f in 0..soup.n_faces() / 3 {
            for corner in 3 * f..3 * f + 3 {
                soup.corners[corner] += n;
            }
        }
        soup
    };
    let repaired = repair(&slit(0.0), Weld::Auto);
    assert!(matches!(kinds(&repaired)[..], [("Welded", n)] if n > 10));
    assert!(is_sphere(&repaired.soup));
    assert_eq!(repair(&slit(1e-3), Weld::Auto).changes, []);
    assert!(is_sphere(&repair(&slit(1e-3), Weld::Within(2e-3)).soup));
}

#[test]
fn closed_bodies_that_touch_stay_two() {
    let one = sphere(1.0);
    let mut both = one.clone();
    let n = one.positions.len() as u32;
    // The lowest vertex of the one at the highest of the other.
    let by_height = |a: &&DVec3, b: &&DVec3| a.z.total_cmp(&b.z);
    let low = one.positions.iter().min_by(by_height).expect("vertices");
    let high = one.positions.iter().max_by(by_height).expect("vertices");
    let moved = one.positions.iter().map(|p| *p - *low + *high);
    both.positions.extend(moved);
    for face in one.faces() {
        both.push_face(&face.iter().map(|v| v + n).collect::<Vec<_>>());
    }
    assert_eq!(repair(&both, Weld::Auto).changes, []);
}

#[test]
fn a_triangle_without_area_goes_and_leaves_no_gap() {
    // An edge halved on one side only, and a triangle of collinear corners between.
    let mut soup = sphere(2.0);
    let [a, b, c] = [0, 1, 2].map(|i| soup.face(0)[i]);
    let middle = soup.positions.len() as u32;
    let p = soup.positions[a as usize].midpoint(soup.positions[b as usize]);
    soup.positions.push(p);
    let mut faces: Vec<Vec<u32>> = soup.faces().skip(1).map(<[u32]>::to_vec).collect();
    faces.extend([vec![a, middle, c], vec![middle, b, c], vec![a, b, middle]]);
    let soup = PolygonSoup::from_faces(soup.positions, &faces);
    assert!(is_sphere(&soup));
    let repaired = repair(&soup, Weld::Auto);
    assert_eq!(kinds(&repaired), [("FlatFaces", 1)]);
    assert!(is_sphere(&repaired.soup));
    assert_eq!(repaired.soup.n_faces(), 322);
    // Without it there is a vertex in the middle of an edge.
    faces.pop();
    let soup = PolygonSoup::from_faces(soup.positions, &faces);
    assert!(!is_sphere(&soup));
    let repaired = repair(&soup, Weld::Auto);
    assert_eq!(kinds(&repaired), [("Inserted", 1)]);
    assert!(is_sphere(&repaired.soup));
    assert_eq!(repair(&soup, Weld::Off).soup.n_faces(), 322, "to rounding");
}

#[test]
fn several_vertices_on_an_edge_are_inserted_in_their_order() {
    // A square whose one side is cut in five.
    let mut x: Vec<DVec3> = [(0., 0.), (5., 0.), (5., 5.), (0., 5.)]
        .map(|(a, b)| DVec3::new(a, b, 0.0))
        .to_vec();
    let below = DVec3::new(2.0, -3.0, 0.0);
    let mut faces = vec![vec![0, 1, 2], vec![0, 2, 3]];
    x.push(below);
    let order = [3.0, 1.0, 4.0, 2.0];
    x.extend(order.map(|a| DVec3::new(a, 0.0, 0.0)));
    for pair in [[0, 6], [6, 8], [8, 5], [5, 7], [7, 1]] {
        faces.push(vec![pair[1], pair[0], 4]);
    }
    let soup = PolygonSoup::from_faces(x, &faces);
    let repaired = repair(&soup, Weld::Auto);
    assert_eq!(kinds(&repaired), [("Inserted", 4)]);
    let mesh = built(&repaired.soup);
    assert_eq!(
        (
            mesh.n_faces(),
            mesh.n_vertices() + mesh.n_faces() - mesh.n_edges()
        ),
        (11, 1)
    );
}

#[test]
fn a_fin_is_dropped_and_the_smaller_of_two_bodies_is_not() {
    let whole = sphere(2.0);
    let mut fin = whole.clone();
    let [a, b, _] = [0, 1, 2].map(|i| fin.face(0)[i]);
    let tip = fin.positions.len() as u32;
    fin.positions.push(fin.positions[a as usize] * 1.5);
    fin.push_face(&[a, b, tip]);
    assert!(build(&fin).is_err());
    let repaired = repair(&fin, Weld::Auto);
    assert_eq!(kinds(&repaired), [("Fins", 1)]);
    assert!(is_sphere(&repaired.soup) && repaired.soup.n_faces() == 320);
    // One that joins two vertices of the surface, too.
    let mut fin = whole.clone();
    let far = fin.face(200)[0];
    fin.push_face(&[a, b, far]);
    assert!(is_sphere(&repair(&fin, Weld::Auto).soup));

    // Two spheres on one edge, one turned inside out for good measure.
    let mut two = whole.clone();
    let n = two.positions.len() as u32;
    let move_by = whole.positions[a as usize] + whole.positions[b as usize];
    two.positions
        .extend(whole.positions.iter().map(|p| move_by - *p));
    let name = |v: u32| match v {
        v if v == a => b,
        v if v == b => a,
        v => v + n,
    };
    for face in whole.faces() {
        two.push_face(&face.iter().map(|&v| name(v)).collect::<Vec<_>>());
    }
    assert!(build(&two).is_err());
    let repaired = repair(&two, Weld::Auto);
    assert_eq!(kinds(&repaired), [("CutEdges", 1)]);
    let mesh = built(&repaired.soup);
    assert!(mesh.halfedges().all(|h| mesh.face(h).is_some()));
    assert_eq!(
        mesh.n_vertices() + mesh.n_faces() - mesh.n_edges(),
        4,
        "two spheres"
    );
}

#[test]
fn a_surface_that_was_exported_twice_is_one() {
    let soups = ["disk", "octahedron"].map(|name| shape::make(name, &[]).expect("a shape").soup);
    let each = soups.iter().flat_map(|one| [(one, false), (one, true)]);
    for (one, turned) in each {
        let n = one.positions.len() as u32;
        let mut both = one.clone();
        both.positions.extend(&one.positions);
        for face in one.faces() {
            let mut face: Vec<u32> = face.iter().map(|v| v + n).collect();
            if turned {
                face.reverse();
            }
            both.push_face(&face);
        }
        let repaired = repair(&both, Weld::Auto);
        assert_eq!(kinds(&repaired), [("DoubledFaces", one.n_faces())]);
        assert_eq!(repaired.soup, *one);
        let is_suspect = |soup: &PolygonSoup| {
            let built = build(soup).expect("a surface");
            is_suspect(&built.mesh, &built.positions, Weld::Auto)
        };
        assert!(is_suspect(&both) && !is_suspect(one));
        // Beside it, it is another.
        for p in &mut both.positions[n as usize..] {
            p.x += 5.0;
        }
        assert_eq!(repair(&both, Weld::Auto).changes, []);
    }
}

/// Soups of few vertices in few places, some of them nearly the same.
fn random_soups() -> impl Iterator<Item = PolygonSoup> {
    let mut state = 7_u64;
    let mut random = move |n: u64| {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        (state >> 33) % n
    };
    (0..1500).map(move |k| {
        let n = 5 + random(12);
        let scale = 10f64.powi((k % 13) - 6);
        let far = [0.0, 1e3, 5e6][k as usize % 3];
        let mut c = |m: u64| (random(m) as f64 + random(2) as f64 * 1e-7) * scale + far;
        let x: Vec<DVec3> = (0..n).map(|_| DVec3::new(c(4), c(4), c(3))).collect();
        let faces: Vec<Vec<u32>> = (0..3 + random(40))
            .map(|_| (0..3 + random(2)).map(|_| random(n) as u32).collect())
            .collect();
        PolygonSoup::from_faces(x, &faces)
    })
}

#[test]
fn whatever_is_repaired_is_a_surface_and_good_ones_are_left_alone() {
    for name in [
        "icosphere",
        "torus",
        "letter-c",
        "cube",
        "four-bumps",
        "klein-bottle",
        "disk",
        "cylinder",
        "holed-sphere",
    ] {
        let Ok(sample) = shape::make(name, &[]) else {
            continue;
        };
        let repaired = repair(&sample.soup, Weld::Auto);
        assert_eq!(repaired.changes, [], "{name}");
        let bits = |soup: &PolygonSoup| -> Vec<[u64; 3]> {
            let positions = soup.positions.iter();
            positions.map(|p| p.to_array().map(f64::to_bits)).collect()
        };
        assert_eq!(bits(&repaired.soup), bits(&sample.soup), "{name}");
        assert_eq!(repaired.soup, sample.soup, "{name}");
    }
    for soup in random_soups() {
        for weld in [Weld::Off, Weld::Auto, Weld::Within(1.0)] {
            let repaired = repair(&soup, weld);
            assert_eq!(repaired.origin.len(), repaired.soup.positions.len());
            let n = soup.positions.len() as u32;
            assert!(repaired.origin.iter().all(|v| *v < n));
            let built = match build(&repaired.soup) {
                Ok(built) => built,
                Err(error) => {
                    assert_eq!(error, crate::mesh::MeshError::NoFaces);
                    continue;
                }
            };
            built.mesh.validate().expect("a surface");
            // What looks whole is.
            if !is_suspect(&built.mesh, &built.positions, weld) {
                let again = repair(&built.mesh.to_soup(&built.positions), weld);
                assert_eq!(again.changes, [], "{weld:?}");
            }
        }
    }
}

/// A length is proposed for a gap that is narrow for its edges, and closes it; none for what is
/// whole, for what a repair closes by itself, and for a hole.
#[test]
fn a_narrow_gap_is_measured_and_that_length_closes_it() {
    let apart = |gap: f64| {
        // The upper half on vertices of its own, lifted.
        let mut soup = sphere(3.0);
        let n = soup.positions.len() as u32;
        let lifted: Vec<DVec3> = soup.positions.iter().map(|p| *p + gap * DVec3::Z).collect();
        let mut faces: Vec<Vec<u32>> = soup.faces().map(<[u32]>::to_vec).collect();
        let is_high = |v: &u32| soup.positions[*v as usize].z > -1e-9;
        for face in faces.iter_mut().filter(|face| face.iter().all(is_high)) {
            face.iter_mut().for_each(|v| *v += n);
        }
        soup.positions.extend(lifted);
        PolygonSoup::from_faces(soup.positions, &faces)
    };
    let gap_of = |soup: &PolygonSoup| {
        let built = crate::mesh::build(soup).expect("a surface");
        gap(&built.mesh, &built.positions)
    };
    for width in [0.01, 0.03] {
        let soup = apart(width);
        let proposed = gap_of(&soup).expect("a gap");
        assert!((width..1.05 * width).contains(&proposed), "{proposed}");
        assert_eq!(repair(&soup, Weld::Auto).changes, []);
        let repaired = repair(&soup, Weld::Within(proposed));
        assert_eq!(kinds(&repaired).len(), 1, "{:?}", repaired.changes);
        assert!(is_sphere(&repaired.soup));
    }
    assert_eq!(gap_of(&apart(0.5)), None);
    assert_eq!(gap_of(&sphere(3.0)), None);
}
