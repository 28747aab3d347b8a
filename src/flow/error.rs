//! Why a flow cannot start or cannot go on.

use super::option::{Allowed, OptionError};
use crate::interrupt::Interrupted;
use crate::linalg::LinalgError;
use crate::message::messages;

messages! {
    /// Refusals and failures of a flow. The positions are those before the failed step.
    #[derive(Clone, Debug, PartialEq)]
    pub enum FlowError as "flow" {
        /// The method is defined on triangles only.
        NotTriangular {
            /// The first such face.
            face: u32,
            /// Its degree.
            corners: usize,
        },
        /// Two vertices joined by an edge lie at the same point.
        ZeroLengthEdge {
            /// One end.
            a: u32,
            /// The other end.
            b: u32,
            /// How many more.
            others: usize,
        },
        /// Every vertex is held.
        NothingFree,
        /// A selection names a vertex that does not exist.
        SelectionOutOfRange {
            /// The index.
            vertex: u32,
            /// How many vertices there are.
            vertices: usize,
        },
        /// An option has a value it cannot have, by itself or with the others.
        Option(error: OptionError),
        /// The method is for closed surfaces.
        NotClosed {
            /// How many loops there are.
            loops: usize,
        },
        /// The method needs an inside and an outside.
        NotOriented,
        /// The method takes triangles, or quadrilaterals, but not both.
        MixedFaces,
        /// The scheme is for small meshes.
        TooLarge {
            /// How many there are.
            vertices: usize,
            /// How many there may be.
            limit: usize,
        },
        /// The neighbours of a vertex do not determine a quadratic surface.
        Unfit {
            /// The vertex.
            vertex: u32,
        },
        /// The solution of the linear system does not satisfy it.
        Inaccurate {
            /// Norm of what is left of the right-hand side, over its norm.
            residual: f64,
        },
        /// The energy or its gradient is not a number.
        NonFiniteEnergy {
            /// The step that was to be taken.
            step: usize,
        },
        /// The linear system could not be solved.
        Linear(reason: LinalgError),
    }
}

impl From<Interrupted> for FlowError {
    fn from(interrupted: Interrupted) -> Self {
        LinalgError::from(interrupted).into()
    }
}

impl FlowError {
    /// An option that cannot be so together with the others or with the mesh; `allowed` tells
    /// what it may be then.
    pub(super) fn option(name: &'static str, value: impl ToString, allowed: Allowed) -> Self {
        Self::Option(OptionError::BadOption {
            name,
            value: value.to_string(),
            allowed,
        })
    }

    /// The elements at fault, for highlighting.
    pub fn detail(&self) -> Vec<(&'static str, Vec<u32>)> {
        match self {
            Self::NotTriangular { face, .. } => vec![("faces", vec![*face])],
            Self::ZeroLengthEdge { a, b, .. } => vec![("vertices", vec![*a, *b])],
            Self::SelectionOutOfRange { vertex, .. } | Self::Unfit { vertex } => {
                vec![("vertices", vec![*vertex])]
            }
            _ => Vec::new(),
        }
    }
}
