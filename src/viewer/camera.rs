//! Turntable camera: pure mathematics, no GPU.
//!
//! The camera circles a `target` on a turntable whose axis `up` stays vertical on
//! screen, so a surface never ends up tilted by accident: moving the pointer out and
//! back returns exactly to the start. Elevation stops at the poles. The axis is not
//! tied to a coordinate: [`Camera::roll`] turns the picture *and* the axis, which sets
//! upright a mesh whose file has another idea of up.
//!
//! View space is right-handed: x right, y up, the camera looks along −z. Clip space is
//! WebGPU's (depth 0 to 1). Matrices are named `to_from`, so products read by adjacency.
//! The field of view belongs to the *shorter* side of the viewport: resizing a window
//! never pushes a fitted surface out of the picture.

use std::f32::consts::{FRAC_PI_2, PI};

use glam::camera::rh::proj::directx::perspective;
use glam::{Mat3, Mat4, Quat, Vec2, Vec3};

/// Tangent of half the field of view along the shorter side (28° in all): long enough
/// a lens that a torus looks round, short enough that near and far can be told apart.
const TAN_HALF_FIELD: f32 = 0.25;
/// Air around a fitted bounding sphere.
const FIT_MARGIN: f32 = 1.06;
/// How far a followed surface may grow over the picture before the camera goes back.
const TOLERATED: f32 = 1.04;
/// Distances allowed, in radii of what is looked at.
const DISTANCE_RANGE: (f32, f32) = (0.02, 40.0);

/// Sine of half the field of view.
fn sine_half_field() -> f32 {
    TAN_HALF_FIELD / TAN_HALF_FIELD.hypot(1.0)
}

/// A ball containing every finite point of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// Centre of the bounding box of the points.
    pub center: Vec3,
    /// Largest distance from the centre; positive.
    pub radius: f32,
}

impl Sphere {
    /// Ball about the centre of the bounding box; points that are not finite are left
    /// out. Without any extent (no point, or one) the radius is 1, so that a camera
    /// can always be placed.
    pub fn around(points: impl Iterator<Item = Vec3> + Clone) -> Self {
        let finite = points.filter(|p| p.is_finite());
        let (low, high) = finite.clone().fold(
            (Vec3::splat(f32::INFINITY), Vec3::splat(f32::NEG_INFINITY)),
            |(low, high), p| (low.min(p), high.max(p)),
        );
        if low.x > high.x {
            return Self {
                center: Vec3::ZERO,
                radius: 1.0,
            };
        }
        // Halved before adding: the sum of two large coordinates must not overflow.
        let center = 0.5 * low + 0.5 * high;
        let radius = finite.map(|p| p.distance(center)).fold(0.0, f32::max);
        let usable = radius > 0.0 && radius.is_finite();
        Self {
            center,
            radius: if usable { radius } else { 1.0 },
        }
    }
}

/// Where the picture is taken from.
#[derive(Clone, Debug, PartialEq)]
pub struct Camera {
    target: Vec3,
    distance: f32,
    /// Rotation whose columns are the camera's right, up and backward axes.
    world_from_view: Quat,
    /// Axis of the turntable, a unit vector.
    up: Vec3,
    /// Width and height in pixels.
    viewport: Vec2,
    /// What the clip planes must enclose.
    bounds: Sphere,
    /// What share of the surface's depth is cut away in front.
    cut: f32,
    /// Whether nobody has chosen what part is seen: a surface that grows is then followed.
    follows: bool,
}

impl Default for Camera {
    fn default() -> Self {
        let mut camera = Self {
            target: Vec3::ZERO,
            distance: 1.0,
            world_from_view: Quat::IDENTITY,
            up: Vec3::Y,
            viewport: Vec2::ONE,
            bounds: Sphere {
                center: Vec3::ZERO,
                radius: 1.0,
            },
            cut: 0.0,
            follows: true,
        };
        camera.home(false);
        camera
    }
}

impl Camera {
    /// Numbers in a serialised camera.
    pub const LENGTH: usize = 11;

    /// Sets the size of the picture in pixels; zero counts as one.
    pub fn resize(&mut self, width: u32, height: u32) {
        self.viewport = Vec2::new(width.max(1) as f32, height.max(1) as f32);
    }

    /// Tells what the surface occupies now. Moves the clip planes, and the camera only
    /// where a surface that was fitted would grow out of the picture: it must not jump
    /// because the surface flows.
    pub fn set_bounds(&mut self, bounds: Sphere) {
        self.bounds = bounds;
        let reach = self.target.distance(bounds.center) + bounds.radius;
        if self.follows && FIT_MARGIN * reach > self.distance * sine_half_field() * TOLERATED {
            self.fit();
        }
    }

    /// Cuts away what is nearer than a plane across the line of sight, which stands at this share of
    /// the way through the surface.
    pub fn set_cut(&mut self, share: f32) {
        self.cut = share.clamp(0.0, 1.0);
    }

    /// Centres the bounding sphere and makes it fill the picture, from where the camera
    /// stands now.
    pub fn fit(&mut self) {
        self.target = self.bounds.center;
        self.distance = FIT_MARGIN * self.bounds.radius / sine_half_field();
        self.follows = true;
    }

    /// Fits from the standard direction, a little from the left and from above: where z is up more
    /// from above than where y is, as what lies flat is seen best so.
    pub fn home(&mut self, is_z_up: bool) {
        let (up, upright, elevation) = if is_z_up {
            (Vec3::Z, Quat::from_rotation_x(FRAC_PI_2), 0.63)
        } else {
            (Vec3::Y, Quat::IDENTITY, 0.42)
        };
        self.up = up;
        self.world_from_view =
            upright * Quat::from_rotation_y(-0.55) * Quat::from_rotation_x(-elevation);
        self.fit();
    }

    /// Turns the surface as if dragged by `(dx, dy)` pixels (y down); half a turn for a
    /// drag across the shorter side.
    pub fn orbit(&mut self, dx: f32, dy: f32) {
        let angle = Vec2::new(dx, dy) * (PI / self.viewport.min_element());
        let elevation = self.elevation();
        let rise = angle.y.clamp(-FRAC_PI_2 - elevation, FRAC_PI_2 - elevation);
        let turn = Quat::from_axis_angle(self.up, -angle.x);
        let tilt = Quat::from_rotation_x(-rise);
        self.world_from_view = (turn * self.world_from_view * tilt).normalize();
    }

    /// Turns the picture anticlockwise by `angle` radians, and the turntable with it.
    pub fn roll(&mut self, angle: f32) {
        let turn = Quat::from_axis_angle(self.backward(), -angle);
        self.world_from_view = (turn * self.world_from_view).normalize();
        self.up = (turn * self.up).normalize();
    }

    /// Looks against a direction, at the same point from as far. Nothing changes where there is
    /// none, or where it is that of the turntable's axis.
    pub fn face(&mut self, direction: Vec3) {
        let backward = direction.normalize_or_zero();
        let Some(right) = self.up.cross(backward).try_normalize() else {
            return;
        };
        let axes = Mat3::from_cols(right, backward.cross(right), backward);
        self.world_from_view = Quat::from_mat3(&axes);
    }

    /// Moves the surface with a pointer that moved by `(dx, dy)` pixels (y down).
    pub fn pan(&mut self, dx: f32, dy: f32) {
        self.target -= self.world_from_view * self.view_offset(Vec2::new(dx, dy));
        self.follows = false;
    }

    /// Comes closer by `factor` (below 1: goes away) while the point of the target's
    /// plane under pixel `(x, y)` stays where it is.
    pub fn zoom(&mut self, factor: f32, x: f32, y: f32) {
        if !(factor > 0.0 && factor.is_finite()) {
            return;
        }
        let (nearest, farthest) = DISTANCE_RANGE;
        let closest = nearest * self.bounds.radius;
        let distance = (self.distance / factor).clamp(closest, farthest * self.bounds.radius);
        let cursor = self.view_offset(Vec2::new(x, y) - 0.5 * self.viewport);
        let shift = cursor * (1.0 - distance / self.distance);
        self.target += self.world_from_view * shift;
        self.distance = distance;
        self.follows = false;
    }

    /// Rigid motion into view space.
    pub fn view_from_world(&self) -> Mat4 {
        Mat4::from_quat(self.world_from_view.conjugate()) * Mat4::from_translation(-self.eye())
    }

    /// Perspective projection; the clip planes just enclose the bounding sphere.
    pub fn clip_from_view(&self) -> Mat4 {
        let tangent = TAN_HALF_FIELD * self.viewport / self.viewport.min_element();
        let (near, far) = self.clip_planes();
        perspective(
            2.0 * tangent.y.atan(),
            self.viewport.x / self.viewport.y,
            near,
            far,
        )
    }

    /// World to clip space.
    pub fn clip_from_world(&self) -> Mat4 {
        self.clip_from_view() * self.view_from_world()
    }

    /// Distances of the near and far clip plane, `0 < near < far`. The near one is what cuts the
    /// surface open.
    pub fn clip_planes(&self) -> (f32, f32) {
        let depth = (self.eye() - self.bounds.center).dot(self.backward());
        let reach = 1.01 * self.bounds.radius;
        // Inside the sphere something must still keep the near plane off the eye, and a
        // depth buffer of 24 bits tells points apart up to a ratio of about 10⁴.
        let far = (depth + reach).max(1e-3 * self.distance);
        let front = depth - reach + 2.0 * self.cut * reach;
        let near = front.max(0.02 * self.distance).max(1e-4 * far);
        (near, far.max(2.0 * near))
    }

    /// Size of a pixel in the world at unit depth.
    pub fn pixel_size(&self) -> f32 {
        2.0 * TAN_HALF_FIELD / self.viewport.min_element()
    }

    /// The camera as numbers: target, distance, rotation (x, y, z, w), turntable axis.
    /// Independent of the size of the picture.
    pub fn to_array(&self) -> [f32; Self::LENGTH] {
        let (t, q, u) = (self.target, self.world_from_view, self.up);
        [
            t.x,
            t.y,
            t.z,
            self.distance,
            q.x,
            q.y,
            q.z,
            q.w,
            u.x,
            u.y,
            u.z,
        ]
    }

    /// Takes over numbers of [`Camera::to_array`]. Refuses (returns false and changes
    /// nothing) when there are not [`Camera::LENGTH`] finite ones, when the distance is
    /// not positive, or when rotation or axis vanish: links are typed by people.
    pub fn set_from_slice(&mut self, numbers: &[f32]) -> bool {
        let &[tx, ty, tz, distance, x, y, z, w, ux, uy, uz] = numbers else {
            return false;
        };
        let rotation = Quat::from_xyzw(x, y, z, w);
        let up = Vec3::new(ux, uy, uz);
        let proper = numbers.iter().all(|number| number.is_finite())
            && distance > 0.0
            && rotation.length_squared() > 1e-6
            && up.length_squared() > 1e-6;
        if proper {
            self.target = Vec3::new(tx, ty, tz);
            self.distance = distance;
            self.world_from_view = rotation.normalize();
            self.up = up.normalize();
            self.follows = false;
        }
        proper
    }

    /// Where what is seen at a pixel begins, on the near clip plane, and its direction.
    pub fn ray(&self, x: f32, y: f32) -> (Vec3, Vec3) {
        let direction = self.sight(x, y);
        let near = self.clip_planes().0;
        (self.unproject(x, y, near), direction)
    }

    /// The direction of the line of sight through a pixel.
    fn sight(&self, x: f32, y: f32) -> Vec3 {
        let offset = self.view_offset(Vec2::new(x, y) - 0.5 * self.viewport);
        (self.world_from_view * (offset - self.distance * Vec3::Z)).normalize()
    }

    /// The pixel a point is seen at, and its distance from the plane of the eye; `None` from
    /// behind.
    pub fn project(&self, point: Vec3) -> Option<(Vec2, f32)> {
        let seen = self.world_from_view.conjugate() * (point - self.eye());
        let depth = -seen.z;
        let offset = Vec2::new(seen.x, -seen.y) / (depth * self.pixel_size());
        (depth > 0.0).then(|| (0.5 * self.viewport + offset, depth))
    }

    /// The point seen at a pixel at such a distance from the plane of the eye.
    pub fn unproject(&self, x: f32, y: f32, depth: f32) -> Vec3 {
        let direction = self.sight(x, y);
        self.eye() - direction * (depth / direction.dot(self.backward()))
    }

    fn eye(&self) -> Vec3 {
        self.target + self.distance * self.backward()
    }

    fn backward(&self) -> Vec3 {
        self.world_from_view * Vec3::Z
    }

    /// Axis of the turntable, a unit vector.
    pub fn up(&self) -> Vec3 {
        self.up
    }

    /// Angle above the turntable, in radians. By two axes, because an arc sine alone loses half its
    /// digits at the poles and would let the camera creep past them.
    pub fn elevation(&self) -> f32 {
        let upward = self.world_from_view * Vec3::Y;
        self.backward().dot(self.up).atan2(upward.dot(self.up))
    }

    /// Vector of the target's plane, in view space, that spans `pixels` on screen.
    fn view_offset(&self, pixels: Vec2) -> Vec3 {
        let world_per_pixel = self.pixel_size() * self.distance;
        Vec3::new(pixels.x, -pixels.y, 0.0) * world_per_pixel
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZES: [(u32, u32); 3] = [(1280, 800), (400, 900), (512, 512)];

    fn looking_at(center: Vec3, radius: f32, (width, height): (u32, u32)) -> Camera {
        let mut camera = Camera::default();
        camera.resize(width, height);
        camera.set_bounds(Sphere { center, radius });
        camera.home(false);
        camera
    }

    /// Pixel at which a point of the world appears.
    fn pixel(camera: &Camera, point: Vec3) -> Vec2 {
        let ndc = camera.clip_from_world().project_point3(point);
        (Vec2::new(ndc.x, -ndc.y) + 1.0) * 0.5 * camera.viewport
    }

    #[test]
    fn a_place_is_faced_at_the_same_point_from_as_far_with_the_axis_upright() {
        let before = looking_at(Vec3::new(1.0, 2.0, 3.0), 2.0, SIZES[0]);
        for direction in [Vec3::X, Vec3::new(-3.0, 0.2, 1.0), Vec3::NEG_Z] {
            let mut camera = before.clone();
            camera.face(7.0 * direction);
            assert!(camera.backward().distance(direction.normalize()) < 1e-6);
            assert!((camera.eye().distance(camera.target) - before.distance).abs() < 1e-5);
            assert_eq!(camera.target, before.target);
            let right = camera.world_from_view * Vec3::X;
            assert!(right.dot(camera.up).abs() < 1e-6, "upright");
        }
        for none in [Vec3::ZERO, Vec3::Y, Vec3::NEG_Y] {
            let mut camera = before.clone();
            camera.face(none);
            assert_eq!(camera, before);
        }
    }

    #[test]
    fn a_surface_is_seen_upright_from_in_front_and_above_by_either_axis() {
        let mut camera = looking_at(Vec3::ZERO, 1.0, SIZES[0]);
        for (is_z_up, up, front) in [(false, Vec3::Y, Vec3::Z), (true, Vec3::Z, Vec3::NEG_Y)] {
            camera.home(is_z_up);
            let top = pixel(&camera, 0.5 * up);
            let foot = pixel(&camera, -0.5 * up);
            assert!(
                (top.x - foot.x).abs() < 1e-3 && top.y < foot.y - 100.0,
                "upright"
            );
            assert!(camera.eye().dot(up) > 0.3 && camera.eye().dot(front) > 0.3);
        }
    }

    fn on_sphere(center: Vec3, radius: f32) -> Vec<Vec3> {
        let golden = PI * (3.0 - 5f32.sqrt());
        let point = |i: i32| {
            let z = 1.0 - (2 * i + 1) as f32 / 500.0;
            let (sin, cos) = (golden * i as f32).sin_cos();
            center + radius * Vec3::new(cos * (1.0 - z * z).sqrt(), sin * (1.0 - z * z).sqrt(), z)
        };
        (0..500).map(point).collect()
    }

    #[test]
    fn a_point_is_found_again_at_its_pixel() {
        let camera = looking_at(Vec3::new(3.0, 1.0, -2.0), 2.0, SIZES[0]);
        for point in on_sphere(Vec3::new(3.0, 1.0, -2.0), 2.0) {
            let (at, depth) = camera.project(point).expect("in front");
            assert!(at.distance(pixel(&camera, point)) < 1e-2);
            assert!(camera.unproject(at.x, at.y, depth).distance(point) < 1e-5);
        }
    }

    #[test]
    fn fit_contains_the_bounding_sphere_and_fills_the_shorter_side() {
        for (center, radius) in [
            (Vec3::ZERO, 1.0),
            (Vec3::new(40.0, -7.0, 3.0), 2e-3),
            (Vec3::ONE, 3e4),
        ] {
            for size in SIZES {
                let camera = looking_at(center, radius, size);
                let mut reach = 0f32;
                for point in on_sphere(center, radius) {
                    let ndc = camera.clip_from_world().project_point3(point);
                    assert!((0.0..=1.0).contains(&ndc.z), "depth {} clipped", ndc.z);
                    assert!(ndc.x.abs() <= 1.0 && ndc.y.abs() <= 1.0, "{ndc} outside");
                    reach = reach.max(ndc.x.abs()).max(ndc.y.abs());
                }
                assert!(reach > 0.9, "fills only {reach} of {size:?}");
            }
        }
    }

    #[test]
    fn zoom_keeps_the_point_under_the_cursor() {
        for size in SIZES {
            let mut camera = looking_at(Vec3::new(1.0, 2.0, 3.0), 2.0, size);
            let cursor = Vec2::new(0.2, 0.7) * camera.viewport;
            let offset = camera.view_offset(cursor - 0.5 * camera.viewport);
            let point = camera.target + camera.world_from_view * offset;
            for factor in [1.3, 0.5, 4.0, 0.9] {
                camera.zoom(factor, cursor.x, cursor.y);
                assert!(pixel(&camera, point).distance(cursor) < 0.02);
            }
        }
    }

    #[test]
    fn zoom_stops_at_both_ends_and_ignores_nonsense() {
        let mut camera = looking_at(Vec3::ZERO, 1.0, SIZES[0]);
        camera.zoom(1e9, 640.0, 400.0);
        assert_eq!(camera.distance, DISTANCE_RANGE.0);
        camera.zoom(1e-9, 640.0, 400.0);
        assert_eq!(camera.distance, DISTANCE_RANGE.1);
        let before = camera.clone();
        for factor in [0.0, -1.0, f32::NAN, f32::INFINITY] {
            camera.zoom(factor, 0.0, 0.0);
        }
        assert_eq!(camera, before);
    }

    #[test]
    fn orbit_keeps_the_distance_and_the_horizon() {
        let mut camera = looking_at(Vec3::new(5.0, 0.0, -1.0), 2.0, SIZES[0]);
        let distance = camera.distance;
        for step in 0..2000 {
            camera.orbit((step % 37) as f32 - 11.0, (step % 53) as f32 - 25.0);
            assert!((camera.eye().distance(camera.target) / distance - 1.0).abs() < 1e-5);
            let right = camera.world_from_view * Vec3::X;
            assert!(
                right.dot(camera.up).abs() < 1e-4,
                "the horizon tilts by {}",
                right.dot(camera.up)
            );
            assert!(camera.elevation().abs() <= FRAC_PI_2 + 1e-4);
        }
    }

    #[test]
    fn orbit_follows_the_pointer() {
        let mut camera = looking_at(Vec3::ZERO, 1.0, SIZES[0]);
        let nearest = camera.backward();
        let before = pixel(&camera, nearest);
        camera.orbit(10.0, 6.0);
        let moved = pixel(&camera, nearest) - before;
        assert!(moved.x > 5.0 && moved.y > 3.0, "moved by {moved}");
    }

    #[test]
    fn orbit_out_and_back_is_the_identity() {
        let mut camera = looking_at(Vec3::ZERO, 1.0, SIZES[0]);
        let start = camera.world_from_view;
        camera.orbit(300.0, 20.0);
        camera.orbit(-120.0, -60.0);
        camera.orbit(-180.0, 40.0);
        assert!(start.angle_between(camera.world_from_view) < 1e-3);
    }

    #[test]
    fn roll_turns_the_picture_and_keeps_the_horizon() {
        let mut camera = looking_at(Vec3::ZERO, 1.0, SIZES[2]);
        let right = camera.world_from_view * Vec3::X;
        camera.roll(FRAC_PI_2);
        let turned = pixel(&camera, 0.5 * right) - 0.5 * camera.viewport;
        assert!(
            turned.x.abs() < 0.1 && turned.y < -50.0,
            "right went to {turned}, not to the top"
        );
        assert!((camera.world_from_view * Vec3::X).dot(camera.up).abs() < 1e-5);
    }

    #[test]
    fn pan_moves_the_target_with_the_pointer() {
        let mut camera = looking_at(Vec3::new(0.0, 1.0, 0.0), 3.0, SIZES[1]);
        let point = camera.target;
        let before = pixel(&camera, point);
        camera.pan(31.0, -17.0);
        assert!((pixel(&camera, point) - before - Vec2::new(31.0, -17.0)).length() < 0.01);
    }

    #[test]
    fn a_fitted_surface_that_grows_is_followed_from_the_same_direction() {
        let mut camera = looking_at(Vec3::ZERO, 1.0, SIZES[0]);
        camera.orbit(40.0, -25.0);
        let (backward, distance) = (camera.backward(), camera.distance);
        let ball = |x: f32, radius: f32| Sphere {
            center: Vec3::new(x, 0.0, 0.0),
            radius,
        };
        for kept in [ball(0.0, 0.4), ball(0.3, 0.7), ball(0.0, 1.02)] {
            camera.set_bounds(kept);
            assert_eq!(camera.distance, distance);
        }
        camera.set_bounds(ball(0.2, 2.0));
        assert!((camera.distance / distance - 2.0).abs() < 1e-5);
        assert!(camera.backward().distance(backward) < 1e-6 && camera.target.x == 0.2);
        camera.zoom(1.5, 10.0, 10.0);
        let chosen = camera.distance;
        camera.set_bounds(ball(0.0, 9.0));
        assert_eq!(camera.distance, chosen);
    }

    #[test]
    fn new_bounds_move_the_clip_planes_but_not_a_picture_that_was_chosen() {
        let mut camera = looking_at(Vec3::ZERO, 1.0, SIZES[0]);
        camera.pan(0.0, 0.0);
        let (point, eye) = (Vec3::new(0.3, 0.1, 0.2), camera.eye());
        let before = pixel(&camera, point);
        camera.set_bounds(Sphere {
            center: Vec3::X,
            radius: 2.5,
        });
        assert!(pixel(&camera, point).distance(before) < 1e-2);
        assert_eq!(camera.eye(), eye);
        for point in on_sphere(Vec3::X, 2.5) {
            assert!((0.0..=1.0).contains(&camera.clip_from_world().project_point3(point).z));
        }
    }

    #[test]
    fn clip_planes_are_ordered_wherever_the_camera_is() {
        let mut camera = looking_at(Vec3::ZERO, 1.0, SIZES[0]);
        for _ in 0..200 {
            camera.zoom(1.1, 900.0, 100.0);
            camera.pan(200.0, -90.0);
            let (near, far) = camera.clip_planes();
            assert!(0.0 < near && near < far && far.is_finite());
            assert!(camera.clip_from_world().is_finite());
        }
    }

    #[test]
    fn a_cut_takes_away_what_is_in_front_and_nothing_else() {
        let (center, radius) = (Vec3::new(3.0, 1.0, -2.0), 2.0);
        let mut camera = looking_at(center, radius, SIZES[0]);
        let is_seen = |camera: &Camera, point: Vec3| {
            (0.0..=1.0).contains(&camera.clip_from_world().project_point3(point).z)
        };
        let at = |share: f32| center + (1.0 - 2.0 * share) * radius * camera.backward();
        let places = [0.02, 0.2, 0.45, 0.55, 0.8, 0.98].map(at);
        for (cut, first) in [(0.0, 0), (0.3, 2), (0.5, 3), (0.9, 5)] {
            camera.set_cut(cut);
            let seen = places.map(|place| is_seen(&camera, place));
            let expected = [0, 1, 2, 3, 4, 5].map(|k| k >= first);
            assert_eq!(seen, expected, "{cut}");
            let (origin, direction) = camera.ray(640.0, 400.0);
            let begin = (origin - center).dot(camera.backward()) / radius;
            assert!((begin - 1.01 * (1.0 - 2.0 * cut)).abs() < 1e-3, "{begin}");
            assert!((direction + camera.backward()).length() < 1e-5);
        }
        // Wherever the camera goes, the planes stay in order.
        camera.set_cut(1.0);
        let (near, far) = camera.clip_planes();
        assert!(0.0 < near && near < far);
    }

    #[test]
    fn serialised_camera_takes_the_same_picture() {
        let mut camera = looking_at(Vec3::new(3.0, 1.0, 2.0), 1.5, SIZES[0]);
        camera.orbit(100.0, -250.0);
        camera.roll(0.7);
        camera.zoom(2.0, 10.0, 20.0);
        let mut restored = looking_at(Vec3::new(3.0, 1.0, 2.0), 1.5, SIZES[0]);
        assert!(restored.set_from_slice(&camera.to_array()));
        // And moves on alike.
        camera.orbit(90.0, 40.0);
        restored.orbit(90.0, 40.0);
        for point in on_sphere(Vec3::new(3.0, 1.0, 2.0), 1.5) {
            assert!(pixel(&camera, point).distance(pixel(&restored, point)) < 0.05);
        }
    }

    #[test]
    fn broken_cameras_are_refused() {
        let good = Camera::default().to_array();
        let mut camera = Camera::default();
        let broken = |at: usize, value: f32| {
            let mut numbers = good;
            numbers[at] = value;
            numbers
        };
        assert!(!camera.set_from_slice(&good[..10]));
        assert!(!camera.set_from_slice(&broken(1, f32::NAN)));
        assert!(!camera.set_from_slice(&broken(3, 0.0)));
        assert!(
            !camera.set_from_slice(
                &[[0.0; 3].as_slice(), &[1.0], &[0.0; 4], &[0.0, 1.0, 0.0]].concat()
            )
        );
        assert_eq!(camera, Camera::default());
    }

    #[test]
    fn bounding_sphere_leaves_out_what_is_not_finite() {
        let points = [
            Vec3::new(-1.0, 0.0, 0.0),
            Vec3::NAN,
            Vec3::new(3.0, 0.0, 0.0),
            Vec3::INFINITY,
        ];
        let sphere = Sphere::around(points.iter().copied());
        assert_eq!(
            sphere,
            Sphere {
                center: Vec3::X,
                radius: 2.0
            }
        );
        assert_eq!(Sphere::around([Vec3::ONE].into_iter()).radius, 1.0);
        assert_eq!(Sphere::around([].into_iter()).radius, 1.0);
    }
}
