//! Mass matrices of surface elements: lumped, consistent, and a mixture of both.
//!
//! For a field f with values f_i at the vertices, fᵀ M f stands for ∫|f|² dA:
//!
//! ```math
//! \begin{aligned}
//! \text{consistent} && M_{ij} &= \int \varphi_i \varphi_j \, dA && f \text{ itself is interpolated by the hat functions } \varphi_i, \\
//! \text{lumped} && m_i &= \int \varphi_i \, dA && |f|^2 \text{ is,} \\
//! \text{mixed} && M_\alpha &= (1 - \alpha) \, \text{consistent} + \alpha \, \text{lumped.}
//! \end{aligned}
//! ```
//!
//! A square is convex: at no point does |Σ φ_i f_i|² exceed Σ φ_i |f_i|². So lumped −
//! consistent is positive semidefinite, and for any load b the dual norm bᵀ M⁻¹ b grows from
//! lumped to mixed to consistent. They part on loads that alternate from vertex to vertex: there
//! the consistent mass sees up to 4 times (triangles) or 9 times (parallelograms) what the
//! lumped one does.
//!
//! α = ¼ is where the leading errors of ∫|Y|² dA, M Y = −∇A, cancel on spheres of triangles, and
//! nearly so on spheres of quadrilaterals. In per cent of the exact value, of a sphere or of
//! the Clifford torus:
//!
//! | | α = 1 | ½ | ¼ | 0 |
//! | --- | --- | --- | --- | --- |
//! | icosphere, level 3 | −0.444 | −0.148 | +0.006 | +0.170 |
//! | cube as a sphere, 16² squares a face | −0.225 | −0.065 | +0.017 | +0.104 |
//! | torus, 40 × 24, triangles | −1.219 | −0.276 | +0.211 | +0.710 |
//! | torus, 36 × 18, quadrilaterals | −2.044 | −0.477 | +0.352 | +1.214 |
//! | the same, 36 × 24, sheared | −2.098 | −0.969 | −0.382 | +0.221 |

use super::element::Elements;
use crate::interrupt::{self, paced};
use crate::linalg::Entry;
use glam::DVec3;

/// Values of the hat functions at the midpoints of a triangle's edges: exact for products
/// of two linear functions.
const MIDPOINTS: [[f64; 4]; 3] = [
    [0.5, 0.5, 0.0, 0.0],
    [0.0, 0.5, 0.5, 0.0],
    [0.5, 0.0, 0.5, 0.0],
];

/// Square of the residual over that of b, both in the norm of the preconditioner, that ends
/// a solve.
const TOLERANCE: f64 = 1e-28;
/// Iterations of a solve at most. Scaled by its diagonal the consistent matrix has a condition
/// number of at most 4 on triangles of any shape and 9 on parallelograms, the mixed one of 2.3
/// and 4: 20 to 40 iterations do.
const MAX_ITERATIONS: usize = 200;

/// Which mass matrix.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mass {
    /// α = 1: diagonal.
    Lumped,
    /// α = ¼.
    Mixed,
    /// α = 0.
    Consistent,
}

impl Mass {
    /// α, the share of the lumped mass.
    pub fn lumped_share(self) -> f64 {
        match self {
            Self::Lumped => 1.0,
            Self::Mixed => 0.25,
            Self::Consistent => 0.0,
        }
    }

    /// Largest factor by which bᵀ M⁻¹ b can exceed its value with the lumped mass, on elements
    /// of that many corners: 1/(α + (1 − α) λ) with λ = ¼ of triangles and 1/9 of
    /// parallelograms, the least eigenvalue of the consistent mass of one element relative
    /// to its lumped mass.
    pub fn amplification(self, degree: usize) -> f64 {
        let least = if degree == 3 { 0.25 } else { 1.0 / 9.0 };
        let share = self.lumped_share();
        1.0 / (share + (1.0 - share) * least)
    }
}

/// The mass matrix of elements with given areas; applied, never assembled.
#[derive(Clone, Copy, Debug)]
pub struct MassMatrix<'a> {
    elements: &'a Elements,
    areas: &'a [f64],
    lumped: &'a [f64],
    /// α.
    share: f64,
}

impl<'a> MassMatrix<'a> {
    /// Of elements whose quadrature points, in order, stand for `areas`
    /// ([`Node::area`](super::Node::area), unit length²); `lumped` are the m_i by vertices.
    pub fn new(elements: &'a Elements, areas: &'a [f64], lumped: &'a [f64], mass: Mass) -> Self {
        Self {
            elements,
            areas,
            lumped,
            share: mass.lumped_share(),
        }
    }

    /// Values of the hat functions where the part of an element around its quadrature point
    /// `q` is sampled for the consistent mass; the samples weigh alike.
    pub fn samples(elements: &Elements, q: usize) -> &'static [[f64; 4]] {
        if elements.degree() == 3 {
            &MIDPOINTS
        } else {
            std::slice::from_ref(&elements.points()[q].shape)
        }
    }

    fn each_sample(&self, mut visit: impl FnMut(&[u32], &[f64; 4], f64)) {
        if self.share == 1.0 {
            return;
        }
        let points = self.elements.points().len();
        let areas = self.areas.chunks_exact(points);
        for (corners, areas) in paced(self.elements.corners().zip(areas)) {
            for (q, area) in areas.iter().enumerate() {
                let samples = Self::samples(self.elements, q);
                let weight = (1.0 - self.share) * area / samples.len() as f64;
                samples
                    .iter()
                    .for_each(|shape| visit(corners, shape, weight));
            }
        }
    }

    /// ∫ g(f) dA: g at the samples with the share 1 − α, at the vertices with α. With g = |·|²
    /// this is fᵀ M f.
    pub fn integrate(&self, f: &[DVec3], g: impl Fn(DVec3) -> f64) -> f64 {
        let vertices = f.iter().zip(self.lumped);
        let mut sum = self.share * vertices.map(|(f, m)| m * g(*f)).sum::<f64>();
        self.each_sample(|corners, shape, weight| {
            sum += weight * g(interpolate(f, corners, shape));
        });
        sum
    }

    /// ∫ φ_i g(f) dA, sampled likewise, for g with values or vectors. With g the identity this is M f; with g the gradient
    /// of a function it is the gradient of the latter's integral by the nodal values.
    pub fn load<T: Entry>(&self, f: &[DVec3], g: impl Fn(DVec3) -> T) -> Vec<T> {
        let vertices = f.iter().zip(self.lumped);
        let mut load: Vec<T> = vertices.map(|(f, m)| g(*f) * (self.share * m)).collect();
        self.each_sample(|corners, shape, weight| {
            let value = g(interpolate(f, corners, shape)) * weight;
            for (&v, phi) in corners.iter().zip(shape) {
                load[v as usize] += value * *phi;
            }
        });
        load
    }

    /// M f.
    pub fn multiply(&self, f: &[DVec3]) -> Vec<DVec3> {
        if self.elements.degree() != 3 {
            return self.load(f, |f| f);
        }
        // The element matrix is area/12 times (1 + δ_ij).
        let vertices = f.iter().zip(self.lumped);
        let mut image: Vec<DVec3> = vertices.map(|(f, m)| self.share * *m * *f).collect();
        if self.share < 1.0 {
            for (corners, area) in self.elements.corners().zip(self.areas) {
                let weight = (1.0 - self.share) * area / 12.0;
                let sum: DVec3 = corners.iter().map(|&v| f[v as usize]).sum();
                for &v in corners {
                    image[v as usize] += weight * (sum + f[v as usize]);
                }
            }
        }
        image
    }

    /// Solves M y = b, from `y`, by conjugate gradients to near roundoff, whatever the unit of
    /// length. Where not `is_free`, and where the mass vanishes, y stays as it is.
    /// Tells the number of iterations.
    pub fn solve(&self, b: &[DVec3], y: &mut [DVec3], is_free: impl Fn(usize) -> bool) -> usize {
        let mut diagonal: Vec<f64> = self.lumped.iter().map(|m| self.share * m).collect();
        self.each_sample(|corners, shape, weight| {
            for (&v, phi) in corners.iter().zip(shape) {
                diagonal[v as usize] += weight * phi * phi;
            }
        });
        let inverse: Vec<f64> = diagonal
            .iter()
            .enumerate()
            .map(|(i, d)| {
                if *d > 0.0 && is_free(i) {
                    d.recip()
                } else {
                    0.0
                }
            })
            .collect();
        // No direction then leaves the free vertices.
        let precondition =
            |r: &[DVec3]| -> Vec<DVec3> { r.iter().zip(&inverse).map(|(r, d)| *d * *r).collect() };
        let image = self.multiply(y);
        let mut residual: Vec<DVec3> = b.iter().zip(&image).map(|(b, q)| *b - *q).collect();
        let mut direction = precondition(&residual);
        let mut rho = dot(&residual, &direction);
        let enough = TOLERANCE * dot(b, &precondition(b));
        for iteration in 0..MAX_ITERATIONS {
            if rho <= enough || rho.is_nan() || interrupt::check().is_err() {
                return iteration;
            }
            let image = self.multiply(&direction);
            let step = rho / dot(&direction, &image);
            for (y, p) in y.iter_mut().zip(&direction) {
                *y += step * *p;
            }
            for (r, q) in residual.iter_mut().zip(&image) {
                *r -= step * *q;
            }
            let z = precondition(&residual);
            let before = std::mem::replace(&mut rho, dot(&residual, &z));
            for (p, z) in direction.iter_mut().zip(z) {
                *p = z + rho / before * *p;
            }
        }
        MAX_ITERATIONS
    }
}

/// Σ φ_k f_k over the corners of an element, for hat functions of these values.
pub fn interpolate(f: &[DVec3], corners: &[u32], shape: &[f64; 4]) -> DVec3 {
    let terms = corners.iter().zip(shape);
    terms.map(|(&v, phi)| *phi * f[v as usize]).sum()
}

fn dot(a: &[DVec3], b: &[DVec3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.dot(*b)).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::build;
    use crate::soup::PolygonSoup;

    /// Elements, areas and lumped masses of these faces.
    struct Measured {
        elements: Elements,
        areas: Vec<f64>,
        lumped: Vec<f64>,
    }

    impl Measured {
        fn of(positions: &[DVec3], faces: &[Vec<u32>]) -> Self {
            let soup = PolygonSoup::from_faces(positions.to_vec(), faces);
            let built = build(&soup).expect("a surface");
            let elements = Elements::of(&built.mesh).expect("one kind");
            let (mut areas, mut lumped) = (Vec::new(), vec![0.0; positions.len()]);
            for (e, corners) in elements.corners().enumerate() {
                for node in elements.nodes(&built.positions, e) {
                    areas.push(node.area);
                    for (&v, phi) in corners.iter().zip(node.shape) {
                        lumped[v as usize] += node.area * phi;
                    }
                }
            }
            Self {
                elements,
                areas,
                lumped,
            }
        }

        /// A rectangular grid of n × n vertices, sheared, `squares` or each cut into two
        /// triangles, its vertices moved by a function of their number.
        fn grid(n: u32, squares: bool, moved: impl Fn(u32) -> DVec3) -> Self {
            let at = |i: u32, j: u32| i * n + j;
            let point = |v: u32| {
                let (i, j) = (f64::from(v / n), f64::from(v % n));
                DVec3::new(i + 0.5 * j, 0.75f64.sqrt() * j, 0.0) + moved(v)
            };
            let mut faces = Vec::new();
            for i in 0..n - 1 {
                for j in 0..n - 1 {
                    let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
                    if squares {
                        faces.push(vec![a, b, c, d]);
                    } else {
                        faces.extend([vec![a, b, d], vec![b, c, d]]);
                    }
                }
            }
            Self::of(&(0..n * n).map(point).collect::<Vec<_>>(), &faces)
        }

        fn matrix(&self, mass: Mass) -> MassMatrix<'_> {
            MassMatrix::new(&self.elements, &self.areas, &self.lumped, mass)
        }
    }

    const MASSES: [Mass; 3] = [Mass::Lumped, Mass::Mixed, Mass::Consistent];

    fn wave(v: usize) -> DVec3 {
        let v = v as f64;
        DVec3::new((1.7 * v).sin(), (2.9 * v).cos(), (0.6 * v * v).sin())
    }

    fn rough(v: u32) -> DVec3 {
        0.2 * wave(v as usize)
    }

    fn column(matrix: &MassMatrix<'_>, n: usize, j: usize) -> Vec<f64> {
        let mut unit = vec![DVec3::ZERO; n];
        unit[j] = DVec3::X;
        matrix.multiply(&unit).iter().map(|p| p.x).collect()
    }

    #[test]
    fn one_element_has_the_textbook_matrix() {
        let corners = [
            DVec3::ZERO,
            2.0 * DVec3::X,
            DVec3::new(2.0, 3.0, 0.0),
            3.0 * DVec3::Y,
        ];
        let triangle = Measured::of(&corners[..3], &[vec![0, 1, 2]]);
        let square = Measured::of(&corners, &[vec![0, 1, 2, 3]]);
        // area/12 (1 + δ_ij); area/36 times 4, 2 along an edge, 1 across.
        let cases: [(&Measured, usize, &[f64]); 2] = [
            (&triangle, 0, &[0.5, 0.25, 0.25]),
            (&square, 1, &[2.0 / 6.0, 4.0 / 6.0, 2.0 / 6.0, 1.0 / 6.0]),
        ];
        for (measured, j, expected) in cases {
            let found = column(&measured.matrix(Mass::Consistent), expected.len(), j);
            for (f, e) in found.iter().zip(expected) {
                assert!((f - e).abs() < 1e-14, "{found:?}");
            }
            let mixed = column(&measured.matrix(Mass::Mixed), expected.len(), j);
            for (i, (f, e)) in mixed.iter().zip(expected).enumerate() {
                let lumped = if i == j { measured.lumped[j] } else { 0.0 };
                assert!((f - (0.75 * e + 0.25 * lumped)).abs() < 1e-14, "{mixed:?}");
            }
        }
    }

    #[test]
    fn a_solve_undoes_a_product_in_few_iterations_at_any_scale() {
        for (squares, most) in [(false, 40), (true, 70)] {
            let mut measured = Measured::grid(12, squares, rough);
            let expected: Vec<DVec3> = (0..144).map(wave).collect();
            for scale in [1.0, 1e-24, 1e24] {
                measured.areas.iter_mut().for_each(|a| *a *= scale);
                measured.lumped.iter_mut().for_each(|m| *m *= scale);
                for mass in MASSES {
                    let matrix = measured.matrix(mass);
                    let b = matrix.multiply(&expected);
                    let by_load = matrix.load(&expected, |f| f);
                    for (b, l) in b.iter().zip(&by_load) {
                        assert!((*b - *l).length() <= 1e-14 * l.length());
                    }
                    let mut y = vec![DVec3::ZERO; 144];
                    let iterations = matrix.solve(&b, &mut y, |_| true);
                    println!("{mass:?}, squares {squares}: {iterations} iterations");
                    assert!(iterations <= most, "{mass:?}: {iterations}");
                    for (y, e) in y.iter().zip(&expected) {
                        assert!((*y - *e).length() < 1e-12, "{mass:?}: {y}, not {e}");
                    }
                }
                measured.areas.iter_mut().for_each(|a| *a /= scale);
                measured.lumped.iter_mut().for_each(|m| *m /= scale);
            }
        }
    }

    #[test]
    fn held_values_stay_and_vertices_without_mass_do_no_harm() {
        let mut measured = Measured::grid(6, false, rough);
        let held = |v: usize| v.is_multiple_of(5);
        let expected: Vec<DVec3> = (0..36).map(wave).collect();
        let b = measured.matrix(Mass::Mixed).multiply(&expected);
        let mut y: Vec<DVec3> = expected
            .iter()
            .enumerate()
            .map(|(v, e)| if held(v) { *e } else { DVec3::ZERO })
            .collect();
        measured.matrix(Mass::Mixed).solve(&b, &mut y, |v| !held(v));
        for (v, (y, e)) in y.iter().zip(&expected).enumerate() {
            assert!((*y - *e).length() < 1e-12 && (!held(v) || y == e));
        }
        measured.areas.fill(0.0);
        measured.lumped.fill(0.0);
        let mut y = expected.clone();
        for mass in MASSES {
            assert_eq!(measured.matrix(mass).solve(&b, &mut y, |_| true), 0);
            assert_eq!(y, expected);
        }
    }

    /// fᵀ M f lies between that of the lumped mass over the amplification and the lumped; a
    /// field that takes three values in turn, or two, is at the lower end.
    #[test]
    fn the_amplification_is_the_largest_there_is() {
        // 3 divides the number of vertices a row less the row's own shear of 1: f depends on
        // i − j only, and takes all three values in each triangle.
        let n = 12u32;
        for squares in [false, true] {
            let still = Measured::grid(n, squares, |_| DVec3::ZERO);
            let moved = Measured::grid(n, squares, rough);
            let degree = if squares { 4 } else { 3 };
            let steepest: Vec<DVec3> = (0..n * n)
                .map(|v| {
                    let (i, j) = (v / n, v % n);
                    if squares {
                        DVec3::X * (1.0 - 2.0 * f64::from((i + j) % 2))
                    } else {
                        let turn = f64::from((i + 2 * j) % 3) * std::f64::consts::TAU / 3.0;
                        DVec3::new(turn.cos(), turn.sin(), 0.0)
                    }
                })
                .collect();
            for mass in MASSES {
                let form = |measured: &Measured, mass: Mass, f: &[DVec3]| {
                    measured.matrix(mass).integrate(f, |f| f.length_squared())
                };
                let ratio = |measured: &Measured, f: &[DVec3]| {
                    form(measured, Mass::Lumped, f) / form(measured, mass, f)
                };
                let bound = mass.amplification(degree);
                let found = ratio(&still, &steepest);
                assert!((found / bound - 1.0).abs() < 1e-12, "{mass:?}: {found}");
                for k in 0..50 {
                    let f: Vec<DVec3> = (0..144).map(|v| wave(v + 1000 * k)).collect();
                    for measured in [&still, &moved] {
                        let found = ratio(measured, &f);
                        // Squares that are no parallelograms may exceed the bound; not here.
                        assert!(
                            (1.0..=bound).contains(&(found * (1.0 + 1e-14)))
                                || mass == Mass::Lumped
                        );
                        let product: f64 = measured
                            .matrix(mass)
                            .multiply(&f)
                            .iter()
                            .zip(&f)
                            .map(|(q, f)| q.dot(*f))
                            .sum();
                        let direct = form(measured, mass, &f);
                        assert!((product / direct - 1.0).abs() < 1e-13);
                    }
                }
            }
        }
    }
}
