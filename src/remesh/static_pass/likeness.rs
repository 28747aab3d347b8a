//! How far a regularised mesh may be from the surface it came from.

use crate::geometry::measure;
use crate::geometry::nearest::TwoSided;
use crate::mesh::{HalfedgeMesh, Vertex};
use glam::DVec3;

/// Largest two-sided distance, as a share of the diagonal of the bounding box.
pub(super) const DISTANCE: f64 = 0.01;

/// Largest change of the volume, relative.
pub(super) const VOLUME: f64 = 0.02;

/// How far a side of the bounding box may move, and its extent change, relative to the extent.
pub(super) const BOX: f64 = 0.02;

/// The smallest angle that counts as good, in degrees: one that is smaller must not become
/// smaller still, and none of the others may become smaller than this.
pub(super) const ANGLE: f64 = 5.0;

/// Bounds are met with this to spare, so that they hold in a file of single precision too.
const SPARE: f64 = 0.999;

/// What would be lost.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Property {
    /// The place of the surface.
    Distance,
    /// The volume.
    Volume,
    /// The bounding box.
    Box,
    /// The smallest angle.
    Angle,
}

/// A property that is not kept, and where: at no vertex if it is not to be told.
pub(super) struct Loss {
    pub(super) of: Property,
    pub(super) at: Vec<Vertex>,
}

/// The surface at the start, which others are compared with.
pub(super) struct Likeness<'a> {
    mesh: &'a HalfedgeMesh,
    start: &'a [DVec3],
    both: TwoSided<'a>,
    diagonal: f64,
    volume: Option<f64>,
    low: DVec3,
    high: DVec3,
    angle: f64,
}

impl<'a> Likeness<'a> {
    pub(super) fn new(mesh: &'a HalfedgeMesh, x: &'a [DVec3]) -> Self {
        let (low, high) = measure::bounding_box(x);
        Self {
            mesh,
            start: x,
            both: TwoSided::new(mesh, x),
            diagonal: measure::bounding_diagonal(x),
            volume: measure::volume(mesh, x),
            low,
            high,
            angle: measure::min_angle_degrees(mesh, x),
        }
    }

    /// Two-sided distance of the surface at `y`, as a share of the diagonal.
    pub(super) fn distance(&self, y: &[DVec3]) -> f64 {
        self.both.distance(y) / self.diagonal
    }

    /// The smallest angle that a mesh may have: 5°, or that at the start.
    fn least_angle(&self) -> f64 {
        self.angle.min(ANGLE)
    }

    /// Whether the smallest angle at `y` is good, or no smaller than at the start.
    pub(super) fn keeps_angle(&self, y: &[DVec3]) -> bool {
        measure::min_angle_degrees(self.mesh, y) >= self.least_angle()
    }

    /// What the surface at `y` would have lost of its shape, the cheapest to tell first.
    pub(super) fn loss(&self, y: &[DVec3]) -> Option<Loss> {
        let lost = |of, at| Some(Loss { of, at });
        let outside = self.off_box(y);
        if !outside.is_empty() {
            return lost(Property::Box, outside);
        }
        if !self.keeps_volume(y) {
            return lost(Property::Volume, Vec::new());
        }
        let far = self.both.beyond(y, SPARE * DISTANCE * self.diagonal);
        if far.is_empty() {
            return None;
        }
        lost(Property::Distance, far)
    }

    /// Vertices of faces with a corner at `y` that is too sharp, and sharper than at `x`.
    pub(super) fn sharper(&self, x: &[DVec3], y: &[DVec3]) -> Option<Loss> {
        let mesh = self.mesh;
        let least = self.least_angle().to_radians();
        let mut at = Vec::new();
        for h in mesh.halfedges().filter(|&h| !mesh.is_boundary_halfedge(h)) {
            let corner = [mesh.tail(h), mesh.tip(h), mesh.tail(mesh.prev(h))];
            let angle = |x: &[DVec3]| {
                let [p, q, r] = corner.map(|v| x[v.index()]);
                let (u, w) = (q - p, r - p);
                u.cross(w).length().atan2(u.dot(w))
            };
            let now = angle(y);
            if now < least && now < angle(x) {
                at.extend(corner);
            }
        }
        (!at.is_empty()).then_some(Loss {
            of: Property::Angle,
            at,
        })
    }

    fn keeps_volume(&self, y: &[DVec3]) -> bool {
        match (self.volume, measure::volume(self.mesh, y)) {
            (Some(before), Some(after)) => (after - before).abs() <= SPARE * VOLUME * before.abs(),
            _ => true,
        }
    }

    /// Vertices that a side of the bounding box at `y` owes its wrong place to: those beyond
    /// it, or those that it was at.
    fn off_box(&self, y: &[DVec3]) -> Vec<Vertex> {
        let (low, high) = measure::bounding_box(y);
        let room = SPARE * BOX * (self.high - self.low);
        let (down, up) = (low - self.low, high - self.high);
        let mut at = Vec::new();
        for axis in 0..3 {
            let room = room[axis];
            // Where both have moved apart or together both are to blame.
            let room = if (up - down)[axis].abs() > room {
                0.5 * room
            } else {
                room
            };
            for (sign, moved, before) in [(-1.0, -down, self.low), (1.0, up, self.high)] {
                let moved = moved[axis];
                if moved.abs() <= room {
                    continue;
                }
                let positions = if moved > 0.0 { y } else { self.start };
                let least = if moved > 0.0 { room } else { -room };
                let beyond = |v: &Vertex| sign * (positions[v.index()] - before)[axis] > least;
                at.extend(self.mesh.vertices().filter(beyond));
            }
        }
        at
    }
}
