//! Better meshes of the same surface, and surfaces where there were holes.

pub mod adaptive;
pub mod conformal;
pub mod fill;
pub mod flips;
pub mod repair;
pub mod static_pass;

pub use conformal::{Mode, Regulariser};
