//! Why a link is refused.

use crate::app::fault::Fault;
use crate::app::recipe::RecipeError;
use crate::flow::option::OptionError;
use std::fmt;
use thiserror::Error;

/// Letters of a value that a message repeats.
const LONGEST_VALUE: usize = 60;

/// A link that cannot be read.
#[derive(Clone, Debug, Error, PartialEq)]
pub(in crate::app) enum LinkError {
    /// More text than is ever read.
    #[error("The link has {bytes} bytes, more than the {most} that are read.")]
    TooLong {
        /// Its length.
        bytes: usize,
        /// The longest that is read.
        most: usize,
    },
    /// A word that is said more than once.
    #[error("The link has “{word}” more than once.")]
    Twice {
        /// The word.
        word: String,
    },
    /// A value that a word cannot have.
    #[error("“{word}” cannot be “{value}”.")]
    BadWord {
        /// The word.
        word: &'static str,
        /// Its value, cut off where it is long.
        value: String,
        /// What it may be.
        allowed: Allowed,
    },
    /// A figure that there is not.
    #[error("There is no figure “{id}”.")]
    UnknownFigure {
        /// As given, cut off where it is long.
        id: String,
    },
    /// An option of a flow or of an arrangement.
    #[error(transparent)]
    Option(#[from] OptionError),
    /// What was done to the surface.
    #[error(transparent)]
    Recipe(#[from] RecipeError),
}

/// What the value of a word may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::app) enum Allowed {
    /// The id of a sample.
    Sample,
    /// The digits that a digest begins with.
    Digest,
    /// A step.
    Step,
    /// What the viewer gives as its camera.
    Camera,
    /// One of some names.
    Names(&'static [&'static str]),
    /// An energy.
    Energy,
    /// A version.
    Version,
    /// Edits, encoded.
    Edits,
    /// A path that ends at a step, encoded.
    Path {
        /// The step.
        step: usize,
    },
    /// Panes, of flows that move vertices.
    Panes,
    /// The letter of a pane.
    Pane,
}

impl fmt::Display for Allowed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Sample => f.write_str("the id of a sample"),
            Self::Digest => f.write_str("the first 16 digits of a SHA-256, or more of them"),
            Self::Step => f.write_str("a whole number of at most seven digits"),
            Self::Camera => f.write_str("the numbers of a camera, with commas between them"),
            Self::Names(names) => write!(f, "one of {}", names.join(", ")),
            Self::Energy => f.write_str("a number"),
            Self::Version => f.write_str("a version"),
            Self::Edits => f.write_str("edits as a link writes them"),
            Self::Path { step } => write!(f, "a path as a link writes it, to step {step}"),
            Self::Panes => f.write_str("at most three panes, of flows that move vertices"),
            Self::Pane => f.write_str("the letter of a pane"),
        }
    }
}

/// As much of a text as a message repeats.
pub(super) fn shortened(text: &str) -> String {
    text.chars().take(LONGEST_VALUE).collect()
}

impl LinkError {
    /// A refusal of a value.
    pub(super) fn bad(word: &'static str, value: &str, allowed: Allowed) -> Self {
        let value = shortened(value);
        Self::BadWord {
            word,
            value,
            allowed,
        }
    }
}

impl From<LinkError> for Fault {
    fn from(error: LinkError) -> Self {
        let (kind, hint) = match &error {
            LinkError::Option(error) => return error.clone().into(),
            LinkError::Recipe(error) => return error.clone().into(),
            LinkError::BadWord { allowed, .. } => ("BadValue", format!("It may be {allowed}.")),
            LinkError::UnknownFigure { .. } => (
                "UnknownFigure",
                "The button Figures shows those there are.".into(),
            ),
            LinkError::TooLong { .. } | LinkError::Twice { .. } => (
                "BadLink",
                "Copy a link from the page to see how its words are written.".into(),
            ),
        };
        Self::new(kind, error.to_string(), hint)
    }
}
