//! A figure of a paper: what is run for it, and the rule that judges the run.

use super::measured::Run;
use super::sample::{Sample, Shape};
use crate::app::{Arrangement, FieldName, RegulariseOptions};
use crate::flow::Status;
use crate::flow::options::FlowOptions;
use crate::message::{Message, Value};
use serde::Serialize;

/// Parameters of a shape in the place of those of a sample, by name.
pub type Parameters = &'static [(&'static str, f64)];

/// A figure that shows a result.
#[derive(Clone, Copy, Debug)]
pub struct Figure {
    /// Its name in links, thumbnails and locale files.
    pub id: &'static str,
    /// Its paper, of [the references](crate#references): called `paper-<paper>` in the locale files.
    pub paper: &'static str,
    /// As the paper numbers it.
    pub number: &'static str,
    /// Id of the sample it begins with.
    pub sample: &'static str,
    /// Options over those of the sample.
    pub options: fn(FlowOptions) -> FlowOptions,
    /// What stands side by side.
    pub arrangement: Arrangement,
    /// What the surface is coloured by.
    pub colour: Option<FieldName>,
    /// How far it runs.
    pub steps: Steps,
    /// Parameters of coarser meshes, coarsest first, on which the same is run before.
    pub refine: &'static [Parameters],
    /// Parameters of the surface on which the same is run first, where the two runs make one film:
    /// this one backwards, then that of the sample.
    pub back: Option<Parameters>,
    /// Regularisation after the steps.
    pub regularise: Option<RegulariseOptions>,
    /// The undamaged surface, its vertices numbered as those of the sample.
    pub reference: Option<Shape>,
    /// Whether it takes a few seconds at most.
    pub quick: bool,
    /// Whether it is known not to come out as the paper has it; the words say why.
    pub falls_short: bool,
    /// Whether a run comes out as expected, and what was measured.
    pub(in crate::app) judge: fn(&Run<'_>) -> Finding,
}

/// How far a figure runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Steps {
    /// So many steps, fewer where it comes to rest before; 0 for a figure without a flow.
    Count(usize),
    /// Until it comes to rest.
    Rest,
}

/// What a run came to.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Finding {
    /// Whether it came out as expected.
    pub ok: bool,
    /// What was measured.
    pub message: Message,
}

impl From<Status> for Value {
    fn from(status: Status) -> Self {
        let id = match status {
            Status::Ready => "measured-ready",
            Status::Converged => "measured-converged",
            Status::StepLimit => "measured-step-limit",
            Status::Stalled => "measured-stalled",
            Status::Singular => "measured-singular",
            Status::Collapsed => "measured-collapsed",
            Status::Failed => "measured-failed",
        };
        Self::Message(said(id, &[]))
    }
}

fn said(id: &str, values: &[(&'static str, Value)]) -> Message {
    Message {
        id: id.into(),
        values: values.into(),
    }
}

impl Finding {
    pub(in crate::app) fn new(
        ok: bool,
        id: &'static str,
        values: &[(&'static str, Value)],
    ) -> Self {
        let message = said(id, values);
        Self { ok, message }
    }
}

impl Figure {
    /// A figure with nothing special about it, for the tables to begin with.
    pub(in crate::app) const PLAIN: Self = Self {
        id: "",
        paper: "",
        number: "",
        sample: "",
        options: |o| o,
        arrangement: Arrangement::PLAIN,
        colour: None,
        steps: Steps::Rest,
        refine: &[],
        back: None,
        regularise: None,
        reference: None,
        quick: true,
        falls_short: false,
        judge: |_| Finding::new(false, "measured-incomplete", &[]),
    };

    /// Its sample; the tables name none that there is not.
    pub fn sample(&self) -> Option<&'static Sample> {
        super::sample(self.sample)
    }

    /// Options in full: those of the sample under its own.
    pub fn whole_options(&self) -> FlowOptions {
        let of_sample = self.sample().map(Sample::whole_options);
        (self.options)(of_sample.unwrap_or_default())
    }

    /// Whether it takes more than one run of its flow to be judged.
    pub fn is_compound(&self) -> bool {
        !self.refine.is_empty() || self.regularise.is_some()
    }
}
