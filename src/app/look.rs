//! Looking closer: what is drawn over the surface as segments, and told beside it.

use super::crossing;
use super::fault::Fault;
use super::probe::Probe;
use super::runner::Runner;
use super::{Session, as_f32};
use crate::arrays::TypedArray;
use crate::geometry::circumcircle::Circle;
use crate::geometry::measure;
use crate::mesh::{Face, Vertex};
use crate::operator::fitted::principal::{aligned_edges, principal_directions};
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// What to look at.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase", default, deny_unknown_fields)]
pub struct LookOptions {
    /// A vertex with its star and the circumcircles of its triangles.
    pub probe: Option<u32>,
    /// The circumcircles of all triangles.
    pub circles: bool,
    /// Principal directions.
    pub directions: bool,
    /// The curves along which the surface passes through itself.
    pub crossings: bool,
}

/// What a segment belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SegmentKind {
    /// An edge at the vertex probed.
    Spoke,
    /// A circumcircle at it.
    ProbedCircle,
    /// Any circumcircle.
    Circle,
    /// The direction of the larger principal curvature.
    Largest,
    /// That of the smaller one.
    Smallest,
    /// A double curve.
    Crossing,
}

/// Circles or crosses drawn of those there are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct Drawn {
    /// So many of them …
    pub drawn: usize,
    /// … of so many.
    pub total: usize,
    /// Left out: circles larger than the surface, umbilics.
    pub left_out: usize,
}

/// How edges lie to the lines of curvature.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct Alignment {
    /// Edges within [`ALIGNED_DEGREES`] of a line of curvature …
    pub aligned: usize,
    /// … of those not between umbilics.
    pub edges: usize,
}

/// What is seen.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Look {
    /// The vertex probed.
    pub probe: Option<Probe>,
    /// Two ends a segment, three coordinates each, relative to the mesh's frame.
    pub ends: TypedArray<f32>,
    /// The [`SegmentKind`] of each segment, by its number.
    pub kinds: TypedArray<u8>,
    /// Of all circumcircles.
    pub circles: Option<Drawn>,
    /// Of principal directions.
    pub directions: Option<Drawn>,
    /// Likewise.
    pub alignment: Option<Alignment>,
}

/// An edge is aligned within so many degrees, as where figure 8 of Bobenko & Schröder is judged;
/// 11 % of edges that know nothing of curvature are.
pub const ALIGNED_DEGREES: f64 = 5.0;

/// Circles drawn at most; of more triangles every second, third, …
pub const MAX_CIRCLES: usize = 6_000;
/// Crosses drawn at most.
pub const MAX_CROSSES: usize = 20_000;
/// Sides of a circle as drawn.
const SIDES: usize = 32;
const PROBED_SIDES: usize = 96;
/// Half the length of a cross, in mean lengths of the edges at its vertex.
const ARM: f64 = 0.36;

impl Session {
    /// Looks closer at the surface as it is now.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn look(&self, options: LookOptions) -> Result<Look, Fault> {
        let runner = self.runner()?;
        Ok(runner.look(options, &runner.x))
    }

    /// The same, and what [`frame`](Self::frame) looks at from now on: a vertex at the same place of
    /// the surface where that is remeshed.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn look_at(&mut self, options: LookOptions) -> Result<Look, Fault> {
        let runner = self.runner.as_ref().ok_or_else(Fault::no_mesh)?;
        self.view.look_at(options, runner);
        self.look(options)
    }
}

impl Runner {
    /// The same with the vertices at `x`.
    pub(super) fn look(&self, options: LookOptions, x: &[DVec3]) -> Look {
        let mut look = Look::default();
        let size = measure::bounding_diagonal(x);
        if options.circles {
            self.all_circles(x, size, &mut look);
        }
        if options.directions {
            self.crosses(x, size, &mut look);
        }
        if options.crossings {
            for [from, to] in crossing::curves(self.triangles(), x) {
                look.segment(from, to, SegmentKind::Crossing);
            }
        }
        // Last, and so over the others.
        look.probe = options.probe.and_then(|v| self.probe(v, x));
        if let Some(vertex) = look.probe.as_ref().map(|p| Vertex(p.vertex)) {
            let mesh = self.triangles();
            for spoke in mesh.star(vertex) {
                if let Some(circle) = self.circle(x, spoke.face) {
                    look.circle(&circle, PROBED_SIDES, SegmentKind::ProbedCircle);
                }
            }
            for w in mesh.neighbours(vertex) {
                look.segment(x[vertex.index()], x[w.index()], SegmentKind::Spoke);
            }
        }
        look
    }

    fn circle(&self, x: &[DVec3], f: Face) -> Option<Circle> {
        f.is_some()
            .then(|| measure::triangle_points(self.triangles(), x, f))
            .and_then(Circle::through)
    }

    fn all_circles(&self, x: &[DVec3], size: f64, look: &mut Look) {
        let total = self.triangles().n_faces();
        let (mut drawn, mut left_out) = (0, 0);
        let faces = self.triangles().faces();
        for f in faces.step_by(total.div_ceil(MAX_CIRCLES).max(1)) {
            match self.circle(x, f).filter(|c| c.radius() < size) {
                Some(circle) => {
                    drawn += 1;
                    look.circle(&circle, SIDES, SegmentKind::Circle);
                }
                None => left_out += 1,
            }
        }
        look.circles = Some(Drawn {
            drawn,
            total,
            left_out,
        });
    }

    fn crosses(&self, x: &[DVec3], size: f64, look: &mut Look) {
        let mesh = self.triangles();
        let at = principal_directions(mesh, x, |_| true);
        let lengths = measure::mean_edge_lengths(mesh, x);
        let (mut drawn, mut left_out) = (0, 0);
        let every = x.len().div_ceil(MAX_CROSSES).max(1);
        for i in (0..x.len()).step_by(every) {
            let Some(p) = at[i].filter(|p| !p.is_umbilic(size)) else {
                left_out += 1;
                continue;
            };
            drawn += 1;
            for (direction, kind) in p
                .directions
                .into_iter()
                .zip([SegmentKind::Largest, SegmentKind::Smallest])
            {
                let arm = ARM * lengths[i] * direction;
                look.segment(x[i] - arm, x[i] + arm, kind);
            }
        }
        let (aligned, edges) = aligned_edges(mesh, x, &at, size, ALIGNED_DEGREES);
        look.alignment = Some(Alignment { aligned, edges });
        look.directions = Some(Drawn {
            drawn,
            total: x.len(),
            left_out,
        });
    }
}

impl Look {
    fn segment(&mut self, a: DVec3, b: DVec3, kind: SegmentKind) {
        self.ends.extend(as_f32(&[a, b]));
        self.kinds.push(kind as u8);
    }

    fn circle(&mut self, circle: &Circle, sides: usize, kind: SegmentKind) {
        let points: Vec<DVec3> = circle.points(sides).collect();
        for (k, &p) in points.iter().enumerate() {
            self.segment(p, points[(k + 1) % sides], kind);
        }
    }
}
