//! What a judge sees of the run of a figure.

use super::measure::off_surface;
use super::sample::Shape;
use crate::app::crossing;
use crate::app::pane::pictures;
use crate::app::runner::Runner;
use crate::app::{Fault, FieldName, Info, Session, State};
use crate::flow::flips::FlipReading;
use crate::flow::spec::FlowName;
use crate::remesh::flips::reduction::Criterion;
use crate::remesh::static_pass::Regularised;
use glam::DVec3;

/// What a judge sees of a run.
pub(in crate::app) struct Run<'a> {
    session: &'a Session,
    runner: &'a Runner,
    /// Readings before the first step.
    pub(super) first: &'a State,
    /// Readings at the end.
    pub(super) last: &'a State,
    /// Positions before the first step.
    pub(super) start: &'a [DVec3],
    /// Positions at the end.
    pub(super) x: &'a [DVec3],
    /// Ends on coarser meshes, coarsest first.
    pub(super) refined: Vec<State>,
    pub(super) regularised: Option<Regularised>,
    /// The first half of a film.
    back: Option<&'a Runner>,
    /// Of the undamaged surface.
    reference: Option<Vec<DVec3>>,
}

impl<'a> Run<'a> {
    pub(super) fn of(
        reference: Option<&Shape>,
        session: &'a Session,
        refined: Vec<State>,
        regularised: Option<Regularised>,
    ) -> Result<Self, Fault> {
        let reference = match reference {
            Some(shape) => {
                let mut clean = Session::new();
                shape.load(&mut clean, &[])?;
                Some(clean.runner()?.x.clone())
            }
            None => None,
        };
        let [runner, back] = session.halves()?;
        let runner = runner.ok_or_else(Fault::no_mesh)?;
        let (first, start) = runner.beginning();
        Ok(Self {
            session,
            runner,
            first,
            last: &runner.state,
            start,
            x: &runner.x,
            refined,
            regularised,
            back,
            reference,
        })
    }

    /// The surface at the end.
    pub(super) fn info(&self) -> Info {
        self.runner.info()
    }

    /// Readings at the end of the first half of a film.
    pub(super) fn back(&self) -> Option<&State> {
        self.back.map(|runner| &runner.state)
    }

    /// Least product of a unit face normal with a unit normal at its corners, on all surfaces of
    /// both halves of a film that are stored.
    pub(super) fn least_alignment(&self) -> f64 {
        let halves = [Some(self.runner), self.back];
        let least = halves.into_iter().flatten().map(Runner::least_alignment);
        least.fold(f64::INFINITY, f64::min)
    }

    /// Pairs of triangles that cross: the most on a stored surface, and at the end.
    pub(super) fn crossings(&self) -> [usize; 2] {
        let last = crossing::count(self.runner.triangles(), self.x);
        [self.runner.most_crossings(), last.unwrap_or(0)]
    }

    /// The jump of H across the boundary of what moves, relative.
    pub(super) fn jump(&self) -> Option<f64> {
        self.runner.curvature_jump().map(|jump| jump.relative)
    }

    /// The same of a flow side by side with others; NaN where there is none.
    pub(super) fn jump_of(&self, flow: FlowName) -> f64 {
        let mut runners = std::iter::once(self.runner).chain(self.session.panes.others());
        let runner = runners.find(|runner| runner.options().flow == flow);
        let jump = runner.and_then(Runner::curvature_jump);
        jump.map_or(f64::NAN, |jump| jump.relative)
    }

    /// Distance of start and end from the undamaged surface along its normals, root mean square;
    /// its boundary, which is held, does not count.
    pub(super) fn off_reference(&self) -> [f64; 2] {
        let mesh = self.runner.triangles();
        let Some(surface) = &self.reference else {
            return [f64::NAN; 2];
        };
        let is_inner = |v: usize| !mesh.is_boundary_vertex(crate::mesh::Vertex(v as u32));
        [self.start, self.x].map(|x| off_surface(x, mesh, surface, is_inner))
    }

    /// Edge flips by a criterion; zeros where it was not run.
    pub(super) fn flips(&self, criterion: Criterion) -> Option<&FlipReading> {
        let readings = self.last.flips.as_deref().unwrap_or_default();
        readings.iter().find(|one| one.criterion == criterion)
    }

    /// Sum over the edges of a picture of how much a field differs between their ends; NaN where
    /// there is none of that name.
    pub(super) fn variation(&self, name: &str, field: FieldName) -> f64 {
        let panes = pictures(self.runner, &self.session.panes, Some(field));
        let pane = panes.iter().find(|pane| pane.name == name);
        let Some((pane, field)) = pane.and_then(|pane| Some((pane, pane.field.as_ref()?))) else {
            return f64::NAN;
        };
        let value = |v: u32| f64::from(field.values[v as usize]);
        let edges = pane.wire_edges.chunks_exact(2);
        edges
            .map(|ends| (value(ends[0]) - value(ends[1])).abs())
            .sum()
    }
}
