//! Edges in the order of what a flip gains, and edges that wait.

use crate::mesh::Edge;
use std::cmp::Reverse;
use std::collections::{BinaryHeap, HashMap};

/// Both ends of an edge, the smaller number first.
pub(super) type Key = (u32, u32);

/// What an edge waits for that is only queued again when its own reduction changes.
pub(super) const NEVER: Key = (u32::MAX, u32::MAX);

/// An edge that may gain from a flip, as numbers in the order of which the greatest comes first:
/// that of the greatest reduction, and of equal ones the edge with the smallest (min, max) of its
/// ends.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
struct Candidate {
    /// Of the reduction, which is positive: such numbers are in the order of their bits.
    bits: u64,
    /// The key as one number, the smallest last.
    ends: Reverse<u64>,
    edge: Edge,
    version: u32,
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

    /// Puts in an edge that is in neither place, with what it gains.
    pub(super) fn push(&mut self, edge: Edge, reduction: f64, key: Key) {
        debug_assert!(reduction > 0.0);
        let version = self.versions[edge.index()];
        self.heap.push(Candidate {
            bits: reduction.to_bits(),
            ends: Reverse(u64::from(key.0) << 32 | u64::from(key.1)),
            edge,
            version,
        });
    }

    /// Takes out the edge that gains most.
    pub(super) fn pop(&mut self) -> Option<(Edge, f64)> {
        while let Some(c) = self.heap.pop() {
            if self.versions[c.edge.index()] == c.version {
                return Some((c.edge, f64::from_bits(c.bits)));
            }
        }
        None
    }

    /// Takes an edge out of either place; what it waited for, if it did.
    pub(super) fn remove(&mut self, edge: Edge) -> Option<Key> {
        self.versions[edge.index()] += 1;
        if self.waits.is_empty() {
            return None;
        }
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
        if self.waiting.is_empty() {
            return Vec::new();
        }
        self.waiting.get(&key).cloned().unwrap_or_default()
    }
}
