//! Energy, gradient, K and the paper's scheme against independent numbers: inversion at
//! 50 digits, differences, a dense solve in high precision (`tests/reference`).

use crate::support::*;
use glam::DVec3;
use std::sync::Arc;
use umbilic::energy::circle::angle::Smoothing;
use umbilic::energy::circle::star::StarMatrix;
use umbilic::energy::circle::{Boundary, CircleEnergy, Evaluation};
use umbilic::flow::options::{FlowOptions, Scheme};
use umbilic::geometry::curvature;
use umbilic::linalg::{Ldlt, Symbolic};
use umbilic::mesh::Vertex;

const ALL: [&str; 15] = [
    "closed_icosphere",
    "closed_torus",
    "closed_klein",
    "closed_islands",
    "closed_octahedron_2",
    "closed_tetrahedron_2",
    "free_disc",
    "free_annulus",
    "free_mobius",
    "fixed_disc",
    "fixed_annulus",
    "fixed_mobius",
    "fixed_disc_islands",
    "clamped_disc",
    "clamped_annulus",
];

fn boundary(data: &serde_json::Value) -> Boundary {
    match data["boundary"].as_str() {
        Some("free") => Boundary::Free,
        Some("clamped") => Boundary::Clamped,
        _ => Boundary::Fixed,
    }
}

#[test]
fn energy_gradient_and_stiffness_agree_to_1e_9() {
    for name in ALL
        .into_iter()
        .chain(["smoothed_torus", "smoothed_annulus"])
    {
        let data = reference(name);
        let Surface { mesh, x, .. } = surface(&soup_of(&data));
        let energy = CircleEnergy::new(&mesh, boundary(&data));
        let smoothing = Smoothing {
            epsilon: number(&data["epsilon"]),
        };
        let mut found = Evaluation::default();
        energy.evaluate(&x, smoothing, &mut found);

        let expected = number(&data["energy"]);
        assert!(
            (found.value - expected).abs() <= 1e-12 * expected.abs().max(1.0),
            "{name}: W"
        );
        assert!((energy.value(&x, smoothing) - found.value).abs() <= 1e-12 * expected.max(1.0));

        let gradient = points(&data["gradient"]);
        for v in indices(&data["held"]) {
            found.gradient[v as usize] = DVec3::ZERO;
        }
        let size = gradient.iter().map(|g| g.length()).fold(0.0, f64::max);
        let error = largest_difference(&found.gradient, &gradient);
        assert!(
            error <= 1e-9 * size.max(1e-3),
            "{name}: gradient off by {error} of {size}"
        );

        if smoothing.epsilon == 0.0 {
            let rows = data["vertex_energy"].as_array().expect("W_i");
            let per_vertex = energy.vertex_energies(&x);
            for v in mesh.vertices().filter(|&v| energy.counts(v)) {
                let expected = number(&rows[v.index()]);
                assert!(
                    (per_vertex[v.index()] - expected).abs() < 1e-12,
                    "{name}: W_{}",
                    v.0
                );
            }
            let defect = curvature::integrated_gauss_curvature(&mesh, &x);
            for (found, expected) in defect.iter().zip(numbers(&data["angle_defect"])) {
                assert!((found - expected).abs() < 1e-12, "{name}: angle defect");
            }
        }
    }
}

#[test]
fn the_edge_weights_are_those_of_the_distance_laplacian() {
    for name in [
        "smoothed_torus",
        "smoothed_annulus",
        "closed_torus",
        "free_annulus",
    ] {
        let data = reference(name);
        let Some(entries) = data.get("stiffness").and_then(|s| s.as_array()) else {
            continue;
        };
        let Surface { mesh, x, .. } = surface(&soup_of(&data));
        let energy = CircleEnergy::new(&mesh, boundary(&data));
        let mut found = Evaluation::default();
        let smoothing = Smoothing {
            epsilon: number(&data["epsilon"]),
        };
        energy.evaluate(&x, smoothing, &mut found);
        let free = vec![true; mesh.n_vertices()];
        let mut matrix = StarMatrix::new(&energy, &free);
        let mut values = Vec::new();
        matrix.assemble(&found.weights, false, &mut values);
        let mut size = 0.0f64;
        for entry in entries {
            size = size.max(number(&entry[2]).abs());
        }
        for entry in entries {
            let [p, q, w] = [0, 1, 2].map(|i| number(&entry[i]));
            let k = values[matrix.pattern().slot(p as u32, q as u32)];
            assert!(
                (k + w).abs() < 1e-9 * size,
                "{name}: K_{p},{q} = {k}, not {}",
                -w
            );
        }
    }
}

#[test]
fn ten_steps_of_the_papers_scheme_agree_to_1e_6() {
    for name in ALL {
        let data = reference(name);
        if data["trace"].as_array().is_none_or(Vec::is_empty) {
            continue;
        }
        let Surface { mesh, mut x, .. } = surface(&soup_of(&data));
        let options = FlowOptions {
            scheme: Scheme::Paper,
            boundary: Some(boundary(&data)),
            dt: Some(number(&data["dt"])),
            fixed: Some(indices(&data["fixed"])),
            ..FlowOptions::default()
        };
        let mut flow = drive(&mesh, &mut x, options).expect("a flow");
        let held = indices(&data["held"]);
        for v in mesh.vertices() {
            assert_eq!(
                flow.flow().is_free(v.index()),
                !held.contains(&v.0),
                "{name}: held {}",
                v.0
            );
        }
        for (k, row) in data["trace"].as_array().expect("trace").iter().enumerate() {
            let (report, _) = flow.step(&mut x).expect("a step");
            let report = report.expect("a step is taken");
            let expected = number(&row["energy"]);
            let error = (report.energy - expected).abs() / expected.abs().max(1e-3);
            assert!(
                error <= 1e-6,
                "{name}: W after step {} off by {error}",
                k + 1
            );
            assert_eq!(report.negative_pivots, 0, "{name}");
        }
        let h = number(&data["mean_edge_length"]);
        let error = largest_difference(&x, &points(&data["final_positions"])) / h;
        assert!(error <= 1e-6, "{name}: positions off by {error} h");
    }
}

/// The projected matrix against the exact projection star by star: the couplings it
/// replaces only add, and add little.
#[test]
fn the_recommended_matrix_is_semidefinite_and_close_to_the_projection() {
    for name in ["smoothed_torus", "smoothed_annulus"] {
        let data = reference(name);
        let Surface { mesh, x, .. } = surface(&soup_of(&data));
        let energy = CircleEnergy::new(&mesh, boundary(&data));
        let smoothing = Smoothing {
            epsilon: number(&data["epsilon"]),
        };
        let mut found = Evaluation::default();
        energy.evaluate(&x, smoothing, &mut found);
        let free = vec![true; mesh.n_vertices()];
        let mut matrix = StarMatrix::new(&energy, &free);
        let (mut plain, mut projected) = (Vec::new(), Vec::new());
        matrix.assemble(&found.weights, false, &mut plain);
        let info = matrix.assemble(&found.weights, true, &mut projected);
        assert!(info.projected_stars > 0, "{name}: nothing to project");

        let expected = numbers(&data["star_diagonal"]);
        let size = expected.iter().copied().fold(0.0, f64::max);
        let (mut sum, mut expected_sum) = (0.0, 0.0);
        for (slot, expected) in matrix.pattern().diagonal_slots().iter().zip(expected) {
            let found = projected[*slot as usize];
            assert!(
                found > expected - 1e-8 * size,
                "{name}: {found} below {expected}"
            );
            (sum, expected_sum) = (sum + found, expected_sum + expected);
        }
        println!(
            "{name}: trace {:.4} of the exact projection's",
            sum / expected_sum
        );
        assert!(
            sum < 1.1 * expected_sum,
            "{name}: {sum}, not {expected_sum}"
        );

        let symbolic = Arc::new(Symbolic::analyse(matrix.pattern(), None).expect("an analysis"));
        let mut factor = Ldlt::new(symbolic).expect("memory");
        let mut negative = |mut values: Vec<f64>| {
            for &slot in matrix.pattern().diagonal_slots() {
                values[slot as usize] += 1e-8 * size;
            }
            factor.factor(&values).expect("no zero pivot").negative
        };
        let change = projected.iter().zip(&plain).map(|(a, b)| a - b).collect();
        assert!(negative(plain) > 0, "{name}: K itself is indefinite");
        assert_eq!(negative(projected), 0, "{name}: not semi-definite");
        assert_eq!(
            negative(change),
            0,
            "{name}: the projection took something away"
        );
    }
}

#[test]
fn a_vertex_sent_to_infinity_is_a_free_boundary() {
    let data = &reference("closed_forms")["vertex_at_infinity"];
    let Surface { mesh, x, .. } = surface(&soup_of(data));
    let energy = CircleEnergy::new(&mesh, Boundary::Free);
    let closed = number(&data["closed_energy"]);
    let found = energy.value(&x, Smoothing::EXACT);
    assert!(
        (found - closed).abs() < 1e-12 * closed,
        "{found}, not {closed}"
    );
    let at_infinity = found - energy.vertex_energies(&x).iter().sum::<f64>();
    assert!((at_infinity - number(&data["closed_vertex_energy"])).abs() < 1e-11);
    assert!(
        mesh.is_boundary_vertex(Vertex(
            mesh.boundary_loops()
                .flatten()
                .map(|h| mesh.tail(h).0)
                .min()
                .expect("a loop")
        ))
    );
}
