//! Pictures side by side: the start, or all three criteria of edge flips, each as it is or
//! subdivided by Loop's scheme.

use super::beside::Standing;
use super::fault::Fault;
use super::field::{Field, FieldName};
use super::message::AppError;
use super::work::Work;
use super::{Session, as_f32};
use crate::flow::error::Allowed;
use crate::flow::flips::EdgeFlips;
use crate::mesh::{self, HalfedgeMesh, Vertex, subdivide};
use crate::remesh::flips::FlipOptimiser;
use crate::remesh::flips::reduction::Criterion;
use glam::DVec3;
use serde::{Deserialize, Serialize};

/// What stands beside the surface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Compare {
    /// Nothing.
    #[default]
    None,
    /// The mesh before the first flip.
    Start,
    /// The other criteria, after as many flips from the same start.
    Criteria,
    /// The other flows by mean curvature and its derivatives, from the same start.
    Flows,
}

/// What is shown of edge flips.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[serde(rename_all = "camelCase", default, deny_unknown_fields)]
pub struct Arrangement {
    /// Side by side.
    pub compare: Compare,
    /// Steps of Loop's scheme before drawing.
    pub subdivide: usize,
    /// Flips a step makes; all that gain anything if absent.
    pub flips_per_step: Option<usize>,
}

impl Arrangement {
    /// The surface alone, flip by flip.
    pub const PLAIN: Self = Self {
        compare: Compare::None,
        subdivide: 0,
        flips_per_step: Some(1),
    };
}

impl Default for Arrangement {
    fn default() -> Self {
        Self::PLAIN
    }
}

/// Area and W against the number of flips, for plots.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Curves {
    /// Numbers of flips, from 0 to those of the run that made most.
    pub flips: Vec<f64>,
    /// A criterion's area and W after them; NaN after its last flip.
    pub runs: Vec<(&'static str, Vec<f64>, Vec<f64>)>,
}

/// Points of a curve at most.
const MAX_POINTS: usize = 400;

/// A picture: all of what a viewer draws.
#[derive(Clone, Debug, PartialEq)]
pub struct Pane {
    /// `start`, the criterion, or the flow.
    pub name: &'static str,
    /// Of flows beside each other: where this one stands.
    pub standing: Option<Standing>,
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
    /// How edge flips are shown and how many a step makes; where the flow stands, it stays.
    ///
    /// # Errors
    /// [`Fault::no_mesh`]; steps of no flip.
    pub fn arrange(&mut self, arrangement: Arrangement) -> Result<(), Fault> {
        if arrangement.flips_per_step == Some(0) {
            let error = AppError::BadOption {
                name: "flipsPerStep",
                value: "0".into(),
                allowed: Allowed::WholeFrom { low: 1 },
            };
            return Err(error.into());
        }
        self.work_mut()?.arrange(arrangement);
        Ok(())
    }

    /// The pictures of edge flips, or of flows beside each other, coloured by a field or
    /// `none` over one range for all; none of a single flow.
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

    /// The curves of edge flips so far; empty under any other flow.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn curves(&self) -> Result<Curves, Fault> {
        let flow = self.work()?.flow.as_ref();
        Ok(flow
            .and_then(|f| f.flips())
            .map_or_else(Curves::default, curves))
    }
}

impl Work {
    pub(super) fn arrange(&mut self, arrangement: Arrangement) {
        self.arrangement = arrangement;
        if let Some(flips) = self.flow.as_mut().and_then(|flow| flow.flips_mut()) {
            flips.compare(arrangement.compare == Compare::Criteria);
            flips.set_per_step(arrangement.flips_per_step.unwrap_or(usize::MAX));
            self.state.dt = flips.per_step() as f64;
            self.state.tau = self.state.dt;
            if self.state.flips.is_some() {
                self.state.flips = Some(flips.readings());
            }
        }
        self.run_beside(arrangement.compare == Compare::Flows);
    }

    pub(super) fn panes(&self, field: Option<FieldName>) -> Vec<Pane> {
        let Some(flips) = self.flow.as_ref().and_then(|flow| flow.flips()) else {
            return self.flow_panes(field);
        };
        let mut panes = Vec::new();
        if self.arrangement.compare == Compare::Start {
            panes.push(self.pane("start", flips.start(), Vec::new(), field));
        }
        for run in flips.runs() {
            let name = name_of(run.criterion());
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
        let boundary = self.options().boundary.unwrap_or_default();
        Pane {
            name,
            standing: None,
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
            field: field.map(|f| Field::compute(f, drawn, boundary, x, |_| None)),
        }
    }
}

fn name_of(criterion: Criterion) -> &'static str {
    match criterion {
        Criterion::Area => "area",
        Criterion::Willmore => "willmore",
        Criterion::Localised => "localised",
    }
}

fn curves(flow: &EdgeFlips) -> Curves {
    let most = flow.runs().iter().map(FlipOptimiser::flips).max();
    let most = most.unwrap_or_default();
    let stride = most.div_ceil(MAX_POINTS).max(1);
    let mut flips: Vec<usize> = (0..most).step_by(stride).collect();
    flips.push(most);
    let run = |run: &FlipOptimiser| {
        let costs = |n: &usize| run.costs_after(*n).unwrap_or([f64::NAN; 2]);
        let mut both: Vec<[f64; 2]> = flips.iter().map(costs).collect();
        // Its end, where that lies between two points.
        if let Some(gap) = both.iter_mut().find(|c| c[0].is_nan()) {
            *gap = [run.area(), run.willmore()];
        }
        let [area, circle] = [0, 1].map(|i| both.iter().map(|c| c[i]).collect());
        (name_of(run.criterion()), area, circle)
    };
    Curves {
        runs: flow.runs().iter().map(run).collect(),
        flips: flips.iter().map(|&n| n as f64).collect(),
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
