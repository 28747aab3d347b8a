//! How a run ended, for whoever waited for it.

use super::Session;
use super::fault::Fault;
use super::runner::Runner;
use crate::energy::curvature_jump::CurvatureJump;
use crate::flow::option::kind::id_of;
use crate::flow::{Monitored, Status, Warning};
use crate::geometry::measure;
use crate::message::{Message, Value, messages};
use crate::remesh::adaptive::Soundness;
use serde::Serialize;
use std::collections::BTreeMap;

messages! {
    /// What is to be said of a run that is over.
    #[derive(Clone, Debug, PartialEq)]
    pub enum RunNotice as "run" {
        /// How it ended, and why.
        Over {
            /// After how many steps.
            ended: Message,
            /// The reason.
            reason: Option<Message>,
        },
        /// It is over without having come to rest: the best surface there is, but not the one
        /// that was meant.
        NotAtRest {
            /// The reason.
            reason: Option<Message>,
        },
        /// Faces folded over in some of its steps.
        Folds {
            /// In so many …
            folding: usize,
            /// … of these.
            steps: usize,
        },
    }
}

/// How a run ended, or how far it has come.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct Outcome {
    /// Whether it is over, and of which kind its end is.
    pub status: Status,
    /// Whether the surface could not be kept good any longer: what is left is the last good one.
    pub is_breakdown: bool,
    /// How it ended, and why.
    pub message: Message,
    /// The reason alone.
    pub reason: Option<Message>,
    /// The failure of its last step.
    pub fault: Option<Fault>,
    /// Which functional its steps must not raise.
    pub monitored: Monitored,
    /// Whether the readings at the end can be believed, of the p-Willmore flow and of a rest under
    /// flows by fits.
    pub soundness: Option<Soundness>,
    /// The jump of H across the boundary of what moves.
    pub curvature_jump: Option<CurvatureJump>,
    /// What its steps warned of, the last of each kind, and whether it came to rest.
    pub warnings: Vec<Message>,
}

impl Session {
    /// How the run of the present flow ended.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn outcome(&self) -> Result<Outcome, Fault> {
        Ok(self.runner()?.outcome())
    }
}

impl Runner {
    fn outcome(&self) -> Outcome {
        let (status, reason) = (self.state.status, self.state.message.clone());
        let values = [
            ("status", Value::from(id_of(&status))),
            ("steps", self.state.step.into()),
        ];
        let ended = Message {
            id: "ended".into(),
            values: values.into(),
        };
        let message = RunNotice::Over {
            ended,
            reason: reason.clone(),
        };
        Outcome {
            status,
            is_breakdown: status.is_breakdown(),
            message: message.into(),
            fault: self
                .failure
                .clone()
                .filter(|_| status == Status::Failed)
                .map(Fault::from),
            monitored: self.state.monitored,
            soundness: self.state.soundness,
            curvature_jump: self.curvature_jump(),
            warnings: self.warnings(),
            reason,
        }
    }

    fn warnings(&self) -> Vec<Message> {
        let reports = self.history.reports();
        let folding = reports.iter().filter(|report| report.flipped_faces > 0);
        let (folding, steps) = (folding.count(), reports.len());
        // The count of steps says more than the faces of any one of them.
        let of_steps = reports.iter().flat_map(|report| &report.warnings);
        // Nor does it matter what a mesh was like that has been made another since, or who took the steps.
        let is_passing = |warning: &&Warning| {
            matches!(
                warning,
                Warning::FoldedFaces { .. }
                    | Warning::Untrusted { .. }
                    | Warning::NearSphere
                    | Warning::AwayFromSphere
                    | Warning::LittleGain
                    | Warning::NoGain
                    | Warning::ExactHalt
                    | Warning::AnotherRound
            )
        };
        let others = of_steps.filter(|warning| !is_passing(warning));
        // What grows on is told by what it has come to.
        let first = measure::area(&self.document.triangles, &self.document.start);
        let now = (100.0 * (self.state.area / first - 1.0)).round();
        let others = others.copied().map(|warning| match warning {
            Warning::OpenBoundary { percent } => Warning::OpenBoundary {
                percent: percent.max(now),
            },
            other => other,
        });
        let unsound = self.state.soundness.as_ref().and_then(Warning::of_unsound);
        let mut last = BTreeMap::new();
        for message in others.chain(unsound).map(Message::from) {
            last.insert(message.id.clone(), message);
        }
        let folds = (folding > 0).then_some(RunNotice::Folds { folding, steps });
        let stalled = (self.state.status == Status::Stalled).then(|| RunNotice::NotAtRest {
            reason: self.state.message.clone(),
        });
        let notices = folds.into_iter().chain(stalled).map(Message::from);
        last.into_values().chain(notices).collect()
    }
}
