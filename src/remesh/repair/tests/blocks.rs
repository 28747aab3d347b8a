//! What comes of solids of unit cubes, and of surfaces with others on them.

use super::*;

/// The quadrilaterals around unit cubes at these places; cubes that share an edge alone share its ends.
fn blocks(cubes: &[[i64; 3]]) -> PolygonSoup {
    let mut x: Vec<DVec3> = Vec::new();
    let mut faces = Vec::new();
    let mut vertex = |at: [i64; 3]| {
        let p = DVec3::from_array(at.map(|c| c as f64));
        let known = x.iter().position(|q| *q == p);
        known.unwrap_or_else(|| {
            x.push(p);
            x.len() - 1
        }) as u32
    };
    for cube in cubes {
        for axis in 0..3 {
            for side in [0, 1] {
                let mut beside = *cube;
                beside[axis] += 2 * side - 1;
                if cubes.contains(&beside) {
                    continue;
                }
                let corner = |u: i64, v: i64| {
                    let mut at = *cube;
                    at[axis] += side;
                    at[(axis + 1) % 3] += u;
                    at[(axis + 2) % 3] += v;
                    at
                };
                let mut face = [(0, 0), (1, 0), (1, 1), (0, 1)].map(|(u, v)| vertex(corner(u, v)));
                if side == 0 {
                    face.reverse();
                }
                faces.push(face.to_vec());
            }
        }
    }
    PolygonSoup::from_faces(x, &faces)
}

fn measures(soup: &PolygonSoup) -> (bool, f64, f64) {
    use crate::geometry::measure;
    let built = build(soup).expect("a surface");
    let (mesh, x) = (&built.mesh, &built.positions);
    let volume = measure::volume(mesh, x).unwrap_or(f64::NAN);
    (mesh.is_closed(), measure::area(mesh, x), volume)
}

#[test]
fn bodies_whose_edges_no_cut_takes_apart_stay_closed() {
    // Two cubes on one edge, joined by others around: its ends hang together.
    let ring: &[[i64; 3]] = &[
        [0, 0, 0],
        [1, 1, 0],
        [0, 0, 1],
        [0, 1, 1],
        [1, 1, 1],
        [0, 0, -1],
        [1, 0, -1],
        [1, 1, -1],
    ];
    let cubes = ring.len() as f64;
    let soup = blocks(ring);
    assert!(build(&soup).is_err());
    let repaired = repair(&soup, Weld::Auto);
    assert_eq!(kinds(&repaired), [("DoubledEdges", 1)]);
    let (is_closed, area, volume) = measures(&repaired.soup);
    let expected: f64 = soup.n_faces() as f64;
    assert!(is_closed && (area - expected).abs() < 1e-12, "{area}");
    assert!((volume - cubes).abs() < 1e-12, "{volume}");
    assert_eq!(repair(&repaired.soup, Weld::Auto).changes, []);
    // As voxels come: many, in whatever way.
    let mut state = 5_u64;
    for _ in 0..20 {
        let mut voxels = Vec::new();
        for k in 0..64 {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            if (state >> 33).is_multiple_of(2) {
                voxels.push([k % 4, k / 4 % 4, k / 16]);
            }
        }
        let soup = blocks(&voxels);
        let (is_closed, area, volume) = measures(&repair(&soup, Weld::Auto).soup);
        assert!(is_closed && (area - soup.n_faces() as f64).abs() < 1e-9);
        assert!((volume - voxels.len() as f64).abs() < 1e-9, "{volume}");
    }
}

#[test]
fn a_wall_inside_goes_and_the_body_around_stays_closed() {
    // A box of two cubes with the square between them, in two triangles, and three in a row.
    for n in [2, 3] {
        let cubes: Vec<[i64; 3]> = (0..n).map(|k| [k, 0, 0]).collect();
        let whole = blocks(&cubes);
        let mut walled = whole.clone();
        for at in 1..n {
            let corner = |y: f64, z: f64| {
                let p = DVec3::new(at as f64, y, z);
                whole
                    .positions
                    .iter()
                    .position(|q| *q == p)
                    .expect("a corner") as u32
            };
            let [a, b, c, d] = [(0., 0.), (1., 0.), (1., 1.), (0., 1.)].map(|(y, z)| corner(y, z));
            walled.push_face(&[a, b, c]);
            walled.push_face(&[a, c, d]);
        }
        assert!(build(&walled).is_err());
        let repaired = repair(&walled, Weld::Auto);
        assert_eq!(kinds(&repaired), [("Walls", 2 * (n as usize - 1))]);
        assert_eq!(repaired.soup, whole);
    }
}

#[test]
fn sides_that_are_refined_twice_close_at_once() {
    // A cube whose top is refined towards one edge, each square on corners of its own.
    let mut x = Vec::new();
    let mut faces: Vec<Vec<u32>> = Vec::new();
    let mut square = |corners: [DVec3; 4]| {
        let first = x.len() as u32;
        x.extend(corners);
        faces.push((first..first + 4).collect());
    };
    let top = |u0: f64, u1: f64, v0: f64, v1: f64| {
        [(u0, v0), (u1, v0), (u1, v1), (u0, v1)].map(|(u, v)| DVec3::new(u, v, 1.0))
    };
    square(top(0.0, 0.5, 0.5, 1.0));
    square(top(0.5, 1.0, 0.5, 1.0));
    for (u, v) in [(0.0, 0.25), (0.25, 0.25), (0.5, 0.25), (0.75, 0.25)] {
        square(top(u, u + 0.25, v, v + 0.25));
    }
    for k in 0..8 {
        let u = f64::from(k) / 8.0;
        square(top(u, u + 0.125, 0.0, 0.125));
        square(top(u, u + 0.125, 0.125, 0.25));
    }
    for face in blocks(&[[0, 0, 0]]).faces() {
        let corners = [0, 1, 2, 3].map(|k| blocks(&[[0, 0, 0]]).positions[face[k] as usize]);
        if !corners.iter().all(|p| p.z == 1.0) {
            square(corners);
        }
    }
    let soup = PolygonSoup::from_faces(x, &faces);
    let repaired = repair(&soup, Weld::Auto);
    let (is_closed, area, volume) = measures(&repaired.soup);
    assert!(is_closed, "{:?}", repaired.changes);
    assert!((area - 6.0).abs() < 1e-12 && (volume - 1.0).abs() < 1e-12);
    assert_eq!(repair(&repaired.soup, Weld::Auto).changes, []);
}

#[test]
fn a_patch_that_lies_on_a_part_of_another_goes() {
    let whole = sphere(2.0);
    for (count, turned) in [(1, false), (28, false), (28, true)] {
        let n = whole.positions.len() as u32;
        let mut soup = whole.clone();
        soup.positions.extend(&whole.positions);
        for face in whole.faces().take(count) {
            let mut face: Vec<u32> = face.iter().map(|v| v + n).collect();
            if turned {
                face.reverse();
            }
            soup.push_face(&face);
        }
        let looked_at = build(&soup).expect("a surface");
        assert!(is_suspect(
            &looked_at.mesh,
            &looked_at.positions,
            Weld::Auto
        ));
        let repaired = repair(&soup, Weld::Auto);
        assert_eq!(kinds(&repaired), [("DoubledFaces", count)]);
        assert!(is_sphere(&repaired.soup));
    }
    // Bodies that touch share faces, and are two.
    let mut two = blocks(&[[0, 0, 0]]);
    let other = blocks(&[[1, 0, 0]]);
    two.positions.extend(&other.positions);
    for face in other.faces() {
        two.push_face(&face.iter().map(|v| v + 8).collect::<Vec<_>>());
    }
    assert_eq!(repair(&two, Weld::Auto).changes, []);
}

#[test]
fn corners_that_each_face_rounds_to_single_precision_are_welded() {
    let round = sphere(3.0);
    for far in [0.0, 1e3, 3e3, 1e4] {
        // As an instance is put in place: the corners of each face by sums of their own.
        let mut soup = PolygonSoup::default();
        for (f, face) in round.faces().enumerate() {
            let first = soup.positions.len() as u32;
            let middle = face
                .iter()
                .map(|v| round.positions[*v as usize])
                .sum::<DVec3>()
                / 3.0;
            let place = |p: DVec3| {
                let single = |c: f64| f64::from(c as f32);
                let shift = |m: f64| single(50.0 * m + far);
                let m = DVec3::from_array(middle.to_array().map(shift));
                let d = 50.0 * (p - middle);
                let sum = (m + d).to_array().map(single);
                DVec3::from_array(sum)
            };
            assert!(f < 1280);
            soup.positions
                .extend(face.iter().map(|v| place(round.positions[*v as usize])));
            soup.push_face(&[first, first + 1, first + 2]);
        }
        let repaired = repair(&soup, Weld::Auto);
        assert_eq!(kinds(&repaired), [("Welded", 3 * 1280 - 642)], "{far}");
        assert!(is_sphere(&repaired.soup), "{far}");
    }
}

#[test]
fn a_vertex_beside_a_long_edge_tells_the_width_of_the_gap() {
    // A box whose top has a vertex more on two sides than the walls, all a little above them.
    let walls = blocks(&[[0, 0, 0]]);
    let is_high = |v: &u32| walls.positions[*v as usize].z > 0.5;
    let mut faces: Vec<Vec<u32>> = walls.faces().map(<[u32]>::to_vec).collect();
    faces.retain(|face| !face.iter().all(is_high));
    let mut x = walls.positions.clone();
    let first = x.len() as u32;
    let rim = [
        (0.0, 0.0),
        (0.5, 0.0),
        (1.0, 0.0),
        (1.0, 1.0),
        (0.5, 1.0),
        (0.0, 1.0),
    ];
    for width in [0.02, 0.002] {
        let mut x = x.clone();
        x.extend(rim.map(|(u, v)| DVec3::new(u, v, 1.0 + width)));
        let mut faces = faces.clone();
        faces.push(
            (first..first + 3)
                .chain([first + 3, first + 4, first + 5])
                .collect(),
        );
        let soup = PolygonSoup::from_faces(x, &faces);
        let open = build(&soup).expect("a surface");
        let proposed = gap(&open.mesh, &open.positions).expect("a gap");
        assert!((width..1.05 * width).contains(&proposed), "{proposed}");
        assert_eq!(repair(&soup, Weld::Auto).changes, []);
        let repaired = repair(&soup, Weld::Within(proposed));
        assert!(is_sphere(&repaired.soup), "{:?}", repaired.changes);
    }
    // A hole as wide as an edge is none.
    x.truncate(8);
    let open = build(&PolygonSoup::from_faces(x, &faces)).expect("a surface");
    assert_eq!(gap(&open.mesh, &open.positions), None);
}

#[test]
fn quadrilaterals_in_the_order_of_rows_are_put_right() {
    let whole = blocks(&[[0, 0, 0], [1, 0, 0]]);
    let crossed = |which: &dyn Fn(usize) -> bool| {
        let mut faces: Vec<Vec<u32>> = whole.faces().map(<[u32]>::to_vec).collect();
        for (f, face) in faces.iter_mut().enumerate().filter(|(f, _)| which(*f)) {
            // Either pair of sides.
            if f % 4 == 0 {
                face.swap(1, 2)
            } else {
                face.swap(2, 3)
            }
        }
        PolygonSoup::from_faces(whole.positions.clone(), &faces)
    };
    for (which, count) in [
        (&(|f: usize| f == 4) as &dyn Fn(usize) -> bool, 1),
        (&|f| f > 5, 4),
        (&|_| true, 10),
    ] {
        let repaired = repair(&crossed(which), Weld::Auto);
        assert_eq!(kinds(&repaired)[0], ("Uncrossed", count));
        let (is_closed, area, volume) = measures(&repaired.soup);
        assert!(is_closed && (area - 10.0).abs() < 1e-12, "{area}");
        assert!((volume - 2.0).abs() < 1e-12, "{volume}");
        if let Ok(built) = build(&crossed(which)) {
            assert!(is_suspect(&built.mesh, &built.positions, Weld::Auto));
        }
    }
    // A quadrilateral that is bent or not convex is none of these.
    let x = [(0., 0., 0.), (2., 0., 1.), (0.3, 0.3, 0.), (0., 2., 1.)]
        .map(|(a, b, c)| DVec3::new(a, b, c));
    let bent = PolygonSoup::from_faces(x.to_vec(), &[[0, 1, 2, 3]]);
    assert_eq!(repair(&bent, Weld::Auto).changes, []);
}
