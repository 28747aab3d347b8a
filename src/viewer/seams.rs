//! Cuts, for drawing only, along edges where the winding of triangles disagrees.
//!
//! A Möbius strip has no consistent orientation: somewhere two neighbours run along
//! their common edge in the same direction. A vertex there has two opposite normals,
//! one for each side of the seam; sharing one vertex would average them to nothing and
//! draw a dark scar. So such a vertex is drawn as several, one for each fan of
//! consistently wound triangles; [`super::normals`] then makes their normals agree up
//! to sign, and two-sided lighting hides the sign.

/// Splits vertices along seams, rewriting `triangles` in place. Answers, for each vertex
/// appended after the first `n_vertices`, the vertex it copies. Empty for a consistently
/// wound mesh, which is left untouched.
///
/// `O(n)` where there is no seam; else the edges are sorted. Non-manifold edges count as a seam
/// when two of their triangles run along them in the same direction.
pub fn split_seams(n_vertices: usize, triangles: &mut [u32]) -> Vec<u32> {
    if is_wound_consistently(n_vertices, triangles) {
        return Vec::new();
    }
    let mut edges: Vec<(u32, u32, u32)> = (0..triangles.len())
        .map(|corner| {
            let (a, b) = (triangles[corner], triangles[next(corner)]);
            (a.min(b), a.max(b), corner as u32)
        })
        .collect();
    edges.sort_unstable();
    let shared = || edges.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1));

    let mut on_seam = vec![false; n_vertices];
    for edge in shared() {
        let forward = |&&(a, _, corner): &&(u32, u32, u32)| triangles[corner as usize] == a;
        let n_forward = edge.iter().filter(forward).count();
        if n_forward > 1 || edge.len() - n_forward > 1 {
            on_seam[edge[0].0 as usize] = true;
            on_seam[edge[0].1 as usize] = true;
        }
    }
    // Corners of one vertex belong to one fan when a chain of consistent edges joins them.
    let mut fans = Fans((0..triangles.len() as u32).collect());
    for edge in shared() {
        if let &[(.., first), (.., second)] = edge {
            let (first, second) = (first as usize, second as usize);
            if triangles[first] == triangles[next(second)] {
                fans.join(first, next(second));
                fans.join(next(first), second);
            }
        }
    }

    let mut copies = Vec::new();
    let mut claimed = vec![false; n_vertices];
    let mut vertex_of_fan = vec![u32::MAX; triangles.len()];
    for corner in 0..triangles.len() {
        let vertex = triangles[corner];
        if !on_seam[vertex as usize] {
            continue;
        }
        let home = &mut vertex_of_fan[fans.root(corner)];
        if *home == u32::MAX {
            *home = if claimed[vertex as usize] {
                copies.push(vertex);
                (n_vertices + copies.len() - 1) as u32
            } else {
                vertex
            };
            claimed[vertex as usize] = true;
        }
        triangles[corner] = *home;
    }
    copies
}

/// Whether no two triangles run along an edge in the same direction: among the ends of the sides
/// that leave a vertex there are no two alike.
fn is_wound_consistently(n_vertices: usize, triangles: &[u32]) -> bool {
    // Where the ends of each vertex begin, and after the last; then filled from behind.
    let mut starts = vec![0u32; n_vertices + 1];
    for &vertex in triangles {
        starts[vertex as usize] += 1;
    }
    let mut sum = 0;
    for start in &mut starts {
        sum += *start;
        *start = sum;
    }
    let mut ends = vec![0u32; triangles.len()];
    for (corner, &vertex) in triangles.iter().enumerate() {
        let place = &mut starts[vertex as usize];
        *place -= 1;
        ends[*place as usize] = triangles[next(corner)];
    }
    // Vertex from which a side was last seen to lead here.
    let mut from = vec![u32::MAX; n_vertices];
    (0..).zip(starts.windows(2)).all(|(vertex, span)| {
        let mut ends = ends[span[0] as usize..span[1] as usize].iter();
        ends.all(|&end| std::mem::replace(&mut from[end as usize], vertex) != vertex)
    })
}

/// The corner after this one in its triangle.
fn next(corner: usize) -> usize {
    if corner % 3 == 2 {
        corner - 2
    } else {
        corner + 1
    }
}

/// Disjoint sets of corners, with path halving.
struct Fans(Vec<u32>);

impl Fans {
    fn root(&mut self, mut corner: usize) -> usize {
        while self.0[corner] as usize != corner {
            self.0[corner] = self.0[self.0[corner] as usize];
            corner = self.0[corner] as usize;
        }
        corner
    }

    fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        self.0[a] = b as u32;
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use glam::Vec3;

    /// A Möbius strip of `n × 2` quads, wound consistently but for the seam where it
    /// closes.
    pub(in crate::viewer) fn mobius_strip(n: u32) -> (Vec<Vec3>, Vec<u32>) {
        let mut positions = Vec::new();
        let mut triangles = Vec::new();
        for i in 0..n {
            let angle = std::f32::consts::TAU * i as f32 / n as f32;
            let radial = Vec3::new(angle.cos(), angle.sin(), 0.0);
            let across = (angle / 2.0).cos() * radial + (angle / 2.0).sin() * Vec3::Z;
            for j in 0..3 {
                positions.push(radial + 0.3 * (j as f32 - 1.0) * across);
            }
            for j in 0..2 {
                let far = |j: u32| if i + 1 < n { 3 * (i + 1) + j } else { 2 - j };
                let [a, b, c, d] = [3 * i + j, far(j), far(j + 1), 3 * i + j + 1];
                triangles.extend([a, b, c, a, c, d]);
            }
        }
        (positions, triangles)
    }

    #[test]
    fn consistently_wound_triangles_are_untouched() {
        let tetrahedron = [0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2];
        let mut triangles = tetrahedron;
        assert!(split_seams(4, &mut triangles).is_empty());
        assert_eq!(triangles, tetrahedron);
    }

    #[test]
    fn mobius_strip_is_cut_once_across() {
        let (positions, mut triangles) = mobius_strip(12);
        let original = triangles.clone();
        let mut copies = split_seams(positions.len(), &mut triangles);
        let source = |v: u32| {
            copies
                .get((v as usize).wrapping_sub(positions.len()))
                .copied()
                .unwrap_or(v)
        };
        let restored: Vec<u32> = triangles.iter().map(|&v| source(v)).collect();
        assert_eq!(
            restored, original,
            "a copy stands for another vertex than its own"
        );
        copies.sort_unstable();
        assert_eq!(copies, [0, 1, 2], "the seam is the first column");
        // Cut open, the strip is consistently wound.
        assert!(split_seams(positions.len() + 3, &mut triangles).is_empty());
    }

    #[test]
    fn one_flipped_triangle_is_cut_out() {
        // A fan of four about vertex 0, the second wound the other way.
        let mut triangles = [0, 1, 2, 0, 3, 2, 0, 3, 4, 0, 4, 1];
        let copies = split_seams(5, &mut triangles);
        assert_eq!(copies.len(), 3, "vertices 0, 2 and 3 each have two sides");
        assert!(split_seams(8, &mut triangles).is_empty());
    }
}
