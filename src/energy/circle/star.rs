//! The matrix of the semi-implicit step: K of Eq. (1), assembled star by star and, if
//! asked for, projected to positive semi-definite in each star.
//!
//! W_i depends on the star of i alone, so K = Σ_i K_i with K_i the edge weights of the
//! angles at i, each counted once, a dense matrix on the star. K has negative
//! eigenvalues on every surface that is not critical; K_i has none where the star is
//! convex and spherical, a minimum of W_i. Clamping the negative eigenvalues of each
//! K_i therefore changes nothing near a sphere and makes I/dt + K definite for every
//! dt elsewhere. (Projecting angle by angle instead would spoil convergence.)
//!
//! The projection couples neighbours of i that no angle does, such as the opposite ones at
//! a vertex of valence 6. They would double the cost of the factorisation. A spring of
//! strength w between such p and q is replaced by springs 2w from both to i,
//!
//! ```math
//! w (x_p - x_q)^2 \le 2w (x_p - x_i)^2 + 2w (x_i - x_q)^2 \qquad (w > 0),
//! ```
//!
//! or left out where w < 0: either way the matrix only grows, and stays semi-definite.

use super::angle::{CORNER_PAIRS, DIAMOND_PAIRS};
use super::{CircleEnergy, Weights};
use crate::interrupt::paced;
use crate::linalg::Pattern;
use crate::linalg::eigen::SpringMatrix;

/// Stars with more neighbours than this are projected angle by angle: a dense matrix
/// on them would cost valence³ time and fill the sparse factor.
const MAX_DENSE_VALENCE: usize = SpringMatrix::MAX_SIZE - 1;

/// A dense block: a few vertices and the angles among them.
struct Block {
    members: std::ops::Range<u32>,
    terms: std::ops::Range<u32>,
    /// First of the slots of the block's pairs in `StarMatrix::slots`.
    slots: u32,
}

/// One angle of a block: its number (diamonds first, then corners) and which pairs of
/// the block's members its weights act between.
#[derive(Clone, Copy)]
struct Term {
    angle: u32,
    pairs: [u8; 6],
}

/// Assembles K over the free vertices; built once per connectivity and selection.
pub struct StarMatrix {
    pattern: Pattern,
    /// Row of each vertex; `NONE` if it is held.
    row_of_vertex: Vec<u32>,
    blocks: Vec<Block>,
    members: Vec<u32>,
    terms: Vec<Term>,
    slots: Vec<u32>,
    first_corner: u32,
    star: SpringMatrix,
}

/// Marks a held vertex, and an entry that is not in the system.
const NONE: u32 = u32::MAX;
/// Marks an entry between free vertices that no angle couples.
const OFF_PATTERN: u32 = u32::MAX - 1;

/// What an assembly found.
#[derive(Clone, Copy, Debug, Default)]
pub struct AssemblyInfo {
    /// Stars whose matrix had a negative eigenvalue.
    pub projected_stars: usize,
    /// Stars in all.
    pub stars: usize,
}

impl StarMatrix {
    /// The pattern of K among the vertices with `free[v]`.
    pub fn new(energy: &CircleEnergy, free: &[bool]) -> Self {
        let mut row_of_vertex = vec![NONE; free.len()];
        let rows = free.iter().enumerate().filter(|(_, f)| **f);
        for (row, (v, _)) in rows.enumerate() {
            row_of_vertex[v] = row as u32;
        }
        let n = free.iter().filter(|&&f| f).count();
        let mut matrix = Self {
            pattern: Pattern::from_cliques(0, std::iter::empty::<&[u32]>()),
            row_of_vertex,
            blocks: Vec::new(),
            members: Vec::new(),
            terms: Vec::new(),
            slots: Vec::new(),
            first_corner: energy.diamonds().len() as u32,
            star: SpringMatrix::default(),
        };
        matrix.collect_blocks(energy);
        let n_angles = energy.diamonds().len() + energy.corners().len();
        let cliques = (0..n_angles as u32).map(|angle| {
            let rows = matrix.angle_vertices(energy, angle).iter();
            let rows = rows.map(|&v| matrix.row_of_vertex[v as usize]);
            rows.filter(|&r| r != NONE).collect::<Vec<u32>>()
        });
        matrix.pattern = Pattern::from_cliques(n, cliques);
        matrix.find_slots();
        matrix
    }

    /// Blocks of one star each, those of infinity, and those of crowded stars.
    fn collect_blocks(&mut self, energy: &CircleEnergy) {
        // Angles at each vertex: the vertex in the upper half, the angle in the lower.
        let entry = |v: u32, angle: u32| u64::from(v) << 32 | u64::from(angle);
        let mut at = Vec::new();
        for (d, diamond) in energy.diamonds().iter().enumerate() {
            for v in [diamond.v[1], diamond.v[3]] {
                if energy.counts(crate::mesh::Vertex(v)) {
                    at.push(entry(v, d as u32));
                }
            }
        }
        for (c, corner) in energy.corners().iter().enumerate() {
            let angle = self.first_corner + c as u32;
            let [p, v, n] = corner.v;
            if c < energy.first_turn() {
                at.extend([entry(p, angle), entry(n, angle)]);
            } else {
                // The other end of this edge is at infinity: a star of its own.
                at.push(entry(v, angle));
                self.push_block(energy, &[angle], v);
            }
        }
        at.sort_unstable();
        for star in at.chunk_by(|a, b| a >> 32 == b >> 32) {
            let centre = (star[0] >> 32) as u32;
            let angles: Vec<u32> = star.iter().map(|entry| *entry as u32).collect();
            let together = if angles.len() <= MAX_DENSE_VALENCE {
                angles.len()
            } else {
                1
            };
            for angles in angles.chunks(together) {
                self.push_block(energy, angles, centre);
            }
        }
    }

    /// Vertices of an angle: four of a diamond, three of a corner.
    fn angle_vertices<'a>(&self, energy: &'a CircleEnergy, angle: u32) -> &'a [u32] {
        if angle < self.first_corner {
            &energy.diamonds()[angle as usize].v
        } else {
            &energy.corners()[(angle - self.first_corner) as usize].v
        }
    }

    fn push_block(&mut self, energy: &CircleEnergy, angles: &[u32], centre: u32) {
        let mut members = vec![centre];
        for &angle in angles {
            for &v in self.angle_vertices(energy, angle) {
                if !members.contains(&v) {
                    members.push(v);
                }
            }
        }
        if members
            .iter()
            .all(|&v| self.row_of_vertex[v as usize] == NONE)
        {
            return;
        }
        let first_term = self.terms.len() as u32;
        for &angle in angles {
            let vertices = self.angle_vertices(energy, angle);
            let local = |k: usize| members.iter().position(|m| *m == vertices[k]);
            let pairs: &[(usize, usize)] = if angle < self.first_corner {
                &DIAMOND_PAIRS
            } else {
                &CORNER_PAIRS
            };
            let mut term = Term {
                angle,
                pairs: [u8::MAX; 6],
            };
            for (pair, &(p, q)) in term.pairs.iter_mut().zip(pairs) {
                if let (Some(p), Some(q)) = (local(p), local(q)) {
                    *pair = SpringMatrix::pair(p, q);
                }
            }
            self.terms.push(term);
        }
        let first_member = self.members.len() as u32;
        self.members.extend(members);
        self.blocks.push(Block {
            members: first_member..self.members.len() as u32,
            terms: first_term..self.terms.len() as u32,
            slots: 0,
        });
    }

    fn find_slots(&mut self) {
        for block in &mut self.blocks {
            block.slots = self.slots.len() as u32;
            let members = &self.members[block.members.start as usize..block.members.end as usize];
            for (m, &p) in members.iter().enumerate() {
                for &q in &members[..m] {
                    let rows = [p, q].map(|v| self.row_of_vertex[v as usize]);
                    self.slots.push(if rows.contains(&NONE) {
                        NONE
                    } else {
                        self.pattern
                            .find(rows[0], rows[1])
                            .map_or(OFF_PATTERN, |s| s as u32)
                    });
                }
            }
        }
    }

    /// The pattern of the system, one row a free vertex in vertex order.
    pub fn pattern(&self) -> &Pattern {
        &self.pattern
    }

    /// Row of each vertex; `u32::MAX` if it is held.
    pub fn row_of_vertex(&self) -> &[u32] {
        &self.row_of_vertex
    }

    /// Writes K into `values` (one a slot of the pattern); unit 1/length².
    /// `project` clamps the negative eigenvalues of each star. Some of it where the work is given up.
    pub fn assemble(
        &mut self,
        weights: &Weights,
        project: bool,
        values: &mut Vec<f64>,
    ) -> AssemblyInfo {
        values.clear();
        values.resize(self.pattern.nnz(), 0.0);
        let mut info = AssemblyInfo {
            stars: self.blocks.len(),
            projected_stars: 0,
        };
        let star = &mut self.star;
        let diagonal_slots = self.pattern.diagonal_slots();
        for block in paced(&self.blocks) {
            let members = &self.members[block.members.start as usize..block.members.end as usize];
            star.reset(members.len());
            for term in &self.terms[block.terms.start as usize..block.terms.end as usize] {
                let weights: &[f64] = match term.angle.checked_sub(self.first_corner) {
                    None => &weights.diamonds[term.angle as usize],
                    Some(corner) => &weights.corners[corner as usize],
                };
                for (&pair, w) in term.pairs.iter().zip(weights) {
                    star.add(pair, *w);
                }
            }
            let slots = &self.slots[block.slots as usize..];
            if project && star.project_semidefinite() {
                info.projected_stars += 1;
                keep_to_pattern(star, slots);
            }
            let (mut springs, mut slots) = (star.springs(), slots);
            let mut diagonal = [0.0; SpringMatrix::MAX_SIZE];
            for p in 1..members.len() {
                let (row, row_slots);
                (row, springs) = springs.split_at(p);
                (row_slots, slots) = slots.split_at(p);
                let mut sum = 0.0;
                for ((w, &slot), d) in row.iter().zip(row_slots).zip(&mut diagonal) {
                    *d += w;
                    sum += w;
                    if slot < OFF_PATTERN {
                        values[slot as usize] -= w;
                    }
                }
                diagonal[p] = sum;
            }
            for (&v, d) in members.iter().zip(diagonal) {
                let row = self.row_of_vertex[v as usize];
                if row != NONE {
                    values[diagonal_slots[row as usize] as usize] += d;
                }
            }
        }
        info
    }
}

/// Replaces the springs of a star that are not in the pattern; member 0 is its centre.
fn keep_to_pattern(star: &mut SpringMatrix, slots: &[u32]) {
    let pairs = (1..).flat_map(|p: usize| (0..p).map(move |q| (p, q)));
    let springs = star.springs_mut();
    for (k, ((p, q), &slot)) in pairs.zip(slots).enumerate().take(springs.len()) {
        if slot == OFF_PATTERN {
            let w = std::mem::take(&mut springs[k]);
            // No `max`: wasm has no such instruction, and calls a function.
            let w = if w > 0.0 { w } else { 0.0 };
            springs[usize::from(SpringMatrix::pair(p, 0))] += 2.0 * w;
            springs[usize::from(SpringMatrix::pair(q, 0))] += 2.0 * w;
        }
    }
}
