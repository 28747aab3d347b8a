//! Makes a sample, chooses a flow, takes its steps and shows them.

use crate::app::Loaded;
use crate::app::Session;
use crate::app::fault::Fault;
use crate::app::field::{Field, FieldName};
use crate::app::history::Timeline;
use crate::app::readings::{Info, State};
use crate::app::runner::Configured;
use crate::flow::StepReport;
use crate::flow::option::{Value, Values, options_of};
use crate::interrupt;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A request by name, with its fields.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(
    rename_all = "camelCase",
    rename_all_fields = "camelCase",
    deny_unknown_fields
)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum RunCommand {
    /// Loads a sample shape.
    Sample {
        /// Its name.
        name: String,
        /// Parameters that are not the usual ones.
        #[serde(default)]
        parameters: BTreeMap<String, f64>,
    },
    /// The mesh as it is now.
    Loaded {},
    /// Diagnosis card.
    Info {},
    /// Chooses flow and parameters, and goes back to the start.
    Configure {
        /// Those that are not the usual ones.
        #[cfg_attr(test, ts(as = "crate::flow::options::FlowOptions"))]
        options: Values,
    },
    /// Goes on from the surface as it is with other options.
    ContinueWith {
        /// All of them.
        #[cfg_attr(test, ts(as = "crate::flow::options::FlowOptions"))]
        options: Values,
    },
    /// Takes a step, if there is one to take.
    Step {},
    /// Where the session stands.
    State {},
    /// One stored step back.
    Back {},
    /// Back to the start.
    Reset {},
    /// Shows a stored step, the nearest at or before this one.
    Seek {
        /// Its number.
        step: usize,
    },
    /// Goes to the end of a branch.
    Branch {
        /// Its number.
        branch: u32,
    },
    /// The steps that can be shown.
    Timeline {},
    /// How edge flips, or flows side by side, are shown.
    Arrange {
        /// All of it.
        #[cfg_attr(test, ts(as = "crate::app::arrangement::Arrangement"))]
        arrangement: Values,
    },
    /// What frames are coloured by from now on.
    Colour {
        /// A field by name, or `none`.
        field: String,
    },
}

/// What a command of the same name is answered with.
#[derive(Clone, Debug, Serialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(test, derive(ts_rs::TS))]
#[allow(missing_docs, reason = "each is described at the command of its name")]
pub enum RunAnswer {
    Sample(Loaded),
    Loaded(Loaded),
    Info(Info),
    Configure(Configured),
    ContinueWith(Configured),
    /// None where there was none to take; the state says why.
    Step(Option<Box<StepReport>>),
    State(State),
    Back(State),
    Reset(State),
    Seek(State),
    Branch(State),
    Timeline(Timeline),
    Arrange(State),
    Colour(Option<Field>),
}

impl RunCommand {
    /// Their names, as JavaScript has them.
    pub const NAMES: [&str; 14] = [
        "sample",
        "loaded",
        "info",
        "configure",
        "continueWith",
        "step",
        "state",
        "back",
        "reset",
        "seek",
        "branch",
        "timeline",
        "arrange",
        "colour",
    ];

    /// Whether it is about a flow of the [deferred](crate::deferred) part.
    pub fn asks_for_more(&self) -> bool {
        let (Self::Configure { options } | Self::ContinueWith { options }) = self else {
            return false;
        };
        (options.get("flow")).is_some_and(|flow| *flow != Value::Text("circle".into()))
    }
}

impl Session {
    /// Does what a command asks for.
    ///
    /// # Errors
    /// Those of the method it stands for; nothing has changed then.
    pub fn perform(&mut self, command: RunCommand) -> Result<RunAnswer, Fault> {
        // Steps are observed one by one: what is given up is a step. Where the session stands is told
        // even then.
        use RunCommand::{State, Step, Timeline};
        let is_plain = matches!(command, Step {} | State {} | Timeline {});
        let progress = self.progress.clone().filter(|_| !is_plain);
        let outcome = interrupt::observed(progress, || {
            interrupt::commit()?;
            self.run_command(command)
        });
        outcome.map_err(|fault| self.offering(fault))
    }

    fn run_command(&mut self, command: RunCommand) -> Result<RunAnswer, Fault> {
        use {RunAnswer as A, RunCommand as C};
        if matches!(
            command,
            C::Configure { .. }
                | C::ContinueWith { .. }
                | C::Back {}
                | C::Reset {}
                | C::Seek { .. }
                | C::Branch { .. }
        ) {
            self.view.forget_steps();
        }
        Ok(match command {
            C::Sample { name, parameters } => {
                let values: Vec<(String, f64)> = parameters.into_iter().collect();
                A::Sample(self.sample(&name, &values)?)
            }
            C::Loaded {} => A::Loaded(self.loaded()?),
            C::Info {} => A::Info(self.info()?),
            C::Configure { options } => {
                let configured = self.configure(options_of(&options)?)?;
                self.tell_flow();
                A::Configure(configured)
            }
            C::ContinueWith { options } => {
                let configured = self.continue_with(options_of(&options)?)?;
                self.tell_flow();
                A::ContinueWith(configured)
            }
            C::Step {} => {
                let report = self.step()?;
                if let Some(report) = &report {
                    self.view.add(report);
                }
                A::Step(report.map(Box::new))
            }
            C::State {} => A::State(self.state()?),
            C::Back {} => A::Back(self.back()?),
            C::Reset {} => A::Reset(self.reset()?),
            C::Seek { step } => {
                let known = self.state()?.step;
                let state = self.seek(step)?;
                self.tell_steps_after(known);
                A::Seek(state)
            }
            C::Branch { branch } => {
                let known = self.timeline()?.start;
                let state = self.branch(branch)?;
                self.tell_steps_after(known);
                A::Branch(state)
            }
            C::Timeline {} => A::Timeline(self.timeline()?),
            C::Arrange { arrangement } => {
                self.arrange(options_of(&arrangement)?)?;
                A::Arrange(self.state()?)
            }
            C::Colour { field } => {
                let answer = self.field(&field)?;
                let name = (field != "none").then(|| FieldName::parse(&field));
                self.view.field = name.transpose()?;
                A::Colour(answer)
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By these names it is decided which part of the program reads a command.
    #[test]
    fn the_names_are_those_of_the_commands() {
        let nothing = serde_json::from_str::<RunCommand>(r#"{ "nothing": {} }"#);
        let said = nothing.expect_err("no command").to_string();
        let known: Vec<&str> = said.split('`').skip(3).step_by(2).collect();
        assert_eq!(known, RunCommand::NAMES, "{said}");
    }

    #[test]
    fn only_the_circle_flow_is_there_from_the_start() {
        let asks = |text: &str| {
            let command: RunCommand = serde_json::from_str(text).expect("a command");
            command.asks_for_more()
        };
        assert!(!asks(r#"{ "configure": { "options": {} } }"#));
        assert!(!asks(
            r#"{ "configure": { "options": { "flow": "circle", "tau": 1 } } }"#
        ));
        assert!(asks(
            r#"{ "configure": { "options": { "flow": "p-willmore" } } }"#
        ));
        assert!(asks(
            r#"{ "continueWith": { "options": { "flow": "flips" } } }"#
        ));
        assert!(!asks(r#"{ "step": {} }"#));
    }
}
