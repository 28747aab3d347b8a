//! What the p-Willmore functional is told at given positions.

use crate::interrupt::paced;
use crate::operator::Elements;
use glam::DVec3;

/// The integrals of a surface.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Integrals {
    /// What the flow decreases: W^p with the terms of Helfrich and δ.
    pub objective: f64,
    /// W^p itself.
    pub energy: f64,
    /// Area.
    pub area: f64,
    /// Signed volume.
    pub volume: f64,
}

/// Integrals and their exact derivatives, kept from step to step.
#[derive(Clone, Debug, Default)]
pub struct Evaluation {
    /// The integrals.
    pub integrals: Integrals,
    /// ∂objective/∂x_i.
    pub gradient: Vec<DVec3>,
    /// ∂A/∂x_i.
    pub area_gradient: Vec<DVec3>,
    /// ∂V/∂x_i = ∫φ_i n dA; also, normalised, the vertex normal.
    pub volume_gradient: Vec<DVec3>,
    /// m_i, the lumped mass, unit length².
    pub mass: Vec<f64>,
    /// Area of every element at every quadrature point, unit length².
    pub areas: Vec<f64>,
    /// Y_i, unit 1/length.
    pub curvature: Vec<DVec3>,
    /// Iterations of the solves with the mass matrix.
    pub iterations: usize,
}

impl Evaluation {
    /// Area and volume with their gradients, and the lumped mass; neither Y nor energy.
    pub(super) fn measure(&mut self, elements: &Elements, x: &[DVec3]) {
        let n = elements.n_vertices();
        for field in [&mut self.area_gradient, &mut self.volume_gradient] {
            field.clear();
            field.resize(n, DVec3::ZERO);
        }
        self.mass.clear();
        self.mass.resize(n, 0.0);
        self.areas.clear();
        self.curvature.clear();
        self.iterations = 0;
        let (mut area, mut volume) = (0.0, 0.0);
        let origin = x.first().copied().unwrap_or_default();
        for (e, corners) in paced(elements.corners().enumerate()) {
            for node in elements.nodes(x, e) {
                area += node.area;
                self.areas.push(node.area);
                let vector = node.area * node.normal;
                for (k, &v) in corners.iter().enumerate() {
                    let (v, shape) = (v as usize, node.shape[k]);
                    self.mass[v] += node.area * shape;
                    self.area_gradient[v] += node.area * node.gradients[k];
                    self.volume_gradient[v] += shape * vector;
                    volume += shape * (x[v] - origin).dot(vector);
                }
            }
        }
        let all = elements.len() * elements.points().len();
        self.areas.resize(all, 0.0);
        self.integrals = Integrals {
            area,
            volume: volume / 3.0,
            ..Integrals::default()
        };
    }

    /// Y_i = −s_i/m_i of what was measured.
    pub(super) fn lump_curvature(&mut self) {
        self.curvature.clear();
        let pairs = self.area_gradient.iter().zip(&self.mass);
        self.curvature
            .extend(pairs.map(|(s, m)| if *m > 0.0 { -*s / *m } else { DVec3::ZERO }));
    }
}
