//! ∫|H|^p dA, the p-Willmore energies of Gruber & Aulisa [GA20](crate::bibliography#ga20).

mod bounds;
mod evaluation;
mod functional;

pub use bounds::WillmoreBounds;
pub use evaluation::{Evaluation, Integrals};
pub use functional::{Helfrich, PWillmore};

use crate::geometry::curvature::area_gradient;
use crate::geometry::measure::{area, vertex_areas};
use crate::mesh::HalfedgeMesh;
use glam::DVec3;

/// ∫|H|^p dA by vertex lumping: Σ m_i |∇A_i / 2m_i|^p with m_i a third of the area of
/// the triangles at i. Unit length^(2−p); p = 0 is the area. H = (κ₁+κ₂)/2, so the
/// paper's W^p, with Y = 2Hn, is 2^p times this.
///
/// On an open surface the sum is over interior vertices, p = 0 excepted: at the boundary
/// the area gradient is no curvature.
pub fn integrated_power(mesh: &HalfedgeMesh, x: &[DVec3], p: f64) -> f64 {
    if p == 0.0 {
        return area(mesh, x);
    }
    let (gradient, mass) = (area_gradient(mesh, x), vertex_areas(mesh, x));
    mesh.vertices()
        .filter(|&v| !mesh.is_boundary_vertex(v) && mass[v.index()] > 0.0)
        .map(|v| {
            let m = mass[v.index()];
            m * (0.5 * gradient[v.index()].length() / m).powf(p)
        })
        .sum()
}
