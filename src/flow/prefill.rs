//! Pre-fills: a free region replaced by the membrane its rim spans, or by a smooth surface
//! that also takes over tangent planes and curvature from its surroundings.

use super::FlowError;
use crate::geometry::measure;
use crate::linalg::{Pattern, Refactor, Solver};
use crate::mesh::{HalfedgeMesh, Vertex};
use crate::operator::{Elements, Laplacian};
use glam::DVec3;

/// Moves every free vertex to the mean of its neighbours, all at once: the uniform
/// Laplacian vanishes on the free vertices, the others stay.
///
/// A region of flat, aligned quads starts on the kinks β = 0 of the circle energy; the
/// membrane is a generic, smooth start. Components without a held vertex are left alone,
/// as the membrane would be a point.
///
/// # Errors
/// [`FlowError::Linear`] if the system cannot be solved.
pub fn harmonic(mesh: &HalfedgeMesh, free: &[bool], x: &mut [DVec3]) -> Result<(), FlowError> {
    let (row, moving) = anchored(mesh, free);
    if moving.is_empty() {
        return Ok(());
    }
    let pairs = mesh.edges().filter_map(|e| {
        let [a, b] = mesh.ends(e);
        Some([row[a.index()]?, row[b.index()]?])
    });
    let pattern = Pattern::from_cliques(moving.len(), pairs);
    let mut values = vec![0.0; pattern.nnz()];
    let mut rhs = vec![DVec3::ZERO; moving.len()];
    for (r, &v) in moving.iter().enumerate() {
        for w in mesh.neighbours(v) {
            values[pattern.slot(r as u32, r as u32)] += 1.0;
            match row[w.index()] {
                // Each off-diagonal entry is met from both ends and stored once.
                Some(s) if (s as usize) < r => values[pattern.slot(r as u32, s)] -= 1.0,
                Some(_) => {}
                None => rhs[r] += x[w.index()],
            }
        }
    }
    let points: Vec<DVec3> = moving.iter().map(|v| x[v.index()]).collect();
    let mut solution = vec![DVec3::ZERO; moving.len()];
    Solver::new(pattern, Some(&points))?.solve(
        &values,
        &rhs,
        &mut solution,
        1e-12,
        Refactor::Always,
    )?;
    for (v, p) in moving.iter().zip(solution) {
        x[v.index()] = p;
    }
    Ok(())
}

/// Moves the free vertices to where [L (M⁻¹L)² r] vanishes on them: L the cotangent
/// Laplacian, M the lumped mass, both of the surface as it is; in each of some passes.
///
/// The linear counterpart of the minimum of ∫|∇H|² dA, and the start from which the
/// sixth-order flow converges best. Components without a held vertex are left alone.
///
/// # Errors
/// [`FlowError::Linear`] if the system cannot be solved, as where triangles have collapsed.
pub fn smooth(
    mesh: &HalfedgeMesh,
    free: &[bool],
    x: &mut [DVec3],
    passes: usize,
) -> Result<(), FlowError> {
    let (row, moving) = anchored(mesh, free);
    let Some(elements) = Elements::of(mesh).filter(|_| !moving.is_empty()) else {
        return Ok(());
    };
    let mut laplacian = Laplacian::new(&elements);
    let mut cube = Cube::new(free.len());
    let cliques = |cube: &mut Cube, laplacian: &Laplacian| -> Vec<[u32; 2]> {
        let mut pairs = Vec::new();
        for (r, &v) in moving.iter().enumerate() {
            cube.row(laplacian, None, v.index());
            let columns = cube.entries().filter_map(|(j, _)| row[j]);
            pairs.extend(columns.map(|column| [r as u32, column]));
        }
        pairs
    };
    let pattern = Pattern::from_cliques(moving.len(), cliques(&mut cube, &laplacian).iter());
    let points: Vec<DVec3> = moving.iter().map(|v| x[v.index()]).collect();
    let mut values = vec![0.0; pattern.nnz()];
    let mut solver = Solver::new(pattern.clone(), Some(&points))?;
    for _ in 0..passes {
        laplacian.assemble(&elements, x);
        let mass = measure::vertex_areas(mesh, x);
        let mut rhs = vec![DVec3::ZERO; moving.len()];
        for (r, &v) in moving.iter().enumerate() {
            cube.row(&laplacian, Some(&mass), v.index());
            for (j, weight) in cube.entries() {
                match row[j] {
                    // Symmetric: stored once.
                    Some(s) if s as usize <= r => {
                        values[pattern.slot(r as u32, s)] = weight;
                    }
                    Some(_) => {}
                    None => rhs[r] -= weight * x[j],
                }
            }
        }
        let mut solution: Vec<DVec3> = moving.iter().map(|v| x[v.index()]).collect();
        solver.solve(&values, &rhs, &mut solution, 1e-12, Refactor::Always)?;
        for (v, p) in moving.iter().zip(solution) {
            x[v.index()] = p;
        }
    }
    Ok(())
}

/// Rows of L (M⁻¹L)².
struct Cube {
    weights: Vec<f64>,
    is_touched: Vec<bool>,
    touched: Vec<u32>,
}

impl Cube {
    fn new(n: usize) -> Self {
        Self {
            weights: vec![0.0; n],
            is_touched: vec![false; n],
            touched: Vec::new(),
        }
    }

    /// Row `i`; without a mass its pattern only.
    fn row(&mut self, laplacian: &Laplacian, mass: Option<&[f64]>, i: usize) {
        self.clear();
        self.weights[i] = 1.0;
        self.is_touched[i] = true;
        self.touched.push(i as u32);
        for factor in 0..3 {
            let row: Vec<(usize, f64)> = self.entries().collect();
            self.clear();
            for (j, weight) in row {
                // L first, then twice M⁻¹L from the right.
                let weight = match mass {
                    Some(mass) if factor > 0 => weight / mass[j],
                    _ => weight,
                };
                for (&l, entry) in laplacian.members(j).iter().zip(laplacian.row(j)) {
                    if !self.is_touched[l as usize] {
                        self.is_touched[l as usize] = true;
                        self.touched.push(l);
                    }
                    self.weights[l as usize] += weight * entry;
                }
            }
        }
    }

    fn clear(&mut self) {
        for j in self.touched.drain(..) {
            self.weights[j as usize] = 0.0;
            self.is_touched[j as usize] = false;
        }
    }

    fn entries(&self) -> impl Iterator<Item = (usize, f64)> + '_ {
        let touched = self.touched.iter();
        touched.map(|&j| (j as usize, self.weights[j as usize]))
    }
}

/// The free vertices of components with a held one, and the row of each vertex among them.
fn anchored(mesh: &HalfedgeMesh, free: &[bool]) -> (Vec<Option<u32>>, Vec<Vertex>) {
    let (component, count) = mesh.components();
    let mut anchored = vec![false; count];
    for (v, _) in free.iter().enumerate().filter(|(_, f)| !**f) {
        anchored[component[v] as usize] = true;
    }
    let mut row = vec![None; free.len()];
    let mut moving = Vec::new();
    for v in mesh.vertices() {
        if free[v.index()] && anchored[component[v.index()] as usize] {
            row[v.index()] = Some(moving.len() as u32);
            moving.push(v);
        }
    }
    (row, moving)
}
