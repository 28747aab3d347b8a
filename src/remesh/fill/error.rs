//! Why holes cannot be filled, or loops not be connected.

use crate::linalg::LinalgError;
use crate::mesh::MeshError;
use thiserror::Error;

/// A fill that was refused; the mesh is as it was. Loops, vertices and faces count from 0.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum FillError {
    /// The mesh is closed.
    #[error("the mesh has no boundary loop")]
    NoLoops,
    /// A loop that does not exist.
    #[error("there is no boundary loop {index}; the mesh has {loops}, counted from 0")]
    LoopOutOfRange {
        /// The number asked for.
        index: usize,
        /// How many there are.
        loops: usize,
    },
    /// Two vertices of a loop lie in the same place: filled, they would leave faces without
    /// area between them.
    #[error("boundary loop {index} touches itself: vertices {a} and {b} lie in the same place")]
    TouchingLoop {
        /// The loop.
        index: usize,
        /// A vertex.
        a: u32,
        /// Another.
        b: u32,
    },
    /// A one-sided surface: a patch would have no side to agree with.
    #[error("the surface has no consistent orientation")]
    NotOrientable,
    /// Connecting takes two loops.
    #[error("{loops} boundary loops cannot be connected")]
    TooFewLoops {
        /// How many were asked for.
        loops: usize,
    },
    /// A loop that is not seen from outside: its vertices and edges do not lie on the convex
    /// hull of all loops.
    #[error(
        "boundary loop {index} does not lie on the convex hull of the loops to be connected, at \
         vertex {vertex}"
    )]
    HiddenLoop {
        /// The loop.
        index: usize,
        /// Where.
        vertex: u32,
    },
    /// The connecting surface needs an edge that the mesh has already.
    #[error("vertices {a} and {b} of two loops are joined by an edge already")]
    LoopsTooClose {
        /// One end.
        a: u32,
        /// The other end.
        b: u32,
    },
    /// The caller asked to stop.
    #[error("filling was cancelled")]
    Cancelled,
    /// The filled mesh is not a surface.
    #[error("the filled mesh is not a surface: {0}")]
    Mesh(#[from] MeshError),
    /// The linear system cannot be solved.
    #[error(transparent)]
    Linear(#[from] LinalgError),
}

impl FillError {
    /// Name of the variant.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::NoLoops => "NoLoops",
            Self::LoopOutOfRange { .. } => "LoopOutOfRange",
            Self::TouchingLoop { .. } => "TouchingLoop",
            Self::NotOrientable => "NotOrientable",
            Self::TooFewLoops { .. } => "TooFewLoops",
            Self::HiddenLoop { .. } => "HiddenLoop",
            Self::LoopsTooClose { .. } => "LoopsTooClose",
            Self::Cancelled => "Cancelled",
            Self::Mesh(error) => error.kind(),
            Self::Linear(error) => error.kind(),
        }
    }

    /// What the user can do about it.
    pub fn hint(&self) -> String {
        match self {
            Self::NoLoops => "There is nothing to fill.",
            Self::LoopOutOfRange { .. } => "Ask for all loops, or for one of those there are.",
            Self::TouchingLoop { .. } => {
                "Merge such vertices in a mesh editor (merge by distance), or delete the faces \
                 around them."
            }
            Self::NotOrientable => "A one-sided surface cannot be filled.",
            Self::TooFewLoops { .. } => "Name two loops or more, or fill them one by one.",
            Self::HiddenLoop { .. } => {
                "Move the parts apart or leave the loop out; loops that are round and face each \
                 other can be connected."
            }
            Self::LoopsTooClose { .. } => "Fill the loops one by one.",
            Self::Cancelled => "Start again whenever you like.",
            Self::Mesh(error) => return error.hint(),
            Self::Linear(error) => return error.hint(),
        }
        .to_owned()
    }

    /// The elements at fault, for highlighting.
    pub fn detail(&self) -> Vec<(&'static str, Vec<u32>)> {
        match self {
            Self::TouchingLoop { a, b, .. } | Self::LoopsTooClose { a, b } => {
                vec![("vertices", vec![*a, *b])]
            }
            Self::HiddenLoop { vertex, .. } => vec![("vertices", vec![*vertex])],
            Self::Mesh(error) => error.detail(),
            _ => Vec::new(),
        }
    }
}
