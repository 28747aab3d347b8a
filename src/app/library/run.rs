//! Running a figure, a step at a time.

use super::figure::{Figure, Finding, Steps};
use super::measured::Run;
use crate::app::{Fault, Session, State};
use crate::flow::options::FlowOptions;

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
    /// Whether the first half of a film is done.
    is_turned: bool,
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
            is_turned: false,
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
            if !self.is_turned {
                figure.begin_with(&mut self.session, over)?;
            }
            if figure.back.is_some() {
                self.session.turn(figure.id)?;
            }
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
        if figure.back.is_some() && !self.is_turned {
            self.is_turned = true;
            self.steps = None;
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
        let run = Run::of(
            figure.reference.as_ref(),
            &self.session,
            refined,
            regularised,
        )?;
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
        let runner = session.runner()?;
        if self.is_compound() || runner.is_restored {
            return Ok(None);
        }
        let run = Run::of(self.reference.as_ref(), session, Vec::new(), None)?;
        Ok(Some((self.judge)(&run)))
    }
}
