//! Half-edge connectivity: invariants, safe repairs, refusals.

use crate::support::*;
use glam::DVec3;
use proptest::prelude::*;
use umbilic::geometry::measure;
use umbilic::mesh::{MeshError, Repair, Vertex, build, shape};
use umbilic::soup::PolygonSoup;

fn sample(name: &str) -> PolygonSoup {
    shape::make(name, &[]).expect("a shape").soup
}

/// A cube of six quads, outward.
fn cube() -> PolygonSoup {
    let corner = |i: u32| {
        DVec3::new(
            f64::from(i & 1),
            f64::from(i >> 1 & 1),
            f64::from(i >> 2 & 1),
        )
    };
    let faces = [
        [0, 2, 3, 1],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 4, 6, 2],
        [1, 3, 7, 5],
    ];
    PolygonSoup::from_faces((0..8).map(corner).collect(), &faces)
}

#[test]
fn every_sample_shape_is_a_valid_mesh() {
    for shape in shape::all() {
        let Surface { mesh, x, repairs } = surface(&sample(shape.name));
        let one_sided = ["moebius", "klein-bottle", "boy"].contains(&shape.name);
        assert_eq!(mesh.is_oriented(), !one_sided, "{}", shape.name);
        assert_eq!(
            repairs.len(),
            usize::from(one_sided),
            "{}: {repairs:?}",
            shape.name
        );
        // Half-way between its sides a surface encloses nothing.
        if let Some(volume) = measure::volume(&mesh, &x).filter(|_| shape.name != "morin") {
            assert!(volume > 0.0, "{} is inside out", shape.name);
        }
        let boundary = mesh
            .vertices()
            .filter(|&v| mesh.is_boundary_vertex(v))
            .count();
        assert_eq!(
            boundary,
            mesh.boundary_loops().flatten().count(),
            "{}",
            shape.name
        );
    }
}

#[test]
fn faces_keep_their_degree_and_order() {
    let soup = cube();
    let Surface { mesh, x, .. } = surface(&soup);
    assert_eq!(
        (mesh.n_vertices(), mesh.n_edges(), mesh.n_faces()),
        (8, 12, 6)
    );
    assert_eq!((mesh.euler_characteristic(), mesh.genus()), (2, Some(0)));
    assert_eq!(mesh.to_soup(&x), soup);
    assert!((measure::volume(&mesh, &x).expect("closed") - 1.0).abs() < 1e-15);
    assert!((measure::area(&mesh, &x) - 6.0).abs() < 1e-15);
    let cut = surface(&soup.triangulated());
    assert_eq!((cut.mesh.n_vertices(), cut.mesh.n_faces()), (8, 12));
    assert!((measure::volume(&cut.mesh, &cut.x).expect("closed") - 1.0).abs() < 1e-15);
}

#[test]
fn boundary_loops_run_against_the_faces() {
    let Surface { mesh, .. } = surface(&sample("cylinder"));
    assert_eq!((mesh.n_boundary_loops(), mesh.genus()), (2, Some(0)));
    for h in mesh.boundary_loops().flatten() {
        assert!(mesh.is_boundary_halfedge(h) && !mesh.is_boundary_halfedge(h.twin()));
        assert_eq!(mesh.tail(h), mesh.tip(h.twin()));
    }
}

#[test]
fn a_moebius_strip_has_one_loop_and_no_orientation() {
    let Surface { mesh, .. } = surface(&sample("moebius"));
    assert_eq!(
        (mesh.n_boundary_loops(), mesh.euler_characteristic()),
        (1, 0)
    );
    assert_eq!(mesh.genus(), None);
    assert!(mesh.edges().any(|e| mesh.is_twisted(e)));
}

#[test]
fn a_reversed_patch_is_turned_back() {
    let clean = sample("icosphere");
    let mut soup = PolygonSoup {
        positions: clean.positions.clone(),
        ..PolygonSoup::default()
    };
    for (f, face) in clean.faces().enumerate() {
        let mut face = face.to_vec();
        if f % 7 == 3 {
            face.reverse();
        }
        soup.push_face(&face);
    }
    let Surface { mesh, x, repairs } = surface(&soup);
    assert!(mesh.is_oriented() && measure::volume(&mesh, &x).expect("closed") > 0.0);
    assert_eq!(repairs.len(), 1, "{repairs:?}");
}

#[test]
fn an_inside_out_surface_is_turned() {
    let mut soup = sample("torus");
    soup.corners.chunks_exact_mut(3).for_each(<[u32]>::reverse);
    let Surface { mesh, x, repairs } = surface(&soup);
    assert!(measure::volume(&mesh, &x).expect("closed") > 0.0);
    assert_eq!(repairs, [Repair::InsideOut]);
}

/// A thin plate, whose volume is small, is turned; a surface half-way through an eversion is not.
#[test]
fn what_shows_both_sides_is_not_turned() {
    let mut plate = cube();
    plate.positions.iter_mut().for_each(|p| p.z *= 0.01);
    plate.corners.chunks_exact_mut(4).for_each(<[u32]>::reverse);
    assert_eq!(surface(&plate).repairs, [Repair::InsideOut]);
    for push in [-0.1, -0.02, 0.02, 0.1] {
        let values = [("vertices", 1200.0), ("push", push)];
        let Surface { mesh, x, repairs } = surface(&crate::support::sample("morin", &values));
        assert_eq!(repairs, [], "{push}");
        let volume = measure::volume(&mesh, &x).expect("closed");
        assert!(volume * push > 0.0, "{push}: {volume}");
    }
}

/// Balls of these radii about these places, those of negative radius inside out.
fn balls(of: &[(f64, f64)]) -> PolygonSoup {
    let ball = sample("icosphere");
    let mut soup = PolygonSoup::default();
    for &(radius, at) in of {
        let first = soup.positions.len() as u32;
        let place = |p: &DVec3| radius.abs() * *p + at * DVec3::X;
        soup.positions.extend(ball.positions.iter().map(place));
        for face in ball.faces() {
            let mut face: Vec<u32> = face.iter().map(|v| v + first).collect();
            if radius < 0.0 {
                face.reverse();
            }
            soup.push_face(&face);
        }
    }
    soup
}

#[test]
fn parts_that_are_inside_out_are_turned_and_walls_of_cavities_are_not() {
    type Case = (&'static [(f64, f64)], f64, Option<Repair>);
    let turned = |count| Some(Repair::TurnedParts { count });
    let cases: [Case; 8] = [
        (&[(1.0, 0.0), (-0.5, 3.0)], 1.125, turned(1)),
        (&[(-0.5, 3.0), (-0.2, 6.0), (1.0, 0.0)], 1.133, turned(2)),
        // A hollow ball, as it should be; all of it inside out; beside another; and alone within.
        (&[(1.0, 0.0), (-0.5, 0.1)], 0.875, None),
        (&[(-1.0, 0.0), (0.5, 0.1)], 0.875, Some(Repair::InsideOut)),
        (&[(-1.0, 0.0), (0.5, 0.1), (1.0, 4.0)], 1.875, turned(2)),
        (&[(1.0, 0.0), (0.5, 0.1)], 1.125, None),
        (&[(1.0, 0.0), (-0.05, 0.0)], 0.999_875, None),
        (&[(-1.0, 0.0), (-0.5, 3.0)], 1.125, Some(Repair::InsideOut)),
    ];
    let unit = {
        let Surface { mesh, x, .. } = surface(&sample("icosphere"));
        measure::volume(&mesh, &x).expect("closed")
    };
    for (n, (of, volume, repair)) in cases.into_iter().enumerate() {
        let Surface { mesh, x, repairs } = surface(&balls(of));
        let found = measure::volume(&mesh, &x).expect("closed") / unit;
        assert!((found - volume).abs() < 1e-12, "{n}: {found}");
        assert_eq!(repairs, repair.into_iter().collect::<Vec<_>>(), "{n}");
    }
    // In the box of a ball, but in its corner.
    let mut soup = balls(&[(1.0, 0.0), (-0.1, 0.0)]);
    let half = soup.positions.len() / 2;
    for p in &mut soup.positions[half..] {
        *p += DVec3::splat(0.8);
    }
    let repairs = surface(&soup).repairs;
    assert_eq!(repairs, [Repair::TurnedParts { count: 1 }]);
}

#[test]
fn harmless_debris_is_dropped_with_a_word() {
    let clean = sample("icosahedron");
    let mut soup = clean.clone();
    let n = soup.positions.len() as u32;
    let first: Vec<u32> = soup.face(0).to_vec();
    soup.push_face(&[first[1], first[2], first[0]]);
    soup.push_face(&[0, 0, 1]);
    soup.positions
        .extend((0..4).map(|i| DVec3::splat(f64::from(i))));
    soup.push_face(&[n, n + 1, n + 2]);
    let Surface { mesh, x, repairs } = surface(&soup);
    assert_eq!(mesh.to_soup(&x), clean);
    assert_eq!(repairs.len(), 4, "{repairs:?}");
}

#[test]
fn a_quad_with_a_repeated_corner_is_a_triangle() {
    let positions = vec![DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::ONE];
    let soup = PolygonSoup::from_faces(positions, &[&[0, 1, 1, 2][..], &[1, 3, 2][..]]);
    let Surface { mesh, .. } = surface(&soup);
    assert_eq!((mesh.n_faces(), mesh.n_edges()), (2, 5));
}

#[test]
fn sheets_that_touch_in_a_vertex_are_parted() {
    let mut soup = sample("icosahedron");
    let n = soup.positions.len() as u32;
    let other = sample("icosahedron");
    soup.positions
        .extend(other.positions.iter().map(|p| *p + DVec3::X * 5.0));
    for face in other.faces() {
        // Vertex 0 of both.
        let face: Vec<u32> = face
            .iter()
            .map(|&v| if v == 0 { 0 } else { v + n })
            .collect();
        soup.push_face(&face);
    }
    let built = build(&soup).expect("a surface");
    built.mesh.validate().expect("valid");
    assert_eq!(built.mesh.n_vertices(), 2 * n as usize);
    assert_eq!(built.mesh.components().1, 2);
    assert_eq!(
        built.soup_vertex.last(),
        Some(&0),
        "the copy knows where it comes from"
    );
    let (count, vertices) = (1, vec![0]);
    assert_eq!(
        built.repairs[0],
        Repair::SplitVertices {
            count,
            vertices,
            first: 0
        }
    );
}

#[test]
fn what_cannot_be_repaired_is_named() {
    let points = |n: u32| {
        (0..n)
            .map(|i| DVec3::new(f64::from(i), f64::from(i * i), 1.0))
            .collect()
    };
    let fan = PolygonSoup::from_faces(points(5), &[[0, 1, 2], [1, 0, 3], [0, 1, 4]]);
    let error = build(&fan).expect_err("three faces at an edge");
    assert_eq!(
        error,
        MeshError::NonManifoldEdge {
            a: 0,
            b: 1,
            faces: vec![0, 1, 2],
            others: 0,
            first: 0
        }
    );

    let range = PolygonSoup::from_faces(points(3), &[[0, 1, 3]]);
    let expected = MeshError::VertexOutOfRange {
        face: 0,
        vertex: 3,
        vertices: 3,
    };
    assert_eq!(build(&range).expect_err("out of range"), expected);

    let mut nan = PolygonSoup::from_faces(points(3), &[[0, 1, 2]]);
    nan.positions[1].y = f64::NAN;
    assert_eq!(
        build(&nan).expect_err("NaN"),
        MeshError::NonFiniteVertex { vertex: 1 }
    );

    let nothing = PolygonSoup::from_faces(points(3), &[[0, 0, 1]]);
    assert_eq!(build(&nothing).expect_err("no face"), MeshError::NoFaces);
}

#[test]
fn stars_are_cyclic_and_cross_twisted_edges() {
    for name in ["icosphere", "klein-bottle", "moebius", "pipe"] {
        let Surface { mesh, .. } = surface(&sample(name));
        for v in mesh.vertices() {
            let star: Vec<_> = mesh.star(v).collect();
            for (i, spoke) in star.iter().enumerate().filter(|(_, s)| s.face.is_some()) {
                let next: Vertex = star[(i + 1) % star.len()].neighbour;
                let corners: Vec<Vertex> = mesh.face_vertices(spoke.face).collect();
                assert!(
                    corners.contains(&v) && corners.contains(&spoke.neighbour),
                    "{name}"
                );
                assert!(
                    corners.contains(&next),
                    "{name}: face between neighbouring spokes"
                );
            }
        }
    }
}

#[test]
fn real_and_broken_files_get_their_verdict() {
    let Some(folder) = shared_meshes() else {
        return;
    };
    // Vertices, faces, components, loops, genus.
    let good: [(&str, [i64; 5]); 8] = [
        ("spot_quadrangulated.obj", [2930, 2928, 1, 0, 0]),
        ("bob_small.ply", [250, 500, 1, 0, 1]),
        ("borromean.obj", [5760, 11520, 3, 0, 3]),
        ("skull_low_resolution.obj", [5154, 10312, 1, 0, 2]),
        ("plane_holes.obj", [8519, 16747, 1, 27, 0]),
        ("icosahedron_binary.stl", [12, 20, 1, 0, 0]),
        ("hemisphere.off", [1861, 3600, 1, 1, 0]),
        ("koala.obj", [49_999, 99_994, 1, 0, 0]),
    ];
    let read = |name: &str| {
        let bytes = std::fs::read(folder.join(name)).expect("a file");
        umbilic::io::read(&bytes, name).expect("readable").soup
    };
    for (name, expected) in good {
        let Surface { mesh, repairs, .. } = surface(&read(name));
        let found = [
            mesh.n_vertices() as i64,
            mesh.n_faces() as i64,
            mesh.components().1 as i64,
            mesh.n_boundary_loops() as i64,
            mesh.genus().expect("oriented"),
        ];
        assert_eq!(found, expected, "{name}");
        assert!(repairs.is_empty(), "{name}: {repairs:?}");
    }
    let fan = build(&read("broken/fan3.obj")).expect_err("refused");
    assert!(matches!(fan, MeshError::NonManifoldEdge { .. }));
    for (name, vertices, faces, repairs) in [
        ("broken/hourglass_ico.obj", 24, 40, 1),
        ("broken/moebius.obj", 280, 224, 1),
        ("broken/walnut_shell_inside_out.obj", 3842, 7680, 1),
        ("broken/sphere_with_hole.stl", 148, 285, 1),
        ("broken/spot_duplicate_faces.obj", 829, 1654, 1),
        ("broken/spot_flipped_patch.obj", 829, 1654, 1),
        ("broken/spot_degenerate.obj", 829, 1654, 4),
        ("broken/two_groups.obj", 4, 2, 0),
        ("broken/two_solids.stl", 6, 2, 0),
    ] {
        let found = surface(&read(name));
        assert_eq!(
            (found.mesh.n_vertices(), found.mesh.n_faces()),
            (vertices, faces),
            "{name}"
        );
        assert_eq!(found.repairs.len(), repairs, "{name}: {:?}", found.repairs);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    /// Any soup is either refused by name or becomes a valid mesh.
    #[test]
    fn random_soups_are_refused_or_valid(
        faces in prop::collection::vec(prop::collection::vec(0u32..9, 0..6), 0..14),
        points in prop::collection::vec((-2i8..3, -2i8..3, -2i8..3), 9),
    ) {
        let point = |&(x, y, z): &(i8, i8, i8)| DVec3::new(x.into(), y.into(), z.into());
        let soup = PolygonSoup::from_faces(points.iter().map(point).collect(), &faces);
        if let Ok(built) = build(&soup) {
            prop_assert_eq!(built.mesh.validate(), Ok(()));
            prop_assert_eq!(built.positions.len(), built.mesh.n_vertices());
            let _ = build(&built.mesh.to_soup(&built.positions).triangulated());
        }
    }
}

/// A box of quadrilaterals with a roof of two that share two sides, and a pentagon beside a
/// quadrilateral that do.
#[test]
fn polygons_that_share_two_sides_are_cut_apart() {
    let at = |x: f64, y: f64, z: f64| DVec3::new(x, y, z);
    let mut points: Vec<DVec3> = (0..8)
        .map(|i| {
            at(
                f64::from(i % 4 == 1 || i % 4 == 2),
                f64::from(i % 4 > 1),
                f64::from(i > 3),
            )
        })
        .collect();
    points.push(at(0.5, 0.5, 2.3));
    let roofed = [
        vec![0, 3, 2, 1],
        vec![0, 1, 5, 4],
        vec![1, 2, 6, 5],
        vec![2, 3, 7, 6],
        vec![3, 0, 4, 7],
        vec![4, 5, 6, 8],
        vec![4, 8, 6, 7],
    ];
    let open = [vec![1, 0, 2, 3, 4], vec![0, 1, 4, 5]];
    let flat: Vec<DVec3> = [
        (0.3, 0.5),
        (0.0, 0.4),
        (0.5, 0.0),
        (1.0, 0.6),
        (0.4, 1.0),
        (0.2, 0.7),
    ]
    .map(|(x, y)| at(x, y, x * y))
    .to_vec();
    for (positions, faces) in [(points, roofed.as_slice()), (flat, open.as_slice())] {
        let soup = PolygonSoup::from_faces(positions, faces);
        build(&soup).expect("a surface of polygons");
        let cut = soup.triangulated();
        let corners: usize = faces.iter().map(|face| face.len() - 2).sum();
        assert_eq!(cut.n_faces(), corners);
        let built = build(&cut).expect("a surface of triangles");
        assert!(built.repairs.is_empty(), "{:?}", built.repairs);
    }
}

/// A part is flat by its own size: neither a vertex far away that no face uses nor a part ten million
/// times as large makes it nothing.
#[test]
fn a_small_part_is_no_flat_one() {
    let ball = sample("octahedron");
    let mut soup = ball.clone();
    soup.positions.push(DVec3::X * 1e10);
    assert_eq!(build(&soup).expect("a ball").repairs.len(), 1);
    let n = soup.positions.len() as u32;
    let small = ball.positions.iter().map(|p| DVec3::splat(3.0) + 1e-7 * *p);
    soup.positions.extend(small);
    for face in ball.faces() {
        let face: Vec<u32> = face.iter().map(|v| v + n).collect();
        soup.push_face(&face);
    }
    let built = build(&soup).expect("two balls");
    assert_eq!(built.mesh.n_faces(), 2 * ball.n_faces());
    assert_eq!(built.repairs, [Repair::UnusedVertices { count: 1 }]);
}
