//! Polygon soup: positions and faces as lists of corner indices, with no adjacency.
//!
//! What the readers in [`crate::io`] produce and the writers consume, and what
//! [`crate::mesh`] builds connectivity from. It makes no promise beyond its own
//! index ranges: faces may repeat, be degenerate or meet in a non-manifold way.

mod diagonals;
mod triangulate;

pub(crate) use triangulate::cut_bridged;

use glam::DVec3;

/// Red, green, blue and opacity from 0 to 1, as they are shown on a screen (sRGB).
pub type Colour = [f32; 4];

/// Positions and polygonal faces of any degree.
///
/// Faces are stored end to end: the corners of face `f` are
/// `corners[face_starts[f]..face_starts[f + 1]]`, so `face_starts` has one entry
/// more than there are faces and begins with 0.
#[derive(Clone, Debug, PartialEq)]
pub struct PolygonSoup {
    /// Position of each vertex.
    pub positions: Vec<DVec3>,
    /// Vertex index of each corner, face after face.
    pub corners: Vec<u32>,
    /// Where each face begins in `corners`; `n_faces + 1` entries.
    pub face_starts: Vec<u32>,
    /// Colour of each vertex, or none at all.
    pub colours: Vec<Colour>,
}

impl Default for PolygonSoup {
    fn default() -> Self {
        Self {
            positions: Vec::new(),
            corners: Vec::new(),
            face_starts: vec![0],
            colours: Vec::new(),
        }
    }
}

impl PolygonSoup {
    /// A soup of faces given as slices of vertex indices.
    pub fn from_faces<F: AsRef<[u32]>>(positions: Vec<DVec3>, faces: &[F]) -> Self {
        let mut soup = Self {
            positions,
            ..Self::default()
        };
        for face in faces {
            soup.push_face(face.as_ref());
        }
        soup
    }

    /// Whether each vertex has a colour.
    pub fn has_colours(&self) -> bool {
        !self.colours.is_empty() && self.colours.len() == self.positions.len()
    }

    /// Colours of vertices that were those of this soup; none where it has none.
    pub fn colours_of(&self, were: &[u32]) -> Vec<Colour> {
        let were = if self.has_colours() { were } else { &[] };
        were.iter().map(|&v| self.colours[v as usize]).collect()
    }

    /// Appends one face.
    pub fn push_face(&mut self, corners: &[u32]) {
        self.corners.extend_from_slice(corners);
        self.face_starts.push(self.corners.len() as u32);
    }

    /// Number of faces.
    pub fn n_faces(&self) -> usize {
        self.face_starts.len() - 1
    }

    /// Corners of face `f`, in order.
    pub fn face(&self, f: usize) -> &[u32] {
        &self.corners[self.face_starts[f] as usize..self.face_starts[f + 1] as usize]
    }

    /// All faces in order.
    pub fn faces(&self) -> impl ExactSizeIterator<Item = &[u32]> + Clone {
        (0..self.n_faces()).map(|f| self.face(f))
    }
}
