//! Faces that change, found by their edges.

use super::hash::Table;
use super::key;
use crate::soup::PolygonSoup;

/// Faces of a soup; those that are gone are empty.
pub(super) struct Faces {
    faces: Vec<Vec<u32>>,
    of_edge: Table<(u32, u32), Few>,
}

/// Faces at an edge: hardly ever more than two, for which nothing is allocated.
pub(super) enum Few {
    Two([u32; 2], u8),
    Many(Vec<u32>),
}

impl Default for Few {
    fn default() -> Self {
        Self::Two([0; 2], 0)
    }
}

impl Few {
    fn push(&mut self, f: u32) {
        match self {
            Self::Two(list, n @ (0 | 1)) => {
                list[usize::from(*n)] = f;
                *n += 1;
            }
            Self::Two([a, b], _) => *self = Self::Many(vec![*a, *b, f]),
            Self::Many(list) => list.push(f),
        }
    }

    fn remove(&mut self, f: u32) {
        match self {
            Self::Two(list, n) => {
                if *n == 2 && list[0] == f {
                    list[0] = list[1];
                    *n = if list[0] == f { 0 } else { 1 };
                } else if *n > 0 && list[usize::from(*n) - 1] == f {
                    *n -= 1;
                }
            }
            Self::Many(list) => list.retain(|g| *g != f),
        }
    }

    fn list(&self) -> &[u32] {
        match self {
            Self::Two(list, n) => &list[..usize::from(*n)],
            Self::Many(list) => list,
        }
    }
}

impl Faces {
    pub(super) fn of(soup: &PolygonSoup) -> Self {
        let mut this = Self {
            faces: Vec::with_capacity(soup.n_faces()),
            of_edge: Table::with_capacity_and_hasher(soup.corners.len(), Default::default()),
        };
        for face in soup.faces() {
            this.add(face.to_vec());
        }
        this
    }

    pub(super) fn len(&self) -> usize {
        self.faces.len()
    }

    pub(super) fn face(&self, f: usize) -> &[u32] {
        &self.faces[f]
    }

    /// The faces at an edge, in order.
    pub(super) fn at(&self, a: u32, b: u32) -> &[u32] {
        self.of_edge.get(&key(a, b)).map_or(&[], Few::list)
    }

    /// Every edge with its faces.
    pub(super) fn edges(&self) -> impl Iterator<Item = (&(u32, u32), &[u32])> {
        let all = self.of_edge.iter().map(|(ends, few)| (ends, few.list()));
        all.filter(|(_, faces)| !faces.is_empty())
    }

    pub(super) fn add(&mut self, face: Vec<u32>) {
        let f = self.faces.len() as u32;
        for (a, b) in sides(&face) {
            self.of_edge.entry(key(a, b)).or_default().push(f);
        }
        self.faces.push(face);
    }

    pub(super) fn remove(&mut self, f: usize) -> Vec<u32> {
        let face = std::mem::take(&mut self.faces[f]);
        for (a, b) in sides(&face) {
            if let Some(faces) = self.of_edge.get_mut(&key(a, b)) {
                faces.remove(f as u32);
            }
        }
        face
    }

    /// Puts a vertex on a side of a face: of a triangle that makes two. Whether it could be.
    pub(super) fn insert(&mut self, f: usize, (a, b): (u32, u32), v: u32) -> bool {
        let face = &self.faces[f];
        let n = face.len();
        let place = (0..n).find(|&i| key(face[i], face[(i + 1) % n]) == key(a, b));
        let Some(place) = place.filter(|_| !face.contains(&v)) else {
            return false;
        };
        let mut face = self.remove(f);
        if n == 3 {
            face.rotate_left(place);
            let [a, b, c] = [face[0], face[1], face[2]];
            self.add(vec![a, v, c]);
            self.add(vec![v, b, c]);
        } else {
            face.insert(place + 1, v);
            self.add(face);
        }
        true
    }

    /// For each corner of the soup that these faces are of, the least corner of its fan: corners at
    /// a vertex hang together where `joined` pairs the faces at an edge of it.
    pub(super) fn fans(
        &self,
        soup: &PolygonSoup,
        joined: impl Fn((u32, u32), &[u32]) -> Vec<(u32, u32)>,
    ) -> Vec<u32> {
        let corner_of = |f: u32, v: u32| {
            let place = self.face(f as usize).iter().position(|&c| c == v);
            place.map(|place| soup.face_starts[f as usize] + place as u32)
        };
        let mut parent: Vec<u32> = (0..soup.corners.len() as u32).collect();
        for (&(a, b), of) in self.edges() {
            for (f, g) in joined((a, b), of) {
                for v in [a, b] {
                    let (Some(c), Some(d)) = (corner_of(f, v), corner_of(g, v)) else {
                        continue;
                    };
                    let (c, d) = (root(&mut parent, c), root(&mut parent, d));
                    parent[c.max(d) as usize] = c.min(d);
                }
            }
        }
        let all = 0..parent.len() as u32;
        all.map(|c| root(&mut parent, c)).collect()
    }

    /// The soup of what is left.
    pub(super) fn write_to(self, soup: &mut PolygonSoup) {
        let positions = std::mem::take(&mut soup.positions);
        let faces: Vec<Vec<u32>> = self.faces.into_iter().filter(|f| !f.is_empty()).collect();
        *soup = PolygonSoup::from_faces(positions, &faces);
    }
}

fn root(parent: &mut [u32], mut i: u32) -> u32 {
    while parent[i as usize] != i {
        parent[i as usize] = parent[parent[i as usize] as usize];
        i = parent[i as usize];
    }
    i
}

/// The sides of a face.
pub(super) fn sides(face: &[u32]) -> impl Iterator<Item = (u32, u32)> + Clone + '_ {
    let next = face.iter().cycle().skip(1);
    face.iter().copied().zip(next.copied())
}
