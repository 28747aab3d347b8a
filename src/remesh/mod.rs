//! Better meshes of the same surface.

pub mod conformal;
pub mod flips;
pub mod static_pass;

pub use conformal::{Mode, Regulariser};
