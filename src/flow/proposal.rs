//! What a flow proposes for a step.

use super::Refusal;
use super::rules::Ceiling;
use glam::DVec3;

/// How a move that is refused is made smaller.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Search {
    /// Along its own direction first, which descends; then by a smaller step size.
    Shorten,
    /// By a smaller step size only: the direction need not descend, or its length is not to
    /// be changed.
    Solve,
    /// To a point where the functional has fallen and flattened (weak Wolfe conditions): a
    /// quasi-Newton method has no step size.
    Wolfe,
    /// It is taken as it comes, as the papers take their steps.
    Unseen,
}

/// A move of all vertices.
#[derive(Clone, Debug)]
pub struct Move {
    /// A vector a vertex, zero where it is held.
    pub d: Vec<DVec3>,
    /// ⟨∇F, d⟩, the change of the functional to first order; 0 where that is not known.
    pub slope: f64,
    /// The time that it stands for.
    pub dt: f64,
    /// How it is made smaller.
    pub search: Search,
    /// Whether the step size may grow after it.
    pub grows: bool,
    /// A ceiling of its own for the functional, in place of that of the rules.
    pub ceiling: Option<Ceiling>,
    /// The largest distance a vertex is to move, in mean edge lengths, where that tells rest.
    pub update: Option<f64>,
    /// Whether that is so little that the surface is at rest.
    pub rests: bool,
}

impl Move {
    /// A descending move.
    pub fn new(d: Vec<DVec3>, slope: f64, dt: f64, search: Search) -> Self {
        Self {
            d,
            slope,
            dt,
            search,
            grows: true,
            ceiling: None,
            update: None,
            rests: false,
        }
    }
}

/// What a flow makes of a step size.
#[derive(Clone, Debug)]
pub enum Proposal {
    /// This move.
    Move(Box<Move>),
    /// There is none at this step size.
    Refused(Refusal),
    /// There is none at any.
    Nothing,
}
