//! What the flow remembers, and all that it has learnt.

use super::CurvatureFlow;
use super::ladder::Ladder;
use crate::flow::Move;
use glam::DVec3;
use std::rc::Rc;

/// What the flow must remember beside the positions.
#[derive(Clone, Copy, Debug)]
pub struct Memory {
    ladder: Ladder,
}

/// What a step may change beside that.
pub struct Learnt {
    memory: Memory,
    size: f64,
    known: Option<(f64, Rc<Move>)>,
    reached: Option<Rc<Vec<DVec3>>>,
    top: Option<Rc<Vec<DVec3>>>,
    is_iterative: bool,
}

impl CurvatureFlow {
    pub(super) fn own_memory(&self) -> Memory {
        Memory {
            ladder: self.ladder,
        }
    }

    pub(super) fn recall_own(&mut self, Memory { ladder }: Memory) {
        self.ladder = ladder;
        (self.reached, self.top) = (None, None);
        self.forget();
    }

    pub(super) fn own_learnt(&self) -> Learnt {
        Learnt {
            memory: self.own_memory(),
            size: self.size,
            known: self.known.clone(),
            reached: self.reached.clone(),
            top: self.top.clone(),
            is_iterative: self.is_iterative,
        }
    }

    pub(super) fn relearn_own(&mut self, learnt: Learnt) {
        self.recall_own(learnt.memory);
        (self.size, self.known) = (learnt.size, learnt.known);
        (self.reached, self.top) = (learnt.reached, learnt.top);
        self.is_iterative = learnt.is_iterative;
    }
}
