//! A limit on the memory that a file may ask for beyond the numbers that stand in it: by copies of
//! parts, by arrays that share bytes, by compression.

use super::{Place, ReadError};

/// Bytes that any file may ask for, however small it is.
const FEW: u64 = 1 << 26;

/// Bytes that are left.
pub(super) struct Budget {
    left: u64,
    limit: u64,
}

impl Budget {
    /// So many bytes for each byte of the file.
    pub(super) fn new(file: &[u8], ratio: u64) -> Self {
        let limit = FEW.max(ratio * file.len() as u64);
        Self { left: limit, limit }
    }

    /// Makes sure that so many more bytes are allowed.
    ///
    /// # Errors
    /// [`ReadError::CountTooLarge`].
    pub(super) fn take(&mut self, bytes: u64, place: Place) -> Result<(), ReadError> {
        let Some(left) = self.left.checked_sub(bytes) else {
            return Err(ReadError::CountTooLarge {
                place,
                what: "bytes",
                count: (self.limit - self.left).saturating_add(bytes),
                at_most: self.limit,
            });
        };
        self.left = left;
        Ok(())
    }

    /// The same for vertices and triangles of a part, which takes some room by itself.
    ///
    /// # Errors
    /// [`ReadError::CountTooLarge`].
    pub(super) fn part(
        &mut self,
        vertices: usize,
        triangles: usize,
        place: Place,
    ) -> Result<(), ReadError> {
        self.take(64 + 24 * vertices as u64 + 16 * triangles as u64, place)
    }
}
