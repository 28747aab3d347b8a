//! Looking around in a run: any stored step is shown as it was, and branches are switched to.
//!
//! What is shown moves, the flow itself stays where it last computed: whoever looks back and
//! returns goes on as if he had not. Only a step from elsewhere makes the flow anew there.

use super::Session;
use super::engine::Checkpoint;
use super::fault::Fault;
use super::history::{Moment, MomentId, Timeline};
use super::message::AppError;
use super::readings::State;
use super::work::Work;
use std::rc::Rc;

/// What belongs to the moment that is shown, where the flow stands at another.
pub(super) struct Shown {
    checkpoint: Checkpoint,
    flipped: Vec<u32>,
}

impl Session {
    /// Shows a stored step of the present path, the nearest at or before `step` where that is
    /// not stored: positions, readings and checkpoint exactly as then. Later steps stay stored, and
    /// a step from here keeps them as a branch.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn seek(&mut self, step: usize) -> Result<State, Fault> {
        Ok(self.work_mut()?.seek(step))
    }

    /// The steps that can be shown, and the branches.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn timeline(&self) -> Result<Timeline, Fault> {
        let work = self.work()?;
        Ok(work.history.timeline(work.state.step))
    }

    /// Goes to the end of a branch; the rest of the path left becomes a branch itself.
    ///
    /// # Errors
    /// `NoSuchBranch`: it was forgotten, or there never was one of that number.
    pub fn branch(&mut self, id: u32) -> Result<State, Fault> {
        self.work_mut()?.branch(id)
    }

    /// Makes the flow anew where it stands, as a step after a look back does: what it knows of
    /// earlier steps is forgotten, the checkpoint is not.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn renew(&mut self) -> Result<(), Fault> {
        let work = self.work_mut()?;
        if let Some(checkpoint) = work.checkpoint() {
            let flipped = work.folded().to_vec();
            work.shown = Some(Shown {
                checkpoint,
                flipped,
            });
            work.flow_at = MomentId::MAX;
        }
        Ok(())
    }

    /// Step, time, step size, energy and monitored functional of the steps after `step` up to
    /// the one shown.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn samples_after(&self, step: usize) -> Result<Vec<[f64; 5]>, Fault> {
        let reports = self.work()?.history.reports();
        let first = reports.partition_point(|report| report.step <= step);
        let sample =
            |r: &crate::flow::StepReport| [r.step as f64, r.time, r.dt, r.energy, r.objective];
        Ok(reports[first..].iter().map(sample).collect())
    }
}

impl Work {
    /// The checkpoint of the moment that is shown.
    pub(super) fn checkpoint(&self) -> Option<Checkpoint> {
        match &self.shown {
            Some(shown) if self.flow_at != self.history.here() => Some(shown.checkpoint),
            _ => self.flow.as_ref().map(|flow| flow.checkpoint()),
        }
    }

    /// Triangles that folded over in the step that led to what is shown.
    pub(super) fn folded(&self) -> &[u32] {
        match (&self.shown, &self.flow) {
            (Some(shown), _) if self.flow_at != self.history.here() => &shown.flipped,
            (_, Some(flow)) => flow.flipped_faces(),
            _ => &[],
        }
    }

    /// What is shown, as a moment without positions.
    fn present_moment(&self) -> Option<Moment> {
        let flipped = self.folded().to_vec();
        let (id, checkpoint) = (self.history.here(), self.checkpoint()?);
        let (course, state) = (Rc::clone(&self.course), self.state.clone());
        Some(Moment::new(id, None, course, checkpoint, state, flipped))
    }

    fn moves_positions(&self) -> bool {
        self.flow.as_ref().is_some_and(|f| f.flips().is_none())
    }

    /// A copy of what is shown.
    pub(super) fn copied(&self) -> Option<Moment> {
        let mut moment = self.present_moment()?;
        moment.x = self.moves_positions().then(|| self.x.clone());
        Some(moment)
    }

    /// Replaces what is shown by the moment that `choose` gives for it.
    fn exchange(&mut self, choose: impl FnOnce(&mut super::history::History, Moment) -> Moment) {
        let Some(mut live) = self.present_moment() else {
            return;
        };
        live.x = self.moves_positions().then(|| std::mem::take(&mut self.x));
        let moment = choose(&mut self.history, live);
        if let Some(x) = moment.x {
            self.x = x;
        }
        self.course = moment.course;
        self.state = moment.state;
        self.state.can_step_back = self.history.can_go_back();
        self.shown = Some(Shown {
            checkpoint: moment.checkpoint,
            flipped: moment.flipped,
        });
    }

    /// After a change of what is shown: flips are replayed, the flow is the one that stood
    /// there, and what stands beside follows.
    fn settle(&mut self) {
        let checkpoint = self.checkpoint();
        if !Rc::ptr_eq(&self.course, &self.flow_of) {
            // It started before; if memory is short now, the next step will say so.
            if let (Some(checkpoint), Ok(mut flow)) = (checkpoint, self.started()) {
                flow.restore(checkpoint);
                self.flow = Some(flow);
                self.flow_of = Rc::clone(&self.course);
            }
            // A step from here makes it anew, as everywhere else that was gone to.
            self.flow_at = MomentId::MAX;
        }
        if let (Some(checkpoint), Some(flow)) = (checkpoint, &mut self.flow)
            && let Some(flips) = flow.flips_mut()
        {
            if let Checkpoint::Flips(clock) = checkpoint {
                flips.seek(clock);
            }
            let readings = flips.readings();
            // Criteria may have joined since.
            if self
                .state
                .flips
                .as_ref()
                .is_some_and(|f| f.len() != readings.len())
            {
                self.state.flips = Some(readings);
            }
            self.flow_at = self.history.here();
        }
        self.seek_beside();
    }

    /// One stored moment back, if there is one.
    pub(super) fn back(&mut self) -> State {
        if self.history.can_go_back() {
            self.exchange(|history, live| history.back(live));
            self.settle();
        }
        self.state.clone()
    }

    /// One stored moment on, if there is one.
    pub(super) fn forth(&mut self) {
        if self.history.next_step().is_some() {
            self.exchange(|history, live| history.forth(live));
            self.settle();
        }
    }

    /// To the start, also before a regularisation there, with the options in force.
    pub(super) fn rewind(&mut self) -> Result<State, Fault> {
        let options = self.options().clone();
        while self.history.can_go_back() {
            self.exchange(|history, live| history.back(live));
        }
        self.settle();
        if *self.options() != options {
            self.continue_with(options)?;
        }
        Ok(self.state.clone())
    }

    pub(super) fn seek(&mut self, step: usize) -> State {
        let here = self.history.here();
        while self.state.step > step && self.history.can_go_back() {
            self.exchange(|history, live| history.back(live));
        }
        while self.history.next_step().is_some_and(|next| next <= step) {
            self.exchange(|history, live| history.forth(live));
        }
        if self.history.here() != here {
            self.settle();
        }
        self.state.clone()
    }

    fn seek_moment(&mut self, id: MomentId) {
        let ahead = self.history.is_ahead(id);
        while self.history.here() != id {
            if ahead {
                self.exchange(|history, live| history.forth(live));
            } else if self.history.can_go_back() {
                self.exchange(|history, live| history.back(live));
            } else {
                break;
            }
        }
    }

    fn branch(&mut self, id: u32) -> Result<State, Fault> {
        let way = self.history.way_to(id);
        if way.is_empty() {
            return Err(AppError::NoSuchBranch { branch: id }.into());
        }
        for (fork, id) in way {
            self.seek_moment(fork);
            self.history.turn(id, self.state.step);
        }
        self.seek(usize::MAX);
        self.settle();
        Ok(self.state.clone())
    }

    /// Makes the flow ready to compute from what is shown.
    ///
    /// # Errors
    /// As [`Driver::start`](crate::flow::Driver::start), if memory is short; nothing has changed.
    pub(super) fn stand_here(&mut self) -> Result<(), Fault> {
        let Some(checkpoint) = self
            .checkpoint()
            .filter(|_| self.flow_at != self.history.here())
        else {
            return Ok(());
        };
        let mut flow = self.started()?;
        flow.restore(checkpoint);
        self.flow = Some(flow);
        self.flow_of = Rc::clone(&self.course);
        self.flow_at = self.history.here();
        self.anew = true;
        Ok(())
    }
}
