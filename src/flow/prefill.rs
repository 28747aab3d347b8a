//! Harmonic pre-fill: a free region replaced by the membrane its rim spans.

use super::FlowError;
use crate::linalg::{Pattern, Refactor, Solver};
use crate::mesh::HalfedgeMesh;
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
