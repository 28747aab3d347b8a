//! Flows: an energy plus an integrator.
//!
//! Step-size control, stopping rules, selections and reports are written once here and
//! shared; a flow's own folder holds only its system.

pub mod boundary;
pub mod circle;
pub mod error;
pub mod options;
pub mod prefill;
pub mod report;
pub mod step_size;
pub mod stop;

pub use error::FlowError;
pub use report::{Status, StepReport};

/// A callback for progress within long steps: the stage's name and the share done.
pub type Progress = std::rc::Rc<dyn Fn(&str, f64)>;
