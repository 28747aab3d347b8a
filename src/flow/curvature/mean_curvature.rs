//! Flow by mean curvature, V = −H: decreases the area fastest.
//!
//! In the paper's sign of H the velocity is +H.

use super::velocity::Velocity;

/// V_i = −H_i.
pub(super) fn linearise(i: usize, velocity: &mut Velocity) {
    velocity.add(i as u32, -1.0);
}
