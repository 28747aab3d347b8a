//! Why a recipe, or what a link says was done to a surface, cannot be used.

use crate::app::fault::Fault;
use crate::flow::option::OptionError;
use crate::message::{Message, Say, messages};

messages! {
    /// A recipe that cannot be read or followed.
    #[derive(Clone, Debug, PartialEq)]
    pub enum RecipeError as "recipe" {
        /// The text is no JSON.
        NotJson {
            /// Counted from 1.
            line: usize,
        },
        /// More text than is ever read.
        TooLong {
            /// Its length.
            bytes: usize,
            /// The longest that is read.
            most: usize,
        },
        /// Something is missing, or is not what its place asks for.
        Malformed {
            /// The place, as JavaScript would write it.
            key: String,
            /// What belongs there.
            must: MustBe,
        },
        /// An option of a flow or of an arrangement.
        Option(error: OptionError),
        /// The same, in a recipe that another version wrote.
        OldOption {
            /// What is wrong with it.
            error: Box<OptionError>,
            /// The version that wrote the recipe.
            version: String,
            /// This version.
            present: &'static str,
        },
        /// Selections of vertices that are too large together.
        TooManySelected {
            /// Vertices in all selections.
            count: usize,
            /// The most that are read.
            most: usize,
        },
        /// More changes of the flow than the mesh leaves memory for.
        TooManyFlows {
            /// Changes so far.
            count: usize,
            /// Vertices of the mesh.
            vertices: usize,
        },
        /// The file that it begins with was not given.
        MeshMissing {
            /// Name of the file.
            name: String,
        },
        /// The file given is another.
        AnotherMesh {
            /// Name of the file asked for.
            name: String,
            /// First digits of its digest.
            asked: String,
            /// Those of the file given.
            found: String,
        },
        /// The flow comes to its end before its last step.
        EndsEarly {
            /// The last step there is.
            step: usize,
            /// The step asked for.
            goal: usize,
            /// Why, as the flow says.
            reason: Option<Message>,
        },
        /// There is nothing to be done again.
        NoFlow,
        /// What was loaded first is not known.
        OriginUnknown,
        /// Nothing is being replayed.
        NotReplaying,
    }
}

messages! {
    /// What belongs somewhere in a recipe.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub enum MustBe as "must-be" {
        /// The version, as text.
        Version,
        /// An object.
        Object,
        /// A list.
        List,
        /// A whole number.
        Count {
            /// The largest.
            most: u64,
        },
        /// Any number.
        Number,
        /// A number, or null.
        NumberOrNull,
        /// 64 hexadecimal digits.
        Digest,
        /// Name of a shape.
        Shape,
        /// Name of a sample.
        Sample,
        /// Name of a file.
        File,
        /// Numbers by name.
        Numbers,
        /// Options of a flow.
        Options,
        /// What may stand in a path.
        Action,
        /// What may end an edit record.
        Edit,
        /// Options of a regularisation.
        Regularisation,
        /// A path of so many steps.
        Steps {
            /// As `steps` says.
            total: u64,
        },
    }
}

impl From<RecipeError> for Fault {
    /// What is wrong with the text is `BadRecipe`; its options are refused as anywhere.
    fn from(error: RecipeError) -> Self {
        use RecipeError as R;
        let mut fault = Self::new(&error);
        match &error {
            R::NotJson { .. } | R::TooLong { .. } | R::Malformed { .. } => fault.kind = "BadRecipe",
            R::NoFlow | R::OriginUnknown => fault.kind = "NoRecipe",
            R::OldOption { error, .. } => (fault.kind, fault.hint) = (error.kind(), error.hint()),
            _ => (),
        }
        fault
    }
}
