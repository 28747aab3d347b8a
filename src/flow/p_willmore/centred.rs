//! The paper's own step, Problem 5.1: centred in time, nonlinear, by Newton's method.
//!
//! Geometry is that of x̄ = (x + x′)/2. With vertex lumping the curvature Ȳ = −M⁻¹L x′ and
//! its weighted W̄ = |Ȳ|^(p−2) Ȳ are functions of x′, and W′ = 2W̄ − W: of the paper's nine
//! unknowns a vertex three remain. The Jacobian is exact, applied by forward
//! differentiation; its systems are solved by GMRES, preconditioned by the scalar matrix of
//! the semi-implicit step.

use super::system::PWillmoreSystem;
use crate::energy::p_willmore::Evaluation;
use crate::flow::FlowError;
use crate::flow::constraint::{Constraint, multipliers};
use crate::linalg::{Ldlt, gmres};
use crate::operator::element::DualNode;
use crate::operator::{Dual, DualVec, Elements};
use glam::DVec3;

/// Newton's iterations, at most …
const MAX_NEWTON: usize = 12;
/// … until the residual has fallen to this share of the first: two iterations, as in the
/// paper, do not reach it near the largest stable step.
const CONVERGED: f64 = 1e-8;
/// Products with the Jacobian a linear system may take, and the residual asked of it.
const MAX_KRYLOV: usize = 120;
/// A residual so many times the first is on its way to nowhere.
const DIVERGED: f64 = 10.0;
const KRYLOV_TOLERANCE: f64 = 1e-6;
/// Relative violation of a constraint that counts as none.
const SATISFIED: f64 = 1e-12;

/// A step from x with size τ.
pub(super) struct CentredStep<'a> {
    pub(super) elements: &'a Elements,
    pub(super) p: f64,
    /// δ² of the rounded |Y|.
    pub(super) rounding: f64,
    pub(super) x: &'a [DVec3],
    /// W at x.
    pub(super) weighted: Vec<DVec3>,
    pub(super) tau: f64,
}

/// Where Newton's method came to.
pub(super) struct Centred {
    pub(super) x: Vec<DVec3>,
    /// λ of ∇W^p + Σ λ ∇C = 0.
    pub(super) multipliers: Vec<f64>,
    pub(super) newton: usize,
}

/// The residual of Problem 5.1 with its derivative, and the constraints' gradients at x̄.
#[derive(Default)]
struct Residual {
    values: Vec<DualVec>,
    mass: Vec<Dual>,
    /// L x′.
    laplacian: Vec<DualVec>,
    area: Vec<DualVec>,
    volume: Vec<DualVec>,
}

impl CentredStep<'_> {
    /// Newton's method; `None` if it does not converge. `constraints` tells area and volume
    /// in force, with gradients, at a state.
    pub(super) fn solve(
        &self,
        system: &mut PWillmoreSystem,
        at_x: &Evaluation,
        kept: [bool; 2],
        mut constraints: impl FnMut(&[DVec3], &mut dyn FnMut(&[Constraint<'_>])),
    ) -> Result<Option<Centred>, FlowError> {
        // W′ = 2W̄ − W doubles the stiffness.
        let mut factor =
            system.factor(&at_x.mass, self.tau, if self.p == 0.0 { 1.0 } else { 2.0 })?;
        let n = self.x.len();
        let mut y = self.x.to_vec();
        let mut lambda = vec![0.0; kept.iter().filter(|k| **k).count()];
        let mut residual = Residual::default();
        let mut first = 0.0;
        for newton in 0..=MAX_NEWTON {
            self.residual(&y, None, kept, &lambda, &mut residual);
            let size = residual
                .values
                .iter()
                .map(|r| r.re.length_squared())
                .sum::<f64>()
                .sqrt();
            let mut violation = 0.0f64;
            constraints(&y, &mut |all| {
                violation = all
                    .iter()
                    .map(|c| (c.value / c.target - 1.0).abs())
                    .fold(0.0, f64::max);
            });
            if newton == 0 {
                first = size;
            }
            let is_lost = newton > 0 && size > DIVERGED * first;
            if !size.is_finite() || is_lost || newton == MAX_NEWTON {
                return Ok(None);
            }
            if newton > 0 && size <= CONVERGED * first && violation <= SATISFIED {
                return Ok(Some(Centred {
                    x: y,
                    multipliers: lambda,
                    newton,
                }));
            }
            // J δ = −R, and a column for each constraint.
            let mut columns = vec![
                residual
                    .values
                    .iter()
                    .map(|r| -r.re)
                    .collect::<Vec<DVec3>>(),
            ];
            for (is_kept, gradient) in kept.iter().zip([&residual.area, &residual.volume]) {
                if *is_kept {
                    columns.push(gradient.iter().map(|b| -b.re).collect());
                }
            }
            let mut solutions = Vec::with_capacity(columns.len() * n);
            for column in columns {
                solutions.extend(self.linear(&y, kept, &lambda, &mut factor, &column));
            }
            let (d, directions) = solutions.split_at(n);
            let mut change = Vec::new();
            constraints(&y, &mut |all| change = multipliers(all, d, directions));
            for (i, y) in y.iter_mut().enumerate() {
                *y += d[i];
                for (c, u) in change.iter().zip(directions.chunks_exact(n)) {
                    *y += *c * u[i];
                }
            }
            lambda.iter_mut().zip(&change).for_each(|(l, c)| *l += c);
        }
        Ok(None)
    }

    /// Solves J z = b at y.
    fn linear(
        &self,
        y: &[DVec3],
        kept: [bool; 2],
        lambda: &[f64],
        factor: &mut Ldlt,
        b: &[DVec3],
    ) -> Vec<DVec3> {
        let flat = |v: &[DVec3]| v.iter().flat_map(|p| p.to_array()).collect::<Vec<f64>>();
        let fields = |v: &[f64]| v.chunks_exact(3).map(DVec3::from_slice).collect::<Vec<_>>();
        let mut residual = Residual::default();
        let apply = |v: &[f64], w: &mut [f64]| {
            self.residual(y, Some(&fields(v)), kept, lambda, &mut residual);
            for (w, r) in w.chunks_exact_mut(3).zip(&residual.values) {
                w.copy_from_slice(&r.du.to_array());
            }
        };
        let precondition = |v: &mut [f64]| {
            let mut field = fields(v);
            factor.solve_in_place(&mut field);
            v.copy_from_slice(&flat(&field));
        };
        // A solution that falls short makes Newton's method slower, or fail and say so.
        let (z, _) = gmres(apply, precondition, &flat(b), KRYLOV_TOLERANCE, MAX_KRYLOV);
        fields(&z)
    }

    /// The residual at x′ = `y`, and its derivative along `d`.
    fn residual(
        &self,
        y: &[DVec3],
        d: Option<&[DVec3]>,
        kept: [bool; 2],
        lambda: &[f64],
        out: &mut Residual,
    ) {
        let n = y.len();
        let moving = |i: usize| DualVec {
            re: y[i],
            du: d.map_or(DVec3::ZERO, |d| d[i]),
        };
        let middle = |i: usize| (moving(i) + DualVec::constant(self.x[i])) * 0.5;
        for field in [
            &mut out.values,
            &mut out.laplacian,
            &mut out.area,
            &mut out.volume,
        ] {
            field.clear();
            field.resize(n, DualVec::default());
        }
        out.mass.clear();
        out.mass.resize(n, Dual::default());
        self.each_node(middle, |corners, shape, node| {
            for (i, &v) in corners.iter().enumerate() {
                let (v, g) = (v as usize, node.gradients[i]);
                out.mass[v] = out.mass[v] + node.area * shape[i];
                out.area[v] = out.area[v] + g * node.area;
                out.volume[v] = out.volume[v] + node.normal * (node.area * shape[i]);
                let mut flux = DualVec::default();
                for (j, &u) in corners.iter().enumerate() {
                    flux = flux + moving(u as usize) * g.dot(node.gradients[j]);
                }
                out.laplacian[v] = out.laplacian[v] + flux * node.area;
            }
        });
        for i in 0..n {
            let moved = moving(i) - DualVec::constant(self.x[i]);
            out.values[i] = moved * (out.mass[i] * (1.0 / self.tau));
        }
        let forces = kept.iter().zip([&out.area, &out.volume]);
        let forces = forces.filter(|(kept, _)| **kept).map(|(_, f)| f);
        for (lambda, force) in lambda.iter().zip(forces) {
            for (r, f) in out.values.iter_mut().zip(force) {
                *r = *r + *f * *lambda;
            }
        }
        if self.p == 0.0 {
            for (r, l) in out.values.iter_mut().zip(&out.laplacian) {
                *r = *r + *l;
            }
        } else {
            self.add_bending(middle, out);
        }
    }

    /// ∫ (|Ȳ|^p − p Ȳ·W̄ − p div W̄) div φ + p (⟨D(φ)du, dW⟩ − ⟨dφ, dW′⟩) over the hat
    /// functions, du and dW those of the old state on the geometry of x̄.
    fn add_bending(&self, middle: impl Fn(usize) -> DualVec, out: &mut Residual) {
        let p = self.p;
        let bent: Vec<(Dual, DualVec)> = out
            .laplacian
            .iter()
            .zip(&out.mass)
            .map(|(l, m)| {
                let y = -(*l * m.recip());
                let square = y.dot(y) + Dual::constant(self.rounding);
                let w = y * square.powf(0.5 * p - 1.0);
                (square.powf(0.5 * p) + y.dot(w) * -p, w)
            })
            .collect();
        let (old, weighted, values) = (self.x, &self.weighted, &mut out.values);
        self.each_node(middle, |corners, shape, node| {
            let g = &node.gradients;
            let (mut a, mut divergence) = (Dual::default(), Dual::default());
            for (k, &v) in corners.iter().enumerate() {
                let (power, w) = bent[v as usize];
                a = a + power * shape[k];
                divergence = divergence + g[k].dot(w);
            }
            let spread = a + divergence * -p;
            for (i, &v) in corners.iter().enumerate() {
                let (mut along, mut turned) = (DualVec::default(), DualVec::default());
                let mut flux = DualVec::default();
                for (j, &u) in corners.iter().enumerate() {
                    let (u, weight) = (u as usize, g[i].dot(g[j]));
                    along = along + DualVec::constant(old[u]) * weight;
                    turned = turned + DualVec::constant(weighted[u]) * weight;
                    let next = bent[u].1 * 2.0 - DualVec::constant(weighted[u]);
                    flux = flux + next * weight;
                }
                let mut sum = g[i] * spread - flux * p;
                for (j, &u) in corners.iter().enumerate() {
                    let u = u as usize;
                    let contracted = DualVec::constant(weighted[u]).dot(along)
                        + DualVec::constant(old[u]).dot(turned);
                    sum = sum + g[j] * (contracted * p);
                }
                values[v as usize] = values[v as usize] + sum * node.area;
            }
        });
    }

    fn each_node(
        &self,
        at: impl Fn(usize) -> DualVec,
        mut visit: impl FnMut(&[u32], &[f64; 4], &DualNode),
    ) {
        for corners in self.elements.corners() {
            let mut x = [DualVec::default(); 4];
            for (x, &v) in x.iter_mut().zip(corners) {
                *x = at(v as usize);
            }
            for point in self.elements.points() {
                let node = DualNode::new(&x[..corners.len()], point);
                visit(corners, &point.shape, &node);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::energy::p_willmore::{Helfrich, PWillmore};
    use crate::mesh::{build, shape};
    use crate::operator::Mass;
    use std::rc::Rc;

    /// As x′ → x the residual less its inertia is the exact gradient; and the derivative is
    /// that of differences.
    #[test]
    fn the_residual_is_consistent_and_its_derivative_exact() {
        let sample = shape::make("ellipsoid", &[("level".into(), 2.0)]).expect("a shape");
        let built = build(&sample.soup).expect("a surface");
        let (mesh, x) = (Rc::new(built.mesh), built.positions);
        for p in [0.0, 1.0, 2.0, 3.0, 4.0] {
            let functional =
                PWillmore::new(Rc::clone(&mesh), &x, p, Helfrich::default(), Mass::Lumped)
                    .expect("triangles");
            let mut at = Evaluation::default();
            functional.evaluate(&x, &mut at);
            let step = CentredStep {
                elements: functional.elements(),
                p,
                rounding: functional.rounding(),
                x: &x,
                weighted: functional.weighted(&at),
                tau: 1e-3,
            };
            let kept = [true, true];
            let mut residual = Residual::default();
            step.residual(&x, None, kept, &[0.0, 0.0], &mut residual);
            let size = at.gradient.iter().map(|g| g.length()).fold(0.0, f64::max);
            for (r, g) in residual.values.iter().zip(&at.gradient) {
                assert!((r.re - *g).length() < 1e-11 * size, "p = {p}");
            }
            // Inertia is the mass at x̄ times (x′ − x)/τ, and all that τ has a part in.
            let pushed: Vec<DVec3> = x.iter().map(|x| 1.1 * *x).collect();
            let half_way: Vec<DVec3> = x.iter().map(|x| 1.05 * *x).collect();
            let mut there = Evaluation::default();
            functional.measure(&half_way, &mut there);
            let slower = CentredStep {
                tau: 1e-2,
                weighted: step.weighted.clone(),
                ..step
            };
            let [fast, slow] = [&step, &slower].map(|step| {
                let mut residual = Residual::default();
                step.residual(&pushed, None, [false; 2], &[], &mut residual);
                residual.values
            });
            for (i, (fast, slow)) in fast.iter().zip(&slow).enumerate() {
                let inertia = there.mass[i] * (pushed[i] - x[i]) * (1e3 - 1e2);
                let off = (fast.re - slow.re - inertia).length();
                assert!(off < 1e-9 * inertia.length(), "p = {p}: {off}");
            }
            let wave = |i: usize| DVec3::new((i as f64).sin(), (2.3 * i as f64).cos(), 0.4);
            let d: Vec<DVec3> = (0..x.len()).map(wave).collect();
            let y: Vec<DVec3> = x.iter().zip(&d).map(|(x, d)| *x + 0.01 * *d).collect();
            let lambda = [0.7, -0.3];
            step.residual(&y, Some(&d), kept, &lambda, &mut residual);
            let found: Vec<DVec3> = residual.values.iter().map(|r| r.du).collect();
            let mut at_shift = |s: f64| {
                let z: Vec<DVec3> = y.iter().zip(&d).map(|(y, d)| *y + s * *d).collect();
                step.residual(&z, None, kept, &lambda, &mut residual);
                residual.values.iter().map(|r| r.re).collect::<Vec<DVec3>>()
            };
            let s = 1e-6;
            let (plus, minus) = (at_shift(s), at_shift(-s));
            let size = found.iter().map(|f| f.length()).fold(0.0, f64::max);
            for (i, found) in found.iter().enumerate() {
                let expected = (plus[i] - minus[i]) / (2.0 * s);
                let error = (*found - expected).length();
                assert!(
                    error < 2e-7 * size,
                    "p = {p}, vertex {i}: {error} of {size}"
                );
            }
        }
    }
}
