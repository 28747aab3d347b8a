//! Why a flow cannot start or cannot go on.

use super::option::OptionError;
use crate::linalg::LinalgError;
use crate::mesh::error::and_others;
use thiserror::Error;

/// Refusals and failures of a flow. The positions are those before the failed step.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum FlowError {
    /// The method is defined on triangles only.
    #[error("face {face} has {corners} corners; this flow works on triangles")]
    NotTriangular {
        /// The first such face.
        face: u32,
        /// Its degree.
        corners: usize,
    },
    /// Two vertices joined by an edge lie at the same point.
    #[error("the edge between vertices {a} and {b} has no length{}", and_others(*others))]
    ZeroLengthEdge {
        /// One end.
        a: u32,
        /// The other end.
        b: u32,
        /// How many more.
        others: usize,
    },
    /// Every vertex is held.
    #[error("no vertex is free to move")]
    NothingFree,
    /// A selection names a vertex that does not exist.
    #[error("the selection names vertex {vertex}, but there are only {vertices} vertices")]
    SelectionOutOfRange {
        /// The index.
        vertex: u32,
        /// How many vertices there are.
        vertices: usize,
    },
    /// An option has a value it cannot have, by itself or with the others.
    #[error(transparent)]
    Option(#[from] OptionError),
    /// The method is for closed surfaces.
    #[error("the surface has {loops} boundary loop{}; this flow is for closed surfaces", if *loops == 1 { "" } else { "s" })]
    NotClosed {
        /// How many loops there are.
        loops: usize,
    },
    /// The method needs an inside and an outside.
    #[error("the surface is one-sided; this flow is for orientable surfaces")]
    NotOriented,
    /// The method takes triangles, or quadrilaterals, but not both.
    #[error("the mesh mixes faces of different degree")]
    MixedFaces,
    /// The scheme is for small meshes.
    #[error("the mesh has {vertices} vertices; the paper's scheme takes {limit}")]
    TooLarge {
        /// How many there are.
        vertices: usize,
        /// How many there may be.
        limit: usize,
    },
    /// The neighbours of a vertex do not determine a quadratic surface.
    #[error("the surface cannot be fitted at vertex {vertex}")]
    Unfit {
        /// The vertex.
        vertex: u32,
    },
    /// The solution of the linear system does not satisfy it.
    #[error("the linear system was solved to a residual of {residual:.1e} only")]
    Inaccurate {
        /// Norm of what is left of the right-hand side, over its norm.
        residual: f64,
    },
    /// The energy or its gradient is not a number.
    #[error("the energy is not a finite number at step {step}")]
    NonFiniteEnergy {
        /// The step that was to be taken.
        step: usize,
    },
    /// The linear system could not be solved.
    #[error("the linear system could not be solved: {0}")]
    Linear(#[from] LinalgError),
}

impl FlowError {
    /// An option that cannot be so together with the others or with the mesh; `allowed` tells
    /// what it may be then.
    pub(super) fn option(name: &'static str, value: impl ToString, allowed: &str) -> Self {
        Self::Option(OptionError::BadValue {
            name,
            value: value.to_string(),
            allowed: allowed.into(),
        })
    }

    /// The variant's name.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::NotTriangular { .. } => "NotTriangular",
            Self::ZeroLengthEdge { .. } => "ZeroLengthEdge",
            Self::NothingFree => "NothingFree",
            Self::SelectionOutOfRange { .. } => "SelectionOutOfRange",
            Self::Option(error) => error.kind(),
            Self::NotClosed { .. } => "NotClosed",
            Self::NotOriented => "NotOriented",
            Self::MixedFaces => "MixedFaces",
            Self::TooLarge { .. } => "TooLarge",
            Self::Unfit { .. } => "Unfit",
            Self::Inaccurate { .. } => "Inaccurate",
            Self::NonFiniteEnergy { .. } => "NonFiniteEnergy",
            Self::Linear(error) => error.kind(),
        }
    }

    /// What the user can do.
    pub fn hint(&self) -> String {
        match self {
            Self::NotTriangular { .. } => "Triangulate the mesh first.".into(),
            Self::ZeroLengthEdge { .. } => {
                "Merge the two vertices in a mesh editor (merge by distance), then load again."
                    .into()
            }
            Self::NothingFree => {
                "With a clamped boundary the vertices within one edge of it are held too: choose a \
                 fixed or free boundary, a finer mesh, or a larger selection."
                    .into()
            }
            Self::SelectionOutOfRange { .. } => {
                "Vertex indices count from 0 in the order of the file.".into()
            }
            Self::Option(error) => error.hint(),
            Self::NotClosed { .. } => {
                "Close its holes in a mesh editor and open it again, or choose the circle-angle \
                 Willmore flow, which takes boundaries."
                    .into()
            }
            Self::NotOriented => {
                "Choose the circle-angle Willmore flow, which needs no orientation.".into()
            }
            Self::TooLarge { .. } => {
                "Choose the recommended scheme, which tends to the same flow, or a coarser mesh."
                    .into()
            }
            Self::MixedFaces => "Triangulate the mesh first.".into(),
            Self::Unfit { .. } => {
                "It has too few neighbours, some of them coincide, or faces around it have \
                 collapsed or are folded: repair the mesh there, or hold the vertices around it."
                    .into()
            }
            Self::Inaccurate { .. } => {
                "Choose a smaller step size, a coarser mesh or a flow of lower order.".into()
            }
            Self::NonFiniteEnergy { .. } => {
                "Go back a step, choose a smaller step size or the recommended scheme, and look \
                 for a folded or collapsed triangle."
                    .into()
            }
            Self::Linear(error) => error.hint(),
        }
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
