//! Brink & Alboul [BA](crate::bibliography#ba)'s conjecture, that a flip lowers the area if and
//! only if it lowers the localised Willmore energy: f_a ≤ 0 ⇔ f_l ≤ 0 (Section 4). It is false.
//!
//! By hand: (0,0,0), (3,0,0), (0,4,0), (1,0,1) as i, j, k, l have f_a = 15/2 − 2√2 − √89/2 =
//! −0.0454 and f_l = +0.0068. It looks true because both signs are that of the Delaunay test
//! where the four points are nearly coplanar (for the area Rippa's theorem; for f_l so in
//! experiments); away from that the share of counterexamples grows like a power
//! of the angle between the faces, of the order of 1.5 to 2.

use super::reduction::Quad;
use crate::mesh::flip::Flippable;
use crate::mesh::{Edge, HalfedgeMesh};
use glam::DVec3;
use serde::Serialize;

/// Reductions up to this are zero but for rounding, as a share of the area or in radians.
const ROUNDING: f64 = 1e-13;

/// Both reductions of one edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reductions {
    /// f_a, Eq. (1), over the area of the two triangles.
    pub area: f64,
    /// f_l, Eq. (5), in radians.
    pub localised: f64,
    /// Whether f_a > 0, by more than rounding.
    pub lowers_area: bool,
    /// Whether f_l > 0, by more than rounding.
    pub lowers_localised: bool,
    /// Whether all four points lie in a plane.
    pub coplanar: bool,
}

impl Reductions {
    /// Of the edge (i, j) of a quadrilateral.
    pub fn of(quad: &Quad) -> Self {
        let total = quad.area();
        let area = if total > 0.0 {
            quad.area_reduction() / total
        } else {
            0.0
        };
        let localised = quad.localised_reduction();
        Self {
            area,
            localised,
            lowers_area: area > ROUNDING,
            lowers_localised: localised > ROUNDING,
            coplanar: quad.flatness() < ROUNDING,
        }
    }

    /// Whether the conjecture holds here, or cannot be decided: a reduction of zero but for
    /// rounding says nothing, with one exception. In a plane every convex quadrilateral has
    /// f_a = 0 exactly, and one with f_l > 0 is a counterexample.
    pub fn agree(&self) -> bool {
        let against_area = self.lowers_area && self.localised < -ROUNDING;
        let keeps_area = self.area < -ROUNDING || (self.coplanar && !self.lowers_area);
        let against_localised = self.lowers_localised && keeps_area;
        !against_area && !against_localised
    }
}

/// Both reductions of every edge that can be flipped.
pub fn survey(mesh: &HalfedgeMesh, x: &[DVec3]) -> Vec<(Edge, Reductions)> {
    mesh.edges()
        .filter(|&e| mesh.flippable(e) == Flippable::Yes)
        .map(|e| (e, Reductions::of(&Quad::of(mesh, x, e))))
        .collect()
}

/// How many edges there are in each quadrant.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Quadrants {
    /// The flip lowers both.
    pub both: usize,
    /// It lowers neither.
    pub neither: usize,
    /// It lowers the area only: a counterexample.
    pub area_only: usize,
    /// It lowers the localised energy only: a counterexample.
    pub localised_only: usize,
}

impl Quadrants {
    /// Counts one edge.
    pub fn add(&mut self, reductions: &Reductions) {
        *match (reductions.lowers_area, reductions.agree()) {
            (true, true) => &mut self.both,
            (false, true) => &mut self.neither,
            (true, false) => &mut self.area_only,
            (false, false) => &mut self.localised_only,
        } += 1;
    }

    /// Edges in all.
    pub fn total(&self) -> usize {
        self.both + self.neither + self.counterexamples()
    }

    /// Edges that the conjecture fails on.
    pub fn counterexamples(&self) -> usize {
        self.area_only + self.localised_only
    }
}
