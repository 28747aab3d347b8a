//! Lengths, angles, areas, normals and curvatures of a surface with positions.
//!
//! Conventions: outward normals on closed surfaces; H = (κ₁+κ₂)/2, positive on a
//! sphere; K Gaussian. Names say `integrated_` or `pointwise_` where both exist.

pub mod bend;
pub mod circumcircle;
pub mod curvature;
pub mod face_tree;
pub mod frame;
pub mod inversion;
pub mod measure;
pub mod nearest;
pub mod parts;
pub mod quality;
pub mod self_intersection;
pub mod survey;
pub mod upright;
