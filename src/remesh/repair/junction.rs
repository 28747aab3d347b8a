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
        let along = q - p;
        let length = along.length();
        // Rounding of the coordinates, where nothing is to be welded.
        let near = self.near.max(1e-12 * (p.abs() + q.abs()).max_element());
        let reach = DVec3::splat(near);
        let parts = (length / self.grid.size()).ceil().max(1.0) as usize;
        let mut found: Vec<(f64, u32)> = Vec::new();
        for part in 0..parts {
            let [s, t] = [part, part + 1].map(|i| p + along * (i as f64 / parts as f64));
            for v in self.grid.near(s.min(t) - reach, s.max(t) + reach) {
                let r = at(v) - p;
                let share = r.dot(along) / (length * length);
                let is_inside = share * length > near && (1.0 - share) * length > near;
                let is_on = (r - share * along).length() <= near;
                if v != a && v != b && is_inside && is_on {
                    found.push((share, v));
                }
            }
        }
        order::sort_by(&mut found, |s, t| s.0.total_cmp(&t.0).then(s.1.cmp(&t.1)));
        found.dedup();
        let all: Vec<u32> = found.into_iter().map(|(_, v)| v).collect();
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

    /// A length within which vertices meet across a gap that is narrow for the edges at it: as
    /// large as the widest of such, of which there must be two ends.
    pub(super) fn gap(&self) -> Option<f64> {
        let mut widest = 0.0_f64;
        let mut ends = 0;
        for v in self.vertices() {
            let around = self.around(v);
            let p = self.x[v as usize];
            let length = |w: &u32| self.x[*w as usize].distance(p);
            let shortest = around.iter().map(length).fold(f64::INFINITY, f64::min);
            let narrow = NARROW * shortest;
            let reach = DVec3::splat(narrow);
            let others = self.grid.near(p - reach, p + reach);
            let others = others.filter(|w| *w != v && !around.contains(w));
            let nearest = others.map(|w| length(&w)).fold(f64::INFINITY, f64::min);
            if nearest <= narrow && nearest > self.near {
                widest = widest.max(nearest);
                ends += 1;
            }
        }
        // A little more, so that rounding leaves none out.
        (ends >= 2).then_some(1.01 * widest)
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
