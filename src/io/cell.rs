//! Cells of VTK and elements of Gmsh: which are faces of a surface.

use super::assembly::{Assembly, Tally};
use super::solid::{Solid, Solids};
use super::{Format, Oddity, Place, Read, ReadError};

/// Takes cells in as faces, and counts the rest. Where there is no face, the cells with a volume
/// give theirs.
pub(super) struct Cells {
    pub(super) assembly: Assembly,
    solids: Solids,
    volumes: Tally,
    skipped: Tally,
}

impl Cells {
    pub(super) fn new() -> Self {
        Self {
            assembly: Assembly::new(),
            solids: Solids::default(),
            volumes: Tally::default(),
            skipped: Tally::default(),
        }
    }

    /// A cell of VTK's type `kind`. One of second order is cut at its nodes; of one of a higher
    /// order, or of Bézier's kind, the corners make the face, and other nodes stay without one.
    pub(super) fn cell(
        &mut self,
        kind: u8,
        corners: &[u32],
        place: Place,
    ) -> Result<(), ReadError> {
        let first = |count: usize| &corners[..count.min(corners.len())];
        match (kind, corners.len()) {
            (22, 6..) | (69, 6) => return self.pieces(SECOND_ORDER_TRIANGLE, corners, place),
            (34 | 69, 7) => return self.pieces(TRIANGLE_WITH_CENTRE, corners, place),
            (23, 8..) | (70, 8) => return self.pieces(SERENDIPITY, corners, place),
            (28, 9..) | (70, 9) => return self.pieces(SECOND_ORDER_SQUARE, corners, place),
            (30, 6..) => return self.pieces(LINEAR_BY_SECOND_ORDER, corners, place),
            _ => {}
        }
        match (kind, corners) {
            (POLYGON | 5 | 9, _) => self.assembly.face(corners, place),
            (STRIP, _) => (1..=corners.len()).try_for_each(|end| {
                let so_far = &corners[..end];
                self.assembly.strip(so_far, place)
            }),
            // A pixel: in the order of its axes.
            (8, &[a, b, c, d, ..]) => self.assembly.face(&[a, b, d, c], place),
            // Triangles and quadrilaterals of Lagrange's and of Bézier's kind, and such as lack nodes.
            (22 | 34 | 69 | 76, _) => self.assembly.face(first(3), place),
            (23 | 28 | 30 | 70 | 77, _) => self.assembly.face(first(4), place),
            // A polygon of second order: corners, then middles of sides.
            (36, _) => {
                let (ends, middles) = corners.split_at(corners.len() / 2);
                let around = ends.iter().zip(middles).flat_map(|(&a, &b)| [a, b]);
                self.assembly.face(&around.collect::<Vec<_>>(), place)
            }
            (10 | 24 | 71 | 78, _) => self.solid(Solid::Tetrahedron, corners, place),
            (12 | 25 | 29 | 33 | 72 | 79, _) => self.solid(Solid::Hexahedron, corners, place),
            (13 | 26 | 31 | 32 | 73 | 80, _) => self.solid(Solid::Wedge, corners, place),
            (14 | 27 | 37 | 74, _) => self.solid(Solid::Pyramid, corners, place),
            // A voxel: in the order of its axes.
            (11, &[a, b, c, d, e, f, g, h, ..]) => {
                self.solid(Solid::Hexahedron, &[a, b, d, c, e, f, h, g], place)
            }
            // Nothing.
            (0, _) => Ok(()),
            _ => {
                self.skipped.count(place);
                Ok(())
            }
        }
    }

    /// The faces that an element is cut into, each by its corners among the element's nodes.
    pub(super) fn pieces(
        &mut self,
        pieces: Pieces,
        nodes: &[u32],
        place: Place,
    ) -> Result<(), ReadError> {
        let mut corners = [0; 4];
        for piece in pieces {
            for (corner, &node) in corners.iter_mut().zip(*piece) {
                *corner = nodes[node];
            }
            self.assembly.face(&corners[..piece.len()], place)?;
        }
        Ok(())
    }

    /// A cell with a volume. Once there is a face, none gives its own.
    ///
    /// # Errors
    /// [`ReadError::CountTooLarge`] past 2³² corners.
    pub(super) fn solid(
        &mut self,
        solid: Solid,
        corners: &[u32],
        place: Place,
    ) -> Result<(), ReadError> {
        if !self.wants_solid(place) {
            return Ok(());
        }
        self.solids.push(solid, corners);
        self.assembly.check_corners(self.solids.n_corners(), place)
    }

    /// A polyhedron, from the number of its faces and, of each, the number of its corners and these,
    /// counted from a first vertex. One that ends before is none.
    ///
    /// # Errors
    /// [`ReadError::IndexOutOfRange`], [`ReadError::CountTooLarge`].
    pub(super) fn polyhedron(
        &mut self,
        numbers: &[f64],
        first: usize,
        format: Format,
        place: Place,
    ) -> Result<(), ReadError> {
        if !self.wants_solid(place) {
            return Ok(());
        }
        // A negative one is none, also where vertices go before the first.
        let index = |&corner: &f64| {
            let own = self.assembly.index(corner, format, place)?;
            let number = f64::from(own) + first as f64;
            self.assembly.index(number, format, place)
        };
        let faces = faces_of(numbers).unwrap_or_default().into_iter();
        let faces = faces.map(|face| face.iter().map(index).collect());
        let faces: Vec<Vec<u32>> = faces.collect::<Result<_, _>>()?;
        self.solids.push_polyhedron(&faces);
        self.assembly.check_corners(self.solids.n_corners(), place)
    }

    /// Counts a cell with a volume; says whether it may still be needed.
    fn wants_solid(&mut self, place: Place) -> bool {
        self.volumes.count(place);
        let wants = self.assembly.n_faces() == 0;
        if !wants {
            self.solids.clear();
        }
        wants
    }

    /// Cells that are known to be none of a surface.
    pub(super) fn skip(&mut self, place: Place) {
        self.skipped.count(place);
    }

    pub(super) fn finish(mut self, format: Format) -> Result<Read, ReadError> {
        let mut oddities = Vec::new();
        match self.volumes.met() {
            Some((count, first)) if self.assembly.n_faces() == 0 => {
                for face in self.solids.boundary(self.assembly.positions()) {
                    self.assembly.face(&face, first)?;
                }
                oddities.push(Oddity::SolidCells { count });
            }
            _ => self.skipped.add(&self.volumes),
        }
        let other = |(count, first)| Oddity::OtherCells { count, first };
        oddities.extend(self.skipped.met().map(other));
        let mut read = self.assembly.finish(format)?;
        read.warnings.extend(oddities);
        Ok(read)
    }
}

/// The faces of a polyhedron.
fn faces_of(numbers: &[f64]) -> Option<Vec<&[f64]>> {
    let (&count, mut rest) = numbers.split_first()?;
    let mut faces = Vec::new();
    while (faces.len() as f64) < count {
        let (&n, corners) = rest.split_first()?;
        let (face, others) = corners.split_at_checked(n as usize)?;
        faces.push(face);
        rest = others;
    }
    Some(faces)
}

/// Faces as corners among the nodes of an element.
pub(super) type Pieces = &'static [&'static [usize]];

/// Nodes of second order are corners, then middles of sides, then what is within; VTK and Gmsh
/// number them alike.
pub(super) const SECOND_ORDER_TRIANGLE: Pieces = &[&[0, 3, 5], &[3, 1, 4], &[5, 4, 2], &[3, 4, 5]];
const TRIANGLE_WITH_CENTRE: Pieces = &[
    &[0, 3, 6],
    &[3, 1, 6],
    &[1, 4, 6],
    &[4, 2, 6],
    &[2, 5, 6],
    &[5, 0, 6],
];
/// Without a node in the middle.
pub(super) const SERENDIPITY: Pieces = &[
    &[0, 4, 7],
    &[4, 1, 5],
    &[5, 2, 6],
    &[6, 3, 7],
    &[4, 5, 6, 7],
];
pub(super) const SECOND_ORDER_SQUARE: Pieces =
    &[&[0, 4, 8, 7], &[4, 1, 5, 8], &[8, 5, 2, 6], &[7, 8, 6, 3]];
/// With middles of the first side and of the one across.
const LINEAR_BY_SECOND_ORDER: Pieces = &[&[0, 4, 5, 3], &[4, 1, 2, 5]];

/// VTK's type of a polyhedron.
pub(super) const POLYHEDRON: u8 = 42;
/// VTK's type of a polygon.
pub(super) const POLYGON: u8 = 7;
/// That of a strip of triangles.
pub(super) const STRIP: u8 = 6;
