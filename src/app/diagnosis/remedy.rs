//! What helps: actions of the application by name, with what they change.

use crate::energy::circle::Boundary;
use crate::flow::constraint::Kept;
use crate::flow::options::{FlowOptions, Scheme};
use crate::flow::spec::FlowName;
use crate::message::{Message, messages};
use crate::remesh::Mode;
use serde::Serialize;

/// What is done.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub enum RemedyId {
    /// Conformal regularisation of the mesh as it is.
    Regularise,
    /// The same after each step.
    RegulariseEachStep,
    /// Repair of the surface as it is, which becomes the start.
    Repair,
    /// The surface as it is becomes the start, by one step of Loop's scheme four times as fine.
    Subdivide,
    /// A smaller constant step.
    SmallerStep,
    /// Steps that adapt.
    AutomaticStep,
    /// More angle smoothing.
    LargerEpsilon,
    /// The recommended scheme in place of the paper's.
    RecommendedScheme,
    /// More steps.
    Continue,
    /// Some steps back.
    Back,
    /// The surface as it is becomes the start, its edges are flipped, the flow goes on.
    KeepAndFlips,
    /// Volume or area are kept.
    KeepVolume,
    /// Another flow.
    OtherFlow,
    /// A smooth first guess of what moves.
    Prefill,
    /// Another exponent first.
    LowerExponent,
    /// Energies at several resolutions.
    Refine,
}

/// Options that a remedy changes; the others stay.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct Change {
    /// See [`FlowOptions::flow`].
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub flow: Option<FlowName>,
    /// See [`FlowOptions::scheme`].
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub scheme: Option<Scheme>,
    /// See [`FlowOptions::boundary`].
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub boundary: Option<Boundary>,
    /// See [`FlowOptions::tau`]; the inner `None` leaves the step to the flow.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub tau: Option<Option<f64>>,
    /// See [`FlowOptions::dt`]; always back to none, so that τ rules.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub dt: Option<Option<f64>>,
    /// See [`FlowOptions::epsilon`].
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub epsilon: Option<f64>,
    /// See [`FlowOptions::prefill`].
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub prefill: Option<bool>,
    /// See [`FlowOptions::p`].
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub p: Option<f64>,
    /// See [`FlowOptions::keep`].
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub keep: Option<Vec<Kept>>,
    /// See [`FlowOptions::reduced_volume`].
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub reduced_volume: Option<Option<f64>>,
    /// See [`FlowOptions::regularise`].
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub regularise: Option<Mode>,
}

impl Change {
    /// The options with this change made.
    #[must_use]
    pub fn applied(&self, options: &FlowOptions) -> FlowOptions {
        let old = options.clone();
        FlowOptions {
            flow: self.flow.unwrap_or(old.flow),
            scheme: self.scheme.unwrap_or(old.scheme),
            boundary: self.boundary.or(old.boundary),
            tau: self.tau.unwrap_or(old.tau),
            dt: self.dt.unwrap_or(old.dt),
            epsilon: self.epsilon.unwrap_or(old.epsilon),
            prefill: self.prefill.unwrap_or(old.prefill),
            p: self.p.unwrap_or(old.p),
            keep: self.keep.clone().unwrap_or_else(|| old.keep.clone()),
            reduced_volume: self.reduced_volume.unwrap_or(old.reduced_volume),
            regularise: self.regularise.unwrap_or(old.regularise),
            ..old
        }
    }
}

messages! {
    /// What a button says.
    #[derive(Clone, Debug, PartialEq)]
    pub enum Label as "remedy" {
        /// To go on as before.
        MoreSteps,
        /// To study the surface at several resolutions.
        RefinementStudy,
        /// To optimise connectivity.
        FlipAndGoOn,
        /// To go back.
        Back {
            /// So many steps.
            steps: usize,
        },
        /// To regularise the mesh.
        RegulariseAndGoOn,
        /// And to use surface diffusion then.
        RegulariseAndDiffuse,
        /// To repair the surface.
        RepairAndGoOn,
        /// To regularise the mesh again and again.
        RegulariseEachStep,
        /// To make the mesh finer.
        SubdivideAndGoOn,
        /// To set the step size.
        SetTau {
            /// Without a unit.
            tau: f64,
        },
        /// To let the step size adapt.
        AutomaticStep,
        /// To leave the paper's scheme.
        RecommendedScheme,
        /// To smooth angles more.
        SetEpsilon {
            /// In radians.
            epsilon: f64,
        },
        /// To lay the free vertices out first.
        FirstGuess,
        /// To keep the volume.
        KeepVolume,
        /// To keep the area.
        KeepArea,
        /// To keep both.
        KeepBoth,
        /// To let go of the area.
        KeepOnlyVolume,
        /// To begin with another exponent.
        SmoothFirst {
            /// The exponent.
            p: f64,
        },
        /// To use another flow.
        UseFlow {
            /// Which, by its name.
            flow: Message,
        },
    }
}

/// Something that helps.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct Remedy {
    /// What is done.
    pub id: RemedyId,
    /// What the button says.
    pub label: Message,
    /// Options that change.
    pub change: Change,
    /// Whether the run begins anew, the present surface being past help; otherwise that is
    /// the new start.
    pub from_start: bool,
    /// Steps to go back.
    pub steps: usize,
}

/// Steps of τ cut to a quarter, as the adaptive ones are.
const CUT: f64 = 0.25;

impl Remedy {
    fn new(id: RemedyId, label: Label) -> Self {
        Self {
            id,
            label: label.into(),
            change: Change::default(),
            from_start: false,
            steps: 0,
        }
    }

    fn changing(id: RemedyId, label: Label, change: Change) -> Self {
        Self {
            change,
            ..Self::new(id, label)
        }
    }

    pub(super) fn anew(mut self) -> Self {
        self.from_start = true;
        self
    }

    pub(super) fn go_on() -> Self {
        Self::new(RemedyId::Continue, Label::MoreSteps)
    }

    pub(super) fn refine() -> Self {
        Self::new(RemedyId::Refine, Label::RefinementStudy)
    }

    pub(super) fn flips() -> Self {
        Self::new(RemedyId::KeepAndFlips, Label::FlipAndGoOn)
    }

    pub(super) fn back(steps: usize) -> Self {
        let label = Label::Back { steps };
        Self {
            steps,
            ..Self::new(RemedyId::Back, label)
        }
    }

    pub(super) fn repair() -> Self {
        Self::new(RemedyId::Repair, Label::RepairAndGoOn)
    }

    pub(super) fn regularise() -> Self {
        let label = Label::RegulariseAndGoOn;
        Self::new(RemedyId::Regularise, label)
    }

    /// What a closed surface is faired by: nothing holds it, and flows of sixth order inflate
    /// it besides.
    pub(super) fn regularise_and_diffuse() -> Self {
        let label = Label::RegulariseAndDiffuse.into();
        Self {
            id: RemedyId::Regularise,
            label,
            ..Self::other_flow(FlowName::SurfaceDiffusion)
        }
    }

    pub(super) fn regularise_each_step() -> Self {
        let change = Change {
            regularise: Some(Mode::Nonlinear),
            ..Change::default()
        };
        let label = Label::RegulariseEachStep;
        Self::changing(RemedyId::RegulariseEachStep, label, change)
    }

    pub(super) fn subdivide() -> Self {
        let label = Label::SubdivideAndGoOn;
        Self::new(RemedyId::Subdivide, label)
    }

    pub(super) fn smaller_step(tau: f64) -> Self {
        let tau = CUT * tau;
        let label = Label::SetTau { tau };
        let change = Change {
            tau: Some(Some(tau)),
            dt: Some(None),
            ..Change::default()
        };
        Self::changing(RemedyId::SmallerStep, label, change)
    }

    pub(super) fn automatic_step() -> Self {
        let change = Change {
            tau: Some(None),
            dt: Some(None),
            ..Change::default()
        };
        let label = Label::AutomaticStep;
        Self::changing(RemedyId::AutomaticStep, label, change)
    }

    pub(super) fn recommended_scheme() -> Self {
        let change = Change {
            scheme: Some(Scheme::Auto),
            tau: Some(None),
            dt: Some(None),
            ..Change::default()
        };
        let label = Label::RecommendedScheme;
        Self::changing(RemedyId::RecommendedScheme, label, change)
    }

    pub(super) fn larger_epsilon(epsilon: f64) -> Self {
        let change = Change {
            epsilon: Some(epsilon),
            ..Change::default()
        };
        let label = Label::SetEpsilon { epsilon };
        Self::changing(RemedyId::LargerEpsilon, label, change)
    }

    pub(super) fn prefill() -> Self {
        let change = Change {
            prefill: Some(true),
            ..Change::default()
        };
        let label = Label::FirstGuess;
        Self::changing(RemedyId::Prefill, label, change)
    }

    pub(super) fn keep(kept: &[Kept]) -> Self {
        let change = Change {
            keep: Some(kept.to_vec()),
            ..Change::default()
        };
        let label = match kept {
            [Kept::Volume] => Label::KeepVolume,
            [Kept::Area] => Label::KeepArea,
            _ => Label::KeepBoth,
        };
        Self::changing(RemedyId::KeepVolume, label, change)
    }

    /// Of area and volume only the volume, and that where it is.
    pub(super) fn release_area() -> Self {
        let change = Change {
            keep: Some(vec![Kept::Volume]),
            reduced_volume: Some(None),
            ..Change::default()
        };
        let label = Label::KeepOnlyVolume;
        Self::changing(RemedyId::KeepVolume, label, change)
    }

    pub(super) fn exponent(p: f64) -> Self {
        let change = Change {
            p: Some(p),
            ..Change::default()
        };
        let label = Label::SmoothFirst { p };
        Self::changing(RemedyId::LowerExponent, label, change)
    }

    pub(super) fn other_flow(flow: FlowName) -> Self {
        let label = Label::UseFlow {
            flow: flow.message(),
        };
        let change = Change {
            flow: Some(flow),
            tau: Some(None),
            dt: Some(None),
            ..Change::default()
        };
        Self::changing(RemedyId::OtherFlow, label, change)
    }
}
