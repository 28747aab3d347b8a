//! Boundary vertices at the same place become one.

use super::grid::Grid;
use super::{RepairChange, edges, key, named};
use crate::soup::PolygonSoup;
use glam::DVec3;
use std::collections::HashMap;

/// Vertices at an end of an edge that only one face has.
pub(super) fn boundary(soup: &PolygonSoup) -> Vec<bool> {
    let mut faces_of_edge: HashMap<(u32, u32), u32> = HashMap::new();
    for (a, b) in edges(soup) {
        *faces_of_edge.entry(key(a, b)).or_default() += 1;
    }
    let mut is_boundary = vec![false; soup.positions.len()];
    for ((a, b), _) in faces_of_edge.into_iter().filter(|(_, faces)| *faces == 1) {
        is_boundary[a as usize] = true;
        is_boundary[b as usize] = true;
    }
    is_boundary
}

/// Welds boundary vertices no farther apart than `near`: each to the first one there is. The
/// corners of one face never become one.
pub(super) fn weld(soup: &mut PolygonSoup, near: f64) -> Option<RepairChange> {
    let is_boundary = boundary(soup);
    let mut grid = Grid::new(2.0 * near);
    let mut becomes: Vec<u32> = (0..soup.positions.len() as u32).collect();
    let mut welded = Vec::new();
    for v in (0..becomes.len()).filter(|&v| is_boundary[v]) {
        let p = soup.positions[v];
        let reach = DVec3::splat(near);
        let first = grid
            .near(p - reach, p + reach)
            .filter(|&other| soup.positions[other as usize].distance(p) <= near)
            .min();
        match first {
            Some(other) => {
                becomes[v] = other;
                welded.push(other);
            }
            None => grid.insert(p, v as u32),
        }
    }
    // A face smaller than that would be no face any more.
    let (mut is_kept, mut kept) = (vec![false; becomes.len()], false);
    for face in soup.faces() {
        for (i, &a) in face.iter().enumerate() {
            for &b in &face[i + 1..] {
                if a != b && becomes[a as usize] == becomes[b as usize] {
                    is_kept[a as usize] = true;
                    is_kept[b as usize] = true;
                    kept = true;
                }
            }
        }
    }
    if kept {
        for v in (0..becomes.len()).filter(|&v| is_kept[v]) {
            becomes[v] = v as u32;
        }
    }
    let gone = (0..becomes.len()).filter(|&v| becomes[v] != v as u32);
    let count = gone.count();
    if count == 0 {
        return None;
    }
    for corner in &mut soup.corners {
        *corner = becomes[*corner as usize];
    }
    Some(RepairChange::Welded {
        count,
        vertices: named(welded),
    })
}
