//! Hole filling and blending: topology to the letter, geometry against closed forms.

use crate::support::parts::{Ends, chamfered, circle, gear, prism, refined};
use crate::support::*;
use glam::DVec3;
use std::collections::BTreeSet;
use std::ops::ControlFlow;
use umbilic::geometry::measure;
use umbilic::geometry::quality::{is_folded, triangle_quality};
use umbilic::mesh::{Face, HalfedgeMesh, Repair};
use umbilic::remesh::fill::{FillError, FillNotice, FillOptions, Filled, boundary_loops, fill};
use umbilic::soup::PolygonSoup;

fn try_fill(mesh: &HalfedgeMesh, x: &[DVec3], options: &FillOptions) -> Result<Filled, FillError> {
    fill(mesh, x, options, &mut |_, _| ControlFlow::Continue(()))
}

fn fill_all(s: &Surface) -> Filled {
    let filled = try_fill(&s.mesh, &s.x, &FillOptions::default()).expect("filled");
    assert_sound(s, &filled);
    filled
}

fn faces_of(mesh: &HalfedgeMesh) -> impl Iterator<Item = Vec<u32>> + '_ {
    mesh.faces()
        .map(|f| mesh.face_vertices(f).map(|v| v.0).collect())
}

/// Whether there is nothing to be said of a fill.
fn is_plain(filled: &Filled) -> bool {
    filled.notices.is_empty() && filled.repairs.is_empty()
}

/// Everything that must hold of any fill: a valid mesh, old elements untouched, patches that
/// list the new ones, one Euler characteristic more a loop that was closed by a patch of its
/// own, no edge twice, no face without area, none folded over.
fn assert_sound(before: &Surface, filled: &Filled) {
    let (mesh, x) = (&filled.mesh, &filled.positions);
    mesh.validate().expect("valid connectivity");
    assert!(x.iter().all(|p| p.is_finite()));
    let n_old = filled.patches[0].vertices.start as usize;
    // Copies of a corner that holes share have become one: there faces are told by their places.
    let merged = before.x.len() - n_old;
    if merged == 0 {
        assert_eq!(x[..n_old], before.x[..], "old vertices moved");
    }
    let first_at = |v: u32| {
        let p = before.x[v as usize];
        before.x.iter().position(|q| *q == p).expect("itself") as u32
    };
    let old: Vec<Vec<u32>> = faces_of(&before.mesh).collect();
    let new = faces_of(mesh).take(old.len());
    let (old, new): (Vec<Vec<u32>>, Vec<Vec<u32>>) = if merged == 0 {
        (old, new.collect())
    } else {
        let place = |v: &u32| {
            let p = x[*v as usize];
            before.x.iter().position(|q| *q == p).expect("an old place") as u32
        };
        let at_first = |f: Vec<u32>| f.into_iter().map(first_at).collect();
        let new = new.map(|f| f.iter().map(place).collect());
        (old.into_iter().map(at_first).collect(), new.collect())
    };
    // The documented exception.
    let turns = |r: &Repair| matches!(r, Repair::InsideOut | Repair::TurnedParts { .. });
    let may_turn = filled.repairs.iter().any(turns);
    for (old, new) in old.iter().zip(&new) {
        let is_turned = may_turn && old.iter().rev().eq(new);
        assert!(
            old == new || is_turned,
            "old faces changed: {old:?}, {new:?}"
        );
    }

    let (mut vertex, mut face) = (n_old as u32, old.len() as u32);
    let (mut closed, mut euler) = (0, before.mesh.euler_characteristic() - merged as i64);
    for patch in &filled.patches {
        assert_eq!((patch.vertices.start, patch.faces.start), (vertex, face));
        (vertex, face) = (patch.vertices.end, patch.faces.end);
        closed += patch.loops.len();
        // A disc closes one loop; a sphere with n holes connects n.
        euler += 2 - patch.loops.len() as i64;
    }
    assert_eq!((x.len(), mesh.n_faces()), (vertex as usize, face as usize));
    assert_eq!(mesh.euler_characteristic(), euler);
    assert_eq!(
        boundary_loops(mesh, x).len() + closed,
        boundary_loops(&before.mesh, &before.x).len()
    );
    assert!(mesh.is_oriented());

    let mut edges = BTreeSet::new();
    for e in mesh.edges() {
        let [a, b] = mesh.ends(e).map(|v| v.0);
        assert!(edges.insert((a.min(b), a.max(b))), "edge {a} {b} twice");
    }
}

/// The worst triangle of the patches, how many of their faces fold over, and their largest
/// edge over the mean of the loops.
fn quality(filled: &Filled) -> (f64, usize) {
    let (mesh, x) = (&filled.mesh, &filled.positions);
    let (mut worst, mut folded) = (1.0f64, 0);
    for f in filled
        .patches
        .iter()
        .flat_map(|p| p.faces.clone())
        .map(Face)
    {
        worst = worst.min(triangle_quality(measure::triangle_points(mesh, x, f)));
        folded += usize::from(is_folded(mesh, x, f));
    }
    (worst, folded)
}

fn new_points(filled: &Filled) -> &[DVec3] {
    let (first, last) = (
        &filled.patches[0],
        &filled.patches[filled.patches.len() - 1],
    );
    &filled.positions[first.vertices.start as usize..last.vertices.end as usize]
}

fn off_the_sphere(filled: &Filled) -> f64 {
    new_points(filled)
        .iter()
        .map(|p| (p.length() - 1.0).abs())
        .fold(0.0, f64::max)
}

#[test]
fn the_first_fill_of_a_sphere_is_nearly_that_sphere() {
    // Largest distance from the unit sphere by half-angle of the hole: on the icosphere, on
    // a jittered one.
    for (degrees, regular, rough) in [
        (20.0, 1.5e-3, 1.5e-3),
        (35.0, 1.5e-3, 2.2e-3),
        (50.0, 2.8e-3, 2.8e-3),
        (60.0, 7.5e-3, 7.5e-3),
        (70.0, 2e-2, 2e-2),
    ] {
        for (jitter, bound) in [(0.0, regular), (0.25, rough)] {
            let s = open_sphere(4.0, jitter, degrees);
            let filled = fill_all(&s);
            assert!(is_plain(&filled), "{:?}", filled.notices);
            let error = off_the_sphere(&filled);
            assert!(error < bound, "{degrees}°, jitter {jitter}: {error}");
            let (worst, folded) = quality(&filled);
            assert!(
                folded == 0 && worst > 0.5,
                "{degrees}°: {folded} folded, {worst}"
            );
            let all = boundary_loops(&s.mesh, &s.x);
            let wanted = all[0].length / all[0].vertices.len() as f64;
            let ratio = new_edge_length(&filled) / wanted;
            assert!(
                (0.85..1.15).contains(&ratio),
                "{degrees}°: edges of {ratio}"
            );
        }
    }
}

/// Mean length of the edges at new vertices.
fn new_edge_length(filled: &Filled) -> f64 {
    let mesh = &filled.mesh;
    let first = filled.patches[0].vertices.start;
    let is_new = |e: &umbilic::mesh::Edge| mesh.ends(*e).iter().any(|v| v.0 >= first);
    let new: Vec<_> = mesh.edges().filter(is_new).collect();
    let length = |e: &umbilic::mesh::Edge| measure::edge_length(mesh, &filled.positions, *e);
    new.iter().map(length).sum::<f64>() / new.len() as f64
}

#[test]
fn tubes_are_blended_into_one_surface() {
    for count in 2..=6 {
        let s = surface(&sample("tubes", &[("count", count as f64)]));
        let options = FillOptions {
            loops: Some(inner_loops(&s)),
            connect: true,
            ..FillOptions::default()
        };
        let filled = try_fill(&s.mesh, &s.x, &options).expect("blended");
        assert_sound(&s, &filled);
        let mesh = &filled.mesh;
        assert_eq!(
            (mesh.components().1, mesh.genus()),
            (1, Some(0)),
            "{count} tubes"
        );
        assert_eq!(mesh.n_boundary_loops(), count);
        let (worst, folded) = quality(&filled);
        assert!(
            folded == 0 && worst > 0.4,
            "{count} tubes: {folded} folded, {worst}"
        );
        assert_eq!((filled.patches[0].order, is_plain(&filled)), (3, true));
        // Between the tubes, whose rims are at 1.118 from the origin.
        let farthest =
            |of: &dyn Fn(&DVec3) -> f64| new_points(&filled).iter().map(of).fold(0.0, f64::max);
        let reach = farthest(&|p| p.length());
        assert!(reach < 1.118, "{count} tubes: {reach}");
        if count == 2 {
            let error = farthest(&|p| (p.truncate().length() - 0.5).abs());
            // Order 3 reproduces no cylinder: this is where a flow begins.
            assert!(error < 0.05, "off the cylinder by {error}");
        }
    }
}

/// A collar of `rings` strips of quads, cut in two, around an inner loop; ring r lies at
/// `place(i, r)`.
fn collar(m: usize, rings: usize, place: impl Fn(usize, usize) -> DVec3) -> Surface {
    let positions = (0..m * (rings + 1)).map(|k| place(k % m, k / m)).collect();
    let mut soup = PolygonSoup {
        positions,
        ..PolygonSoup::default()
    };
    for r in 0..rings {
        for i in 0..m {
            let vertex = |i: usize, r: usize| (r * m + i % m) as u32;
            soup.push_face(&[vertex(i, r), vertex(i + 1, r + 1), vertex(i + 1, r)]);
            soup.push_face(&[vertex(i, r), vertex(i, r + 1), vertex(i + 1, r + 1)]);
        }
    }
    surface(&soup)
}

/// Fills the loop that vertex 0 lies on.
fn fill_inner(s: &Surface) -> Filled {
    let all = boundary_loops(&s.mesh, &s.x);
    let inner = all.iter().position(|l| l.vertices.contains(&0));
    let options = FillOptions {
        loops: Some(vec![inner.expect("a loop")]),
        ..FillOptions::default()
    };
    let filled = try_fill(&s.mesh, &s.x, &options).expect("filled");
    assert_sound(s, &filled);
    filled
}

fn turn(i: usize, m: usize) -> (f64, f64) {
    let angle = std::f64::consts::TAU * i as f64 / m as f64;
    (angle.cos(), angle.sin())
}

#[test]
fn small_holes_of_a_sphere_are_closed_with_few_triangles() {
    let sphere = sample("icosphere", &[("level", 3.0)]);
    let full = surface(&sphere);
    let first = full.mesh.triangle(Face(0)).map(|v| v.0);
    // One face, two faces, and all around a vertex.
    let two = |f: &[u32]| f.contains(&first[0]) && f.contains(&first[1]);
    for (removed, edges) in [
        (cut(&sphere, |_, f| f != first), 3),
        (cut(&sphere, |_, f| !two(f)), 4),
        (
            cut(&sphere, |_, f| !f.contains(&first[0])),
            full.mesh.valence(umbilic::mesh::Vertex(first[0])),
        ),
    ] {
        assert_eq!(
            boundary_loops(&removed.mesh, &removed.x)[0].vertices.len(),
            edges
        );
        let filled = fill_all(&removed);
        assert!(filled.mesh.is_closed());
        let (worst, folded) = quality(&filled);
        assert!(
            worst > 0.5 && folded == 0,
            "{edges} edges: {worst}, {folded}"
        );
        assert!(new_points(&filled).len() <= 2, "{edges} edges");
        assert!(off_the_sphere(&filled) < 2e-3);
    }
}

/// Two equilateral triangles, each refined towards the corner that the other has not.
fn rhombus() -> Surface {
    const SPOKES: u32 = 8;
    let height = 0.75f64.sqrt();
    let corners = [(0.5, 0.0), (0.0, height), (-0.5, 0.0), (0.0, -height)];
    let mut x = corners.map(|(x, y)| DVec3::new(x, y, 0.0)).to_vec();
    let mut faces = Vec::new();
    for [from, tip, to] in [[0, 1, 2], [2, 3, 0]] {
        let [a, apex, b] = [from, tip, to].map(|v: u32| x[v as usize]);
        let first = x.len() as u32;
        let at = |k: u32| a.lerp(b, f64::from(k) / f64::from(SPOKES + 1));
        x.extend((1..=SPOKES).map(|k| apex.lerp(at(k), 0.8)));
        let middle = x.len() as u32;
        x.push(apex.lerp(0.5 * (a + b), 0.9));
        let chain: Vec<u32> = [from]
            .into_iter()
            .chain(first..middle)
            .chain([to])
            .collect();
        for pair in chain.windows(2) {
            faces.push([pair[0], tip, pair[1]]);
            faces.push([pair[0], pair[1], middle]);
        }
        faces.push([from, middle, to]);
    }
    surface(&PolygonSoup::from_faces(x, &faces))
}

#[test]
fn chords_that_are_edges_already_are_not_used_again() {
    let triangle = surface(&PolygonSoup::from_faces(
        vec![DVec3::ZERO, DVec3::X, DVec3::Y],
        &[[0, 1, 2]],
    ));
    assert!(fill_all(&triangle).mesh.is_closed());
    // The short diagonal of a rhombus is an edge, and its other corners have so many that
    // no flip would take that diagonal out of the patch again.
    assert!(fill_all(&rhombus()).mesh.is_closed());
    // Fans: all their inner edges are chords of the loop.
    for m in 4..14 {
        let rim = (0..m).map(|i| {
            let (cos, sin) = turn(i, m);
            DVec3::new(cos, sin, 0.3 * cos * sin)
        });
        let faces: Vec<[u32; 3]> = (1..m as u32 - 1).map(|i| [0, i, i + 1]).collect();
        let fan = surface(&PolygonSoup::from_faces(rim.clone().collect(), &faces));
        let filled = fill_all(&fan);
        assert!(
            filled.mesh.is_closed() && filled.mesh.genus() == Some(0),
            "{m}"
        );
        // The diagonals of a polygon are edges as soon as it is cut into triangles.
        let corners: Vec<u32> = (0..m as u32).collect();
        let polygon = surface(&PolygonSoup::from_faces(rim.collect(), &[corners]));
        let filled = fill_all(&polygon);
        let cut = filled.mesh.to_soup(&filled.positions).triangulated();
        assert!(surface(&cut).mesh.is_closed(), "{m}");
    }
}

#[test]
fn thin_curled_and_noisy_loops() {
    // A slit fifty times as long as wide.
    let slit = collar(80, 4, |i, r| {
        let ((cos, sin), out) = (turn(i, 80), 0.04 * r as f64);
        DVec3::new((1.0 + out) * cos, (0.02 + out) * sin, 0.0)
    });
    let filled = fill_inner(&slit);
    assert_fair(&filled, 0.3);
    assert!(
        filled.positions.iter().all(|p| p.z == 0.0),
        "flat stays flat"
    );

    // A ribbon wound once and a half.
    let spiral = |i: usize| {
        let (at, side) = if i < 60 { (i, 1.0) } else { (119 - i, 0.8) };
        let angle = 9.4 * at as f64 / 59.0;
        let radius = side * (1.0 + 0.25 * angle);
        DVec3::new(radius * angle.cos(), radius * angle.sin(), 0.02 * angle)
    };
    let wound = collar(120, 4, |i, r| {
        let along = spiral((i + 1) % 120) - spiral((i + 119) % 120);
        spiral(i) + 0.02 * r as f64 * along.cross(DVec3::Z).normalize()
    });
    let filled = fill_inner(&wound);
    assert_fair(&filled, 0.3);

    // A crown.
    let crown = collar(90, 5, |i, r| {
        let ((cos, sin), out) = (turn(i, 90), 1.0 + 0.07 * r as f64);
        DVec3::new(out * cos, out * sin, 0.5 * turn(3 * i, 90).1)
    });
    let filled = fill_inner(&crown);
    assert_fair(&filled, 0.5);
    assert_eq!(filled.patches[0].order, 3);

    // Noise of two fifths of an edge.
    for seed in 0..10 {
        let mut random = Random(seed);
        let noise: Vec<DVec3> = (0..60 * 6).map(|_| 0.04 * random.vector()).collect();
        let rough = collar(60, 5, |i, r| {
            let ((cos, sin), out) = (turn(i, 60), 1.0 + 0.1 * r as f64);
            DVec3::new(out * cos, out * sin, 0.0) + noise[r * 60 + i]
        });
        let filled = fill_inner(&rough);
        assert_fair(&filled, 0.3);
        let height = new_points(&filled)
            .iter()
            .map(|p| p.z.abs())
            .fold(0.0, f64::max);
        assert!(height < 0.1, "seed {seed}: height {height}");
    }
}

#[test]
fn a_flat_hole_with_deep_bays_is_covered_once() {
    let place = |i: usize, out: f64| {
        let (cos, sin) = turn(i, 120);
        let radius = 1.0 + 0.7 * turn(5 * i, 120).0 + out;
        DVec3::new(radius * cos, radius * sin, 0.0)
    };
    let bays = collar(120, 4, |i, r| place(i, 0.05 * r as f64));
    let filled = fill_inner(&bays);
    assert_fair(&filled, 0.2);
    let corner = |i: usize| place(i % 120, 0.0);
    let polygon: f64 = (0..120)
        .map(|i| 0.5 * corner(i).cross(corner(i + 1)).z)
        .sum();
    let faces = filled.patches[0].faces.clone().map(Face);
    let area = |f| measure::face_vector_area(&filled.mesh, &filled.positions, f).length();
    let covered: f64 = faces.map(area).sum();
    assert!(
        (covered - polygon.abs()).abs() < 1e-9,
        "{covered} for {polygon}"
    );
}

/// No face folded over, none worse than that.
fn assert_fair(filled: &Filled, least: f64) {
    let (worst, folded) = quality(filled);
    assert!(folded == 0 && worst > least, "{folded} folded, {worst}");
}

#[test]
fn coinciding_neighbours_do_no_harm_and_holes_that_share_a_corner_are_two() {
    let twice = collar(40, 4, |i, r| {
        let ((cos, sin), out) = (
            turn(if i == 7 && r == 0 { 6 } else { i }, 40),
            1.0 + 0.15 * r as f64,
        );
        DVec3::new(out * cos, out * sin, 0.0)
    });
    fill_inner(&twice);
    // Two faces at a vertex that share no edge: around the vertex two fans are left, and one
    // loop of the mesh passes it twice.
    let sphere = sample("icosphere", &[("level", 2.0)]);
    let full = surface(&sphere);
    let v = umbilic::mesh::Vertex(20);
    let around: Vec<[u32; 3]> = full
        .mesh
        .star(v)
        .map(|s| full.mesh.triangle(s.face).map(|v| v.0))
        .collect();
    let bow_tie = cut(&sphere, |_, f| f != around[0] && f != around[3]);
    assert_eq!(bow_tie.mesh.n_boundary_loops(), 1);
    let loops = boundary_loops(&bow_tie.mesh, &bow_tie.x);
    let sizes: Vec<usize> = loops.iter().map(|l| l.vertices.len()).collect();
    assert_eq!(sizes, [3, 3]);
    let n = sphere.positions.len();
    let filled = fill_all(&bow_tie);
    assert_sound(&bow_tie, &filled);
    assert!(is_plain(&filled) && filled.mesh.is_closed());
    // A triangle has no room for more than its face, and so it is the sphere again.
    assert_eq!(
        (filled.positions.len(), filled.mesh.n_faces()),
        (n, sphere.n_faces())
    );
    for index in [0, 1] {
        let options = FillOptions {
            loops: Some(vec![index]),
            ..FillOptions::default()
        };
        let one = try_fill(&bow_tie.mesh, &bow_tie.x, &options).expect("filled");
        assert_sound(&bow_tie, &one);
        assert_eq!((one.mesh.n_boundary_loops(), one.positions.len()), (1, n));
    }
}

#[test]
fn a_vertex_on_an_edge_leaves_no_hole() {
    // A tetrahedron of which one face knows of a vertex on its side and the other does not; once in
    // single precision, where the vertex is not quite there.
    for offset in [0.0, 3e-7] {
        let corners = [[0.0; 3], [1.3, 0.2, 0.1], [0.3, 1.1, 0.4], [0.2, 0.5, 1.2]];
        let mut x = corners.map(DVec3::from_array).to_vec();
        x.push(x[0].lerp(x[1], 0.4) + offset * DVec3::Z);
        let faces = [[0, 2, 4], [4, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
        let s = surface(&PolygonSoup::from_faces(x, &faces));
        let reason = FillError::StraightLoop { index: 0 };
        assert_eq!(boundary_loops(&s.mesh, &s.x).len(), 1);
        let filled = try_fill(&s.mesh, &s.x, &FillOptions::default());
        assert_eq!(filled.err(), Some(reason), "{offset}");
    }
}

#[test]
fn a_slit_is_no_hole() {
    // Between two rings of a tube, two thirds of the way around, vertices are twice there.
    let (around, x): (usize, Vec<DVec3>) = (12, {
        let ring = |z: usize| {
            (0..12).map(move |i| {
                let (cos, sin) = turn(i, 12);
                DVec3::new(cos, sin, z as f64)
            })
        };
        (0..3).flat_map(ring).chain(ring(1)).collect()
    });
    let mut faces: Vec<[u32; 3]> = Vec::new();
    for z in 0..2 {
        for i in 0..around {
            let upper = |i: usize| match (z, i % around) {
                (1, i) if (1..8).contains(&i) => 3 * around + i,
                (z, i) => z * around + i,
            };
            let (a, b) = (upper(i), upper(i + 1));
            let [c, d] = [i, i + 1].map(|i| (z + 1) * around + i % around);
            faces.push([a, b, d].map(|v| v as u32));
            faces.push([a, d, c].map(|v| v as u32));
        }
    }
    let s = surface(&PolygonSoup::from_faces(x, &faces));
    let loops = boundary_loops(&s.mesh, &s.x);
    assert_eq!(loops.len(), 3);
    let slit = loops
        .iter()
        .position(|l| l.vertices.len() == 16)
        .expect("the slit");
    let options = FillOptions {
        loops: Some(vec![slit]),
        ..FillOptions::default()
    };
    match try_fill(&s.mesh, &s.x, &options) {
        Err(FillError::TouchingLoop { index, a, b }) => {
            assert_eq!((index, s.x[a as usize]), (slit, s.x[b as usize]));
        }
        other => panic!("{other:?}"),
    }
    // With the ends, these are filled and the slit is left.
    let filled = fill_all(&s);
    assert_eq!(filled.mesh.n_boundary_loops(), 1);
    let left = FillNotice::LeftOpen {
        reason: FillError::TouchingLoop {
            index: slit,
            a: 0,
            b: 0,
        },
    };
    let ids = |notice: &FillNotice| umbilic::message::Message::from(notice.clone()).id;
    assert_eq!(ids(&filled.notices[0]), ids(&left));
}

#[test]
fn requests_that_make_no_sense_are_refused() {
    let of = |name: &str, loops: Option<Vec<usize>>, connect: bool| {
        let s = surface(&sample(name, &[]));
        let options = FillOptions {
            loops,
            connect,
            ..FillOptions::default()
        };
        try_fill(&s.mesh, &s.x, &options).err()
    };
    assert_eq!(of("icosphere", None, false), Some(FillError::NoLoops));
    assert_eq!(of("moebius", None, false), Some(FillError::NotOrientable));
    let out_of_range = FillError::LoopOutOfRange { index: 2, loops: 2 };
    assert_eq!(of("cylinder", Some(vec![0, 2]), false), Some(out_of_range));
    assert_eq!(
        of("cylinder", Some(vec![]), false),
        Some(FillError::NoLoops)
    );
    assert_eq!(
        of("disk", None, true),
        Some(FillError::TooFewLoops { loops: 1 })
    );
    // A ring: its inner loop is not on the hull.
    let ring = collar(20, 4, |i, r| {
        let (cos, sin) = turn(i, 20);
        DVec3::new(cos, sin, 0.0) * (1.0 + 0.2 * r as f64)
    });
    let connect = FillOptions {
        connect: true,
        ..FillOptions::default()
    };
    let hidden = try_fill(&ring.mesh, &ring.x, &connect).err();
    assert!(
        matches!(hidden, Some(FillError::HiddenLoop { .. })),
        "{hidden:?}"
    );
    // A ring of one strip: its ends are joined by edges already.
    let short = surface(&sample("cylinder", &[("along", 1.0)]));
    let close = try_fill(&short.mesh, &short.x, &connect).err();
    assert!(
        matches!(close, Some(FillError::LoopsTooClose { .. })),
        "{close:?}"
    );
}

#[test]
fn the_order_falls_where_the_surroundings_are_narrow_and_says_so() {
    for (along, order) in [(1.0, 2), (2.0, 3)] {
        let s = surface(&sample(
            "cylinder",
            &[("along", along), ("length", 0.2 * along)],
        ));
        let options = FillOptions {
            loops: Some(vec![0]),
            ..FillOptions::default()
        };
        let filled = try_fill(&s.mesh, &s.x, &options).expect("filled");
        assert_sound(&s, &filled);
        assert_eq!(filled.patches[0].order, order);
        let near = |notice: &FillNotice| matches!(notice, FillNotice::LowOrder { cause: "near-boundary", order: o, .. } if *o == order);
        let says = filled.notices.iter().any(near);
        assert_eq!(says, order < 3, "{:?}", filled.notices);
    }
}

/// What continued the sides smoothly would bulge out of the plane of the rim.
#[test]
fn the_missing_side_of_a_part_comes_back_flat() {
    let hexagon = circle(6, 1.0);
    for (outline, level) in [
        (chamfered(2.0, 1.5, 0.0), 0),
        (chamfered(2.0, 1.5, 0.0), 3),
        (hexagon, 2),
        (gear(5, 0.7, 1.0), 2),
    ] {
        let whole = refined(&prism(&outline, &[0.0, 0.5, 1.0], Ends::Hub), level);
        let closed = surface(&whole);
        let volume = measure::volume(&closed.mesh, &closed.x).expect("closed");
        let s = cut(&whole, |c, _| c.z < 1.0 - 1e-9);
        let filled = fill_all(&s);
        let found = measure::volume(&filled.mesh, &filled.positions).expect("closed");
        assert!((found / volume - 1.0).abs() < 1e-9, "{found} for {volume}");
        let is_side = |notice: &FillNotice| {
            matches!(
                notice,
                FillNotice::LowOrder {
                    cause: "side",
                    order: 1,
                    ..
                }
            )
        };
        assert!(filled.notices.iter().all(is_side), "{:?}", filled.notices);
    }
    // The mouth of a smooth tube is none, however flat.
    let tube = refined(&prism(&circle(24, 1.0), &[0.0, 0.5, 1.0], Ends::Hub), 1);
    let filled = fill_all(&cut(&tube, |c, _| c.z < 1.0 - 1e-9));
    assert_eq!(filled.patches[0].order, 3);
}

#[test]
fn a_hole_beyond_a_hemisphere_is_called_a_guess() {
    let told = |s: &Surface| {
        let filled = try_fill(&s.mesh, &s.x, &FillOptions::default()).expect("filled");
        let large = |notice: &FillNotice| matches!(notice, FillNotice::LargeHole { .. });
        filled.notices.iter().any(large)
    };
    for (degrees, is_large) in [(80.0, false), (90.0, false), (110.0, true), (130.0, true)] {
        for jitter in [0.0, 0.25] {
            assert_eq!(
                told(&open_sphere(4.0, jitter, degrees)),
                is_large,
                "{degrees}°"
            );
        }
    }
    // Half a sphere by its own mesh, however coarse; the ends of a pipe are hemispheres.
    assert!(!told(&surface(&sample("hemisphere", &[("rings", 4.0)]))));
    assert!(!told(&surface(&sample("cylinder", &[]))));
    // The outline of a sheet, which only a sphere's worth of curvature closes.
    assert!(told(&surface(&sample("disk", &[]))));
}

#[test]
fn the_number_of_new_vertices_is_bounded() {
    let s = open_sphere(5.0, 0.0, 60.0);
    let free = new_points(&fill_all(&s)).len();
    for most in [0, 1, 40, 500] {
        let options = FillOptions {
            max_vertices: most,
            ..FillOptions::default()
        };
        let filled = try_fill(&s.mesh, &s.x, &options).expect("filled");
        assert_sound(&s, &filled);
        let new = new_points(&filled).len();
        assert!(new <= most && 500 < free, "{new} of {most}");
        assert!(
            filled
                .notices
                .iter()
                .any(|notice| matches!(notice, FillNotice::Coarser { most: m, .. } if *m == most)),
            "{:?}",
            filled.notices
        );
    }
}

#[test]
fn a_fill_can_be_stopped_at_any_moment() {
    let s = open_sphere(3.0, 0.0, 40.0);
    let mut calls = 0;
    let options = FillOptions::default();
    let count = &mut |_: &str, share: f64| {
        assert!((0.0..=1.0).contains(&share));
        calls += 1;
        ControlFlow::Continue(())
    };
    fill(&s.mesh, &s.x, &options, count).expect("filled");
    assert!(calls > 10);
    for last in 0..calls {
        let (mut left, mut is_told) = (last, false);
        let stop = &mut |_: &str, _: f64| {
            assert!(!is_told, "asked again after it was told to stop");
            if left == 0 {
                is_told = true;
                return ControlFlow::Break(());
            }
            left -= 1;
            ControlFlow::Continue(())
        };
        let stopped = fill(&s.mesh, &s.x, &options, stop);
        assert_eq!(
            stopped.err(),
            Some(FillError::Cancelled),
            "call {last} of {calls}"
        );
    }
}

#[test]
fn the_fill_does_not_depend_on_the_unit_of_length() {
    let s = open_sphere(3.0, 0.2, 50.0);
    let filled = fill_all(&s);
    for factor in [2f64.powi(-30), 2f64.powi(30)] {
        let x: Vec<DVec3> = s.x.iter().map(|&p| factor * p).collect();
        let other = try_fill(&s.mesh, &x, &FillOptions::default()).expect("filled");
        assert_eq!(filled.positions.len(), other.positions.len());
        let back: Vec<DVec3> = other.positions.iter().map(|&p| p / factor).collect();
        assert!(largest_difference(&filled.positions, &back) < 1e-9);
    }
}

#[test]
fn two_holes_of_a_sphere_become_a_handle() {
    let s = cut(&sample("icosphere", &[("level", 4.0)]), |c, _| {
        c.z.abs() < 0.8
    });
    let options = FillOptions {
        connect: true,
        ..FillOptions::default()
    };
    let filled = try_fill(&s.mesh, &s.x, &options).expect("connected");
    assert_sound(&s, &filled);
    assert_eq!(filled.mesh.genus(), Some(1));
    assert!(filled.mesh.is_closed());
    // At the rims the surface turns back on itself, so some of its faces count as folded.
    assert!(quality(&filled).0 > 0.1);
}

#[test]
fn ragged_tubes_are_blended_too() {
    for seed in 0..4 {
        let mut soup = sample("tubes", &[("count", 4.0), ("around", 24.0)]);
        let mut random = Random(seed);
        soup.positions
            .iter_mut()
            .for_each(|p| *p += 0.03 * random.vector());
        let s = surface(&soup);
        let all = boundary_loops(&s.mesh, &s.x);
        let near = |i: &usize| s.x[all[*i].vertices[0] as usize].length() < 1.4;
        let options = FillOptions {
            loops: Some((0..all.len()).filter(near).collect()),
            connect: true,
            ..FillOptions::default()
        };
        let filled = try_fill(&s.mesh, &s.x, &options).expect("blended");
        assert_sound(&s, &filled);
        assert_eq!(
            (filled.mesh.components().1, filled.mesh.genus()),
            (1, Some(0))
        );
        assert_fair(&filled, 0.4);
    }
}

#[test]
fn tubes_turned_against_each_other_are_turned_to_agree() {
    let mut soup = sample("tubes", &[("count", 3.0)]);
    // The faces of the second tube.
    for f in 960..1920 {
        soup.corners[3 * f..3 * f + 3].swap(0, 1);
    }
    let s = surface(&soup);
    let options = FillOptions {
        loops: Some(inner_loops(&s)),
        connect: true,
        ..FillOptions::default()
    };
    let filled = try_fill(&s.mesh, &s.x, &options).expect("blended");
    filled.mesh.validate().expect("valid");
    assert!(filled.mesh.is_oriented());
    assert_eq!(filled.mesh.components().1, 1);
    assert!(
        filled
            .repairs
            .iter()
            .any(|repair| matches!(repair, Repair::TurnedFaces { .. })),
        "{:?}",
        filled.repairs
    );
}

/// Star-shaped regions of a sphere, cut out: everything must hold of any of them.
#[test]
fn any_star_shaped_hole_of_a_sphere_is_filled() {
    use proptest::prelude::*;
    let sphere = sample("icosphere", &[("level", 3.0)]);
    let waves = proptest::collection::vec((-0.35..0.35, 0.0..6.3), 5);
    let config = ProptestConfig {
        cases: 48,
        failure_persistence: None,
        ..ProptestConfig::default()
    };
    let mut runner = proptest::test_runner::TestRunner::new_with_rng(
        config,
        proptest::test_runner::TestRng::deterministic_rng(
            proptest::test_runner::RngAlgorithm::ChaCha,
        ),
    );
    let case = (0.3..1.1, waves, -1.0..1.0);
    runner
        .run(&case, |(size, waves, tilt)| {
            let pole = DVec3::new(tilt, 0.4, 0.8).normalize();
            let (u, v) = pole.any_orthonormal_pair();
            let radius = |c: DVec3| {
                let angle = c.dot(u).atan2(c.dot(v));
                let wave = |(k, (a, phase)): (usize, &(f64, f64))| {
                    a * ((k + 1) as f64 * angle + phase).sin()
                };
                size * (1.0 + waves.iter().enumerate().map(wave).sum::<f64>())
            };
            let s = cut(&sphere, |c, _| c.angle_between(pole) > radius(c));
            match try_fill(&s.mesh, &s.x, &FillOptions::default()) {
                Ok(filled) => {
                    assert_sound(&s, &filled);
                    let (worst, folded) = quality(&filled);
                    prop_assert!(folded == 0 && worst > 0.02, "{folded} folded, {worst}");
                    let error = off_the_sphere(&filled);
                    prop_assert!(error < 0.5, "off by {error}");
                }
                // The cut may leave parts that hang together by a vertex.
                Err(FillError::TouchingLoop { .. } | FillError::NoLoops) => {}
                Err(other) => prop_assert!(false, "{other}"),
            }
            Ok(())
        })
        .unwrap_or_else(|error| panic!("{error}"));
}

#[test]
fn quadrilaterals_stay_quadrilaterals() {
    let Some(folder) = shared_meshes() else {
        return;
    };
    let bytes = std::fs::read(folder.join("spot_quadrangulated.obj")).expect("a file");
    let soup = umbilic::io::read(&bytes, "spot.obj")
        .expect("readable")
        .soup;
    let centre = soup.positions[100];
    let s = cut(&soup, |c, _| c.distance(centre) > 0.15);
    let filled = fill_all(&s);
    assert!(filled.mesh.is_closed());
    assert_eq!(filled.mesh.face_vertices(Face(0)).count(), 4);
}

#[test]
fn real_scans_are_closed() {
    if let Some(s) = real("plane_holes.obj") {
        let filled = fill_all(&s);
        assert!(filled.mesh.is_closed() && filled.patches.len() == 27);
        assert_fair(&filled, 0.5);
    }
    for (file, points) in [
        ("demosthenes_low_res.obj", [500, 4000, 9000]),
        ("bunny.obj", [100, 2000, 5000]),
    ] {
        let Some(whole) = real(file) else { return };
        let soup = whole.mesh.to_soup(&whole.x);
        let radius = 0.04 * measure::bounding_diagonal(&whole.x);
        let centres = points.map(|v: usize| whole.x[v % whole.x.len()]);
        let s = cut(&soup, |c, _| centres.iter().all(|p| p.distance(c) > radius));
        let filled = fill_all(&s);
        assert!(filled.mesh.is_closed());
        assert_fair(&filled, 0.3);
        // How far the patches of our own holes are from what was there.
        let all = boundary_loops(&s.mesh, &s.x);
        let ours = filled
            .patches
            .iter()
            .filter(|p| all[p.loops[0]].length < 9.0 * radius);
        let near = |p: DVec3| {
            whole
                .x
                .iter()
                .map(|q| q.distance(p))
                .fold(f64::INFINITY, f64::min)
        };
        let new = ours.flat_map(|p| p.vertices.clone());
        let off = new
            .map(|v| near(filled.positions[v as usize]))
            .fold(0.0, f64::max);
        assert!(off < 0.35 * radius, "{file}: off by {} radii", off / radius);
    }
}

#[test]
fn broken_files_are_filled_or_refused() {
    let Some(folder) = shared_meshes() else {
        return;
    };
    let mut filled_some = 0;
    for entry in std::fs::read_dir(folder.join("broken")).expect("a folder") {
        let path = entry.expect("an entry").path();
        let name = path
            .file_name()
            .expect("a name")
            .to_string_lossy()
            .into_owned();
        let bytes = std::fs::read(&path).expect("a file");
        let Ok(read) = umbilic::io::read(&bytes, &name) else {
            continue;
        };
        let Ok(built) = umbilic::mesh::build(&read.soup) else {
            continue;
        };
        let s = Surface {
            mesh: std::rc::Rc::new(built.mesh),
            x: built.positions,
            repairs: built.repairs,
        };
        match try_fill(&s.mesh, &s.x, &FillOptions::default()) {
            Ok(filled) => {
                assert_sound(&s, &filled);
                filled_some += 1;
            }
            Err(FillError::NoLoops) => assert!(s.mesh.is_closed(), "{name}"),
            Err(FillError::NotOrientable) => assert_eq!(name, "moebius.obj"),
            Err(FillError::TouchingLoop { .. }) => assert_eq!(name, "sphere_with_hole.stl"),
            Err(error) => panic!("{name}: {error}"),
        }
    }
    assert!(filled_some > 1, "{filled_some}");
}
