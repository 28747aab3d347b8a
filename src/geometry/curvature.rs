//! Discrete curvatures at the vertices of a triangle mesh.

use super::measure::{face_vector_area, triangle_angles, triangle_points, vertex_areas};
use crate::mesh::HalfedgeMesh;
use glam::DVec3;
use std::f64::consts::{PI, TAU};

/// Integrated Gaussian curvature at each vertex: the angle defect 2π − Σ angles, π − Σ
/// on the boundary. Dimensionless; sums to 2πχ (Gauss–Bonnet).
pub fn integrated_gauss_curvature(mesh: &HalfedgeMesh, x: &[DVec3]) -> Vec<f64> {
    let mut defect: Vec<f64> = mesh
        .vertices()
        .map(|v| if mesh.is_boundary_vertex(v) { PI } else { TAU })
        .collect();
    for f in mesh.faces() {
        let angles = triangle_angles(triangle_points(mesh, x, f));
        for (v, angle) in mesh.triangle(f).into_iter().zip(angles) {
            defect[v.index()] -= angle;
        }
    }
    defect
}

/// Gradient of the total area with respect to each vertex, ½ Σ (cot α + cot β)(x_i − x_j)
/// over the edges at i: the integrated mean-curvature vector 2Hn of the vertex's third
/// of the area; unit length. Half the jump of the outer conormals of its triangles, it
/// needs no orientation.
pub fn area_gradient(mesh: &HalfedgeMesh, x: &[DVec3]) -> Vec<DVec3> {
    let mut gradient = vec![DVec3::ZERO; mesh.n_vertices()];
    for f in mesh.faces() {
        let [p, q, r] = triangle_points(mesh, x, f);
        let Some(n) = (q - p).cross(r - p).try_normalize() else {
            continue;
        };
        for (v, opposite) in mesh.triangle(f).into_iter().zip([r - q, p - r, q - p]) {
            gradient[v.index()] += 0.5 * n.cross(opposite);
        }
    }
    gradient
}

/// Area-weighted unit vertex normals; zero where the faces cancel. On a surface that
/// is not orientable the sign is that of the faces around each vertex as stored.
pub fn vertex_normals(mesh: &HalfedgeMesh, x: &[DVec3]) -> Vec<DVec3> {
    let mut normals = vec![DVec3::ZERO; mesh.n_vertices()];
    for f in mesh.faces() {
        let n = face_vector_area(mesh, x, f);
        for v in mesh.face_vertices(f) {
            normals[v.index()] += n;
        }
    }
    normals.into_iter().map(DVec3::normalize_or_zero).collect()
}

/// Pointwise mean curvature H = ½ ⟨∇A, n⟩ / area at each vertex, unit 1/length,
/// positive on a sphere with outward normal; 0 on the boundary, where the area gradient
/// is no curvature.
pub fn pointwise_mean_curvature(mesh: &HalfedgeMesh, x: &[DVec3]) -> Vec<f64> {
    let (gradient, areas) = (area_gradient(mesh, x), vertex_areas(mesh, x));
    let normals = vertex_normals(mesh, x);
    mesh.vertices()
        .map(|v| {
            let i = v.index();
            let (vector, area) = (gradient[i], areas[i]);
            if mesh.is_boundary_vertex(v) || area <= 0.0 {
                return 0.0;
            }
            // Size from the vector, sign from the normal.
            0.5 * vector.length().copysign(vector.dot(normals[i])) / area
        })
        .collect()
}

/// Pointwise Gaussian curvature: angle defect per third of the area, unit 1/length²;
/// 0 on the boundary, where the defect is that of a curve.
pub fn pointwise_gauss_curvature(mesh: &HalfedgeMesh, x: &[DVec3]) -> Vec<f64> {
    let areas = vertex_areas(mesh, x);
    integrated_gauss_curvature(mesh, x)
        .into_iter()
        .zip(mesh.vertices())
        .map(|(k, v)| {
            let area = areas[v.index()];
            if mesh.is_boundary_vertex(v) || area <= 0.0 {
                0.0
            } else {
                k / area
            }
        })
        .collect()
}
