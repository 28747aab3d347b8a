//! Why an option is refused, and which one was probably meant.

use thiserror::Error;

/// An option that there is not, or a value that it cannot have.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum OptionError {
    /// Nothing is called so.
    #[error("there is no option `{name}`")]
    Unknown {
        /// As given.
        name: String,
        /// Name and flag of the option that is called almost so.
        near: Option<(String, String)>,
    },
    /// Not in its range, or of another kind.
    #[error("`{name}` cannot be `{value}`")]
    BadValue {
        /// The option.
        name: &'static str,
        /// What was given.
        value: String,
        /// What it may be, in half a sentence.
        allowed: String,
    },
    /// Nothing was given.
    #[error("`{name}` has no value")]
    Empty {
        /// The option.
        name: &'static str,
        /// What it may be.
        allowed: String,
    },
    /// What runs does not read it.
    #[error("`{name}` changes nothing here: it is for {of}")]
    Unread {
        /// The option.
        name: &'static str,
        /// What reads it.
        of: String,
    },
    /// Two that say the same thing differently.
    #[error("`{first}` and `{second}` cannot both be given")]
    Conflict {
        /// One.
        first: &'static str,
        /// The other.
        second: &'static str,
    },
}

impl OptionError {
    /// The variant's name. A value out of range and a missing one are the same mistake.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Unknown { .. } => "UnknownOption",
            Self::BadValue { .. } | Self::Empty { .. } => "BadOption",
            Self::Unread { .. } => "UnreadOption",
            Self::Conflict { .. } => "ConflictingOptions",
        }
    }

    /// What the user can do.
    pub fn hint(&self) -> String {
        match self {
            Self::Unknown {
                near: Some((name, flag)),
                ..
            } if name == flag => format!("Did you mean `{name}`?"),
            Self::Unknown {
                near: Some((name, flag)),
                ..
            } => format!("Did you mean `{name}` (--{flag})?"),
            Self::Unknown { near: None, .. } => {
                "--help lists the options; a link that is copied from the page shows how they are \
                 written."
                    .into()
            }
            Self::BadValue { allowed, .. } | Self::Empty { allowed, .. } => {
                format!("It may be {allowed}.")
            }
            Self::Unread { .. } => "Leave it out, or choose what reads it.".into(),
            Self::Conflict { .. } => "Each says the same thing in its own way.".into(),
        }
    }
}

/// Slips of the hand that a name may have and still be recognised.
const MOST_SLIPS: usize = 2;

/// The nearest of `names`, when it is near enough to be a slip of the hand.
pub fn nearest<'a>(typed: &str, names: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let ranked = names.into_iter().map(|name| (edits(typed, name), name));
    let (distance, name) = ranked.min_by_key(|(distance, _)| *distance)?;
    // Of a short name hardly anything would be left.
    (distance <= MOST_SLIPS && distance < name.chars().count()).then_some(name)
}

/// Levenshtein's distance: letters to insert, leave out or replace.
fn edits(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, y) in b.iter().enumerate() {
            let replaced = diagonal + usize::from(x != *y);
            diagonal = row[j + 1];
            row[j + 1] = replaced.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_are_those_of_levenshtein() {
        for (a, b, distance) in [
            ("kitten", "sitting", 3),
            ("", "abc", 3),
            ("flaw", "lawn", 2),
            ("ab", "ba", 2),
            ("same", "same", 0),
        ] {
            assert_eq!(edits(a, b), distance, "{a} {b}");
            assert_eq!(edits(b, a), distance, "{b} {a}");
        }
    }

    #[test]
    fn a_slip_is_recognised_and_nothing_else() {
        let names = ["p", "tau", "steps", "epsilon"];
        assert_eq!(nearest("stepz", names), Some("steps"));
        assert_eq!(nearest("epsillon", names), Some("epsilon"));
        assert_eq!(nearest("q", names), None);
        assert_eq!(nearest("nothing", names), None);
    }
}
