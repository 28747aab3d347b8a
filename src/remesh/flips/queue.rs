//! Edges in the order of what a flip gains, and edges that wait.

use crate::mesh::Edge;
use std::cmp::{Ordering, Reverse};
use std::collections::{BinaryHeap, HashMap};

/// Both ends of an edge, the smaller number first.
pub(super) type Key = (u32, u32);

/// What an edge waits for that is only queued again when its own reduction changes.
pub(super) const NEVER: Key = (u32::MAX, u32::MAX);

/// An edge that may gain from a flip. The greatest reduction comes first; of equal ones the
/// edge with the smallest (min, max) of its ends.
struct Candidate {
    reduction: f64,
    key: Key,
    edge: Edge,
    version: u32,
}

impl Candidate {
    fn rank(&self, other: &Self) -> Ordering {
        let by_gain = self.reduction.total_cmp(&other.reduction);
        by_gain.then_with(|| Reverse(self.key).cmp(&Reverse(other.key)))
    }
}

impl PartialEq for Candidate {
    fn eq(&self, other: &Self) -> bool {
        self.rank(other) == Ordering::Equal
    }
}

impl Eq for Candidate {}

impl PartialOrd for Candidate {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Candidate {
    fn cmp(&self, other: &Self) -> Ordering {
        self.rank(other)
    }
}

/// A queue with lazy deletion: every edge has a version, raised when its reduction changes,
/// and entries of an older version are passed over. An edge is in the queue, or waits for
/// another edge to go, or neither.
pub(super) struct Queue {
    heap: BinaryHeap<Candidate>,
    versions: Vec<u32>,
    waits: HashMap<Edge, Key>,
    waiting: HashMap<Key, Vec<Edge>>,
}

impl Queue {
    pub(super) fn new(n_edges: usize) -> Self {
        Self {
            heap: BinaryHeap::new(),
            versions: vec![0; n_edges],
            waits: HashMap::new(),
            waiting: HashMap::new(),
        }
    }

    /// Puts in an edge that is in neither place.
    pub(super) fn push(&mut self, edge: Edge, reduction: f64, key: Key) {
        let version = self.versions[edge.index()];
        self.heap.push(Candidate {
            reduction,
            key,
            edge,
            version,
        });
    }

    /// Takes out the edge that gains most.
    pub(super) fn pop(&mut self) -> Option<(Edge, f64)> {
        while let Some(c) = self.heap.pop() {
            if self.versions[c.edge.index()] == c.version {
                return Some((c.edge, c.reduction));
            }
        }
        None
    }

    /// Takes an edge out of either place; what it waited for, if it did.
    pub(super) fn remove(&mut self, edge: Edge) -> Option<Key> {
        self.versions[edge.index()] += 1;
        let key = self.waits.remove(&edge)?;
        if let Some(others) = self.waiting.get_mut(&key) {
            others.retain(|e| *e != edge);
            if others.is_empty() {
                self.waiting.remove(&key);
            }
        }
        Some(key)
    }

    /// Lets an edge that is in neither place wait.
    pub(super) fn park(&mut self, edge: Edge, until: Key) {
        self.waits.insert(edge, until);
        if until != NEVER {
            self.waiting.entry(until).or_default().push(edge);
        }
    }

    /// Edges that wait for this one to go.
    pub(super) fn waiting_for(&self, key: Key) -> Vec<Edge> {
        self.waiting.get(&key).cloned().unwrap_or_default()
    }
}
