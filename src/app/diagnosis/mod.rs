//! Why did this happen? One message, the elements at fault, and what helps.
//!
//! Told of the state as it is, the last reports and the geometry, when asked. Where nothing
//! is wrong there is nothing to tell; a run that has converged needs no reason, unless its
//! energy is one that no smooth surface has.

mod context;
mod elements;
mod remedy;
mod stop;
mod surface;

pub use remedy::{Change, Label, Remedy, RemedyId};

use super::Session;
use super::fault::Fault;
use super::runner::Runner;
use crate::arrays::TypedArray;
use crate::flow::Status;
use crate::message::{Message, Say, messages};
use serde::Serialize;

messages! {
    /// What is the matter.
    #[derive(Clone, Debug, PartialEq)]
    pub enum Symptom as "symptom" {
        /// Trial steps were refused and a shorter one taken: nothing is wrong.
        RejectedSteps {
            /// In this step.
            step: usize,
            /// So many.
            count: usize,
            /// The step size taken, without a unit.
            tau: f64,
            /// The vertex that the last of them would have moved most.
            vertex: u32,
        },
        /// A step of the paper's scheme was halved for a definite matrix: it goes on.
        HalvedStep {
            /// The step.
            step: usize,
            /// So many times.
            count: usize,
            /// The step size taken, without a unit.
            tau: f64,
        },
        /// Every trial step was refused.
        RefusedSteps {
            /// Kind of the last one's [`Cause`](crate::flow::Cause).
            cause: &'static str,
            /// The vertex that it would have moved most.
            vertex: u32,
            /// The face that it would have turned most.
            face: Option<u32>,
        },
        /// No step descends, as circle angles are exactly 0: four points on a circle, where the
        /// energy has the tip of a cone.
        CocircularKink {
            /// Such edges.
            count: usize,
            /// The angle smoothing.
            epsilon: f64,
        },
        /// Steps too long for a scheme that does not test for descent.
        RisingEnergy {
            /// The least energy of the last steps.
            least: f64,
            /// The energy now.
            energy: f64,
            /// The step size, without a unit.
            tau: f64,
            /// The vertex that the last step moved most.
            vertex: u32,
            /// By so many edge lengths.
            moved: f64,
            /// Times that the step was halved for a definite matrix.
            halved: usize,
        },
        /// A neck thinner than the mesh can show.
        Pinch {
            /// Where.
            vertex: u32,
            /// Radius of the neck.
            width: f64,
            /// Edges that have room around it.
            edges: f64,
        },
        /// A free surface swells under an energy that does not depend on size.
        Inflating {
            /// To so many times its area.
            times: f64,
            /// The face with the smallest angle.
            face: u32,
            /// That angle, in degrees.
            angle: f64,
        },
        /// The energy falls as the whole surface grows, for p > 2.
        Growing {
            /// The exponent.
            p: f64,
            /// To so many times its area.
            times: f64,
        },
        /// The same as it shrinks, for p < 2.
        Shrinking {
            /// The exponent.
            p: f64,
            /// To its area over this.
            times: f64,
        },
        /// An angle near 0.
        DegenerateFaces {
            /// The face.
            face: u32,
            /// The angle, in degrees.
            angle: f64,
            /// The smallest angle at the start.
            before: f64,
        },
        /// Faces that lie against their neighbours.
        FoldedFaces {
            /// How many.
            count: usize,
            /// The first.
            face: u32,
        },
        /// Less energy than any smooth surface of that topology has.
        BelowSmoothMinimum {
            /// The energy.
            energy: f64,
            /// What smooth surfaces have at least.
            smooth: f64,
            /// The vertex of the sharpest bend.
            vertex: u32,
        },
        /// Triangles without area, from which no first step led on.
        FlatFaces {
            /// How many.
            count: usize,
            /// The first.
            face: u32,
        },
        /// The mesh shows less energy than that before the first step.
        Unresolved,
        /// A mesh whose readings cannot be believed.
        Untrusted {
            /// See [`Soundness::bend`](crate::remesh::adaptive::Soundness::bend).
            bend: f64,
            /// See [`Soundness::alignment`](crate::remesh::adaptive::Soundness::alignment).
            alignment: f64,
            /// See [`Soundness::gauss_bonnet`](crate::remesh::adaptive::Soundness::gauss_bonnet).
            topology: f64,
            /// See [`Soundness::fitted_energy`](crate::remesh::adaptive::Soundness::fitted_energy).
            energy: f64,
            /// The sharpest point.
            vertex: u32,
        },
        /// A large exponent on a rough surface.
        LargeExponent {
            /// The exponent.
            p: f64,
            /// The sharpest point.
            vertex: u32,
        },
        /// A flow of high order on a rough surface.
        TooRough {
            /// After so many steps.
            steps: usize,
            /// Vertices are still to move by so many edge lengths.
            update: f64,
            /// The vertex that the last step moved most.
            vertex: u32,
        },
        /// No quadratic surface fits about a vertex.
        Unfit {
            /// The vertex.
            vertex: u32,
        },
        /// The budget of steps is used up, and the energy falls.
        StepLimit {
            /// Steps taken.
            steps: usize,
            /// Fall of the energy in the last one.
            percent: f64,
            /// The vertex that it moved most.
            vertex: u32,
        },
        /// The budget of steps is used up, and the energy does not fall.
        NotAtRest {
            /// Steps taken.
            steps: usize,
            /// The vertex that the last one moved most.
            vertex: u32,
        },
    }
}

/// What is the matter, where, and what helps.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Diagnosis {
    /// What it is: name of a [`Symptom`].
    pub kind: &'static str,
    /// The same, to be said in one sentence.
    pub message: Message,
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
    fn new(symptom: &Symptom) -> Self {
        Self {
            kind: symptom.kind(),
            message: symptom.message(),
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
        Ok(self.runner()?.why())
    }
}

impl Runner {
    fn why(&self) -> Option<Diagnosis> {
        let flow = self.engine.as_ref().filter(|flow| flow.flips().is_none())?;
        let status = self.state.status;
        if status == Status::Ready && self.segment_reports().is_empty() {
            return None;
        }
        if status == Status::Converged {
            return self.below_minimum().or_else(|| self.untrusted());
        }
        let stopped = status == Status::Stalled || status.is_breakdown();
        let pinched = || {
            (status == Status::Singular)
                .then(|| self.pinch(true))
                .flatten()
        };
        self.flat_faces()
            .or_else(|| self.cocircular(flow))
            .or_else(|| self.rising())
            .or_else(pinched)
            .or_else(|| self.scaling())
            .or_else(|| self.pinch(stopped))
            .or_else(|| self.inflating())
            .or_else(|| self.below_minimum())
            .or_else(|| self.unresolved())
            .or_else(|| self.failed())
            .or_else(|| self.too_rough())
            .or_else(|| self.folded_over(flow))
            .or_else(|| self.degenerate())
            .or_else(|| match status {
                Status::StepLimit => self.step_limit(),
                _ if stopped => self.refused(flow),
                _ => None,
            })
            .or_else(|| self.untrusted())
            .or_else(|| self.rejected(flow))
            .or_else(|| self.halved())
    }
}
