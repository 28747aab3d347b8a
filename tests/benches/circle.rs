//! Cost of a default step of the circle flow on bumpy spheres, and of its parts.

#![allow(
    clippy::unwrap_used,
    reason = "a bench that fails has nothing to measure"
)]

#[path = "../suite/support/clock.rs"]
mod clock;

use clock::clock;
use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use glam::DVec3;
use std::hint::black_box;
use std::rc::Rc;
use std::time::Duration;
use umbilic::energy::circle::angle::Smoothing;
use umbilic::energy::circle::star::StarMatrix;
use umbilic::energy::circle::{Boundary, CircleEnergy, Evaluation};
use umbilic::flow::Driver;
use umbilic::flow::options::FlowOptions;
use umbilic::geometry::survey::survey;
use umbilic::linalg::{Method, Solver};
use umbilic::mesh::{Built, HalfedgeMesh, build, shape};

const SMOOTHING: Smoothing = Smoothing { epsilon: 0.1 };

/// A bumpy sphere some steps into its flow: the first are not typical.
fn surface(level: usize) -> (Rc<HalfedgeMesh>, Vec<DVec3>, Driver) {
    let sample = shape::make("bumpy-sphere", &[("level".into(), level as f64)]).unwrap();
    let Built {
        mesh, positions, ..
    } = build(&sample.soup).unwrap();
    let (mesh, mut x) = (Rc::new(mesh), positions);
    let mut flow = Driver::start(&mesh, &mesh, &mut x, FlowOptions::default()).unwrap();
    for _ in 0..4 {
        flow.step(&mut x).unwrap();
    }
    (mesh, x, flow)
}

fn parts(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("circle");
    group.sample_size(10);
    for level in [4, 5, 6] {
        let (mesh, x, mut flow) = surface(level);
        let n = mesh.n_vertices();
        let mut time = |part: &str, run: &mut dyn FnMut()| {
            group.bench_function(BenchmarkId::new(part, n), |b| {
                b.iter_custom(|runs| {
                    let start = clock();
                    (0..runs).for_each(|_| run());
                    Duration::from_secs_f64(clock() - start)
                });
            });
        };

        let energy = CircleEnergy::new(&mesh, Boundary::Clamped);
        let mut evaluation = Evaluation::default();
        time("value", &mut || {
            black_box(energy.value(&x, SMOOTHING));
        });
        time("evaluate", &mut || {
            energy.evaluate(&x, SMOOTHING, &mut evaluation)
        });

        let mut matrix = StarMatrix::new(&energy, &vec![true; n]);
        let mut values = Vec::new();
        let info = matrix.assemble(&evaluation.weights, true, &mut values);
        println!("{} of {} stars projected", info.projected_stars, info.stars);
        time("assemble", &mut || {
            matrix.assemble(&evaluation.weights, true, &mut values);
        });

        for &slot in matrix.pattern().diagonal_slots() {
            values[slot as usize] *= 1.01;
        }
        let mut solver = Solver::new(matrix.pattern().clone(), Some(&x));
        let mut d = vec![DVec3::ZERO; n];
        time("factor and solve", &mut || {
            let g = &evaluation.gradient;
            solver
                .solve(&values, g, &mut d, 1e-6, Method::Direct)
                .unwrap();
        });
        time("survey", &mut || {
            black_box(survey(&mesh, &x, &x));
        });

        let checkpoint = flow.checkpoint();
        time("step", &mut || {
            let mut y = x.clone();
            flow.restore(checkpoint.clone());
            flow.step(&mut y).unwrap();
        });
    }
    group.finish();
}

criterion_group!(circle, parts);
criterion_main!(circle);
