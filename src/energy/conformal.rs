//! Conformal distortion against reference angles, after Gruber & Aulisa
//! [GA20](crate::bibliography#ga20).

use crate::geometry::measure::{face_vector_area, triangle_points};
use crate::mesh::HalfedgeMesh;
use glam::DVec3;
use std::f64::consts::{PI, TAU};

/// Reference angles of a triangle from the number of triangles at each corner
/// (Algorithm 1 of the paper, with α_i = 2π/m_i, which the printed text garbles).
///
/// Where one angle is strictly the largest it is kept and the others share the rest in
/// proportion; otherwise all three are scaled to sum to π.
pub fn reference_angles(incident: [usize; 3]) -> [f64; 3] {
    let a = incident.map(|m| TAU / m.max(1) as f64);
    let sum: f64 = a.iter().sum();
    let largest = (0..3).find(|&i| (0..3).all(|j| j == i || a[i] > a[j]));
    match largest {
        // An angle of π or more leaves nothing to share: scaling keeps all positive.
        Some(i) if a[i] < PI => {
            let scale = (PI - a[i]) / (sum - a[i]);
            [0, 1, 2].map(|j| if j == i { a[j] } else { scale * a[j] })
        }
        _ => a.map(|angle| angle * PI / sum),
    }
}

/// Conformal distortion Σ_T 2 (D_T − A_T) ≥ 0 with the Dirichlet energy
/// D_T = ¼ Σ cot(α_k) |e_k|² of the map from a triangle with the reference angles.
/// Unit length²; 0 where every triangle has its reference angles.
pub fn conformal_distortion(mesh: &HalfedgeMesh, x: &[DVec3]) -> f64 {
    let mut incident = vec![0usize; mesh.n_vertices()];
    for f in mesh.faces() {
        mesh.triangle(f)
            .into_iter()
            .for_each(|v| incident[v.index()] += 1);
    }
    mesh.faces()
        .map(|f| {
            let angles = reference_angles(mesh.triangle(f).map(|v| incident[v.index()]));
            let [a, b, c] = triangle_points(mesh, x, f);
            let opposite = [
                b.distance_squared(c),
                c.distance_squared(a),
                a.distance_squared(b),
            ];
            let dirichlet: f64 = angles
                .iter()
                .zip(opposite)
                .map(|(angle, e)| e / angle.tan())
                .sum::<f64>()
                / 4.0;
            2.0 * (dirichlet - face_vector_area(mesh, x, f).length())
        })
        .sum()
}
