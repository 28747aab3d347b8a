//! Why an option is refused, and which one was probably meant.

use crate::message::{Message, messages};

messages! {
    /// An option that there is not, or a value that it cannot have.
    #[derive(Clone, Debug, PartialEq)]
    pub enum OptionError as "option-error" {
        /// Nothing is called so.
        UnknownOption {
            /// As given.
            name: String,
            /// The option that is called almost so, or `none`, …
            near: String,
            /// … and its flag.
            flag: String,
        },
        /// Not in its range, or of another kind.
        BadOption {
            /// The option.
            name: &'static str,
            /// What was given.
            value: String,
            /// What it may be.
            allowed: Allowed,
        },
        /// What runs does not read it.
        UnreadOption {
            /// The option.
            name: &'static str,
            /// The flows that read it …
            flows: Vec<&'static str>,
            /// … with this scheme, or `any`, …
            scheme: &'static str,
            /// … and with this goal, or `any`.
            goal: &'static str,
        },
        /// One that there must be.
        MissingOption {
            /// The option.
            name: &'static str,
            /// What it may be.
            allowed: Allowed,
        },
        /// One that is read together with a value of another only.
        LoneOption {
            /// The option.
            name: &'static str,
            /// The other.
            other: &'static str,
            /// What that would have to be.
            value: &'static str,
        },
        /// Two that say the same thing differently.
        ConflictingOptions {
            /// One.
            first: &'static str,
            /// The other.
            second: &'static str,
        },
    }
}

messages! {
    /// What the value of an option may be.
    #[derive(Clone, Debug, PartialEq)]
    pub enum Allowed as "allowed" {
        /// A number between these, both included.
        Range {
            /// The least.
            low: f64,
            /// The largest.
            high: f64,
        },
        /// The same, or 0.
        ZeroOrRange {
            /// The least.
            low: f64,
            /// The largest.
            high: f64,
        },
        /// Above the one and at most the other.
        Above {
            /// What it is above.
            low: f64,
            /// The largest.
            high: f64,
        },
        /// A whole number between these, both included.
        WholeRange {
            /// The least.
            low: f64,
            /// The largest.
            high: f64,
        },
        /// One of some names.
        OneOf {
            /// The names.
            names: Vec<&'static str>,
        },
        /// Any of some names, or none of them.
        AnyOf {
            /// The names.
            names: Vec<&'static str>,
        },
        /// Yes or no.
        Switch,
        /// Any number of these, with commas.
        SeveralOf {
            /// What each may be.
            allowed: Message,
        },
        /// Vertex numbers.
        Vertices,
        /// A word, or something else.
        WordOr {
            /// The word.
            word: &'static str,
            /// What else.
            allowed: Message,
        },
        /// One of the flows that move vertices.
        MovingFlow,
        /// One of the flows by mean curvature or its derivatives.
        CurvatureFlow,
        /// Given only where both area and volume are kept.
        WithAreaAndVolume,
        /// Only 2 with spontaneous curvature, tension or pressure.
        HelfrichTwo,
        /// 0 on quadrilaterals.
        ZeroOnQuadrilaterals,
        /// 0 in the paper's scheme.
        ZeroInPaper,
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

/// The distance of Damerau and Levenshtein: letters to insert, leave out or replace, and neighbours
/// to change over.
fn edits(a: &str, b: &str) -> usize {
    let [a, b]: [Vec<char>; 2] = [a, b].map(|word| word.chars().collect());
    let first: Vec<usize> = (0..=b.len()).collect();
    let mut rows = vec![first];
    for (i, x) in a.iter().enumerate() {
        let above = &rows[i];
        let mut row = vec![i + 1];
        for (j, y) in b.iter().enumerate() {
            let replaced = above[j] + usize::from(x != y);
            let mut least = replaced.min(above[j + 1] + 1).min(row[j] + 1);
            if i > 0 && j > 0 && *x == b[j - 1] && a[i - 1] == *y {
                least = least.min(rows[i - 1][j - 1] + 1);
            }
            row.push(least);
        }
        rows.push(row);
    }
    rows[a.len()][b.len()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_are_those_of_damerau_and_levenshtein() {
        for (a, b, distance) in [
            ("kitten", "sitting", 3),
            ("", "abc", 3),
            ("flaw", "lawn", 2),
            ("ab", "ba", 1),
            ("hlep", "help", 1),
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
