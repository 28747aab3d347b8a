//! One vertex looked at closely: its star, the angles of its circles, its curvatures.

use super::runner::Runner;
use crate::energy::circle::Boundary;
use crate::energy::circle::angle::{corner_angle, diamond_angle};
use crate::geometry::circumcircle::Circle;
use crate::geometry::{curvature, measure};
use crate::mesh::{Edge, HalfedgeMesh, Vertex};
use crate::operator::fitted::principal::principal_directions;
use glam::DVec3;
use serde::Serialize;
use std::f64::consts::TAU;

/// An edge at the vertex.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct ProbedEdge {
    /// Its other end.
    pub neighbour: u32,
    /// Its length.
    pub length: f64,
    /// Angle between the circumcircles of its two triangles, in radians; of a boundary edge β₂,
    /// to the line through it, where a vertex at infinity closes the boundary. Absent where
    /// the energy has no angle there.
    pub beta: Option<f64>,
    /// Whether it has one triangle only.
    pub boundary: bool,
}

/// What is known of a vertex. Angles are in radians; H, K and the areas have the units of the
/// file, 1/length, 1/length² and length².
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct Probe {
    /// Its number, from 0.
    pub vertex: u32,
    /// In the coordinates of the file.
    pub position: [f64; 3],
    /// Whether it lies on the boundary.
    pub boundary: bool,
    /// Its edges in cyclic order.
    pub edges: Vec<ProbedEdge>,
    /// β₃ of a boundary vertex, the exterior angle of the boundary there, where it counts.
    pub turn: Option<f64>,
    /// Σβ over its edges, with β₃.
    pub sum: f64,
    /// W_i = Σβ − 2π; absent where it is no part of the energy.
    pub energy: Option<f64>,
    /// K_i, the angle defect 2π − Σ angles, π − Σ on the boundary.
    pub defect: f64,
    /// Pointwise H as the flow measures it.
    pub mean_curvature: f64,
    /// Pointwise K, the defect over the area; 0 on the boundary.
    pub gauss_curvature: f64,
    /// κ₁ ≥ κ₂ by the quadratic fit.
    pub principal: Option<[f64; 2]>,
    /// A third of the area of its triangles.
    pub area: f64,
    /// Circumradii of its triangles.
    pub radii: Vec<f64>,
}

/// β of an edge as the circle energy has it under a boundary condition, if it has.
pub fn edge_angle(mesh: &HalfedgeMesh, x: &[DVec3], e: Edge, boundary: Boundary) -> Option<f64> {
    let at = |v: Vertex| x[v.index()];
    let ([i, j], [k, l]) = (mesh.ends(e), mesh.opposite_vertices(e));
    if !mesh.is_boundary_edge(e) {
        return Some(diamond_angle(at(k), at(j), at(l), at(i)).beta);
    }
    (boundary != Boundary::Clamped).then(|| corner_angle(at(i), at(k), at(j)).beta)
}

impl Runner {
    /// The vertex with the surface at `x`; `None` if there is no such vertex.
    pub(super) fn probe(&self, vertex: u32, x: &[DVec3]) -> Option<Probe> {
        let mesh = self.triangles();
        if vertex as usize >= mesh.n_vertices() {
            return None;
        }
        let (v, i) = (Vertex(vertex), vertex as usize);
        let boundary = self.options().boundary.unwrap_or_default();
        let is_boundary = mesh.is_boundary_vertex(v);
        let spokes: Vec<_> = mesh.star(v).collect();
        let edges: Vec<ProbedEdge> = spokes
            .iter()
            .map(|spoke| ProbedEdge {
                neighbour: spoke.neighbour.0,
                length: measure::edge_length(mesh, x, spoke.edge),
                beta: edge_angle(mesh, x, spoke.edge, boundary),
                boundary: mesh.is_boundary_edge(spoke.edge),
            })
            .collect();
        let counted = !is_boundary || boundary != Boundary::Clamped;
        let turn = (is_boundary && counted)
            .then(|| {
                let [p, n] = [spokes.first()?, spokes.last()?].map(|s| x[s.neighbour.index()]);
                Some(corner_angle(p, x[i], n).beta)
            })
            .flatten();
        let sum = edges.iter().filter_map(|e| e.beta).chain(turn).sum::<f64>();
        let triangles = || spokes.iter().map(|s| s.face).filter(|f| f.is_some());
        let corners = triangles().map(|f| measure::triangle_points(mesh, x, f));
        let radii = corners
            .filter_map(Circle::through)
            .map(|circle| circle.radius());
        let measured = self.engine.as_ref().and_then(|flow| flow.mean_curvature(x));
        let mean = measured.unwrap_or_else(|| curvature::pointwise_mean_curvature(mesh, x));
        let position = x[i] + self.document.frame.shift;
        Some(Probe {
            vertex,
            position: position.to_array(),
            boundary: is_boundary,
            turn,
            sum,
            energy: counted.then_some(sum - TAU),
            defect: curvature::integrated_gauss_curvature(mesh, x)[i],
            mean_curvature: mean[i],
            gauss_curvature: curvature::pointwise_gauss_curvature(mesh, x)[i],
            principal: principal_directions(mesh, x, |w| w == i)[i].map(|p| p.curvatures),
            area: measure::vertex_areas(mesh, x)[i],
            radii: radii.collect(),
            edges,
        })
    }
}
