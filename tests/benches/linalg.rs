//! Cost of ordering, factorisation and solution on bending matrices of bumpy spheres.
//!
//! Prints a table first (least CPU time of some runs), then lets criterion measure the
//! smaller sizes. `UMBILIC_STIFFNESS` sets the condition of the matrices.

#![allow(
    clippy::unwrap_used,
    reason = "a bench that fails has nothing to measure"
)]

#[path = "../suite/support/clock.rs"]
mod clock;
#[path = "../suite/support/flap_matrix.rs"]
mod flap_matrix;

#[path = "linalg/elimination.rs"]
mod elimination;
#[path = "linalg/iteration.rs"]
mod iteration;
#[path = "linalg/stars.rs"]
mod stars;
#[path = "linalg/timing.rs"]
mod timing;

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use flap_matrix::FlapMesh;
use std::hint::black_box;
use std::sync::Arc;
use timing::least;
use umbilic::linalg::{Ldlt, Symbolic};

fn table() {
    println!(
        "{:>7} {:>9} {:>7} {:>8} {:>9} {:>8} {:>7} {:>8}  milliseconds",
        "n", "entries", "GFlop", "pattern", "analysis", "factor", "solve3", "product"
    );
    for q in [16, 32, 61, 100, 187] {
        let mesh = FlapMesh::icosphere(q);
        let pattern = mesh.pattern();
        let pattern_ms = least(1, || drop(black_box(mesh.pattern())));
        let values = mesh.bending_matrix(&pattern, &mesh.points, stiffness());
        let analyse = || Symbolic::analyse(&pattern, Some(&mesh.points)).unwrap();
        let symbolic = Arc::new(analyse());
        let analysis = least(1, || drop(black_box(analyse())));
        let mut ldlt = Ldlt::new(symbolic.clone()).unwrap();
        let repetitions = if q > 100 { 2 } else { 5 };
        let factor = least(repetitions, || {
            assert_eq!(ldlt.factor(&values).unwrap().negative, 0)
        });
        let (x, mut y) = (mesh.field(1), mesh.field(2));
        let solve = least(repetitions, || ldlt.solve_in_place(&mut y));
        let product = least(repetitions, || pattern.multiply(&values, &x, &mut y));
        println!(
            "{:>7} {:>9} {:>7.3} {pattern_ms:>8.1} {analysis:>9.1} {factor:>8.2} {solve:>7.2} {product:>8.2}",
            mesh.n(),
            symbolic.factor_len(),
            symbolic.flops() * 1e-9,
        );
    }
}

/// Of the matrices: about their condition.
fn stiffness() -> f64 {
    std::env::var("UMBILIC_STIFFNESS").map_or(1e4, |text| text.parse().unwrap())
}

fn benches(criterion: &mut Criterion) {
    let print = &mut |line: String| println!("{line}");
    stars::compare(print);
    iteration::compare(&[32, 64, 128], print);
    elimination::compare(6, print);
    table();
    let mut group = criterion.benchmark_group("ldlt");
    group.sample_size(10);
    for q in [16, 32, 61] {
        let mesh = FlapMesh::icosphere(q);
        let pattern = mesh.pattern();
        let values = mesh.bending_matrix(&pattern, &mesh.points, stiffness());
        let symbolic = Arc::new(Symbolic::analyse(&pattern, Some(&mesh.points)).unwrap());
        let mut factor = Ldlt::new(symbolic).unwrap();
        let mut x = mesh.field(1);
        group.bench_function(BenchmarkId::new("factor", mesh.n()), |b| {
            b.iter(|| factor.factor(&values).unwrap());
        });
        group.bench_function(BenchmarkId::new("solve3", mesh.n()), |b| {
            b.iter(|| factor.solve_in_place(&mut x));
        });
    }
    group.finish();
}

criterion_group!(linalg, benches);
criterion_main!(linalg);
