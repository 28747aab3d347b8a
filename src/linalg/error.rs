//! What can go wrong in a linear solve.

use faer::sparse::FaerError;
use thiserror::Error;

/// A linear system that could not be set up or factored.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum LinalgError {
    /// Elimination met a pivot that is exactly zero or overflows.
    #[error("the matrix is singular: the pivot of row {row} is zero")]
    ZeroPivot {
        /// Row and column of the pivot in the caller's numbering.
        row: usize,
    },
    /// A matrix entry is infinite or not a number.
    #[error("the matrix has an entry that is not finite in column {column}")]
    NonFiniteEntry {
        /// Column of the first such entry of the lower triangle.
        column: usize,
    },
    /// A right-hand side is infinite or not a number.
    #[error("the right-hand side is not finite at vertex {row}")]
    NonFiniteRightHandSide {
        /// Row of the first such vector.
        row: usize,
    },
    /// The factor does not fit into memory.
    #[error("the factor of a matrix of {n} rows does not fit into memory")]
    OutOfMemory {
        /// Number of rows.
        n: usize,
    },
    /// The factor has more than 2³¹ − 1 entries.
    #[error("the factor of a matrix of {n} rows has too many entries to be indexed")]
    IndexOverflow {
        /// Number of rows.
        n: usize,
    },
}

impl LinalgError {
    /// Name of the variant.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::ZeroPivot { .. } => "ZeroPivot",
            Self::NonFiniteEntry { .. } => "NonFiniteEntry",
            Self::NonFiniteRightHandSide { .. } => "NonFiniteRightHandSide",
            Self::OutOfMemory { .. } => "OutOfMemory",
            Self::IndexOverflow { .. } => "IndexOverflow",
        }
    }

    /// What the user can do about it.
    pub fn hint(&self) -> String {
        match self {
            Self::ZeroPivot { .. } => "Take a smaller step.",
            Self::NonFiniteEntry { .. } | Self::NonFiniteRightHandSide { .. } => {
                "A triangle may have collapsed: take a smaller step or repair the mesh."
            }
            Self::OutOfMemory { .. } | Self::IndexOverflow { .. } => "Use a coarser mesh.",
        }
        .to_owned()
    }

    /// The error of `faer` for a matrix of `n` rows.
    pub(super) fn from_faer(error: FaerError, n: usize) -> Self {
        match error {
            FaerError::IndexOverflow => Self::IndexOverflow { n },
            _ => Self::OutOfMemory { n },
        }
    }
}
