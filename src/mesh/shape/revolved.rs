//! Surfaces of revolution about z, with an axis of five-fold symmetry and no crowded poles.
//!
//! An icosphere that stands on a vertex is mapped so that areas keep their shares. What has five
//! equal sectors cannot tell two directions across the axis apart: a flow from there is not led
//! away from shapes of revolution by the triangles.

use super::sphere::icosphere;
use crate::mesh::subdivide::SubdivisionError;
use crate::soup::PolygonSoup;
use glam::{DQuat, DVec2, DVec3};
use std::f64::consts::PI;

/// Points of a meridian between which it is straight.
const POINTS: usize = 4000;
/// Half the thickness of the lip of a stomatocyte, and how far from the axis it begins, as an angle.
const LIP: f64 = 0.08;
const MOUTH: f64 = 0.35;

/// From a meridian over [0, 1], as distance from the axis and height; it begins on top.
fn revolved(
    meridian: impl Fn(f64) -> DVec2,
    level: usize,
) -> Result<PolygonSoup, SubdivisionError> {
    let points: Vec<DVec2> = (0..=POINTS)
        .map(|k| meridian(k as f64 / POINTS as f64))
        .collect();
    let mut areas = vec![0.0];
    for pair in points.windows(2) {
        let area = (pair[0].x + pair[1].x) * pair[0].distance(pair[1]);
        areas.push(areas[areas.len() - 1] + area);
    }
    let whole = areas[POINTS];
    let mut soup = icosphere(level)?;
    let turn = DQuat::from_rotation_arc(soup.positions[0], DVec3::Z);
    for p in &mut soup.positions {
        let on_sphere = turn * *p;
        let area = whole * (0.5 - 0.5 * on_sphere.z).clamp(0.0, 1.0);
        let next = areas.partition_point(|a| *a < area).clamp(1, POINTS);
        let share = (area - areas[next - 1]) / (areas[next] - areas[next - 1]);
        let at = points[next - 1].lerp(points[next], share);
        let around = on_sphere.truncate().normalize_or_zero();
        *p = (at.x * around).extend(at.y);
    }
    Ok(soup)
}

/// The spheroid of width 2 whose height is `ratio` times that.
pub fn spheroid(ratio: f64, level: usize) -> Result<PolygonSoup, SubdivisionError> {
    let meridian = |t: f64| {
        let (sin, cos) = (PI * t).sin_cos();
        DVec2::new(sin, ratio * cos)
    };
    revolved(meridian, level)
}

/// The unit sphere with a mouth below, behind which lies a sphere of radius `inner`: the shape of a
/// stomatocyte, a vesicle that is dented inward.
pub fn stomatocyte(inner: f64, level: usize) -> Result<PolygonSoup, SubdivisionError> {
    let below = |angle: f64| DVec2::new(angle.sin(), -angle.cos());
    let edge = (1.0 - 2.0 * LIP) * below(MOUTH);
    let centre = DVec2::new(0.0, edge.y + (inner * inner - edge.x * edge.x).sqrt());
    let begin = (edge.x / inner).asin();
    let lengths = [PI - MOUTH, PI * LIP, inner * (PI - begin)];
    let whole: f64 = lengths.iter().sum();
    let meridian = |t: f64| {
        let [outer, lip, _] = lengths;
        let s = t * whole;
        let at = if s < outer {
            below(PI - s)
        } else if s < outer + lip {
            // Round the lip, first towards the axis.
            let turn = DVec2::from_angle(-(s - outer) / LIP);
            (1.0 - LIP) * below(MOUTH) + LIP * turn.rotate(below(MOUTH))
        } else {
            centre + inner * below(begin + (s - outer - lip) / inner)
        };
        DVec2::new(at.x.max(0.0), at.y)
    };
    revolved(meridian, level)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::measure::{area, min_angle_degrees, volume};
    use crate::mesh::build_as_given;

    #[test]
    fn spheroids_and_stomatocytes_have_five_sectors_and_their_volume() {
        // 4πr³q/3; that between two spheres.
        let stomatocyte_volume = 4.0 / 3.0 * PI * (1.0 - 0.55f64.powi(3));
        for (soup, expected, off) in [
            (spheroid(0.5, 4), 4.0 / 3.0 * PI * 0.5, 0.01),
            (spheroid(3.0, 4), 4.0 / 3.0 * PI * 3.0, 0.01),
            (stomatocyte(0.55, 4), stomatocyte_volume, 0.05),
        ] {
            let built = build_as_given(&soup.expect("a shape")).expect("a surface");
            assert!(built.repairs.is_empty());
            let (mesh, x) = (&built.mesh, &built.positions);
            let found = volume(mesh, x).expect("closed");
            assert!((found / expected - 1.0).abs() < off, "{found}, {expected}");
            assert!(
                min_angle_degrees(mesh, x) > 5.0,
                "{}",
                min_angle_degrees(mesh, x)
            );
            assert!(area(mesh, x) > 0.0);
            let turn = DQuat::from_rotation_z(2.0 * PI / 5.0);
            for p in x {
                let image = turn * *p;
                let nearest = x.iter().map(|q| q.distance(image));
                assert!(nearest.fold(f64::INFINITY, f64::min) < 1e-9);
            }
        }
    }
}
