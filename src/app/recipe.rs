//! How the present surface came about from the mesh that was loaded, as something that can
//! be done again.

use super::Session;
use super::fault::Fault;
use super::fill::{FillOptions, Loops};
use super::flip::FlipOptions;
use super::history::Deed;
use super::message::AppError;
use super::subdivide::SubdivideOptions;
use super::work::Work;
use crate::flow::options::FlowOptions;
use crate::remesh::static_pass::RegulariseOptions;
use serde::Serialize;

/// A part of a run.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub enum Leg {
    /// So many steps.
    Steps(usize),
    /// A conformal regularisation of the mesh at rest.
    Regularise(RegulariseOptions),
    /// The flow is made anew where it stands: it knows nothing of earlier steps.
    Anew,
    /// From here on another flow, or the same with other parameters.
    Flow(Box<FlowOptions>),
}

/// What made another mesh of the one at hand.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub enum Edit {
    /// The surface as it was became the start.
    Adopt,
    /// Holes were filled.
    Fill(FillOptions),
    /// Connectivity was optimised.
    Flip(FlipOptions),
    /// Faces were divided into four.
    Subdivide(SubdivideOptions),
    /// The surface was inverted in a sphere: its centre, in the units of [`Session::invert`].
    Invert([f64; 3]),
}

/// A run, and the edit that ended it.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Chapter {
    /// Options of the flow; absent where none was chosen.
    pub flow: Option<FlowOptions>,
    /// What was done.
    pub path: Vec<Leg>,
    /// The edit.
    pub edit: Edit,
}

/// How the present surface came about.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Recipe {
    /// What made the mesh of the one that was loaded, oldest first.
    pub edits: Vec<Chapter>,
    /// Options of the flow it began with; absent where none was chosen.
    pub flow: Option<FlowOptions>,
    /// What was done since.
    pub path: Vec<Leg>,
}

impl Session {
    /// How the present surface came about, forgotten steps included.
    ///
    /// # Errors
    /// `NoRecipe` after positions came from outside.
    pub fn recipe(&self) -> Result<Recipe, Fault> {
        let work = self.work()?;
        let Some(edits) = work.origin.clone().filter(|_| !work.is_restored) else {
            return Err(AppError::NoRecipe.into());
        };
        Ok(Recipe {
            edits,
            flow: work.told_options(),
            path: work.legs(),
        })
    }
}

impl Work {
    /// The options that the run began with.
    fn told_options(&self) -> Option<FlowOptions> {
        self.flow.as_ref()?;
        Some(self.as_given(&self.first.options))
    }

    fn legs(&self) -> Vec<Leg> {
        if let Some(flips) = self.flow.as_ref().and_then(|flow| flow.flips()) {
            // One by one or many at once, they are the same.
            let count = flips.runs()[0].flips();
            return Vec::from_iter((count > 0).then_some(Leg::Steps(count)));
        }
        let mut legs = Vec::new();
        for act in self.history.acts() {
            if act.anew {
                legs.push(Leg::Anew);
            }
            match (&act.deed, legs.last_mut()) {
                (Deed::Step, Some(Leg::Steps(count))) => *count += 1,
                (Deed::Step, _) => legs.push(Leg::Steps(1)),
                (Deed::Regularise(settings), _) => legs.push(Leg::Regularise(*settings)),
                (Deed::Flow(options), _) => {
                    legs.push(Leg::Flow(Box::new(FlowOptions::clone(options))))
                }
            }
        }
        legs
    }

    /// How a document that `edit` makes of what is shown comes about.
    pub(super) fn origin_of(&self, mut edit: Edit) -> Option<Vec<Chapter>> {
        if let Edit::Fill(options) = &mut edit
            && options.loops == Loops::All
        {
            options.loops = Loops::Word("all".into());
        }
        let mut chapters = self.origin.clone().filter(|_| !self.is_restored)?;
        chapters.push(Chapter {
            flow: self.told_options(),
            path: self.legs(),
            edit,
        });
        Some(chapters)
    }
}
