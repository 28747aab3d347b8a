//! The volume that surface diffusion keeps: exactly, where its velocity law keeps it to first order.

use crate::flow::constraint::{Constraint, project};
use crate::flow::{Cause, Refusal};
use crate::geometry::measure::{area, face_vector_area, volume};
use crate::mesh::HalfedgeMesh;
use glam::DVec3;

/// The enclosed volume of a closed surface at the start.
///
/// Σ V_i dA = ∫ΔH dA = 0 of the smooth flow. Fitted Laplacians do not quite sum to nothing, and long
/// steps change the volume to second order: each trial is moved along its normals until it encloses
/// what the start did.
#[derive(Clone, Copy, Debug)]
pub(super) struct KeptVolume {
    volume: f64,
    /// A volume of the surface's size. Volumes are compared with it added: that of an immersed
    /// surface may be nothing.
    unit: f64,
}

impl KeptVolume {
    /// `None` of an open surface.
    pub(super) fn of(mesh: &HalfedgeMesh, x: &[DVec3]) -> Option<Self> {
        let volume = volume(mesh, x)?;
        let unit = area(mesh, x).powf(1.5).copysign(volume);
        Some(Self { volume, unit })
    }

    /// Moves the vertices of `y` along their normals, all as far, until the volume is what it was.
    ///
    /// # Errors
    /// [`Cause::Constraints`] where that cannot be done.
    pub(super) fn restore(&self, mesh: &HalfedgeMesh, y: &mut [DVec3]) -> Result<(), Refusal> {
        let normals: Vec<DVec3> = gradient(mesh, y)
            .into_iter()
            .map(DVec3::normalize_or_zero)
            .collect();
        let is_restored = project(y, &normals, |y, take| {
            let Some(volume) = volume(mesh, y) else {
                return;
            };
            take(&[Constraint {
                target: self.volume + self.unit,
                value: volume + self.unit,
                gradient: &gradient(mesh, y),
            }]);
        });
        if is_restored {
            Ok(())
        } else {
            Err(Refusal::of(Cause::Constraints))
        }
    }
}

/// ∂V/∂x_i = ⅓ Σ of the vector areas of the triangles at vertex i.
fn gradient(mesh: &HalfedgeMesh, x: &[DVec3]) -> Vec<DVec3> {
    let mut gradient = vec![DVec3::ZERO; x.len()];
    for f in mesh.faces() {
        let third = face_vector_area(mesh, x, f) / 3.0;
        for v in mesh.face_vertices(f) {
            gradient[v.index()] += third;
        }
    }
    gradient
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::shape;

    #[test]
    fn what_grew_is_drawn_in_along_its_normals() {
        let values = [("level".to_owned(), 2.0)];
        let sphere = shape::make("icosphere", &values).expect("a sphere");
        let mesh = crate::mesh::build(&sphere.soup).expect("a surface").mesh;
        let x = &sphere.soup.positions;
        let kept = KeptVolume::of(&mesh, x).expect("closed");
        for size in [0.9, 1.0, 1.2] {
            let mut y: Vec<DVec3> = x.iter().map(|p| size * *p).collect();
            assert_eq!(kept.restore(&mesh, &mut y), Ok(()));
            let [before, after] = [x, &y].map(|x| volume(&mesh, x).expect("closed"));
            assert!((after / before - 1.0).abs() < 1e-12, "{size}");
            // Normals of the mesh are not quite those of the sphere.
            assert!(
                x.iter()
                    .zip(&y)
                    .all(|(p, q)| p.distance(*q) < 0.03 * (size - 1.0).abs() + 1e-12)
            );
        }
    }
}
