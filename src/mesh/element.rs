//! Mesh elements as `u32` newtypes, so that a vertex is never mistaken for an edge.

/// Declares an index newtype over `u32` with a `NONE` value.
macro_rules! element {
    ($(#[$doc:meta])* $name:ident) => {
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
        pub struct $name(pub u32);

        impl $name {
            /// No element: the face of a boundary half-edge.
            pub const NONE: Self = Self(u32::MAX);

            /// The element at position `i` of an array.
            pub fn new(i: usize) -> Self {
                debug_assert!(i < u32::MAX as usize);
                Self(i as u32)
            }

            /// Position in arrays indexed by this kind of element.
            pub fn index(self) -> usize {
                self.0 as usize
            }

            /// Whether this is an element at all.
            pub fn is_some(self) -> bool {
                self != Self::NONE
            }
        }
    };
}

element!(
    /// A vertex.
    Vertex
);
element!(
    /// One side of an edge. The two sides of edge `e` are `2e` and `2e + 1`.
    Halfedge
);
element!(
    /// An undirected edge.
    Edge
);
element!(
    /// A face of any degree.
    Face
);

impl Halfedge {
    /// The other side of the same edge.
    pub fn twin(self) -> Self {
        Self(self.0 ^ 1)
    }

    /// The edge this is a side of.
    pub fn edge(self) -> Edge {
        Edge(self.0 >> 1)
    }
}

impl Edge {
    /// The first of the two sides; never a boundary half-edge.
    pub fn halfedge(self) -> Halfedge {
        Halfedge(self.0 << 1)
    }
}
