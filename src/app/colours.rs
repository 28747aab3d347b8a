//! Colours that a file gives its vertices: no flow looks at them, and a file that is saved has them
//! still.

use crate::arrays::TypedArray;
use crate::mesh::HalfedgeMesh;
use crate::remesh::adaptive::Origin;
use crate::soup::{Colour, PolygonSoup};
use std::collections::VecDeque;
use std::rc::Rc;

/// Colours of the vertices of a document.
#[derive(Clone, Debug, Default)]
pub(super) enum Colours {
    /// There never were any.
    #[default]
    None,
    /// One a vertex.
    Kept(Rc<[Colour]>),
    /// Those of vertices of which nothing but their places was left.
    Dropped,
}

impl Colours {
    /// Of vertices that were those of a file.
    pub(super) fn of(soup: &PolygonSoup, were: &[u32]) -> Self {
        match soup.has_colours() {
            true => Self::Kept(soup.colours_of(were).into()),
            false => Self::None,
        }
    }

    /// One a vertex, or none.
    pub(super) fn list(&self) -> &[Colour] {
        match self {
            Self::Kept(list) => list,
            _ => &[],
        }
    }

    /// The parts of each in a row, where there are any.
    pub(super) fn numbers(&self) -> Option<TypedArray<f32>> {
        match self {
            Self::Kept(list) => Some(TypedArray(list.concat())),
            _ => None,
        }
    }

    /// Of vertices of which nothing is known but their places.
    pub(super) fn dropped(&self) -> Self {
        match self {
            Self::None => Self::None,
            _ => Self::Dropped,
        }
    }

    fn map(&self, f: impl FnOnce(&[Colour]) -> Vec<Colour>) -> Self {
        match self {
            Self::Kept(list) => Self::Kept(f(list).into()),
            other => other.clone(),
        }
    }

    /// Of vertices that were these.
    pub(super) fn carried(&self, were: &[u32]) -> Self {
        self.map(|list| were.iter().map(|&v| list[v as usize]).collect())
    }

    /// Of vertices that lie between those there were.
    pub(super) fn interpolated(&self, origins: &[Origin]) -> Self {
        self.map(|list| {
            let part = |origin: &Origin, k: usize| origin.mean(|v| f64::from(list[v as usize][k]));
            let colour = |origin| std::array::from_fn(|k| part(origin, k) as f32);
            origins.iter().map(colour).collect()
        })
    }

    /// With those of vertices between two each.
    pub(super) fn refined(&self, parents: &[[u32; 2]]) -> Self {
        self.map(|list| {
            let between = parents
                .iter()
                .map(|ends| mean(ends.iter().map(|&v| list[v as usize])));
            list.iter().copied().chain(between).collect()
        })
    }

    /// With those of new vertices of a mesh, which come after the old ones: ring by ring, the mean
    /// of what has a colour around.
    pub(super) fn spread(&self, mesh: &HalfedgeMesh) -> Self {
        self.map(|list| {
            let mut all: Vec<Option<Colour>> = list.iter().copied().map(Some).collect();
            all.resize(mesh.n_vertices(), None);
            let mut around = vec![Vec::new(); mesh.n_vertices()];
            for e in mesh.edges() {
                let [a, b] = mesh.ends(e).map(|v| v.index());
                around[a].push(b);
                around[b].push(a);
            }
            let is_rim = |v: &usize| around[*v].iter().any(|w| all[*w].is_none());
            let mut open: VecDeque<usize> = (0..list.len()).filter(is_rim).collect();
            while let Some(v) = open.pop_front() {
                for &w in &around[v] {
                    if all[w].is_none() {
                        all[w] = Some(mean(around[w].iter().filter_map(|u| all[*u])));
                        open.push_back(w);
                    }
                }
            }
            let white = [1.0; 4];
            all.into_iter().map(|c| c.unwrap_or(white)).collect()
        })
    }
}

/// The mean of colours, of which there is one at least.
fn mean(colours: impl Iterator<Item = Colour>) -> Colour {
    let mut sum = [0.0; 4];
    let mut count = 0.0;
    for colour in colours {
        count += 1.0;
        for (sum, part) in sum.iter_mut().zip(colour) {
            *sum += part;
        }
    }
    sum.map(|part| part / count)
}
