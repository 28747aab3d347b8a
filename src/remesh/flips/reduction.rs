//! What an edge flip takes off each of the three costs of Brink & Alboul
//! [BA](crate::bibliography#ba): f(e) = before − after, so positive is an improvement. (The
//! printed text has the sign both ways.)

use crate::energy::circle::angle::{diamond_angle, diamond_parts};
use crate::geometry::measure::triangle_angles;
use crate::mesh::{Edge, Halfedge, HalfedgeMesh, Vertex};
use glam::{DVec2, DVec3};
use serde::{Deserialize, Serialize};

/// An angle beyond this is not zero, whatever the rounding.
const SURE: f64 = 1e-9;

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
        let ([i, j], [k, l]) = (mesh.ends(e), mesh.opposite_vertices(e));
        Self {
            i: at(i),
            j: at(j),
            k: at(k),
            l: at(l),
        }
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

    /// Whether f_l is below zero by more than rounding, as is found without an arc tangent:
    /// most edges are like that. False also where that cannot be told so.
    ///
    /// The angles of each middle add up as their cosines and sines multiply, as complex numbers,
    /// up to whole turns. As the energy of a vertex is not negative they are one turn at least,
    /// and four angles are two at most; so where both products lie above the real axis, both sums
    /// are in the first half of the second turn, and their difference has the sign of its sine.
    pub fn surely_loses(&self) -> bool {
        let Self { i, j, k, l } = *self;
        let scale = (i - j).length_squared() * (k - l).length_squared();
        let inverse = scale.recip();
        let phase = |a, b, c, d| {
            let (sine, cosine) = diamond_parts(c, b, d, a);
            DVec2::new(cosine, sine) * inverse
        };
        let around = |m: DVec3| {
            let ends = phase(m, i, l, k).rotate(phase(m, j, k, l));
            ends.rotate(phase(m, k, i, j).rotate(phase(m, l, j, i)))
        };
        let is_above = |z: DVec2| z.y > 0.0 && z.y * z.y > SURE * SURE * z.length_squared();
        let before = around(0.5 * (i + j));
        let after = around(0.5 * (k + l));
        let sine = after.perp_dot(before);
        let both = before.length_squared() * after.length_squared();
        is_above(before) && is_above(after) && sine < 0.0 && sine * sine > SURE * SURE * both
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

/// f_w, Eq. (4) with its third term β_jkiv: twice the decrease of Σβ over the four sides of
/// the quadrilateral, as each angle counts at both ends of its edge; the angle of the edge
/// itself is that of the other diagonal. A side on the boundary has no angle.
pub fn willmore_reduction(mesh: &HalfedgeMesh, x: &[DVec3], e: Edge) -> f64 {
    reduction_by_sides(mesh, e, |first, of_first, side| {
        side_angle(mesh, x, side) - side_angle_beyond(mesh, x, first, of_first)
    })
}

/// The four sides of the quadrilateral about an edge, each with the side of the edge in whose
/// triangle it lies and whether it is the next (0) or the previous one (1) there.
pub(super) fn sides(mesh: &HalfedgeMesh, e: Edge) -> [(Halfedge, usize, Halfedge); 4] {
    let h = e.halfedge();
    let t = h.twin();
    [
        (h, 0, mesh.next(h)),
        (h, 1, mesh.prev(h)),
        (t, 0, mesh.next(t)),
        (t, 1, mesh.prev(t)),
    ]
}

/// Twice the sum of a term over [`sides`].
pub(super) fn reduction_by_sides(
    mesh: &HalfedgeMesh,
    e: Edge,
    term: impl Fn(Halfedge, usize, Halfedge) -> f64,
) -> f64 {
    let mut sum = 0.0;
    for (first, place, side) in sides(mesh, e) {
        sum += term(first, place, side);
    }
    2.0 * sum
}

/// Where the apex of the triangle is that a half-edge is a side of.
fn apex(mesh: &HalfedgeMesh, x: &[DVec3], h: Halfedge) -> DVec3 {
    x[mesh.tail(mesh.prev(h)).index()]
}

/// β of the edge of a half-edge between two apexes; 0 on the boundary.
fn angle_at(mesh: &HalfedgeMesh, x: &[DVec3], side: Halfedge, inner: DVec3, outer: DVec3) -> f64 {
    if mesh.is_boundary_edge(side.edge()) {
        return 0.0;
    }
    let (a, b) = (x[mesh.tail(side).index()], x[mesh.tip(side).index()]);
    beta(a, b, inner, outer)
}

/// β of the edge of a half-edge, from its triangle outwards; 0 on the boundary.
pub(super) fn side_angle(mesh: &HalfedgeMesh, x: &[DVec3], side: Halfedge) -> f64 {
    let (inner, outer) = (apex(mesh, x, side), apex(mesh, x, side.twin()));
    angle_at(mesh, x, side, inner, outer)
}

/// β of the next (0) or the previous (1) side of the triangle of `first` once the edge of
/// `first` is flipped: the apex within is then that across the edge. 0 on the boundary.
pub(super) fn side_angle_beyond(
    mesh: &HalfedgeMesh,
    x: &[DVec3],
    first: Halfedge,
    place: usize,
) -> f64 {
    let side = match place {
        0 => mesh.next(first),
        _ => mesh.prev(first),
    };
    let (inner, outer) = (apex(mesh, x, first.twin()), apex(mesh, x, side.twin()));
    angle_at(mesh, x, side, inner, outer)
}
