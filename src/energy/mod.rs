//! Energies: functions of connectivity and positions with value and gradient.
//!
//! One file or folder an energy; none knows a flow.

pub mod circle;
pub mod conformal;
pub mod curvature_jump;
pub mod p_willmore;
pub mod total_curvature;
