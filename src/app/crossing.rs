//! Where the surface passes through itself, for the diagnosis card and for marks on it.

use super::Session;
use super::fault::Fault;
use crate::arrays::TypedArray;
use crate::geometry::self_intersection;
use crate::mesh::HalfedgeMesh;
use glam::DVec3;
use serde::Serialize;

/// Boxes that the diagnosis card compares at most: measured, a second in wasm for a heap of
/// triangles in one place, and half of one for a mesh of some 300,000 triangles, each of which
/// takes 23 to 28.
const BRIEF: usize = 8_000_000;
/// The same where it is asked for.
const PATIENT: usize = 8 * BRIEF;

/// The same after every step: about a twentieth of a second.
const SWIFT: usize = BRIEF / 16;

/// The curves along which the surface passes through itself, as segments; none where looking for them
/// would take more than about a second.
pub(super) fn curves(mesh: &HalfedgeMesh, x: &[DVec3]) -> Vec<[DVec3; 2]> {
    self_intersection::curves_within(mesh, x, BRIEF).unwrap_or_default()
}

/// The triangles that pass through each other.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct SelfIntersections {
    /// Two triangles a pair, the smaller number first; sorted.
    pub pairs: TypedArray<u32>,
    /// The triangles of all pairs, each once; sorted.
    pub triangles: TypedArray<u32>,
}

/// Number of pairs, see [`self_intersection`]; `None` where that would take more than about a
/// second.
pub(super) fn count(mesh: &HalfedgeMesh, x: &[DVec3]) -> Option<usize> {
    self_intersection::pairs_within(mesh, x, BRIEF).map(|pairs| pairs.len())
}

/// Number of pairs after a step, of a surface that passed through itself at the start, as `crosses`
/// says; `None` where it did not, or looking for them would take long.
pub(super) fn count_after_step(crosses: bool, mesh: &HalfedgeMesh, x: &[DVec3]) -> Option<usize> {
    let pairs = || self_intersection::pairs_within(mesh, x, SWIFT);
    crosses.then(pairs).flatten().map(|pairs| pairs.len())
}

impl Session {
    /// The triangles of the surface as it is now that pass through each other; `None` where there
    /// are too many near each other to be compared in a few seconds. See [`self_intersection`] for
    /// what counts.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn self_intersections(&self) -> Result<Option<SelfIntersections>, Fault> {
        let runner = self.runner()?;
        let found = self_intersection::pairs_within(runner.triangles(), &runner.x, PATIENT);
        Ok(found.map(|pairs| SelfIntersections {
            triangles: self_intersection::triangles(&pairs)
                .into_iter()
                .map(|f| f.0)
                .collect(),
            pairs: pairs.into_iter().flatten().map(|f| f.0).collect(),
        }))
    }
}
