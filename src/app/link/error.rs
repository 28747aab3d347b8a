//! Why a link is refused.

use crate::app::fault::Fault;
use crate::app::message::AppError;
use crate::app::recipe::RecipeError;
use crate::flow::option::OptionError;
use crate::message::messages;

/// Letters of a value that a message repeats.
const LONGEST_VALUE: usize = 60;

messages! {
    /// A link that cannot be read.
    #[derive(Clone, Debug, PartialEq)]
    pub enum LinkError as "link" {
        /// More text than is ever read.
        TooLong {
            /// Its length.
            bytes: usize,
            /// The longest that is read.
            most: usize,
        },
        /// A word that is said more than once.
        Twice {
            /// The word.
            word: String,
        },
        /// A value that a word cannot have.
        BadWord {
            /// The word.
            word: &'static str,
            /// Its value, cut off where it is long.
            value: String,
            /// What it may be.
            allowed: LinkValue,
        },
        /// A figure that there is not.
        Figure(error: AppError),
        /// An option of a flow or of an arrangement.
        Option(error: OptionError),
        /// What was done to the surface.
        Recipe(reason: RecipeError),
    }
}

messages! {
    /// What the value of a word of a link may be.
    #[derive(Clone, Debug, PartialEq)]
    pub enum LinkValue as "link-value" {
        /// The id of a sample.
        Sample,
        /// The digits that a digest begins with.
        Digest,
        /// A step.
        Step,
        /// A share.
        Percent,
        /// What the viewer gives as its camera.
        Camera,
        /// One of some names.
        OneOf {
            /// The names.
            names: Vec<&'static str>,
        },
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
}

impl LinkError {
    /// A refusal of a value.
    pub(super) fn bad(word: &'static str, value: &str, allowed: LinkValue) -> Self {
        Self::BadWord {
            word,
            value: shortened(value),
            allowed,
        }
    }

    /// The refusal of a figure.
    pub(super) fn no_figure(id: &str) -> Self {
        let name = shortened(id);
        AppError::UnknownFigure { name }.into()
    }
}

fn shortened(text: &str) -> String {
    text.chars().take(LONGEST_VALUE).collect()
}

impl From<LinkError> for Fault {
    fn from(error: LinkError) -> Self {
        match error {
            LinkError::Figure(error) => error.into(),
            LinkError::Option(error) => error.into(),
            LinkError::Recipe(error) => error.into(),
            LinkError::BadWord { .. } => Self {
                kind: "BadValue",
                ..Self::new(&error)
            },
            LinkError::TooLong { .. } | LinkError::Twice { .. } => Self {
                kind: "BadLink",
                ..Self::new(&error)
            },
        }
    }
}
