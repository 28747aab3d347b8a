//! The two halves of a film: runs from the two surfaces of a figure, of which the first is shown
//! backwards. One is at hand, the other waits with all its steps; turning exchanges them.

use super::fault::Fault;
use super::library::{Figure, Parameters};
use super::message::AppError;
use super::readings::State;
use super::runner::{Runner, Suspended};
use super::{Session, library};
use crate::flow::options::FlowOptions;

/// The half that waits.
#[derive(Default)]
pub(super) struct OtherHalf(Option<Suspended>);

impl Session {
    /// Goes over to the other half of a figure that has two, where it was left; the first time to
    /// its start, under the options in force. Another mesh or an edit forgets it.
    ///
    /// # Errors
    /// `UnknownFigure`: none of that name has two halves. Options that its surface refuses; nothing
    /// has changed then.
    pub fn turn(&mut self, figure: &str) -> Result<State, Fault> {
        let unknown = || AppError::UnknownFigure {
            name: figure.into(),
        };
        let found = library::figure(figure).ok_or_else(unknown)?;
        let over = found.back.ok_or_else(unknown)?;
        let other = match self.other_half.0.take() {
            Some(half) => half.resume(self.progress.clone()),
            None => self.half_of(found, over)?,
        };
        let state = other.state.clone();
        let here = self.runner.replace(other);
        self.other_half.0 = here.map(Runner::suspend);
        self.settle_panes();
        Ok(state)
    }

    fn half_of(&self, figure: &Figure, over: Parameters) -> Result<Runner, Fault> {
        let options: FlowOptions = self.runner()?.options().clone();
        let sample = figure.sample().ok_or_else(Fault::no_mesh)?;
        let mut other = Self::new();
        sample.load(&mut other, over)?;
        other.progress.clone_from(&self.progress);
        other.configure(options)?;
        other.runner.ok_or_else(Fault::no_mesh)
    }
}
