//! Why a recipe, or what a link says was done to a surface, cannot be used.

use crate::app::fault::Fault;
use crate::flow::option::OptionError;
use std::fmt;
use thiserror::Error;

/// A recipe that cannot be read or followed.
#[derive(Clone, Debug, Error, PartialEq)]
pub(in crate::app) enum RecipeError {
    /// The text is no JSON.
    #[error("The recipe is not JSON: line {line} cannot be read.")]
    NotJson {
        /// Counted from 1.
        line: usize,
    },
    /// More text than is ever read.
    #[error("The recipe has {bytes} bytes, more than the {most} that are read.")]
    TooLong {
        /// Its length.
        bytes: usize,
        /// The longest that is read.
        most: usize,
    },
    /// Something is missing, or is not what its place asks for.
    #[error("The recipe’s “{key}” must be {expected}.")]
    BadValue {
        /// The place, as JavaScript would write it.
        key: String,
        /// What belongs there.
        expected: Expected,
    },
    /// An option of a flow or of an arrangement.
    #[error("{error}{}", by_version(.version))]
    Option {
        /// What is wrong with it.
        error: OptionError,
        /// The version that wrote the recipe, where that is another.
        version: Option<String>,
    },
    /// Selections of vertices that are too large together.
    #[error("The selections hold {count} vertices in all, more than the {most} that are read.")]
    TooManySelected {
        /// Vertices in all selections.
        count: usize,
        /// The most that are read.
        most: usize,
    },
    /// More changes of the flow than the mesh leaves memory for.
    #[error("The flow changes {count} times on a mesh of {vertices} vertices: that is too much.")]
    TooManyFlows {
        /// Changes so far.
        count: usize,
        /// Vertices of the mesh.
        vertices: usize,
    },
    /// The file that it begins with was not given.
    #[error("The recipe needs the mesh {name}.")]
    MeshMissing {
        /// Name of the file.
        name: String,
    },
    /// The file given is another.
    #[error(
        "The file given is not the mesh {name}: its SHA-256 begins with {found}, not with {asked}."
    )]
    AnotherMesh {
        /// Name of the file asked for.
        name: String,
        /// First digits of its digest.
        asked: String,
        /// Those of the file given.
        found: String,
    },
    /// The flow comes to its end before its last step.
    #[error("The flow ends at step {step} of {goal}: {reason}.")]
    EndsEarly {
        /// The last step there is.
        step: usize,
        /// The step asked for.
        goal: usize,
        /// Why, as the flow says.
        reason: String,
    },
    /// There is nothing to be done again.
    #[error("No flow has been chosen yet.")]
    NoFlow,
    /// What was loaded first is not known.
    #[error(
        "A recipe of this surface cannot be made: where its mesh came from is not known any more."
    )]
    OriginUnknown,
    /// Nothing is being replayed.
    #[error("No recipe is being followed.")]
    NotReplaying,
}

/// What belongs somewhere in a recipe.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::app) enum Expected {
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

impl fmt::Display for Expected {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Version => f.write_str("the version, as text"),
            Self::Object => f.write_str("an object"),
            Self::List => f.write_str("a list"),
            Self::Count { most } => write!(f, "a whole number from 0 to {most}"),
            Self::Number => f.write_str("a number"),
            Self::NumberOrNull => f.write_str("a number or null"),
            Self::Digest => f.write_str("a SHA-256, 64 digits from 0 to f"),
            Self::Shape => f.write_str("the name of a shape"),
            Self::Sample => f.write_str("the name of a sample"),
            Self::File => f.write_str("the name of a file"),
            Self::Numbers => f.write_str("an object of numbers"),
            Self::Options => f.write_str("an object of options"),
            Self::Action => f.write_str("{ steps }, { regularise }, { flow } or “anew”"),
            Self::Edit => f.write_str(
                "“adopt”, { fill }, { flip }, { subdivide } or { invert: [x, y, z] }, with options \
                 that there are",
            ),
            Self::Regularisation => f.write_str("options of a regularisation"),
            Self::Steps { total } => {
                write!(f, "a list whose steps are {total} in all, as “steps” says")
            }
        }
    }
}

fn by_version(version: &Option<String>) -> String {
    match version {
        Some(version) => format!(
            " (the recipe was written by version {version}; this is version {})",
            env!("CARGO_PKG_VERSION")
        ),
        None => String::new(),
    }
}

impl RecipeError {
    fn kind(&self) -> &'static str {
        match self {
            Self::Option { error, .. } => error.kind(),
            Self::AnotherMesh { .. } => "AnotherMesh",
            Self::MeshMissing { .. } => "MeshMissing",
            Self::EndsEarly { .. } => "EndsEarly",
            Self::NoFlow | Self::OriginUnknown => "NoRecipe",
            Self::NotReplaying => "NotReplaying",
            _ => "BadRecipe",
        }
    }

    fn hint(&self) -> String {
        match self {
            Self::Option { error, .. } => error.hint(),
            Self::MeshMissing { .. } => "Open it first.".into(),
            Self::AnotherMesh { .. } => {
                "The recipe holds for that very file only, to the last byte.".into()
            }
            Self::EndsEarly { .. } => String::new(),
            Self::NoFlow => "Choose one first.".into(),
            Self::NotReplaying => "Open one first.".into(),
            Self::OriginUnknown => {
                "Open the mesh or choose the sample again; what is done from then on is recorded."
                    .into()
            }
            Self::TooManySelected { .. } | Self::TooManyFlows { .. } | Self::TooLong { .. } => {
                "Do the work in fewer parts, and save the mesh between them.".into()
            }
            _ => "Recipes are made by “Save as: Recipe”.".into(),
        }
    }
}

impl From<OptionError> for RecipeError {
    fn from(error: OptionError) -> Self {
        Self::Option {
            error,
            version: None,
        }
    }
}

impl From<RecipeError> for Fault {
    fn from(error: RecipeError) -> Self {
        Self::new(error.kind(), error.to_string(), error.hint())
    }
}
