//! Conformal regularisation of a mesh at rest, where triangles may be slivers or inverted.

use super::conformal::{Mode, Normals, Regulariser};
use crate::energy::p_willmore::{Evaluation, Helfrich, PWillmore};
use crate::geometry::{measure, nearest};
use crate::linalg::LinalgError;
use crate::mesh::HalfedgeMesh;
use crate::operator::Mass;
use glam::DVec3;
use serde::{Deserialize, Serialize};
use std::rc::Rc;

/// Tried one after the other until a pass does no harm: diag(K) times this is added …
const DAMPINGS: [f64; 4] = [0.0, 0.1, 1.0, 10.0];
/// … and then this share of the displacement taken.
const SHARES: [f64; 3] = [1.0, 0.5, 0.25];

/// How a mesh at rest is regularised. Unknown names are refused.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, Serialize)]
#[serde(rename_all = "camelCase", default, deny_unknown_fields)]
pub struct Settings {
    /// Linear or nonlinear.
    pub mode: Mode,
    /// ε, a pure number: 1e-3 is faithful to the surface, 1e-1 aggressive.
    pub epsilon: f64,
    /// Passes at most.
    pub iterations: usize,
    /// η: damping by η (|Y_i| h_i)² keeps vertices where the surface bends within an edge
    /// length, so that features stay; 0 lets them slide.
    pub features: f64,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            mode: Mode::Nonlinear,
            epsilon: 1e-2,
            iterations: 5,
            features: 0.3,
        }
    }
}

/// How good a mesh is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Quality {
    /// Smallest corner angle.
    pub min_angle_degrees: f64,
    /// CD / A: 0 where every element has its reference shape.
    pub distortion: f64,
    /// Elements whose normal opposes that of the surface around them.
    pub inverted: usize,
    /// Area.
    pub area: f64,
    /// Signed volume, of a closed oriented surface.
    pub volume: Option<f64>,
}

/// What the passes did.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Outcome {
    /// Passes that were taken.
    pub passes: usize,
    /// Before the first.
    pub before: Quality,
    /// After the last.
    pub after: Quality,
    /// Largest distance of a vertex from the surface at the start, as a share of the diagonal
    /// of the bounding box.
    pub distance: f64,
}

/// Regularises a closed, oriented mesh at `x`, in place.
///
/// The normals held are those of the surface smoothed over two rings, not a sliver's own.
/// A pass is taken only if CD falls and no further element is inverted; the first that can
/// do neither is the last.
///
/// # Errors
/// [`LinalgError`]; `x` is then as after the last good pass.
pub fn regularise(
    regulariser: &mut Regulariser,
    mesh: &Rc<HalfedgeMesh>,
    x: &mut Vec<DVec3>,
    settings: &Settings,
) -> Result<Outcome, LinalgError> {
    let start = x.clone();
    let before = quality(regulariser, mesh, x);
    let damping = feature_damping(regulariser, mesh, x, settings.features);
    let mut passes = 0;
    while passes < settings.iterations {
        match pass(regulariser, x, settings, &damping)? {
            Some(better) => *x = better,
            None => break,
        }
        passes += 1;
    }
    Ok(Outcome {
        passes,
        before,
        after: quality(regulariser, mesh, x),
        distance: nearest::farthest_from_surface(mesh, &start, x)
            / measure::bounding_diagonal(&start),
    })
}

/// Readings of a mesh.
pub fn quality(regulariser: &Regulariser, mesh: &HalfedgeMesh, x: &[DVec3]) -> Quality {
    let area = measure::area(mesh, x);
    let smooth = smoothed(regulariser, x);
    Quality {
        min_angle_degrees: measure::min_angle_degrees(mesh, x),
        distortion: regulariser.distortion(x) / area,
        inverted: inverted(regulariser, x, &smooth),
        area,
        volume: measure::volume(mesh, x),
    }
}

/// The next positions, or `None` if there are no better ones.
fn pass(
    regulariser: &mut Regulariser,
    x: &[DVec3],
    settings: &Settings,
    features: &[f64],
) -> Result<Option<Vec<DVec3>>, LinalgError> {
    let distortion = regulariser.distortion(x);
    let normals = smoothed(regulariser, x);
    let folds = inverted(regulariser, x, &normals);
    for extra in DAMPINGS {
        let damping: Vec<f64> = features.iter().map(|f| f + extra).collect();
        let mut v = regulariser.solve(x, &normals, settings.epsilon, Some(&damping))?;
        if settings.mode == Mode::Nonlinear {
            let central = smoothed(regulariser, &moved(x, &v, 0.5));
            v = regulariser.solve(x, &central, settings.epsilon, Some(&damping))?;
        }
        for share in SHARES {
            let trial = moved(x, &v, share);
            let is_better = regulariser.distortion(&trial) < distortion
                && inverted(regulariser, &trial, &smoothed(regulariser, &trial)) <= folds;
            if is_better {
                return Ok(Some(trial));
            }
        }
    }
    Ok(None)
}

fn moved(x: &[DVec3], v: &[DVec3], share: f64) -> Vec<DVec3> {
    x.iter().zip(v).map(|(x, v)| *x + share * *v).collect()
}

/// Normals averaged over two rings: of the corners of each element the mean, twice.
fn smoothed(regulariser: &Regulariser, x: &[DVec3]) -> Normals {
    let elements = regulariser.elements();
    let Normals { vertices, .. } = regulariser.normals(x);
    let spread = |vertices: &[DVec3]| -> Vec<DVec3> {
        let mut points = Vec::with_capacity(elements.len() * elements.points().len());
        for corners in elements.corners() {
            points.extend(elements.points().iter().map(|point| {
                let pairs = corners.iter().zip(point.shape);
                let sum: DVec3 = pairs.map(|(&v, shape)| shape * vertices[v as usize]).sum();
                sum.normalize_or_zero()
            }));
        }
        points
    };
    let once = spread(&vertices);
    let mut gathered = vec![DVec3::ZERO; x.len()];
    let mut normal = once.iter();
    for (e, corners) in elements.corners().enumerate() {
        for (node, n) in elements.nodes(x, e).zip(&mut normal) {
            for (&v, shape) in corners.iter().zip(node.shape) {
                gathered[v as usize] += shape * node.area * *n;
            }
        }
    }
    gathered.iter_mut().for_each(|n| *n = n.normalize_or_zero());
    Normals {
        points: spread(&gathered),
        vertices: gathered,
    }
}

/// Number of elements that oppose the normals given, at any of their points.
fn inverted(regulariser: &Regulariser, x: &[DVec3], normals: &Normals) -> usize {
    let elements = regulariser.elements();
    let per_element = elements.points().len();
    (0..elements.len())
        .filter(|&e| {
            let around = &normals.points[e * per_element..(e + 1) * per_element];
            elements
                .nodes(x, e)
                .zip(around)
                .any(|(node, n)| node.normal.dot(*n) < 0.0)
        })
        .count()
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
    let helfrich = Helfrich::default();
    let Some(functional) = PWillmore::new(Rc::clone(mesh), x, 2.0, helfrich, Mass::Lumped) else {
        return zero;
    };
    debug_assert_eq!(regulariser.elements().len(), mesh.n_faces());
    let mut evaluation = Evaluation::default();
    functional.integrals(x, &mut evaluation);
    let pairs = evaluation.curvature.iter().zip(&evaluation.mass);
    pairs.map(|(y, m)| eta * y.length_squared() * m).collect()
}
