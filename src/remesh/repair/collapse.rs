//! Edges without length.

use super::faces::{Faces, sides};
use super::hash::Table;
use std::collections::BTreeSet;

/// Collapses edges; remembers which faces a vertex has had.
#[derive(Default)]
pub(super) struct Collapser {
    faces_of: Table<u32, Vec<usize>>,
    /// Faces that were looked at: what others change are new faces after them, and empty ones.
    seen: usize,
}

impl Collapser {
    fn catch_up(&mut self, faces: &Faces) {
        for f in self.seen..faces.len() {
            for &v in faces.face(f) {
                self.faces_of.entry(v).or_default().push(f);
            }
        }
        self.seen = faces.len();
    }

    fn star(&self, faces: &Faces, v: u32) -> Vec<usize> {
        let known = self.faces_of.get(&v).into_iter().flatten().copied();
        let mut star: Vec<usize> = known.filter(|&f| faces.face(f).contains(&v)).collect();
        star.sort_unstable();
        star.dedup();
        star
    }

    /// Makes one vertex of the ends of an edge, where that leaves a surface a surface; gives the
    /// vertex.
    pub(super) fn collapse(&mut self, faces: &mut Faces, [a, b]: [u32; 2]) -> Option<u32> {
        self.catch_up(faces);
        let around = |v: u32| -> BTreeSet<u32> {
            let star = self.star(faces, v);
            let pairs = star.iter().flat_map(|&f| sides(faces.face(f)));
            let with = pairs.filter(|&(p, q)| p == v || q == v);
            with.map(|(p, q)| if p == v { q } else { p }).collect()
        };
        let is_boundary = |v: u32| around(v).iter().any(|&w| faces.at(v, w).len() == 1);
        // Every neighbour of both must be across a triangle that goes with the edge, or the third of a
        // hole of three edges, which closes.
        let at_edge = faces.at(a, b);
        let is_open = |v: u32, w: u32| faces.at(v, w).len() == 1;
        let triangles = at_edge.iter().map(|&f| faces.face(f as usize));
        let triangles: Vec<&[u32]> = triangles.filter(|face| face.len() == 3).collect();
        let mut shared: Vec<u32> = around(a).intersection(&around(b)).copied().collect();
        let n_shared = shared.len();
        shared.retain(|w| triangles.iter().all(|face| !face.contains(w)));
        let is_link = n_shared - shared.len() == triangles.len();
        let closes = |w: &u32| at_edge.len() == 1 && is_open(a, *w) && is_open(b, *w);
        let may_close = shared.len() < 2 && shared.iter().all(closes);
        let pinches = at_edge.len() == 2 && is_boundary(a) && is_boundary(b);
        if !is_link || !may_close || pinches {
            return None;
        }
        let (kept, gone) = (a.min(b), a.max(b));
        for f in self.star(faces, gone) {
            let mut face = faces.remove(f);
            for v in &mut face {
                if *v == gone {
                    *v = kept;
                }
            }
            face.dedup();
            if face.len() > 1 && face.first() == face.last() {
                face.pop();
            }
            if face.len() < 3 {
                continue;
            }
            faces.add(face);
        }
        Some(kept)
    }
}
