//! Conjugate gradients for three columns with the diagonal or the factor of a nearby matrix: our
//! solver, and faer's block method with the same preconditioners.

use super::flap_matrix::FlapMesh;
use super::timing::{least_of_two, milliseconds};
use faer::dyn_stack::{MemBuffer, MemStack, StackReq};
use faer::matrix_free::conjugate_gradient::{
    CgParams, conjugate_gradient, conjugate_gradient_scratch,
};
use faer::matrix_free::{LinOp, Precond};
use faer::{Mat, MatMut, MatRef, Par};
use glam::DVec3;
use std::fmt;
use std::sync::{Arc, Mutex};
use umbilic::linalg::{Ldlt, Pattern, Preconditioner, Refactor, Solver, Symbolic};

const TOLERANCE: f64 = 1e-8;

/// A symmetric matrix, for faer.
#[derive(Debug)]
struct Matrix<'a> {
    pattern: &'a Pattern,
    values: &'a [f64],
}

impl LinOp<f64> for Matrix<'_> {
    fn apply_scratch(&self, _: usize, _: Par) -> StackReq {
        StackReq::EMPTY
    }

    fn nrows(&self) -> usize {
        self.pattern.n()
    }

    fn ncols(&self) -> usize {
        self.pattern.n()
    }

    fn apply(&self, mut out: MatMut<'_, f64>, x: MatRef<'_, f64>, _: Par, _: &mut MemStack) {
        out.fill(0.0);
        let [x, y, z] = [0, 1, 2].map(|c| x.col(c).try_as_col_major().unwrap().as_slice());
        let (a, rest) = out.split_at_col_mut(1);
        let (b, c) = rest.split_at_col_mut(1);
        let [a, b, c] = [a, b, c].map(|m| {
            let column = m.col_mut(0).try_as_col_major_mut().unwrap();
            column.as_slice_mut()
        });
        for j in 0..self.pattern.n() {
            let range = self.pattern.column(j);
            let (rows, values) = (&self.pattern.rows()[range.clone()], &self.values[range]);
            let own = [x[j], y[j], z[j]];
            let mut sum = own.map(|v| v * values[0]);
            for (&i, v) in rows[1..].iter().zip(&values[1..]) {
                let i = i as usize;
                a[i] += v * own[0];
                b[i] += v * own[1];
                c[i] += v * own[2];
                sum[0] += v * x[i];
                sum[1] += v * y[i];
                sum[2] += v * z[i];
            }
            a[j] += sum[0];
            b[j] += sum[1];
            c[j] += sum[2];
        }
    }

    fn conj_apply(&self, out: MatMut<'_, f64>, x: MatRef<'_, f64>, par: Par, m: &mut MemStack) {
        self.apply(out, x, par, m);
    }
}

/// A preconditioner, for faer.
enum Inverse {
    Diagonal(Vec<f64>),
    /// With the columns it solves for.
    Factor(Box<Mutex<(Ldlt, Vec<f64>)>>, usize),
}

impl fmt::Debug for Inverse {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Inverse")
    }
}

impl LinOp<f64> for Inverse {
    fn apply_scratch(&self, _: usize, _: Par) -> StackReq {
        StackReq::EMPTY
    }

    fn nrows(&self) -> usize {
        match self {
            Self::Diagonal(inverse) => inverse.len(),
            Self::Factor(_, n) => *n,
        }
    }

    fn ncols(&self) -> usize {
        self.nrows()
    }

    fn apply(&self, mut out: MatMut<'_, f64>, x: MatRef<'_, f64>, _: Par, _: &mut MemStack) {
        match self {
            Self::Diagonal(inverse) => {
                for c in 0..3 {
                    let x = x.col(c).try_as_col_major().unwrap().as_slice();
                    let column = out.as_mut().col_mut(c);
                    let y = column.try_as_col_major_mut().unwrap().as_slice_mut();
                    for ((y, x), d) in y.iter_mut().zip(x).zip(inverse) {
                        *y = x * d;
                    }
                }
            }
            Self::Factor(work, n) => {
                let (factor, columns) = &mut *work.lock().unwrap();
                for (c, column) in columns.chunks_exact_mut(*n).enumerate() {
                    column.copy_from_slice(x.col(c).try_as_col_major().unwrap().as_slice());
                }
                factor.solve_in_place(columns);
                out.copy_from(MatRef::from_column_major_slice(columns, *n, 3));
            }
        }
    }

    fn conj_apply(&self, out: MatMut<'_, f64>, x: MatRef<'_, f64>, par: Par, m: &mut MemStack) {
        self.apply(out, x, par, m);
    }
}

impl Precond<f64> for Inverse {}

/// Solves by faer's method from `P⁻¹ B`, as ours does, but for the limit; answers the number of
/// iterations if they did.
fn iterate(
    matrix: &Matrix<'_>,
    inverse: &Inverse,
    rhs: &[DVec3],
    x: &mut [DVec3],
    limit: usize,
) -> Option<usize> {
    let mut memory = MemBuffer::new(conjugate_gradient_scratch(inverse, matrix, 3, Par::Seq));
    let b = Mat::from_fn(rhs.len(), 3, |i, c| rhs[i][c]);
    let mut solution = Mat::zeros(rhs.len(), 3);
    let stack = MemStack::new(&mut memory);
    inverse.apply(solution.as_mut(), b.as_ref(), Par::Seq, stack);
    let parameters = CgParams {
        rel_tolerance: TOLERANCE,
        max_iters: limit,
        ..CgParams::default()
    };
    let ignore = |_: MatRef<'_, f64>| ();
    let info = conjugate_gradient(
        solution.as_mut(),
        inverse,
        matrix,
        b.as_ref(),
        parameters,
        ignore,
        Par::Seq,
        stack,
    );
    for (i, x) in x.iter_mut().enumerate() {
        *x = DVec3::new(solution[(i, 0)], solution[(i, 1)], solution[(i, 2)]);
    }
    info.ok().map(|info| info.iter_count)
}

/// ‖b − A x‖ / ‖b‖.
fn residual(pattern: &Pattern, values: &[f64], x: &[DVec3], b: &[DVec3]) -> f64 {
    let mut product = vec![DVec3::ZERO; x.len()];
    pattern.multiply(values, x, &mut product);
    let rest: f64 = product
        .iter()
        .zip(b)
        .map(|(p, b)| p.distance_squared(*b))
        .sum();
    (rest / b.iter().map(|b| b.length_squared()).sum::<f64>()).sqrt()
}

/// Prints the time of a solve in which the diagonal does not do, attempt and factor.
fn compare_in_vain(mesh: &FlapMesh, print: &mut dyn FnMut(String)) {
    let pattern = mesh.pattern();
    let values = mesh.bending_matrix(&pattern, &mesh.points, 1e6);
    let symbolic = Symbolic::analyse(&pattern, Some(&mesh.points)).unwrap();
    let mut factor = Ldlt::new(Arc::new(symbolic)).unwrap();
    let (b, mut x) = (mesh.field(1), mesh.field(2));
    let diagonal = pattern.diagonal_slots().iter();
    let inverse = Inverse::Diagonal(diagonal.map(|&s| values[s as usize].recip()).collect());
    let theirs = Matrix {
        pattern: &pattern,
        values: &values,
    };
    let mut least = [f64::INFINITY; 2];
    let mut limit = 0;
    for _ in 0..3 {
        // A new one, as ours waits after a failure.
        let mut solver = Solver::new(pattern.clone(), Some(&mesh.points)).unwrap();
        limit = solver.iteration_limit();
        let ours = milliseconds(|| {
            let policy = Refactor::WhenCheaper;
            let info = solver
                .solve(&values, &b, &mut x, TOLERANCE, policy)
                .unwrap();
            assert_eq!(info.preconditioner, Preconditioner::NewFactor);
        });
        let faer = milliseconds(|| {
            assert_eq!(iterate(&theirs, &inverse, &b, &mut x, limit), None);
            factor.factor(&values).unwrap();
            x.copy_from_slice(&b);
            factor.solve_in_place(&mut x);
        });
        least = [least[0].min(ours), least[1].min(faer)];
    }
    let [ours, faer] = least;
    print(format!(
        "{:>7} {:>8} {:>6} {limit:>6} {ours:>9.1} {faer:>9.1} {:>6.2}",
        mesh.n(),
        "in vain",
        "",
        faer / ours
    ));
}

/// Prints times and numbers of iterations, and the ratio of times.
pub(super) fn compare(sizes: &[u32], print: &mut dyn FnMut(String)) {
    print(format!(
        "{:>7} {:>8} {:>6} {:>6} {:>9} {:>9} {:>6} {:>8} {:>8}  \
         conjugate gradients: iterations, milliseconds, residuals",
        "n", "with", "ours", "faer", "ours", "faer", "ratio", "ours", "faer"
    ));
    for &q in sizes {
        let mesh = FlapMesh::icosphere(q);
        let pattern = mesh.pattern();
        let n = mesh.n();
        for kept in [false, true] {
            let stiffness = if kept { 1e4 } else { 1.0 };
            let matrix = |points: &[DVec3]| mesh.bending_matrix(&pattern, points, stiffness);
            let before = matrix(&mesh.points);
            let scale = |p: &DVec3| *p * (1.0 + 0.02 * (3.0 * p.x).sin());
            let values = matrix(&mesh.points.iter().map(scale).collect::<Vec<_>>());
            let mut solver = Solver::new(pattern.clone(), Some(&mesh.points)).unwrap();
            let (b, mut x, mut y) = (mesh.field(1), mesh.field(2), mesh.field(2));
            let (wanted, inverse) = if kept {
                let first = Refactor::Always;
                solver.solve(&before, &b, &mut x, TOLERANCE, first).unwrap();
                let symbolic = Symbolic::analyse(&pattern, Some(&mesh.points)).unwrap();
                let mut factor = Ldlt::new(Arc::new(symbolic)).unwrap();
                factor.reserve_columns(3).unwrap();
                factor.factor(&before).unwrap();
                let work = Box::new(Mutex::new((factor, vec![0.0; 3 * n])));
                (Preconditioner::KeptFactor, Inverse::Factor(work, n))
            } else {
                let diagonal = pattern.diagonal_slots().iter();
                let inverse = diagonal.map(|&s| values[s as usize].recip()).collect();
                (Preconditioner::Diagonal, Inverse::Diagonal(inverse))
            };
            solver.set_iterative_from(0);
            let theirs = Matrix {
                pattern: &pattern,
                values: &values,
            };
            let mut iterations = [0; 2];
            let [first, second] = &mut iterations;
            let [ours, faer] = least_of_two(
                7,
                || {
                    let policy = Refactor::WhenCheaper;
                    let info = solver
                        .solve(&values, &b, &mut x, TOLERANCE, policy)
                        .unwrap();
                    assert_eq!(info.preconditioner, wanted, "{info:?}");
                    *first = info.iterations;
                },
                || *second = iterate(&theirs, &inverse, &b, &mut y, 1000).unwrap(),
            );
            print(format!(
                "{n:>7} {:>8} {:>6} {:>6} {ours:>9.1} {faer:>9.1} {:>6.2} {:>8.0e} {:>8.0e}",
                if kept { "factor" } else { "diagonal" },
                iterations[0],
                iterations[1],
                faer / ours,
                residual(&pattern, &values, &x, &b),
                residual(&pattern, &values, &y, &b),
            ));
        }
        compare_in_vain(&mesh, print);
    }
}
