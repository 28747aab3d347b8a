//! Pre-fills: a free region replaced by the membrane its rim spans, or by a smooth surface
//! that also takes over tangent planes and curvature from its surroundings.

use super::FlowError;
use crate::linalg::{Method, Pattern, Solver};
use crate::mesh::{HalfedgeMesh, Vertex};
use crate::operator::polyharmonic;
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
    let mut solver = Solver::on_mesh(pattern.clone(), &points, pattern);
    solver.solve(&values, &rhs, &mut solution, 1e-12, Method::Direct)?;
    for (v, p) in moving.iter().zip(solution) {
        x[v.index()] = p;
    }
    Ok(())
}

/// L (M⁻¹L)² r = 0 takes over positions, tangent planes and curvature.
const SMOOTH_ORDER: usize = 3;

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
    for _ in 0..passes {
        polyharmonic::fill(mesh, x, free, SMOOTH_ORDER)?;
    }
    Ok(())
}

/// The free vertices of components with a held one, and the row of each vertex among them.
fn anchored(mesh: &HalfedgeMesh, free: &[bool]) -> (Vec<Option<u32>>, Vec<Vertex>) {
    let anchored = polyharmonic::anchored(mesh, free);
    let moving: Vec<Vertex> = mesh.vertices().filter(|v| anchored[v.index()]).collect();
    let mut row = vec![None; free.len()];
    for (r, v) in (0..).zip(&moving) {
        row[v.index()] = Some(r);
    }
    (row, moving)
}
