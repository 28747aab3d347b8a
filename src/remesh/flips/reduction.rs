//! What an edge flip takes off each of the three costs of Brink & Alboul
//! [BA](crate::bibliography#ba): f(e) = before − after, so positive is an improvement. (The
//! printed text has the sign both ways.)

use crate::energy::circle::angle::diamond_angle;
use crate::geometry::measure::triangle_angles;
use crate::mesh::{Edge, Halfedge, HalfedgeMesh, Vertex};
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// A flip must gain more than this share of the area of its two triangles: f_a falls like
/// the fourth power of their size, and an absolute bound would stop fine meshes silently.
const LEAST_AREA_GAIN: f64 = 1e-12;
/// A flip must take more than this off the angles.
const LEAST_ANGLE_GAIN: f64 = 1e-11;

/// What is to become small.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum Criterion {
    /// Surface area.
    Area,
    /// The circle-angle Willmore energy.
    Willmore,
    /// Willmore energy localised at the edge: of a vertex placed at its midpoint. In
    /// experiments it ends at the lowest Willmore energy of the three.
    #[default]
    Localised,
}

impl Criterion {
    /// All three, in the order of the paper.
    pub const ALL: [Self; 3] = [Self::Area, Self::Willmore, Self::Localised];

    /// What a reduction must exceed to be more than rounding.
    pub fn threshold(self, quad: &Quad) -> f64 {
        match self {
            Self::Area => LEAST_AREA_GAIN * quad.area(),
            _ => LEAST_ANGLE_GAIN,
        }
    }
}

/// The quadrilateral about an interior edge (i, j): apexes k and l.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quad {
    /// One end of the edge.
    pub i: DVec3,
    /// The other end.
    pub j: DVec3,
    /// Apex on the one side.
    pub k: DVec3,
    /// Apex on the other.
    pub l: DVec3,
}

fn area(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    0.5 * (b - a).cross(c - a).length()
}

/// β of the edge (a, b) between apexes c and d.
fn beta(a: DVec3, b: DVec3, c: DVec3, d: DVec3) -> f64 {
    diamond_angle(c, b, d, a).beta
}

impl Quad {
    /// The quadrilateral of an interior edge of a triangle mesh.
    pub fn of(mesh: &HalfedgeMesh, x: &[DVec3], e: Edge) -> Self {
        let at = |v: Vertex| x[v.index()];
        let ([i, j], [k, l]) = (mesh.ends(e).map(at), mesh.opposite_vertices(e).map(at));
        Self { i, j, k, l }
    }

    /// Area of the two triangles about (i, j).
    pub fn area(&self) -> f64 {
        area(self.i, self.k, self.j) + area(self.i, self.j, self.l)
    }

    /// f_a, Eq. (1): the area of the two triangles less that of those about (k, l).
    pub fn area_reduction(&self) -> f64 {
        self.area() - area(self.k, self.l, self.i) - area(self.k, self.l, self.j)
    }

    /// f_l, Eq. (5): the Willmore energy of a vertex at the middle of (i, j), joined to all
    /// four, less that of one at the middle of (k, l).
    pub fn localised_reduction(&self) -> f64 {
        let Self { i, j, k, l } = *self;
        let around =
            |m: DVec3| beta(m, i, l, k) + beta(m, j, k, l) + beta(m, k, i, j) + beta(m, l, j, i);
        around(0.5 * (i + j)) - around(0.5 * (k + l))
    }

    /// The quadrilateral after the flip: its edge is (k, l).
    pub fn flipped(&self) -> Self {
        let Self { i, j, k, l } = *self;
        Self {
            i: l,
            j: k,
            k: i,
            l: j,
        }
    }

    /// |det(j − i, k − i, l − i)| over the product of the three lengths: 0 in a plane.
    pub fn flatness(&self) -> f64 {
        let [a, b, c] = [self.j, self.k, self.l].map(|p| p - self.i);
        let product = a.length() * b.length() * c.length();
        if product > 0.0 {
            (a.cross(b).dot(c) / product).abs()
        } else {
            0.0
        }
    }

    /// Angle between the normals of the two triangles about (i, j), in degrees: 0 where they
    /// are coplanar, 180 where one lies on the other.
    pub fn fold_degrees(&self) -> f64 {
        let Self { i, j, k, l } = *self;
        let (m, n) = ((k - j).cross(i - j), (l - i).cross(j - i));
        m.cross(n).length().atan2(m.dot(n)).to_degrees()
    }

    /// Smallest angle of the two triangles about (i, j), in degrees.
    pub fn min_angle_degrees(&self) -> f64 {
        let angles = [[self.i, self.k, self.j], [self.i, self.j, self.l]].map(triangle_angles);
        angles
            .iter()
            .flatten()
            .fold(f64::INFINITY, |least, a| least.min(a.to_degrees()))
    }
}

/// Apex across a side of the quadrilateral, if there is a face.
fn across(mesh: &HalfedgeMesh, side: Halfedge) -> Option<Vertex> {
    let far = side.twin();
    (!mesh.is_boundary_halfedge(far)).then(|| mesh.tail(mesh.prev(far)))
}

/// f_w, Eq. (4) with its third term β_jkiv: twice the decrease of Σβ over the four sides of
/// the quadrilateral, as each angle counts at both ends of its edge; the angle of the edge
/// itself is that of the other diagonal. A side on the boundary has no angle.
pub fn willmore_reduction(mesh: &HalfedgeMesh, x: &[DVec3], e: Edge) -> f64 {
    let h = e.halfedge();
    let at = |v: Vertex| x[v.index()];
    let [k, l] = mesh.opposite_vertices(e).map(at);
    let mut sum = 0.0;
    for (first, apex, other) in [(h, at(mesh.tail(h)), l), (h.twin(), at(mesh.tip(h)), k)] {
        // The two further sides of the triangle of `first`: from its tip, and to its tail.
        let (from_tip, to_tail) = (mesh.next(first), mesh.prev(first));
        let far_end = at(mesh.tip(first));
        for (side, inner) in [(from_tip, apex), (to_tail, far_end)] {
            if let Some(outer) = across(mesh, side) {
                let [a, b] = [mesh.tail(side), mesh.tip(side)].map(at);
                sum += beta(a, b, inner, at(outer)) - beta(a, b, other, at(outer));
            }
        }
    }
    2.0 * sum
}
