//! Pictures side by side: the start, or all three criteria of edge flips, each as it is or
//! subdivided by Loop's scheme.

use super::fault::Fault;
use super::field::{Field, FieldName};
use super::work::Work;
use super::{Session, as_f32};
use crate::mesh::{self, HalfedgeMesh, Vertex, subdivide};
use crate::remesh::flips::reduction::Criterion;
use glam::DVec3;
use serde::Deserialize;

/// What stands beside the surface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Compare {
    /// Nothing.
    #[default]
    None,
    /// The mesh before the first flip.
    Start,
    /// The other criteria, after as many flips from the same start.
    Criteria,
}

/// What is shown of edge flips.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "camelCase", default, deny_unknown_fields)]
pub struct Arrangement {
    /// Side by side.
    pub compare: Compare,
    /// Steps of Loop's scheme before drawing.
    pub subdivide: usize,
}

/// A picture: all of what a viewer draws.
#[derive(Clone, Debug, PartialEq)]
pub struct Pane {
    /// `start`, or the criterion.
    pub name: &'static str,
    /// Three coordinates a vertex.
    pub positions: Vec<f32>,
    /// Three corners a triangle.
    pub triangles: Vec<u32>,
    /// Two ends an edge.
    pub wire_edges: Vec<u32>,
    /// Two ends a boundary edge.
    pub boundary_edges: Vec<u32>,
    /// Two ends an edge that the last step made.
    pub highlight: Vec<u32>,
    /// Colours.
    pub field: Option<Field>,
}

/// Faces at most after subdivision; beyond, one level less is drawn.
const MAX_FACES: usize = 2_000_000;

impl Session {
    /// What the next [`panes`](Self::panes) show.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn arrange(&mut self, arrangement: Arrangement) -> Result<(), Fault> {
        self.work_mut()?.arrange(arrangement);
        Ok(())
    }

    /// The pictures of edge flips, coloured by a field or `none` over one range for all;
    /// none under any other flow.
    ///
    /// # Errors
    /// Unknown names.
    pub fn panes(&self, field: &str) -> Result<Vec<Pane>, Fault> {
        let field = match field {
            "none" => None,
            name => Some(FieldName::parse(name)?),
        };
        Ok(self.work()?.panes(field))
    }
}

impl Work {
    pub(super) fn arrange(&mut self, arrangement: Arrangement) {
        self.arrangement = arrangement;
        if let Some(flips) = self.flow.as_mut().and_then(|flow| flow.flips_mut()) {
            flips.compare(arrangement.compare == Compare::Criteria);
            if self.state.flips.is_some() {
                self.state.flips = Some(flips.readings());
            }
        }
    }

    fn panes(&self, field: Option<FieldName>) -> Vec<Pane> {
        let Some(flips) = self.flow.as_ref().and_then(|flow| flow.flips()) else {
            return Vec::new();
        };
        let mut panes = Vec::new();
        if self.arrangement.compare == Compare::Start {
            panes.push(self.pane("start", flips.start(), Vec::new(), field));
        }
        for run in flips.runs() {
            let name = match run.criterion() {
                Criterion::Area => "area",
                Criterion::Willmore => "willmore",
                Criterion::Localised => "localised",
            };
            let edges = flips.last_edges(run);
            panes.push(self.pane(name, run.mesh(), edges, field));
        }
        // In the order of the paper, whichever was chosen.
        let place = |name| {
            ["start", "area", "willmore", "localised"]
                .iter()
                .position(|n| *n == name)
        };
        panes.sort_by_key(|pane| place(pane.name));
        share_range(&mut panes);
        panes
    }

    fn pane(
        &self,
        name: &'static str,
        mesh: &HalfedgeMesh,
        edges: Vec<[Vertex; 2]>,
        field: Option<FieldName>,
    ) -> Pane {
        let finer = subdivided(mesh, &self.x, self.arrangement.subdivide);
        let (drawn, x) = finer.as_ref().map_or((mesh, &*self.x), |(m, x)| (m, x));
        let zero = |_| vec![DVec3::ZERO; x.len()];
        Pane {
            name,
            positions: as_f32(x),
            triangles: drawn.triangle_indices(),
            wire_edges: drawn.edge_indices(false),
            boundary_edges: drawn.edge_indices(true),
            // Of the coarse mesh: on the finer one these are no edges.
            highlight: if finer.is_some() {
                Vec::new()
            } else {
                edges.into_iter().flatten().map(|v| v.0).collect()
            },
            field: field.map(|f| Field::compute(f, drawn, self.options.boundary, x, zero)),
        }
    }
}

/// Loop's scheme, so many levels but no more than can be drawn.
fn subdivided(
    mesh: &HalfedgeMesh,
    x: &[DVec3],
    levels: usize,
) -> Option<(HalfedgeMesh, Vec<DVec3>)> {
    let mut finer = None;
    let mut soup = mesh.to_soup(x);
    for level in 1..=levels {
        if mesh.n_faces() << (2 * level) > MAX_FACES {
            break;
        }
        soup = subdivide::loop_scheme(&soup).ok()?;
        finer = Some(mesh::build(&soup).ok()?);
    }
    finer.map(|built| (built.mesh, built.positions))
}

/// One scale for all pictures, so that colours can be compared.
fn share_range(panes: &mut [Pane]) {
    let fields = || panes.iter().filter_map(|pane| pane.field.as_ref());
    let low = fields().map(|f| f.low).fold(f32::INFINITY, f32::min);
    let high = fields().map(|f| f.high).fold(f32::NEG_INFINITY, f32::max);
    for field in panes.iter_mut().filter_map(|pane| pane.field.as_mut()) {
        (field.low, field.high) = (low, high);
    }
}
