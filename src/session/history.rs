//! Earlier states, bounded in number and memory.

use super::readings::State;
use crate::flow::Pace;
use glam::DVec3;
use std::collections::VecDeque;

/// Bytes at most: a wasm heap of 4 GiB also holds the factor.
const MAX_BYTES: usize = 192 << 20;

/// A state to go back to.
pub(super) struct Moment {
    /// Positions, where the flow moves any.
    pub(super) x: Option<Vec<DVec3>>,
    pub(super) pace: Pace,
    pub(super) state: State,
    /// How many reports there were.
    pub(super) n_reports: usize,
}

/// A stack that forgets its oldest entries.
#[derive(Default)]
pub(super) struct History {
    moments: VecDeque<Moment>,
}

impl History {
    pub(super) fn push(&mut self, moment: Moment) {
        let positions = moment.x.as_deref().unwrap_or_default();
        let bytes = size_of::<Moment>() + size_of_val(positions);
        self.moments.push_back(moment);
        // At least one step back is always kept.
        let most = (MAX_BYTES / bytes).max(1);
        while self.moments.len() > most {
            self.moments.pop_front();
        }
    }

    pub(super) fn pop(&mut self) -> Option<Moment> {
        self.moments.pop_back()
    }

    /// The state before the present one.
    pub(super) fn last(&self) -> Option<&Moment> {
        self.moments.back()
    }

    pub(super) fn is_empty(&self) -> bool {
        self.moments.is_empty()
    }
}
