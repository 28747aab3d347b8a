//! Closed surfaces with their outside out, part by part.

use super::error::Repair;
use super::sides::{Side, interior_edges};
use crate::soup::PolygonSoup;
use glam::DVec3;
use std::f64::consts::{PI, TAU};

/// A part of a soup that hangs together.
#[derive(Clone, Copy)]
struct Part {
    is_closed: bool,
    volume: f64,
    area: f64,
    low: DVec3,
    high: DVec3,
    /// A vertex of it.
    place: DVec3,
}

/// Share of the volume of the ball of the same area below which an immersed surface may be half-way
/// from one side to the other.
const HALF_WAY: f64 = 0.2;

impl Part {
    /// Whether the volume alone says which side is outside.
    fn has_an_outside(&self) -> bool {
        let ball = self.area.powf(1.5) / (6.0 * PI.sqrt());
        self.volume.abs() >= HALF_WAY * ball
    }
}

/// Turns closed parts outward whose volume is negative and which lie in no other, but for immersed
/// ones that enclose next to nothing and show both sides; with them what lies in them, so that the
/// wall of a cavity keeps its side. A part within another that is as it should be stays as it is given:
/// as the wall of a cavity its volume is negative.
///
/// `part` is that of each face, of `n_parts`; neighbours agree.
pub(super) fn turn_outward(
    soup: &mut PolygonSoup,
    sides: &[Side],
    part: &[u32],
    n_parts: usize,
    repairs: &mut Vec<Repair>,
) {
    // Most surfaces are one part, open or as it should be.
    let is_closed = || 2 * interior_edges(sides).count() == sides.len();
    let volume = || soup.faces().map(|face| cone(soup, face)).sum::<f64>();
    if n_parts == 1 && !(is_closed() && volume() < 0.0) {
        return;
    }
    repairs.extend(turn_parts(soup, sides, part, n_parts));
}

deferred! {
    fn turn_parts(
        soup: &mut PolygonSoup,
        sides: &[Side],
        part: &[u32],
        n_parts: usize,
    ) -> Option<Repair> {
        let parts = parts(soup, sides, part, n_parts);
        let is_in = |inner: usize, outer: usize| {
            let [p, q] = [parts[inner], parts[outer]];
            inner != outer
                && q.is_closed
                && q.low.cmple(p.low).all()
                && p.high.cmple(q.high).all()
                && winding(soup, part, outer as u32, p.place).abs() > 0.5
        };
        let inside_out: Vec<usize> = (0..n_parts)
            .filter(|&i| parts[i].is_closed && parts[i].volume < 0.0)
            .filter(|&i| parts[i].has_an_outside() || shows_inside(soup, part, i as u32))
            .filter(|&i| (0..n_parts).all(|other| !is_in(i, other)))
            .collect();
        if inside_out.is_empty() {
            return None;
        }
        let is_turned: Vec<bool> = (0..n_parts)
            .map(|i| {
                inside_out
                    .iter()
                    .any(|&outer| i == outer || is_in(i, outer))
            })
            .collect();
        for (f, part) in part.iter().enumerate() {
            if is_turned[*part as usize] {
                let range = soup.face_starts[f] as usize..soup.face_starts[f + 1] as usize;
                soup.corners[range].reverse();
            }
        }
        let count = is_turned.iter().filter(|turned| **turned).count();
        Some(if count == n_parts {
            Repair::InsideOut
        } else {
            Repair::TurnedParts { count }
        })
    }
}

fn parts(soup: &PolygonSoup, sides: &[Side], part: &[u32], n_parts: usize) -> Vec<Part> {
    let empty = Part {
        is_closed: true,
        volume: 0.0,
        area: 0.0,
        low: DVec3::INFINITY,
        high: DVec3::NEG_INFINITY,
        place: DVec3::ZERO,
    };
    let mut parts = vec![empty; n_parts];
    for (face, p) in soup.faces().zip(part) {
        let part = &mut parts[*p as usize];
        part.place = soup.positions[face[0] as usize];
        for v in face {
            let x = soup.positions[*v as usize];
            (part.low, part.high) = (part.low.min(x), part.high.max(x));
        }
        part.volume += cone(soup, face);
        part.area += vector_area(soup, face).length();
    }
    // Sides of edges that no other face has.
    let mut open = vec![0_usize; n_parts];
    for side in sides {
        open[part[side.face as usize] as usize] += 1;
    }
    for (side, _) in interior_edges(sides) {
        open[part[side.face as usize] as usize] -= 2;
    }
    for (part, open) in parts.iter_mut().zip(open) {
        part.is_closed = open == 0;
    }
    parts
}

/// Whether a part shows its inside at the outermost vertex in each of six directions. A thin plate that
/// is inside out does; the halfway surface of an eversion shows either side in some.
fn shows_inside(soup: &PolygonSoup, part: &[u32], of: u32) -> bool {
    let faces = || {
        soup.faces()
            .zip(part)
            .filter(|(_, p)| **p == of)
            .map(|(face, _)| face)
    };
    let directions = DVec3::AXES.into_iter().flat_map(|axis| [axis, -axis]);
    directions.into_iter().all(|direction| {
        let reach = |v: &u32| soup.positions[*v as usize].dot(direction);
        let outermost = faces()
            .flatten()
            .max_by(|a, b| reach(a).total_cmp(&reach(b)));
        let there = faces().filter(|face| outermost.is_some_and(|v| face.contains(v)));
        let normal: DVec3 = there.map(|face| vector_area(soup, face)).sum();
        normal.dot(direction) < 0.0
    })
}

/// Half the sum of the cross products around a face: along its normal, as long as its area.
fn vector_area(soup: &PolygonSoup, face: &[u32]) -> DVec3 {
    let triangles = fans(soup, face, soup.positions[face[0] as usize]);
    triangles.map(|[_, b, c]| 0.5 * b.cross(c)).sum()
}

/// Signed volume of the cone from the first vertex over a face.
fn cone(soup: &PolygonSoup, face: &[u32]) -> f64 {
    let triangles = fans(soup, face, soup.positions[0]);
    triangles.map(|[a, b, c]| a.dot(b.cross(c))).sum::<f64>() / 6.0
}

/// The triangles of a face, relative to a point.
fn fans<'a>(
    soup: &'a PolygonSoup,
    face: &'a [u32],
    from: DVec3,
) -> impl Iterator<Item = [DVec3; 3]> + 'a {
    let x = move |v: u32| soup.positions[v as usize] - from;
    face[1..]
        .windows(2)
        .map(move |w| [x(face[0]), x(w[0]), x(w[1])])
}

/// How often a part goes around a point: the sum of its solid angles over 4π. That of a triangle
/// a, b, c is 2 atan2(a·(b × c), |a||b||c| + (a·b)|c| + (b·c)|a| + (c·a)|b|) (Van Oosterom and
/// Strackee, 1983).
fn winding(soup: &PolygonSoup, part: &[u32], of: u32, point: DVec3) -> f64 {
    let faces = soup.faces().zip(part).filter(|(_, p)| **p == of);
    let halves = faces
        .flat_map(|(face, _)| fans(soup, face, point))
        .map(|[a, b, c]| {
            let [p, q, r] = [a, b, c].map(DVec3::length);
            let below = p * q * r + a.dot(b) * r + b.dot(c) * p + c.dot(a) * q;
            a.dot(b.cross(c)).atan2(below)
        });
    halves.sum::<f64>() / TAU
}
