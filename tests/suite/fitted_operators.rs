//! Differential operators by quadratic fits: closed forms, identities, orders of convergence.

use crate::support::*;
use glam::DVec3;
use std::f64::consts::TAU;
use umbilic::mesh::shape;
use umbilic::operator::FittedOperators;
use umbilic::soup::PolygonSoup;

fn sample(name: &str, values: &[(&str, f64)]) -> Surface {
    let values: Vec<(String, f64)> = values.iter().map(|(n, v)| ((*n).to_owned(), *v)).collect();
    surface(&shape::make(name, &values).expect("a shape").soup)
}

/// A smooth surface f = 0 with outward gradient, and a test function, both with Hessians.
struct Implicit {
    gradient: fn(DVec3) -> DVec3,
    hessian: fn(DVec3) -> [DVec3; 3],
}

/// What the operators should give at a point.
struct Exact {
    normal: DVec3,
    h: f64,
    k: f64,
    laplacian: f64,
    gradient: DVec3,
    diamond: DVec3,
}

/// f = xy + z²/2 + sin x: its gradient and Hessian.
fn test_function(p: DVec3) -> (f64, DVec3, [DVec3; 3]) {
    let value = p.x * p.y + 0.5 * p.z * p.z + p.x.sin();
    let gradient = DVec3::new(p.y + p.x.cos(), p.x, p.z);
    (
        value,
        gradient,
        [DVec3::new(-p.x.sin(), 1.0, 0.0), DVec3::X, DVec3::Z],
    )
}

fn times(m: &[DVec3; 3], v: DVec3) -> DVec3 {
    v.x * m[0] + v.y * m[1] + v.z * m[2]
}

impl Implicit {
    fn exact(&self, p: DVec3) -> Exact {
        let (gradient, hessian) = ((self.gradient)(p), (self.hessian)(p));
        let size = gradient.length();
        let n = gradient / size;
        let a = n.any_orthonormal_vector();
        let b = n.cross(a);
        // The shape operator D n on tangents: positive on a sphere.
        let s = |u: DVec3, v: DVec3| u.dot(times(&hessian, v)) / size;
        let (saa, sab, sbb) = (s(a, a), s(a, b), s(b, b));
        let h = 0.5 * (saa + sbb);
        let (_, df, ddf) = test_function(p);
        let tangential = df - df.dot(n) * n;
        let (fa, fb) = (tangential.dot(a), tangential.dot(b));
        let second = |u: DVec3| u.dot(times(&ddf, u));
        Exact {
            normal: n,
            h,
            k: saa * sbb - sab * sab,
            laplacian: second(a) + second(b) - 2.0 * h * df.dot(n),
            gradient: tangential,
            diamond: (sbb * fa - sab * fb) * a + (saa * fb - sab * fa) * b,
        }
    }

    /// Root mean squares of the errors: normal, H, K, Δf, ∇f, ◇f; and the size of an edge, but for a factor.
    fn errors(&self, surface: &Surface) -> ([f64; 6], f64) {
        let operators = FittedOperators::everywhere(&surface.mesh, &surface.x);
        let f: Vec<f64> = surface.x.iter().map(|&p| test_function(p).0).collect();
        let mut sums = [0.0; 6];
        for (v, &p) in surface.x.iter().enumerate() {
            let row = operators.row(v).expect("a fit");
            let exact = self.exact(p);
            let errors = [
                operators.normal(row).distance(exact.normal),
                operators.mean_curvature(row, &surface.x) - exact.h,
                operators.gauss_curvature(row, &surface.x) - exact.k,
                operators.laplacian_of(row, &f) - exact.laplacian,
                operators.gradient_of(row, &f).distance(exact.gradient),
                operators.diamond_of(row, &f).distance(exact.diamond),
            ];
            for (sum, error) in sums.iter_mut().zip(errors) {
                *sum += error * error;
            }
        }
        let n = surface.x.len() as f64;
        (sums.map(|sum| (sum / n).sqrt()), 1.0 / n.sqrt())
    }
}

const SPHERE: Implicit = Implicit {
    gradient: |p| p,
    hessian: |_| [DVec3::X, DVec3::Y, DVec3::Z],
};

/// (R, a) = (2, 1): f = ½((ρ − 2)² + z²), ρ the distance from the axis.
const TORUS: Implicit = Implicit {
    gradient: |p| {
        let rho = p.truncate().length();
        let c = 1.0 - 2.0 / rho;
        DVec3::new(c * p.x, c * p.y, p.z)
    },
    hessian: |p| {
        let rho = p.truncate().length();
        let (c, d) = (1.0 - 2.0 / rho, 2.0 / rho.powi(3));
        [
            DVec3::new(c + d * p.x * p.x, d * p.x * p.y, 0.0),
            DVec3::new(d * p.x * p.y, c + d * p.y * p.y, 0.0),
            DVec3::Z,
        ]
    },
};

/// Semi-axes 1.5, 1, 0.7.
const ELLIPSOID: Implicit = Implicit {
    gradient: |p| p / (AXES * AXES),
    hessian: |_| {
        let d = 1.0 / (AXES * AXES);
        [d.x * DVec3::X, d.y * DVec3::Y, d.z * DVec3::Z]
    },
};
const AXES: DVec3 = DVec3::new(1.5, 1.0, 0.7);

/// A torus of that many steps, its diagonals and points at random where asked.
fn torus(around: usize, tube: usize, jitter: f64, mixes_diagonals: bool) -> Surface {
    let mut random = Random(5);
    let positions = (0..around * tube).map(|k| {
        let mut shift = || jitter * random.next();
        let u = TAU * ((k / tube) as f64 + shift()) / around as f64;
        let v = TAU * ((k % tube) as f64 + shift()) / tube as f64;
        let w = 2.0 + v.cos();
        DVec3::new(w * u.cos(), w * u.sin(), v.sin())
    });
    let positions: Vec<DVec3> = positions.collect();
    let mut faces = Vec::new();
    for i in 0..around {
        for j in 0..tube {
            let at = |i: usize, j: usize| ((i % around) * tube + j % tube) as u32;
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            if mixes_diagonals && random.next() > 0.0 {
                faces.extend([[a, b, d], [b, c, d]]);
            } else {
                faces.extend([[a, b, c], [a, c, d]]);
            }
        }
    }
    surface(&PolygonSoup::from_faces(positions, &faces))
}

/// Errors on meshes that get finer, and the orders between the last two.
fn check_orders(
    name: &str,
    implicit: &Implicit,
    meshes: &[Surface],
    least: [f64; 6],
    most: [f64; 6],
) {
    let found: Vec<([f64; 6], f64)> = meshes.iter().map(|m| implicit.errors(m)).collect();
    let (last, h) = found[found.len() - 1];
    let (before, before_h) = found[found.len() - 2];
    let orders: Vec<f64> = (0..6)
        .map(|k| (before[k] / last[k]).ln() / (before_h / h).ln())
        .collect();
    println!("{name}, {} vertices", meshes[meshes.len() - 1].x.len());
    for (k, quantity) in ["normal", "H", "K", "Δf", "∇f", "◇f"].iter().enumerate() {
        println!("  {quantity}: {:.2e}, order {:.2}", last[k], orders[k]);
        // Errors at rounding have no order.
        assert!(last[k] < 1e-12 || orders[k] > least[k], "{name} {quantity}");
        assert!(last[k] < most[k], "{name} {quantity}: {:.2e}", last[k]);
    }
}

#[test]
fn operators_converge_on_spheres() {
    let regular: Vec<Surface> = [4.0, 5.0]
        .map(|level| sample("icosphere", &[("level", level)]))
        .into();
    let least = [f64::INFINITY, 1.9, 1.9, 1.4, 1.9, 1.9];
    let most = [1e-13, 5e-4, 9e-4, 1.6e-3, 7e-4, 6e-4];
    check_orders("icosphere", &SPHERE, &regular, least, most);
    let random: Vec<Surface> = [4.0, 5.0]
        .map(|level| {
            let axes = [("a", 1.0), ("b", 1.0), ("c", 1.0)];
            let rest = [("level", level), ("jitter", 0.15)];
            sample("ellipsoid", &[&axes[..], &rest].concat())
        })
        .into();
    let least = [f64::INFINITY, 1.9, 1.9, 0.9, 1.9, 1.9];
    let most = [1e-12, 6e-4, 1.2e-3, 2.5e-2, 1e-3, 1e-3];
    check_orders("sphere, random", &SPHERE, &random, least, most);
}

#[test]
fn operators_converge_on_tori() {
    let sizes = [(64, 32), (128, 64), (256, 128)];
    let grids = sizes.map(|(around, tube)| torus(around, tube, 0.0, false));
    let most = [2e-4, 3e-4, 3.5e-4, 1e-3, 1.1e-3, 1.3e-3];
    check_orders("torus", &TORUS, &grids, [1.9; 6], most);
    let mixed = sizes.map(|(around, tube)| torus(around, tube, 0.0, true));
    let least = [1.8, 0.9, 0.9, 0.9, 1.8, 0.9];
    let most = [2e-4, 2.2e-3, 2e-3, 8e-3, 1.1e-3, 1.6e-2];
    check_orders("torus, random diagonals", &TORUS, &mixed, least, most);
    let random = sizes.map(|(around, tube)| torus(around, tube, 0.2, false));
    let most = [6e-4, 5e-3, 1e-2, 3e-2, 3e-3, 2e-2];
    check_orders("torus, random", &TORUS, &random, least, most);
}

#[test]
fn operators_converge_on_ellipsoids() {
    let random: Vec<Surface> = [4.0, 5.0]
        .map(|level| sample("ellipsoid", &[("level", level), ("jitter", 0.1)]))
        .into();
    let least = [1.8, 0.9, 0.9, 0.9, 1.8, 0.9];
    let most = [6e-4, 5e-3, 1e-2, 1.6e-2, 1.2e-3, 1.2e-2];
    check_orders("ellipsoid, random", &ELLIPSOID, &random, least, most);
}

#[test]
fn identities_hold_to_rounding() {
    let meshes = [
        sample("bumpy-sphere", &[("level", 3.0)]),
        torus(40, 20, 0.3, true),
        sample("monkey-saddle", &[("rings", 12.0)]),
        sample("tetrahedron", &[("level", 3.0)]),
        sample("dodecahedron", &[("level", 2.0)]),
    ];
    for (m, surface) in meshes.iter().enumerate() {
        let x = &surface.x;
        let operators = FittedOperators::everywhere(&surface.mesh, x);
        let ones = vec![1.0; x.len()];
        for v in 0..x.len() {
            let Some(row) = operators.row(v) else {
                panic!("mesh {m}: no fit at {v}")
            };
            let n = operators.normal(row);
            let laplacian = operators.laplacian_of_position(row, x);
            let terms = operators.laplacian(row).iter().zip(operators.members(row));
            let size: f64 = terms
                .map(|(w, &j)| w.abs() * x[j as usize].distance(x[v]))
                .sum();
            let h = operators.mean_curvature(row, x);
            assert!(
                laplacian.distance(-2.0 * h * n) < 1e-12 * size,
                "mesh {m}, vertex {v}: Δr is not −2Hn"
            );
            let weights = operators.laplacian(row);
            let sum: f64 = weights.iter().sum();
            let scale: f64 = weights.iter().map(|w| w.abs()).sum();
            assert!(sum.abs() < 1e-14 * scale);
            let sum: DVec3 = operators.gradient(row).iter().sum();
            let scale: f64 = operators.gradient(row).iter().map(|w| w.length()).sum();
            assert!(sum.length() < 1e-14 * scale);
            let sum: DVec3 = operators.diamond(row).iter().sum();
            let scale: f64 = operators.diamond(row).iter().map(|w| w.length()).sum();
            assert!(sum.length() <= 1e-14 * scale);
            assert_eq!(operators.laplacian_of(row, &ones), 0.0);
            assert!(
                operators
                    .gradient(row)
                    .iter()
                    .all(|w| w.dot(n).abs() < 1e-9 * w.length() + 1e-9)
            );
            // The gradient of the coordinates is the projection onto the tangent plane.
            let along = DVec3::new(0.3, -0.5, 0.8);
            let f: Vec<f64> = x.iter().map(|p| p.dot(along)).collect();
            let expected = along - along.dot(n) * n;
            assert!(operators.gradient_of(row, &f).distance(expected) < 1e-10);
        }
    }
}

#[test]
fn curvatures_change_with_orientation_and_scale_as_they_should() {
    let surface = sample("ellipsoid", &[("level", 3.0), ("jitter", 0.1)]);
    let operators = FittedOperators::everywhere(&surface.mesh, &surface.x);
    let scaled: Vec<DVec3> = surface.x.iter().map(|p| 1e3 * *p).collect();
    let large = FittedOperators::everywhere(&surface.mesh, &scaled);
    // Mirrored, its faces have their normals inside.
    let mirrored: Vec<DVec3> = surface
        .x
        .iter()
        .map(|p| *p * DVec3::new(-1.0, 1.0, 1.0))
        .collect();
    let inside = FittedOperators::everywhere(&surface.mesh, &mirrored);
    for v in 0..surface.x.len() {
        let row = operators.row(v).expect("a fit");
        let (h, k) = (
            operators.mean_curvature(row, &surface.x),
            operators.gauss_curvature(row, &surface.x),
        );
        assert!(h > 0.0, "H is positive where the normal points outward");
        assert!((large.mean_curvature(row, &scaled) * 1e3 - h).abs() < 1e-10 * h);
        assert!((large.gauss_curvature(row, &scaled) * 1e6 - k).abs() < 1e-10 * (1.0 + k.abs()));
        let back = inside.mean_curvature(row, &mirrored);
        assert!((back + h).abs() < 1e-10, "{back} {h}");
        assert!((inside.gauss_curvature(row, &mirrored) - k).abs() < 1e-10);
        assert!(large.has_stencils_of(&operators));
    }
}

/// The right stencil: 1-rings where they do, more where they do not.
#[test]
fn stencils_are_wider_only_where_they_must_be() {
    let sphere = sample("icosphere", &[("level", 3.0)]);
    let operators = FittedOperators::everywhere(&sphere.mesh, &sphere.x);
    for v in sphere.mesh.vertices() {
        let row = operators.row(v.index()).expect("a fit");
        assert_eq!(operators.members(row).len(), 1 + sphere.mesh.valence(v));
        assert_eq!(operators.members(row)[0], v.0);
    }
    let octahedron = sample("octahedron", &[("level", 3.0)]);
    let operators = FittedOperators::everywhere(&octahedron.mesh, &octahedron.x);
    for v in octahedron.mesh.vertices() {
        let (row, valence) = (
            operators.row(v.index()).expect("a fit"),
            octahedron.mesh.valence(v),
        );
        if valence == 4 {
            // Its flaps: the vertices across the four edges of the ring.
            assert_eq!(operators.members(row).len(), 1 + 8);
        }
    }
    let disk = sample("disk", &[("rings", 6.0)]);
    let operators = FittedOperators::everywhere(&disk.mesh, &disk.x);
    for v in disk
        .mesh
        .vertices()
        .filter(|&v| disk.mesh.is_boundary_vertex(v))
    {
        let row = operators.row(v.index()).expect("a fit");
        assert!(operators.members(row).len() > 1 + disk.mesh.valence(v));
        assert!(operators.mean_curvature(row, &disk.x).abs() < 1e-10);
    }
}

#[test]
fn where_there_is_no_quadratic_there_is_no_row() {
    let tetrahedron = sample("tetrahedron", &[("level", 0.0)]);
    let operators = FittedOperators::everywhere(&tetrahedron.mesh, &tetrahedron.x);
    assert_eq!(operators.n_rows(), 0);
    let mut sphere = sample("icosphere", &[("level", 2.0)]);
    sphere.x[17] = DVec3::splat(f64::NAN);
    let operators = FittedOperators::everywhere(&sphere.mesh, &sphere.x);
    assert_eq!(operators.row(17), None);
    let first = sphere.mesh.vertices().next().expect("a vertex");
    let mut sphere = sample("icosphere", &[("level", 2.0)]);
    let next = sphere.mesh.neighbours(first).next().expect("a neighbour");
    sphere.x[next.index()] = sphere.x[first.index()];
    let operators = FittedOperators::everywhere(&sphere.mesh, &sphere.x);
    assert_eq!(operators.row(first.index()), None);
}
