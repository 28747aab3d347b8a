//! Meshes and bending matrices with the sparsity the flows have: every edge couples the
//! four vertices of its two triangles, 13 entries a row.

use glam::DVec3;
use std::collections::HashMap;
use umbilic::linalg::Pattern;

/// Small reproducible generator of uniform numbers in [0, 1) (splitmix64).
pub(crate) struct Uniform(pub(crate) u64);

impl Uniform {
    pub(crate) fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// A closed surface and, for each edge, its two ends and the two vertices opposite.
pub(crate) struct FlapMesh {
    pub(crate) points: Vec<DVec3>,
    pub(crate) flaps: Vec<[u32; 4]>,
}

impl FlapMesh {
    /// Icosahedron with each edge cut into `q`, on a bumpy sphere, its vertices shifted
    /// by up to 12 % of the edge length: 10 q² + 2 vertices.
    pub(crate) fn icosphere(q: u32) -> Self {
        let phi = (1.0 + 5_f64.sqrt()) / 2.0;
        let mut corners = Vec::new();
        for (a, b) in [(1.0, phi), (1.0, -phi), (-1.0, phi), (-1.0, -phi)] {
            corners.extend([
                DVec3::new(0.0, a, b),
                DVec3::new(a, b, 0.0),
                DVec3::new(b, 0.0, a),
            ]);
        }
        let is_edge = |a: DVec3, b: DVec3| (a.distance(b) - 2.0).abs() < 1e-9;
        let (mut points, mut triangles) = (Vec::new(), Vec::new());
        let mut known = HashMap::new();
        let mut vertex = |p: DVec3| {
            let key = (p.normalize() * 1e7).round().to_array().map(|c| c as i64);
            *known.entry(key).or_insert_with(|| {
                points.push(p.normalize());
                points.len() as u32 - 1
            })
        };
        for (i, &a) in corners.iter().enumerate() {
            for (j, &b) in corners.iter().enumerate().skip(i + 1) {
                for &c in corners.iter().skip(j + 1) {
                    if !(is_edge(a, b) && is_edge(b, c) && is_edge(c, a)) {
                        continue;
                    }
                    let mut at = |s: u32, t: u32| {
                        let (s, t) = (f64::from(s) / f64::from(q), f64::from(t) / f64::from(q));
                        vertex(a + s * (b - a) + t * (c - a))
                    };
                    for s in 0..q {
                        for t in 0..q - s {
                            triangles.push([at(s, t), at(s + 1, t), at(s, t + 1)]);
                            if s + t + 1 < q {
                                triangles.push([at(s + 1, t), at(s + 1, t + 1), at(s, t + 1)]);
                            }
                        }
                    }
                }
            }
        }
        let mut random = Uniform(7);
        let shift = 0.12 * 2.0 * 1.2 / f64::from(q);
        for p in &mut points {
            let jitter = DVec3::new(random.next(), random.next(), random.next()) - 0.5;
            let bump = 1.0 + 0.15 * (3.0 * p.x).sin() * (4.0 * p.y).cos() * (2.0 * p.z).sin();
            *p = (*p + shift * jitter).normalize() * bump;
        }
        Self {
            points,
            flaps: flaps(&triangles),
        }
    }

    pub(crate) fn n(&self) -> usize {
        self.points.len()
    }

    pub(crate) fn pattern(&self) -> Pattern {
        Pattern::from_cliques(self.n(), self.flaps.iter())
    }

    /// The edges, as a pattern.
    pub(crate) fn edges(&self) -> Pattern {
        Pattern::from_cliques(self.n(), self.flaps.iter().map(|flap| [flap[0], flap[1]]))
    }

    /// Quadratic bending energy of the mesh with vertices at `points`, shifted by the
    /// identity times the mean diagonal over `stiffness`: positive definite, of
    /// condition about `stiffness`.
    pub(crate) fn bending_matrix(
        &self,
        pattern: &Pattern,
        points: &[DVec3],
        stiffness: f64,
    ) -> Vec<f64> {
        let mut values = vec![0.0; pattern.nnz()];
        for &flap in &self.flaps {
            let [a, b, c, d] = flap.map(|i| points[i as usize]);
            let cotangent = |apex: DVec3, u: DVec3, v: DVec3| {
                let (u, v) = (u - apex, v - apex);
                u.dot(v) / u.cross(v).length().max(1e-300)
            };
            let at_a = [cotangent(a, b, c), cotangent(a, b, d)];
            let at_b = [cotangent(b, a, c), cotangent(b, a, d)];
            let weights = [
                at_b[0] + at_b[1],
                at_a[0] + at_a[1],
                -(at_a[0] + at_b[0]),
                -(at_a[1] + at_b[1]),
            ];
            let area = 0.5 * ((b - a).cross(c - a).length() + (b - a).cross(d - a).length());
            for (k, &i) in flap.iter().enumerate() {
                for (l, &j) in flap.iter().enumerate().take(k + 1) {
                    values[pattern.slot(i, j)] += 3.0 / area * weights[k] * weights[l];
                }
            }
        }
        let diagonal = pattern.diagonal_slots();
        let mean = diagonal.iter().map(|&s| values[s as usize]).sum::<f64>() / self.n() as f64;
        diagonal
            .iter()
            .for_each(|&s| values[s as usize] += mean / stiffness);
        values
    }

    /// A field of vectors between −1 and 1.
    pub(crate) fn field(&self, seed: u64) -> Vec<DVec3> {
        let mut random = Uniform(seed);
        let mut next = || 2.0 * random.next() - 1.0;
        (0..self.n())
            .map(|_| DVec3::new(next(), next(), next()))
            .collect()
    }
}

fn flaps(triangles: &[[u32; 3]]) -> Vec<[u32; 4]> {
    let mut open = HashMap::new();
    let mut flaps = Vec::new();
    for &[a, b, c] in triangles {
        for (a, b, c) in [(a, b, c), (b, c, a), (c, a, b)] {
            let edge = (a.min(b), a.max(b));
            match open.remove(&edge) {
                Some(d) => flaps.push([edge.0, edge.1, c, d]),
                None => drop(open.insert(edge, c)),
            }
        }
    }
    flaps
}
