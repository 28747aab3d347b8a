//! Cells with a volume, of finite-element meshes: the surface around them.

use glam::DVec3;

/// The shapes that such cells have; of one of higher order the corners, which come first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Solid {
    Tetrahedron,
    Hexahedron,
    Wedge,
    Pyramid,
}

impl Solid {
    /// The faces, as corners of the cell; which side is outside, the positions say.
    const fn faces(self) -> &'static [&'static [usize]] {
        match self {
            Self::Tetrahedron => &[&[0, 1, 2], &[0, 1, 3], &[1, 2, 3], &[0, 2, 3]],
            Self::Hexahedron => &[
                &[0, 1, 2, 3],
                &[4, 5, 6, 7],
                &[0, 1, 5, 4],
                &[1, 2, 6, 5],
                &[2, 3, 7, 6],
                &[3, 0, 4, 7],
            ],
            Self::Wedge => &[
                &[0, 1, 2],
                &[3, 4, 5],
                &[0, 1, 4, 3],
                &[1, 2, 5, 4],
                &[2, 0, 3, 5],
            ],
            Self::Pyramid => &[
                &[0, 1, 2, 3],
                &[0, 1, 4],
                &[1, 2, 4],
                &[2, 3, 4],
                &[3, 0, 4],
            ],
        }
    }

    pub(super) const fn n_corners(self) -> usize {
        match self {
            Self::Tetrahedron => 4,
            Self::Hexahedron => 8,
            Self::Wedge => 6,
            Self::Pyramid => 5,
        }
    }
}

/// The most faces that a cell has.
const MOST_FACES: usize = 6;

/// Cells with a volume, as they were read.
#[derive(Default)]
pub(super) struct Solids {
    /// Shape of each cell and where its corners begin.
    cells: Vec<(Solid, u32)>,
    corners: Vec<u32>,
}

impl Solids {
    /// Takes in a cell. One that lacks corners is none.
    pub(super) fn push(&mut self, solid: Solid, corners: &[u32]) {
        if let Some(corners) = corners.get(..solid.n_corners()) {
            self.cells.push((solid, self.corners.len() as u32));
            self.corners.extend_from_slice(corners);
        }
    }

    pub(super) fn n_corners(&self) -> usize {
        self.corners.len()
    }

    pub(super) fn clear(&mut self) {
        *self = Self::default();
    }

    /// The faces that one cell alone has, in the order of the cells, seen from outside it.
    pub(super) fn boundary(&self, positions: &[DVec3]) -> Vec<Vec<u32>> {
        let mut faces: Vec<usize> = (0..self.cells.len())
            .flat_map(|cell| {
                let n = self.cells[cell].0.faces().len();
                (0..n).map(move |face| cell * MOST_FACES + face)
            })
            .collect();
        faces.sort_unstable_by_key(|&face| key(&self.face(face)));
        let mut outer: Vec<usize> = faces
            .chunk_by(|&a, &b| key(&self.face(a)) == key(&self.face(b)))
            .filter_map(|same| match same {
                [alone] => Some(*alone),
                _ => None,
            })
            .collect();
        outer.sort_unstable();
        let seen = |face| self.seen_from_outside(face, positions);
        outer.into_iter().filter_map(seen).collect()
    }

    fn cell(&self, face: usize) -> (Solid, &[u32]) {
        let (solid, start) = self.cells[face / MOST_FACES];
        let start = start as usize;
        (solid, &self.corners[start..start + solid.n_corners()])
    }

    /// Corners of a face in their cyclic order. Those that repeat, in cells whose edges are
    /// collapsed, once.
    fn face(&self, face: usize) -> Vec<u32> {
        let (solid, corners) = self.cell(face);
        let around = solid.faces()[face % MOST_FACES].iter();
        let mut face: Vec<u32> = around.map(|&corner| corners[corner]).collect();
        face.dedup();
        if face.len() > 1 && face.first() == face.last() {
            face.pop();
        }
        face
    }

    fn seen_from_outside(&self, face: usize, positions: &[DVec3]) -> Option<Vec<u32>> {
        let (_, cell) = self.cell(face);
        let mut face = self.face(face);
        if face.len() < 3 {
            return None;
        }
        let at = |corner: u32| positions[corner as usize];
        let centre = |corners: &[u32]| {
            corners.iter().map(|&corner| at(corner)).sum::<DVec3>() / corners.len() as f64
        };
        let middle = centre(&face);
        let sides = face.iter().zip(face.iter().cycle().skip(1));
        let normal: DVec3 = sides
            .map(|(&a, &b)| (at(a) - middle).cross(at(b) - middle))
            .sum();
        if normal.dot(middle - centre(cell)) < 0.0 {
            face.reverse();
        }
        Some(face)
    }
}

/// What two cells say of the face that they share.
fn key(face: &[u32]) -> [u32; 4] {
    let mut key = [u32::MAX; 4];
    key[..face.len()].copy_from_slice(face);
    key.sort_unstable();
    key
}
