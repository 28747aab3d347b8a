//! Why a mesh at rest is not regularised.

use super::likeness::{ANGLE, BOX, DISTANCE, Property, VOLUME};
use crate::linalg::LinalgError;
use thiserror::Error;

/// A regularisation that would not keep the shape, or could not be computed. The mesh is
/// as it was.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
pub enum RegulariseError {
    /// There is nothing that may move.
    #[error("all {vertices} vertices lie on creases, which a regularisation keeps")]
    OnlyCreases {
        /// How many there are.
        vertices: usize,
    },
    /// Vertices would leave the surface, or the surface its vertices.
    #[error("any pass would move the surface by more than {percent} % of its size")]
    Distance {
        /// The bound.
        percent: f64,
    },
    /// The surface would shrink or swell.
    #[error("any pass would change the volume by more than {percent} %")]
    Volume {
        /// The bound.
        percent: f64,
    },
    /// The surface would lose its outermost points.
    #[error("any pass would change the bounding box by more than {percent} %")]
    Box {
        /// The bound.
        percent: f64,
    },
    /// The mesh would be worse.
    #[error("any pass would make the smallest angle smaller, and smaller than {degrees}°")]
    Angle {
        /// The bound.
        degrees: f64,
    },
    /// The linear system could not be solved.
    #[error("the linear system could not be solved: {0}")]
    Linear(#[from] LinalgError),
}

impl RegulariseError {
    /// The variant's name.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::OnlyCreases { .. } => "OnlyCreases",
            Self::Distance { .. } => "DistanceBound",
            Self::Volume { .. } => "VolumeBound",
            Self::Box { .. } => "BoxBound",
            Self::Angle { .. } => "AngleBound",
            Self::Linear(error) => error.kind(),
        }
    }

    /// What the user can do.
    pub fn hint(&self) -> String {
        match self {
            Self::Linear(error) => error.hint(),
            _ => "Refine the mesh first: new vertices inside its faces are free to slide.".into(),
        }
    }
}

impl From<Property> for RegulariseError {
    fn from(lost: Property) -> Self {
        match lost {
            Property::Distance => Self::Distance {
                percent: 100.0 * DISTANCE,
            },
            Property::Volume => Self::Volume {
                percent: 100.0 * VOLUME,
            },
            Property::Box => Self::Box {
                percent: 100.0 * BOX,
            },
            Property::Angle => Self::Angle { degrees: ANGLE },
        }
    }
}
