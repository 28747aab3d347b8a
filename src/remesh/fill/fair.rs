//! The patch drawn into the surface around it: polyharmonic fills of the highest order that
//! its surroundings allow.

use crate::geometry::measure::bounding_diagonal;
use crate::geometry::quality::is_folded;
use crate::linalg::LinalgError;
use crate::mesh::{Face, HalfedgeMesh, Vertex};
use crate::operator::polyharmonic;
use glam::DVec3;
use std::ops::Range;

/// The order wanted: curvatures continue across the rim.
pub(super) const ORDER: usize = 3;

/// Free vertices up to which an order is tried: beyond, its factor takes too much memory and
/// leaves too few digits.
const MOST: [(usize, usize); 2] = [(3, 60_000), (2, 120_000)];

/// A patch may grow to so many times the size of its rim.
const LARGEST: f64 = 4.0;

/// Order 3 may take a vertex so many times as far from the membrane as order 2 does, and this
/// share of the size of the rim besides. It continues the curvature of the surroundings, and
/// where they are rough there is none to continue.
const BOLDEST: (f64, f64) = (2.0, 0.05);

/// Why a lower order was used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Lowered {
    /// A boundary is closer than the order's stencil reaches.
    NearBoundary,
    /// Too many free vertices.
    Size,
    /// The higher order turned faces over or left all bounds.
    Folds,
    /// The higher order bulges far more than the lower.
    Rough,
    /// A flat side of the shape is missing.
    Side,
}

/// Fairs the vertices in `free` in place; answers the order used, 0 for none, and why it is
/// not [`ORDER`].
pub(super) fn fair(
    mesh: &HalfedgeMesh,
    x: &mut [DVec3],
    free: &Range<u32>,
    passes: usize,
    most_order: usize,
) -> Result<(usize, Option<Lowered>), LinalgError> {
    if free.is_empty() {
        return Ok((ORDER, None));
    }
    let mut is_free = vec![false; x.len()];
    is_free[free.start as usize..free.end as usize].fill(true);
    let mut lowered = None;
    let mut order = most_order.min(ORDER);
    for (limited, most) in MOST {
        if order == limited && free.len() > most {
            (order, lowered) = (limited - 1, Some(Lowered::Size));
        }
    }
    let supported = polyharmonic::supported_order(mesh, &is_free, order);
    if supported < order {
        (order, lowered) = (supported, Some(Lowered::NearBoundary));
    }
    let (faces, rim) = surroundings(mesh, &is_free);
    let folds = |x: &[DVec3]| faces.iter().filter(|&&f| is_folded(mesh, x, f)).count();
    let rim_size = bounding_diagonal(&rim.iter().map(|v| x[v.index()]).collect::<Vec<_>>());
    let range = free.start as usize..free.end as usize;
    let folds_before = folds(x);
    let attempt = |x: &[DVec3], order: usize, passes: usize| {
        let mut y = x.to_vec();
        for _ in 0..passes {
            polyharmonic::fill(mesh, &mut y, &is_free, order)?;
        }
        let patch = &y[range.clone()];
        let is_bounded =
            patch.iter().all(|p| p.is_finite()) && bounding_diagonal(patch) <= LARGEST * rim_size;
        Ok((is_bounded && folds(&y) <= folds_before).then_some(y))
    };
    while order > 0 {
        match attempt(x, order, passes) {
            Ok(Some(y)) => {
                let rough = order == ORDER
                    && is_bold(&y[range.clone()], rim_size, |k| {
                        let mut y = x.to_vec();
                        let solved = polyharmonic::fill(mesh, &mut y, &is_free, k);
                        solved.ok().map(|()| y[range.clone()].to_vec())
                    });
                if !rough {
                    x.copy_from_slice(&y);
                    break;
                }
                lowered = Some(Lowered::Rough);
            }
            Ok(None) => lowered = Some(Lowered::Folds),
            // Without memory for this order there may be some for a lower one.
            Err(error) if order == 1 => return Err(error),
            Err(_) => lowered = Some(Lowered::Size),
        }
        order -= 1;
    }
    Ok((order, lowered))
}

/// Whether the patch goes much farther from the membrane than the fill of order 2;
/// `of_order` makes both.
fn is_bold(patch: &[DVec3], rim_size: f64, of_order: impl Fn(usize) -> Option<Vec<DVec3>>) -> bool {
    let (Some(membrane), Some(plate)) = (of_order(1), of_order(2)) else {
        return false;
    };
    let farthest = |a: &[DVec3]| {
        let distances = a.iter().zip(&membrane).map(|(p, q)| p.distance(*q));
        distances.fold(0.0, f64::max)
    };
    farthest(patch) > BOLDEST.0 * farthest(&plate) + BOLDEST.1 * rim_size
}

/// The faces with a free vertex, and the held vertices of those.
fn surroundings(mesh: &HalfedgeMesh, is_free: &[bool]) -> (Vec<Face>, Vec<Vertex>) {
    let is_near = |f: &Face| mesh.triangle(*f).iter().any(|v| is_free[v.index()]);
    let faces: Vec<Face> = mesh.faces().filter(is_near).collect();
    let corners = faces.iter().flat_map(|&f| mesh.triangle(f));
    let mut rim: Vec<Vertex> = corners.filter(|v| !is_free[v.index()]).collect();
    rim.sort_unstable();
    rim.dedup();
    (faces, rim)
}
