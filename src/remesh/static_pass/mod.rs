//! Conformal regularisation of a mesh at rest, where triangles may be slivers or inverted.
//!
//! Less conformal distortion alone is no measure of a good pass: a rod of needles is least
//! distorted as a ball. So creases stay, and of every pass as much is taken, vertex by vertex,
//! as leaves the surface where it was:
//!
//! | kept | to |
//! | --- | --- |
//! | two-sided distance from the start ([`TwoSided`]) | 1 % of the diagonal of the bounding box |
//! | volume | 2 % |
//! | sides and extents of the bounding box | 2 % of the extent |
//! | smallest angle | 5°, or that at the start if it is smaller |
//!
//! [`TwoSided`]: crate::geometry::nearest::TwoSided

mod creases;
mod likeness;
mod refusal;
mod search;
mod surroundings;

pub use refusal::RegulariseError;

use super::conformal::{Mode, Regulariser};
use crate::energy::p_willmore::{Evaluation, Helfrich, PWillmore};
use crate::geometry::measure;
use crate::mesh::HalfedgeMesh;
use crate::operator::Mass;
use creases::Creases;
use glam::DVec3;
use likeness::{Likeness, Property};
use search::{Pass, Search};
use serde::{Deserialize, Serialize};
use std::rc::Rc;
use surroundings::{inverted, smoothed};

/// How a mesh at rest is regularised. Unknown names are refused.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase", default, deny_unknown_fields)]
pub struct RegulariseOptions {
    /// Linear or nonlinear.
    pub mode: Mode,
    /// ε, a pure number: 1e-3 is faithful to the surface, 1e-1 aggressive.
    pub epsilon: f64,
    /// Passes at most.
    pub iterations: usize,
    /// η: damping by η (|Y_i| h_i)² keeps vertices where the surface bends within an edge
    /// length, so that features stay; 0 lets them slide, those on creases too, as far as
    /// the bounds allow.
    pub features: f64,
}

impl RegulariseOptions {
    /// Five nonlinear passes that keep features.
    pub const DEFAULT: Self = Self {
        mode: Mode::Nonlinear,
        epsilon: 1e-2,
        iterations: 5,
        features: 0.3,
    };
}

impl Default for RegulariseOptions {
    fn default() -> Self {
        Self::DEFAULT
    }
}

/// How good a mesh is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct MeshQuality {
    /// Smallest corner angle.
    pub min_angle_degrees: f64,
    /// CD / A: 0 where every element has its reference shape.
    pub distortion: f64,
    /// Elements whose normal opposes that of the surface around them, on their side of
    /// creases.
    pub inverted: usize,
    /// Area.
    pub area: f64,
    /// Signed volume, of a closed oriented surface.
    pub volume: Option<f64>,
}

/// What the passes did.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct Regularised {
    /// Passes that were taken.
    pub passes: usize,
    /// Before the first.
    pub before: MeshQuality,
    /// After the last.
    pub after: MeshQuality,
    /// Two-sided distance from the surface at the start, as a share of the diagonal of its
    /// bounding box: of the vertices at the end from that surface, and of its vertices from
    /// the surface at the end, the largest.
    pub distance: f64,
    /// Vertices on creases, which stay where they are.
    pub pinned: usize,
}

/// Regularises a closed, oriented mesh at `x`, in place.
///
/// The normals held are those of the surface smoothed over two rings, not a sliver's own.
/// Vertices on creases, edges with a dihedral angle over 40°, stay. A pass is taken only if
/// CD falls, no further element is inverted and the shape is kept as told above; where it is
/// not, shares of it down to a sixteenth are. The first that gains nothing is the last. A
/// start with folded faces may have a smaller angle on the way, but not at the end.
///
/// # Errors
/// [`RegulariseError`], where all vertices stay or no share of the first pass keeps the
/// shape; `x` is then as it was. After [`RegulariseError::Linear`] it is as after the last
/// good pass.
pub fn regularise(
    regulariser: &mut Regulariser,
    mesh: &Rc<HalfedgeMesh>,
    x: &mut Vec<DVec3>,
    settings: &RegulariseOptions,
) -> Result<Regularised, RegulariseError> {
    let start = x.clone();
    let creases = match settings.features > 0.0 {
        true => Creases::of(regulariser, mesh, x),
        false => Creases::none(regulariser, mesh, x),
    };
    let before = readings(regulariser, mesh, x, &creases.on);
    let mut damping = feature_damping(regulariser, mesh, x, settings.features);
    let pinned = creases.count();
    for (damping, _) in damping.iter_mut().zip(&creases.on).filter(|(_, on)| **on) {
        *damping = f64::INFINITY;
    }
    let mut outcome = Regularised {
        before,
        after: before,
        pinned,
        ..Regularised::default()
    };
    if settings.iterations == 0 {
        return Ok(outcome);
    }
    if pinned == x.len() {
        return Err(RegulariseError::OnlyCreases { vertices: pinned });
    }
    let likeness = Likeness::new(mesh, &start);
    let mut search = Search {
        regulariser,
        mesh,
        settings,
        damping: &damping,
        on_creases: &creases.on,
        likeness: &likeness,
        is_folded: !creases.folded.is_empty(),
    };
    let mut y = start.clone();
    let mut lost = None;
    for n in 1..=settings.iterations {
        match search.pass(&y)? {
            Pass::Taken(better) => y = better,
            Pass::Refused(why) => {
                lost = why;
                break;
            }
        }
        // Of a folded start passes are good only once their angles are.
        if likeness.keeps_angle(&y) {
            x.clone_from(&y);
            outcome.passes = n;
        } else {
            lost = Some(Property::Angle);
        }
    }
    match lost {
        Some(lost) if outcome.passes == 0 => Err(lost.into()),
        _ => {
            outcome.after = readings(regulariser, mesh, x, &creases.on);
            outcome.distance = likeness.distance(x);
            Ok(outcome)
        }
    }
}

/// Readings of a mesh.
pub fn quality(regulariser: &Regulariser, mesh: &HalfedgeMesh, x: &[DVec3]) -> MeshQuality {
    readings(regulariser, mesh, x, &Creases::of(regulariser, mesh, x).on)
}

fn readings(
    regulariser: &Regulariser,
    mesh: &HalfedgeMesh,
    x: &[DVec3],
    on_creases: &[bool],
) -> MeshQuality {
    let area = measure::area(mesh, x);
    let around = smoothed(regulariser, x, on_creases);
    MeshQuality {
        min_angle_degrees: measure::min_angle_degrees(mesh, x),
        distortion: regulariser.distortion(x) / area,
        inverted: inverted(regulariser, x, &around).count(),
        area,
        volume: measure::volume(mesh, x),
    }
}

/// η (|Y_i| h_i)², h_i² the area of a vertex.
fn feature_damping(
    regulariser: &Regulariser,
    mesh: &Rc<HalfedgeMesh>,
    x: &[DVec3],
    eta: f64,
) -> Vec<f64> {
    let zero = vec![0.0; x.len()];
    if eta == 0.0 {
        return zero;
    }
    let Some(functional) =
        PWillmore::new(Rc::clone(mesh), x, 2.0, Helfrich::default(), Mass::Lumped)
    else {
        return zero;
    };
    debug_assert_eq!(regulariser.elements().len(), mesh.n_faces());
    let mut evaluation = Evaluation::default();
    functional.integrals(x, &mut evaluation);
    let pairs = evaluation.curvature.iter().zip(&evaluation.mass);
    pairs.map(|(y, m)| eta * y.length_squared() * m).collect()
}
