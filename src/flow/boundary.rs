//! Which vertices move: the boundary condition together with any selection.

use super::FlowError;
use crate::energy::circle::Boundary;
use crate::mesh::{HalfedgeMesh, Vertex};

/// `true` for every vertex that is free to move.
///
/// `Clamped` holds the boundary vertices and those within one edge of them, `Fixed` the
/// boundary vertices. Of the rest, those in `free` move if it is given, and those in
/// `fixed` do not.
///
/// # Errors
/// [`FlowError::SelectionOutOfRange`], [`FlowError::NothingFree`].
pub fn free_vertices(
    mesh: &HalfedgeMesh,
    boundary: Boundary,
    free: Option<&[u32]>,
    fixed: Option<&[u32]>,
) -> Result<Vec<bool>, FlowError> {
    let vertices = mesh.n_vertices();
    let lists = free.into_iter().chain(fixed).flatten();
    if let Some(&vertex) = lists.into_iter().find(|&&v| v as usize >= vertices) {
        return Err(FlowError::SelectionOutOfRange { vertex, vertices });
    }
    let mut moves = vec![free.is_none(); vertices];
    for &v in free.unwrap_or_default() {
        moves[v as usize] = true;
    }
    for &v in fixed.unwrap_or_default() {
        moves[v as usize] = false;
    }
    let on_boundary = |v: Vertex| mesh.is_boundary_vertex(v);
    for v in mesh.vertices() {
        let held = match boundary {
            Boundary::Free => false,
            Boundary::Fixed => on_boundary(v),
            Boundary::Clamped => on_boundary(v) || mesh.neighbours(v).any(on_boundary),
        };
        moves[v.index()] &= !held;
    }
    if moves.contains(&true) {
        Ok(moves)
    } else {
        Err(FlowError::NothingFree)
    }
}
