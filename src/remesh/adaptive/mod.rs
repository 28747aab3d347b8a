//! Another mesh of the same surface: triangles near equilateral, as small as it bends.
//!
//! A pass is two rounds of splits, collapses, flips and relaxation, after which area and volume
//! are brought back. Isotropic remeshing after Botsch & Kobbelt [BK04](crate::bibliography#bk04)
//! with the size field of Dunyach et al. [DVBB13](crate::bibliography#dvbb13), but on a fitted
//! surface instead of a stored one: new vertices lie on the cubic through the tangent planes at
//! the ends of their edge, and vertices slide on fitted quadrics. Nothing is ever projected onto
//! the old mesh, whose nearest point may lie on another sheet of an immersed surface. What is off
//! the smooth surface is O(h³) for splits, O(h⁴) on regular meshes.
//!
//! Held vertices and boundaries stay as they are, bit for bit, with the edges between them. No
//! order depends on anything but the input: a pass gives the same mesh again, to the last bit.

mod collapse;
mod crease;
mod draft;
mod flip;
mod need;
mod origin;
mod quadric;
mod relax;
mod restore;
mod size;
mod soundness;
mod split;

pub use need::{is_due, is_unfit, is_urgent};
pub use origin::Origin;
pub use restore::Targets;
pub use soundness::{Soundness, alignment};

use crate::geometry::measure;
use crate::interrupt;
use crate::mesh::HalfedgeMesh;
use crate::message::messages;
use draft::Draft;
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// Rounds of a pass between steps of a flow, and at most of one from any mesh.
const ROUNDS: usize = 2;
const MOST_ROUNDS: usize = 12;
/// A mesh is done where a round splits and collapses fewer edges than this share of its vertices.
const SETTLED: f64 = 0.01;
/// A number of vertices that is missed by more than this share is aimed at anew, so many times.
const MET: f64 = 0.03;
const CORRECTIONS: usize = 4;

/// The area of a mesh that is folded over is not that of its surface, and changes by more: it is not
/// brought back.
const SAME_AREA: f64 = 0.02;

/// A surface whose area or volume changes by more than these shares has become another, as one does
/// of needles, whose normals say nothing of what lies between their ends, or one that is thinner than
/// its triangles are long. Healthy meshes change by less than a hundredth.
const OTHER_AREA: f64 = 0.1;
const OTHER_VOLUME: f64 = 0.05;
/// An immersed surface may enclose nothing: volumes are compared with at least this share of that of
/// the ball with the area.
const LEAST_VOLUME: f64 = 0.05;

/// What decides how long edges are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// The curvature: the more the surface bends, the shorter.
    #[default]
    Adaptive,
    /// One length everywhere.
    Isotropic,
}

/// What becomes of edges of the shape, where faces meet at more than 60°, or flat sides at more than 40°.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum Creases {
    /// They stay where they are.
    #[default]
    Keep,
    /// The surface is smooth, and these are noise.
    Smooth,
}

/// A new mesh.
#[derive(Clone, Debug)]
pub struct Remeshed {
    /// Connectivity.
    pub mesh: HalfedgeMesh,
    /// One position a vertex.
    pub positions: Vec<DVec3>,
    /// Where each vertex comes from.
    pub origins: Vec<Origin>,
    /// Whether a vertex is one that was held.
    pub held: Vec<bool>,
    /// What was done.
    pub counts: Counts,
}

/// Operations of a pass.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Counts {
    /// Edges split.
    pub splits: usize,
    /// Edges collapsed.
    pub collapses: usize,
    /// Edges flipped.
    pub flips: usize,
}

/// Whether so few splits and collapses are no sign that a mesh is to become another.
fn is_settled(changes: usize, vertices: usize) -> bool {
    (changes as f64) < SETTLED * vertices as f64
}

impl Remeshed {
    /// Whether it is much the mesh that it was made of, but for flips.
    pub fn is_settled(&self) -> bool {
        is_settled(
            self.counts.splits + self.counts.collapses,
            self.positions.len(),
        )
    }
}

messages! {
    /// Why a mesh is not remeshed; it is as it was.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub enum RemeshError as "remesh" {
        /// A face with more than three corners.
        NotTriangular,
        /// A one-sided surface.
        NotOriented,
        /// Nothing may be changed.
        AllHeld,
        /// The surface would have become another: it is too coarse or too crumpled.
        Spoilt,
    }
}

/// One pass, as between two steps of a flow, towards so many vertices. Brought back are the
/// `targets`, unless something is held.
///
/// # Errors
/// See [`RemeshError`]; any where the work is [given up](crate::interrupt).
pub fn pass(
    mesh: &HalfedgeMesh,
    x: &[DVec3],
    kind: Kind,
    vertices: usize,
    targets: Targets,
) -> Result<Remeshed, RemeshError> {
    let start = checked(mesh, x, &vec![false; x.len()], Creases::Smooth)?;
    let mut draft = start.clone();
    let mut counts = Counts::default();
    for _ in 0..ROUNDS {
        round(&mut draft, kind, vertices, &mut counts);
        interrupt::check().map_err(|_| RemeshError::Spoilt)?;
    }
    counts.flips += flip::to_delaunay(&mut draft);
    finished(mesh, &start, draft, Some(targets), counts)
}

/// Rounds from any mesh until it is settled, towards so many vertices; those that `held` marks
/// stay, and so do edges of the shape unless they are to become smooth. The area of a closed surface
/// is brought back where nothing is held, unless the mesh has lost as much of it as only folds have.
///
/// # Errors
/// See [`RemeshError`]; any where the work is [given up](crate::interrupt).
pub fn remesh(
    mesh: &HalfedgeMesh,
    x: &[DVec3],
    kind: Kind,
    vertices: usize,
    held: &[bool],
    creases: Creases,
) -> Result<Remeshed, RemeshError> {
    let start = checked(mesh, x, held, creases)?;
    let (draft, counts) = settled(mesh, x, &start, kind, vertices)?;
    let area = measure::area(mesh, x);
    let change = draft.areas().iter().sum::<f64>() / area - 1.0;
    let is_same = change.abs() < SAME_AREA && !start.held.contains(&true);
    let targets = is_same.then_some(Targets { area, volume: None });
    finished(mesh, &start, draft, targets, counts)
}

/// The same between two steps of a flow, where a pass is not enough: edges of the shape stay, and
/// the `targets` are brought back.
///
/// # Errors
/// See [`RemeshError`]; any where the work is [given up](crate::interrupt).
pub fn renewal(
    mesh: &HalfedgeMesh,
    x: &[DVec3],
    kind: Kind,
    vertices: usize,
    targets: Targets,
) -> Result<Remeshed, RemeshError> {
    let start = checked(mesh, x, &vec![false; x.len()], Creases::Keep)?;
    let (draft, counts) = settled(mesh, x, &start, kind, vertices)?;
    finished(mesh, &start, draft, Some(targets), counts)
}

/// The number of vertices of a mesh with edges of a mean length, away from those that `held` marks and
/// from boundaries, which all stay.
///
/// # Errors
/// See [`RemeshError`].
pub fn vertices_for(
    mesh: &HalfedgeMesh,
    x: &[DVec3],
    held: &[bool],
    length: f64,
) -> Result<f64, RemeshError> {
    Ok(size::count(
        &checked(mesh, x, held, Creases::Smooth)?,
        length,
    ))
}

fn checked(
    mesh: &HalfedgeMesh,
    x: &[DVec3],
    held: &[bool],
    creases: Creases,
) -> Result<Draft, RemeshError> {
    if !mesh.is_triangular() {
        return Err(RemeshError::NotTriangular);
    }
    if !mesh.is_oriented() {
        return Err(RemeshError::NotOriented);
    }
    let mut draft = Draft::of(mesh, x, held);
    if !draft.held.contains(&false) {
        return Err(RemeshError::AllHeld);
    }
    // What is folded over is noise.
    if creases == Creases::Keep && alignment(mesh, x) > 0.0 {
        crease::mark(&mut draft);
    }
    Ok(draft)
}

/// Whether a draft is of another surface than it was made of.
fn is_other(mesh: &HalfedgeMesh, x: &[DVec3], draft: &Draft) -> bool {
    let area = measure::area(mesh, x);
    let change = draft.areas().iter().sum::<f64>() / area - 1.0;
    // Of folds that are smoothed away the area goes too.
    if change.abs() > OTHER_AREA && alignment(mesh, x) > 0.0 {
        return true;
    }
    measure::volume(mesh, x).is_some_and(|volume| {
        let ball = area.powf(1.5) / (6.0 * std::f64::consts::PI.sqrt());
        let size = volume.abs().max(LEAST_VOLUME * ball);
        (restore::volume(draft) - volume).abs() > OTHER_VOLUME * size
    })
}

/// Rounds until there is little to change and the number of vertices is met, with edges that are
/// Delaunay; refused where the surface has become another.
fn settled(
    mesh: &HalfedgeMesh,
    x: &[DVec3],
    start: &Draft,
    kind: Kind,
    vertices: usize,
) -> Result<(Draft, Counts), RemeshError> {
    let mut draft = start.clone();
    let mut counts = Counts::default();
    let mut aim = vertices as f64;
    let n_held = size::held(&draft);
    let free = |count: usize| count.saturating_sub(n_held).max(1) as f64;
    for _ in 0..=CORRECTIONS {
        settle(&mut draft, kind, aim.round() as usize, &mut counts)?;
        // Edges that are neither split nor collapsed may all be short, or all long.
        let excess = free(draft.x.len()) / free(vertices);
        if (excess - 1.0).abs() < MET {
            break;
        }
        aim = n_held as f64 + (aim - n_held as f64).max(1.0) / excess;
    }
    counts.flips += flip::to_delaunay(&mut draft);
    if is_other(mesh, x, &draft) {
        return Err(RemeshError::Spoilt);
    }
    Ok((draft, counts))
}

/// Rounds until there is little to change.
fn settle(
    draft: &mut Draft,
    kind: Kind,
    vertices: usize,
    counts: &mut Counts,
) -> Result<(), RemeshError> {
    for done in 1..=MOST_ROUNDS {
        let before = counts.splits + counts.collapses;
        round(draft, kind, vertices, counts);
        interrupt::check().map_err(|_| RemeshError::Spoilt)?;
        let changes = counts.splits + counts.collapses - before;
        if done >= ROUNDS && is_settled(changes, draft.x.len()) {
            break;
        }
    }
    Ok(())
}

fn round(draft: &mut Draft, kind: Kind, vertices: usize, counts: &mut Counts) {
    draft.size = size::field(draft, kind, vertices);
    interrupt::tell("remesh", 0.0);
    counts.splits += split::run(draft);
    interrupt::pulse();
    counts.collapses += collapse::run(draft);
    interrupt::pulse();
    counts.flips += flip::for_valence(draft) + flip::to_delaunay(draft);
    interrupt::pulse();
    draft.compact();
    relax::run(draft);
    draft.normal = draft.normals();
}

fn finished(
    mesh: &HalfedgeMesh,
    start: &Draft,
    mut draft: Draft,
    targets: Option<Targets>,
    counts: Counts,
) -> Result<Remeshed, RemeshError> {
    if targets.is_some_and(|targets| !restore::run(&mut draft, start, mesh, targets)) {
        return Err(RemeshError::Spoilt);
    }
    let mesh = draft.mesh().ok_or(RemeshError::Spoilt)?;
    debug_assert_eq!(mesh.validate(), Ok(()));
    Ok(Remeshed {
        mesh,
        origins: origin::origins(start, &draft),
        held: (0..draft.x.len()).map(|v| draft.is_fixed(v)).collect(),
        positions: draft.x,
        counts,
    })
}

#[cfg(test)]
mod tests;
