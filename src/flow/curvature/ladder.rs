//! From a rough start the sixth-order flow finds no way: some steps of surface diffusion go
//! before, as on a ladder.

use super::law::Law;
use super::{CurvatureFlow, NEARLY_AT_REST};
use crate::flow::options::Scheme;
use crate::flow::{Cost, FlowError, Occasion, Phase, Warning};
use glam::DVec3;
use std::rc::Rc;

/// A first update of the sixth-order flow longer than so many edges comes from a start too
/// rough for it …
const ROUGH: f64 = 8.0;
/// … and up to this many steps of surface diffusion go before.
const RUNGS: usize = 40;
/// Surface diffusion has done its part when no vertex moves by more than this share of an
/// edge.
const RUNG_REST: f64 = 1e-2;

/// Where a run stands on it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ladder {
    /// Steps of surface diffusion still to be taken first.
    rungs: usize,
    /// Whether it was used, or may not be.
    has_climbed: bool,
    /// Whether the start was looked at.
    has_looked: bool,
}

impl Ladder {
    /// Of a law, with so many rungs if that is asked for.
    pub(super) fn new(law: Law, rungs: Option<usize>) -> Self {
        let is_own = law == Law::CurvatureVariation;
        Self {
            rungs: rungs.filter(|_| is_own).unwrap_or(0),
            has_climbed: !is_own || rungs.is_some(),
            has_looked: false,
        }
    }

    pub(super) fn is_climbing(&self) -> bool {
        self.rungs > 0
    }
}

impl CurvatureFlow {
    pub(super) fn climb_or_descend(
        &mut self,
        x: &[DVec3],
        occasion: &Occasion,
        cost: &mut Cost,
    ) -> Result<Option<Phase>, FlowError> {
        let may_climb = !self.ladder.has_climbed && self.options.scheme == Scheme::Auto;
        let is_own = self.law == Law::CurvatureVariation && !self.is_paper();
        match occasion {
            Occasion::Before if may_climb && !self.ladder.has_looked => {
                self.ladder.has_looked = true;
                let size = self.whole_size(x, cost)?;
                let event = Warning::RoughStart {
                    edges: size,
                    steps: RUNGS,
                };
                Ok((size > ROUGH).then(|| self.climb(event, None)))
            }
            Occasion::Accepted { .. } if self.ladder.is_climbing() => {
                self.ladder.rungs -= 1;
                if self.size < RUNG_REST {
                    self.ladder.rungs = 0;
                }
                if self.ladder.is_climbing() {
                    return Ok(None);
                }
                Ok(Some(self.top_reached(x)))
            }
            // No rung leads on.
            Occasion::Stuck { .. } if self.ladder.is_climbing() => {
                self.ladder.rungs = 0;
                Ok(Some(self.top_reached(x)))
            }
            Occasion::Idle { .. } | Occasion::Stuck { .. } if may_climb => {
                let size = self.rest_size(x, cost)?;
                if size <= NEARLY_AT_REST {
                    return Ok(None);
                }
                let start = self.start.clone();
                self.reached = Some(Rc::new(x.to_vec()));
                Ok(Some(
                    self.climb(Warning::BackToStart { steps: RUNGS }, Some(start)),
                ))
            }
            Occasion::Ending { is_at_rest } if is_own => {
                Ok(self.better_than(x, *is_at_rest).map(|from| {
                    self.forget();
                    Phase {
                        from: Some(from),
                        event: Some(Warning::BetterBefore),
                        ..Phase::default()
                    }
                }))
            }
            _ => Ok(None),
        }
    }

    /// The flow's own law goes on from here.
    fn top_reached(&mut self, x: &[DVec3]) -> Phase {
        self.top = Some(Rc::new(x.to_vec()));
        self.known = None;
        Phase {
            resets_step_size: true,
            ..Phase::default()
        }
    }

    fn climb(&mut self, event: Warning, from: Option<Vec<DVec3>>) -> Phase {
        self.ladder.rungs = RUNGS;
        self.ladder.has_climbed = true;
        self.known = None;
        if from.is_some() {
            self.forget();
        }
        Phase {
            from,
            resets_step_size: true,
            event: Some(event),
            ..Phase::default()
        }
    }
}
