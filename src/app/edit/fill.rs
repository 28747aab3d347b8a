//! Hole filling and blending of the loaded mesh.

use super::options::{FillOptions, Loops};
use crate::app::document::{Document, triangulated};
use crate::app::fault::Fault;
use crate::app::message::{AppError, Notice};
use crate::app::runner::Runner;
use crate::message::Message;
use crate::remesh::fill::{
    self, BoundaryLoop, FillError, FillProgress, Filled, boundary_loops, small_loops,
};
use serde::Serialize;
use std::rc::Rc;

/// What the fill did. The new vertices are those from `first_vertex` on, and the free ones
/// of the next flow.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct FillOutcome {
    /// The loops that are no more, by the numbers they had.
    pub filled: Vec<usize>,
    /// Those that are still open, by the numbers they had.
    pub left: Vec<usize>,
    /// Number of new vertices.
    pub new_vertices: usize,
    /// The first new vertex.
    pub first_vertex: usize,
    /// What is worth knowing.
    pub warnings: Vec<Message>,
}

/// A boundary loop, for people to choose from.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct LoopInfo {
    /// Number of edges, and of vertices.
    pub edges: usize,
    /// Sum of the edge lengths.
    pub length: f64,
    /// Its vertices in order.
    pub vertices: Vec<u32>,
    /// Whether it is a hole rather than the outer rim of a sheet: those are filled unless told
    /// otherwise.
    pub small: bool,
}

impl Runner {
    /// The boundary loops of the surface as it is now.
    pub(in crate::app) fn boundary_loops(&self) -> Vec<LoopInfo> {
        let loops = boundary_loops(self.polygons(), &self.x);
        let small = small_loops(self.polygons(), &self.x, &loops);
        let info = |(
            n,
            BoundaryLoop {
                vertices, length, ..
            },
        ): (usize, BoundaryLoop)| LoopInfo {
            edges: vertices.len(),
            length,
            vertices,
            small: small.contains(&n),
        };
        loops.into_iter().enumerate().map(info).collect()
    }

    /// The loops to be filled, and whether those that cannot be are left open.
    fn chosen(&self, options: &FillOptions) -> Result<(Option<Vec<usize>>, bool), Fault> {
        match &options.loops {
            Loops::Some(loops) => Ok((Some(loops.clone()), false)),
            Loops::Word(word) if word == "all" => Ok((None, true)),
            Loops::Word(word) if word == "small" => {
                if !self.polygons().is_oriented() {
                    return Err(FillError::NotOrientable.into());
                }
                let all = boundary_loops(self.polygons(), &self.x);
                let small = small_loops(self.polygons(), &self.x, &all);
                if small.is_empty() && !all.is_empty() {
                    let loops = all.len();
                    return Err(FillError::NoSmallLoops { loops }.into());
                }
                Ok((Some(small), true))
            }
            Loops::Word(word) => {
                let word = word.clone();
                Err(AppError::UnknownLoops { word }.into())
            }
            Loops::Usual => self.chosen(&options.named()),
        }
    }

    /// A document with the holes of the surface as it is now filled.
    pub(in crate::app) fn filled(
        &self,
        options: &FillOptions,
        progress: FillProgress<'_>,
    ) -> Result<(Document, FillOutcome), Fault> {
        let (loops, lenient) = self.chosen(options)?;
        let document = self.present();
        let defaults = fill::FillOptions::default();
        let settings = fill::FillOptions {
            loops,
            lenient,
            connect: options.connect,
            max_vertices: options.max_vertices.unwrap_or(defaults.max_vertices),
        };
        let Filled {
            mesh,
            positions,
            patches,
            notices,
            repairs,
        } = fill::fill(&document.polygons, &self.x, &settings, progress)?;
        let mut warnings: Vec<Message> = notices.into_iter().map(Message::from).collect();
        warnings.extend(repairs.into_iter().map(Message::from));
        let n_new: usize = patches.iter().map(|p| p.vertices.len()).sum();
        let n_old = positions.len() - n_new;
        let filled: Vec<usize> = patches
            .iter()
            .flat_map(|p| p.loops.iter().copied())
            .collect();
        let n_loops = boundary_loops(&document.polygons, &self.x).len();
        let outcome = FillOutcome {
            left: (0..n_loops).filter(|n| !filled.contains(n)).collect(),
            filled,
            new_vertices: n_new,
            first_vertex: n_old,
            warnings,
        };
        let polygons = Rc::new(mesh);
        let mut said = document.warnings.clone();
        let filled = Notice::Filled {
            count: outcome.filled.len(),
            vertices: n_new,
        };
        said.push(filled.into());
        said.extend(outcome.warnings.iter().cloned());
        let document = Document {
            colours: document.colours.spread(&polygons),
            numbers: document.numbers.plain(&polygons),
            triangles: triangulated(&polygons, &positions)?,
            polygons,
            start: positions,
            warnings: said,
            fixed: None,
            // Where there is no new vertex, no flow should find that nothing may move.
            free: (n_new > 0).then(|| (n_old as u32..(n_old + n_new) as u32).collect()),
            ..document
        };
        Ok((document, outcome))
    }
}
