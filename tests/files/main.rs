//! What mesh files of every kind say, and what damaged ones are answered: files written by code in
//! all variants that other programs write, read here, and, damaged at random, read again.
#![allow(missing_docs, reason = "tests")]
#![allow(clippy::unwrap_used, reason = "a test may fail here")]

mod colours;
mod fuzz;
mod gltf;
mod mesh;
mod msh;
mod packed;
mod plain;
mod round_trip;
mod second_order;
mod solid;
mod three_mf;
mod vtk;
mod vtp;
