//! What can be wrong with a polygon soup that no repair is safe for, and what was repaired.

use crate::message::messages;

messages! {
    /// Why a soup is not a surface. Vertices and faces are counted from 0, in the
    /// order of the file.
    #[derive(Clone, Debug, PartialEq)]
    pub enum MeshError as "mesh" {
        /// A face refers to a vertex that does not exist.
        VertexOutOfRange {
            /// The face.
            face: usize,
            /// The index it holds.
            vertex: u32,
            /// How many vertices there are.
            vertices: usize,
        },
        /// A coordinate is NaN or infinite.
        NonFiniteVertex {
            /// The vertex.
            vertex: usize,
        },
        /// An edge with three or more faces.
        NonManifoldEdge {
            /// One end.
            a: u32,
            /// The other end.
            b: u32,
            /// The faces that share it.
            faces: Vec<u32>,
            /// How many more such edges there are.
            others: usize,
            /// The number of the first vertex and of the first face: 0, or 1 as a file counts.
            first: u32,
        },
        /// Nothing is left after degenerate and duplicate faces were dropped.
        NoFaces,
        /// More elements than 32-bit indices can name.
        TooLarge {
            /// The number of corners.
            count: usize,
        },
    }
}

impl MeshError {
    /// The same with elements counted from `first`, as a file does that it is of.
    #[must_use]
    pub fn counted_from(mut self, to: u32) -> Self {
        if let Self::NonManifoldEdge {
            a, b, faces, first, ..
        } = &mut self
        {
            let from = std::mem::replace(first, to);
            for n in [a, b].into_iter().chain(faces) {
                *n = *n - from + to;
            }
        }
        self
    }

    /// The elements at fault, for highlighting.
    pub fn detail(&self) -> Vec<(&'static str, Vec<u32>)> {
        match self {
            Self::VertexOutOfRange { face, vertex, .. } => {
                vec![("faces", vec![*face as u32]), ("vertices", vec![*vertex])]
            }
            Self::NonFiniteVertex { vertex } => vec![("vertices", vec![*vertex as u32])],
            Self::NonManifoldEdge {
                a, b, faces, first, ..
            } => {
                let faces = faces.iter().map(|f| f - first).collect();
                vec![("vertices", vec![a - first, b - first]), ("faces", faces)]
            }
            Self::NoFaces | Self::TooLarge { .. } => Vec::new(),
        }
    }
}

messages! {
    /// What was changed to make a surface of a soup.
    #[derive(Clone, Debug, PartialEq)]
    pub enum Repair as "repair" {
        /// Faces with a corner repeated were dropped.
        DegenerateFaces {
            /// How many.
            count: usize,
            /// The first.
            face: usize,
            /// The number of the first face: 0, or 1 as a file counts.
            first: u32,
        },
        /// Faces that pass a vertex twice, as where a bridge leads to a hole in them, were cut into
        /// triangles.
        BridgedFaces {
            /// How many.
            count: usize,
        },
        /// Sides of faces that run out to a vertex and back were cut off.
        SpikedFaces {
            /// How many faces had some.
            count: usize,
        },
        /// Faces on the vertices of an earlier one were dropped.
        DuplicateFaces {
            /// How many.
            count: usize,
        },
        /// Vertices where several sheets touch were split into one a sheet.
        SplitVertices {
            /// How many.
            count: usize,
            /// Which.
            vertices: Vec<u32>,
            /// The number of the first vertex: 0, or 1 as a file counts.
            first: u32,
        },
        /// Faces in pieces without any area were dropped.
        FlatPieces {
            /// How many.
            count: usize,
        },
        /// Vertices of no face were dropped.
        UnusedVertices {
            /// How many.
            count: usize,
        },
        /// Components have no consistent orientation; nothing was done about it.
        OneSided {
            /// How many.
            count: usize,
        },
        /// Faces were turned to agree with their neighbours.
        TurnedFaces {
            /// How many.
            count: usize,
        },
        /// All faces were turned, as the volume was negative.
        InsideOut,
        /// Closed parts of negative volume were turned.
        TurnedParts {
            /// How many.
            count: usize,
        },
    }
}

impl Repair {
    /// The same with elements counted from `to`, as a file does that it is of.
    #[must_use]
    pub fn counted_from(mut self, to: u32) -> Self {
        match &mut self {
            Self::SplitVertices {
                vertices, first, ..
            } => {
                let from = std::mem::replace(first, to);
                for v in vertices {
                    *v = *v - from + to;
                }
            }
            Self::DegenerateFaces { face, first, .. } => {
                let from = std::mem::replace(first, to);
                *face = *face - from as usize + to as usize;
            }
            _ => {}
        }
        self
    }
}
