//! Repairs that are safe: what they drop or split changes no surface. Each leaves a
//! warning.

use super::duplicate::duplicate_faces;
use super::error::Repair;
use super::sides::{Side, face_adjacency, interior_edges};
use crate::order;
use crate::soup::{PolygonSoup, cut_bridged};
use glam::DVec3;

/// Area below which a piece has none, over the square of the diagonal of its own box.
const NEGLIGIBLE: f64 = 1e-14;

/// Drops degenerate and duplicate faces; one that has a hole, which a bridge leads to, is cut into
/// triangles.
pub(crate) fn clean_faces(soup: &PolygonSoup, repairs: &mut Vec<Repair>) -> PolygonSoup {
    let mut clean = PolygonSoup {
        positions: soup.positions.clone(),
        ..PolygonSoup::default()
    };
    clean.corners.reserve(soup.corners.len());
    clean.face_starts.reserve(soup.n_faces());
    let (mut degenerate, mut first_degenerate) = (0usize, 0usize);
    let (mut bridged, mut spiked) = (0, 0);
    let mut corners: Vec<u32> = Vec::new();
    let mut sorted: Vec<u32> = Vec::new();
    for (f, face) in soup.faces().enumerate() {
        corners.clear();
        corners.extend_from_slice(face);
        corners.dedup();
        if corners.len() > 1 && corners.first() == corners.last() {
            corners.pop();
        }
        sorted.clear();
        sorted.extend_from_slice(&corners);
        sorted.sort_unstable();
        let is_repeated = sorted.windows(2).any(|w| w[0] == w[1]);
        if corners.len() < 3 || is_repeated {
            let triangles = cut_bridged(&corners, &soup.positions);
            if !triangles.is_empty() {
                bridged += 1;
                triangles.iter().for_each(|t| clean.push_face(t));
                continue;
            }
            if cut_spikes(&mut corners) {
                spiked += 1;
                clean.push_face(&corners);
                continue;
            }
            if degenerate == 0 {
                first_degenerate = f;
            }
            degenerate += 1;
            continue;
        }
        clean.push_face(&corners);
    }
    if degenerate > 0 {
        repairs.push(Repair::DegenerateFaces {
            count: degenerate,
            face: first_degenerate,
            first: 0,
        });
    }
    if bridged > 0 {
        repairs.push(Repair::BridgedFaces { count: bridged });
    }
    if spiked > 0 {
        repairs.push(Repair::SpikedFaces { count: spiked });
    }
    let duplicates = duplicate_faces(&clean);
    if !duplicates.is_empty() {
        repairs.push(Repair::DuplicateFaces {
            count: duplicates.len(),
        });
        retain_faces(&mut clean, |f| duplicates.binary_search(&f).is_err());
    }
    clean
}

/// Cuts off where a polygon runs out to a vertex and back. Whether a polygon is left that passes no
/// vertex twice.
fn cut_spikes(corners: &mut Vec<u32>) -> bool {
    let at = |corners: &[u32], i: usize| corners[i % corners.len()];
    while corners.len() > 2 {
        let spike = (0..corners.len()).find(|&i| at(corners, i) == at(corners, i + 2));
        let Some(i) = spike else { break };
        // The tip, and what is the same on both sides of it.
        let tip = (i + 1) % corners.len();
        corners.remove(tip);
        corners.remove(if tip < corners.len() { tip } else { 0 });
    }
    let mut sorted = corners.clone();
    sorted.sort_unstable();
    corners.len() > 2 && sorted.windows(2).all(|pair| pair[0] != pair[1])
}

fn retain_faces(soup: &mut PolygonSoup, keep: impl Fn(usize) -> bool) {
    let old = std::mem::take(soup);
    soup.positions = old.positions;
    for f in (0..old.face_starts.len() - 1).filter(|&f| keep(f)) {
        let range = old.face_starts[f] as usize..old.face_starts[f + 1] as usize;
        soup.push_face(&old.corners[range]);
    }
}

fn find(parent: &mut [u32], mut i: u32) -> u32 {
    while parent[i as usize] != i {
        parent[i as usize] = parent[parent[i as usize] as usize];
        i = parent[i as usize];
    }
    i
}

/// Gives every fan of faces its own vertex. Answers the soup vertex of each vertex:
/// the first fan keeps the vertex, further fans get copies at the end.
pub(super) fn split_vertices(
    soup: &mut PolygonSoup,
    sides: &[Side],
    repairs: &mut Vec<Repair>,
) -> Vec<u32> {
    // Corners of one fan are joined across interior edges.
    let mut parent: Vec<u32> = (0..soup.corners.len() as u32).collect();
    let next = |s: Side| {
        let [from, to] = [s.face as usize, s.face as usize + 1].map(|f| soup.face_starts[f]);
        if s.corner + 1 == to {
            from
        } else {
            s.corner + 1
        }
    };
    for (s, t) in interior_edges(sides) {
        let (mut p, mut q) = ([s.corner, next(s)], [t.corner, next(t)]);
        if soup.corners[p[0] as usize] != soup.corners[q[0] as usize] {
            q.swap(0, 1);
        }
        for (a, b) in p.iter_mut().zip(q) {
            let (a, b) = (find(&mut parent, *a), find(&mut parent, b));
            parent[a.max(b) as usize] = a.min(b);
        }
    }
    let mut origin: Vec<u32> = (0..soup.positions.len() as u32).collect();
    let mut fan_of_vertex = vec![u32::MAX; soup.positions.len()];
    // A fan is named by one of its corners.
    let mut copy_of_fan = vec![None; soup.corners.len()];
    let mut split = Vec::new();
    for c in 0..soup.corners.len() {
        let v = soup.corners[c];
        let fan = find(&mut parent, c as u32);
        if fan_of_vertex[v as usize] == u32::MAX {
            fan_of_vertex[v as usize] = fan;
        }
        if fan_of_vertex[v as usize] != fan {
            let copy = *copy_of_fan[fan as usize].get_or_insert_with(|| {
                soup.positions.push(soup.positions[v as usize]);
                origin.push(v);
                split.push(v);
                origin.len() as u32 - 1
            });
            soup.corners[c] = copy;
        }
    }
    if !split.is_empty() {
        order::sort(&mut split);
        split.dedup();
        repairs.push(Repair::SplitVertices {
            count: split.len(),
            vertices: split,
            first: 0,
        });
    }
    origin
}

/// Drops components that have no area at all, by their own size and not by that of others: they are
/// debris, and no curvature is defined anywhere on them.
pub(super) fn drop_flat_components(
    soup: &mut PolygonSoup,
    sides: &[Side],
    repairs: &mut Vec<Repair>,
) {
    let (start, list) = face_adjacency(soup, sides);
    let area = |f: usize| {
        let x = |v: u32| soup.positions[v as usize];
        let face = soup.face(f);
        face[1..]
            .windows(2)
            .map(|w| (x(w[0]) - x(face[0])).cross(x(w[1]) - x(face[0])).length())
            .sum::<f64>()
    };
    let mut flat = vec![None; soup.n_faces()];
    for seed in 0..soup.n_faces() {
        if flat[seed].is_some() {
            continue;
        }
        let mut component = vec![seed as u32];
        flat[seed] = Some(true);
        let (mut at, mut total) = (0, 0.0f64);
        let (mut low, mut high) = (DVec3::INFINITY, DVec3::NEG_INFINITY);
        while at < component.len() {
            let f = component[at] as usize;
            at += 1;
            total += area(f);
            for &v in soup.face(f) {
                let p = soup.positions[v as usize];
                (low, high) = (low.min(p), high.max(p));
            }
            for &(g, _) in &list[start[f] as usize..start[f + 1] as usize] {
                if flat[g as usize].is_none() {
                    flat[g as usize] = Some(true);
                    component.push(g);
                }
            }
        }
        if total > NEGLIGIBLE * (high - low).length_squared() {
            for &f in &component {
                flat[f as usize] = Some(false);
            }
        }
    }
    let dropped = flat.iter().filter(|&&f| f == Some(true)).count();
    if dropped > 0 {
        repairs.push(Repair::FlatPieces { count: dropped });
        retain_faces(soup, |f| flat[f] != Some(true));
    }
}

/// Removes vertices of no face; answers the soup vertex of each that is left.
pub(super) fn drop_unused_vertices(
    soup: &mut PolygonSoup,
    origin: &[u32],
    input: &PolygonSoup,
    repairs: &mut Vec<Repair>,
) -> Vec<u32> {
    let mut name = vec![u32::MAX; soup.positions.len()];
    for &v in &soup.corners {
        name[v as usize] = 0;
    }
    let mut kept = Vec::new();
    for (v, name) in name.iter_mut().enumerate().filter(|(_, name)| **name == 0) {
        *name = kept.len() as u32;
        kept.push(v);
    }
    let n_unused = {
        let mut used = vec![false; input.positions.len()];
        kept.iter().for_each(|&v| used[origin[v] as usize] = true);
        used.iter().filter(|&&u| !u).count()
    };
    if n_unused > 0 {
        repairs.push(Repair::UnusedVertices { count: n_unused });
    }
    soup.corners.iter_mut().for_each(|v| *v = name[*v as usize]);
    soup.positions = kept.iter().map(|&v| soup.positions[v]).collect();
    kept.into_iter().map(|v| origin[v]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_spike_is_cut_off_and_the_face_kept() {
        for (spiked, plain) in [
            (vec![0, 1, 2, 3, 9, 3], Some(vec![0, 1, 2, 3])),
            // At the seam of the list, and one that is two sides long.
            (vec![3, 0, 1, 2, 3, 9], Some(vec![0, 1, 2, 3])),
            (vec![9, 3, 0, 1, 2, 3], Some(vec![0, 1, 2, 3])),
            (vec![0, 1, 8, 9, 8, 1, 2], Some(vec![0, 1, 2])),
            // Nothing else, and a loop that is no spike.
            (vec![0, 1, 0, 1], None),
            (vec![0, 1, 2, 0, 3, 4], None),
        ] {
            let mut corners = spiked.clone();
            let is_left = cut_spikes(&mut corners);
            assert_eq!(is_left, plain.is_some(), "{spiked:?}");
            if let Some(plain) = plain {
                let first = corners
                    .iter()
                    .position(|v| *v == plain[0])
                    .expect("a corner");
                corners.rotate_left(first);
                assert_eq!(corners, plain);
            }
        }
        // One that runs outwards, where no cut into triangles is to be had.
        let x = [(0., 0.), (1., 0.), (1., 1.), (0., 1.), (2., 2.)];
        let x = x.map(|(u, v)| glam::DVec3::new(u, v, 0.0)).to_vec();
        let soup = PolygonSoup::from_faces(x, &[vec![0, 1, 2, 4, 2, 3]]);
        let mut repairs = Vec::new();
        let clean = clean_faces(&soup, &mut repairs);
        assert_eq!(clean.faces().collect::<Vec<_>>(), [[0, 1, 2, 3]]);
        assert_eq!(repairs, [Repair::SpikedFaces { count: 1 }]);
    }
}
