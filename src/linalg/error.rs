//! What can go wrong in a linear solve.

use crate::interrupt::Interrupted;
use crate::message::messages;
use faer::sparse::FaerError;

messages! {
    /// A linear system that could not be set up or factored.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum LinalgError as "linear" {
        /// Elimination met a pivot that is exactly zero or overflows.
        ZeroPivot {
            /// Row and column of the pivot in the caller's numbering.
            row: usize,
        },
        /// A matrix entry is infinite or not a number.
        NonFiniteEntry {
            /// Column of the first such entry of the lower triangle.
            column: usize,
        },
        /// A right-hand side is infinite or not a number.
        NonFiniteRightHandSide {
            /// Row of the first such vector.
            row: usize,
        },
        /// The factor does not fit into memory.
        OutOfMemory {
            /// Number of rows.
            n: usize,
        },
        /// The factor has more than 2³¹ − 1 entries.
        IndexOverflow {
            /// Number of rows.
            n: usize,
        },
        /// The work was [given up](crate::interrupt).
        Interrupted,
    }
}

impl From<Interrupted> for LinalgError {
    fn from(_: Interrupted) -> Self {
        Self::Interrupted
    }
}

impl LinalgError {
    /// The error of `faer` for a matrix of `n` rows.
    pub(super) fn from_faer(error: FaerError, n: usize) -> Self {
        match error {
            FaerError::IndexOverflow => Self::IndexOverflow { n },
            _ => Self::OutOfMemory { n },
        }
    }
}
