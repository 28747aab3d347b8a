//! The circle-angle energy once more, by inversion: no code in common with the crate's own.

use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};

use glam::DVec3;
use umbilic::soup::PolygonSoup;

/// Angles between the circumcircles at the interior edges.
pub(crate) struct Angles {
    interior: Vec<(u32, u32, f64)>,
    boundary: Vec<(u32, u32)>,
    on_boundary: Vec<bool>,
}

impl Angles {
    pub(crate) fn of(soup: &PolygonSoup) -> Self {
        let mut opposite: BTreeMap<(u32, u32), Vec<u32>> = BTreeMap::new();
        for f in soup.faces() {
            for c in 0..3 {
                let (a, b, o) = (f[c], f[(c + 1) % 3], f[(c + 2) % 3]);
                opposite.entry((a.min(b), a.max(b))).or_default().push(o);
            }
        }
        let x = |v: u32| soup.positions[v as usize];
        let mut on_boundary = vec![false; soup.positions.len()];
        let (mut interior, mut boundary) = (Vec::new(), Vec::new());
        for ((i, j), o) in opposite {
            if let [k, l] = o[..] {
                // Inversion at v_i makes both circumcircles straight lines.
                let image = |v: u32| (x(v) - x(i)) / x(v).distance_squared(x(i));
                let angle = turn(image(k), image(j), image(l));
                interior.push((i, j, angle));
            } else {
                boundary.push((i, j));
                on_boundary[i as usize] = true;
                on_boundary[j as usize] = true;
            }
        }
        Self {
            interior,
            boundary,
            on_boundary,
        }
    }

    /// Number of interior edges.
    pub(crate) fn len(&self) -> usize {
        self.interior.len()
    }

    /// Ends of the interior edges.
    pub(crate) fn ends(&self) -> impl Iterator<Item = (u32, u32)> {
        self.interior.iter().map(|&(i, j, _)| (i, j))
    }

    pub(crate) fn boundary_vertices(&self) -> impl Iterator<Item = usize> {
        (0..self.on_boundary.len()).filter(|&v| self.on_boundary[v])
    }

    /// Edges whose four corners lie on a circle.
    pub(crate) fn circular_edges(&self) -> usize {
        self.interior
            .iter()
            .filter(|edge| edge.2.sin() < 1e-6)
            .count()
    }

    /// `2 Σ β - 2πN` of a closed mesh.
    pub(crate) fn closed_energy(&self) -> f64 {
        assert!(self.boundary.is_empty());
        self.edges_twice()
    }

    /// `2 Σ β - 2πN` over interior edges and interior vertices: differs from
    /// [`Self::interior_energy`] by what does not move with a fixed boundary strip.
    pub(crate) fn edges_twice(&self) -> f64 {
        let vertices = self.on_boundary.iter().filter(|&&on| !on).count();
        2.0 * self.interior.iter().map(|edge| edge.2).sum::<f64>() - TAU * vertices as f64
    }

    /// `Σ W_i` over interior vertices.
    pub(crate) fn interior_energy(&self) -> f64 {
        let mut energy: Vec<f64> = vec![-TAU; self.on_boundary.len()];
        for &(i, j, angle) in &self.interior {
            energy[i as usize] += angle;
            energy[j as usize] += angle;
        }
        energy
            .iter()
            .zip(&self.on_boundary)
            .filter(|v| !v.1)
            .map(|v| v.0)
            .sum()
    }
}

/// The energy of a surface whose two boundary loops are each closed by a vertex at infinity.
pub(crate) fn free_boundary(soup: &PolygonSoup) -> f64 {
    let angles = Angles::of(soup);
    let x = |v: u32| soup.positions[v as usize];
    let mut sum: f64 = angles.interior.iter().map(|edge| edge.2).sum();
    let mut around: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    for &(a, b) in &angles.boundary {
        around.entry(a).or_default().push(b);
        around.entry(b).or_default().push(a);
    }
    // A boundary edge meets the line to infinity at the supplement of the opposite angle.
    for f in soup.faces() {
        for [a, b, o] in [[f[0], f[1], f[2]], [f[1], f[2], f[0]], [f[2], f[0], f[1]]] {
            if angles.boundary.contains(&(a.min(b), a.max(b))) {
                sum += PI - (x(a) - x(o)).angle_between(x(b) - x(o));
            }
        }
    }
    sum += around
        .iter()
        .map(|(&v, n)| turn(x(n[0]), x(v), x(n[1])))
        .sum::<f64>();
    2.0 * sum - TAU * (soup.positions.len() + 2) as f64
}

/// Angle by which the path `p`, `q`, `r` turns at `q`.
fn turn(p: DVec3, q: DVec3, r: DVec3) -> f64 {
    let (u, v) = (q - p, r - q);
    u.cross(v).length().atan2(u.dot(v))
}
