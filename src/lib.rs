//! Willmore-type geometric flows on polygon meshes, for the browser and the command line.
//!
//! # The mathematics on one page
//!
//! The Willmore energy of a surface, ∫ (H² − K) dA = ¼ ∫ (κ₁ − κ₂)² dA, measures how far
//! it is from being umbilic, that is from being a sphere at every point. Bobenko &
//! Schröder's discrete version sums the intersection angles β of the circumcircles of
//! neighbouring triangles:
//!
//! ```text
//! W_i = Σ_{edges at i} β − 2π,       W = Σ_i W_i.
//! ```
//!
//! Like the smooth energy it is invariant under Möbius transformations, never negative,
//! and zero on a sphere. Its gradient flow, dx/dt = −∇W, is stepped semi-implicitly with
//! the matrix K for which ∇W = K x.
//!
//! Gruber & Aulisa take powers of the mean curvature, W^p = ∫|Y|^p dA with the curvature
//! vector Y = Δx = −2Hn, discretised by finite elements: Y_i = −s_i/m_i with s_i the area
//! gradient and m_i the lumped mass of a vertex. The flow dx/dt = −∇W^p, for p = 0 the
//! mean-curvature flow, may keep area and volume; vertices then slide along the surface
//! towards a conformal mesh. With p = 0 and the volume kept it is Huisken's volume-preserving
//! mean-curvature flow, dx/dt = 2(H̄ − H)n with H̄ the mean of H by area.
//!
//! Xu & Zhang join patches with continuous curvature by the gradient flow of ∫|∇H|² dA,
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
//! `mesh` share; `linalg` knows vectors only.
//!
//! # References
//!
//! - A. I. Bobenko, P. Schröder: *Discrete Willmore Flow*. Symposium on Geometry
//!   Processing 2005.
//! - A. Gruber, E. Aulisa: *Computational p-Willmore Flow with Conformal Penalty*. ACM
//!   Transactions on Graphics 39 (2020).
//! - G. Xu, Q. Zhang: *Minimal Mean-Curvature-Variation Surfaces and Their Applications in
//!   Surface Modeling*. Geometric Modeling and Processing 2006; their H has the opposite
//!   sign.
//! - G. Huisken: *The volume preserving mean curvature flow*. Journal für die reine und
//!   angewandte Mathematik 382 (1987).
//! - G. Francis, J. M. Sullivan, R. B. Kusner, K. A. Brakke, C. Hartman, G. Chappell: *The
//!   Minimax Sphere Eversion*. Visualization and Mathematics, Springer 1997.
//! - H. B. Lawson: *Complete minimal surfaces in S³*. Annals of Mathematics 92 (1970).
//! - U. Seifert, K. Berndl, R. Lipowsky: *Shape transformations of vesicles*. Physical Review A 44
//!   (1991).
//! - U. Pinkall: *Regular homotopy classes of immersed surfaces*. Topology 24 (1985).
//! - W. Brink, L. Alboul: *Willmore energy vs area as criteria for mesh optimisation*.

#[cfg(feature = "solver")]
pub mod app;
#[cfg(feature = "solver")]
pub mod arrays;
#[cfg(feature = "solver")]
pub mod energy;
#[cfg(feature = "solver")]
pub mod flow;
#[cfg(feature = "solver")]
pub mod geometry;
pub mod io;
#[cfg(feature = "solver")]
pub mod linalg;
pub mod mesh;
pub mod message;
#[cfg(feature = "solver")]
pub mod operator;
#[cfg(feature = "solver")]
pub mod remesh;
pub mod soup;
pub mod viewer;
pub mod web;
