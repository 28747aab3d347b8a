//! Small networks of springs: the positive semi-definite matrix nearest to one.
//!
//! A thousand of these are projected for every millisecond a step may take, and few of
//! their eigenvalues are negative. So each matrix is made tridiagonal, where a polynomial
//! tells whether a negative eigenvalue is left and finds it; QL sweeps shifted by it split
//! it off, and their rotations are applied to its eigenvector only.
//!
//! With the eigenvectors by faer instead, an assembly of all stars takes 3.3 to 3.9 times as
//! long natively and 3.1 to 3.4 times in wasm, on 2,600 to 41,000 stars of valence 6 that are
//! all projected (least times on one core of a virtual AMD EPYC server;
//! `tests/benches/linalg/stars.rs` measures both).

/// A symmetric matrix with zero row sums, Σ w (e_p − e_q)(e_p − e_q)ᵀ over the pairs
/// p < q of a few points; its springs w may be negative.
#[derive(Clone, Debug)]
pub struct SpringMatrix {
    n: usize,
    /// One spring a pair, in the order of [`pair`](Self::pair).
    springs: [f64; 256],
    /// The matrix on vectors of zero sum, then the reflections that made it tridiagonal.
    a: [[f64; MAX]; MAX],
    /// Squared length of each reflection's vector, halved; 0 for none.
    h: [f64; MAX],
    diagonal: [f64; MAX],
    /// Entry i couples i − 1 and i.
    off_diagonal: [f64; MAX],
    /// Rotations of the QL sweeps in the planes (i, i + 1): i, cosine, sine.
    rotations: Vec<(usize, f64, f64)>,
}

/// Dimension of the vectors of zero sum, at most.
const MAX: usize = SpringMatrix::MAX_SIZE - 1;

/// Eigenvalues above −`ROUNDOFF` · (trace of the matrix with springs |w|) count as zero:
/// the star of a point on a sphere has four of them.
const ROUNDOFF: f64 = 1e-11;

/// Off-diagonal entries below this, relative to the same trace, are zero.
const NEGLIGIBLE: f64 = 0.5 * f64::EPSILON;

/// The search for an eigenvalue ends with a relative step below this: it converges
/// cubically, and the sweeps do the rest.
const ENOUGH: f64 = 1e-3;
/// Steps of the search, at most.
const MAX_SEARCH: usize = 8;

/// QL needs one or two sweeps an eigenvalue; this many mean NaN.
const MAX_SWEEPS: usize = 60;

impl Default for SpringMatrix {
    fn default() -> Self {
        Self {
            n: 0,
            springs: [0.0; 256],
            a: [[0.0; MAX]; MAX],
            h: [0.0; MAX],
            diagonal: [0.0; MAX],
            off_diagonal: [0.0; MAX],
            rotations: Vec::new(),
        }
    }
}

impl SpringMatrix {
    /// Most points a matrix can have: the pairs are numbered by bytes.
    pub const MAX_SIZE: usize = 23;

    /// Becomes the zero matrix on `n` ≤ [`MAX_SIZE`](Self::MAX_SIZE) points.
    pub fn reset(&mut self, n: usize) {
        self.n = n.min(Self::MAX_SIZE);
        self.springs[..self.n * self.n.saturating_sub(1) / 2].fill(0.0);
    }

    /// Position of the pair of p and q: (1, 0), (2, 0), (2, 1), (3, 0), …
    ///
    /// No spring acts between a point and itself: that is a position past all others.
    pub fn pair(p: usize, q: usize) -> u8 {
        if p == q {
            return u8::MAX;
        }
        let (p, q) = (p.max(q), p.min(q));
        (p * (p - 1) / 2 + q) as u8
    }

    /// Adds w (e_p − e_q)(e_p − e_q)ᵀ for the points of a pair.
    pub fn add(&mut self, pair: u8, w: f64) {
        self.springs[usize::from(pair)] += w;
    }

    /// The springs in the order of the pairs.
    pub fn springs(&self) -> &[f64] {
        &self.springs[..self.n * self.n.saturating_sub(1) / 2]
    }

    /// The same, to be changed.
    pub fn springs_mut(&mut self) -> &mut [f64] {
        &mut self.springs[..self.n * self.n.saturating_sub(1) / 2]
    }

    /// Replaces negative eigenvalues by zero; answers whether there were any.
    ///
    /// The result is the nearest positive semi-definite matrix in the Frobenius norm.
    /// O(n³).
    pub fn project_semidefinite(&mut self) -> bool {
        let scale = 2.0 * self.springs().iter().map(|w| w.abs()).sum::<f64>();
        if !(scale > 0.0 && scale.is_finite()) {
            return false;
        }
        self.reduce(1.0 / scale);
        self.tridiagonalise();
        self.rotations.clear();
        let m = self.n - 1;
        let mut projected = false;
        let (mut low, mut sweeps) = (0, 0);
        while low < m {
            let high = (low + 1..m)
                .find(|&i| self.off_diagonal[i].abs() <= NEGLIGIBLE)
                .unwrap_or(m);
            if high == low + 1 {
                if self.diagonal[low] < -ROUNDOFF {
                    self.lift(low, -scale * self.diagonal[low]);
                    projected = true;
                }
                (low, sweeps) = (high, 0);
                continue;
            }
            let shift = if sweeps == 0 {
                let (d, e) = (&self.diagonal[low..high], &self.off_diagonal[low..high]);
                match negative_eigenvalue(d, e) {
                    Some(eigenvalue) => eigenvalue,
                    None => {
                        low = high;
                        continue;
                    }
                }
            } else {
                self.wilkinson_shift(low)
            };
            self.sweep(low, high, shift);
            sweeps += 1;
            if sweeps > MAX_SWEEPS {
                return projected;
            }
        }
        projected
    }

    /// The matrix, times `factor`, in the orthonormal basis q_j = e_j − (e_0 + 1/√n)/(√n + 1)
    /// of the vectors of zero sum: one dimension less.
    fn reduce(&mut self, factor: f64) {
        let m = (self.n - 1).min(MAX);
        let s = 1.0 / ((self.n as f64).sqrt() + 1.0);
        let mut centre = [0.0; MAX];
        let mut diagonal = [0.0; MAX];
        let mut total = 0.0;
        let mut springs = &self.springs[..];
        for p in 0..m {
            let (row, rest) = springs.split_at(p + 1);
            springs = rest;
            let w = factor * row[0];
            (centre[p], total) = (s * w, total + w);
            let mut sum = w;
            for (q, w) in row[1..].iter().enumerate() {
                let w = factor * w;
                self.a[p][q] = -w;
                sum += w;
                diagonal[q] += w;
            }
            diagonal[p] = sum;
        }
        total *= s * s;
        for p in 0..m {
            let own = centre[p] + total;
            for (entry, other) in self.a[p][..p].iter_mut().zip(&centre) {
                *entry += own + other;
            }
            self.a[p][p] = diagonal[p] + own + centre[p];
        }
    }

    /// Householder reduction of the lower triangle to tridiagonal form; the vectors of the
    /// reflections stay in its rows.
    fn tridiagonalise(&mut self) {
        let m = (self.n - 1).min(MAX);
        let (a, d, e) = (&mut self.a, &mut self.diagonal, &mut self.off_diagonal);
        // Reflect row i into its sub-diagonal entry, from the last row up.
        for i in (1..m).rev() {
            let mut u = a[i];
            d[i] = u[i];
            let f = u[i - 1];
            let rest: f64 = u[..i - 1].iter().map(|x| x * x).sum();
            if rest <= NEGLIGIBLE * NEGLIGIBLE {
                (e[i], self.h[i]) = (f, 0.0);
                continue;
            }
            let norm_sq = rest + f * f;
            let g = -norm_sq.sqrt().copysign(f);
            let h = norm_sq - f * g;
            (e[i], self.h[i]) = (g, h);
            u[i - 1] = f - g;
            a[i] = u;
            // A ← A − u qᵀ − q uᵀ with p = A u / h, q = p − (uᵀp / 2h) u.
            let inverse = 1.0 / h;
            let mut q = [0.0; MAX];
            for j in 0..i {
                let row = &a[j];
                let mut sum = row[j] * u[j];
                for k in 0..j {
                    sum += row[k] * u[k];
                    q[k] += row[k] * u[j];
                }
                q[j] = sum;
            }
            let mut up = 0.0;
            for j in 0..i {
                q[j] *= inverse;
                up += q[j] * u[j];
            }
            let half = 0.5 * up * inverse;
            for j in 0..i {
                q[j] -= half * u[j];
                for k in 0..=j {
                    a[j][k] -= u[j] * q[k] + q[j] * u[k];
                }
            }
        }
        d[0] = a[0][0];
        e[0] = 0.0;
    }

    /// The eigenvalue of the leading 2×2 block at `low` that is nearer to its first entry.
    fn wilkinson_shift(&self, low: usize) -> f64 {
        let (d, e) = (&self.diagonal, self.off_diagonal[low + 1]);
        let g = (d[low + 1] - d[low]) / (2.0 * e);
        d[low] - e / (g + (g * g + 1.0).sqrt().copysign(g))
    }

    /// An implicit QL sweep over the rows `low..high`.
    fn sweep(&mut self, low: usize, high: usize, shift: f64) {
        let (d, e) = (&mut self.diagonal, &mut self.off_diagonal);
        let last = high - 1;
        let mut g = d[last] - shift;
        let (mut s, mut c, mut p) = (1.0, 1.0, 0.0);
        for i in (low..last).rev() {
            let (f, b) = (s * e[i + 1], c * e[i + 1]);
            let r = (f * f + g * g).sqrt();
            if i + 2 < high {
                e[i + 2] = r;
            }
            if r == 0.0 {
                // The matrix splits here.
                d[i + 1] -= p;
                return;
            }
            (s, c) = (f / r, g / r);
            g = d[i + 1] - p;
            let r = (d[i] - g) * s + 2.0 * c * b;
            p = s * r;
            d[i + 1] = g + p;
            g = c * r - b;
            self.rotations.push((i, c, s));
        }
        d[low] -= p;
        e[low + 1] = g;
    }

    /// Adds `by` to the eigenvalue that stands at `k` of the diagonal.
    fn lift(&mut self, k: usize, by: f64) {
        let m = (self.n - 1).min(MAX);
        let mut y = [0.0; MAX];
        y[k] = 1.0;
        for &(i, c, s) in self.rotations.iter().rev() {
            (y[i], y[i + 1]) = (c * y[i] + s * y[i + 1], c * y[i + 1] - s * y[i]);
        }
        for i in (2..m).filter(|&i| self.h[i] > 0.0) {
            let u = &self.a[i][..i];
            let uy: f64 = u.iter().zip(&y).map(|(u, y)| u * y).sum();
            let by = uy / self.h[i];
            y.iter_mut().zip(u).for_each(|(y, u)| *y -= by * u);
        }
        let (n, sum) = (self.n as f64, y[..m].iter().sum::<f64>());
        let root = n.sqrt();
        let (centre, shift) = (-sum / root, -sum / (n + root));
        let mut springs = &mut self.springs[..];
        for p in 0..m {
            let (row, rest) = springs.split_at_mut(p + 1);
            springs = rest;
            y[p] += shift;
            let scaled = by * y[p];
            row[0] -= scaled * centre;
            row[1..]
                .iter_mut()
                .zip(&y)
                .for_each(|(w, y)| *w -= scaled * y);
        }
    }
}

/// The negative eigenvalue next to zero of a symmetric tridiagonal matrix, approximately;
/// `None` if there is none. `e[0]` is not used; entries are at most about 1.
///
/// Laguerre's method on det(T − σ): with real roots only, it goes monotonically from zero
/// to the next one on the left.
fn negative_eigenvalue(d: &[f64], e: &[f64]) -> Option<f64> {
    let degree = d.len() as f64;
    let mut sigma = -ROUNDOFF;
    let mut all = None;
    for _ in 0..MAX_SEARCH {
        // det(T − σ) of the leading blocks, the one before, and their derivatives.
        let (mut f, mut f1, mut f2) = (1.0, 0.0, 0.0);
        let (mut g, mut g1, mut g2) = (0.0, 0.0, 0.0);
        // The sign of the last determinant that was not zero: each change is an eigenvalue.
        let (mut sign, mut changes) = (1.0, 0);
        for (d, e) in d.iter().zip(e) {
            let (x, ee) = (d - sigma, e * e);
            let next = x * f - ee * g;
            let next1 = x * f1 - f - ee * g1;
            let next2 = x * f2 - 2.0 * f1 - ee * g2;
            (g, g1, g2) = (f, f1, f2);
            (f, f1, f2) = (next, next1, next2);
            if f * sign < 0.0 {
                (sign, changes) = (-sign, changes + 1);
            }
        }
        // Rounding may have led past the eigenvalue.
        if *all.get_or_insert(changes) > changes {
            break;
        }
        if changes == 0 {
            return None;
        }
        let discriminant = (degree - 1.0) * ((degree - 1.0) * f1 * f1 - degree * f * f2);
        let step = degree * f / (f1 + discriminant.max(0.0).sqrt().copysign(f));
        sigma -= step;
        if step <= ENOUGH * sigma.abs() {
            break;
        }
    }
    Some(sigma)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A reproducible matrix of springs of both signs.
    fn springs(n: usize, seed: u64, offset: f64) -> SpringMatrix {
        let mut state = seed;
        let mut m = SpringMatrix::default();
        m.reset(n);
        for w in m.springs_mut() {
            state = state
                .wrapping_mul(6364136223846793005)
                .wrapping_add(1442695040888963407);
            *w = (state >> 33) as f64 / (1u64 << 31) as f64 - offset;
        }
        m
    }

    /// The matrix itself.
    fn dense(m: &SpringMatrix) -> Vec<Vec<f64>> {
        let mut a = vec![vec![0.0; m.n]; m.n];
        for p in 0..m.n {
            for q in 0..p {
                let w = m.springs()[usize::from(SpringMatrix::pair(p, q))];
                a[p][q] -= w;
                a[q][p] -= w;
                a[p][p] += w;
                a[q][q] += w;
            }
        }
        a
    }

    fn inner(a: &SpringMatrix, b: &SpringMatrix) -> f64 {
        let (a, b) = (dense(a), dense(b));
        let pairs = a.iter().flatten().zip(b.iter().flatten());
        pairs.map(|(a, b)| a * b).sum()
    }

    /// By Cholesky without the first row and column, as the row sums are zero; `size`
    /// is that of the entries.
    fn is_semidefinite(m: &SpringMatrix, size: f64) -> bool {
        let mut l = dense(m);
        for j in 1..m.n {
            let sum: f64 = (1..j).map(|k| l[j][k] * l[j][k]).sum();
            let pivot = l[j][j] + 1e-12 * size - sum;
            if pivot.is_nan() || pivot <= 0.0 {
                return false;
            }
            l[j][j] = pivot.sqrt();
            for i in j + 1..m.n {
                let sum: f64 = (1..j).map(|k| l[i][k] * l[j][k]).sum();
                l[i][j] = (l[i][j] - sum) / l[j][j];
            }
        }
        true
    }

    /// The change C = A₊ − A and A₊ are positive semi-definite and orthogonal: that
    /// characterises the projection.
    fn assert_projects(before: &SpringMatrix) -> bool {
        let size = inner(before, before).sqrt();
        let mut after = before.clone();
        let projected = after.project_semidefinite();
        assert_eq!(projected, !is_semidefinite(before, size));
        let mut change = after.clone();
        for (c, a) in change.springs_mut().iter_mut().zip(before.springs()) {
            *c -= a;
        }
        let product = inner(&change, &after);
        assert!(product.abs() < 1e-13 * size * size, "{product}");
        assert!(is_semidefinite(&after, size) && is_semidefinite(&change, size));
        projected
    }

    #[test]
    fn projection_keeps_the_positive_part_and_removes_the_rest() {
        for n in 2..=SpringMatrix::MAX_SIZE {
            for (seed, offset) in (0..40).zip([0.2, 0.35, 0.5, 0.9].into_iter().cycle()) {
                assert_projects(&springs(n, seed + 100 * n as u64, offset));
            }
        }
        // All negative: nothing is left.
        let mut m = springs(9, 1, 1.0);
        assert!(m.project_semidefinite());
        assert!(m.springs().iter().all(|w| w.abs() < 1e-13));
    }

    #[test]
    fn eigenvalues_may_be_multiple_or_tiny() {
        // A ring about a centre has pairs of eigenvalues; units do not matter.
        for (n, unit) in [(4, 1.0), (5, 1e-70), (7, 1e80), (9, 1e3), (23, 1.0)] {
            for ring in [-1.0, -1e-3, -1e-8, -0.4] {
                let mut m = SpringMatrix::default();
                m.reset(n);
                for p in 1..n {
                    m.add(SpringMatrix::pair(p, 0), 1e-9 * unit);
                    m.add(SpringMatrix::pair(p, p % (n - 1) + 1), ring * unit);
                }
                assert!(assert_projects(&m), "{n} {ring}");
            }
        }
    }

    #[test]
    fn a_semidefinite_matrix_is_left_alone() {
        let mut m = SpringMatrix::default();
        m.reset(6);
        assert!(!m.project_semidefinite(), "zero");
        for p in 1..6 {
            m.add(SpringMatrix::pair(0, p), p as f64);
        }
        let before = m.springs().to_vec();
        assert!(!m.project_semidefinite());
        assert_eq!(before, m.springs());
        m.add(0, f64::NAN);
        assert!(!m.project_semidefinite());
    }
}
