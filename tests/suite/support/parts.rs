//! Parts as drawing programs triangulate them: flat sides, sharp edges, long triangles.

use glam::{DVec2, DVec3};
use std::f64::consts::TAU;
use umbilic::mesh::subdivide;
use umbilic::soup::PolygonSoup;

/// How the ends of a prism are filled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ends {
    /// With a fan from the first corner, which sees the others of a convex outline.
    Fan,
    /// With a fan from one vertex more, at the axis.
    Hub,
    /// At the top by a point at the axis, that much higher than the top; at the bottom by a fan
    /// from the axis.
    Tip(f64),
}

/// The prism over a closed outline, counter-clockwise, with its layers at these heights.
pub fn prism(outline: &[DVec2], heights: &[f64], ends: Ends) -> PolygonSoup {
    let n = outline.len() as u32;
    let layer = |z: &f64| {
        outline
            .iter()
            .map(move |p| p.extend(*z))
            .collect::<Vec<_>>()
    };
    let mut positions: Vec<DVec3> = heights.iter().flat_map(layer).collect();
    let mut faces = Vec::new();
    let top = n * (heights.len() as u32 - 1);
    for low in (0..top).step_by(n as usize) {
        for i in 0..n {
            let (a, b) = (low + i, low + (i + 1) % n);
            faces.extend([[a, b, b + n], [a, b + n, a + n]]);
        }
    }
    let hub = positions.len() as u32;
    let (low, high) = (heights[0], heights[heights.len() - 1]);
    let tip = if let Ends::Tip(above) = ends {
        above
    } else {
        0.0
    };
    if ends == Ends::Fan {
        faces.extend((1..n - 1).map(|i| [0, i + 1, i]));
        faces.extend((1..n - 1).map(|i| [top, top + i, top + i + 1]));
    } else {
        positions.extend([DVec3::Z * low, DVec3::Z * (high + tip)]);
        faces.extend((0..n).map(|i| [hub, (i + 1) % n, i]));
        faces.extend((0..n).map(|i| [hub + 1, top + i, top + (i + 1) % n]));
    }
    PolygonSoup::from_faces(positions, &faces)
}

/// A regular outline of `n` corners.
pub fn circle(n: u32, radius: f64) -> Vec<DVec2> {
    let turn = |i: u32| DVec2::from_angle(TAU * f64::from(i) / f64::from(n));
    (0..n).map(|i| radius * turn(i)).collect()
}

/// A rectangle, its corners cut off at that distance from them.
pub fn chamfered(width: f64, depth: f64, cut: f64) -> Vec<DVec2> {
    let (x, y) = (0.5 * width, 0.5 * depth);
    if cut == 0.0 {
        return [[x, -y], [x, y], [-x, y], [-x, -y]].map(DVec2::from).into();
    }
    let (u, v) = (x - cut, y - cut);
    [
        [x, -v],
        [x, v],
        [u, y],
        [-u, y],
        [-x, v],
        [-x, -v],
        [-u, -y],
        [u, -y],
    ]
    .map(DVec2::from)
    .into()
}

/// A gear of `teeth`.
pub fn gear(teeth: u32, inner: f64, outer: f64) -> Vec<DVec2> {
    let corner = |i: u32| {
        let radius = if i % 4 < 2 { inner } else { outer };
        radius * DVec2::from_angle(TAU * f64::from(i) / f64::from(4 * teeth))
    };
    (0..4 * teeth).map(corner).collect()
}

/// Each triangle in four, the surface the same, `levels` times.
pub fn refined(soup: &PolygonSoup, levels: usize) -> PolygonSoup {
    subdivide::linear_levels(soup.clone(), levels).expect("triangles")
}

/// Vertices inside flat sides pushed about in them, by up to that share of their shortest
/// edge: the same part, badly meshed. Below ½ no triangle turns over on a regular grid.
pub fn crumpled(soup: &PolygonSoup, share: f64, seed: u64) -> PolygonSoup {
    let mut random = super::Random(seed);
    let s = super::surface(soup);
    let normal = |f| umbilic::geometry::measure::face_vector_area(&s.mesh, &s.x, f).normalize();
    let mut positions = s.x.clone();
    for v in s.mesh.vertices() {
        let x = s.x[v.index()];
        let normals: Vec<DVec3> = s.mesh.star(v).map(|spoke| normal(spoke.face)).collect();
        let push = random.vector();
        if normals.iter().all(|n| n.dot(normals[0]) > 1.0 - 1e-9) {
            let lengths = s.mesh.neighbours(v).map(|w| x.distance(s.x[w.index()]));
            let shortest = lengths.fold(f64::INFINITY, f64::min);
            positions[v.index()] += share * shortest * push.reject_from_normalized(normals[0]);
        }
    }
    s.mesh.to_soup(&positions)
}
