//! Why holes cannot be filled, or loops not be connected, and what to say of those that are.

use crate::linalg::LinalgError;
use crate::mesh::MeshError;
use crate::message::messages;

messages! {
    /// A fill that was refused; the mesh is as it was. Loops, vertices and faces count from 0.
    #[derive(Clone, Debug, PartialEq)]
    pub enum FillError as "fill" {
        /// The mesh is closed.
        NoLoops,
        /// A loop that does not exist.
        LoopOutOfRange {
            /// The number asked for.
            index: usize,
            /// How many there are.
            loops: usize,
        },
        /// Two vertices of a loop lie in the same place: filled, they would leave faces without
        /// area between them.
        TouchingLoop {
            /// The loop.
            index: usize,
            /// A vertex.
            a: u32,
            /// Another.
            b: u32,
        },
        /// All vertices of a loop lie on a line, as where a vertex lies on an edge that it does not
        /// end: filled, it would be faces without area.
        StraightLoop {
            /// The loop.
            index: usize,
        },
        /// No loop is so small that it is a hole rather than the outer rim of a sheet.
        NoSmallLoops {
            /// How many loops there are.
            loops: usize,
        },
        /// The patch of a loop would fall onto faces that are there.
        NoRoom {
            /// The loop.
            index: usize,
        },
        /// A one-sided surface: a patch would have no side to agree with.
        NotOrientable,
        /// Connecting takes two loops.
        TooFewLoops {
            /// How many were asked for.
            loops: usize,
        },
        /// A loop that is not seen from outside: its vertices and edges do not lie on the convex
        /// hull of all loops.
        HiddenLoop {
            /// The loop.
            index: usize,
            /// Where.
            vertex: u32,
        },
        /// The connecting surface needs an edge that the mesh has already.
        LoopsTooClose {
            /// One end.
            a: u32,
            /// The other end.
            b: u32,
        },
        /// The caller asked to stop.
        Cancelled,
        /// The filled mesh is not a surface.
        Mesh(reason: MeshError),
        /// The linear system cannot be solved.
        Linear(reason: LinalgError),
    }
}

impl FillError {
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

messages! {
    /// What is to be known of a fill.
    #[derive(Clone, Debug, PartialEq)]
    pub enum FillNotice as "fill-notice" {
        /// A loop was left open.
        LeftOpen {
            /// Why.
            reason: FillError,
        },
        /// The hole is so large that its shape is a guess.
        LargeHole {
            /// The loops of the patch.
            loops: Vec<usize>,
            /// Total curvature of the patch, in hemispheres.
            hemispheres: f64,
        },
        /// The patch does not continue the curvature of the surface around it.
        LowOrder {
            /// The loops of the patch.
            loops: Vec<usize>,
            /// What it continues: 2 tangent planes, 1 positions; 0 a membrane.
            order: usize,
            /// `near-boundary`, `size`, `folds`, `rough` or `side`.
            cause: &'static str,
            /// New vertices of the patch.
            vertices: usize,
        },
        /// There would have been more new vertices than there may be.
        Coarser {
            /// How many the loops ask for.
            vertices: f64,
            /// How many there may be.
            most: usize,
            /// How much longer edges are for that.
            times: f64,
        },
    }
}
