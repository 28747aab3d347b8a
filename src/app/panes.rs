//! Flows side by side: the same surface under each of the flows by mean curvature and its
//! derivatives, each a runner of its own that is kept at the step of the first (Xu & Zhang,
//! figures 5.5 and 5.6).

use super::arrangement::Compare;
use super::fault::Fault;
use super::runner::Runner;
use super::segment::Segment;
use crate::flow::options::FlowOptions;
use crate::flow::spec::{self, Family, FlowName};
use std::rc::Rc;

/// Steps that the others still take after the first has come to rest.
const FURTHER: usize = 60;

/// The flows beside the first.
#[derive(Default)]
pub(super) struct Panes {
    /// The start of the run that the others were made for.
    run: Option<Rc<Segment>>,
    others: Vec<Runner>,
}

/// The options of those beside a flow of `options`: all by mean curvature and its derivatives,
/// where it is one of them.
fn others_of(options: &FlowOptions) -> Vec<FlowOptions> {
    let is_one = |flow: FlowName| spec::of(flow).family == Family::Curvature;
    if !is_one(options.flow) {
        return Vec::new();
    }
    let others = FlowName::all().filter(|flow| *flow != options.flow && is_one(*flow));
    // What means nothing to another flow is at its default there; the boundary is not.
    let like = |flow| FlowOptions {
        boundary: options.boundary,
        ..options.with_flow(flow)
    };
    others.map(like).collect()
}

impl Panes {
    /// Those beside the first.
    pub(super) fn others(&self) -> &[Runner] {
        &self.others
    }

    /// Forgets them, as the mesh is another.
    pub(super) fn clear(&mut self) {
        *self = Self::default();
    }

    /// Takes the others to where the first is now; makes those that are missing.
    pub(super) fn settle(&mut self, first: &Runner) {
        if first.engine.is_none() || first.arrangement.compare != Compare::Flows {
            return self.clear();
        }
        let is_made = (self.run.as_ref()).is_some_and(|run| Rc::ptr_eq(run, &first.first));
        if !is_made {
            // What the first takes, the others take, or they are not there.
            let others = others_of(first.options()).into_iter();
            self.others = others.filter_map(|own| start(first, own).ok()).collect();
            self.run = Some(Rc::clone(&first.first));
        }
        let is_over = first.state.status.is_final();
        // To its rest when the first is at its own.
        let goal = first.state.step + if is_over { FURTHER } else { 0 };
        for other in &mut self.others {
            bring_to(other, goal);
        }
    }
}

fn start(first: &Runner, options: FlowOptions) -> Result<Runner, Fault> {
    let document = first.document.clone();
    let start = document.start.clone();
    let mut runner = Runner::new(document, start);
    runner.configure(options)?;
    Ok(runner)
}

fn bring_to(runner: &mut Runner, goal: usize) {
    runner.seek(goal);
    while runner.state.step < goal && !runner.state.status.is_final() {
        // A failure ends it, and its state says so.
        if !matches!(runner.step(), Ok(Some(_))) {
            break;
        }
    }
}
