//! The parts every integrator of the circle flow works with.

use crate::energy::circle::star::StarMatrix;
use crate::energy::circle::{CircleEnergy, Evaluation};
use crate::flow::{Cost, FlowError};
use crate::linalg::{Method, Pattern, Solver};
use crate::mesh::HalfedgeMesh;
use glam::DVec3;
use web_time::Instant;

/// Vertex areas below this share of their mean weigh as much as it: a sliver must not
/// make the system singular.
const LEAST_AREA: f64 = 1e-3;

/// The residual of a direct solve that calls for refinement.
const TOLERANCE: f64 = 1e-6;

/// The residual of an iterative solve, whose step need not be more accurate than its linear
/// model: down to 1e-6 a flow takes as many steps.
const ITERATIVE_TOLERANCE: f64 = 1e-2;

/// Energy, matrix and solver over the free vertices.
pub(super) struct Problem {
    pub(super) energy: CircleEnergy,
    pub(super) matrix: StarMatrix,
    pub(super) solver: Solver,
    /// The free vertices, in row order.
    pub(super) vertex_of_row: Vec<u32>,
    /// Mean edge length at the start.
    pub(super) h: f64,
    /// K at the current positions, one value a slot.
    pub(super) stiffness: Vec<f64>,
    system: Vec<f64>,
    rhs: Vec<DVec3>,
}

impl Problem {
    pub(super) fn new(
        mesh: &HalfedgeMesh,
        energy: CircleEnergy,
        free: &[bool],
        x: &[DVec3],
        h: f64,
    ) -> Result<Self, FlowError> {
        let matrix = StarMatrix::new(&energy, free);
        let vertex_of_row: Vec<u32> = (0..free.len() as u32)
            .filter(|&v| free[v as usize])
            .collect();
        let points: Vec<DVec3> = vertex_of_row.iter().map(|&v| x[v as usize]).collect();
        let row = |v| matrix.row_of_vertex()[v];
        let ends = mesh.edges().map(|e| mesh.ends(e).map(|v| row(v.index())));
        let among_free = ends.filter(|[a, b]| *a != u32::MAX && *b != u32::MAX);
        let edges = Pattern::from_cliques(points.len(), among_free);
        let solver = Solver::on_mesh(matrix.pattern().clone(), &points, edges);
        Ok(Self {
            energy,
            matrix,
            solver,
            vertex_of_row,
            h,
            stiffness: Vec::new(),
            system: Vec::new(),
            rhs: Vec::new(),
        })
    }

    /// Frobenius norm over the free vertices.
    pub(super) fn gradient_norm(&self, gradient: &[DVec3]) -> f64 {
        self.rows(gradient)
            .map(DVec3::length_squared)
            .sum::<f64>()
            .sqrt()
    }

    /// The entries of a field at the free vertices, in row order.
    pub(super) fn rows<'a>(&'a self, field: &'a [DVec3]) -> impl Iterator<Item = DVec3> + 'a {
        self.vertex_of_row.iter().map(|&v| field[v as usize])
    }

    /// ⟨a, b⟩ over the free vertices.
    pub(super) fn dot(&self, a: &[DVec3], b: &[DVec3]) -> f64 {
        self.rows(a).zip(self.rows(b)).map(|(a, b)| a.dot(b)).sum()
    }

    /// A vector a row as a field over all `n` vertices, zero where they are held.
    pub(super) fn field(&self, rows: &[DVec3], n: usize) -> Vec<DVec3> {
        let mut field = vec![DVec3::ZERO; n];
        for (&v, row) in self.vertex_of_row.iter().zip(rows) {
            field[v as usize] = *row;
        }
        field
    }

    /// x + s d.
    pub(super) fn moved(&self, x: &[DVec3], d: &[DVec3], s: f64) -> Vec<DVec3> {
        let mut y = x.to_vec();
        for (&v, d) in self.vertex_of_row.iter().zip(d) {
            y[v as usize] += s * *d;
        }
        y
    }

    /// Diagonal of the mass matrix over the rows: 1, or area over mean area.
    pub(super) fn mass(&self, areas: Option<Vec<f64>>) -> Vec<f64> {
        let Some(areas) = areas else {
            return vec![1.0; self.vertex_of_row.len()];
        };
        let free: Vec<f64> = self
            .vertex_of_row
            .iter()
            .map(|&v| areas[v as usize])
            .collect();
        let mean = free.iter().sum::<f64>() / free.len() as f64;
        free.into_iter()
            .map(|a| (a / mean).max(LEAST_AREA))
            .collect()
    }

    /// Assembles K at the positions of `evaluation`.
    pub(super) fn assemble(&mut self, evaluation: &Evaluation, project: bool, cost: &mut Cost) {
        let watch = Instant::now();
        self.matrix
            .assemble(&evaluation.weights, project, &mut self.stiffness);
        cost.assemble += watch.elapsed().as_secs_f64();
    }

    /// Solves (M/dt + K) d = −field; `d` has one entry a row.
    pub(super) fn solve(
        &mut self,
        field: &[DVec3],
        mass: &[f64],
        dt: f64,
        method: Method,
        cost: &mut Cost,
    ) -> Result<Vec<DVec3>, FlowError> {
        self.system.clone_from(&self.stiffness);
        for (&slot, m) in self.matrix.pattern().diagonal_slots().iter().zip(mass) {
            self.system[slot as usize] += m / dt;
        }
        self.rhs.clear();
        self.rhs
            .extend(self.vertex_of_row.iter().map(|&v| -field[v as usize]));
        let mut d = vec![DVec3::ZERO; self.rhs.len()];
        let tolerance = match method {
            Method::Direct => TOLERANCE,
            Method::Multigrid => ITERATIVE_TOLERANCE,
        };
        let info = self
            .solver
            .solve(&self.system, &self.rhs, &mut d, tolerance, method)?;
        cost.add(&info);
        Ok(d)
    }
}
