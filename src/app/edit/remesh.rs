//! Remeshing as an edit: other triangles of the same surface.

use super::options::RemeshOptions;
use crate::app::Session;
use crate::app::document::Document;
use crate::app::fault::Fault;
use crate::app::lineage::Lineage;
use crate::app::message::AppError;
use crate::app::provenance::Edit;
use crate::app::runner::Runner;
use crate::energy::circle::Boundary;
use crate::energy::p_willmore::integrated_power;
use crate::flow::boundary;
use crate::geometry::measure;
use crate::mesh::HalfedgeMesh;
use crate::remesh::adaptive::{self, Counts, Remeshed, Soundness};
use glam::DVec3;
use serde::Serialize;
use std::rc::Rc;

/// Vertices at most; no flow could take a step on more.
const MAX_VERTICES: usize = 1_000_000;
/// Vertices at least, of a tetrahedron.
const MIN_VERTICES: usize = 4;

/// Readings of a mesh before or after.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct MeshReadings {
    /// Number of vertices.
    pub vertices: usize,
    /// Mean length of the edges.
    pub mean_edge_length: f64,
    /// Smallest corner angle.
    pub min_angle_degrees: f64,
    /// Total area.
    pub area: f64,
    /// Enclosed volume, of a closed surface.
    pub volume: Option<f64>,
    /// Whether the readings of the mesh can be believed; null of open surfaces.
    pub soundness: Option<Soundness>,
}

/// What a remeshing did.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct RemeshOutcome {
    /// Operations.
    pub counts: Counts,
    /// Before it.
    pub before: MeshReadings,
    /// After it.
    pub after: MeshReadings,
}

impl Runner {
    fn mesh_readings(mesh: &HalfedgeMesh, x: &[DVec3]) -> MeshReadings {
        let is_closed = mesh.is_closed() && mesh.is_oriented();
        MeshReadings {
            vertices: x.len(),
            mean_edge_length: measure::mean_edge_length(mesh, x),
            min_angle_degrees: measure::min_angle_degrees(mesh, x),
            area: measure::area(mesh, x),
            volume: measure::volume(mesh, x),
            soundness: is_closed.then(|| Soundness::of(mesh, x, integrated_power(mesh, x, 2.0))),
        }
    }

    /// A document with other triangles; those vertices stay that a selection holds.
    fn remeshed(&self, options: &RemeshOptions) -> Result<(Document, RemeshOutcome), Fault> {
        let present = self.present();
        let (mesh, x) = (&present.triangles, &present.start);
        let (free, fixed) = (&self.options().free, &self.options().fixed);
        let moves =
            boundary::free_vertices(mesh, Boundary::Fixed, free.as_deref(), fixed.as_deref())?;
        let held: Vec<bool> = moves.iter().map(|moves| !moves).collect();
        options.check()?;
        let length = options.target;
        let as_target = length
            .map(|length| adaptive::vertices_for(mesh, x, &held, length))
            .transpose()?;
        let as_asked = options.vertices.map(|vertices| vertices as f64);
        let wanted = as_asked.or(as_target).unwrap_or(x.len() as f64);
        if wanted > MAX_VERTICES as f64 || wanted.is_nan() {
            let (vertices, most) = (wanted, MAX_VERTICES);
            return Err(AppError::TooManyVertices { vertices, most }.into());
        }
        let wanted = (wanted.round() as usize).max(MIN_VERTICES);
        let Remeshed {
            mesh: made,
            positions,
            held,
            counts,
            origins,
        } = adaptive::remesh(mesh, x, options.kind, wanted, &held, options.creases)?;
        let outcome = RemeshOutcome {
            counts,
            before: Self::mesh_readings(mesh, x),
            after: Self::mesh_readings(&made, &positions),
        };
        // A boundary is held without being selected.
        let chosen = |is_chosen: bool| -> Vec<u32> {
            let vertices = made.vertices().zip(&held);
            let chosen =
                vertices.filter(|(v, held)| (**held && !made.is_boundary_vertex(*v)) == is_chosen);
            chosen.map(|(v, _)| v.0).collect()
        };
        let (free, fixed) = (free.is_some(), fixed.is_some());
        let (free, fixed) = (free.then(|| chosen(false)), fixed.then(|| chosen(true)));
        let made = Rc::new(made);
        let document = Document {
            numbers: present.numbers.plain(&made),
            polygons: Rc::clone(&made),
            triangles: made,
            start: positions,
            colours: present.colours.interpolated(&origins),
            lineage: Lineage::after(&present.lineage, &origins, mesh),
            free,
            fixed,
            ..present
        };
        Ok((document, outcome))
    }
}

impl Session {
    /// Gives the surface other triangles: near equilateral, of one size or as small as it bends.
    /// The new mesh becomes the start; what a selection holds and boundaries stay as they are.
    /// [`undo_edit`](Self::undo_edit) undoes it.
    ///
    /// # Errors
    /// One-sided surfaces, more vertices than there may be, surfaces too crumpled to be
    /// remeshed; the mesh stays as it was.
    pub fn remesh(&mut self, options: &RemeshOptions) -> Result<RemeshOutcome, Fault> {
        self.edit(Edit::Remesh(*options), |runner| runner.remeshed(options))
    }
}
