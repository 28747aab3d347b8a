//! Which cells of VTK are faces of a surface.

use super::assembly::{Assembly, Tally};
use super::{Format, Oddity, Place, Read, ReadError};

/// Takes cells in as faces, and counts the rest.
pub(super) struct Cells {
    pub(super) assembly: Assembly,
    skipped: Tally,
}

impl Cells {
    pub(super) fn new() -> Self {
        Self {
            assembly: Assembly::new(),
            skipped: Tally::default(),
        }
    }

    /// A cell of VTK's type `kind`. Of one of higher order the corners make the face; its other
    /// vertices stay without one.
    pub(super) fn cell(
        &mut self,
        kind: u8,
        corners: &[u32],
        place: Place,
    ) -> Result<(), ReadError> {
        let first = |count: usize| &corners[..count.min(corners.len())];
        match (kind, corners) {
            (POLYGON | 5 | 9, _) => self.assembly.face(corners, place),
            (STRIP, _) => (1..=corners.len()).try_for_each(|end| {
                let so_far = &corners[..end];
                self.assembly.strip(so_far, place)
            }),
            // A pixel: in the order of its axes.
            (8, &[a, b, c, d, ..]) => self.assembly.face(&[a, b, d, c], place),
            // Triangles and quadrilaterals of second order, of Lagrange's and of Bézier's kind.
            (22 | 34 | 69 | 76, _) => self.assembly.face(first(3), place),
            (23 | 28 | 30 | 70 | 77, _) => self.assembly.face(first(4), place),
            // A polygon of second order: corners, then middles of sides.
            (36, _) => self.assembly.face(first(corners.len() / 2), place),
            // Nothing.
            (0, _) => Ok(()),
            _ => {
                self.skipped.count(place);
                Ok(())
            }
        }
    }

    /// Cells that are known to be none of a surface.
    pub(super) fn skip(&mut self, place: Place) {
        self.skipped.count(place);
    }

    pub(super) fn finish(self, format: Format) -> Result<Read, ReadError> {
        let other = |(count, first)| Oddity::OtherCells { count, first };
        let other = self.skipped.met().map(other);
        let mut read = self.assembly.finish(format)?;
        read.warnings.extend(other);
        Ok(read)
    }
}

/// VTK's type of a polygon.
pub(super) const POLYGON: u8 = 7;
/// That of a strip of triangles.
pub(super) const STRIP: u8 = 6;
