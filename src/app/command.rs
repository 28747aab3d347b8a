//! What may be asked of the application, and what it answers: the one seam to JavaScript
//! beside [`Frame`](super::Frame).
//!
//! In two enums, as the program comes to a browser in two parts (see [`deferred`](crate::deferred)):
//! what the first picture and a run need, and whatever else can be done with a surface.

mod run;
mod tool;

pub use run::{RunAnswer, RunCommand};
pub use tool::{ToolAnswer, ToolCommand};
