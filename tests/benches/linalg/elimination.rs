//! Unsymmetric matrices as the curvature flows have them factored and solved: by our
//! multifrontal LU, and by faer's supernodal LU with partial pivoting, on the same order of
//! elimination and on the one that faer itself would take (COLAMD).

use super::timing::least_of_two;
use faer::dyn_stack::{MemBuffer, MemStack, StackReq};
use faer::perm::PermRef;
use faer::sparse::linalg::SymbolicSupernodalParams;
use faer::sparse::linalg::colamd;
use faer::sparse::linalg::lu::supernodal;
use faer::sparse::linalg::qr;
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, MatMut, Par, Spec};
use std::sync::Arc;
use umbilic::linalg::{Lu, Pattern, Symbolic, Unsymmetric};
use umbilic::mesh::{Built, build, shape};
use umbilic::operator::FittedOperators;

/// faer's factor, of matrices of one pattern.
struct FaerLu {
    /// Row eliminated first, second, …
    order: Vec<u32>,
    /// The permuted matrix by columns; its pattern is symmetric.
    starts: Vec<u32>,
    rows: Vec<u32>,
    /// Slot of each entry, and whether it is of the lower triangle.
    slots: Vec<(u32, bool)>,
    symbolic: supernodal::SymbolicSupernodalLu<u32>,
    lu: supernodal::SupernodalLu<u32, f64>,
    identity: Vec<u32>,
    row_order: Vec<u32>,
    row_inverse: Vec<u32>,
    memory: MemBuffer,
}

/// A symmetric pattern by columns, permuted.
fn permuted(pattern: &Pattern, order: &[u32]) -> (Vec<u32>, Vec<u32>, Vec<(u32, bool)>) {
    let n = pattern.n();
    let mut inverse = vec![0; n];
    for (k, &i) in order.iter().enumerate() {
        inverse[i as usize] = k as u32;
    }
    let mut columns: Vec<Vec<(u32, (u32, bool))>> = vec![Vec::new(); n];
    for j in 0..n {
        for slot in pattern.column(j) {
            let (row, column) = (inverse[pattern.rows()[slot] as usize], inverse[j]);
            columns[column as usize].push((row, (slot as u32, true)));
            if row != column {
                columns[row as usize].push((column, (slot as u32, false)));
            }
        }
    }
    let (mut starts, mut rows, mut slots) = (vec![0], Vec::new(), Vec::new());
    for mut column in columns {
        column.sort_unstable();
        rows.extend(column.iter().map(|(row, _)| *row));
        slots.extend(column.iter().map(|(_, slot)| *slot));
        starts.push(rows.len() as u32);
    }
    (starts, rows, slots)
}

impl FaerLu {
    fn new(pattern: &Pattern, order: &[u32]) -> Self {
        let n = pattern.n();
        let scratch = StackReq::any_of(&[
            qr::col_etree_scratch::<u32>(n, n),
            qr::postorder_scratch::<u32>(n),
            qr::column_counts_aat_scratch::<u32>(n, n),
            supernodal::factorize_supernodal_symbolic_lu_scratch::<u32>(n, n),
        ]);
        let mut memory = MemBuffer::new(scratch);
        let stack = MemStack::new(&mut memory);
        let (mut tree, mut post) = (vec![0; n], vec![0; n]);
        // faer wants an order in which the column elimination tree is traversed by subtrees.
        let (starts, rows, _) = permuted(pattern, order);
        let structure = SymbolicSparseColMatRef::new_checked(n, n, &starts, None, &rows);
        let found = qr::col_etree(structure, None, &mut tree, stack);
        qr::postorder(&mut post, found, stack);
        let order: Vec<u32> = post.iter().map(|&k: &u32| order[k as usize]).collect();
        let (starts, rows, slots) = permuted(pattern, &order);
        let structure = SymbolicSparseColMatRef::new_checked(n, n, &starts, None, &rows);
        let found = qr::col_etree(structure, None, &mut tree, stack);
        qr::postorder(&mut post, found, stack);
        let (mut counts, mut least) = (vec![0; n], vec![0; n]);
        qr::column_counts_ata(
            &mut counts,
            &mut least,
            structure,
            None,
            found,
            &post,
            stack,
        );
        let symbolic = supernodal::factorize_supernodal_symbolic_lu(
            structure,
            None,
            &least,
            found,
            &counts,
            stack,
            SymbolicSupernodalParams::default(),
        )
        .unwrap();
        let scratch = supernodal::factorize_supernodal_numeric_lu_scratch::<u32, f64>(
            &symbolic,
            Spec::default(),
        )
        .or(supernodal::solve_in_place_scratch::<u32, f64>(
            n,
            1,
            Par::Seq,
        ));
        Self {
            order,
            starts,
            rows,
            slots,
            symbolic,
            lu: supernodal::SupernodalLu::new(),
            identity: (0..n as u32).collect(),
            row_order: vec![0; n],
            row_inverse: vec![0; n],
            memory: MemBuffer::new(scratch),
        }
    }

    fn factor(&mut self, values: &Unsymmetric) {
        let n = self.order.len();
        let pick = |&(slot, lower): &(u32, bool), transposed: bool| {
            let on_diagonal = values.upper[slot as usize];
            if lower != transposed {
                values.lower[slot as usize]
            } else {
                on_diagonal
            }
        };
        let structure = SymbolicSparseColMatRef::new_checked(n, n, &self.starts, None, &self.rows);
        let entries: Vec<f64> = self.slots.iter().map(|s| pick(s, false)).collect();
        let mut across: Vec<f64> = self.slots.iter().map(|s| pick(s, true)).collect();
        for (k, (column, row)) in (0..n)
            .flat_map(|j| (self.starts[j]..self.starts[j + 1]).map(move |_| j))
            .zip(&self.rows)
            .enumerate()
        {
            if column == *row as usize {
                across[k] = entries[k];
            }
        }
        supernodal::factorize_supernodal_numeric_lu(
            &mut self.row_order,
            &mut self.row_inverse,
            &mut self.lu,
            SparseColMatRef::new(structure, &entries),
            SparseColMatRef::new(structure, &across),
            PermRef::new_checked(&self.identity, &self.identity, n),
            &self.symbolic,
            Par::Seq,
            MemStack::new(&mut self.memory),
            Spec::default(),
        )
        .unwrap();
    }

    fn solve_in_place(&mut self, rhs: &mut [f64]) {
        let n = self.order.len();
        let mut y: Vec<f64> = self.order.iter().map(|&i| rhs[i as usize]).collect();
        self.lu.solve_in_place_with_conj(
            PermRef::new_checked(&self.row_order, &self.row_inverse, n),
            PermRef::new_checked(&self.identity, &self.identity, n),
            Conj::No,
            MatMut::from_column_major_slice_mut(&mut y, n, 1),
            Par::Seq,
            MemStack::new(&mut self.memory),
        );
        for (&i, y) in self.order.iter().zip(y) {
            rhs[i as usize] = y;
        }
    }
}

/// 1/dt + ½ (−Δ)^power at dt = 1 on a bumpy sphere, by fits of quadrics: but for terms of lower
/// order the matrix of the Willmore flow (power 2) and of the flow of minimal
/// mean-curvature variation (3). The points order the elimination.
fn flow_matrix(level: usize, power: usize) -> (Pattern, Vec<glam::DVec3>, Unsymmetric) {
    let sample = shape::make("bumpy-sphere", &[("level".into(), level as f64)]).unwrap();
    let Built {
        mesh, positions, ..
    } = build(&sample.soup).unwrap();
    let fitted = FittedOperators::everywhere(&mesh, &positions);
    let n = positions.len();
    let stencil = |i: u32| {
        let row = fitted.row(i as usize).unwrap();
        fitted.members(row).iter().zip(fitted.laplacian(row))
    };
    let mut work = vec![0.0; n];
    let mut rows: Vec<Vec<(u32, f64)>> = Vec::new();
    for i in 0..n as u32 {
        let mut row = vec![(i, 0.5)];
        for _ in 0..power {
            let mut reached = Vec::new();
            for (k, value) in row {
                for (&j, weight) in stencil(k) {
                    reached.push(j);
                    work[j as usize] -= value * weight;
                }
            }
            reached.sort_unstable();
            reached.dedup();
            row = reached
                .into_iter()
                .map(|j| (j, std::mem::take(&mut work[j as usize])))
                .collect();
        }
        rows.push(row);
    }
    let pairs = rows
        .iter()
        .enumerate()
        .flat_map(|(i, row)| row.iter().map(move |&(j, _)| [i as u32, j]));
    let pattern = Pattern::from_cliques(n, pairs);
    let mut values = Unsymmetric::zeros(&pattern);
    for (i, row) in rows.iter().enumerate() {
        for &(j, value) in row {
            let slot = pattern.slot(i as u32, j);
            let triangle = if i >= j as usize {
                &mut values.lower
            } else {
                &mut values.upper
            };
            triangle[slot] = value;
        }
    }
    for &slot in pattern.diagonal_slots() {
        values.lower[slot as usize] += 1.0;
    }
    (pattern, positions, values)
}

/// ‖b − A x‖ / ‖b‖.
fn residual(pattern: &Pattern, values: &Unsymmetric, x: &[f64], b: &[f64]) -> f64 {
    let mut product = vec![0.0; x.len()];
    values.multiply(pattern, x, &mut product);
    let rest: f64 = product.iter().zip(b).map(|(p, b)| (p - b).powi(2)).sum();
    (rest / b.iter().map(|b| b * b).sum::<f64>()).sqrt()
}

/// faer's own order of elimination: column approximate minimum degree.
fn colamd_order(pattern: &Pattern) -> Vec<u32> {
    let n = pattern.n();
    let identity: Vec<u32> = (0..n as u32).collect();
    let (starts, rows, _) = permuted(pattern, &identity);
    let structure = SymbolicSparseColMatRef::new_checked(n, n, &starts, None, &rows);
    let (mut order, mut inverse) = (vec![0; n], vec![0; n]);
    let mut memory = MemBuffer::new(colamd::order_scratch::<u32>(n, n, rows.len()));
    let stack = MemStack::new(&mut memory);
    let control = colamd::Control::default();
    colamd::order(&mut order, &mut inverse, structure, control, stack).unwrap();
    order
}

/// Prints the times to factor and to solve, and their ratios, up to that level of subdivision.
pub(super) fn compare(largest: usize, print: &mut dyn FnMut(String)) {
    print(format!(
        "{:>5} {:>7} {:>8} {:>9} {:>9} {:>6} {:>8} {:>8} {:>6} {:>8} {:>8} {:>7}  \
         LU: milliseconds of factors and of solutions, residuals, faer's order",
        "order",
        "n",
        "entries",
        "ours",
        "faer",
        "ratio",
        "ours",
        "faer",
        "ratio",
        "ours",
        "faer",
        ""
    ));
    for (power, level) in [2, 3]
        .iter()
        .flat_map(|p| (4..=largest).map(move |l| (*p, l)))
    {
        let (pattern, points, values) = flow_matrix(level, power);
        let symbolic = Arc::new(Symbolic::analyse(&pattern, Some(&points)).unwrap());
        let orders = [
            ("COLAMD", colamd_order(&pattern)),
            ("ours", symbolic.order().to_vec()),
        ];
        let mut ours = Lu::new(symbolic).unwrap();
        for (name, order) in orders {
            let mut faer = FaerLu::new(&pattern, &order);
            let repetitions = if level > 5 { 2 } else { 5 };
            let [factor, faer_factor] = least_of_two(
                repetitions,
                || ours.factor(&values).unwrap(),
                || faer.factor(&values),
            );
            let b: Vec<f64> = (0..pattern.n()).map(|i| (0.37 * i as f64).sin()).collect();
            let (mut x, mut y) = (b.clone(), b.clone());
            ours.solve_in_place(&mut x);
            faer.solve_in_place(&mut y);
            let residuals = [x, y].map(|x| residual(&pattern, &values, &x, &b));
            let (mut x, mut y) = (b.clone(), b);
            let [solve, faer_solve] = least_of_two(
                repetitions,
                || ours.solve_in_place(&mut x),
                || faer.solve_in_place(&mut y),
            );
            print(format!(
                "{:>5} {:>7} {:>8} {factor:>9.1} {faer_factor:>9.1} {:>6.2} {solve:>8.2} \
                 {faer_solve:>8.2} {:>6.2} {:>8.0e} {:>8.0e} {name:>7}",
                2 * power,
                pattern.n(),
                ours.factor_len(),
                faer_factor / factor,
                faer_solve / solve,
                residuals[0],
                residuals[1],
            ));
        }
    }
}
