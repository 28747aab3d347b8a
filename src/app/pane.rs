//! Pictures side by side: the flows by mean curvature, or the start and all three criteria of
//! edge flips, each as it is or subdivided by Loop's scheme.

use super::arrangement::{Arrangement, Compare};
use super::fault::Fault;
use super::field::{Field, FieldName};
use super::panes::Panes;
use super::readings::State;
use super::runner::Runner;
use super::{Session, as_f32};
use crate::arrays::TypedArray;
use crate::energy::curvature_jump::CurvatureJump;
use crate::flow::flips::EdgeFlips;
use crate::flow::option;
use crate::flow::option::kind::id_of;
use crate::flow::spec::FlowName;
use crate::mesh::{self, HalfedgeMesh, Vertex, subdivide};
use crate::order;
use crate::remesh::flips::FlipOptimiser;
use crate::remesh::flips::reduction::Criterion;
use glam::DVec3;
use serde::Serialize;

/// Area and W against the number of flips, for plots.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Curves {
    /// Numbers of flips, from 0 to those of the run that made most.
    pub flips: TypedArray<f64>,
    /// One a criterion.
    pub runs: Vec<Curve>,
}

/// Area and W by one criterion after each of the [`Curves::flips`]; NaN after its last flip.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Curve {
    /// The criterion.
    pub criterion: Criterion,
    /// Total area.
    pub area: TypedArray<f64>,
    /// W.
    pub circle: TypedArray<f64>,
}

/// Points of a curve at most.
const MAX_POINTS: usize = 400;

/// A picture: all of what a viewer draws.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Pane {
    /// `start`, the criterion or the flow.
    pub name: &'static str,
    /// Of flows side by side: where this one stands.
    pub state: Option<State>,
    /// Of these: the jump of H across the boundary of what moves.
    pub jump: Option<CurvatureJump>,
    /// Three coordinates a vertex.
    pub positions: TypedArray<f32>,
    /// Three corners a triangle.
    pub triangles: TypedArray<u32>,
    /// Two ends an edge.
    pub wire_edges: TypedArray<u32>,
    /// Two ends a boundary edge.
    pub boundary_edges: TypedArray<u32>,
    /// Two ends an edge that the last step made.
    pub highlight: TypedArray<u32>,
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
        option::check(&arrangement)?;
        self.runner_mut()?.arrange(arrangement);
        self.settle_panes();
        Ok(())
    }

    /// The pictures of edge flips, or of flows side by side, coloured by a field or `none` over
    /// one range for all; none of a single flow.
    ///
    /// # Errors
    /// Unknown names.
    pub fn panes(&self, field: &str) -> Result<Vec<Pane>, Fault> {
        let field = match field {
            "none" => None,
            name => Some(FieldName::parse(name)?),
        };
        Ok(pictures(self.runner()?, &self.panes, field))
    }

    /// The curves of edge flips so far; empty under any other flow.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn curves(&self) -> Result<Curves, Fault> {
        Ok(self.runner()?.curves())
    }
}

/// The pictures of edge flips, or of flows side by side; none of a single flow.
pub(super) fn pictures(first: &Runner, panes: &Panes, field: Option<FieldName>) -> Vec<Pane> {
    if let Some(flips) = first.engine.as_ref().and_then(|flow| flow.flips()) {
        return first.flip_panes(flips, field);
    }
    if panes.others().is_empty() {
        // What a pass of remeshing made the page does not know.
        let made = first.own_triangles();
        let name = first.options().flow.id();
        return Vec::from_iter(made.map(|mesh| first.pane(name, mesh, Vec::new(), field)));
    }
    let all = std::iter::once(first).chain(panes.others());
    let mut pictures: Vec<Pane> = all
        .map(|runner| Pane {
            name: runner.options().flow.id(),
            state: Some(runner.state.clone()),
            jump: runner.curvature_jump(),
            positions: as_f32(&runner.x).into(),
            triangles: runner.triangles().triangle_indices().into(),
            wire_edges: runner.polygons().edge_indices(false).into(),
            boundary_edges: runner.polygons().edge_indices(true).into(),
            highlight: TypedArray::default(),
            field: field.and_then(|name| runner.field(name).ok()),
        })
        .collect();
    // That of the first: where another breaks, it may go out of the scale.
    let range = pictures[0].field.as_ref().map(|f| (f.low, f.high));
    for field in pictures.iter_mut().filter_map(|pane| pane.field.as_mut()) {
        (field.low, field.high) = range.unwrap_or((field.low, field.high));
    }
    // In the order of the paper, whichever was chosen.
    let place = |pane: &Pane| FlowName::all().position(|flow| flow.id() == pane.name);
    order::sort_by_key(&mut pictures, place);
    pictures
}

impl Runner {
    pub(super) fn arrange(&mut self, arrangement: Arrangement) {
        self.arrangement = arrangement;
        if let Some(flips) = self.engine.as_mut().and_then(|flow| flow.flips_mut()) {
            flips.compare(arrangement.compare == Compare::Criteria);
            flips.set_per_step(arrangement.flips_per_step.unwrap_or(usize::MAX));
            self.state.dt = flips.per_step() as f64;
            self.state.tau = self.state.dt;
            if self.state.flips.is_some() {
                self.state.flips = Some(flips.readings());
            }
        }
    }

    /// The curves of edge flips so far; empty under any other flow.
    pub(super) fn curves(&self) -> Curves {
        let flips = self.engine.as_ref().and_then(|flow| flow.flips());
        flips.map_or_else(Curves::default, curves)
    }

    /// The pictures of edge flips.
    fn flip_panes(&self, flips: &EdgeFlips, field: Option<FieldName>) -> Vec<Pane> {
        let mut panes = Vec::new();
        if self.arrangement.compare == Compare::Start {
            panes.push(self.pane("start", flips.start(), Vec::new(), field));
        }
        for run in flips.runs() {
            let name = id_of(&run.criterion());
            let edges = flips.last_edges(run);
            panes.push(self.pane(name, run.mesh(), edges, field));
        }
        // In the order of the paper, whichever was chosen.
        let place = |name| {
            ["start", "area", "willmore", "localised"]
                .iter()
                .position(|n| *n == name)
        };
        order::sort_by_key(&mut panes, |pane| place(pane.name));
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
            state: None,
            jump: None,
            positions: as_f32(x).into(),
            triangles: drawn.triangle_indices().into(),
            wire_edges: drawn.edge_indices(false).into(),
            boundary_edges: drawn.edge_indices(true).into(),
            // Of the coarse mesh: on the finer one these are no edges.
            highlight: if finer.is_some() {
                TypedArray::default()
            } else {
                edges.into_iter().flatten().map(|v| v.0).collect()
            },
            field: field.map(|f| Field::compute(f, drawn, boundary, x, |_| None)),
        }
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
        Curve {
            criterion: run.criterion(),
            area,
            circle,
        }
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
