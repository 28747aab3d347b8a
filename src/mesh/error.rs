//! What can be wrong with a polygon soup that no repair is safe for.

use thiserror::Error;

/// Why a soup is not a surface. Vertices and faces are counted from 0, in the
/// order of the file.
#[derive(Clone, Debug, Error, PartialEq)]
pub enum MeshError {
    /// A face refers to a vertex that does not exist.
    #[error("face {face} uses vertex {vertex}, but there are only {vertices} vertices")]
    VertexOutOfRange {
        /// The face.
        face: usize,
        /// The index it holds.
        vertex: u32,
        /// How many vertices there are.
        vertices: usize,
    },
    /// A coordinate is NaN or infinite.
    #[error("vertex {vertex} has a coordinate that is not a finite number")]
    NonFiniteVertex {
        /// The vertex.
        vertex: usize,
    },
    /// An edge with three or more faces.
    #[error(
        "the edge between vertices {a} and {b} has {} faces ({}){}",
        faces.len(),
        list(faces),
        and_others(*others)
    )]
    NonManifoldEdge {
        /// One end.
        a: u32,
        /// The other end.
        b: u32,
        /// The faces that share it.
        faces: Vec<u32>,
        /// How many more such edges there are.
        others: usize,
    },
    /// Nothing is left after degenerate and duplicate faces were dropped.
    #[error("there is no face with three different corners and an area")]
    NoFaces,
    /// More elements than 32-bit indices can name.
    #[error("{count} face corners are more than 32-bit indices can name")]
    TooLarge {
        /// The number of corners.
        count: usize,
    },
}

/// What to add about further elements of the same kind.
pub(crate) fn and_others(others: usize) -> String {
    match others {
        0 => String::new(),
        1 => "; one other edge is like it".into(),
        n => format!("; {n} other edges are like it"),
    }
}

fn list(faces: &[u32]) -> String {
    let mut text: Vec<String> = faces.iter().take(6).map(u32::to_string).collect();
    if faces.len() > 6 {
        text.push("…".into());
    }
    text.join(", ")
}

impl MeshError {
    /// The variant's name.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::VertexOutOfRange { .. } => "VertexOutOfRange",
            Self::NonFiniteVertex { .. } => "NonFiniteVertex",
            Self::NonManifoldEdge { .. } => "NonManifoldEdge",
            Self::NoFaces => "NoFaces",
            Self::TooLarge { .. } => "TooLarge",
        }
    }

    /// What the user can do.
    pub fn hint(&self) -> String {
        match self {
            Self::VertexOutOfRange { .. } => {
                "The file is damaged or was cut off: export it again from the program it came from."
            }
            Self::NonFiniteVertex { .. } => {
                "Remove the vertex, or give it a position, in a mesh editor."
            }
            Self::NonManifoldEdge { .. } => {
                "A surface has at most two faces at an edge. In a mesh editor, select non-manifold \
                 edges and delete the inner faces, or split the surface there."
            }
            Self::NoFaces => "Check that the file holds a surface and not only points or lines.",
            Self::TooLarge { .. } => {
                "Simplify the mesh first; about a million faces are practical."
            }
        }
        .to_owned()
    }

    /// The elements at fault, for highlighting.
    pub fn detail(&self) -> Vec<(&'static str, Vec<u32>)> {
        match self {
            Self::VertexOutOfRange { face, vertex, .. } => {
                vec![("faces", vec![*face as u32]), ("vertices", vec![*vertex])]
            }
            Self::NonFiniteVertex { vertex } => vec![("vertices", vec![*vertex as u32])],
            Self::NonManifoldEdge { a, b, faces, .. } => {
                vec![("vertices", vec![*a, *b]), ("faces", faces.clone())]
            }
            Self::NoFaces | Self::TooLarge { .. } => Vec::new(),
        }
    }
}
