//! What the application itself has to say; flows, files and meshes have messages of their own.

use crate::flow::option::Allowed;
use crate::message::{Message, messages};

messages! {
    /// Why something asked for cannot be done.
    #[derive(Clone, Debug, PartialEq)]
    pub enum AppError as "app" {
        /// Nothing has been loaded.
        NoMesh,
        /// It was given up, as was asked for.
        Cancelled,
        /// Options that cannot be read.
        BadOptions {
            /// What the reader says of it.
            reason: String,
        },
        /// The deferred part of the program could not be fetched.
        NotFetched,
        /// An option has a value it cannot have.
        BadOption {
            /// The option.
            name: &'static str,
            /// What was given.
            value: String,
            /// What it may be.
            allowed: Allowed,
        },
        /// A selection names what is no vertex of the file.
        BadSelection {
            /// Its number.
            number: u32,
            /// That of the first vertex.
            first: u32,
        },
        /// A word that names no boundary loops.
        UnknownLoops {
            /// The word.
            word: String,
        },
        /// No field has this name.
        UnknownField {
            /// The name.
            name: String,
            /// All names there are.
            known: Vec<&'static str>,
        },
        /// No file format has this name.
        UnknownFormat {
            /// The name.
            name: String,
            /// All names there are.
            known: Vec<&'static str>,
        },
        /// No figure has this id.
        UnknownFigure {
            /// The id.
            name: String,
        },
        /// No flow has been chosen.
        NotConfigured,
        /// Edge flips hold the positions, which a regularisation would move.
        HeldPositions,
        /// Edge flips, and flows side by side, go from the mesh itself.
        FixedStart,
        /// Positions from outside that do not fit the mesh.
        BadPositions {
            /// Coordinates given.
            coordinates: usize,
            /// Vertices of the mesh.
            vertices: usize,
        },
        /// A point of so many coordinates.
        BadPoint {
            /// How many.
            coordinates: usize,
        },
        /// A quadrilateral of so many corners.
        BadQuadrilateral {
            /// How many.
            corners: usize,
        },
        /// Vertices that do not exist.
        NoSuchVertex {
            /// Some of which do not.
            corners: Vec<u32>,
        },
        /// A branch of the history that is not there.
        NoSuchBranch {
            /// Its number.
            branch: u32,
        },
        /// There is no edit to undo.
        NothingToUndo,
        /// How the surface came about is not known.
        NoRecipe,
        /// No refinement study has begun.
        NoStudy,
        /// No table of measurements has begun.
        NoBench,
        /// A flow takes no step that could be measured.
        NoStep {
            /// Why.
            reason: Option<Message>,
        },
        /// A subdivision would make more faces than there may be.
        TooManyFaces {
            /// How many it would make.
            faces: usize,
            /// How many there may be.
            most: usize,
        },
        /// A remeshing would make more vertices than there may be.
        TooManyVertices {
            /// How many it would make.
            vertices: f64,
            /// How many there may be.
            most: usize,
        },
        /// The centre of an inversion is far away.
        CentreTooFar {
            /// In sizes of the surface at most.
            most: f64,
        },
        /// The centre of an inversion is on the surface, or nearly so.
        CentreTooNear {
            /// Share of the surface's size, in per cent.
            percent: f64,
            /// What it must be at least.
            least: f64,
        },
    }
}

messages! {
    /// What is to be known of a mesh that was loaded or made.
    #[derive(Clone, Debug, PartialEq)]
    pub enum Notice as "notice" {
        /// Faces of more than three corners.
        Polygons {
            /// How many.
            count: usize,
            /// `p-willmore` if that flow keeps them, or `none`.
            kept: &'static str,
        },
        /// Triangles without area.
        FlatTriangles {
            /// How many.
            count: usize,
            /// The first, by its number in the triangulated copy.
            face: u32,
            /// Its corners.
            vertices: Vec<u32>,
        },
        /// Edges far shorter than the mean.
        ShortEdges {
            /// How many.
            count: usize,
            /// One end of the first.
            a: u32,
            /// The other end.
            b: u32,
        },
        /// Edge flips cut what they had better kept.
        FlippedVolume {
            /// What was enclosed.
            before: f64,
            /// What is.
            after: f64,
        },
        /// The surface passes through itself.
        SelfIntersections {
            /// Pairs of triangles.
            count: usize,
        },
        /// Boundary loops were filled.
        Filled {
            /// How many.
            count: usize,
            /// With so many new vertices.
            vertices: usize,
        },
    }
}
