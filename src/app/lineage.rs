//! Which vertex of one mesh is which of another that a remeshing made of it, there and back: what
//! is picked stays where it is on the surface.

use crate::mesh::HalfedgeMesh;
use crate::remesh::adaptive::Origin;
use std::collections::VecDeque;
use std::rc::Rc;

/// A mesh among those it came of. Two with the same one have the same vertices, but for new ones
/// that come after the others.
#[derive(Debug, Default)]
pub(super) struct Lineage {
    parent: Option<(Rc<Lineage>, Kin)>,
    depth: usize,
}

/// Vertices of two meshes of one surface.
#[derive(Debug)]
struct Kin {
    /// The old vertex nearest to each new one.
    older: Vec<u32>,
    /// A new vertex near each old one.
    newer: Vec<u32>,
}

impl Lineage {
    /// Of the mesh whose vertices have these origins in `mesh`, which is of `parent`.
    pub(super) fn after(parent: &Rc<Self>, origins: &[Origin], mesh: &HalfedgeMesh) -> Rc<Self> {
        Rc::new(Self {
            parent: Some((Rc::clone(parent), Kin::of(origins, mesh))),
            depth: parent.depth + 1,
        })
    }

    /// Where a vertex of the mesh of `from` is on that of `to`; `None` where they have no mesh in
    /// common that both came of.
    pub(super) fn carried(from: &Rc<Self>, to: &Rc<Self>, vertex: u32) -> Option<u32> {
        if Rc::ptr_eq(from, to) {
            return Some(vertex);
        }
        if from.depth >= to.depth {
            let (parent, kin) = from.parent.as_ref()?;
            let older = kin.older.get(vertex as usize)?;
            return Self::carried(parent, to, *older);
        }
        let (parent, kin) = to.parent.as_ref()?;
        let vertex = Self::carried(from, parent, vertex)?;
        kin.newer.get(vertex as usize).copied()
    }

    /// What it takes to keep it, without those that it came of.
    pub(super) fn bytes(&self) -> usize {
        let kin = self.parent.as_ref().map(|(_, kin)| kin);
        kin.map_or(0, |kin| 4 * (kin.older.len() + kin.newer.len()))
    }
}

impl Kin {
    fn of(origins: &[Origin], mesh: &HalfedgeMesh) -> Self {
        // Weight and number of the new vertex to which each old one counts most.
        let mut best: Vec<Option<(f64, u32)>> = vec![None; mesh.n_vertices()];
        for (new, origin) in (0..).zip(origins) {
            for (&old, &weight) in origin.corners.iter().zip(&origin.weights) {
                let best = &mut best[old as usize];
                if weight > 0.0 && best.is_none_or(|(most, _)| weight > most) {
                    *best = Some((weight, new));
                }
            }
        }
        // One that counts to none is where those around it are.
        let known = mesh.vertices().filter(|v| best[v.index()].is_some());
        let mut open: VecDeque<_> = known.collect();
        while let Some(v) = open.pop_front() {
            for w in mesh.neighbours(v) {
                if best[w.index()].is_none() {
                    best[w.index()] = best[v.index()];
                    open.push_back(w);
                }
            }
        }
        Self {
            older: origins.iter().map(Origin::nearest).collect(),
            newer: best
                .into_iter()
                .map(|best| best.map_or(u32::MAX, |(_, new)| new))
                .collect(),
        }
    }
}
