//! Willmore-type geometric flows on polygon meshes, for the browser and the command line.
//!
//! # The mathematics on one page
//!
//! The Willmore energy of a surface,
//!
//! ```math
//! \int (H^2 - K) \, dA = \tfrac14 \int (\kappa_1 - \kappa_2)^2 \, dA,
//! ```
//!
//! measures how far it is from being umbilic, that is from being a sphere at every point. Bobenko &
//! Schröder's discrete version sums the intersection angles β of the circumcircles of
//! neighbouring triangles:
//!
//! ```math
//! W_i = \sum_{\text{edges at } i} \beta - 2\pi, \qquad W = \sum_i W_i.
//! ```
//!
//! Like the smooth energy it is invariant under Möbius transformations, never negative,
//! and zero on a sphere. Its gradient flow, dx/dt = −∇W, is stepped semi-implicitly with
//! the matrix K for which ∇W = K x.
//!
//! Gruber & Aulisa take powers of the mean curvature,
//!
//! ```math
//! W^p = \int |Y|^p \, dA, \qquad Y = \Delta x = -2 H n,
//! ```
//!
//! discretised by finite elements: Y_i = −s_i/m_i with s_i the area gradient and m_i the lumped
//! mass of a vertex. The flow dx/dt = −∇W^p, for p = 0 the mean-curvature flow, may keep area and
//! volume; vertices then slide along the surface towards a conformal mesh. With p = 0 and the
//! volume kept it is Huisken's volume-preserving mean-curvature flow, dx/dt = 2(H̄ − H)n with H̄
//! the mean of H by area.
//!
//! Xu & Zhang join patches with continuous curvature by the gradient flow of
//!
//! ```math
//! F = \int |\nabla H|^2 \, dA,
//! ```
//!
//! of sixth order, beside the flows by mean curvature, by surface diffusion, V = ΔH, and by
//! the Willmore energy, V = ΔH + 2H(H² − K). Their operators come from quadratic fits.
//! Vertices move along their normals with the speed V.
//!
//! # Conventions
//!
//! | quantity | convention |
//! | --- | --- |
//! | orientation | outward normals on closed surfaces |
//! | mean curvature | H = (κ₁ + κ₂)/2, positive on a sphere with outward normal; Δx = −2Hn |
//! | Gaussian curvature | K; the matrix of the circle flow is also called K, as in the paper |
//! | circle energy | W = Σ W_i as printed; W/2 tends to ∫(H² − K) dA on curvature-aligned lattices only |
//! | p-Willmore readings | ∫\|H\|^p dA; with the paper's Y = 2Hn, W^p is 2^p times that |
//! | Laplacian | positive semi-definite cotangent stiffness |
//! | step size | raw dt, and scale-free τ: dt/h² with h the mean edge length at the start, or dt/L^(p+2) with L = √(A/4π); flows of order k by mean curvature and its derivatives: dt/L^k with L² the area of a free patch |
//! | velocity | V along the outward normal; a sphere shrinks where V = −H |
//! | reductions of edge flips | f(e) = before − after: positive is an improvement |
//! | multipliers | at rest ∇∫\|H\|^p + tension ∇A − pressure ∇V = 0 |
//! | indices | vertices and faces count from 0, in the order of the file |
//!
//! # Modules
//!
//! Dependencies point one way: `mesh ← geometry ← operator ← energy ← remesh ← flow ←
//! app ← web`; `io` and `viewer` stand beside and know no flow; `soup` is what `io` and
//! `mesh` share; `linalg` knows vectors only;
//! `order` sorts for all.
//!
//! # References
//!
//! Keys like [BS05](bibliography#bs05) are those of the [`bibliography`].

#[macro_use]
pub mod deferred;
#[cfg(feature = "solver")]
pub mod app;
#[cfg(feature = "solver")]
pub mod arrays;
pub mod bibliography;
#[cfg(feature = "solver")]
pub mod energy;
#[cfg(feature = "solver")]
pub mod flow;
#[cfg(feature = "solver")]
pub mod geometry;
pub mod interrupt;
#[cfg(feature = "solver")]
pub mod io;
#[cfg(feature = "solver")]
pub mod linalg;
pub mod mesh;
pub mod message;
#[cfg(feature = "solver")]
pub mod operator;
pub mod order;
#[cfg(feature = "solver")]
pub mod remesh;
pub mod soup;
pub mod viewer;
pub mod web;
