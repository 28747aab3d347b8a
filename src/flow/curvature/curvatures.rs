//! The operators and curvatures of a surface where a flow needs them.

use super::region::Region;
use crate::flow::FlowError;
use crate::geometry::measure;
use crate::interrupt::paced;
use crate::mesh::HalfedgeMesh;
use crate::operator::FittedOperators;
use glam::DVec3;

/// Fitted operators within reach of the free vertices, and the curvatures there.
pub(super) struct Curvatures {
    pub(super) operators: FittedOperators,
    /// H by vertex; not a number where there is no fit.
    pub(super) mean: Vec<f64>,
    /// K by vertex; the same.
    pub(super) gauss: Vec<f64>,
    /// Vertices that integrals run over, with their areas.
    near: Vec<(u32, f64)>,
}

impl Curvatures {
    pub(super) fn of(mesh: &HalfedgeMesh, x: &[DVec3], region: &Region) -> Self {
        let operators = FittedOperators::fit(mesh, x, &region.reach);
        let mut mean = vec![f64::NAN; x.len()];
        let mut gauss = vec![f64::NAN; x.len()];
        for v in paced(0..x.len()) {
            if let Some(row) = operators.row(v) {
                mean[v] = operators.mean_curvature(row, x);
                gauss[v] = operators.gauss_curvature(row, x);
            }
        }
        let mut areas = vec![0.0; x.len()];
        measure::add_vertex_areas(mesh, x, region.near_faces.iter().copied(), &mut areas);
        let near = region.near.iter().map(|&v| (v, areas[v as usize]));
        Self {
            near: near.collect(),
            operators,
            mean,
            gauss,
        }
    }

    /// Row of a vertex that must have one.
    pub(super) fn row(&self, vertex: usize) -> Result<usize, FlowError> {
        self.operators.row(vertex).ok_or(FlowError::Unfit {
            vertex: vertex as u32,
        })
    }

    /// Vertices that integrals run over, each with a third of the area of its triangles.
    pub(super) fn areas(&self) -> impl Iterator<Item = (usize, f64)> {
        self.near.iter().map(|&(v, area)| (v as usize, area))
    }

    /// Integral over the part of the surface that free vertices have an influence on: all
    /// vertices within two edges of them, each with a third of its triangles. Vertices
    /// without a fit are left out.
    pub(super) fn integrate(&self, density: impl Fn(&Self, usize, usize) -> f64) -> f64 {
        let fitted = paced(&self.near).filter_map(|&(v, area)| {
            let row = self.operators.row(v as usize)?;
            Some(area * density(self, row, v as usize))
        });
        fitted.filter(|term| !term.is_nan()).sum()
    }
}
