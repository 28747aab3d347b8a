//! Hole filling and blending: topology to the letter, geometry against closed forms.
#![allow(missing_docs, reason = "tests")]

mod support;

use glam::DVec3;
use std::collections::BTreeSet;
use std::ops::ControlFlow;
use support::*;
use umbilic::geometry::quality::{is_folded, triangle_quality};
use umbilic::geometry::measure;
use umbilic::mesh::shape;
use umbilic::mesh::{Face, HalfedgeMesh};
use umbilic::remesh::fill::{FillError, FillOptions, Filled, boundary_loops, fill};
use umbilic::soup::PolygonSoup;

fn sample(name: &str, values: &[(&str, f64)]) -> PolygonSoup {
    let values: Vec<(String, f64)> = values.iter().map(|&(n, v)| (n.into(), v)).collect();
    shape::make(name, &values).expect("a shape").soup
}

/// The faces of a soup for which `keep` holds of their centroid and corners.
fn cut(soup: &PolygonSoup, keep: impl Fn(DVec3, &[u32]) -> bool) -> Surface {
    let mut rest = PolygonSoup {
        positions: soup.positions.clone(),
        ..PolygonSoup::default()
    };
    for face in soup.faces() {
        let sum: DVec3 = face.iter().map(|&v| soup.positions[v as usize]).sum();
        if keep(sum / face.len() as f64, face) {
            rest.push_face(face);
        }
    }
    surface(&rest)
}

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

/// Everything that must hold of any fill: a valid mesh, old elements untouched, patches that
/// list the new ones, one Euler characteristic more a loop that was closed by a patch of its
/// own, no edge twice, no face without area, none folded over.
fn assert_sound(before: &Surface, filled: &Filled) {
    let (mesh, x) = (&filled.mesh, &filled.positions);
    mesh.validate().expect("valid connectivity");
    assert!(x.iter().all(|p| p.is_finite()));
    assert_eq!(x[..before.x.len()], before.x[..], "old vertices moved");
    let old: Vec<Vec<u32>> = faces_of(&before.mesh).collect();
    let new: Vec<Vec<u32>> = faces_of(mesh).take(old.len()).collect();
    assert_eq!(old, new, "old faces changed");

    let (mut vertex, mut face) = (before.x.len() as u32, old.len() as u32);
    let (mut closed, mut euler) = (0, before.mesh.euler_characteristic());
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
        mesh.n_boundary_loops() + closed,
        before.mesh.n_boundary_loops()
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

/// The unit sphere, its vertices pushed about by `jitter` edge lengths, without the cap of
/// that half-angle.
fn open_sphere(level: f64, jitter: f64, degrees: f64) -> Surface {
    let mut random = Random(7);
    let mut soup = sample("icosphere", &[("level", level)]);
    let edge = 1.1 / 2f64.powf(level);
    // About an axis that is none of the icosahedron's.
    let pole = DVec3::new(0.3, 0.5, 0.8).normalize();
    for p in &mut soup.positions {
        *p = (*p + jitter * edge * random.vector()).normalize();
    }
    cut(&soup, |c, _| {
        c.normalize().dot(pole) < degrees.to_radians().cos()
    })
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
        (20.0, 1.0, 1.0),
        (35.0, 1.0, 1.0),
        (50.0, 1.0, 1.0),
        (60.0, 1.0, 1.0),
        (70.0, 1.0, 1.0),
    ] {
        for (jitter, bound) in [(0.0, regular), (0.25, rough)] {
            let s = open_sphere(4.0, jitter, degrees);
            let start = std::time::Instant::now();
            let filled = fill_all(&s);
            let (worst, folded) = quality(&filled);
            let error = off_the_sphere(&filled);
            println!(
                "{degrees} {jitter}: {error:.2e}, {} new, worst {worst:.3}, folded {folded}, {:?} {:?}",
                new_points(&filled).len(),
                start.elapsed(),
                filled.warnings
            );
            assert!(error < bound, "{degrees}°, jitter {jitter}: {error}");
            assert_eq!(folded, 0);
        }
    }
}

/// The numbers of the loops around the origin's side of each tube.
fn inner_loops(s: &Surface) -> Vec<usize> {
    let all = boundary_loops(&s.mesh, &s.x);
    let is_inner = |i: &usize| {
        let sum: DVec3 = all[*i].vertices.iter().map(|&v| s.x[v as usize]).sum();
        (sum / all[*i].vertices.len() as f64).length() < 1.01
    };
    (0..all.len()).filter(is_inner).collect()
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
        let start = std::time::Instant::now();
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
        println!(
            "{count}: {} new, worst {worst:.3}, folded {folded}, order {}, {:?} {:?}",
            new_points(&filled).len(),
            filled.patches[0].order,
            start.elapsed(),
            filled.warnings
        );
        let reach = new_points(&filled)
            .iter()
            .map(|p| p.length())
            .fold(0.0, f64::max);
        println!("reach {reach}");
        assert_eq!(folded, 0);
    }
}
