//! What the flow remembers, and all that it has learnt.

use super::CurvatureFlow;
use super::ladder::Ladder;
use super::solver::Reference;
use crate::flow::Move;
use glam::DVec3;
use std::rc::Rc;

/// What the flow must remember beside the positions.
#[derive(Clone, Debug)]
pub struct Memory {
    ladder: Ladder,
    reached: Option<Rc<Vec<DVec3>>>,
    top: Option<Rc<Vec<DVec3>>>,
    reference: Option<Rc<Reference>>,
}

/// What a step may change beside that.
pub struct Learnt {
    memory: Memory,
    size: f64,
    known: Option<(f64, Rc<Move>)>,
    is_iterative: bool,
}

impl CurvatureFlow {
    pub(super) fn own_memory(&self) -> Memory {
        Memory {
            ladder: self.ladder,
            reached: self.reached.clone(),
            top: self.top.clone(),
            reference: self.system.reference(),
        }
    }

    pub(super) fn recall_own(&mut self, memory: Memory) {
        self.ladder = memory.ladder;
        (self.reached, self.top) = (memory.reached, memory.top);
        self.choose_law();
        self.system.refer_to(memory.reference);
        self.forget();
    }

    /// What is known of the positions.
    pub(super) fn forget(&mut self) {
        self.curvatures = None;
        self.known = None;
    }

    pub(super) fn own_learnt(&self) -> Learnt {
        Learnt {
            memory: self.own_memory(),
            size: self.size,
            known: self.known.clone(),
            is_iterative: self.is_iterative,
        }
    }

    pub(super) fn relearn_own(&mut self, learnt: Learnt) {
        self.recall_own(learnt.memory);
        (self.size, self.known) = (learnt.size, learnt.known);
        self.is_iterative = learnt.is_iterative;
    }
}
