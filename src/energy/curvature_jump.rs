//! How far a free patch is from joining its surroundings with continuous mean curvature.

use crate::mesh::{HalfedgeMesh, Vertex};
use crate::operator::FittedOperators;
use glam::{DMat3, DVec3};
use serde::Serialize;

/// Rings around a vertex of the patch's boundary from which H is extrapolated.
const RINGS: usize = 3;
/// A sample of H whose plane is this badly determined is left out.
const SINGULAR: f64 = 1e-9;

/// The jump of H across the boundary of the free patches.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct CurvatureJump {
    /// J = rms |H_in − H_out| over the boundary vertices, unit 1/length.
    pub absolute: f64,
    /// J over rms H_out: without a unit. 0 where a patch joins with continuous curvature;
    /// on a mesh it is then of the size of an edge, and halves with it.
    pub relative: f64,
    /// Number of boundary vertices where both sides could be extrapolated.
    pub vertices: usize,
}

/// Measures H across the boundary of the free vertices: at each held vertex next to a free
/// one, linear least-squares fits in its tangent plane to H at the free vertices, and at
/// the held vertices not adjacent to a free one, within three rings, both extrapolated to
/// it. H by quadratic fits. `None` if there is no such vertex.
///
/// Patches less than six edges across have too few vertices to tell.
pub fn curvature_jump(mesh: &HalfedgeMesh, x: &[DVec3], free: &[bool]) -> Option<CurvatureJump> {
    let rim: Vec<Vertex> = mesh
        .vertices()
        .filter(|v| !free[v.index()])
        .filter(|&v| mesh.neighbours(v).any(|w| free[w.index()]))
        .collect();
    let mut is_rim = vec![false; free.len()];
    rim.iter().for_each(|v| is_rim[v.index()] = true);
    let mut search = Search::new(mesh);
    let mut wanted = vec![false; free.len()];
    for &v in &rim {
        let around = search.around(v);
        around.iter().for_each(|w| wanted[w.index()] = true);
    }
    let operators = FittedOperators::fit(mesh, x, &wanted);
    let mut jump = CurvatureJump::default();
    let (mut sum, mut size) = (0.0, 0.0);
    for &v in &rim {
        let Some(row) = operators.row(v.index()) else {
            continue;
        };
        let normal = operators.normal(row);
        let around = search.around(v);
        let extrapolate = |is_in: bool| {
            let side = around.iter().map(|w| w.index());
            let side = side.filter(|&w| free[w] == is_in && !is_rim[w]);
            let samples = side.filter_map(|w| {
                let row = operators.row(w)?;
                Some((x[w] - x[v.index()], operators.mean_curvature(row, x)))
            });
            extrapolated(normal, samples)
        };
        if let (Some(inner), Some(outer)) = (extrapolate(true), extrapolate(false)) {
            sum += (inner - outer).powi(2);
            size += outer * outer;
            jump.vertices += 1;
        }
    }
    if jump.vertices == 0 {
        return None;
    }
    jump.absolute = (sum / jump.vertices as f64).sqrt();
    jump.relative = if sum > 0.0 { (sum / size).sqrt() } else { 0.0 };
    jump.absolute.is_finite().then_some(jump)
}

/// Value at the origin of the plane a + bu + cv that fits best.
fn extrapolated(normal: DVec3, samples: impl Iterator<Item = (DVec3, f64)>) -> Option<f64> {
    let first = normal.any_orthonormal_vector();
    let second = normal.cross(first);
    let (mut matrix, mut rhs) = (DMat3::ZERO, DVec3::ZERO);
    let mut scale: f64 = 0.0;
    let points: Vec<(f64, f64, f64)> = samples
        .map(|(p, h)| {
            scale = scale.max(p.length());
            (p.dot(first), p.dot(second), h)
        })
        .collect();
    for (u, v, h) in points {
        let q = DVec3::new(1.0, u / scale, v / scale);
        matrix += DMat3::from_cols(q, q.y * q, q.z * q);
        rhs += h * q;
    }
    let size = matrix.x_axis.x;
    let determinant = matrix.determinant();
    (determinant > SINGULAR * size.powi(3)).then(|| (matrix.inverse() * rhs).x)
}

/// Vertices within a few rings, with scratch memory.
struct Search<'a> {
    mesh: &'a HalfedgeMesh,
    seen_from: Vec<u32>,
    found: Vec<Vertex>,
}

impl<'a> Search<'a> {
    fn new(mesh: &'a HalfedgeMesh) -> Self {
        Self {
            mesh,
            seen_from: vec![u32::MAX; mesh.n_vertices()],
            found: Vec::new(),
        }
    }

    fn around(&mut self, v: Vertex) -> &[Vertex] {
        // A vertex may be asked for twice.
        self.found
            .iter()
            .for_each(|w| self.seen_from[w.index()] = u32::MAX);
        self.found.clear();
        self.found.push(v);
        self.seen_from[v.index()] = v.0;
        let mut begin = 0;
        for _ in 0..RINGS {
            let end = self.found.len();
            for k in begin..end {
                for w in self.mesh.neighbours(self.found[k]) {
                    if self.seen_from[w.index()] != v.0 {
                        self.seen_from[w.index()] = v.0;
                        self.found.push(w);
                    }
                }
            }
            begin = end;
        }
        &self.found
    }
}
