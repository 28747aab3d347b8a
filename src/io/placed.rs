//! Parts of a scene that are put in place once or several times.

use glam::{DAffine3, DVec3};

use super::assembly::Assembly;
use super::{Place, ReadError};

/// Bytes of memory that a scene may take at least, however small its file is,
const FEW: u64 = 1 << 26;
/// and for each byte of the file.
const RATIO: u64 = 8;

/// Puts copies of parts into one mesh. A few bytes could ask for any number of copies: the memory
/// they take is limited.
pub(super) struct Placed {
    left: u64,
    limit: u64,
}

impl Placed {
    pub(super) fn new(file: &[u8]) -> Self {
        let limit = FEW.max(RATIO * file.len() as u64);
        Self { left: limit, limit }
    }

    /// Makes sure that so many more vertices and triangles are allowed; each part that is placed
    /// takes some room as well.
    pub(super) fn check(
        &mut self,
        vertices: usize,
        triangles: usize,
        place: Place,
    ) -> Result<(), ReadError> {
        let more = 64 + 24 * vertices as u64 + 16 * triangles as u64;
        let Some(left) = self.left.checked_sub(more) else {
            return Err(ReadError::CountTooLarge {
                place,
                what: "bytes",
                count: self.limit - self.left + more,
                at_most: self.limit,
            });
        };
        self.left = left;
        Ok(())
    }

    /// A copy of vertices and of triangles that name them; one that is mirrored keeps its outside
    /// outside.
    pub(super) fn part(
        &mut self,
        positions: &[DVec3],
        triangles: &[[u32; 3]],
        transform: &DAffine3,
        place: Place,
        assembly: &mut Assembly,
    ) -> Result<(), ReadError> {
        self.check(positions.len(), triangles.len(), place)?;
        let first = assembly.n_vertices() as u32;
        for position in positions {
            assembly.vertex(transform.transform_point3(*position), place)?;
        }
        for triangle in triangles {
            let corners = turned(*triangle, transform).map(|corner| first + corner);
            assembly.face(&corners, place)?;
        }
        Ok(())
    }
}

/// A triangle whose outside is still outside once it is in place.
pub(super) fn turned([a, b, c]: [u32; 3], transform: &DAffine3) -> [u32; 3] {
    if transform.matrix3.determinant() < 0.0 {
        [b, a, c]
    } else {
        [a, b, c]
    }
}
