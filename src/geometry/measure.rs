//! Edge lengths, areas, volume, angles.

use crate::interrupt::paced;
use crate::mesh::{Edge, Face, HalfedgeMesh, Vertex};
use glam::DVec3;

/// Position of a vertex.
fn at(x: &[DVec3], v: Vertex) -> DVec3 {
    x[v.index()]
}

/// Length of an edge.
pub fn edge_length(mesh: &HalfedgeMesh, x: &[DVec3], e: Edge) -> f64 {
    let [a, b] = mesh.ends(e);
    at(x, a).distance(at(x, b))
}

/// Mean length of all edges; 0 without edges.
pub fn mean_edge_length(mesh: &HalfedgeMesh, x: &[DVec3]) -> f64 {
    let total: f64 = paced(mesh.edges()).map(|e| edge_length(mesh, x, e)).sum();
    total / mesh.n_edges().max(1) as f64
}

/// Mean length of the edges at each vertex; 0 where there are none.
pub fn mean_edge_lengths(mesh: &HalfedgeMesh, x: &[DVec3]) -> Vec<f64> {
    let mut sums = vec![(0.0, 0usize); mesh.n_vertices()];
    for e in paced(mesh.edges()) {
        let length = edge_length(mesh, x, e);
        for v in mesh.ends(e) {
            let (sum, count) = &mut sums[v.index()];
            *sum += length;
            *count += 1;
        }
    }
    let mean = |(sum, count): (f64, usize)| sum / count.max(1) as f64;
    sums.into_iter().map(mean).collect()
}

/// Vector area of a face, Σ ½ x_i × x_{i+1}: normal to the face, as long as its area;
/// for a polygon that is not planar, the area of its projection along that normal.
pub fn face_vector_area(mesh: &HalfedgeMesh, x: &[DVec3], f: Face) -> DVec3 {
    let mut corners = mesh.face_vertices(f).map(|v| at(x, v));
    let Some(origin) = corners.next() else {
        return DVec3::ZERO;
    };
    let mut last = None;
    let mut sum = DVec3::ZERO;
    for p in corners {
        let q = p - origin;
        if let Some(r) = last.replace(q) {
            sum += DVec3::cross(r, q);
        }
    }
    0.5 * sum
}

/// Total area.
pub fn area(mesh: &HalfedgeMesh, x: &[DVec3]) -> f64 {
    paced(mesh.faces())
        .map(|f| face_vector_area(mesh, x, f).length())
        .sum()
}

/// Signed volume, positive with outward normals; `None` unless closed and oriented.
pub fn volume(mesh: &HalfedgeMesh, x: &[DVec3]) -> Option<f64> {
    if !mesh.is_closed() || !mesh.is_oriented() || x.is_empty() {
        return None;
    }
    // Relative to a point of the surface, against cancellation far from the origin.
    let origin = x[0];
    let mut total = 0.0;
    for f in paced(mesh.faces()) {
        let mut corners = mesh.face_vertices(f).map(|v| at(x, v) - origin);
        let (Some(a), Some(mut b)) = (corners.next(), corners.next()) else {
            continue;
        };
        for c in corners {
            total += a.dot(b.cross(c));
            b = c;
        }
    }
    Some(total / 6.0)
}

/// Interior angle at each corner of a triangle, in the order of its vertices.
pub fn triangle_angles([a, b, c]: [DVec3; 3]) -> [f64; 3] {
    let angle = |u: DVec3, v: DVec3| u.cross(v).length().atan2(u.dot(v));
    [
        angle(b - a, c - a),
        angle(c - b, a - b),
        angle(a - c, b - c),
    ]
}

/// Positions of a triangle's corners.
pub fn triangle_points(mesh: &HalfedgeMesh, x: &[DVec3], f: Face) -> [DVec3; 3] {
    mesh.triangle(f).map(|v| at(x, v))
}

/// Smallest corner angle of the mesh in degrees, over corners of any polygon.
pub fn min_angle_degrees(mesh: &HalfedgeMesh, x: &[DVec3]) -> f64 {
    let mut smallest = f64::INFINITY;
    for h in paced(mesh.halfedges()).filter(|&h| !mesh.is_boundary_halfedge(h)) {
        let v = at(x, mesh.tail(h));
        let (u, w) = (at(x, mesh.tip(h)) - v, at(x, mesh.tail(mesh.prev(h))) - v);
        smallest = smallest.min(u.cross(w).length().atan2(u.dot(w)));
    }
    smallest.to_degrees()
}

/// The face with the smallest corner angle, and that angle in degrees.
pub fn sharpest_face(mesh: &HalfedgeMesh, x: &[DVec3]) -> Option<(Face, f64)> {
    paced(mesh.faces())
        .map(|f| (f, least_tangent(mesh, x, f)))
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .map(|(f, tangent)| (f, angle_of(tangent)))
}

/// A number that grows with the smallest corner angle of a face: its tangent up to a right
/// angle, above that infinite. One division a corner, where an angle takes much longer.
fn least_tangent(mesh: &HalfedgeMesh, x: &[DVec3], f: Face) -> f64 {
    let tangent = |h| {
        let v = at(x, mesh.tail(h));
        let (u, w) = (at(x, mesh.tip(h)) - v, at(x, mesh.tail(mesh.prev(h))) - v);
        let (cross, dot) = (u.cross(w).length(), u.dot(w));
        match cross > 0.0 {
            true if dot > 0.0 => cross / dot,
            true => f64::INFINITY,
            false => 0.0,
        }
    };
    mesh.cycle(mesh.halfedge_of_face(f))
        .map(tangent)
        .fold(f64::INFINITY, |a, b| if b < a { b } else { a })
}

fn angle_of(tangent: f64) -> f64 {
    tangent.atan().to_degrees()
}

/// A third of the area of the triangles at each vertex; unit length².
pub fn vertex_areas(mesh: &HalfedgeMesh, x: &[DVec3]) -> Vec<f64> {
    let mut areas = vec![0.0; mesh.n_vertices()];
    add_vertex_areas(mesh, x, mesh.faces(), &mut areas);
    areas
}

/// The same of some triangles, added.
pub fn add_vertex_areas(
    mesh: &HalfedgeMesh,
    x: &[DVec3],
    faces: impl Iterator<Item = Face>,
    areas: &mut [f64],
) {
    for f in paced(faces) {
        let share = face_vector_area(mesh, x, f).length() / 3.0;
        for v in mesh.triangle(f) {
            areas[v.index()] += share;
        }
    }
}

/// Least and greatest corner of the axis-aligned bounding box.
pub fn bounding_box(x: &[DVec3]) -> (DVec3, DVec3) {
    let empty = (DVec3::INFINITY, DVec3::NEG_INFINITY);
    let wider = |(l, h): (DVec3, DVec3), &p: &DVec3| (l.min(p), h.max(p));
    x.iter().fold(empty, wider)
}

/// Length of the diagonal of the axis-aligned bounding box.
pub fn bounding_diagonal(x: &[DVec3]) -> f64 {
    let (low, high) = bounding_box(x);
    if x.is_empty() {
        0.0
    } else {
        (high - low).length()
    }
}
