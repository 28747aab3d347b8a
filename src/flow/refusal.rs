//! Why a trial step was refused, and where.

use crate::message::messages;

messages! {
    /// What is wrong with a trial step.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Cause as "cause" {
        /// What the step has to lower would rise, or fall by too little (Armijo).
        Rise,
        /// What is monitored would fall, but the reading that people see would jump up.
        ReadingJump,
        /// The energy would fall below what a theorem leaves to any smooth surface of this
        /// topology: a handle would collapse between the vertices.
        Bound,
        /// The neighbours of a vertex would no longer determine a quadratic surface.
        Unfit,
        /// Faces would fold over.
        Fold,
        /// A vertex would move by more than half an edge.
        TooFar,
        /// A face would turn by more than 60°.
        Turn,
        /// A face would become a sliver.
        Sliver,
        /// Area and volume cannot both be what they should be.
        Constraints,
        /// The energy there is not a number.
        NotFinite,
        /// The paper's implicit step has no solution that Newton's method finds.
        Newton,
    }
}

/// A trial step that was refused, with the element that shows it most.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Refusal {
    /// What is wrong.
    pub cause: Cause,
    /// The vertex that would have moved most, in lengths of its edges, or that cannot be
    /// fitted.
    pub vertex: u32,
    /// The face that would have turned most or become a sliver.
    pub face: Option<u32>,
    /// The share of the move that might do, where that is known.
    pub ratio: Option<f64>,
}

impl Refusal {
    /// For a cause, without the elements, which the driver knows better.
    pub fn of(cause: Cause) -> Self {
        Self {
            cause,
            vertex: 0,
            face: None,
            ratio: None,
        }
    }

    /// Whether the mesh would suffer, or a theorem's bound be passed.
    pub fn is_of_mesh(&self) -> bool {
        matches!(
            self.cause,
            Cause::Bound | Cause::Sliver | Cause::Turn | Cause::Unfit
        )
    }

    /// The same about a vertex.
    pub fn at(cause: Cause, vertex: u32) -> Self {
        Self {
            vertex,
            ..Self::of(cause)
        }
    }
}

/// The vertex that moves most from `x` to `y` in units of `reach`, and by how much; what is
/// not a number moves most of all.
pub fn farthest(x: &[glam::DVec3], y: &[glam::DVec3], reach: impl Fn(usize) -> f64) -> (u32, f64) {
    let moves = x.iter().zip(y).enumerate();
    moves
        .map(|(v, (x, y))| (v as u32, y.distance(*x) / reach(v)))
        .fold((0, 0.0), |most: (u32, f64), one| {
            if one.1 > most.1 || one.1.is_nan() {
                one
            } else {
                most
            }
        })
}
