//! The intersection angle β of two circumcircles and its derivatives.
//!
//! For an interior edge `(i, j)` with opposite vertices `k`, `l` the angle depends
//! on the six squared distances of its *diamond* only through three products,
//!
//! ```math
//! P = |kj|^2 |li|^2, \quad Q = |jl|^2 |ik|^2, \quad R = |ij|^2 |kl|^2, \qquad
//! \cos \beta = \frac{R - P - Q}{2 \sqrt{PQ}},
//! ```
//!
//! the law of cosines in the triangle of the three other points after an inversion
//! at the fourth, which is why β is Möbius invariant. With one vertex at infinity the
//! distances to it cancel and the same formula holds with one distance in each of P,
//! Q, R: that is an angle at a *corner*, used at free boundaries. Bobenko & Schröder
//! write cos β as −Re of the normalised cross-ratio (Section 3.1); Eq. (1) is the
//! derivative below, sorted by edges.

use glam::DVec3;

/// An angle with its sine and cosine, each accurate near 0 and near π.
#[derive(Clone, Copy, Debug)]
pub struct Angle {
    /// β in [0, π].
    pub beta: f64,
    /// sin β ≥ 0.
    pub sin: f64,
    /// cos β.
    pub cos: f64,
}

impl Angle {
    /// From the lengths of the imaginary and real part of an unnormalised quaternion.
    fn from_parts(im: f64, re: f64) -> Self {
        // Not `hypot`: in wasm it costs more than the rest, and neither part comes near the
        // ends of the number range unless lengths do (10^±38).
        let norm = (im * im + re * re).sqrt();
        Self {
            beta: im.atan2(re),
            sin: im / norm,
            cos: re / norm,
        }
    }
}

/// β of the diamond `k → j → l → i` about the edge `(i, j)`: the angle between the
/// circumcircles of `(i, k, j)` and `(i, j, l)`. Invariant under cyclic permutation
/// and reversal of its arguments; no orientation is used. Dimensionless.
///
/// By `atan2` of imaginary against real part of the quaternion cross-ratio: `acos`
/// would lose half the digits near 0.
pub fn diamond_angle(k: DVec3, j: DVec3, l: DVec3, i: DVec3) -> Angle {
    let (im, re) = diamond_parts(k, j, l, i);
    Angle::from_parts(im, re)
}

/// Sine and cosine of [`diamond_angle`], both times the product of the four lengths.
pub fn diamond_parts(k: DVec3, j: DVec3, l: DVec3, i: DVec3) -> (f64, f64) {
    let (a, b, c, d) = (j - k, l - j, i - l, k - i);
    let (ab, cd) = (a.dot(b), c.dot(d));
    let (axb, cxd) = (a.cross(b), c.cross(d));
    let re = a.dot(c) * b.dot(d) - ab * cd - b.dot(c) * d.dot(a);
    let im = axb.cross(cxd) - ab * cxd - cd * axb;
    (im.length(), re)
}

/// β at the corner `p → v → n`: the exterior angle there, π minus the angle `pvn`.
pub fn corner_angle(p: DVec3, v: DVec3, n: DVec3) -> Angle {
    let (u, z) = (v - p, n - v);
    Angle::from_parts(u.cross(z).length(), u.dot(z))
}

/// How an angle enters the energy: φ(β) = √(β² + ε²) − ε.
///
/// The exact energy is ε = 0. A positive ε rounds off the cone at β = 0, where the
/// exact gradient jumps, and keeps Möbius invariance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Smoothing {
    /// ε ≥ 0 in radians.
    pub epsilon: f64,
}

/// Below this sine the exact energy's gradient is set to zero, as the paper does
/// (end of Section 3.2).
const EXACT_SINE: f64 = 1e-6;
/// The smoothed gradient is regular at β = 0 but not at β = π, a maximum where no
/// direction is preferred; a smaller threshold suffices there.
const SMOOTH_SINE: f64 = 1e-12;

impl Smoothing {
    /// φ = β.
    pub const EXACT: Self = Self { epsilon: 0.0 };

    /// √(β² + ε²).
    fn root(self, beta: f64) -> f64 {
        (beta * beta + self.epsilon * self.epsilon).sqrt()
    }

    /// φ(β).
    pub fn value(self, beta: f64) -> f64 {
        // The product form loses no digits for β ≪ ε.
        if self.epsilon == 0.0 {
            beta
        } else {
            beta * beta / (self.root(beta) + self.epsilon)
        }
    }

    /// −dφ/d(cos β) = φ′(β)/sin β, or `None` where the gradient is undefined.
    pub fn slope(self, angle: Angle) -> Option<f64> {
        let undefined = if self.epsilon == 0.0 {
            angle.sin < EXACT_SINE
        } else {
            angle.sin < SMOOTH_SINE && angle.cos < 0.0
        };
        if undefined || !angle.beta.is_finite() {
            return None;
        }
        Some(beta_over_sine(angle) / self.root(angle.beta))
    }

    /// d²φ/d(cos β)², finite at β = 0 when ε > 0. Meaningful where [`slope`](Self::slope)
    /// is defined.
    pub fn curvature(self, angle: Angle) -> f64 {
        // With t = β² and S = β / sin β: slope h = S / √(t + ε²), and
        // d²φ/dc² = −dh/dc = 2 S dh/dt, as dt/dc = −2S.
        let t = angle.beta * angle.beta;
        let s = beta_over_sine(angle);
        let ds = if t < 1e-4 {
            1.0 / 6.0 + 7.0 / 180.0 * t
        } else {
            (angle.sin - angle.beta * angle.cos) / (2.0 * angle.beta * angle.sin * angle.sin)
        };
        let root = self.root(angle.beta);
        2.0 * s * (ds / root - 0.5 * s / (root * root * root))
    }
}

fn beta_over_sine(angle: Angle) -> f64 {
    if angle.beta < 1e-4 {
        1.0 + angle.beta * angle.beta / 6.0
    } else {
        angle.beta / angle.sin
    }
}

/// Derivatives of cos β with respect to (ln P, ln Q, ln R).
pub fn cosine_slopes(p_sq: f64, q_sq: f64, r_sq: f64) -> [f64; 3] {
    let inverse = (p_sq * q_sq).sqrt().recip();
    let (skew, rho) = (0.25 * (q_sq - p_sq) * inverse, r_sq * inverse);
    [skew - 0.25 * rho, -skew - 0.25 * rho, 0.5 * rho]
}

/// Second derivatives of cos β with respect to (ln P, ln Q, ln R), symmetric.
pub fn cosine_curvatures(p_sq: f64, q_sq: f64, r_sq: f64) -> [[f64; 3]; 3] {
    let (x, rho) = ((p_sq / q_sq).sqrt(), r_sq / (p_sq * q_sq).sqrt());
    let sum = 0.125 * (x + 1.0 / x);
    let (same, mixed) = (0.125 * rho - sum, 0.125 * rho + sum);
    let cross = -0.25 * rho;
    [
        [same, mixed, cross],
        [mixed, same, cross],
        [cross, cross, 0.5 * rho],
    ]
}

/// Index pairs of a diamond's six distances in the vertex order `k, j, l, i`, and
/// which of P, Q, R each enters: `kj, li | jl, ik | ij, kl`.
pub const DIAMOND_PAIRS: [(usize, usize); 6] = [(0, 1), (2, 3), (1, 2), (3, 0), (3, 1), (0, 2)];

/// Index pairs of a corner's three distances in the order `p, v, n`: `pv | vn | pn`.
pub const CORNER_PAIRS: [(usize, usize); 3] = [(0, 1), (1, 2), (0, 2)];

/// Edge weights of dφ(β): with weights ω over [`DIAMOND_PAIRS`], the gradient at
/// vertex p is Σ_q ω_pq (x_p − x_q). Unit 1/length². `None` where undefined.
///
/// ω_pq = 2 ∂φ/∂|pq|², the same six numbers as in Eq. (1) of the paper.
pub fn diamond_weights(x: [DVec3; 4], angle: Angle, smoothing: Smoothing) -> Option<[f64; 6]> {
    let slope = smoothing.slope(angle)?;
    let d = DIAMOND_PAIRS.map(|(p, q)| x[p].distance_squared(x[q]));
    let products = [d[0] * d[1], d[2] * d[3], d[4] * d[5]];
    let c = cosine_slopes(products[0], products[1], products[2]);
    // c / d[0] = c d[1] / (d[0] d[1]): one division for two.
    let f = [0, 1, 2].map(|r| -2.0 * slope * c[r] / products[r]);
    Some([
        f[0] * d[1],
        f[0] * d[0],
        f[1] * d[3],
        f[1] * d[2],
        f[2] * d[5],
        f[2] * d[4],
    ])
}

/// The same for a corner, over [`CORNER_PAIRS`].
pub fn corner_weights(x: [DVec3; 3], angle: Angle, smoothing: Smoothing) -> Option<[f64; 3]> {
    let slope = smoothing.slope(angle)?;
    let d = CORNER_PAIRS.map(|(p, q)| x[p].distance_squared(x[q]));
    let c = cosine_slopes(d[0], d[1], d[2]);
    Some([0, 1, 2].map(|r| -2.0 * slope * c[r] / d[r]))
}

#[cfg(test)]
mod tests {
    use super::*;

    const X: [DVec3; 4] = [
        DVec3::new(0.1, 1.2, -0.3),
        DVec3::new(1.3, 0.2, 0.4),
        DVec3::new(0.2, -0.9, 0.2),
        DVec3::new(-0.8, 0.1, -0.1),
    ];

    fn beta(x: [DVec3; 4]) -> f64 {
        diamond_angle(x[0], x[1], x[2], x[3]).beta
    }

    #[test]
    fn the_law_of_cosines_agrees_with_the_cross_ratio() {
        let d = DIAMOND_PAIRS.map(|(p, q)| X[p].distance_squared(X[q]));
        let (p, q, r) = (d[0] * d[1], d[2] * d[3], d[4] * d[5]);
        let cos = (r - p - q) / (2.0 * (p * q).sqrt());
        assert!((cos - beta(X).cos()).abs() < 1e-15);
    }

    #[test]
    fn cyclic_shifts_and_reversal_change_nothing() {
        let [k, j, l, i] = X;
        for y in [[j, l, i, k], [l, i, k, j], [i, k, j, l], [i, l, j, k]] {
            assert!((beta(y) - beta(X)).abs() < 1e-15);
        }
    }

    #[test]
    fn gradient_size_does_not_depend_on_beta() {
        let w = diamond_weights(X, diamond_angle(X[0], X[1], X[2], X[3]), Smoothing::EXACT)
            .expect("regular");
        let mut g = [DVec3::ZERO; 4];
        for (w, (p, q)) in w.iter().zip(DIAMOND_PAIRS) {
            g[p] += *w * (X[p] - X[q]);
            g[q] += *w * (X[q] - X[p]);
        }
        // |∂β/∂v_k| = |ij| / (|ki| |kj|), and cyclically.
        for v in 0..4 {
            let (next, across, last) = (X[(v + 1) % 4], X[(v + 2) % 4], X[(v + 3) % 4]);
            let expected = next.distance(last) / (X[v].distance(next) * X[v].distance(last));
            assert!(
                (g[v].length() / expected - 1.0).abs() < 1e-13,
                "{v} {across}"
            );
        }
    }

    #[test]
    fn smoothed_slope_and_curvature_match_differences() {
        for epsilon in [0.1, 0.01] {
            let phi = Smoothing { epsilon };
            for beta in [1e-6, 3e-3, 0.02, 0.4, 1.5, 2.9] {
                let at = |b: f64| Angle {
                    beta: b,
                    sin: b.sin(),
                    cos: b.cos(),
                };
                let h = 1e-6 * f64::max(beta, 1e-3);
                let slope = (phi.value(beta + h) - phi.value(beta - h)) / (2.0 * h) / beta.sin();
                let found = phi.slope(at(beta)).expect("regular");
                assert!((found / slope - 1.0).abs() < 1e-6, "ε {epsilon} β {beta}");
                if beta > 1e-4 {
                    let [l, r] = [beta - h, beta + h].map(|b| phi.slope(at(b)).expect("regular"));
                    let curvature = (r - l) / (2.0 * h) / beta.sin();
                    let found = phi.curvature(at(beta));
                    assert!((found - curvature).abs() < 2e-5 * curvature.abs().max(1.0));
                }
            }
        }
    }

    #[test]
    fn second_derivatives_of_the_cosine_match_differences() {
        let cos = |l: [f64; 3]| {
            let [p, q, r] = l.map(f64::exp);
            (r - p - q) / (2.0 * (p * q).sqrt())
        };
        let at = [0.3, -0.2, 0.9];
        let shifted = |m: usize, h: f64| {
            let mut l = at;
            l[m] += h;
            l
        };
        let slopes = |l: [f64; 3]| cosine_slopes(l[0].exp(), l[1].exp(), l[2].exp());
        let h = 1e-5;
        for m in 0..3 {
            let d = (cos(shifted(m, h)) - cos(shifted(m, -h))) / (2.0 * h);
            assert!((slopes(at)[m] - d).abs() < 1e-9);
            let (r, l) = (slopes(shifted(m, h)), slopes(shifted(m, -h)));
            for n in 0..3 {
                let dd = (r[n] - l[n]) / (2.0 * h);
                let found = cosine_curvatures(at[0].exp(), at[1].exp(), at[2].exp())[m][n];
                assert!((found - dd).abs() < 1e-9, "{m} {n}");
            }
        }
    }
}
