//! Triangulation of a closed loop in space, of least area and without double edges.
//!
//! Dynamic programming over the chords (Barequet & Sharir [BS95](crate::bibliography#bs95)),
//! O(m³) for m vertices. Of a longer loop ears are clipped first, the shortest chord first, until
//! few enough vertices are left. A loop that has no triangulation on its own vertices gets a
//! vertex in its middle.

use glam::DVec3;
use std::cmp::Reverse;
use std::collections::BinaryHeap;
use std::f64::consts::PI;

/// Up to so many vertices a loop is triangulated by dynamic programming alone.
const MAX_EXACT: usize = 300;

/// Weight of Σ edge² beside the area. All triangulations of a flat convex loop have the
/// same area: of those the one with the shortest chords is wanted.
const COMPACTNESS: f64 = 1e-4;

/// An ear with less than this to a straight angle is clipped only when there is no other.
const STRAIGHT: f64 = 1e-4;

/// Triangles on the loop's vertices, numbered along it, and on those in the middle, which
/// come after them.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Triangulation {
    /// Corners run with the loop.
    pub(super) faces: Vec<[u32; 3]>,
    /// Positions of the vertices in the middle; usually there are none.
    pub(super) middles: Vec<DVec3>,
}

/// A loop to be triangulated.
pub(super) struct Outline<'a> {
    /// Positions along the loop.
    pub(super) x: &'a [DVec3],
    /// Interior angle at each vertex as seen in the surface around the loop: 2π less its
    /// angles there. Only long loops need it.
    pub(super) angles: &'a [f64],
    /// Whether two vertices may not be joined by a chord.
    pub(super) is_forbidden: &'a dyn Fn(u32, u32) -> bool,
}

impl Outline<'_> {
    /// Triangulates the loop. Never fails for three vertices or more.
    pub(super) fn triangulate(&self) -> Triangulation {
        let mut result = Triangulation::default();
        let ring = if self.x.len() > MAX_EXACT {
            self.clip_ears(&mut result.faces)
        } else {
            (0..self.x.len() as u32).collect()
        };
        let whole = ring.len() <= 2 * MAX_EXACT && self.least_area(&ring, &mut result.faces);
        if !whole {
            self.fan(&ring, &mut result);
        }
        result
    }

    /// Joins every side of the ring to a new vertex at its centroid.
    pub(super) fn fan(&self, ring: &[u32], result: &mut Triangulation) {
        let middle = (self.x.len() + result.middles.len()) as u32;
        let mean = ring.iter().map(|&v| self.x[v as usize]).sum::<DVec3>() / ring.len() as f64;
        result.middles.push(mean);
        for (i, &a) in ring.iter().enumerate() {
            result.faces.push([a, ring[(i + 1) % ring.len()], middle]);
        }
    }

    fn cost(&self, a: u32, b: u32, c: u32) -> f64 {
        let [a, b, c] = [a, b, c].map(|v| self.x[v as usize]);
        let squares = a.distance_squared(b) + b.distance_squared(c) + c.distance_squared(a);
        0.5 * (b - a).cross(c - a).length() + COMPACTNESS * squares
    }

    /// Appends the triangulation of the ring of least cost, if there is any.
    fn least_area(&self, ring: &[u32], faces: &mut Vec<[u32; 3]>) -> bool {
        let m = ring.len();
        // Cost of the polygon i, i + 1, …, j and the corner opposite to its side (i, j).
        let mut cost = vec![0.0; m * m];
        let mut apex = vec![0u32; m * m];
        for span in 2..m {
            for i in 0..m - span {
                let j = i + span;
                let is_side = i == 0 && j == m - 1;
                let mut best = f64::INFINITY;
                if is_side || !(self.is_forbidden)(ring[i], ring[j]) {
                    for k in i + 1..j {
                        let parts = cost[i * m + k] + cost[k * m + j];
                        if parts < best {
                            let total = parts + self.cost(ring[i], ring[k], ring[j]);
                            if total < best {
                                best = total;
                                apex[i * m + j] = k as u32;
                            }
                        }
                    }
                }
                cost[i * m + j] = best;
            }
        }
        if cost[m - 1].is_infinite() {
            return false;
        }
        let mut open = vec![(0, m - 1)];
        while let Some((i, j)) = open.pop() {
            if j < i + 2 {
                continue;
            }
            let k = apex[i * m + j] as usize;
            faces.push([ring[i], ring[k], ring[j]]);
            open.extend([(i, k), (k, j)]);
        }
        true
    }

    /// Clips ears until the loop is short enough; answers what is left of it.
    fn clip_ears(&self, faces: &mut Vec<[u32; 3]>) -> Vec<u32> {
        let m = self.x.len();
        let mut next: Vec<usize> = (1..=m).map(|i| i % m).collect();
        let mut prev: Vec<usize> = (0..m).map(|i| (i + m - 1) % m).collect();
        let mut angles = self.angles.to_vec();
        let mut versions = vec![0u32; m];
        let mut is_left = vec![true; m];
        let mut queue = BinaryHeap::new();
        let rank = |v: usize, prev: &[usize], next: &[usize], angles: &[f64]| {
            let chord = self.x[prev[v]].distance_squared(self.x[next[v]]);
            // Lengths are not negative: their bits sort as they do.
            Reverse((angles[v] > PI - STRAIGHT, chord.to_bits()))
        };
        for v in 0..m {
            queue.push((rank(v, &prev, &next, &angles), Reverse(v), 0));
        }
        let mut left = m;
        while left > MAX_EXACT {
            let Some((_, Reverse(v), version)) = queue.pop() else {
                break;
            };
            let (u, w) = (prev[v], next[v]);
            if version != versions[v] || (self.is_forbidden)(u as u32, w as u32) {
                continue;
            }
            faces.push([u as u32, v as u32, w as u32]);
            let (to_u, to_w, chord) = (
                self.x[v] - self.x[u],
                self.x[w] - self.x[v],
                self.x[w] - self.x[u],
            );
            angles[u] -= to_u.angle_between(chord);
            angles[w] -= to_w.angle_between(chord);
            (next[u], prev[w]) = (w, u);
            is_left[v] = false;
            versions[v] += 1;
            left -= 1;
            for end in [u, w] {
                versions[end] += 1;
                queue.push((
                    rank(end, &prev, &next, &angles),
                    Reverse(end),
                    versions[end],
                ));
            }
        }
        (0..m).filter(|&v| is_left[v]).map(|v| v as u32).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeMap;
    use std::f64::consts::TAU;

    fn outline(x: &[DVec3], forbidden: &dyn Fn(u32, u32) -> bool) -> Triangulation {
        let angles = vec![PI * 0.99; x.len()];
        Outline {
            x,
            angles: &angles,
            is_forbidden: forbidden,
        }
        .triangulate()
    }

    /// Every side of the loop once and forwards, every other edge twice and both ways.
    fn assert_disc(x: &[DVec3], t: &Triangulation) {
        let m = x.len() as u32;
        let mut count: BTreeMap<(u32, u32), usize> = BTreeMap::new();
        for &[a, b, c] in &t.faces {
            for side in [(a, b), (b, c), (c, a)] {
                *count.entry(side).or_default() += 1;
            }
        }
        assert!(
            count.values().all(|&n| n == 1),
            "an edge twice the same way"
        );
        for &(a, b) in count.keys() {
            let is_side = a < m && b < m && (a + 1) % m == b;
            assert_eq!(count.contains_key(&(b, a)), !is_side, "edge {a} {b}");
        }
        assert_eq!(t.faces.len(), x.len() + 2 * t.middles.len() - 2);
    }

    fn area(x: &[DVec3], t: &Triangulation) -> f64 {
        let all: Vec<DVec3> = x.iter().chain(&t.middles).copied().collect();
        let double = |f: &[u32; 3]| {
            let [a, b, c] = f.map(|v| all[v as usize]);
            (b - a).cross(c - a).length()
        };
        0.5 * t.faces.iter().map(double).sum::<f64>()
    }

    fn circle(m: usize) -> Vec<DVec3> {
        let at = |i: usize| TAU * i as f64 / m as f64;
        (0..m)
            .map(|i| DVec3::new(at(i).cos(), at(i).sin(), 0.0))
            .collect()
    }

    #[test]
    fn loops_of_any_length_become_discs_of_the_right_area() {
        for m in [3, 4, 5, 17, 300, 301, 1000] {
            let x = circle(m);
            let t = outline(&x, &|_, _| false);
            assert_disc(&x, &t);
            let exact = 0.5 * m as f64 * (TAU / m as f64).sin();
            assert!((area(&x, &t) - exact).abs() < 1e-12, "{m}");
            assert!(t.middles.is_empty());
        }
    }

    #[test]
    fn a_letter_c_is_filled_inside_only() {
        // Outer arc, tip, inner arc back, tip.
        let at = |r: f64, i: usize| {
            let angle = 0.3 + (TAU - 0.6) * i as f64 / 39.0;
            DVec3::new(r * angle.cos(), r * angle.sin(), 0.0)
        };
        let outer = (0..40).map(|i| at(1.0, i));
        let x: Vec<DVec3> = outer.chain((0..40).rev().map(|i| at(0.8, i))).collect();
        let t = outline(&x, &|_, _| false);
        assert_disc(&x, &t);
        let shoelace = |i: usize| 0.5 * x[i].cross(x[(i + 1) % 80]).z;
        let exact: f64 = (0..80).map(shoelace).sum();
        assert!((area(&x, &t) - exact).abs() < 1e-12, "{}", area(&x, &t));
    }

    #[test]
    fn forbidden_chords_are_never_used() {
        let x = circle(4);
        let t = outline(&x, &|a, b| (a.min(b), a.max(b)) == (0, 2));
        assert_disc(&x, &t);
        assert!(t.faces.iter().all(|f| !(f.contains(&0) && f.contains(&2))));
        // With neither diagonal there is no way but through the middle.
        let t = outline(&x, &|a, b| a.abs_diff(b) == 2);
        assert_disc(&x, &t);
        assert_eq!(t.middles.len(), 1);
        let long = circle(400);
        let t = outline(&long, &|a, b| a.abs_diff(b) == 2 || a.abs_diff(b) == 398);
        assert_disc(&long, &t);
    }

    #[test]
    fn any_points_will_do() {
        let mut random = crate::mesh::noise::SplitMix64::new(5);
        for m in 3..40 {
            let mut x: Vec<DVec3> = (0..m)
                .map(|_| DVec3::from_array(std::array::from_fn(|_| random.gaussian())))
                .collect();
            assert_disc(&x, &outline(&x, &|_, _| false));
            x[m - 1] = x[0];
            x[m / 2] = x[1];
            assert_disc(&x, &outline(&x, &|_, _| false));
            let same = vec![DVec3::ONE; m];
            assert_disc(&same, &outline(&same, &|_, _| false));
        }
    }
}
