//! Boundary vertices at the same place become one, where that stitches two edges.

use super::faces::Faces;
use super::grid::Grid;
use super::hash::Table;
use super::{edges, key};
use crate::order;
use crate::soup::PolygonSoup;

/// Vertices at an end of an edge that only one face has.
pub(super) fn boundary(soup: &PolygonSoup) -> Vec<bool> {
    let ends = edges(soup).map(|(a, b)| key(a, b));
    let (first, mut others) = order::bucketed(soup.positions.len(), ends);
    let mut is_boundary = vec![false; soup.positions.len()];
    for (a, range) in first.windows(2).enumerate() {
        let others = &mut others[range[0] as usize..range[1] as usize];
        others.sort_unstable();
        for b in others
            .chunk_by(|b, c| b == c)
            .filter(|same| same.len() == 1)
        {
            is_boundary[a] = true;
            is_boundary[b[0] as usize] = true;
        }
    }
    is_boundary
}

/// Welds boundary vertices no farther apart than `near`: each to the nearest of those before it.
/// The corners of one face never become one, and fans of faces stay apart that would meet in the
/// vertex alone. Gives how many vertices are gone, and those that they became.
pub(super) fn weld(soup: &mut PolygonSoup, near: f64) -> (usize, Vec<u32>) {
    let Some(becomes) = meetings(soup, near) else {
        return (0, Vec::new());
    };
    let before = soup.corners.clone();
    for corner in &mut soup.corners {
        *corner = becomes[*corner as usize];
    }
    let faces = Faces::of(soup);
    let fans = faces.fans(soup, |_, of| {
        of.windows(2).map(|pair| (pair[0], pair[1])).collect()
    });
    // The vertices that there were, fan by fan.
    let mut were: Vec<(u32, u32)> = fans.iter().copied().zip(before).collect();
    for (corner, (fan, _)) in soup.corners.iter_mut().zip(&were) {
        *corner = *fan;
    }
    order::sort(&mut were);
    were.dedup();
    let (mut count, mut vertices) = (0, Vec::new());
    let mut first = Table::default();
    for fan in were.chunk_by(|a, b| a.0 == b.0) {
        let (name, v) = fan[0];
        first.insert(name, v);
        if fan.len() > 1 {
            count += fan.len() - 1;
            vertices.push(v);
        }
    }
    for corner in &mut soup.corners {
        *corner = first.get(corner).copied().unwrap_or(*corner);
    }
    (count, vertices)
}

/// What each vertex would become; `None` where each stays itself.
fn meetings(soup: &PolygonSoup, near: f64) -> Option<Vec<u32>> {
    let is_boundary = boundary(soup);
    let x = &soup.positions;
    let mut grid = Grid::new(2.0 * near, x);
    let mut becomes: Vec<u32> = (0..x.len() as u32).collect();
    for v in (0..becomes.len()).filter(|&v| is_boundary[v]) {
        match grid.nearest(x[v], near, x) {
            Some(other) => becomes[v] = other,
            None => grid.insert(x[v], v as u32),
        }
    }
    // A face smaller than that would be no face any more.
    let mut is_kept = vec![false; becomes.len()];
    for face in soup.faces() {
        for (i, &a) in face.iter().enumerate() {
            for &b in &face[i + 1..] {
                if a != b && becomes[a as usize] == becomes[b as usize] {
                    is_kept[a as usize] = true;
                    is_kept[b as usize] = true;
                }
            }
        }
    }
    for v in (0..becomes.len()).filter(|&v| is_kept[v]) {
        becomes[v] = v as u32;
    }
    let moves = (0..becomes.len()).any(|v| becomes[v] != v as u32);
    moves.then_some(becomes)
}
