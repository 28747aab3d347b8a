//! Steps of a closed surface near rest without a part along the conformal maps of space, see
//! [`conformal_fields`].

use super::curvatures::Curvatures;
use super::region::Region;
use crate::flow::conformal_fields;
use glam::DVec3;

/// A field of which so small a share is left, beside those before, is one of them: on a round
/// sphere about its centre the special conformal fields move it as translations do.
const DEPENDENT: f64 = 1e-3;

/// Takes out of the normal speeds `phi` of the free vertices their projections, in L² of the
/// surface, onto the normal parts of the conformal fields and of the translations.
pub(super) fn remove(phi: &mut [f64], at: &Curvatures, region: &Region, x: &[DVec3]) {
    let total: f64 = at.areas().map(|(_, area)| area).sum();
    let centre = at.areas().map(|(v, area)| area * x[v]).sum::<DVec3>() / total;
    let scale = (total / (4.0 * std::f64::consts::PI)).sqrt();
    let mut area_of = vec![0.0; x.len()];
    for (v, area) in at.areas() {
        area_of[v] = area / total;
    }
    let weights: Vec<f64> = region.free.iter().map(|&v| area_of[v as usize]).collect();
    let product = |a: &[f64], b: &[f64]| -> f64 {
        let terms = a.iter().zip(b).zip(&weights);
        terms.map(|((a, b), w)| a * b * w).sum()
    };
    let normal_part = |velocity: &dyn Fn(DVec3) -> DVec3| -> Vec<f64> {
        let speed = |&v: &u32| {
            let y = (x[v as usize] - centre) / scale;
            let row = at.operators.row(v as usize);
            row.map_or(0.0, |row| velocity(y).dot(at.operators.normal(row)))
        };
        region.free.iter().map(speed).collect()
    };
    let conformal =
        (0..conformal_fields::COUNT).map(|k| normal_part(&|y| conformal_fields::velocity(k, y)));
    let translations = DVec3::AXES.map(|axis| normal_part(&|_| axis));
    let mut basis: Vec<Vec<f64>> = Vec::new();
    for mut field in conformal.chain(translations) {
        let before = product(&field, &field);
        for other in &basis {
            let along = product(&field, other);
            subtract(&mut field, other, along);
        }
        let left = product(&field, &field);
        if left <= DEPENDENT * before {
            continue;
        }
        field.iter_mut().for_each(|f| *f /= left.sqrt());
        let along = product(phi, &field);
        subtract(phi, &field, along);
        basis.push(field);
    }
}

fn subtract(a: &mut [f64], b: &[f64], factor: f64) {
    a.iter_mut().zip(b).for_each(|(a, b)| *a -= factor * b);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{build, shape};

    #[test]
    fn conformal_fields_are_taken_out_and_bumps_are_not() {
        let sample = shape::make("ellipsoid", &[("level".into(), 3.0)]).expect("a shape");
        let built = build(&sample.soup).expect("a surface");
        let (mesh, x) = (built.mesh, built.positions);
        let region = Region::new(&mesh, &x, vec![true; x.len()], 1);
        let at = Curvatures::of(&mesh, &x, &region);
        let speeds = |velocity: &dyn Fn(DVec3) -> DVec3| -> Vec<f64> {
            let speed = |v: usize| {
                let row = at.operators.row(v).expect("a fit");
                velocity(x[v]).dot(at.operators.normal(row))
            };
            (0..x.len()).map(speed).collect()
        };
        let size = |phi: &[f64]| phi.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
        for k in 0..conformal_fields::COUNT {
            let mut phi = speeds(&|y| conformal_fields::velocity(k, y));
            let before = size(&phi);
            remove(&mut phi, &at, &region, &x);
            assert!(size(&phi) < 1e-9 * before, "field {k}: {}", size(&phi));
        }
        let mut bumps: Vec<f64> = x.iter().map(|p| (9.0 * p.x).sin() * p.y * p.z).collect();
        let before = size(&bumps);
        remove(&mut bumps, &at, &region, &x);
        assert!(size(&bumps) > 0.9 * before);
    }
}
