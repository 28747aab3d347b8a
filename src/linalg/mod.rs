//! Sparse symmetric linear systems `A X = B`, solved directly, thin over `faer`, or on large
//! meshes by conjugate gradients with a [multigrid](Multigrid) preconditioner.
//!
//! The flows meet the same connectivity step after step with new numbers, so the
//! work is split by what it depends on:
//!
//! | depends on | type | cost at 37,000 vertices, browser |
//! | --- | --- | --- |
//! | connectivity | [`Pattern`], [`Symbolic`] | 120 ms, once |
//! | the matrix | [`Ldlt::factor`] | 240 ms |
//! | the right-hand side | [`Ldlt::solve_in_place`] | 25 ms for three columns |
//!
//! [`Solver`] puts them together and decides which costs less.
//!
//! Matrices are scalar, `n × n`. Most act on each coordinate alike: a *field* is then one
//! vector a vertex, `n` values of [`glam::DVec3`], and stands for three columns; where
//! the matrix couples coordinates a field is `n` plain numbers (see [`Entry`]).
//! Several fields are stored end to end. Everything runs on one thread: triangular
//! solves get slower with two.

mod convergence;
pub mod eigen;
mod entry;
mod error;
mod gmres;
mod ldlt;
mod lu;
mod multigrid;
mod ordering;
mod pattern;
mod pcg;
mod solver;
mod supernodal;
mod symbolic;
mod vertex_cover;

pub use convergence::Convergence;
pub use entry::Entry;
pub use error::LinalgError;
pub use gmres::gmres;
pub use ldlt::{Inertia, Ldlt};
pub use lu::{Lu, Unsymmetric};
pub use multigrid::Multigrid;
pub use pattern::Pattern;
pub use pcg::{LinearSystem, Workspace, conjugate_gradients};
pub use solver::{Method, SolveInfo, Solver};
pub use symbolic::{Ordering, Symbolic};

/// Whether the dense products inside the factorisation run their SIMD kernel.
///
/// In wasm that kernel is off unless the crate is compiled with `simd128` *and*
/// `gemm`'s feature `wasm-simd128-enable`; a dropped feature costs a factor 1.5 to 2
/// and nothing else shows it. Natively the kernel is chosen from the processor and the
/// answer is always `true`.
pub fn simd_enabled() -> bool {
    !cfg!(target_arch = "wasm32") || (cfg!(target_feature = "simd128") && gemm::get_wasm_simd128())
}
