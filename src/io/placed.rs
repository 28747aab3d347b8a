//! Parts of a scene that are put in place.

use glam::DAffine3;

/// Bytes that copies of parts may take for each byte of the file.
pub(super) const COPIES: u64 = 8;

/// A triangle whose outside is still outside once it is in place, also where that mirrors it.
pub(super) fn turned([a, b, c]: [u32; 3], transform: &DAffine3) -> [u32; 3] {
    if transform.matrix3.determinant() < 0.0 {
        [b, a, c]
    } else {
        [a, b, c]
    }
}
