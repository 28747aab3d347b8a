//! The two halves of a film: runs from the two surfaces of a figure, of which the first is shown
//! backwards. One is at hand, the other waits with all its steps; turning exchanges them.

use super::crossing;
use super::fault::Fault;
use super::library::{Figure, Parameters};
use super::message::AppError;
use super::readings::State;
use super::runner::{Runner, Suspended};
use super::{Session, library};
use crate::mesh::HalfedgeMesh;
use crate::remesh::adaptive::alignment;
use glam::DVec3;

/// The half that waits.
#[derive(Default)]
pub(super) struct OtherHalf {
    waiting: Option<Suspended>,
    /// Whether it is the second, and the first at hand.
    is_second: bool,
}

impl Session {
    /// Goes over to the other half of a figure that has two, where it was left; the first time to
    /// the start of the one that is shown backwards, under the options in force. Another mesh, a
    /// flow from the start or an edit forgets it.
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
        let other = match self.other_half.waiting.take() {
            Some(half) => half.resume(),
            None => self.half_of(found, over)?,
        };
        let state = other.state.clone();
        let here = self.runner.replace(other);
        self.other_half = OtherHalf {
            waiting: here.map(Runner::suspend),
            is_second: !self.other_half.is_second,
        };
        self.settle_panes();
        Ok(state)
    }

    /// A step of the half at hand as one of the film: negative in the half that is shown backwards.
    pub(super) fn signed(&self, step: usize) -> i32 {
        let step = i32::try_from(step).unwrap_or(i32::MAX);
        if self.other_half.is_second {
            -step
        } else {
            step
        }
    }

    fn half_of(&self, figure: &Figure, over: Parameters) -> Result<Runner, Fault> {
        let options = self.runner()?.options().clone();
        let sample = figure.sample().ok_or_else(Fault::no_mesh)?;
        let mut other = Self::new();
        sample.load(&mut other, over)?;
        other.configure(options)?;
        other.runner.ok_or_else(Fault::no_mesh)
    }

    /// The run of the sample itself, and that which is shown backwards, where there is one.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub(super) fn halves(&self) -> Result<[Option<&Runner>; 2], Fault> {
        let here = Some(self.runner()?);
        let other = self.other_half.waiting.as_ref().map(|half| &half.runner);
        Ok(if self.other_half.is_second {
            [other, here]
        } else {
            [here, other]
        })
    }
}

impl Runner {
    /// Least product of a unit face normal with a unit normal at its corners, on every stored
    /// surface of the path.
    pub(super) fn least_alignment(&self) -> f64 {
        self.stored(alignment).fold(f64::INFINITY, f64::min)
    }

    /// Largest number of pairs of triangles that cross, likewise.
    pub(super) fn most_crossings(&self) -> usize {
        let counts = self.stored(|mesh, x| crossing::count(mesh, x).unwrap_or(0));
        counts.max().unwrap_or(0)
    }

    /// What is measured on every stored surface of the path, and on the present one.
    fn stored<'a, T: 'a>(
        &'a self,
        measure: impl Fn(&HalfedgeMesh, &[DVec3]) -> T + 'a,
    ) -> impl Iterator<Item = T> + 'a {
        let before = self.history.path().filter_map(|snapshot| {
            let remade = snapshot.segment.remade.as_ref();
            let mesh = remade.map_or(&self.document.triangles, |remade| &remade.mesh);
            Some((&**mesh, snapshot.x.as_deref()?))
        });
        let present = std::iter::once((self.triangles(), &*self.x));
        before.chain(present).map(move |(mesh, x)| measure(mesh, x))
    }
}
