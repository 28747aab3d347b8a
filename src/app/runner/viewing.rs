//! Looking around in a run: any stored step is shown as it was, and branches are switched to.

use super::{Position, Runner, Viewed};
use crate::app::Session;
use crate::app::engine::{Checkpoint, Engine};
use crate::app::fault::Fault;
use crate::app::history::{History, Snapshot, SnapshotId, Timeline};
use crate::app::message::AppError;
use crate::app::readings::State;
use std::rc::Rc;

impl Session {
    /// Shows a stored step of the present path, the nearest at or before `step` where that is
    /// not stored: positions, readings and checkpoint exactly as then. Later steps stay stored, and
    /// a step from here keeps them as a branch.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn seek(&mut self, step: usize) -> Result<State, Fault> {
        let state = self.runner_mut()?.seek(step);
        self.settle_panes();
        Ok(state)
    }

    /// The steps that can be shown, and the branches.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn timeline(&self) -> Result<Timeline, Fault> {
        let runner = self.runner()?;
        Ok(runner.history.timeline(runner.state.step))
    }

    /// Goes to the end of a branch; the rest of the path left becomes a branch itself.
    ///
    /// # Errors
    /// `NoSuchBranch`: it was forgotten, or there never was one of that number.
    pub fn branch(&mut self, id: u32) -> Result<State, Fault> {
        let state = self.runner_mut()?.branch(id)?;
        self.settle_panes();
        Ok(state)
    }

    /// Makes the flow anew where it stands, as a step after a look back does: what it knows of
    /// earlier steps is forgotten, the checkpoint is not.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn renew(&mut self) -> Result<(), Fault> {
        let runner = self.runner_mut()?;
        if let Some(checkpoint) = runner.checkpoint() {
            runner.position = Position::Viewing(Viewed {
                checkpoint,
                folded: runner.folded().to_vec(),
                engine_at: None,
            });
        }
        Ok(())
    }

    /// Step, time, step size, energy and monitored functional of the steps after `step` up to
    /// the one shown.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn samples_after(&self, step: usize) -> Result<Vec<[f64; 5]>, Fault> {
        let reports = self.runner()?.history.reports();
        let first = reports.partition_point(|report| report.step <= step);
        let sample =
            |r: &crate::flow::StepReport| [r.step as f64, r.time, r.dt, r.energy, r.objective];
        Ok(reports[first..].iter().map(sample).collect())
    }
}

impl Runner {
    /// The checkpoint of the snapshot that is shown.
    pub(in crate::app) fn checkpoint(&self) -> Option<Checkpoint> {
        match &self.position {
            Position::Viewing(viewed) => Some(viewed.checkpoint.clone()),
            Position::Live => self.engine.as_ref().map(Engine::checkpoint),
        }
    }

    /// Triangles that folded over in the step that led to what is shown.
    pub(in crate::app) fn folded(&self) -> &[u32] {
        match (&self.position, &self.engine) {
            (Position::Viewing(viewed), _) => &viewed.folded,
            (Position::Live, Some(engine)) => engine.flipped_faces(),
            (Position::Live, None) => &[],
        }
    }

    /// What is shown, as a snapshot without positions.
    fn present_snapshot(&self) -> Option<Snapshot> {
        let flipped = self.folded().to_vec();
        let (id, checkpoint) = (self.history.here(), self.checkpoint()?);
        let (segment, state) = (Rc::clone(&self.segment), self.state.clone());
        Some(Snapshot::new(id, None, segment, checkpoint, state, flipped))
    }

    fn moves_positions(&self) -> bool {
        self.engine.as_ref().is_some_and(|f| f.flips().is_none())
    }

    /// A copy of what is shown.
    pub(in crate::app) fn copied(&self) -> Option<Snapshot> {
        let mut snapshot = self.present_snapshot()?;
        snapshot.x = self.moves_positions().then(|| self.x.clone());
        Some(snapshot)
    }

    /// Replaces what is shown by the snapshot that `choose` gives for it.
    fn exchange(&mut self, choose: impl FnOnce(&mut History, Snapshot) -> Snapshot) {
        let Some(mut live) = self.present_snapshot() else {
            return;
        };
        live.x = self.moves_positions().then(|| std::mem::take(&mut self.x));
        let engine_at = match &self.position {
            Position::Live => Some(live.id),
            Position::Viewing(viewed) => viewed.engine_at,
        };
        let snapshot = choose(&mut self.history, live);
        if let Some(x) = snapshot.x {
            self.x = x;
        }
        self.segment = snapshot.segment;
        self.state = snapshot.state;
        self.state.can_step_back = self.history.can_go_back();
        self.position = match engine_at {
            Some(id) if id == self.history.here() => Position::Live,
            _ => Position::Viewing(Viewed {
                checkpoint: snapshot.checkpoint,
                folded: snapshot.flipped,
                engine_at,
            }),
        };
    }

    /// After a change of what is shown: flips are replayed, and the flow is the one that stood
    /// there.
    fn settle(&mut self) {
        let checkpoint = self.checkpoint();
        if !Rc::ptr_eq(&self.segment, &self.engine_segment) {
            // It started before; if memory is short now, the next step will say so.
            if let (Some(checkpoint), Ok(mut flow)) = (checkpoint.clone(), self.started()) {
                flow.restore(checkpoint);
                self.engine = Some(flow);
                self.engine_segment = Rc::clone(&self.segment);
            }
            // A step from here makes it anew, as everywhere else that was gone to.
            if let Position::Viewing(viewed) = &mut self.position {
                viewed.engine_at = None;
            }
        }
        if let (Some(checkpoint), Some(flow)) = (checkpoint, &mut self.engine)
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
            self.position = Position::Live;
        }
    }

    /// One stored snapshot back, if there is one.
    pub(in crate::app) fn back(&mut self) -> State {
        if self.history.can_go_back() {
            self.exchange(|history, live| history.back(live));
            self.leave_pass();
            self.settle();
        }
        self.state.clone()
    }

    /// A pass belongs to the step after it: the step before it is shown on its own mesh.
    fn leave_pass(&mut self) {
        while self.history.ends_with_pass() {
            self.exchange(|history, live| history.back(live));
        }
    }

    /// One stored snapshot on, if there is one.
    pub(in crate::app) fn forth(&mut self) {
        if self.history.next_step().is_some() {
            self.exchange(|history, live| history.forth(live));
            self.settle();
        }
    }

    /// To the start, also before a regularisation there, with the options in force.
    pub(in crate::app) fn rewind(&mut self) -> Result<State, Fault> {
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

    pub(in crate::app) fn seek(&mut self, step: usize) -> State {
        let here = self.history.here();
        while self.state.step > step && self.history.can_go_back() {
            self.exchange(|history, live| history.back(live));
        }
        while self.history.next_step().is_some_and(|next| next <= step) {
            self.exchange(|history, live| history.forth(live));
        }
        self.leave_pass();
        if self.history.here() != here {
            self.settle();
        }
        self.state.clone()
    }

    fn seek_snapshot(&mut self, id: SnapshotId) {
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
            self.seek_snapshot(fork);
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
    pub(in crate::app) fn stand_here(&mut self) -> Result<(), Fault> {
        let Position::Viewing(Viewed { checkpoint, .. }) = &self.position else {
            return Ok(());
        };
        let checkpoint = checkpoint.clone();
        let mut flow = self.started()?;
        flow.restore(checkpoint);
        self.engine = Some(flow);
        self.engine_segment = Rc::clone(&self.segment);
        self.position = Position::Live;
        self.restarted = true;
        Ok(())
    }
}
