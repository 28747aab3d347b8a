//! Surfaces cut into triangles. Two polygons that share two sides in a row, as a roof of two
//! quadrilaterals does, may not be cut along the same line, nor any along a side of another: the edge
//! would have four faces there, or three.

use super::PolygonSoup;
use super::triangulate::Cutter;
use crate::order;

impl PolygonSoup {
    /// The faces cut into triangles on their own corners, orientation and order kept; vertices
    /// keep their numbers.
    pub fn triangles(&self) -> Vec<[u32; 3]> {
        let mut cutter = Cutter::default();
        let mut all = Vec::with_capacity(self.corners.len().saturating_sub(2 * self.n_faces()));
        let mut starts = Vec::with_capacity(self.n_faces() + 1);
        for face in self.faces() {
            starts.push(all.len());
            all.extend_from_slice(cutter.cut(face, &self.positions));
        }
        starts.push(all.len());
        if self.faces().any(|face| face.len() > 3) {
            return parted(self, &starts, all);
        }
        all
    }

    /// The same surface with triangles only; faces of fewer than three corners are gone.
    #[must_use]
    pub fn triangulated(&self) -> Self {
        Self {
            colours: self.colours.clone(),
            ..Self::from_faces(self.positions.clone(), &self.triangles())
        }
    }
}

/// The ends of an edge, the same either way.
fn key(a: u32, b: u32) -> u64 {
    u64::from(a.min(b)) << 32 | u64::from(a.max(b))
}

fn sides(face: &[u32]) -> impl Iterator<Item = u64> + '_ {
    let next = face.iter().cycle().skip(1);
    face.iter().zip(next).map(|(&a, &b)| key(a, b))
}

/// Sides of the triangles of a face that are none of its own; each twice.
fn diagonals<'a>(face: &'a [u32], cut: &'a [[u32; 3]]) -> impl Iterator<Item = u64> + 'a {
    let all = cut.iter().flat_map(|triangle| sides(triangle));
    all.filter(|diagonal| !sides(face).any(|side| side == *diagonal))
}

deferred! {
    /// Cuts faces anew whose diagonals are already an edge of others, if there is another way. `starts`
    /// tells where the triangles of each face begin.
    fn parted(soup: &PolygonSoup, starts: &[usize], cut: Vec<[u32; 3]>) -> Vec<[u32; 3]> {
        let mut all = cut;
        let mut edges: Vec<u64> = soup.faces().flat_map(sides).collect();
        order::sort(&mut edges);
        let mut drawn: Vec<(u64, u32)> = Vec::new();
        for (f, face) in soup.faces().enumerate().filter(|(_, face)| face.len() > 3) {
            let own = diagonals(face, &all[starts[f]..starts[f + 1]]);
            drawn.extend(own.map(|diagonal| (diagonal, f as u32)));
        }
        order::sort(&mut drawn);
        drawn.dedup();
        let is_edge = |diagonal: u64| edges.binary_search(&diagonal).is_ok();
        let doubled = drawn.windows(2).filter(|pair| pair[0].0 == pair[1].0);
        let mut clashing: Vec<u32> = doubled.map(|pair| pair[1].1).collect();
        clashing.extend(drawn.iter().filter(|(d, _)| is_edge(*d)).map(|(_, f)| f));
        order::sort_by_key(&mut clashing, |f| u64::from(*f));
        clashing.dedup();
        let mut redrawn: Vec<u64> = Vec::new();
        let mut cutter = Cutter::default();
        for f in clashing {
            let mut face = soup.face(f as usize).to_vec();
            let is_free = |diagonal: u64, redrawn: &[u64]| {
                let at = drawn.partition_point(|(other, _)| *other < diagonal);
                let mut others = drawn[at..]
                    .iter()
                    .take_while(|(other, _)| *other == diagonal);
                others.all(|(_, other)| *other == f)
                    && !is_edge(diagonal)
                    && !redrawn.contains(&diagonal)
            };
            for _ in 0..face.len() {
                face.rotate_left(1);
                let cut = match *face {
                    [a, b, c, d] => vec![[a, b, c], [a, c, d]],
                    _ => cutter.cut(&face, &soup.positions).to_vec(),
                };
                if diagonals(&face, &cut).all(|diagonal| is_free(diagonal, &redrawn)) {
                    redrawn.extend(diagonals(&face, &cut));
                    all[starts[f as usize]..starts[f as usize + 1]].copy_from_slice(&cut);
                    break;
                }
            }
        }
        all
    }
}
