//! Discrete differential operators on surfaces.

pub mod dual;
pub mod element;
pub mod fitted;
pub mod laplacian;
pub mod mass;
pub mod polyharmonic;

pub use dual::{Dual, DualVec};
pub use element::{Elements, Node};
pub use fitted::FittedOperators;
pub use laplacian::Laplacian;
pub use mass::{Mass, MassMatrix};
