//! Where a step began, to go back to where it is given up.

use super::{Position, Runner, Viewed};
use crate::app::engine::Engine;
use crate::app::history::SnapshotId;
use crate::app::readings::State;
use crate::app::segment::Segment;
use crate::flow::{FlowError, Mark};
use glam::DVec3;
use std::rc::Rc;

/// All that a step may change, or can be made again as it was.
pub(super) struct ReturnPoint {
    x: Vec<DVec3>,
    state: State,
    failure: Option<FlowError>,
    snapshot: SnapshotId,
    segment: Rc<Segment>,
    engine_segment: Rc<Segment>,
    segments: u32,
    viewed: Option<Viewed>,
    restarted: bool,
    mark: Option<Mark>,
}

impl Runner {
    pub(super) fn return_point(&self) -> ReturnPoint {
        let viewed = match &self.position {
            Position::Live => None,
            Position::Viewing(viewed) => Some(viewed.clone()),
        };
        let live = self.engine.as_ref().filter(|_| viewed.is_none());
        ReturnPoint {
            x: self.x.clone(),
            state: self.state.clone(),
            failure: self.failure.clone(),
            snapshot: self.history.here(),
            segment: Rc::clone(&self.segment),
            engine_segment: Rc::clone(&self.engine_segment),
            segments: self.segments,
            mark: live.and_then(Engine::mark),
            restarted: self.restarted,
            viewed,
        }
    }

    /// Goes back to where a step began that is given up.
    pub(super) fn go_back(&mut self, here: ReturnPoint) {
        if self.history.here() != here.snapshot {
            // A pass of remeshing, which no step has followed.
            let live = self.copied();
            if let Some(live) = live {
                self.history.back(live);
                self.history.drop_future();
            }
        }
        if let Some(engine) = self.aside.take() {
            self.engine = Some(engine);
        }
        (self.x, self.state, self.failure) = (here.x, here.state, here.failure);
        (self.segment, self.engine_segment) = (here.segment, here.engine_segment);
        (self.segments, self.restarted) = (here.segments, here.restarted);
        if let (Some(mark), Some(engine)) = (here.mark, &mut self.engine) {
            engine.go_back(mark);
        }
        self.position = match here.viewed {
            None => Position::Live,
            // What stood where it had computed last was given away for what is shown.
            Some(viewed) => Position::Viewing(Viewed {
                engine_at: None,
                ..viewed
            }),
        };
    }
}
