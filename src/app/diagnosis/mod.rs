//! Why did this happen? One sentence, the elements at fault, and what helps.
//!
//! Told of the state as it is, the last reports and the geometry, when asked. Where nothing
//! is wrong there is nothing to tell; a run that has converged needs no reason, unless its
//! energy is one that no smooth surface has.

mod context;
mod elements;
mod remedy;
mod stop;
mod surface;
mod text;

pub use remedy::{Change, Remedy, RemedyId};
pub use text::Text;

use super::Session;
use super::fault::Fault;
use super::work::Work;
use crate::arrays::TypedArray;
use crate::flow::Status;
use serde::Serialize;

/// What is the matter.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub enum DiagnosisKind {
    /// Trial steps were refused and a shorter one taken: nothing is wrong.
    RejectedSteps,
    /// Every trial step was refused.
    RefusedSteps,
    /// No step descends, as circle angles are exactly 0: four points on a circle, where the
    /// energy has the tip of a cone.
    CocircularKink,
    /// Steps too long for a scheme that does not test for descent.
    RisingEnergy,
    /// A neck thinner than the mesh can show.
    Pinch,
    /// A free surface swells under an energy that does not depend on size.
    Inflating,
    /// The energy falls as the whole surface grows, for p > 2.
    Growing,
    /// The same as it shrinks, for p < 2.
    Shrinking,
    /// An angle near 0.
    DegenerateFaces,
    /// Faces that lie against their neighbours.
    FoldedFaces,
    /// Less energy than any smooth surface of that topology has.
    BelowSmoothMinimum,
    /// Exponent or flow of high order on a rough surface.
    TooRough,
    /// No quadratic surface fits about a vertex.
    Unfit,
    /// The budget of steps is used up.
    StepLimit,
}

/// What is the matter, where, and what helps.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Diagnosis {
    /// What it is.
    pub kind: DiagnosisKind,
    /// The same in one sentence.
    pub sentence: Text,
    /// Vertices at fault.
    pub vertices: TypedArray<u32>,
    /// Triangles at fault.
    pub faces: TypedArray<u32>,
    /// Two ends an edge at fault.
    pub edges: TypedArray<u32>,
    /// What helps, the best first; three at most.
    pub remedies: Vec<Remedy>,
}

impl Diagnosis {
    fn new(kind: DiagnosisKind, sentence: Text) -> Self {
        Self {
            kind,
            sentence,
            vertices: TypedArray::default(),
            faces: TypedArray::default(),
            edges: TypedArray::default(),
            remedies: Vec::new(),
        }
    }

    fn at_vertices(mut self, vertices: impl IntoIterator<Item = u32>) -> Self {
        self.vertices.extend(vertices);
        self
    }

    fn at_faces(mut self, faces: impl IntoIterator<Item = u32>) -> Self {
        self.faces.extend(faces);
        self
    }

    /// Those of the remedies that apply, as many as a person will look at.
    fn with(mut self, remedies: impl IntoIterator<Item = Option<Remedy>>) -> Self {
        self.remedies = remedies.into_iter().flatten().take(3).collect();
        self
    }
}

impl Session {
    /// Why the flow stands as it does; `None` where nothing is wrong.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn why(&self) -> Result<Option<Diagnosis>, Fault> {
        Ok(self.work()?.why())
    }
}

impl Work {
    fn why(&self) -> Option<Diagnosis> {
        let flow = self.flow.as_ref().filter(|flow| flow.flips().is_none())?;
        let status = self.state.status;
        if status == Status::Ready && self.course_reports().is_empty() {
            return None;
        }
        if status == Status::Converged {
            return self.below_minimum();
        }
        let stopped = status == Status::Stalled || status.is_breakdown();
        let pinched = || {
            (status == Status::Singular)
                .then(|| self.pinch(true))
                .flatten()
        };
        self.cocircular(flow)
            .or_else(|| self.rising())
            .or_else(pinched)
            .or_else(|| self.scaling())
            .or_else(|| self.pinch(stopped))
            .or_else(|| self.inflating())
            .or_else(|| self.below_minimum())
            .or_else(|| self.failed())
            .or_else(|| self.too_rough())
            .or_else(|| self.folded_over(flow))
            .or_else(|| self.degenerate())
            .or_else(|| match status {
                Status::Stalled | Status::Singular | Status::Collapsed => self.refused(flow),
                Status::StepLimit => self.step_limit(),
                _ => self.rejected(flow),
            })
    }
}
