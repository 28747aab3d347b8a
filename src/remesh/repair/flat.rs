//! Triangles without area, and sides without length.

use super::collapse::Collapser;
use super::faces::{Faces, sides};
use crate::geometry::quality;
use crate::order;
use crate::soup::PolygonSoup;
use glam::DVec3;

/// A side no longer than this share of the longest has no length.
const SHORT: f64 = 1e-10;

/// How a triangle has no area.
#[derive(Clone, Copy)]
enum Flat {
    /// Its third corner lies between the two others.
    Between([u32; 3]),
    /// Its first two corners lie at the same place.
    Short([u32; 2]),
}

/// `None` for a triangle with an area, and for any other face whose sides have a length.
fn flat(face: &[u32], x: &[DVec3]) -> Option<Flat> {
    let at = |v: u32| x[v as usize];
    let &[a, b, c] = face else {
        let length = |(a, b): (u32, u32)| at(a).distance_squared(at(b));
        let longest = sides(face).map(length).fold(0.0, f64::max);
        let short = sides(face).find(|&side| length(side) <= SHORT * SHORT * longest);
        return short.map(|(a, b)| Flat::Short([a, b]));
    };
    let mut sides = [[a, b, c], [b, c, a], [c, a, b]];
    let length = |s: &[u32; 3]| at(s[0]).distance_squared(at(s[1]));
    order::sort_by(&mut sides, |s, t| length(s).total_cmp(&length(t)));
    let [shortest, _, longest] = sides;
    if !quality::is_flat(longest.map(at)) {
        return None;
    }
    let is_short = length(&shortest) <= SHORT * SHORT * length(&longest);
    Some(if is_short {
        Flat::Short([shortest[0], shortest[1]])
    } else {
        Flat::Between(longest)
    })
}

/// Whether a triangle has no area, or another face a side without length.
pub(super) fn is_flat(face: &[u32], x: &[DVec3]) -> bool {
    flat(face, x).is_some()
}

/// How many there were, and their vertices.
#[derive(Default)]
pub(super) struct Dropped {
    pub(super) flat: (usize, Vec<u32>),
    pub(super) collapsed: (usize, Vec<u32>),
}

/// Drops triangles without area. Where a corner lies between the others it joins the neighbour
/// across the longest side, so that no gap is left; an edge without length is collapsed, and so is one
/// of the boundary no longer than `near`, as where each face at a pole has a pole of its own.
pub(super) fn drop_flat(soup: &mut PolygonSoup, near: f64) -> Dropped {
    let mut dropped = Dropped::default();
    let x = &soup.positions;
    let is_near = |(a, b): &(u32, u32)| x[*a as usize].distance(x[*b as usize]) <= near;
    let is_short = |face| sides(face).any(|side| is_near(&side));
    if !soup.faces().any(|face| is_flat(face, x) || is_short(face)) {
        return dropped;
    }
    let mut faces = Faces::of(soup);
    let mut collapser = Collapser::default();
    let mut collapse = |faces: &mut Faces, ends| {
        if let Some(kept) = collapser.collapse(faces, ends) {
            dropped.collapsed.0 += 1;
            dropped.collapsed.1.push(kept);
        }
    };
    // Those that an insertion makes are of the next round.
    for f in 0..faces.len() {
        let is_open = |(a, b): &(u32, u32)| faces.at(*a, *b).len() == 1;
        match flat(faces.face(f), x) {
            None => {
                let short = sides(faces.face(f)).find(|side| is_near(side) && is_open(side));
                if let Some((a, b)) = short {
                    collapse(&mut faces, [a, b]);
                }
            }
            Some(Flat::Short(ends)) => collapse(&mut faces, ends),
            Some(Flat::Between([a, b, c])) => {
                faces.remove(f);
                dropped.flat.0 += 1;
                dropped.flat.1.extend([a, b, c]);
                let is_open = |v: u32| faces.at(v, c).is_empty();
                if is_open(a) && is_open(b) {
                    continue;
                }
                // A flat neighbour goes itself: what it leaves open is closed as a junction.
                let others = faces.at(a, b).iter().copied();
                let others: Vec<u32> = others
                    .filter(|g| !is_flat(faces.face(*g as usize), x))
                    .collect();
                for g in others {
                    faces.insert(g as usize, (a, b), c);
                }
            }
        }
    }
    if dropped.flat.0 + dropped.collapsed.0 > 0 {
        faces.write_to(soup);
    }
    dropped
}
