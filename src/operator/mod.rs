//! Discrete differential operators on surfaces.

pub mod element;
pub mod laplacian;

pub use element::{Elements, Node};
pub use laplacian::Laplacian;
