//! Every invariant of the half-edge structure, for tests.

use super::{Face, HalfedgeMesh};

impl HalfedgeMesh {
    /// Checks every invariant of the connectivity; `Err` names the first that fails.
    ///
    /// Linear in the number of elements.
    ///
    /// # Errors
    /// A sentence naming the invariant and the element.
    pub fn validate(&self) -> Result<(), String> {
        let check = |holds: bool, what: &str, at: u32| {
            holds
                .then_some(())
                .ok_or_else(|| format!("{what} fails at {at}"))
        };
        let mut cycles_seen = vec![false; self.n_halfedges()];
        for h in self.halfedges() {
            check(self.prev(self.next(h)) == h, "prev(next(h)) = h", h.0)?;
            check(
                self.face(self.next(h)) == self.face(h),
                "one face a cycle",
                h.0,
            )?;
            check(self.tail(h) != self.tip(h), "distinct ends", h.0)?;
            let (mut ends, mut far) = ([self.tail(h), self.tip(h)], self.ends(h.edge()));
            ends.sort_unstable();
            far.sort_unstable();
            check(ends == far, "both sides have the same ends", h.0)?;
        }
        for e in self.edges() {
            check(
                self.face(e.halfedge()).is_some(),
                "first side has a face",
                e.0,
            )?;
        }
        for f in self.faces() {
            for h in self.cycle(self.halfedge_of_face(f)) {
                check(self.face(h) == f, "face of its half-edges", f.0)?;
                cycles_seen[h.index()] = true;
            }
        }
        for h in self.boundary_loops().flatten() {
            check(self.face(h) == Face::NONE, "loop without face", h.0)?;
            cycles_seen[h.index()] = true;
        }
        if let Some(h) = cycles_seen.iter().position(|&seen| !seen) {
            return Err(format!("half-edge {h} is in no face and no loop"));
        }
        let mut spokes = 0;
        for v in self.vertices() {
            let star: Vec<_> = self.star(v).collect();
            check(
                star.iter()
                    .all(|s| self.ends(s.edge).contains(&v) && s.neighbour != v),
                "star holds its edges",
                v.0,
            )?;
            let gaps = star.iter().filter(|s| s.face == Face::NONE).count();
            check(
                gaps == usize::from(self.is_boundary_vertex(v)),
                "at most one gap a star",
                v.0,
            )?;
            check(
                gaps == 0 || star.last().is_some_and(|s| s.face == Face::NONE),
                "star starts at the boundary",
                v.0,
            )?;
            spokes += star.len();
        }
        if spokes != self.n_halfedges() {
            return Err(format!(
                "stars hold {spokes} spokes, not {}",
                self.n_halfedges()
            ));
        }
        Ok(())
    }
}
