//! Whether a mesh may need a repair, found without taking it apart.

use super::hash::{Mixed, Table};
use super::junction::Rims;
use super::{Weld, automatic, crossed, flat};
use crate::geometry::measure::edge_length;
use crate::mesh::HalfedgeMesh;
use glam::DVec3;
use std::hash::{Hash as _, Hasher as _};

/// Whether [`repair`](super::repair) might change a mesh: where this is false it changes nothing.
/// Linear in the number of elements, without a copy.
pub fn is_suspect(mesh: &HalfedgeMesh, x: &[DVec3], weld: Weld) -> bool {
    let mut corners = Vec::new();
    let mut has_flat = |f| {
        corners.clear();
        corners.extend(mesh.face_vertices(f).map(|v| v.0));
        flat::is_flat(&corners, x) || crossed::is_crossed(&corners, x)
    };
    if mesh.faces().any(&mut has_flat) || mesh.components().1 > 1 && has_twins(mesh, x) {
        return true;
    }
    !mesh.is_closed() && are_rims_suspect(mesh, x, weld)
}

deferred! {
    fn are_rims_suspect(mesh: &HalfedgeMesh, x: &[DVec3], weld: Weld) -> bool {
        let rims = rims(mesh, x, weld);
        rims.is_some_and(|rims| rims.is_suspect())
    }
}

deferred! {
    /// Whether two faces may lie on each other: their corners have the same places.
    fn has_twins(mesh: &HalfedgeMesh, x: &[DVec3]) -> bool {
        let place = |p: &DVec3| {
            let mut hasher = Mixed::default();
            (*p + 0.0).to_array().map(f64::to_bits).hash(&mut hasher);
            hasher.finish()
        };
        let places: Vec<u64> = x.iter().map(place).collect();
        // A sum of them that no order changes.
        let sum = |f| {
            let corners = mesh.face_vertices(f).map(|v| places[v.0 as usize]);
            corners.fold(0, u64::wrapping_add)
        };
        let mut seen = Table::default();
        mesh.faces().any(|f| seen.insert(sum(f), ()).is_some())
    }
}

/// A length within which a weld closes gaps that are wider than what [`Weld::Auto`] takes for none,
/// and narrow for the edges at them; `None` where there are none.
pub fn gap(mesh: &HalfedgeMesh, x: &[DVec3]) -> Option<f64> {
    if mesh.is_closed() {
        None
    } else {
        gap_between(mesh, x)
    }
}

deferred! {
    fn gap_between(mesh: &HalfedgeMesh, x: &[DVec3]) -> Option<f64> {
        rims(mesh, x, Weld::Auto)?.gap()
    }
}

fn rims<'a>(mesh: &HalfedgeMesh, x: &'a [DVec3], weld: Weld) -> Option<Rims<'a>> {
    let open = mesh.edges().filter(|&e| mesh.is_boundary_edge(e));
    let open: Vec<(u32, u32)> = open.map(|e| mesh.ends(e).map(|v| v.0).into()).collect();
    if open.is_empty() {
        return None;
    }
    let near = match weld {
        Weld::Off => None,
        Weld::Within(length) => Some(length.max(0.0)),
        Weld::Auto => {
            // A side of each face, as in a soup.
            let sides = mesh.edges().flat_map(|e| {
                let n = 2 - usize::from(mesh.is_boundary_edge(e));
                std::iter::repeat_n(edge_length(mesh, x, e), n)
            });
            automatic(x, sides.collect())
        }
    };
    Rims::new(open, x, near.unwrap_or(0.0))
}
