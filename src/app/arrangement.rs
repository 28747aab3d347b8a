//! What is shown side by side, and how edge flips are shown.

use serde::{Deserialize, Serialize};

/// What stands beside the surface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum Compare {
    /// Nothing.
    #[default]
    None,
    /// The mesh before the first flip.
    Start,
    /// The other criteria, after as many flips from the same start.
    Criteria,
    /// The other flows by mean curvature and its derivatives, from the same start.
    Flows,
}

/// What is shown of edge flips.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct Arrangement {
    /// Side by side.
    pub compare: Compare,
    /// Steps of Loop's scheme before drawing.
    pub subdivide: usize,
    /// Flips a step makes; all that gain anything if absent.
    pub flips_per_step: Option<usize>,
}

impl Arrangement {
    /// The surface alone, flip by flip.
    pub const PLAIN: Self = Self {
        compare: Compare::None,
        subdivide: 0,
        flips_per_step: Some(1),
    };
}

impl Default for Arrangement {
    fn default() -> Self {
        Self::PLAIN
    }
}
