//! What the driver sees to, by flow and phase.

/// Which folded faces a step may leave behind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Folds {
    /// None: a smaller step is taken.
    None,
    /// Few; a sliver may fold at any step size, so a step is refused for it only a few times.
    Few,
    /// Any.
    Any,
}

/// By how much the functional may lie above what it was.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Ceiling {
    /// Not at all: each step descends.
    Descent,
    /// Not above the last value, or above this, below which it cannot be told from zero: for
    /// functionals whose discrete reading is not quite what the discrete flow descends, so that
    /// no slope says by how much they should fall.
    NoRise(f64),
    /// Up to this value.
    Below(f64),
    /// By anything.
    None,
}

/// What is tested of a trial, and what ends a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rules {
    /// How the functional may change.
    pub ceiling: Ceiling,
    /// A vertex moves at most so many mean lengths of its edges.
    pub reach: Option<f64>,
    /// A face turns at most by the angle of this cosine.
    pub turn: Option<f64>,
    /// Folded faces.
    pub folds: Folds,
    /// The angle in degrees below which no triangle may become worse, if it is a good mesh.
    pub least_angle: Option<f64>,
    /// The least value that a theorem leaves to [`Flow::bounded`](super::Flow::bounded) on
    /// smooth surfaces, and the share of it that healthy meshes come down to.
    pub bound: Option<f64>,
    /// See there.
    pub bound_share: f64,
    /// A predicted change smaller than this drowns in roundoff.
    pub roundoff: f64,
    /// A functional below this is zero.
    pub zero: f64,
    /// Whether the surface can shrink to a point.
    pub can_vanish: bool,
    /// Whether the surface grows without end, as a larger one of any shape has less of the functional.
    pub grows: bool,
    /// Whether a run ends at rest; if not, after a set number of steps.
    pub ends_at_rest: bool,
    /// Share of the functional by which it must fall in ten steps: less is a sign of rest. `None`
    /// where nothing is.
    pub idle: Option<f64>,
    /// A gain in a longer step than this counts by so much of it only: at rest the steps become
    /// as long as one likes, and a mesh still creeps.
    pub long_dt: f64,
}

/// What falls by less than this share of itself in ten steps has stopped falling.
pub const NEGLIGIBLE: f64 = 1e-5;

impl Rules {
    /// Of a scheme that is taken as it is printed.
    pub fn unseen() -> Self {
        Self {
            ceiling: Ceiling::None,
            reach: None,
            turn: None,
            folds: Folds::Any,
            least_angle: None,
            bound: None,
            bound_share: 1.0,
            roundoff: 0.0,
            zero: 0.0,
            can_vanish: false,
            grows: false,
            ends_at_rest: true,
            idle: None,
            long_dt: f64::INFINITY,
        }
    }
}
