//! The full Hessian, for Newton's method.
//!
//! An angle is a function of a few squared distances α_r, so
//!
//! ```math
//! \operatorname{Hess} \varphi = \sum_r \omega_r \, (\text{Laplacian of pair } r) \otimes I
//!   + 4 \sum_{rs} \varphi_{rs} \, e_r e_s^T,
//! ```
//!
//! with ω_r = 2 ∂φ/∂α_r, φ_rs = ∂²φ/∂α_r∂α_s and e_r = x_p − x_q at p, x_q − x_p at
//! q. The first part is K of the paper's Eq. (1), the second is what it leaves out.

use super::CircleEnergy;
use super::angle::{
    Angle, CORNER_PAIRS, DIAMOND_PAIRS, Smoothing, corner_angle, cosine_curvatures, cosine_slopes,
    diamond_angle,
};
use glam::{DMat3, DVec3};

impl CircleEnergy {
    /// Calls `add(p, q, block)` for every 3×3 block, p = q included, each ordered pair
    /// once an angle. Angles whose gradient is undefined contribute nothing.
    pub fn hessian_blocks(
        &self,
        x: &[DVec3],
        smoothing: Smoothing,
        mut add: impl FnMut(u32, u32, DMat3),
    ) {
        for d in self.diamonds().iter().filter(|d| d.count > 0) {
            let y = d.v.map(|v| x[v as usize]);
            let angle = diamond_angle(y[0], y[1], y[2], y[3]);
            angle_blocks(
                &y,
                &DIAMOND_PAIRS,
                angle,
                smoothing,
                f64::from(d.count),
                |p, q, block| {
                    add(d.v[p], d.v[q], block);
                },
            );
        }
        for c in self.corners() {
            let y = c.v.map(|v| x[v as usize]);
            let angle = corner_angle(y[0], y[1], y[2]);
            angle_blocks(&y, &CORNER_PAIRS, angle, smoothing, 2.0, |p, q, block| {
                add(c.v[p], c.v[q], block);
            });
        }
    }
}

/// The blocks of one angle; `pairs` come in three groups of equal size for P, Q, R.
fn angle_blocks(
    y: &[DVec3],
    pairs: &[(usize, usize)],
    angle: Angle,
    smoothing: Smoothing,
    count: f64,
    mut add: impl FnMut(usize, usize, DMat3),
) {
    let Some(slope) = smoothing.slope(angle) else {
        return;
    };
    let n = pairs.len();
    let group = |r: usize| r * 3 / n;
    let mut alpha = [0.0; 6];
    let mut product = [1.0; 3];
    for (r, &(p, q)) in pairs.iter().enumerate() {
        alpha[r] = y[p].distance_squared(y[q]);
        product[group(r)] *= alpha[r];
    }
    let [p_sq, q_sq, r_sq] = product;
    let c = cosine_slopes(p_sq, q_sq, r_sq);
    let cc = cosine_curvatures(p_sq, q_sq, r_sq);
    let (f1, f2) = (-count * slope, count * smoothing.curvature(angle));

    let mut block = [[DMat3::ZERO; 4]; 4];
    let mut scatter = |(p, q): (usize, usize), (s, t): (usize, usize), m: DMat3| {
        block[p][s] += m;
        block[q][t] += m;
        block[p][t] -= m;
        block[q][s] -= m;
    };
    for (r, &(p, q)) in pairs.iter().enumerate() {
        let (g, along) = (group(r), y[p] - y[q]);
        scatter(
            (p, q),
            (p, q),
            DMat3::from_diagonal(DVec3::splat(2.0 * f1 * c[g] / alpha[r])),
        );
        for (s, &(u, v)) in pairs.iter().enumerate() {
            let h = group(s);
            let mut second = (f1 * cc[g][h] + f2 * c[g] * c[h]) / (alpha[r] * alpha[s]);
            if r == s {
                second -= f1 * c[g] / (alpha[r] * alpha[r]);
            }
            scatter((p, q), (u, v), 4.0 * second * outer(along, y[u] - y[v]));
        }
    }
    for (p, row) in block.iter().enumerate().take(y.len()) {
        for (q, m) in row.iter().enumerate().take(y.len()) {
            add(p, q, *m);
        }
    }
}

/// a bᵀ.
fn outer(a: DVec3, b: DVec3) -> DMat3 {
    DMat3::from_cols(a * b.x, a * b.y, a * b.z)
}
