//! Subdivision as an edit: finer faces, of the same surface or of a smoother one.

use super::options::{SubdivideOptions, SubdivisionScheme};
use crate::app::document::Document;
use crate::app::fault::Fault;
use crate::app::message::AppError;
use crate::app::provenance::Edit;
use crate::app::runner::Runner;
use crate::app::{Loaded, Session};
use crate::mesh::{self, HalfedgeMesh, subdivide};
use std::rc::Rc;

/// Faces at most; no flow could take a step on more.
const MAX_FACES: usize = 2_000_000;

/// What a selection of vertices is on the finer mesh: a new vertex belongs to it if `belongs`
/// says so of the ends of its edge.
fn refined(
    chosen: &[u32],
    n_old: usize,
    parents: &[[u32; 2]],
    belongs: impl Fn(bool, bool) -> bool,
) -> Vec<u32> {
    let mut is_chosen = vec![false; n_old];
    for &v in chosen {
        if let Some(is_chosen) = is_chosen.get_mut(v as usize) {
            *is_chosen = true;
        }
    }
    let new = (n_old as u32..).zip(parents);
    let new = new.filter(|&(_, &[a, b])| belongs(is_chosen[a as usize], is_chosen[b as usize]));
    let mut all = chosen.to_vec();
    all.extend(new.map(|(v, _)| v));
    all
}

impl Runner {
    /// A document with each triangle divided into four.
    fn subdivided(&self, options: SubdivideOptions) -> Result<(Document, ()), Fault> {
        let document = self.present();
        let n_faces = 4 * document.triangles.n_faces();
        if n_faces > MAX_FACES {
            let error = AppError::TooManyFaces {
                faces: n_faces,
                most: MAX_FACES,
            };
            return Err(error.into());
        }
        let soup = document.triangles.to_soup(&document.start);
        let parents = subdivide::parents(&soup)?;
        let finer = match options.scheme {
            SubdivisionScheme::Linear => subdivide::linear(&soup)?,
            SubdivisionScheme::Loop => subdivide::loop_scheme(&soup)?,
        };
        let triangles: Rc<HalfedgeMesh> = Rc::new(mesh::build_as_given(&finer)?.mesh);
        let n_old = document.start.len();
        let of = |list: &Option<Vec<u32>>, belongs: fn(bool, bool) -> bool| {
            list.as_deref()
                .map(|chosen| refined(chosen, n_old, &parents, belongs))
        };
        // An edge with one end held moved with its other end, so its midpoint moves.
        let free = of(&self.options().free, |a, b| a || b);
        let fixed = of(&self.options().fixed, |a, b| a && b);
        let document = Document {
            colours: document.colours.refined(&parents),
            numbers: document.numbers.plain(&triangles),
            polygons: Rc::clone(&triangles),
            triangles,
            start: finer.positions,
            free,
            fixed,
            ..document
        };
        Ok((document, ()))
    }
}

impl Session {
    /// Divides each triangle into four; the finer surface becomes the start, and what was held
    /// or free stays so. [`undo_edit`](Self::undo_edit) undoes it.
    ///
    /// # Errors
    /// Meshes that would become too large; the mesh stays as it was.
    pub fn subdivide(&mut self, options: SubdivideOptions) -> Result<Loaded, Fault> {
        self.edit(Edit::Subdivide(options), |runner| {
            runner.subdivided(options)
        })?;
        self.loaded()
    }
}
