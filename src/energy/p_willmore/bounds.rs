//! ∫H² dA between its lumped and its consistent value: how far a mesh resolves it.

use super::evaluation::Evaluation;
use crate::mesh::{HalfedgeMesh, Vertex};
use crate::operator::{Elements, Mass, MassMatrix};
use glam::DVec3;

/// ¼ sᵀ M⁻¹ s, s_i = ∂A/∂x_i, with the lumped and with the consistent mass matrix M; no unit.
///
/// lumped ≤ consistent on every mesh. On a mesh that resolves its surface they differ by the
/// discretisation error, of second order; on a crumpled one, where s alternates from vertex
/// to vertex, the lumped value misses what the consistent one sees.
///
/// On an open surface, fields that vanish at the boundary stand for H: there s is no
/// curvature.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WillmoreBounds {
    /// ∫H² dA with the lumped mass.
    pub lumped: f64,
    /// ∫H² dA with the consistent mass.
    pub consistent: f64,
}

impl WillmoreBounds {
    /// Of a mesh of triangles only or quadrilaterals only; `None` of any other.
    pub fn of(mesh: &HalfedgeMesh, x: &[DVec3]) -> Option<Self> {
        Some(Self::of_elements(mesh, &Elements::of(mesh)?, x))
    }

    pub(super) fn of_elements(mesh: &HalfedgeMesh, elements: &Elements, x: &[DVec3]) -> Self {
        let mut at = Evaluation::default();
        at.measure(elements, x);
        at.lump_curvature();
        let is_free = |v: usize| !mesh.is_boundary_vertex(Vertex(v as u32));
        let y = &mut at.curvature;
        for (_, y) in y.iter_mut().enumerate().filter(|(v, _)| !is_free(*v)) {
            *y = DVec3::ZERO;
        }
        let load: Vec<DVec3> = at.area_gradient.iter().map(|s| -*s).collect();
        let quarter = |y: &[DVec3]| {
            let products = y.iter().zip(&load).map(|(y, b)| y.dot(*b));
            0.25 * products.sum::<f64>()
        };
        let lumped = quarter(y);
        let matrix = MassMatrix::new(elements, &at.areas, &at.mass, Mass::Consistent);
        matrix.solve(&load, y, is_free);
        Self {
            lumped,
            consistent: quarter(y),
        }
    }

    /// (consistent − lumped)/consistent, from 0 to 1; 0 of flat surfaces.
    pub fn disagreement(self) -> f64 {
        if self.consistent > 0.0 {
            (self.consistent - self.lumped) / self.consistent
        } else {
            0.0
        }
    }
}
