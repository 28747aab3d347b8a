//! Running a figure, a step at a time, and what its judge sees.

use super::figure::{Figure, Finding, Steps};
use super::measure::off_surface;
use crate::app::work::Work;
use crate::app::{Fault, FieldName, Info, Session, State};
use crate::flow::flips::FlipReading;
use crate::flow::options::{FlowName, FlowOptions};
use crate::remesh::flips::reduction::Criterion;
use crate::remesh::static_pass::Regularised;
use glam::DVec3;

/// Steps in which a figure comes to rest, or not: what is measured must not depend on how fast
/// the machine is.
const REST: usize = 400;

/// A figure under way, on surfaces of its own.
pub struct FigureRun {
    figure: &'static Figure,
    session: Session,
    /// Ends on the coarser meshes so far.
    refined: Vec<State>,
    /// Steps on the present mesh; `None` before it is made.
    steps: Option<usize>,
    /// Whether the present mesh came to its end.
    is_over: bool,
}

impl FigureRun {
    /// Nothing is computed yet.
    pub fn new(figure: &'static Figure) -> Self {
        Self {
            figure,
            session: Session::new(),
            refined: Vec::new(),
            steps: None,
            is_over: false,
        }
    }

    /// Where it has come to.
    pub fn session(&self) -> &Session {
        &self.session
    }

    /// Steps on the present mesh.
    pub fn steps(&self) -> usize {
        self.steps.unwrap_or(0)
    }

    /// Makes a surface or takes one step; with the last of it comes the finding.
    ///
    /// # Errors
    /// Whatever refuses; the run cannot go on then.
    pub fn advance(&mut self) -> Result<Option<Finding>, Fault> {
        let figure = self.figure;
        let Some(steps) = self.steps else {
            let refined = self.refined.len();
            let over = figure.refine.get(refined).copied().unwrap_or_default();
            figure.begin_with(&mut self.session, over)?;
            self.steps = Some(0);
            self.is_over = figure.steps == Steps::Count(0);
            return Ok(None);
        };
        if !self.is_over {
            let has_stepped = self.session.step()?.is_some();
            let steps = steps + usize::from(has_stepped);
            self.steps = Some(steps);
            self.is_over = !has_stepped
                || figure.steps == Steps::Count(steps)
                || self.session.state()?.status.is_final();
            return Ok(None);
        }
        if self.refined.len() < figure.refine.len() {
            self.refined.push(self.session.state()?);
            self.steps = None;
            return Ok(None);
        }
        let regularised = match &figure.regularise {
            Some(settings) => Some(self.session.regularise(settings)?),
            None => None,
        };
        let refined = std::mem::take(&mut self.refined);
        let run = Run::of(figure, self.session.work()?, refined, regularised)?;
        Ok(Some((figure.judge)(&run)))
    }
}

impl Figure {
    /// Its sample, arrangement and flow in a session, nothing run.
    ///
    /// # Errors
    /// Options that its surface refuses.
    pub fn begin(&self, session: &mut Session) -> Result<(), Fault> {
        self.begin_with(session, &[])
    }

    fn begin_with(&self, session: &mut Session, over: &[(&str, f64)]) -> Result<(), Fault> {
        let Some(sample) = self.sample() else {
            return Err(Fault::no_mesh());
        };
        sample.load(session, over)?;
        session.arrange(self.arrangement)?;
        let limit = match self.steps {
            Steps::Rest => REST,
            Steps::Count(count) => count.max(1),
        };
        session.configure(FlowOptions {
            max_steps: Some(limit),
            ..self.whole_options()
        })?;
        Ok(())
    }

    /// All of it at once.
    ///
    /// # Errors
    /// As [`FigureRun::advance`].
    pub fn run(&'static self) -> Result<Finding, Fault> {
        let mut run = FigureRun::new(self);
        loop {
            if let Some(finding) = run.advance()? {
                return Ok(finding);
            }
        }
    }

    /// What a session has come to that shows this figure; `None` where that does not say it all:
    /// other runs belong to it, or positions came from outside.
    ///
    /// # Errors
    /// Without a mesh.
    pub fn judged(&self, session: &Session) -> Result<Option<Finding>, Fault> {
        let work = session.work()?;
        if self.is_compound() || work.is_restored {
            return Ok(None);
        }
        let run = Run::of(self, work, Vec::new(), None)?;
        Ok(Some((self.judge)(&run)))
    }
}

/// What a judge sees of a run.
pub(in crate::app) struct Run<'a> {
    work: &'a Work,
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
    /// Of the undamaged surface.
    reference: Option<Vec<DVec3>>,
}

impl<'a> Run<'a> {
    fn of(
        figure: &Figure,
        work: &'a Work,
        refined: Vec<State>,
        regularised: Option<Regularised>,
    ) -> Result<Self, Fault> {
        let reference = match &figure.reference {
            Some(shape) => {
                let mut clean = Session::new();
                shape.load(&mut clean, &[])?;
                Some(clean.work()?.x.clone())
            }
            None => None,
        };
        let (first, start) = work.beginning();
        Ok(Self {
            work,
            first,
            last: &work.state,
            start,
            x: &work.x,
            refined,
            regularised,
            reference,
        })
    }

    /// The surface at the end.
    pub(super) fn info(&self) -> Info {
        self.work.info()
    }

    /// The jump of H across the boundary of what moves, relative.
    pub(super) fn jump(&self) -> Option<f64> {
        self.work.curvature_jump().map(|jump| jump.relative)
    }

    /// The same of a flow side by side with others; NaN where there is none.
    pub(super) fn jump_of(&self, flow: FlowName) -> f64 {
        let mut works = std::iter::once(self.work).chain(&self.work.beside);
        let work = works.find(|work| work.options().flow == flow);
        let jump = work.and_then(Work::curvature_jump);
        jump.map_or(f64::NAN, |jump| jump.relative)
    }

    /// Distance of start and end from the undamaged surface along its normals, root mean square;
    /// its boundary, which is held, does not count.
    pub(super) fn off_reference(&self) -> [f64; 2] {
        let mesh = self.work.triangles();
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
        let panes = self.work.panes(Some(field));
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
