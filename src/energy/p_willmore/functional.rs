//! The functional a p-Willmore flow decreases, with its exact first variation.

use crate::energy::total_curvature;
use crate::mesh::HalfedgeMesh;
use crate::operator::Elements;
use glam::DVec3;
use std::rc::Rc;

/// Below this share of its root mean square |Y| is rounded off where p < 2, and floored in
/// the stiffness: |Y|^(p−2) has no bound there.
const LEAST_CURVATURE: f64 = 1e-2;

/// Terms of Canham & Helfrich beside ∫(2H)² dA.
///
/// With c₀ = 2H₀ the functional is ∫(2H − c₀)² dA + σA − PV
/// = ∫(2H)² dA − 2c₀ ∫2H dA + (c₀² + σ) A − P V.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Helfrich {
    /// c₀ = 2H₀, unit 1/length; positive bends outwards as a sphere with outward normal.
    pub spontaneous: f64,
    /// σ, per area.
    pub tension: f64,
    /// P, per volume.
    pub pressure: f64,
}

impl Helfrich {
    /// Whether there are no such terms.
    pub fn is_zero(self) -> bool {
        self == Self::default()
    }
}

/// W^p = ∫|Y|^p dA with the mean-curvature vector Y = Δx = −2Hn, by vertex lumping:
/// Σ m_i |Y_i|^p with m_i = ∫φ_i dA, Y_i = −s_i/m_i and s_i = ∂A/∂x_i.
///
/// The paper's functional without its factor 2^−p (Remark 2.3), so 2^p ∫|H|^p dA; unit
/// length^(2−p). p = 0 is the area. For p < 2 |Y|² is replaced by |Y|² + δ² with δ a
/// hundredth of the root mean square of |Y| at the start.
#[derive(Clone, Debug)]
pub struct PWillmore {
    mesh: Rc<HalfedgeMesh>,
    elements: Elements,
    p: f64,
    helfrich: Helfrich,
    /// δ².
    rounding: f64,
}

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
    /// m_i, unit length².
    pub mass: Vec<f64>,
    /// Y_i, unit 1/length.
    pub curvature: Vec<DVec3>,
}

impl PWillmore {
    /// The functional on a closed, oriented mesh of triangles only or quadrilaterals only,
    /// for a flow that starts at `x`; `None` of any other mesh.
    pub fn new(mesh: Rc<HalfedgeMesh>, x: &[DVec3], p: f64, helfrich: Helfrich) -> Option<Self> {
        let elements = Elements::of(&mesh)?;
        let mut functional = Self {
            mesh,
            elements,
            p,
            helfrich,
            rounding: 0.0,
        };
        if p > 0.0 && p < 2.0 {
            let mut start = Evaluation::default();
            functional.measure(x, &mut start);
            functional.rounding = (LEAST_CURVATURE * rms(&start)).powi(2);
        }
        Some(functional)
    }

    /// The exponent.
    pub fn p(&self) -> f64 {
        self.p
    }

    /// The terms of Helfrich.
    pub fn helfrich(&self) -> Helfrich {
        self.helfrich
    }

    /// What a reader is shown: ∫|H|^p dA, or with the terms of Helfrich a quarter of the
    /// functional, ∫(H − H₀)² dA + (σA − PV)/4.
    pub fn reading(&self, integrals: &Integrals) -> f64 {
        let shown = if self.helfrich.is_zero() {
            integrals.energy
        } else {
            integrals.objective
        };
        shown / 2f64.powf(self.p)
    }

    /// δ², which rounds |Y|² where p < 2.
    pub fn rounding(&self) -> f64 {
        self.rounding
    }

    /// W_i = |Y_i|^(p−2) Y_i, of an evaluation.
    pub fn weighted(&self, evaluation: &Evaluation) -> Vec<DVec3> {
        let weight = |y: &DVec3| power(y.length_squared() + self.rounding, 0.5 * self.p - 1.0);
        let weighted = evaluation.curvature.iter().map(|y| weight(y) * *y);
        // 0 · ∞ where Y vanishes and p = 0.
        weighted
            .map(|w| if w.is_finite() { w } else { DVec3::ZERO })
            .collect()
    }

    /// The mesh as elements.
    pub fn elements(&self) -> &Elements {
        &self.elements
    }

    /// The integrals at `x`.
    pub fn integrals(&self, x: &[DVec3], scratch: &mut Evaluation) -> Integrals {
        self.measure(x, scratch);
        let Self { p, rounding, .. } = *self;
        let mut integrals = scratch.integrals;
        if p == 0.0 {
            integrals.energy = integrals.area;
            integrals.objective = integrals.area;
        } else {
            let (mut energy, mut objective) = (0.0, 0.0);
            for (y, &m) in scratch.curvature.iter().zip(&scratch.mass) {
                let square = y.length_squared();
                energy += m * power(square, 0.5 * p);
                if rounding > 0.0 {
                    objective += m * power(square + rounding, 0.5 * p);
                }
            }
            integrals.energy = energy;
            integrals.objective = if rounding > 0.0 { objective } else { energy };
        }
        let Helfrich {
            spontaneous: c,
            tension,
            pressure,
        } = self.helfrich;
        if !self.helfrich.is_zero() {
            integrals.objective += (c * c + tension) * integrals.area - pressure * integrals.volume;
            if c != 0.0 {
                integrals.objective -= 2.0 * c * total_curvature::value(&self.mesh, x);
            }
        }
        scratch.integrals = integrals;
        integrals
    }

    /// The integrals and all derivatives at `x`.
    ///
    /// With a_i = f − 2f′|Y_i|² and w_i = −2f′ Y_i, f(|Y|²) the integrand, the gradient is
    /// Σ (a div φ + ⟨H_A w, φ⟩), H_A the second variation of area (Lemma 3.1): Theorem 3.2
    /// with |Y|^p − p Y·W for the printed (1 − p)|Y|^p, which lumping makes the same.
    pub fn evaluate(&self, x: &[DVec3], out: &mut Evaluation) {
        self.integrals(x, out);
        out.gradient.clear();
        if self.p == 0.0 {
            out.gradient.extend_from_slice(&out.area_gradient);
        } else {
            out.gradient.resize(x.len(), DVec3::ZERO);
            self.add_bending(x, out);
        }
        self.add_helfrich(x, out);
    }

    /// Area and volume with their gradients, mass and Y; no energy.
    pub fn measure(&self, x: &[DVec3], out: &mut Evaluation) {
        let n = self.elements.n_vertices();
        for field in [&mut out.area_gradient, &mut out.volume_gradient] {
            field.clear();
            field.resize(n, DVec3::ZERO);
        }
        out.mass.clear();
        out.mass.resize(n, 0.0);
        let (mut area, mut volume) = (0.0, 0.0);
        let origin = x.first().copied().unwrap_or_default();
        for (e, corners) in self.elements.corners().enumerate() {
            for node in self.elements.nodes(x, e) {
                area += node.area;
                let vector = node.area * node.normal;
                for (k, &v) in corners.iter().enumerate() {
                    let (v, shape) = (v as usize, node.shape[k]);
                    out.mass[v] += node.area * shape;
                    out.area_gradient[v] += node.area * node.gradients[k];
                    out.volume_gradient[v] += shape * vector;
                    volume += shape * (x[v] - origin).dot(vector);
                }
            }
        }
        out.integrals = Integrals {
            area,
            volume: volume / 3.0,
            ..Integrals::default()
        };
        out.curvature.clear();
        let curvature = out.area_gradient.iter().zip(&out.mass);
        out.curvature
            .extend(curvature.map(|(s, m)| if *m > 0.0 { -*s / *m } else { DVec3::ZERO }));
    }

    fn add_bending(&self, x: &[DVec3], out: &mut Evaluation) {
        let half = 0.5 * self.p;
        // a_i and w_i of the doc comment.
        let weights: Vec<(f64, DVec3)> = out
            .curvature
            .iter()
            .map(|y| {
                let square = y.length_squared();
                let rounded = square + self.rounding;
                let slope = self.p * power(rounded, half - 1.0);
                (power(rounded, half) - slope * square, -slope * *y)
            })
            .collect();
        for (e, corners) in self.elements.corners().enumerate() {
            for node in self.elements.nodes(x, e) {
                let (mut a, mut divergence, mut slope) = (0.0, 0.0, DVec3::ZERO);
                for (k, &v) in corners.iter().enumerate() {
                    let (a_k, w_k) = weights[v as usize];
                    a += node.shape[k] * a_k;
                    divergence += node.gradients[k].dot(w_k);
                    slope += node.normal.dot(w_k) * node.gradients[k];
                }
                for (j, &v) in corners.iter().enumerate() {
                    let g_j = node.gradients[j];
                    let mut along = DVec3::ZERO;
                    for (k, &u) in corners.iter().enumerate() {
                        along += g_j.dot(weights[u as usize].1) * node.gradients[k];
                    }
                    let sum = (a + divergence) * g_j - along + g_j.dot(slope) * node.normal;
                    out.gradient[v as usize] += node.area * sum;
                }
            }
        }
    }

    fn add_helfrich(&self, x: &[DVec3], out: &mut Evaluation) {
        let Helfrich {
            spontaneous: c,
            tension,
            pressure,
        } = self.helfrich;
        if self.helfrich.is_zero() {
            return;
        }
        for (i, gradient) in out.gradient.iter_mut().enumerate() {
            *gradient +=
                (c * c + tension) * out.area_gradient[i] - pressure * out.volume_gradient[i];
        }
        if c != 0.0 {
            total_curvature::add_gradient(&self.mesh, x, -2.0 * c, &mut out.gradient);
        }
    }

    /// c_i of the stiffness L diag(c) L ≈ ∂²W^p: p max(1, p − 1) |Y_i|^(p−2) / m_i.
    /// Empty for p = 0, whose stiffness is L.
    pub fn stiffness(&self, evaluation: &Evaluation) -> Vec<f64> {
        if self.p == 0.0 {
            return Vec::new();
        }
        let floor = LEAST_CURVATURE * rms(evaluation);
        let factor = self.p * (self.p - 1.0).max(1.0);
        let pairs = evaluation.curvature.iter().zip(&evaluation.mass);
        pairs
            .map(|(y, m)| {
                let size = y.length().max(floor);
                factor * power(size * size, 0.5 * self.p - 1.0) / m.max(f64::MIN_POSITIVE)
            })
            .collect()
    }
}

/// q^e, the powers of p = 2 without `powf`; 0^0 = 1.
fn power(q: f64, e: f64) -> f64 {
    if e == 1.0 {
        q
    } else if e == 0.0 {
        1.0
    } else if e == 2.0 {
        q * q
    } else {
        q.powf(e)
    }
}

/// Root mean square of |Y| over the surface.
fn rms(evaluation: &Evaluation) -> f64 {
    let pairs = evaluation.curvature.iter().zip(&evaluation.mass);
    let sum: f64 = pairs.map(|(y, m)| m * y.length_squared()).sum();
    (sum / evaluation.mass.iter().sum::<f64>()).sqrt()
}
