//! Corners at exactly the same position become one vertex, for formats that cannot say which
//! corners share one.

use std::collections::BTreeMap;

use glam::DVec3;

use super::assembly::Assembly;
use super::{Place, ReadError};

/// Joins corners at the same position, numbered by first use.
pub(super) struct Weld {
    pub(super) assembly: Assembly,
    vertex_at: BTreeMap<[u64; 3], u32>,
    /// Corners met, joined or not.
    met: usize,
}

impl Weld {
    pub(super) fn new() -> Self {
        Self {
            assembly: Assembly::new(),
            vertex_at: BTreeMap::new(),
            met: 0,
        }
    }

    /// The vertex at a position.
    pub(super) fn corner(&mut self, position: DVec3, place: Place) -> Result<u32, ReadError> {
        // Adding zero makes -0 and 0 one position.
        let position = position + DVec3::ZERO;
        let bits = position.to_array().map(f64::to_bits);
        let next = self.assembly.n_vertices() as u32;
        let vertex = *self.vertex_at.entry(bits).or_insert(next);
        if vertex == next {
            if !position.is_finite() {
                let number = self.met + 1;
                return Err(ReadError::NonFiniteVertex { number, place });
            }
            self.assembly.vertex(position, place)?;
        }
        self.met += 1;
        Ok(vertex)
    }

    /// Nothing that comes later is joined to what was met so far.
    pub(super) fn forget(&mut self) {
        self.vertex_at.clear();
    }
}
