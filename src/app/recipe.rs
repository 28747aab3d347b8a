//! How the present surface came about from the mesh that was loaded, as something that can
//! be done again.

mod error;
mod file;
mod read;
mod replay;
mod script;

pub use file::{RecipeCard, RecipeMesh, ReplayReport, ReplayResult};
pub use replay::{ReplayProgress, ScriptText};
pub use script::Estimate;

pub use error::{MustBe, RecipeError};
pub(super) use file::{is_near, is_plain};
pub(super) use read::{Node, Reader};
pub(super) use replay::Replay;
pub(super) use script::steps_in;

use super::Session;
use super::fault::Fault;
use super::history::Event;
use super::message::AppError;
use super::provenance::{Action, Edit, EditRecord, Provenance};
use super::runner::Runner;
use crate::flow::options::FlowOptions;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// What the open mesh was made of, before any edits; as the page tells it.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(tag = "kind", rename_all = "camelCase")]
pub enum Origin {
    /// A sample.
    Sample {
        /// Its id.
        id: String,
    },
    /// A file.
    File {
        /// What people call it.
        name: String,
        /// Its own name, where it was opened here.
        #[serde(default)]
        #[cfg_attr(test, ts(optional))]
        file: Option<String>,
        /// Its digest; empty or left out where that is not known.
        #[serde(default)]
        #[cfg_attr(test, ts(optional))]
        sha256: Option<String>,
        /// Its length.
        #[serde(default)]
        #[cfg_attr(test, ts(optional))]
        bytes: Option<usize>,
    },
    /// A shape that is no sample.
    Shape {
        /// Its name.
        shape: String,
        /// Parameters that are not the usual ones.
        parameters: BTreeMap<String, f64>,
    },
}

impl Session {
    /// How the present surface came about, forgotten steps included.
    ///
    /// # Errors
    /// `NoRecipe` after positions came from outside.
    pub fn provenance(&self) -> Result<Provenance, Fault> {
        let runner = self.runner()?;
        let Some(edits) = runner.origin.clone().filter(|_| !runner.is_restored) else {
            return Err(AppError::NoRecipe.into());
        };
        Ok(Provenance {
            edits,
            flow: runner.first_options(),
            path: runner.actions(),
        })
    }
}

impl Runner {
    /// The options that the run began with.
    fn first_options(&self) -> Option<FlowOptions> {
        self.engine.as_ref()?;
        Some(self.as_given(&self.first.options))
    }

    fn actions(&self) -> Vec<Action> {
        if let Some(flips) = self.engine.as_ref().and_then(|flow| flow.flips()) {
            // One by one or many at once, they are the same.
            let count = flips.runs()[0].flips();
            return Vec::from_iter((count > 0).then_some(Action::Steps(count)));
        }
        let mut actions = Vec::new();
        for transition in self.history.transitions() {
            if transition.restarted {
                actions.push(Action::Anew);
            }
            match (&transition.event, actions.last_mut()) {
                (Event::Step, Some(Action::Steps(count))) => *count += 1,
                (Event::Step, _) => actions.push(Action::Steps(1)),
                (Event::Regularise(settings), _) => actions.push(Action::Regularise(*settings)),
                // It comes of itself where the steps are taken again.
                (Event::Pass, _) => {}
                (Event::Flow(options), _) => {
                    actions.push(Action::Flow(Box::new(FlowOptions::clone(options))))
                }
            }
        }
        actions
    }

    /// How a document that `edit` makes of what is shown comes about.
    pub(super) fn origin_of(&self, edit: Edit) -> Option<Vec<EditRecord>> {
        let mut records = self.origin.clone().filter(|_| !self.is_restored)?;
        records.push(EditRecord {
            flow: self.first_options(),
            path: self.actions(),
            edit,
        });
        Some(records)
    }
}

#[cfg(test)]
mod tests;
