//! A piece of triangle mesh that can be changed: edges split, collapsed and flipped, its rim
//! held.

use crate::geometry::quality::triangle_quality;
use glam::DVec3;
use std::collections::HashSet;

/// A face that is no more.
const GONE: [u32; 3] = [u32::MAX; 3];

/// A flip may bring the worse of two triangles down to this share of what it was …
const LEAST_SHARE: f64 = 0.5;
/// … or to this quality.
const GOOD: f64 = 0.6;

/// Triangles between loops of held vertices, the rim, which are numbered first.
///
/// The surface around the patch is known by what it forbids: edges between rim vertices
/// that it has already.
#[derive(Clone, Debug)]
pub(super) struct Patch {
    /// Positions, those of the rim first.
    pub(super) x: Vec<DVec3>,
    /// Edge length wanted at each vertex.
    pub(super) sizes: Vec<f64>,
    faces: Vec<[u32; 3]>,
    /// The faces at each vertex.
    stars: Vec<Vec<u32>>,
    /// Number of edges at each rim vertex outside the patch, the rim's own included.
    outer_valences: Vec<usize>,
    forbidden: HashSet<(u32, u32)>,
    /// Whether the three vertices of the rim have a face outside: the patch must not become
    /// that face again.
    is_face: bool,
    is_gone: Vec<bool>,
}

/// The two triangles about an edge (a, b): a, b, c and b, a, d.
struct Diamond {
    faces: [u32; 2],
    c: u32,
    d: u32,
}

fn key(a: u32, b: u32) -> (u32, u32) {
    (a.min(b), a.max(b))
}

impl Patch {
    /// A patch of these faces, for edges of that length; the rim has one outer valence a
    /// vertex.
    pub(super) fn new(
        x: Vec<DVec3>,
        faces: Vec<[u32; 3]>,
        outer_valences: Vec<usize>,
        forbidden: HashSet<(u32, u32)>,
        size: f64,
    ) -> Self {
        let mut stars = vec![Vec::new(); x.len()];
        for (f, face) in faces.iter().enumerate() {
            for &v in face {
                stars[v as usize].push(f as u32);
            }
        }
        Self {
            is_gone: vec![false; x.len()],
            sizes: vec![size; x.len()],
            is_face: false,
            x,
            faces,
            stars,
            outer_valences,
            forbidden,
        }
    }

    /// Forbids the single triangle.
    pub(super) fn forbid_face(&mut self) {
        self.is_face = true;
    }

    /// Number of held vertices.
    pub(super) fn n_rim(&self) -> usize {
        self.outer_valences.len()
    }

    /// Number of vertices that may move.
    pub(super) fn n_free(&self) -> usize {
        self.free_vertices().count()
    }

    /// The vertices that may move.
    pub(super) fn free_vertices(&self) -> impl Iterator<Item = u32> + '_ {
        (self.n_rim()..self.x.len())
            .filter(|&v| !self.is_gone[v])
            .map(|v| v as u32)
    }

    /// Whether a vertex is held.
    pub(super) fn is_rim(&self, v: u32) -> bool {
        (v as usize) < self.n_rim()
    }

    /// The faces there are.
    pub(super) fn faces(&self) -> impl Iterator<Item = [u32; 3]> + '_ {
        self.faces.iter().copied().filter(|f| *f != GONE)
    }

    /// Ends of the edges with a face on both sides, each once.
    pub(super) fn inner_edges(&self) -> Vec<(u32, u32)> {
        let sides = self.faces().flat_map(|[a, b, c]| [(a, b), (b, c), (c, a)]);
        // A side that runs the other way on the other face is met once with a < b.
        sides
            .filter(|&(a, b)| a < b && self.diamond(a, b).is_some())
            .collect()
    }

    /// Lengths of the rim's edges, with their ends.
    pub(super) fn rim_edges(&self) -> Vec<(u32, u32, f64)> {
        let sides = self.faces().flat_map(|[a, b, c]| [(a, b), (b, c), (c, a)]);
        let outer = sides.filter(|&(a, b)| self.is_rim(a) && self.is_rim(b));
        let outer = outer.filter(|&(a, b)| self.diamond(a, b).is_none());
        outer.map(|(a, b)| (a, b, self.length(a, b))).collect()
    }

    /// Edge length wanted between two vertices.
    pub(super) fn size(&self, a: u32, b: u32) -> f64 {
        0.5 * (self.sizes[a as usize] + self.sizes[b as usize])
    }

    /// Length of an edge.
    pub(super) fn length(&self, a: u32, b: u32) -> f64 {
        self.x[a as usize].distance(self.x[b as usize])
    }

    /// Corners of a face.
    fn points(&self, face: [u32; 3]) -> [DVec3; 3] {
        face.map(|v| self.x[v as usize])
    }

    fn normal(&self, face: [u32; 3]) -> DVec3 {
        let [a, b, c] = self.points(face);
        (b - a).cross(c - a)
    }

    /// The faces at a vertex.
    pub(super) fn star(&self, v: u32) -> impl Iterator<Item = [u32; 3]> + '_ {
        self.stars[v as usize]
            .iter()
            .map(|&f| self.faces[f as usize])
    }

    /// The vertices joined to `v`, each once, in no order.
    pub(super) fn neighbours(&self, v: u32) -> Vec<u32> {
        let mut all: Vec<u32> = self.star(v).flatten().filter(|&w| w != v).collect();
        all.sort_unstable();
        all.dedup();
        all
    }

    /// Mean over the neighbours of a free vertex, whose faces close around it.
    pub(super) fn mean_around<T>(&self, v: u32, of: impl Fn(u32) -> T) -> T
    where
        T: std::iter::Sum + std::ops::Mul<f64, Output = T>,
    {
        // Each neighbour is in two of the faces.
        let corners = self.star(v).flatten().filter(|&w| w != v);
        let half = 0.5 / self.stars[v as usize].len() as f64;
        corners.map(of).sum::<T>() * half
    }

    fn has_edge(&self, a: u32, b: u32) -> bool {
        self.star(a).any(|face| face.contains(&b))
    }

    /// Whether two vertices may be joined by a new edge.
    fn may_join(&self, a: u32, b: u32) -> bool {
        let both_rim = self.is_rim(a) && self.is_rim(b);
        a != b && !self.has_edge(a, b) && !(both_rim && self.forbidden.contains(&key(a, b)))
    }

    /// Number of edges at a vertex, in the patch and around it.
    pub(super) fn valence(&self, v: u32) -> usize {
        let faces = self.stars[v as usize].len();
        match self.outer_valences.get(v as usize) {
            Some(outer) => outer + faces - 1,
            None => faces,
        }
    }

    fn diamond(&self, a: u32, b: u32) -> Option<Diamond> {
        let mut found = [None; 2];
        for &f in &self.stars[a as usize] {
            let face = self.faces[f as usize];
            for i in 0..3 {
                let apex = face[(i + 2) % 3];
                if face[i] == a && face[(i + 1) % 3] == b {
                    found[0] = Some((f, apex));
                } else if face[i] == b && face[(i + 1) % 3] == a {
                    found[1] = Some((f, apex));
                }
            }
        }
        let [(f, c), (g, d)] = [found[0]?, found[1]?];
        Some(Diamond {
            faces: [f, g],
            c,
            d,
        })
    }

    /// Puts a vertex in the middle of an inner edge; answers its number.
    pub(super) fn split(&mut self, a: u32, b: u32) -> Option<u32> {
        let Diamond { faces, c, d } = self.diamond(a, b)?;
        let middle = self.x.len() as u32;
        self.x.push(0.5 * (self.x[a as usize] + self.x[b as usize]));
        self.is_gone.push(false);
        self.sizes.push(self.size(a, b));
        self.stars.push(Vec::with_capacity(6));
        for (f, apex) in faces.into_iter().zip([c, d]) {
            let half = self.faces[f as usize].map(|v| if v == a { middle } else { v });
            let g = self.faces.len() as u32;
            self.faces.push(half);
            for v in &mut self.faces[f as usize] {
                if *v == b {
                    *v = middle;
                }
            }
            self.stars[b as usize].retain(|&s| s != f);
            self.stars[b as usize].push(g);
            self.stars[apex as usize].push(g);
            self.stars[middle as usize].extend([f, g]);
        }
        Some(middle)
    }

    /// Moves the free vertex `gone` into its neighbour `kept`, which goes half way to meet it
    /// unless held; answers whether that was possible without double edges, faces turned
    /// over, or edges longer than `longest`.
    pub(super) fn collapse(&mut self, gone: u32, kept: u32, longest: f64) -> bool {
        let Some(Diamond { faces, c, d }) = self.diamond(gone, kept) else {
            return false;
        };
        let ring = self.neighbours(gone);
        let keeps_fans = [c, d]
            .iter()
            .all(|&v| self.stars[v as usize].len() > if self.is_rim(v) { 1 } else { 3 });
        // The link condition, and nothing that is there outside the patch.
        let joins = ring
            .iter()
            .filter(|&&v| ![kept, c, d].contains(&v))
            .all(|&v| self.may_join(v, kept));
        if self.is_face && self.n_free() == 1 {
            return false;
        }
        if self.is_rim(gone) || !keeps_fans || !joins {
            return false;
        }
        let target = if self.is_rim(kept) {
            self.x[kept as usize]
        } else {
            0.5 * (self.x[kept as usize] + self.x[gone as usize])
        };
        let too_long = |v: &u32| self.x[*v as usize].distance(target) > longest;
        if ring.iter().filter(|v| **v != kept).any(too_long) {
            return false;
        }
        for v in [gone, kept] {
            let stays = |face: &[u32; 3]| !(face.contains(&gone) && face.contains(&kept));
            let moved = |face: [u32; 3]| {
                let corner = |w: u32| if w == v { target } else { self.x[w as usize] };
                let [a, b, c] = face.map(corner);
                (b - a).cross(c - a).dot(self.normal(face)) > 0.0
            };
            if !self.star(v).filter(stays).all(moved) {
                return false;
            }
        }
        for f in faces {
            for v in std::mem::replace(&mut self.faces[f as usize], GONE) {
                self.stars[v as usize].retain(|&s| s != f);
            }
        }
        for f in std::mem::take(&mut self.stars[gone as usize]) {
            for v in &mut self.faces[f as usize] {
                if *v == gone {
                    *v = kept;
                }
            }
            self.stars[kept as usize].push(f);
        }
        self.x[kept as usize] = target;
        self.is_gone[gone as usize] = true;
        true
    }

    /// Flips an inner edge if `wants` says so of it and its apexes, and if that makes no
    /// double edge, turns no face over and leaves fair triangles. Answers the new ends.
    pub(super) fn flip(
        &mut self,
        a: u32,
        b: u32,
        wants: impl FnOnce(&Self, [u32; 4]) -> bool,
    ) -> Option<(u32, u32)> {
        let Diamond { faces, c, d } = self.diamond(a, b)?;
        if !wants(self, [a, b, c, d]) || !self.may_join(c, d) {
            return None;
        }
        let keeps_fans = [a, b]
            .iter()
            .all(|&v| self.stars[v as usize].len() > if self.is_rim(v) { 1 } else { 3 });
        let (old, new) = ([[a, b, c], [b, a, d]], [[a, d, c], [b, c, d]]);
        let reference = self.normal(old[0]) + self.normal(old[1]);
        let turns = new.iter().any(|&f| self.normal(f).dot(reference) <= 0.0);
        let worst = |pair: [[u32; 3]; 2]| {
            let [p, q] = pair.map(|f| triangle_quality(self.points(f)));
            p.min(q)
        };
        let is_fair = worst(new) >= GOOD.min(LEAST_SHARE * worst(old));
        if !keeps_fans || turns || !is_fair {
            return None;
        }
        for (f, corners) in faces.into_iter().zip(new) {
            self.faces[f as usize] = corners;
        }
        self.stars[b as usize].retain(|&f| f != faces[0]);
        self.stars[a as usize].retain(|&f| f != faces[1]);
        self.stars[d as usize].push(faces[0]);
        self.stars[c as usize].push(faces[1]);
        Some((c, d))
    }

    /// Moves a free vertex unless a face at it would turn over.
    pub(super) fn try_move(&mut self, v: u32, target: DVec3) -> bool {
        let turns = |face: [u32; 3]| {
            let corner = |w: u32| if w == v { target } else { self.x[w as usize] };
            let [a, b, c] = face.map(corner);
            let before = self.normal(face);
            let after = (b - a).cross(c - a);
            after.dot(before) < 0.1 * after.length() * before.length()
        };
        if self.star(v).any(turns) {
            return false;
        }
        self.x[v as usize] = target;
        true
    }

    /// Unit normal at a vertex: of the sum of the vector areas of its faces.
    pub(super) fn vertex_normal(&self, v: u32) -> DVec3 {
        self.star(v)
            .map(|f| self.normal(f))
            .sum::<DVec3>()
            .normalize_or_zero()
    }

    /// Area of all faces.
    pub(super) fn area(&self) -> f64 {
        0.5 * self.faces().map(|f| self.normal(f).length()).sum::<f64>()
    }

    /// Numbers the vertices without gaps, the rim as it was, and lays out anew in memory what
    /// splits and collapses have scattered: large patches take half the time.
    pub(super) fn compact(&mut self) {
        let mut number = vec![u32::MAX; self.x.len()];
        let (mut x, mut sizes) = (Vec::new(), Vec::new());
        for v in (0..self.x.len()).filter(|&v| !self.is_gone[v]) {
            number[v] = x.len() as u32;
            x.push(self.x[v]);
            sizes.push(self.sizes[v]);
        }
        let faces = self
            .faces()
            .map(|f| f.map(|v| number[v as usize]))
            .collect();
        let outer_valences = std::mem::take(&mut self.outer_valences);
        let forbidden = std::mem::take(&mut self.forbidden);
        *self = Self {
            sizes,
            is_face: self.is_face,
            ..Self::new(x, faces, outer_valences, forbidden, 0.0)
        };
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_collapse_makes_no_double_edge() {
        // The triangle 3, 4, 5 is the foot of a bubble: without the edge 3, 4 it would be
        // an edge with four faces.
        let place = |x: f64, y: f64, z: f64| DVec3::new(x, y, z);
        let x = vec![
            place(0.0, -1.0, 0.0),
            place(2.0, 1.5, 0.0),
            place(-2.0, 1.5, 0.0),
            place(-0.1, 0.0, 0.0),
            place(0.1, 0.0, 0.0),
            place(0.0, 1.0, 0.0),
            place(0.0, 0.3, 1.0),
            place(0.0, 0.6, 1.0),
        ];
        let ring = [
            [0, 1, 4],
            [1, 2, 5],
            [2, 0, 3],
            [0, 4, 3],
            [1, 5, 4],
            [2, 3, 5],
        ];
        let bubble = [[3, 4, 6], [4, 7, 6], [7, 5, 6], [5, 3, 6], [4, 5, 7]];
        let faces = [&ring[..], &bubble[..]].concat();
        let mut patch = Patch::new(x, faces, vec![2; 3], HashSet::new(), 1.0);
        assert!(!patch.collapse(4, 3, 10.0));
        assert_eq!(patch.faces().count(), 11);
    }
}
