//! How far an iteration came.

/// Result of an iterative solve.
#[derive(Clone, Copy, Debug)]
pub struct Convergence {
    /// Number of iterations, each with one product with the matrix.
    pub iterations: usize,
    /// `‖b − A x‖ / ‖b‖`, of several fields the largest.
    pub relative_residual: f64,
}
