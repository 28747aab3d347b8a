//! What lies under a pixel.

use glam::{Vec2, Vec3};

use super::camera::Camera;
use super::drawing::Drawing;

/// Where a line of sight meets the surface first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The triangle.
    pub triangle: u32,
    /// The point on it.
    pub point: Vec3,
    /// The nearest of its vertices.
    pub vertex: usize,
}

/// The first triangle along a ray, from either side (Möller & Trumbore
/// [MT97](crate::bibliography#mt97)).
pub fn pick(drawing: &Drawing, origin: Vec3, direction: Vec3) -> Option<Hit> {
    let at = drawing.positions();
    let mut nearest: Option<(f32, u32)> = None;
    for (t, corners) in (0..).zip(drawing.triangles().chunks_exact(3)) {
        let a = at(corners[0]);
        let (u, v) = (at(corners[1]) - a, at(corners[2]) - a);
        let across = direction.cross(v);
        let determinant = u.dot(across);
        let from = origin - a;
        let (s, turned) = (from.dot(across) / determinant, from.cross(u));
        let r = direction.dot(turned) / determinant;
        let depth = v.dot(turned) / determinant;
        // A triangle seen from its edge divides by zero, and no comparison holds.
        let is_inside = s >= 0.0 && r >= 0.0 && s + r <= 1.0 && depth > 0.0;
        if is_inside && nearest.is_none_or(|(best, _)| depth < best) {
            nearest = Some((depth, t));
        }
    }
    let (depth, triangle) = nearest?;
    let point = origin + depth * direction;
    let corners = &drawing.triangles()[3 * triangle as usize..][..3];
    let far = |corner: &&u32| at(**corner).distance(point);
    let corner = corners.iter().min_by(|a, b| far(a).total_cmp(&far(b)))?;
    Some(Hit {
        triangle,
        point,
        vertex: drawing.source(*corner as usize),
    })
}

/// Which of these edges, two vertices each, is seen next to a pixel, `reach` pixels away at
/// most. One that lies behind the surface there is not seen.
pub fn nearest_edge(
    drawing: &Drawing,
    camera: &Camera,
    ends: &[u32],
    at: Vec2,
    reach: f32,
) -> Option<usize> {
    let (origin, direction) = camera.ray(at.x, at.y);
    let position = drawing.positions();
    let surface = pick(drawing, origin, direction).and_then(|hit| camera.project(hit.point));
    let mut best = (reach, None);
    for (n, pair) in ends.chunks_exact(2).enumerate() {
        let [a, b] = [pair[0], pair[1]].map(&position);
        let (Some((from, near)), Some((to, far))) = (camera.project(a), camera.project(b)) else {
            continue;
        };
        // Cut away, or behind the surface.
        let is_cut = near.max(far) < camera.clip_planes().0;
        let is_hidden =
            is_cut || surface.is_some_and(|(_, depth)| near.min(far) > depth + a.distance(b));
        let span = to - from;
        let along = (at - from).dot(span) / span.length_squared().max(f32::MIN_POSITIVE);
        let distance = at.distance(from + along.clamp(0.0, 1.0) * span);
        if !is_hidden && distance < best.0 {
            best = (distance, Some(n));
        }
    }
    best.1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearer_of_two_squares_is_picked() {
        let mut positions = Vec::new();
        for z in [0.0, 1.0] {
            for (x, y) in [(0., 0.), (1., 0.), (1., 1.), (0., 1.)] {
                positions.extend([x, y, z]);
            }
        }
        let triangles = [0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7];
        let drawing = Drawing::new(&positions, &triangles, false).expect("a valid mesh");
        let down = |x, y| pick(&drawing, Vec3::new(x, y, 9.0), Vec3::NEG_Z);
        let hit = down(0.75, 0.25).expect("above the square");
        assert_eq!((hit.triangle, hit.point), (2, Vec3::new(0.75, 0.25, 1.0)));
        assert_eq!(hit.vertex, 5, "its nearest corner");
        assert_eq!(
            down(0.25, 0.75).map(|hit| (hit.triangle, hit.vertex)),
            Some((3, 7))
        );
        assert_eq!(down(1.25, 0.75), None);
        let up = pick(&drawing, Vec3::new(0.75, 0.25, -9.0), Vec3::Z);
        assert_eq!(up.map(|hit| hit.triangle), Some(0));
        let along = pick(&drawing, Vec3::new(-9.0, 0.5, 1.0), Vec3::X);
        assert_eq!(along, None, "seen from the edge");
    }

    #[test]
    fn what_is_drawn_at_a_pixel_is_picked_there() {
        let positions = [-1., -1., 0.3, 1., -1., 0., 0., 1., -0.2];
        let drawing = Drawing::new(&positions, &[0, 1, 2], false).expect("a valid mesh");
        let mut camera = Camera::default();
        camera.resize(640, 360);
        camera.set_bounds(drawing.bounds());
        camera.home(false);
        camera.orbit(40.0, -25.0);
        for (s, r) in [(0.2, 0.3), (0.7, 0.1), (0.1, 0.8)] {
            let [a, b, c] = [0, 3, 6].map(|i| Vec3::from_slice(&positions[i..]));
            let point = a + s * (b - a) + r * (c - a);
            let clip = camera.clip_from_world() * point.extend(1.0);
            let (x, y) = (clip.x / clip.w, clip.y / clip.w);
            let (origin, direction) = camera.ray(320.0 * (1.0 + x), 180.0 * (1.0 - y));
            let hit = pick(&drawing, origin, direction).expect("on the triangle");
            assert!(
                hit.point.distance(point) < 1e-5,
                "{} is not {point}",
                hit.point
            );
            let (pixel, _) = camera.project(point).expect("in front");
            let expected = Vec2::new(320.0 * (1.0 + x), 180.0 * (1.0 - y));
            assert!(pixel.distance(expected) < 1e-2, "{pixel}, {expected}");
        }
    }

    #[test]
    fn edges_are_found_from_beside_them_but_not_through_the_surface() {
        // A square in front, an edge beyond its rim, an edge behind it, one in it.
        let positions = [
            -1., -1., 0., 1., -1., 0., 1., 1., 0., -1., 1., 0., // the square
            1.05, -0.3, 0., 1.05, 0.3, 0., -0.2, 0.5, -1., 0.2, 0.5, -1., -0.2, -0.5, 0., 0.2,
            -0.5, 0.,
        ];
        let drawing = Drawing::new(&positions, &[0, 1, 2, 0, 2, 3], false).expect("a valid mesh");
        let mut camera = Camera::default();
        camera.resize(600, 600);
        camera.set_bounds(drawing.bounds());
        let front = [0., 0., 0., 8., 0., 0., 0., 1., 0., 1., 0.];
        assert!(camera.set_from_slice(&front));
        let ends = [4, 5, 6, 7, 8, 9];
        let at = |x: f32, y: f32| {
            let (pixel, _) = camera.project(Vec3::new(x, y, 0.0)).expect("in front");
            nearest_edge(&drawing, &camera, &ends, pixel, 12.0)
        };
        assert_eq!(at(1.04, 0.0), Some(0));
        assert_eq!(at(0.99, 0.2), Some(0), "over the rim");
        assert_eq!(at(0.0, 0.44), None, "behind the square");
        assert_eq!(at(0.0, -0.48), Some(2));
        assert_eq!(at(0.5, 0.0), None, "nothing within reach");
        camera.set_cut(0.6);
        let (pixel, _) = camera
            .project(Vec3::new(0.0, -0.48, 0.0))
            .expect("in front");
        let found = nearest_edge(&drawing, &camera, &ends, pixel, 12.0);
        assert_eq!(found, None, "cut away");
    }
}
