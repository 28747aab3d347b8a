//! What is worth telling of a run while it goes on.

use crate::message::messages;
use crate::remesh::adaptive::Soundness;

messages! {
    /// Told with a step.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub enum Warning as "warning" {
        /// The energy is near the least of any smooth surface of this topology.
        NearBound,
        /// The area has grown several times over.
        Growth,
        /// Half of the area is held by few faces.
        Balloon,
        /// W rose while the smoothed energy fell.
        ReadingRose {
            /// W before the step.
            before: f64,
            /// And after it.
            after: f64,
        },
        /// ∫H² rose over a run that was to smooth.
        Roughened {
            /// At the start.
            before: f64,
            /// Now.
            after: f64,
        },
        /// The mesh is too coarse for the curvature.
        Coarse {
            /// Where most.
            vertex: usize,
        },
        /// So much so that the surface is about to become singular.
        NearlySingular {
            /// Where most.
            vertex: usize,
        },
        /// The largest face has grown.
        LargeFace {
            /// To so many times the mean.
            times: f64,
        },
        /// The smallest angle has become small.
        Slivers {
            /// The angle.
            degrees: f64,
            /// What it was at the start.
            before: f64,
            /// What helps.
            advice: Advice,
        },
        /// Faces folded over in this step.
        FoldedFaces {
            /// How many.
            count: usize,
        },
        /// The recommended scheme would not let vertices move that far.
        FarMoves,
        /// Systems of the whole mesh are solved iteratively.
        IterativeMesh,
        /// The system of a patch is solved iteratively.
        IterativePatch,
        /// A linear system was not solved well.
        Inaccurate {
            /// Norm of what is left of the right-hand side, over its norm.
            residual: f64,
        },
        /// Too few held vertices about a patch.
        Margin {
            /// Rings that there should be.
            rings: usize,
        },
        /// The area has grown beside a boundary of which only the place is held.
        OpenBoundary {
            /// By so much.
            percent: f64,
        },
        /// Two discretisations of ∫H² disagree.
        Disagreement {
            /// By so much.
            percent: f64,
        },
        /// The mesh is too coarse or too crumpled for its readings to be believed.
        Untrusted {
            /// See [`Soundness::bend`](crate::remesh::adaptive::Soundness::bend).
            bend: f64,
            /// See [`Soundness::alignment`](crate::remesh::adaptive::Soundness::alignment).
            alignment: f64,
            /// See [`Soundness::gauss_bonnet`](crate::remesh::adaptive::Soundness::gauss_bonnet).
            topology: f64,
            /// See [`Soundness::fitted_energy`](crate::remesh::adaptive::Soundness::fitted_energy).
            energy: f64,
        },
        /// The branch of a led vesicle.
        Branch {
            /// `round`, `prolate`, `oblate` or `triaxial`.
            shape: &'static str,
            /// The middle principal length over the longest.
            middle: f64,
            /// The shortest over the longest.
            shortest: f64,
        },
        /// The step was halved for a positive definite matrix.
        HalvedStep {
            /// So many times.
            times: usize,
        },
        /// Newton's method did not converge in this step.
        NewtonFailed,
        /// Near a sphere semi-implicit steps take over.
        NearSphere,
        /// Away from one angles are smoothed again.
        AwayFromSphere,
        /// Steps gain little, so that L-BFGS takes over.
        LittleGain,
        /// The same, as they gain nothing.
        NoGain,
        /// Steps of the exact energy have come to a halt: angles are smoothed again.
        ExactHalt,
        /// W still falls: another round of L-BFGS.
        AnotherRound,
        /// The start is too rough for a flow of sixth order: surface diffusion goes before.
        RoughStart {
            /// How far it would move the surface.
            edges: f64,
            /// Steps of surface diffusion at most.
            steps: usize,
        },
        /// Back to the start, for the same.
        BackToStart {
            /// Steps of surface diffusion at most.
            steps: usize,
        },
        /// A surface on the way was better than the last, and is put in its place.
        BetterBefore,
    }
}

impl Warning {
    /// What is to be said of a mesh whose readings cannot be believed.
    pub fn of_unsound(readings: &Soundness) -> Option<Self> {
        (!readings.is_sound).then_some(Self::Untrusted {
            bend: readings.bend,
            alignment: readings.alignment,
            topology: readings.gauss_bonnet,
            energy: readings.fitted_energy,
        })
    }
}

messages! {
    /// What helps a run that can go no further, in half a sentence.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Advice as "advice" {
        /// A finer mesh.
        FinerMesh,
        /// A better mesh, by conformal regularisation.
        BetterMesh,
        /// Conformal regularisation or a finer mesh.
        RegularOrFiner,
        /// Keeping the volume of what thins out.
        KeepVolume,
        /// Smoothing with p = 2 first.
        SmoothFirst,
        /// The p-Willmore flow with p = 0.
        PWillmoreZero,
        /// Conformal regularisation or the p-Willmore flow.
        RegularOrPWillmore,
        /// A smooth first guess, a finer mesh or a flow of lower order.
        FirstGuess,
    }
}

/// Which warnings a run has given.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct WarningsGiven(u64);

impl WarningsGiven {
    fn bit(warning: &Warning) -> u64 {
        let kind = crate::message::Say::kind(warning);
        let place = Warning::MESSAGES.iter().position(|(name, _)| *name == kind);
        1 << place.unwrap_or_default()
    }

    /// Whether a warning of this kind has been given.
    pub fn was_given(self, warning: &Warning) -> bool {
        self.0 & Self::bit(warning) != 0
    }

    /// Adds the warning unless one of its kind has been given.
    pub fn give_once(&mut self, warning: Warning, warnings: &mut Vec<Warning>) {
        if !self.was_given(&warning) {
            self.0 |= Self::bit(&warning);
            warnings.push(warning);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_warning_is_given_once_whatever_its_values() {
        // One bit a kind.
        assert!(Warning::MESSAGES.len() <= 64);
        let (mut given, mut warnings) = (WarningsGiven::default(), Vec::new());
        for percent in [6.0, 7.0] {
            given.give_once(Warning::Disagreement { percent }, &mut warnings);
        }
        given.give_once(Warning::Growth, &mut warnings);
        assert_eq!(
            warnings,
            [Warning::Disagreement { percent: 6.0 }, Warning::Growth]
        );
        assert!(given.was_given(&Warning::Growth) && !given.was_given(&Warning::NearBound));
    }
}
