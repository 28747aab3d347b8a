//! Tests of the solver: one program, since a program each would take minutes to link.
#![allow(missing_docs, reason = "tests")]
#![allow(clippy::unwrap_used, reason = "a test may fail here")]

mod support;

mod bench;
mod circle_figures;
mod circle_invariants;
mod circle_reference;
mod colours;
mod comparison;
mod course;
mod curvature_flows;
mod eversion;
mod fill;
mod fitted_operators;
mod flip_session;
mod flips;
mod history;
mod interruption;
mod io;
mod library;
mod linalg;
mod mesh;
mod messages;
mod modelling;
mod moebius;
mod multigrid;
mod organic_flows;
mod p_willmore_energy;
mod p_willmore_flow;
mod p_willmore_mass;
mod phases;
mod probe;
mod property_io;
mod random_surfaces;
mod real_meshes;
mod recipe;
mod regularise;
mod remesh_flows;
mod repair;
mod robust_flows;
mod self_intersection;
mod session;
mod session_fill;
mod session_remesh;
mod session_subdivide;
mod shaders;
mod shapes;
mod study;
mod volume_preserving;
mod why;
