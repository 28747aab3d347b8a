//! Solves for three columns with multigrid and with a factor.

use super::flap_matrix::FlapMesh;
use super::timing::least_of_two;
use umbilic::linalg::{Method, Solver};

/// Prints numbers of iterations, times and their ratio.
pub(super) fn compare(sizes: &[u32], print: &mut dyn FnMut(String)) {
    print(format!(
        "{:>7} {:>9} {:>9} {:>6} {:>9} {:>9} {:>6}  multigrid and factor: milliseconds",
        "n", "stiffness", "residual", "steps", "multigrid", "factor", "ratio"
    ));
    for &q in sizes {
        let mesh = FlapMesh::icosphere(q);
        let pattern = mesh.pattern();
        let b = mesh.field(1);
        for (stiffness, tolerance) in [(1e2, 1e-2), (1e4, 1e-2), (1e4, 1e-8)] {
            let values = mesh.bending_matrix(&pattern, &mesh.points, stiffness);
            let mut solver = Solver::on_mesh(pattern.clone(), &mesh.points, mesh.edges());
            solver.prefer_multigrid();
            let mut direct = Solver::new(pattern.clone(), Some(&mesh.points));
            let (mut x, mut y) = (mesh.field(2), mesh.field(2));
            let mut iterations = 0;
            let [multigrid, factor] = least_of_two(
                5,
                || {
                    let method = Method::Multigrid;
                    let info = solver.solve(&values, &b, &mut x, tolerance, method);
                    let info = info.unwrap();
                    assert_eq!(info.method, method, "{info:?}");
                    iterations = info.iterations;
                },
                || {
                    direct
                        .solve(&values, &b, &mut y, tolerance, Method::Direct)
                        .unwrap();
                },
            );
            print(format!(
                "{:>7} {stiffness:>9.0e} {tolerance:>9.0e} {iterations:>6} {multigrid:>9.1} \
                 {factor:>9.1} {:>6.2}",
                mesh.n(),
                factor / multigrid,
            ));
        }
    }
}
