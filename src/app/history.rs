//! The snapshots of a run: the path to the present one, what comes after it, and the branches
//! that leave it. Bounded in number and in memory.

use super::engine::Checkpoint;
use super::readings::State;
use super::segment::Segment;
use crate::flow::StepReport;
use crate::flow::options::FlowOptions;
use crate::remesh::static_pass::RegulariseOptions;
use glam::DVec3;
use serde::Serialize;
use std::collections::VecDeque;
use std::rc::Rc;

/// Bytes at most: a wasm heap of 4 GiB also holds the factor.
const MAX_BYTES: usize = 192 << 20;
/// Branches at most.
const MAX_BRANCHES: usize = 8;

/// Name of a snapshot. Snapshots that are equal to the last bit and have the same past share it.
pub(super) type SnapshotId = u64;

/// How a snapshot came about from the one before it.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Transition {
    pub(super) event: Event,
    /// Whether the flow was made anew for it and knew nothing of earlier steps.
    pub(super) restarted: bool,
}

/// What leads from a snapshot to the next.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Event {
    Step,
    Regularise(RegulariseOptions),
    /// From here on a flow of these options.
    Flow(Rc<FlowOptions>),
    /// From here on another mesh of the same surface; it follows from what was there.
    Pass,
}

/// All of a run that changes from step to step.
pub(super) struct Snapshot {
    pub(super) id: SnapshotId,
    /// Positions, where the flow moves any.
    pub(super) x: Option<Vec<DVec3>>,
    /// The flow that stood there, and how far it was.
    pub(super) segment: Rc<Segment>,
    pub(super) checkpoint: Checkpoint,
    pub(super) state: State,
    /// Faces that folded over in the step that led here.
    pub(super) flipped: Vec<u32>,
    /// Kept by the path while the snapshot is on it.
    came: Option<(Transition, Option<StepReport>)>,
}

impl Snapshot {
    pub(super) fn new(
        id: SnapshotId,
        x: Option<Vec<DVec3>>,
        segment: Rc<Segment>,
        checkpoint: Checkpoint,
        state: State,
        flipped: Vec<u32>,
    ) -> Self {
        Self {
            id,
            x,
            segment,
            checkpoint,
            state,
            flipped,
            came: None,
        }
    }

    /// Whether a pass of remeshing made it, which belongs to the step after it and is not shown.
    fn is_of_pass(&self) -> bool {
        let event = self.came.as_ref().map(|(transition, _)| &transition.event);
        event == Some(&Event::Pass)
    }

    fn bytes(&self) -> usize {
        let positions = self.x.as_deref().unwrap_or_default();
        // Others share its segment, and go before the first of it.
        let is_first = self.state.step == self.segment.from;
        let segment = if is_first { self.segment.bytes() } else { 0 };
        size_of::<Self>() + size_of_val(positions) + size_of_val(&*self.flipped) + segment
    }
}

/// Another way on from a snapshot.
struct Branch {
    id: u32,
    /// The snapshot it leaves.
    fork: SnapshotId,
    from: usize,
    /// The next one last.
    snapshots: Vec<Snapshot>,
}

impl Branch {
    /// Its last snapshot.
    fn tip(&self) -> Option<&Snapshot> {
        self.snapshots.first()
    }

    /// The snapshot that follows another.
    fn after(&self, id: SnapshotId) -> Option<&Snapshot> {
        if self.fork == id {
            return self.snapshots.last();
        }
        let place = self.snapshots.iter().position(|m| m.id == id)?;
        self.snapshots.get(place.checked_sub(1)?)
    }
}

/// A branch, for people to choose from.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct BranchInfo {
    /// Its number.
    pub id: u32,
    /// The step it leaves.
    pub from: usize,
    /// Its last step.
    pub last: usize,
    /// The flow's own energy there.
    pub energy: f64,
}

/// The steps that can be shown.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Timeline {
    /// The step of the start, which is always stored.
    pub start: usize,
    /// From here to `last` every step is stored; between it and the start, none.
    pub first: usize,
    /// The last step of the present path.
    pub last: usize,
    /// The step that is shown.
    pub at: usize,
    /// The stored step before it.
    pub previous: Option<usize>,
    /// The stored step after it; the same where the mesh was regularised next.
    pub next: Option<usize>,
    /// Snapshots of the present path that are stored.
    pub stored: usize,
    /// Other ways on, oldest first.
    pub branches: Vec<BranchInfo>,
}

/// Every snapshot but the present one, which the session holds.
pub(super) struct History {
    /// From the start.
    past: VecDeque<Snapshot>,
    /// The next one last.
    future: Vec<Snapshot>,
    branches: VecDeque<Branch>,
    /// How the present snapshot and each before it came about, forgotten ones too.
    transitions: Vec<Transition>,
    reports: Vec<StepReport>,
    /// The present snapshot.
    here: SnapshotId,
    last_id: SnapshotId,
    last_branch: u32,
    has_forgotten: bool,
    bytes: usize,
    limit: usize,
}

impl Default for History {
    fn default() -> Self {
        Self {
            past: VecDeque::new(),
            future: Vec::new(),
            branches: VecDeque::new(),
            transitions: Vec::new(),
            reports: Vec::new(),
            here: 0,
            last_id: 0,
            last_branch: 0,
            has_forgotten: false,
            bytes: 0,
            limit: MAX_BYTES,
        }
    }
}

impl History {
    pub(super) fn here(&self) -> SnapshotId {
        self.here
    }

    pub(super) fn transitions(&self) -> &[Transition] {
        &self.transitions
    }

    /// The snapshots of the path before and after the present one.
    pub(super) fn path(&self) -> impl Iterator<Item = &Snapshot> {
        self.past.iter().chain(&self.future)
    }

    /// The first snapshot of the path to the present one; `None` where that is the first.
    pub(super) fn first(&self) -> Option<&Snapshot> {
        self.past.front()
    }

    /// The snapshot before the present one.
    pub(super) fn last(&self) -> Option<&Snapshot> {
        self.past.back()
    }

    /// Of the steps to the present snapshot, oldest first.
    pub(super) fn reports(&self) -> &[StepReport] {
        &self.reports
    }

    pub(super) fn can_go_back(&self) -> bool {
        !self.past.is_empty()
    }

    /// Whether any snapshot but the present one is stored.
    pub(super) fn has_snapshots(&self) -> bool {
        self.can_go_back() || !self.future.is_empty()
    }

    /// Whether a change of the flow led to the present snapshot, and nothing came of it.
    pub(super) fn ends_with_new_flow(&self) -> bool {
        let last = self.transitions.last().map(|transition| &transition.event);
        matches!(last, Some(Event::Flow(_))) && self.future.is_empty() && self.can_go_back()
    }

    /// Whether the present snapshot is what a pass made, which a step follows.
    pub(super) fn ends_with_pass(&self) -> bool {
        let last = self.transitions.last().map(|transition| &transition.event);
        last == Some(&Event::Pass) && self.can_go_back()
    }

    /// Forgets what is stored to come.
    pub(super) fn drop_future(&mut self) {
        for snapshot in self.future.drain(..) {
            self.bytes -= snapshot.bytes();
        }
    }

    /// The step after the present one that is stored.
    pub(super) fn next_step(&self) -> Option<usize> {
        self.future.last().map(|snapshot| snapshot.state.step)
    }

    pub(super) fn timeline(&self, at: usize) -> Timeline {
        let start = self.past.front().map_or(at, |m| m.state.step);
        let second = self.past.get(1).map_or(at, |m| m.state.step);
        let info = |branch: &Branch| {
            let tip = &branch.tip()?.state;
            Some(BranchInfo {
                id: branch.id,
                from: branch.from,
                last: tip.step,
                energy: tip.energy,
            })
        };
        Timeline {
            start,
            first: if self.has_forgotten { second } else { start },
            last: self.future.first().map_or(at, |m| m.state.step),
            at,
            previous: (self.past.iter().rev())
                .map(|m| m.state.step)
                .find(|step| *step < at),
            next: (self.future.iter().rev())
                .find(|m| !m.is_of_pass())
                .map(|m| m.state.step),
            stored: self.past.len() + 1 + self.future.len(),
            branches: self.branches.iter().filter_map(info).collect(),
        }
    }

    /// The present snapshot has become a past one, and what `transition` made of it the present.
    ///
    /// What was stored to come after it becomes a branch, unless it is the same to the last
    /// bit; a branch that the path has come to the end of is no more.
    pub(super) fn follow(
        &mut self,
        before: Snapshot,
        transition: Transition,
        report: Option<StepReport>,
        x: Option<&[DVec3]>,
        now: &State,
    ) {
        let (fork, from) = (before.id, before.state.step);
        self.bytes += before.bytes();
        self.past.push_back(before);
        let event = transition.event.clone();
        self.transitions.push(transition);
        self.reports.extend(report);
        if x.is_some() {
            let future = std::mem::take(&mut self.future);
            self.keep(fork, from, future);
        } else {
            // Edge flips have one way only: further on is what was stored.
            while let Some(passed) = self.future.pop_if(|m| m.state.step <= now.step) {
                self.bytes -= passed.bytes();
            }
        }
        self.last_id += 1;
        self.here = self.last_id;
        self.recognise(fork, &event, x, now);
        self.forget();
    }

    /// Gives the present snapshot the name of one that is the same.
    fn recognise(&mut self, fork: SnapshotId, event: &Event, x: Option<&[DVec3]>, now: &State) {
        let is_same = |m: &Snapshot| {
            m.came
                .as_ref()
                .is_some_and(|(transition, _)| transition.event == *event)
                && (m.state.step, m.state.time) == (now.step, now.time)
                && m.x.as_deref() == x
        };
        let same = |branch: &Branch| branch.after(fork).filter(|m| is_same(m)).map(|m| m.id);
        let Some(id) = self.branches.iter().find_map(same) else {
            return;
        };
        self.here = id;
        let is_over = |branch: &Branch| branch.tip().is_some_and(|tip| tip.id == id);
        if let Some(place) = self.branches.iter().position(is_over) {
            self.drop_branch(place);
        }
    }

    /// Keeps what comes after a snapshot as a branch.
    fn keep(&mut self, fork: SnapshotId, from: usize, snapshots: Vec<Snapshot>) {
        if snapshots.is_empty() {
            return;
        }
        self.last_branch += 1;
        self.branches.push_back(Branch {
            id: self.last_branch,
            fork,
            from,
            snapshots,
        });
        if self.branches.len() > MAX_BRANCHES {
            self.drop_branch(0);
        }
    }

    /// Drops a branch, and those that leave from it and cannot be reached without it.
    fn drop_branch(&mut self, place: usize) {
        let mut lost = vec![place];
        while let Some(place) = lost.pop() {
            for snapshot in self
                .branches
                .remove(place)
                .map(|b| b.snapshots)
                .into_iter()
                .flatten()
            {
                self.bytes -= snapshot.bytes();
            }
            lost.extend(
                self.branches
                    .iter()
                    .position(|b| !self.is_on_path(b.fork) && self.holder(b.fork).is_none()),
            );
        }
    }

    /// Keeps within the bounds: branches go first, the oldest foremost, then early steps. The
    /// start and one step back always stay.
    fn forget(&mut self) {
        while self.bytes > self.limit {
            if !self.branches.is_empty() {
                self.drop_branch(0);
            } else if self.past.len() > 2
                && let Some(snapshot) = self.past.remove(1)
            {
                self.bytes -= snapshot.bytes();
                self.has_forgotten = true;
            } else {
                break;
            }
        }
    }

    /// The snapshot before `live`, which becomes one to come.
    pub(super) fn back(&mut self, mut live: Snapshot) -> Snapshot {
        let Some(previous) = self.past.pop_back() else {
            return live;
        };
        live.came = self
            .transitions
            .pop()
            .map(|transition| match transition.event {
                Event::Step => (transition, self.reports.pop()),
                Event::Regularise(_) | Event::Flow(_) | Event::Pass => (transition, None),
            });
        self.bytes = self.bytes + live.bytes() - previous.bytes();
        self.future.push(live);
        self.here = previous.id;
        previous
    }

    /// The snapshot after `live`, which becomes a past one.
    pub(super) fn forth(&mut self, live: Snapshot) -> Snapshot {
        let Some(mut next) = self.future.pop() else {
            return live;
        };
        if let Some((transition, report)) = next.came.take() {
            self.transitions.push(transition);
            self.reports.extend(report);
        }
        self.bytes = self.bytes + live.bytes() - next.bytes();
        self.past.push_back(live);
        self.here = next.id;
        next
    }

    fn is_on_path(&self, id: SnapshotId) -> bool {
        let stored = self.past.iter().chain(&self.future);
        self.here == id || stored.into_iter().any(|m| m.id == id)
    }

    /// The branch that a snapshot is on.
    fn holder(&self, id: SnapshotId) -> Option<&Branch> {
        let holds = |b: &&Branch| b.snapshots.iter().any(|m| m.id == id);
        self.branches.iter().find(holds)
    }

    /// The snapshots at which to turn, each into a branch, to come to the end of a branch;
    /// empty if there is none of that number.
    pub(super) fn way_to(&self, id: u32) -> Vec<(SnapshotId, u32)> {
        let mut way = Vec::new();
        let mut branch = self.branches.iter().find(|b| b.id == id);
        while let Some(b) = branch {
            way.push((b.fork, b.id));
            branch = if self.is_on_path(b.fork) {
                None
            } else {
                self.holder(b.fork)
            };
        }
        way.reverse();
        way
    }

    /// Whether a snapshot of the path comes after the present one.
    pub(super) fn is_ahead(&self, id: SnapshotId) -> bool {
        self.future.iter().any(|m| m.id == id)
    }

    /// At the snapshot a branch leaves: what was to come and the branch event places.
    pub(super) fn turn(&mut self, id: u32, at: usize) {
        let Some(place) = self.branches.iter().position(|b| b.id == id) else {
            return;
        };
        let Some(branch) = self.branches.remove(place) else {
            return;
        };
        let before = std::mem::replace(&mut self.future, branch.snapshots);
        // What the branch has too need not be kept.
        if before.first().is_some_and(|tip| self.is_on_path(tip.id)) {
            self.bytes -= before.iter().map(Snapshot::bytes).sum::<usize>();
        } else {
            self.keep(self.here, at, before);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn snapshot(history: &History, step: usize, size: usize) -> Snapshot {
        let state = State {
            step,
            ..State::default()
        };
        let x = vec![DVec3::splat(step as f64); size];
        Snapshot::new(
            history.here(),
            Some(x),
            Rc::default(),
            Checkpoint::Flips(step),
            state,
            Vec::new(),
        )
    }

    /// A step to `value`, from a snapshot of so many points.
    fn step(history: &mut History, from: usize, size: usize, value: f64) {
        let before = snapshot(history, from, size);
        let now = State {
            step: from + 1,
            ..State::default()
        };
        let transition = Transition {
            event: Event::Step,
            restarted: false,
        };
        let x = vec![DVec3::splat(value); size];
        history.follow(before, transition, None, Some(&x), &now);
    }

    fn counted(history: &History) -> usize {
        let branched = history.branches.iter().flat_map(|b| &b.snapshots);
        let stored = history.past.iter().chain(&history.future).chain(branched);
        stored.map(Snapshot::bytes).sum()
    }

    fn steps_of(history: &History) -> Vec<usize> {
        history.past.iter().map(|m| m.state.step).collect()
    }

    #[test]
    fn early_steps_are_forgotten_and_the_start_is_not() {
        let mut history = History {
            limit: 10 * (size_of::<Snapshot>() + 100 * size_of::<DVec3>()),
            ..History::default()
        };
        for n in 0..50 {
            step(&mut history, n, 100, (n + 1) as f64);
            assert!(history.bytes <= history.limit && history.bytes == counted(&history));
        }
        assert_eq!(steps_of(&history), [0, 41, 42, 43, 44, 45, 46, 47, 48, 49]);
        let timeline = history.timeline(50);
        assert_eq!((timeline.start, timeline.first), (0, 41));
        assert_eq!((timeline.at, timeline.last), (50, 50));
        // How it came about is known all the same.
        assert_eq!(history.transitions().len(), 50);
        // A step back always stays, however large.
        step(&mut history, 50, 5000, 51.0);
        step(&mut history, 51, 5000, 52.0);
        assert_eq!(steps_of(&history), [0, 51]);
    }

    /// Goes back by some snapshots.
    fn go_back(history: &mut History, from: usize, count: usize) {
        for n in 0..count {
            let live = snapshot(history, from - n, 4);
            history.back(live);
        }
    }

    #[test]
    fn the_oldest_branch_goes_first_and_what_hangs_on_it_too() {
        let mut history = History::default();
        step(&mut history, 0, 4, 1.0);
        // Ten ways on from the start.
        for way in 2..12 {
            go_back(&mut history, 1, 1);
            step(&mut history, 0, 4, f64::from(way));
        }
        let ids = |history: &History| history.branches.iter().map(|b| b.id).collect::<Vec<_>>();
        assert_eq!(ids(&history), [3, 4, 5, 6, 7, 8, 9, 10]);
        assert_eq!(history.bytes, counted(&history));
        // A branch of a branch: from step 1 of the present way, which then is left.
        step(&mut history, 1, 4, 50.0);
        go_back(&mut history, 2, 1);
        step(&mut history, 1, 4, 51.0);
        go_back(&mut history, 2, 2);
        step(&mut history, 0, 4, 60.0);
        assert_eq!(ids(&history), [5, 6, 7, 8, 9, 10, 11, 12]);
        let way: Vec<u32> = history.way_to(11).into_iter().map(|(_, id)| id).collect();
        assert_eq!(way, [12, 11], "by way of the branch it leaves");
        let place = history.branches.iter().position(|b| b.id == 12);
        history.drop_branch(place.expect("the branch"));
        assert_eq!(ids(&history), [5, 6, 7, 8, 9, 10], "both are gone");
        assert_eq!(history.bytes, counted(&history));
    }

    #[test]
    fn the_same_steps_again_are_no_branch() {
        let mut history = History::default();
        for n in 0..5 {
            step(&mut history, n, 4, (n + 1) as f64);
        }
        go_back(&mut history, 5, 3);
        step(&mut history, 2, 4, 3.0);
        let branches = history.timeline(3).branches;
        assert_eq!((branches[0].from, branches[0].last), (2, 5));
        step(&mut history, 3, 4, 4.0);
        step(&mut history, 4, 4, 5.0);
        assert_eq!(history.timeline(5).branches, []);
        assert_eq!(history.bytes, counted(&history));
    }
}
