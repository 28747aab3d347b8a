//! What a recipe or a link says is to be done to a mesh, and what that takes.

use crate::app::provenance::{Action, EditRecord};
use serde::Serialize;

/// Beyond so many steps one would rather be asked.
const MANY_STEPS: u64 = 10_000;

/// The mesh that a script begins with.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::app) enum Start {
    /// A sample shape.
    Shape {
        name: String,
        parameters: Vec<(String, f64)>,
    },
    /// A file, with the digits that its digest begins with, where they are known.
    File {
        name: Option<String>,
        sha256: Option<String>,
    },
}

impl Start {
    pub(in crate::app) fn is_file(&self) -> bool {
        matches!(self, Self::File { .. })
    }
}

/// What is done to a mesh.
#[derive(Clone, Debug, PartialEq)]
pub(in crate::app) struct Script {
    pub(in crate::app) start: Start,
    pub(in crate::app) edits: Vec<EditRecord>,
    /// After the last edit.
    pub(in crate::app) path: Vec<Action>,
}

/// What it takes to do something again.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct Estimate {
    /// Steps in all.
    pub steps: u64,
    /// Whether one would rather be asked first.
    pub is_long: bool,
}

impl Estimate {
    /// Of so many steps.
    pub(in crate::app) fn of_steps(steps: u64) -> Self {
        let is_long = steps > MANY_STEPS;
        Self { steps, is_long }
    }

    /// Of edits, and so many steps after them.
    pub(in crate::app) fn of(edits: &[EditRecord], steps: u64) -> Self {
        let before: u64 = edits.iter().map(|record| steps_in(&record.path)).sum();
        Self::of_steps(before + steps)
    }
}

/// Steps of a path.
pub(in crate::app) fn steps_in(path: &[Action]) -> u64 {
    let steps = path.iter().map(|action| match action {
        Action::Steps(count) => *count as u64,
        _ => 0,
    });
    steps.sum()
}
