//! The surface around a vertex as a quadric over its tangent plane.
//!
//! z = ½(a u² + 2b uv + c v²) + d u + e v by weighted least squares over two rings, through
//! the vertex; weights 1/(0.3 + r²/h²) with h the root mean square of its edges. Neighbours
//! whose normal disagrees are left out: beyond a fold they say nothing of this sheet. The
//! curvatures are exact to O(h²) on regular meshes and to O(h) on others.
//!
//! [`FittedOperators`](crate::operator::fitted::FittedOperators) fits a quadratic too, from
//! fewer neighbours and for its derivatives' weights; here the surface itself is needed, also
//! where triangles are bad.

use crate::interrupt::paced;
use glam::DVec3;

/// Normals with a smaller scalar product belong to another part of the surface.
const AGREEING: f64 = 0.2;
/// Unknowns of the fit.
const N: usize = 5;

/// A quadric in a frame at a vertex.
#[derive(Clone, Copy, Debug)]
pub(super) struct Quadric {
    u: DVec3,
    v: DVec3,
    n: DVec3,
    /// a, b, c; unit 1/length.
    second: [f64; 3],
    /// d, e.
    slope: [f64; 2],
}

impl Quadric {
    /// The tangent plane alone.
    fn plane(n: DVec3) -> Self {
        // A vertex whose faces cancel has no normal; any frame will do.
        let n = if n == DVec3::ZERO { DVec3::Z } else { n };
        let u = n.any_orthonormal_vector();
        Self {
            u,
            v: n.cross(u),
            n,
            second: [0.0; 3],
            slope: [0.0; 2],
        }
    }

    /// The principal curvatures, the smaller first; against the normal they are negative.
    pub(super) fn curvatures(&self) -> [f64; 2] {
        let ([a, b, c], [d, e]) = (self.second, self.slope);
        let (g11, g12, g22) = (1.0 + d * d, d * e, 1.0 + e * e);
        let det = g11 * g22 - g12 * g12;
        let stretch = det.sqrt();
        let mean = (g11 * c - 2.0 * g12 * b + g22 * a) / (2.0 * det * stretch);
        let gauss = (a * c - b * b) / (det * det);
        let half_gap = (mean * mean - gauss).max(0.0).sqrt();
        [mean - half_gap, mean + half_gap]
    }

    /// The larger of |κ₁| and |κ₂|.
    pub(super) fn bend(&self) -> f64 {
        let [low, high] = self.curvatures();
        low.abs().max(high.abs())
    }

    /// The step that stays on the quadric and goes, seen along the normal, the way `step` does
    /// but by `longest` at most.
    pub(super) fn along(&self, step: DVec3, longest: f64) -> DVec3 {
        let (mut p, mut q) = (step.dot(self.u), step.dot(self.v));
        let length = p.hypot(q);
        if length > longest {
            (p, q) = (p * longest / length, q * longest / length);
        }
        let ([a, b, c], [d, e]) = (self.second, self.slope);
        let height = d * p + e * q + 0.5 * (a * p * p + 2.0 * b * p * q + c * q * q);
        // Where triangles are folded over, a fit is as steep as it likes.
        let steepest = length.min(longest);
        let height = height.clamp(-steepest, steepest);
        p * self.u + q * self.v + height * self.n
    }
}

/// The quadrics at all vertices, of which `rings` has the neighbours; planes at some where the work is
/// given up.
pub(super) fn fits(x: &[DVec3], rings: &[Vec<u32>], normals: &[DVec3]) -> Vec<Quadric> {
    let mut marked_by = vec![u32::MAX; x.len()];
    let mut around = Vec::new();
    let fitted = paced(0..x.len() as u32).map(|i| {
        around.clear();
        marked_by[i as usize] = i;
        for &j in &rings[i as usize] {
            for k in std::iter::once(j).chain(rings[j as usize].iter().copied()) {
                if marked_by[k as usize] != i {
                    marked_by[k as usize] = i;
                    around.push(k);
                }
            }
        }
        fit(x, normals, i as usize, &rings[i as usize], &around)
    });
    let mut quadrics: Vec<Quadric> = fitted.collect();
    let rest = &normals[quadrics.len()..];
    quadrics.extend(rest.iter().map(|n| Quadric::plane(*n)));
    quadrics
}

fn fit(x: &[DVec3], normals: &[DVec3], i: usize, ring: &[u32], around: &[u32]) -> Quadric {
    let mut quadric = Quadric::plane(normals[i]);
    let squares = ring.iter().map(|&j| x[j as usize].distance_squared(x[i]));
    let h = (squares.sum::<f64>() / ring.len().max(1) as f64).sqrt();
    if h <= 0.0 {
        return quadric;
    }
    let mut system = [[0.0; N + 1]; N];
    for &j in around {
        if normals[j as usize].dot(normals[i]) < AGREEING {
            continue;
        }
        let r = (x[j as usize] - x[i]) / h;
        let (p, q) = (r.dot(quadric.u), r.dot(quadric.v));
        let row = [0.5 * p * p, p * q, 0.5 * q * q, p, q, r.dot(quadric.n)];
        let weight = 1.0 / (0.3 + r.length_squared());
        for (k, to) in system.iter_mut().enumerate() {
            let factor = weight * row[k];
            for (entry, value) in to[k..].iter_mut().zip(&row[k..]) {
                *entry += factor * value;
            }
        }
    }
    if let Some([a, b, c, d, e]) = solved(system) {
        quadric.second = [a / h, b / h, c / h];
        quadric.slope = [d, e];
    }
    quadric
}

/// Elimination in the upper half of a symmetric matrix, the right side beside it; `None` where it
/// is not positive definite.
fn solved(mut m: [[f64; N + 1]; N]) -> Option<[f64; N]> {
    for i in 0..N {
        if m[i][i].is_nan() || m[i][i] < 1e-12 {
            return None;
        }
        let row = m[i];
        for r in i + 1..N {
            let factor = row[r] / row[i];
            for (entry, value) in m[r][r..].iter_mut().zip(&row[r..]) {
                *entry -= factor * value;
            }
        }
    }
    let mut solution = [0.0; N];
    for i in (0..N).rev() {
        let known: f64 = (i + 1..N).map(|k| m[i][k] * solution[k]).sum();
        solution[i] = (m[i][N] - known) / m[i][i];
    }
    Some(solution)
}
