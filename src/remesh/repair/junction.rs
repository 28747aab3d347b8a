//! Vertices in the middle of a neighbour's edge.

use super::faces::Faces;
use super::grid::Grid;
use super::weld;
use crate::order;
use crate::soup::PolygonSoup;
use glam::DVec3;

/// A gap narrower than this share of the edges at it may be one that is to be closed.
const NARROW: f64 = 0.5;

/// Boundary edges, and what is near them.
pub(super) struct Rims<'a> {
    x: &'a [DVec3],
    edges: Vec<(u32, u32)>,
    /// Where the neighbours of each vertex begin, and its neighbours along the boundary.
    first: Vec<u32>,
    neighbours: Vec<u32>,
    grid: Grid,
    near: f64,
}

impl<'a> Rims<'a> {
    /// `None` where the boundary has no length.
    pub(super) fn new(mut edges: Vec<(u32, u32)>, x: &'a [DVec3], near: f64) -> Option<Self> {
        let length = |&(a, b): &(u32, u32)| x[a as usize].distance(x[b as usize]);
        let total: f64 = edges.iter().map(length).sum();
        if total == 0.0 {
            return None;
        }
        order::sort(&mut edges);
        let both_ways = edges.iter().flat_map(|&(a, b)| [(a, b), (b, a)]);
        let (first, neighbours) = order::bucketed(x.len(), both_ways);
        // Cubes as long as the mean edge: all edges together lead through few of them.
        let mut grid = Grid::new((total / edges.len() as f64).max(2.0 * near), x);
        for (v, &p) in x.iter().enumerate() {
            if first[v] < first[v + 1] {
                grid.insert(p, v as u32);
            }
        }
        Some(Self {
            x,
            edges,
            first,
            neighbours,
            grid,
            near,
        })
    }

    /// Neighbours of a vertex along the boundary.
    fn around(&self, v: u32) -> &[u32] {
        let [from, to] = [v, v + 1].map(|v| self.first[v as usize] as usize);
        &self.neighbours[from..to]
    }

    /// Vertices on the boundary.
    fn vertices(&self) -> impl Iterator<Item = u32> + '_ {
        (0..self.x.len() as u32).filter(|&v| !self.around(v).is_empty())
    }

    /// Vertices on an edge, farther than `near` from its ends, in order from its first end, one at a
    /// place. Only those from which a boundary edge goes on along it: others touch it in a point.
    fn on_edge(&self, (a, b): (u32, u32)) -> Vec<u32> {
        let at = |v: u32| self.x[v as usize];
        let (p, q) = (at(a), at(b));
        // Rounding of the coordinates, where nothing is to be welded.
        let near = self.near.max(1e-12 * (p.abs() + q.abs()).max_element());
        let mut found = self.beside((a, b), near, near);
        order::sort_by(&mut found, |s, t| s.1.total_cmp(&t.1).then(s.0.cmp(&t.0)));
        found.dedup();
        let all: Vec<u32> = found.into_iter().map(|(v, ..)| v).collect();
        let goes_on = |v: &u32| {
            self.around(*v).iter().any(|&w| {
                let is_end = [p, q].iter().any(|end| at(w).distance(*end) <= near);
                is_end || all.contains(&w)
            })
        };
        let mut on: Vec<u32> = all.iter().copied().filter(goes_on).collect();
        // Of several at one place one: the others are welded to it.
        on.dedup_by(|v, w| at(*v).distance(at(*w)) <= near);
        on
    }

    /// Vertices no farther than `near` from an edge, beyond `off` of its ends: where along it, as a share
    /// of its length, and how far from it.
    fn beside(&self, (a, b): (u32, u32), near: f64, off: f64) -> Vec<(u32, f64, f64)> {
        let (p, q) = (self.x[a as usize], self.x[b as usize]);
        let along = q - p;
        let length = along.length();
        let reach = DVec3::splat(near);
        let parts = (length / self.grid.size()).ceil().max(1.0) as usize;
        let mut found = Vec::new();
        for part in 0..parts {
            let [s, t] = [part, part + 1].map(|i| p + along * (i as f64 / parts as f64));
            for v in self.grid.near(s.min(t) - reach, s.max(t) + reach) {
                let r = self.x[v as usize] - p;
                let share = r.dot(along) / (length * length);
                let is_inside = share * length > off && (1.0 - share) * length > off;
                let distance = (r - share * along).length();
                if v != a && v != b && is_inside && distance <= near {
                    found.push((v, share, distance));
                }
            }
        }
        found
    }

    /// A length within which vertices meet others, or edges on which they lie, across a gap that is
    /// narrow for the edges at it: as large as the widest of such, of which there must be two ends.
    pub(super) fn gap(&self) -> Option<f64> {
        let place = |v: u32| self.x[v as usize];
        let length = |v: u32, w: &u32| place(*w).distance(place(v));
        // Of each vertex how far it is from what is across, as far as that is narrow.
        let mut across = vec![f64::INFINITY; self.x.len()];
        for v in self.vertices() {
            let around = self.around(v);
            let shortest = around.iter().map(|w| length(v, w));
            let narrow = NARROW * shortest.fold(f64::INFINITY, f64::min);
            let reach = DVec3::splat(narrow);
            let others = self.grid.near(place(v) - reach, place(v) + reach);
            let others = others.filter(|w| *w != v && !around.contains(w));
            let nearest = others.map(|w| length(v, &w)).fold(f64::INFINITY, f64::min);
            if nearest <= narrow {
                across[v as usize] = nearest;
            }
        }
        for &(a, b) in &self.edges {
            let narrow = NARROW * length(a, &b);
            for (v, _, distance) in self.beside((a, b), narrow, self.near) {
                let around = self.around(v);
                let is_narrow = around.iter().all(|w| distance <= NARROW * length(v, w));
                let is_neighbour = around.contains(&a) || around.contains(&b);
                if is_narrow && !is_neighbour {
                    let nearest = &mut across[v as usize];
                    *nearest = nearest.min(distance);
                }
            }
        }
        let wide = across
            .into_iter()
            .filter(|d| *d > self.near && d.is_finite());
        let wide: Vec<f64> = wide.collect();
        // A little more, so that rounding leaves none out.
        let widest = wide.iter().copied().fold(0.0, f64::max);
        (wide.len() >= 2).then_some(1.01 * widest)
    }

    /// Whether two boundary vertices lie within `near` of each other, or one on an edge.
    pub(super) fn is_suspect(&self) -> bool {
        let reach = DVec3::splat(self.near);
        let is_near = |v: u32| {
            let p = self.x[v as usize];
            let mut others = self.grid.near(p - reach, p + reach);
            others.any(|w| w != v && self.x[w as usize].distance(p) <= self.near)
        };
        self.vertices().any(is_near)
            || self
                .edges
                .iter()
                .any(|&edge| !self.on_edge(edge).is_empty())
    }
}

/// Inserts boundary vertices that lie on a boundary edge, no farther from it than `near`, into the
/// face of that edge. Gives how often, and the vertices.
pub(super) fn insert(soup: &mut PolygonSoup, near: f64) -> (usize, Vec<u32>) {
    if !weld::boundary(soup).contains(&true) {
        return (0, Vec::new());
    }
    let mut faces = Faces::of(soup);
    let open: Vec<(u32, u32)> = faces
        .edges()
        .filter(|(_, faces)| faces.len() == 1)
        .map(|(ends, _)| *ends)
        .collect();
    let Some(rims) = Rims::new(open, &soup.positions, near) else {
        return (0, Vec::new());
    };
    let mut inserted = Vec::new();
    for &(mut from, to) in &rims.edges {
        for v in rims.on_edge((from, to)) {
            let &[f] = faces.at(from, to) else { break };
            if faces.insert(f as usize, (from, to), v) {
                inserted.push(v);
                from = v;
            }
        }
    }
    if !inserted.is_empty() {
        faces.write_to(soup);
    }
    (inserted.len(), inserted)
}
