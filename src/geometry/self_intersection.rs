//! Where a surface passes through itself: the pairs of its triangles that do.
//!
//! Two triangles *pass through each other* where the surface crosses itself along a segment in
//! both. Touching is no crossing: sheets that lie on one another in a plane, or meet in a point,
//! a vertex or an edge and stay on their sides, are not reported; nor are sheets that lie on one
//! another for a while and part to opposite sides, along that stretch. Three cases are told apart
//! by the line in which the planes of the two triangles meet (Möller
//! [M97](crate::bibliography#m97) looks for the first one only):
//!
//! 1. The insides of both overlap along it. This is all there is in general position; of
//!    triangles with a common vertex too, where the opposite edge of one goes through the other.
//! 2. An edge of one lies inside the other: they cross if the two faces at that edge lie on
//!    opposite sides.
//! 3. An edge of one lies on an edge of the other, which is not the same edge: they cross if the
//!    half-planes of the four faces alternate around it.
//!
//! The last two are what symmetric surfaces with matching rows of vertices are made of. Triangles
//! with a common edge are reported where one is folded onto the other, within
//! [`ALIGNED`]; otherwise they have nothing but that edge in common.
//!
//! Exact predicates would answer another question: faces that touch in the file, turned by any
//! angle, cross by a rounding error. Therefore depths below [`CONTACT`] of the surface's size are
//! contact, which is what single precision, as of many files, makes of it. Of triangles that
//! have no plane to speak of, corners being collinear, nothing is reported: their neighbours
//! tell.

use super::face_tree::FaceTree;
use super::measure::{bounding_diagonal, triangle_points};
use crate::mesh::{Face, HalfedgeMesh, Vertex};
use glam::DVec3;

/// Depth of a crossing that counts as contact, in diagonals of the bounding box: 2⁻²², twice
/// what single precision distinguishes.
pub const CONTACT: f64 = 1.0 / 4_194_304.0;

/// Angle in radians below which two half-planes at an edge are the same.
pub const ALIGNED: f64 = 1e-4;

/// Boxes to compare, for each triangle of a surface, at least: measured, 23 to 28. Where that is more
/// than there may be, nothing is begun.
const FEWEST: usize = 16;

/// Height over longest edge below which a triangle has no plane in double precision.
const COLLINEAR: f64 = 1e-9;

/// The pairs of triangles that pass through each other or are folded onto each other: each once,
/// the smaller number first, sorted. The mesh must have triangles only.
///
/// Neither scale, place nor the numbering of the elements changes the pairs.
pub fn pairs(mesh: &HalfedgeMesh, x: &[DVec3]) -> Vec<[Face; 2]> {
    // No memory holds a mesh for which that would not be enough.
    pairs_within(mesh, x, usize::MAX).unwrap_or_default()
}

/// The same; `None` if there are more than `most` boxes to compare, as in a heap of triangles that
/// are all in one place. See [`FaceTree::overlapping_pairs`] for how many it takes.
pub fn pairs_within(mesh: &HalfedgeMesh, x: &[DVec3], most: usize) -> Option<Vec<[Face; 2]>> {
    let mut found = Vec::new();
    let is_done = meetings(mesh, x, most, |f, g, _| found.push([f.min(g), f.max(g)]));
    found.sort_unstable();
    is_done.then_some(found)
}

/// The double curves: a segment for each pair that meets along one, in no order. Triangles folded
/// onto each other have none. `None` as of [`pairs_within`].
pub fn curves_within(mesh: &HalfedgeMesh, x: &[DVec3], most: usize) -> Option<Vec<[DVec3; 2]>> {
    let mut found = Vec::new();
    let is_done = meetings(mesh, x, most, |_, _, meeting| {
        if let Meeting::Along(segment) = meeting {
            found.push(segment);
        }
    });
    is_done.then_some(found)
}

/// How two triangles meet.
enum Meeting {
    /// One on the other.
    Folded,
    /// From the first to the second point.
    Along([DVec3; 2]),
}

/// Tells of every pair; whether that was all.
fn meetings(
    mesh: &HalfedgeMesh,
    x: &[DVec3],
    most: usize,
    mut tell: impl FnMut(Face, Face, Meeting),
) -> bool {
    if mesh.n_faces().saturating_mul(FEWEST) > most {
        return false;
    }
    let contact = CONTACT * bounding_diagonal(x);
    let surface = Surface {
        mesh,
        x,
        normals: mesh.faces().map(|f| unit_normal(mesh, x, f)).collect(),
        contact,
    };
    let tree = FaceTree::new(mesh, x, contact);
    tree.overlapping_pairs(most, |f, g| {
        if let Some(meeting) = surface.meeting(f, g) {
            tell(f, g, meeting);
        }
    })
}

/// The triangles of pairs, each once, sorted.
pub fn triangles(pairs: &[[Face; 2]]) -> Vec<Face> {
    let mut faces: Vec<Face> = pairs.iter().flatten().copied().collect();
    faces.sort_unstable();
    faces.dedup();
    faces
}

/// Zero where the corners are collinear.
fn unit_normal(mesh: &HalfedgeMesh, x: &[DVec3], f: Face) -> DVec3 {
    let [a, b, c] = triangle_points(mesh, x, f);
    let (u, v, w) = (b - a, c - b, a - c);
    let longest = u
        .length_squared()
        .max(v.length_squared())
        .max(w.length_squared());
    let normal = u.cross(-w);
    if normal.length() > COLLINEAR * longest {
        normal.normalize()
    } else {
        DVec3::ZERO
    }
}

struct Surface<'a> {
    mesh: &'a HalfedgeMesh,
    x: &'a [DVec3],
    normals: Vec<DVec3>,
    /// Unit length.
    contact: f64,
}

/// How a triangle lies to a plane, contact being none.
#[derive(Clone, Copy, PartialEq)]
enum Pose {
    /// On one side, or with a corner in it at most, or all in it.
    Apart,
    /// With corners on both sides.
    Through,
    /// With this edge, from the corner of that number to the next, in it and the third corner
    /// not.
    Along(usize),
}

/// A triangle beside another one.
struct Placed {
    face: Face,
    points: [DVec3; 3],
    /// Of the corners over the other's plane.
    heights: [f64; 3],
    pose: Pose,
}

impl Surface<'_> {
    fn at(&self, v: Vertex) -> DVec3 {
        self.x[v.index()]
    }

    fn meeting(&self, f: Face, g: Face) -> Option<Meeting> {
        let (normal_f, normal_g) = (self.normals[f.index()], self.normals[g.index()]);
        if normal_f == DVec3::ZERO || normal_g == DVec3::ZERO {
            return None;
        }
        let (own, other) = (self.mesh.triangle(f), self.mesh.triangle(g));
        match own.iter().filter(|v| other.contains(v)).count() {
            0 | 1 => {}
            2 => return self.is_folded_onto(own, other).then_some(Meeting::Folded),
            _ => return Some(Meeting::Folded),
        }
        let a = self.placed(f, own, (self.at(other[0]), normal_g))?;
        let b = self.placed(g, other, (self.at(own[0]), normal_f))?;
        // As long as the sine of the angle between the planes.
        let along = normal_f.cross(normal_g);
        let (sine, line) = (along.length(), along.try_normalize()?);
        let place = |p: &DVec3| (*p - a.points[0]).dot(line);
        let [from, to] = common(a.extent(place)?, b.extent(place)?, place);
        if place(&to) - place(&from) <= self.contact {
            return None;
        }
        let is_through = match (a.pose, b.pose) {
            (Pose::Through, Pose::Through) => true,
            (Pose::Along(k), Pose::Through) => self.passes(&a, k, sine, normal_g, &b),
            (Pose::Through, Pose::Along(k)) => self.passes(&b, k, sine, normal_f, &a),
            (Pose::Along(k), Pose::Along(l)) => {
                self.is_on_line(&a, k, sine)
                    && self.is_on_line(&b, l, sine)
                    && self.alternate((&a, k), (&b, l), line)
            }
            _ => false,
        };
        is_through.then_some(Meeting::Along([from, to]))
    }

    /// A triangle beside the plane of another one, through a point with a unit normal; `None` where
    /// it does not reach across: of almost all pairs, which are done with then.
    fn placed(
        &self,
        face: Face,
        corners: [Vertex; 3],
        (origin, normal): (DVec3, DVec3),
    ) -> Option<Placed> {
        let points = corners.map(|v| self.at(v));
        let heights = points.map(|p| normal.dot(p - origin));
        let pose = self.pose(heights);
        (pose != Pose::Apart).then_some(Placed {
            face,
            points,
            heights,
            pose,
        })
    }

    fn pose(&self, heights: [f64; 3]) -> Pose {
        let above = heights.iter().any(|&h| h > self.contact);
        let below = heights.iter().any(|&h| h < -self.contact);
        if above && below {
            return Pose::Through;
        }
        let mut off = (0..3).filter(|&i| heights[i].abs() > self.contact);
        match (off.next(), off.next()) {
            (Some(i), None) => Pose::Along((i + 1) % 3),
            _ => Pose::Apart,
        }
    }

    /// The third corner of the face across edge `k`; none at the boundary.
    fn mate(&self, triangle: &Placed, k: usize) -> Option<DVec3> {
        let first = self.mesh.halfedge_of_face(triangle.face);
        let side = self.mesh.cycle(first).nth(k)?.twin();
        let has_face = !self.mesh.is_boundary_halfedge(side);
        has_face.then(|| self.at(self.mesh.tail(self.mesh.prev(side))))
    }

    /// Whether an edge in the plane is on the line in which the planes meet, and not only close
    /// to the plane, as it may be anywhere if they are nearly the same.
    fn is_on_line(&self, triangle: &Placed, k: usize, sine: f64) -> bool {
        let ends = [triangle.heights[k], triangle.heights[(k + 1) % 3]];
        ends.iter().all(|h| h.abs() <= 8.0 * self.contact * sine)
    }

    /// Whether the faces at an edge inside of `through` lie on opposite sides of it.
    fn passes(&self, a: &Placed, k: usize, sine: f64, normal: DVec3, through: &Placed) -> bool {
        let Some(mate) = self.mate(a, k) else {
            return false;
        };
        let apex = a.heights[(k + 2) % 3];
        let height = normal.dot(mate - through.points[0]);
        self.is_on_line(a, k, sine) && height.abs() > self.contact && height * apex < 0.0
    }

    /// Whether the half-planes of the faces at two edges on the same line alternate around it.
    fn alternate(&self, (a, k): (&Placed, usize), (b, l): (&Placed, usize), line: DVec3) -> bool {
        let (Some(mate_a), Some(mate_b)) = (self.mate(a, k), self.mate(b, l)) else {
            return false;
        };
        let zero = a.points[(k + 2) % 3] - a.points[k];
        let across = line.cross(zero);
        let turn = |point: DVec3, edge: DVec3| {
            let direction = point - edge;
            let straight = direction.dot(zero.reject_from_normalized(line));
            let angle = (direction.dot(across)).atan2(straight);
            angle.rem_euclid(std::f64::consts::TAU)
        };
        let half = turn(mate_a, a.points[k]);
        let is_between = |angle: f64| angle > ALIGNED && angle < half - ALIGNED;
        let is_beyond =
            |angle: f64| angle > half + ALIGNED && angle < std::f64::consts::TAU - ALIGNED;
        let apex = turn(b.points[(l + 2) % 3], b.points[l]);
        let mate = turn(mate_b, b.points[l]);
        (is_between(apex) && is_beyond(mate)) || (is_between(mate) && is_beyond(apex))
    }

    /// Whether two triangles with a common edge lie on the same side of it and in one plane.
    fn is_folded_onto(&self, own: [Vertex; 3], other: [Vertex; 3]) -> bool {
        let apex = |of: [Vertex; 3], but: [Vertex; 3]| of.into_iter().find(|v| !but.contains(v));
        let mut common = own.into_iter().filter(|v| other.contains(v));
        let (Some(p), Some(q), Some(a), Some(b)) = (
            common.next(),
            common.next(),
            apex(own, other),
            apex(other, own),
        ) else {
            return false;
        };
        let Some(edge) = (self.at(q) - self.at(p)).try_normalize() else {
            return false;
        };
        let half_plane = |v: Vertex| (self.at(v) - self.at(p)).reject_from_normalized(edge);
        let (u, v) = (half_plane(a), half_plane(b));
        u.cross(v).length().atan2(u.dot(v)) < ALIGNED
    }
}

/// Of two segments on a line the later beginning and the earlier end.
fn common(a: [DVec3; 2], b: [DVec3; 2], place: impl Fn(&DVec3) -> f64) -> [DVec3; 2] {
    let from = if place(&a[0]) > place(&b[0]) { a } else { b };
    let to = if place(&a[1]) < place(&b[1]) { a } else { b };
    [from[0], to[1]]
}

impl Placed {
    /// From where to where it reaches in the plane of the other triangle, along a line.
    fn extent(&self, place: impl Fn(&DVec3) -> f64) -> Option<[DVec3; 2]> {
        let mut met = Vec::with_capacity(3);
        if let Pose::Along(k) = self.pose {
            met.extend([self.points[k], self.points[(k + 1) % 3]]);
        } else {
            for i in 0..3 {
                let j = (i + 1) % 3;
                let (h, k) = (self.heights[i], self.heights[j]);
                if h == 0.0 {
                    met.push(self.points[i]);
                } else if h * k < 0.0 {
                    met.push(self.points[i].lerp(self.points[j], h / (h - k)));
                }
            }
        }
        let by_place = |p: &DVec3, q: &DVec3| place(p).total_cmp(&place(q));
        let first = met.iter().copied().min_by(by_place)?;
        let last = met.iter().copied().max_by(by_place)?;
        Some([first, last])
    }
}
