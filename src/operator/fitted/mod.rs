//! Differential operators by quadratic fits, after Xu [X06](crate::bibliography#x06).
//!
//! At a vertex i a function f is fitted by a quadratic polynomial f_i + f_u u + f_v v +
//! ½ f_uu u² + f_uv uv + ½ f_vv v² over local parameters (u, v) of its neighbours, through
//! f_i and by weighted least squares. The fit is linear in f, and so are the operators
//! that follow from it, the same for positions and for functions:
//!
//! ```math
//! (\nabla f)_i = \sum_j \nabla_{ij} f_j, \quad (\diamond f)_i = \sum_j \diamond_{ij} f_j, \quad
//! (\Delta f)_i = \sum_j \Delta_{ij} f_j, \quad K_i = \sum_j k_{ij} \, n_i \cdot r_j
//! ```
//!
//! with j over the vertex and its stencil. Pointwise, units 1/length, 1/length², 1/length²,
//! 1/length². Weights of ∇, ◇ and Δ sum to zero; Δr = −2Hn holds to rounding. Errors are
//! O(h²) for normals and ∇; for H, K, ◇ and Δ O(h²) on regular and O(h) on irregular
//! meshes. ΔH does not converge pointwise on irregular meshes.
//!
//! H and ◇ have this crate's sign: H > 0 on a sphere with outward normal, and ◇f = (2H −
//! S)∇f multiplies the derivative along each principal direction by the other curvature.
//! In the paper both have the opposite sign.

mod fit;
pub mod principal;
mod stencil;

use crate::interrupt::paced;
use crate::mesh::{HalfedgeMesh, Vertex};
use fit::Fit;
use glam::DVec3;
use std::ops::Range;
use stencil::Stencils;

/// The operators at some vertices of a triangle mesh, by rows.
#[derive(Clone, Debug, Default)]
pub struct FittedOperators {
    row_of_vertex: Vec<u32>,
    starts: Vec<u32>,
    members: Vec<u32>,
    laplacian: Vec<f64>,
    gradient: Vec<DVec3>,
    diamond: Vec<DVec3>,
    gauss: Vec<f64>,
    normal: Vec<DVec3>,
}

const NONE: u32 = u32::MAX;

impl FittedOperators {
    /// Fits at every vertex that `wanted` marks. There is no row where the neighbours do not
    /// determine a quadratic: too few, in special position, or not finite; nor where the work is
    /// given up before.
    pub fn fit(mesh: &HalfedgeMesh, x: &[DVec3], wanted: &[bool]) -> Self {
        let mut this = Self {
            row_of_vertex: vec![NONE; mesh.n_vertices()],
            starts: vec![0],
            ..Self::default()
        };
        let mut stencils = Stencils::new(mesh);
        let mut fit = Fit::default();
        for v in paced(mesh.vertices()).filter(|v| wanted[v.index()]) {
            if stencils.choose(x, v, &mut fit).is_some() {
                this.row_of_vertex[v.index()] = this.normal.len() as u32;
                this.push(x, v, stencils.members(), &fit);
            }
        }
        this
    }

    /// Fits at every vertex.
    pub fn everywhere(mesh: &HalfedgeMesh, x: &[DVec3]) -> Self {
        Self::fit(mesh, x, &vec![true; mesh.n_vertices()])
    }

    fn push(&mut self, x: &[DVec3], v: Vertex, members: &[u32], fit: &Fit) {
        let centre = self.members.len();
        self.members.push(v.0);
        self.members.extend_from_slice(members);
        self.starts.push(self.members.len() as u32);
        let n = self.members.len();
        self.laplacian.resize(n, 0.0);
        self.gauss.resize(n, 0.0);
        self.gradient.resize(n, DVec3::ZERO);
        self.diamond.resize(n, DVec3::ZERO);

        let differences = members.iter().map(|&j| x[j as usize] - x[v.index()]);
        let [ru, rv, ruu, ruv, rvv] = fit.derivatives(differences);
        let (e, f, g) = (ru.dot(ru), ru.dot(rv), rv.dot(rv));
        let det = e * g - f * f;
        let normal = ru.cross(rv).normalize();
        self.normal.push(normal);
        // First fundamental form inverted, second with the sign of the outward normal.
        let (g11, g12, g22) = (g / det, -f / det, e / det);
        let [l, m, n] = [ruu, ruv, rvv].map(|r| -r.dot(normal));
        let second = g11 * ruu + 2.0 * g12 * ruv + g22 * rvv;
        let (pu, pv) = (second.dot(ru), second.dot(rv));
        let (p1, p2) = (g11 * pu + g12 * pv, g12 * pu + g22 * pv);
        let (gu, gv) = (g11 * ru + g12 * rv, g12 * ru + g22 * rv);
        let (du, dv) = ((n * ru - m * rv) / det, (l * rv - m * ru) / det);
        for (k, [fu, fv, fuu, fuv, fvv]) in fit.functionals().enumerate() {
            let at = centre + 1 + k;
            let laplacian = g11 * fuu + 2.0 * g12 * fuv + g22 * fvv - p1 * fu - p2 * fv;
            self.laplacian[at] = laplacian;
            self.laplacian[centre] -= laplacian;
            let gauss = (2.0 * m * fuv - n * fuu - l * fvv) / (2.0 * det);
            self.gauss[at] = gauss;
            self.gauss[centre] -= gauss;
            let gradient = fu * gu + fv * gv;
            self.gradient[at] = gradient;
            self.gradient[centre] -= gradient;
            let diamond = fu * du + fv * dv;
            self.diamond[at] = diamond;
            self.diamond[centre] -= diamond;
        }
    }

    /// Row of a vertex, if it was fitted.
    pub fn row(&self, vertex: usize) -> Option<usize> {
        let row = self.row_of_vertex[vertex];
        (row != NONE).then_some(row as usize)
    }

    /// Number of rows.
    pub fn n_rows(&self) -> usize {
        self.normal.len()
    }

    fn range(&self, row: usize) -> Range<usize> {
        self.starts[row] as usize..self.starts[row + 1] as usize
    }

    /// The vertices of a row: its own first, then its stencil.
    pub fn members(&self, row: usize) -> &[u32] {
        &self.members[self.range(row)]
    }

    /// Weights Δ_ij, in the order of the members.
    pub fn laplacian(&self, row: usize) -> &[f64] {
        &self.laplacian[self.range(row)]
    }

    /// Weights ∇_ij.
    pub fn gradient(&self, row: usize) -> &[DVec3] {
        &self.gradient[self.range(row)]
    }

    /// Weights ◇_ij.
    pub fn diamond(&self, row: usize) -> &[DVec3] {
        &self.diamond[self.range(row)]
    }

    /// Weights k_ij, with which K_i = Σ_j k_ij n_i·r_j.
    pub fn gauss(&self, row: usize) -> &[f64] {
        &self.gauss[self.range(row)]
    }

    /// Unit normal of the fit, on the side of the faces' normals.
    pub fn normal(&self, row: usize) -> DVec3 {
        self.normal[row]
    }

    /// Δr, a vector of length 2|H| against the normal where H > 0.
    pub fn laplacian_of_position(&self, row: usize, x: &[DVec3]) -> DVec3 {
        let members = self.members(row);
        let centre = x[members[0] as usize];
        let terms = members.iter().zip(self.laplacian(row));
        terms.map(|(&j, w)| *w * (x[j as usize] - centre)).sum()
    }

    /// H = −½ n·Δr; the paper's H is the negative of it.
    pub fn mean_curvature(&self, row: usize, x: &[DVec3]) -> f64 {
        -0.5 * self.normal[row].dot(self.laplacian_of_position(row, x))
    }

    /// K = Σ k_ij n·r_j.
    pub fn gauss_curvature(&self, row: usize, x: &[DVec3]) -> f64 {
        let members = self.members(row);
        let centre = x[members[0] as usize];
        let terms = members.iter().zip(self.gauss(row));
        let sum: DVec3 = terms.map(|(&j, w)| *w * (x[j as usize] - centre)).sum();
        self.normal[row].dot(sum)
    }

    /// Δf.
    pub fn laplacian_of(&self, row: usize, f: &[f64]) -> f64 {
        self.apply(row, f, self.laplacian(row), 0.0)
    }

    /// ∇f, a tangent vector.
    pub fn gradient_of(&self, row: usize, f: &[f64]) -> DVec3 {
        self.apply(row, f, self.gradient(row), DVec3::ZERO)
    }

    /// ◇f, a tangent vector.
    pub fn diamond_of(&self, row: usize, f: &[f64]) -> DVec3 {
        self.apply(row, f, self.diamond(row), DVec3::ZERO)
    }

    fn apply<T>(&self, row: usize, f: &[f64], weights: &[T], zero: T) -> T
    where
        T: Copy + std::ops::Mul<f64, Output = T> + std::ops::Add<Output = T>,
    {
        let members = self.members(row);
        let centre = f[members[0] as usize];
        let terms = members.iter().zip(weights);
        terms.fold(zero, |sum, (&j, w)| sum + *w * (f[j as usize] - centre))
    }

    /// Whether another fit has the same stencils.
    pub fn has_stencils_of(&self, other: &Self) -> bool {
        self.starts == other.starts && self.members == other.members
    }
}
