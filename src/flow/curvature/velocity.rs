//! The velocity of one vertex, written so that it can be taken implicitly.

use super::curvatures::Curvatures;

/// A velocity as V_i = Σ_j q_j H_j + k K_i. With the factors q and k at the present surface
/// and the curvatures H and K at the next it is the semi-implicit velocity; with both at
/// the present surface, the velocity itself.
#[derive(Clone, Debug, Default)]
pub(super) struct Velocity {
    weights: Vec<f64>,
    is_touched: Vec<bool>,
    touched: Vec<u32>,
    /// k, the factor of K at the vertex.
    pub(super) on_gauss: f64,
}

impl Velocity {
    pub(super) fn new(n_vertices: usize) -> Self {
        Self {
            weights: vec![0.0; n_vertices],
            is_touched: vec![false; n_vertices],
            ..Self::default()
        }
    }

    /// Makes it V = 0.
    pub(super) fn clear(&mut self) {
        for &j in &self.touched {
            self.weights[j as usize] = 0.0;
            self.is_touched[j as usize] = false;
        }
        self.touched.clear();
        self.on_gauss = 0.0;
    }

    /// Adds to q_j.
    pub(super) fn add(&mut self, j: u32, weight: f64) {
        if !self.is_touched[j as usize] {
            self.is_touched[j as usize] = true;
            self.touched.push(j);
        }
        self.weights[j as usize] += weight;
    }

    /// The q_j that are not zero.
    pub(super) fn on_curvature(&self) -> impl Iterator<Item = (usize, f64)> + '_ {
        let touched = self.touched.iter();
        touched.map(|&j| (j as usize, self.weights[j as usize]))
    }

    /// V_i at the present surface.
    pub(super) fn value(&self, at: &Curvatures, i: usize) -> f64 {
        let sum: f64 = self.on_curvature().map(|(j, q)| q * at.mean[j]).sum();
        sum + self.on_gauss * at.gauss[i]
    }
}
