//! Why a mesh at rest is not regularised.

use super::likeness::{ANGLE, BOX, DISTANCE, Property, VOLUME};
use crate::linalg::LinalgError;
use crate::message::messages;

messages! {
    /// A regularisation that would not keep the shape, or could not be computed. The mesh is
    /// as it was.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub enum RegulariseError as "regularise" {
        /// There is nothing that may move.
        OnlyCreases {
            /// How many there are.
            vertices: usize,
        },
        /// Vertices would leave the surface, or the surface its vertices.
        DistanceBound {
            /// The bound.
            percent: f64,
        },
        /// The surface would shrink or swell.
        VolumeBound {
            /// The bound.
            percent: f64,
        },
        /// The surface would lose its outermost points.
        BoxBound {
            /// The bound.
            percent: f64,
        },
        /// The mesh would be worse.
        AngleBound {
            /// The bound.
            degrees: f64,
        },
        /// The linear system could not be solved.
        Linear(reason: LinalgError),
    }
}

impl From<Property> for RegulariseError {
    fn from(lost: Property) -> Self {
        match lost {
            Property::Distance => Self::DistanceBound {
                percent: 100.0 * DISTANCE,
            },
            Property::Volume => Self::VolumeBound {
                percent: 100.0 * VOLUME,
            },
            Property::Box => Self::BoxBound {
                percent: 100.0 * BOX,
            },
            Property::Angle => Self::AngleBound { degrees: ANGLE },
        }
    }
}
