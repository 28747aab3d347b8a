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

/// The most faces that a cell of a shape has.
const MOST_FACES: usize = 6;

/// Cells with a volume, as they were read.
#[derive(Default)]
pub(super) struct Solids {
    /// Shape of each cell and where its corners begin.
    cells: Vec<(Solid, u32)>,
    corners: Vec<u32>,
    polyhedra: Polyhedra,
}

/// Cells that list their faces.
#[derive(Default)]
struct Polyhedra {
    /// Where each face begins, and the cell that has it.
    faces: Vec<(u32, u32)>,
    /// Where the corners of each cell begin.
    cells: Vec<u32>,
    corners: Vec<u32>,
}

impl Polyhedra {
    fn face(&self, face: usize) -> &[u32] {
        span(&self.corners, face, &self.faces, |&(start, _)| start)
    }

    /// Corners of the cell that a face is of, once for each of its faces there.
    fn cell(&self, face: usize) -> &[u32] {
        let (_, cell) = self.faces[face];
        span(&self.corners, cell as usize, &self.cells, |&start| start)
    }
}

/// What lies between a start and the next.
fn span<'a, T>(all: &'a [u32], at: usize, starts: &[T], start: impl Fn(&T) -> u32) -> &'a [u32] {
    let end = starts
        .get(at + 1)
        .map_or(all.len(), |next| start(next) as usize);
    &all[start(&starts[at]) as usize..end]
}

impl Solids {
    /// Takes in a cell. One that lacks corners is none.
    pub(super) fn push(&mut self, solid: Solid, corners: &[u32]) {
        if let Some(corners) = corners.get(..solid.n_corners()) {
            self.cells.push((solid, self.corners.len() as u32));
            self.corners.extend_from_slice(corners);
        }
    }

    /// Takes in a cell with any faces.
    pub(super) fn push_polyhedron(&mut self, of: &[Vec<u32>]) {
        let Polyhedra {
            faces: starts,
            cells,
            corners,
        } = &mut self.polyhedra;
        let cell = cells.len() as u32;
        cells.push(corners.len() as u32);
        for face in of {
            starts.push((corners.len() as u32, cell));
            corners.extend_from_slice(face);
        }
    }

    pub(super) fn n_corners(&self) -> usize {
        self.corners.len().max(self.polyhedra.corners.len())
    }

    pub(super) fn clear(&mut self) {
        *self = Self::default();
    }

    /// The faces that one cell alone has, in the order of the cells, those that list their faces
    /// last, seen from outside it.
    pub(super) fn boundary(&self, positions: &[DVec3]) -> Vec<Vec<u32>> {
        let of_shapes = (0..self.cells.len()).flat_map(|cell| {
            let n = self.cells[cell].0.faces().len();
            (0..n).map(move |face| cell * MOST_FACES + face)
        });
        let listed = (0..self.polyhedra.faces.len()).map(|face| self.n_slots() + face);
        let mut faces: Vec<usize> = of_shapes.chain(listed).collect();
        faces.sort_unstable_by_key(|&face| key(self.face(face)));
        let mut outer: Vec<usize> = faces
            .chunk_by(|&a, &b| key(self.face(a)) == key(self.face(b)))
            .filter_map(|same| match same {
                [alone] => Some(*alone),
                _ => None,
            })
            .collect();
        outer.sort_unstable();
        let seen = |face| self.seen_from_outside(face, positions);
        outer.into_iter().filter_map(seen).collect()
    }

    /// The number that the first face has which is listed.
    fn n_slots(&self) -> usize {
        MOST_FACES * self.cells.len()
    }

    /// Corners of the cell that has a face.
    fn cell(&self, face: usize) -> &[u32] {
        if let Some(face) = face.checked_sub(self.n_slots()) {
            return self.polyhedra.cell(face);
        }
        span(
            &self.corners,
            face / MOST_FACES,
            &self.cells,
            |&(_, start)| start,
        )
    }

    /// Corners of a face in their cyclic order. Those that repeat, in cells whose edges are
    /// collapsed, once.
    fn face(&self, face: usize) -> Vec<u32> {
        let mut face: Vec<u32> = if let Some(face) = face.checked_sub(self.n_slots()) {
            self.polyhedra.face(face).to_vec()
        } else {
            let corners = self.cell(face);
            let (solid, _) = self.cells[face / MOST_FACES];
            let around = solid.faces()[face % MOST_FACES].iter();
            around.map(|&corner| corners[corner]).collect()
        };
        face.dedup();
        if face.len() > 1 && face.first() == face.last() {
            face.pop();
        }
        face
    }

    fn seen_from_outside(&self, face: usize, positions: &[DVec3]) -> Option<Vec<u32>> {
        let cell = self.cell(face);
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

/// What two cells say of the face that they share: its corners, of a larger one the three smallest
/// and the largest.
fn key(mut face: Vec<u32>) -> [u32; 4] {
    face.sort_unstable();
    let mut key = [u32::MAX; 4];
    let n = face.len().min(3);
    key[..n].copy_from_slice(&face[..n]);
    if let Some(&last) = face.get(3..).and_then(<[u32]>::last) {
        key[3] = last;
    }
    key
}
