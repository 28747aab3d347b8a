//! Vertices in the middle of a neighbour's edge.

use super::faces::Faces;
use super::grid::Grid;
use super::weld::boundary;
use crate::soup::PolygonSoup;
use glam::DVec3;

/// Cubes that an edge may lead through before it is cut for the search.
const CELLS: f64 = 64.0;

/// Inserts boundary vertices that lie on a boundary edge, farther than `near` from its ends and
/// no farther from it, into the face of that edge. Gives the vertices, as often as that was done.
pub(super) fn insert(soup: &mut PolygonSoup, near: f64) -> Vec<u32> {
    let is_boundary = boundary(soup);
    let x = soup.positions.clone();
    let mut faces = Faces::of(soup);
    let open: Vec<(u32, u32)> = faces
        .edges()
        .filter(|(_, faces)| faces.len() == 1)
        .map(|(ends, _)| *ends)
        .collect();
    let length = |(a, b): (u32, u32)| x[a as usize].distance(x[b as usize]);
    let total: f64 = open.iter().map(|&edge| length(edge)).sum();
    if open.is_empty() || total == 0.0 {
        return Vec::new();
    }
    let mut grid = Grid::new((total / open.len() as f64).max(2.0 * near));
    for v in (0..x.len()).filter(|&v| is_boundary[v]) {
        grid.insert(x[v], v as u32);
    }
    let mut open = open;
    open.sort_unstable();
    let mut inserted = Vec::new();
    for edge in open {
        let mut between = on_edge(edge, &x, &grid, near);
        between.sort_by(|s, t| s.0.total_cmp(&t.0));
        let (mut from, to) = edge;
        for (_, v) in between {
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
    inserted
}

/// Vertices on an edge, with how far along.
fn on_edge((a, b): (u32, u32), x: &[DVec3], grid: &Grid, near: f64) -> Vec<(f64, u32)> {
    let (p, q) = (x[a as usize], x[b as usize]);
    let along = q - p;
    let length = along.length();
    // Rounding of the coordinates, where nothing is to be welded.
    let near = near.max(1e-12 * (p.abs() + q.abs()).max_element());
    let reach = DVec3::splat(near);
    // A long edge in parts, whose boxes are small.
    let parts = ((length / grid.size()).ceil()).clamp(1.0, CELLS) as usize;
    let mut found: Vec<(f64, u32)> = Vec::new();
    for part in 0..parts {
        let [s, t] = [part, part + 1].map(|i| p + along * (i as f64 / parts as f64));
        for v in grid.near(s.min(t) - reach, s.max(t) + reach) {
            let r = x[v as usize] - p;
            let share = r.dot(along) / (length * length);
            let is_inside = share * length > near && (1.0 - share) * length > near;
            let is_on = (r - share * along).length() <= near;
            if v != a && v != b && is_inside && is_on {
                found.push((share, v));
            }
        }
    }
    found.sort_by_key(|(_, v)| *v);
    found.dedup_by_key(|(_, v)| *v);
    found
}
