//! What the edits of a mesh can be asked for. Unknown names are refused.

use crate::flow::option::OptionError;
use crate::remesh::adaptive::{Creases, Kind};
use crate::remesh::flips::reduction::Criterion;
use crate::remesh::repair::Weld;
use serde::{Deserialize, Deserializer, Serialize};

/// Which loops are filled: a word, or their numbers, counted from 0; unless told otherwise the
/// small ones.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(untagged)]
pub enum Loops {
    /// Some of them.
    Some(Vec<usize>),
    /// A word: `small`, or `all`.
    Word(String),
    /// Those that are holes and no outer rims; where loops are connected, all.
    #[default]
    Usual,
}

/// How holes are filled. Unknown names are refused.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase", default, deny_unknown_fields)]
pub struct FillOptions {
    /// Which loops.
    pub loops: Loops,
    /// Whether one patch connects them all.
    pub connect: bool,
    /// New vertices at most; 200,000 if absent.
    pub max_vertices: Option<usize>,
}

impl FillOptions {
    /// The same with the usual loops by their word, which is how a recipe has them.
    pub(in crate::app) fn named(&self) -> Self {
        let mut options = self.clone();
        if options.loops == Loops::Usual {
            let word = if options.connect { "all" } else { "small" };
            options.loops = Loops::Word(word.into());
        }
        options
    }
}

/// How connectivity is optimised. Unknown names are refused.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase", default, deny_unknown_fields)]
pub struct FlipOptions {
    /// What is to become small.
    pub criterion: Criterion,
    /// Flips at most; all that gain anything if absent.
    pub max: Option<usize>,
    /// Whether faces may not be turned over.
    pub guard_folds: bool,
    /// Whether every flip is listed.
    pub history: bool,
}

/// How a surface is repaired. Unknown names are refused.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase", default, deny_unknown_fields)]
pub struct RepairOptions {
    /// How near boundary vertices are welded.
    #[serde(deserialize_with = "or_default")]
    pub weld: Weld,
}

/// The word of a default is read as null.
fn or_default<'de, D: Deserializer<'de>>(given: D) -> Result<Weld, D::Error> {
    Ok(Option::deserialize(given)?.unwrap_or_default())
}

/// How faces are divided into four.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum SubdivisionScheme {
    /// At the midpoints of edges: the surface stays the same point set.
    #[default]
    Linear,
    /// By Loop's scheme: every vertex moves towards a smooth limit surface.
    Loop,
}

/// Options of [`Session::subdivide`](crate::app::Session::subdivide).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase", default, deny_unknown_fields)]
pub struct SubdivideOptions {
    /// How.
    pub scheme: SubdivisionScheme,
}

/// What a remeshing makes. Unknown names are refused.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase", default, deny_unknown_fields)]
pub struct RemeshOptions {
    /// What decides how long edges are.
    pub kind: Kind,
    /// Mean length of the edges between vertices that are not held; not together with `vertices`.
    pub target: Option<f64>,
    /// Number of vertices; as many as there are if both are absent.
    pub vertices: Option<usize>,
    /// What becomes of edges of the shape.
    pub creases: Creases,
}

impl RemeshOptions {
    /// That no two say the same thing.
    ///
    /// # Errors
    /// [`OptionError::ConflictingOptions`].
    pub fn check(&self) -> Result<(), OptionError> {
        let (first, second) = ("vertices", "target");
        match (self.vertices, self.target) {
            (Some(_), Some(_)) => Err(OptionError::ConflictingOptions { first, second }),
            _ => Ok(()),
        }
    }
}
