//! What every shader knows of a frame: the uniform block of `frame.wgsl`.

use bytemuck::{Pod, Zeroable};
use glam::{Mat4, Vec2, Vec3, Vec4};

use super::camera::Camera;
use super::colour::linear;
use super::drawing::Drawing;
use super::quality::Effects;
use super::style::{FieldRange, Style, WIRE_OPACITY};

/// Mirror of `struct Frame` in `frame.wgsl`, field by field; a test compares the layouts.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Frame {
    /// Perspective projection.
    pub clip_from_view: Mat4,
    /// Rigid motion of the camera.
    pub view_from_world: Mat4,
    /// Weight of each step in the surface that is drawn.
    pub weights: Vec4,
    /// Background behind the surface, linear light like all colours here …
    pub centre: Vec4,
    /// … and at the rim of the picture.
    pub rim: Vec4,
    /// Front of the surface.
    pub front: Vec4,
    /// Back of the surface; equal to the front when there are no two sides.
    pub back: Vec4,
    /// Highlight of marked triangles.
    pub marked: Vec4,
    /// Edges of the mesh, and their opacity.
    pub wire: Vec4,
    /// The floor in view space: its normal, and what that makes of a point on it.
    pub floor: Vec4,
    /// Places on the floor, from 0 to 1 within its shadow's texture: `u = xyz · point + w`,
    /// likewise in view space …
    pub floor_u: Vec4,
    /// … and v.
    pub floor_v: Vec4,
    /// Width and height in pixels.
    pub viewport: Vec2,
    /// Size of a pixel in the world at unit depth.
    pub pixel_size: f32,
    /// Distance of the near clip plane …
    pub near: f32,
    /// … and of the far one.
    pub far: f32,
    /// Field value at the low end of the colour map.
    pub field_low: f32,
    /// 1 / (high − low).
    pub field_scale: f32,
    /// 1 when the surface is coloured by its field, else 0.
    pub field_strength: f32,
    /// 1 for flat shading, else 0.
    pub flatness: f32,
    /// Cosine of incidence up to which a back counts as front.
    pub grazing: f32,
    /// Half the width of an edge of the mesh, in pixels.
    pub wire_half_width: f32,
    /// Strength of the light from sky and ground.
    pub hemisphere: f32,
    /// Strength of the light that outlines the surface.
    pub outline: f32,
    /// 1 when corners are darkened, else 0.
    pub occlusion: f32,
    /// Opacity of the shadow on the floor.
    pub shadow: f32,
    /// Radius of the surface.
    pub radius: f32,
    /// Number of steps that have weights.
    pub n_steps: u32,
    /// Uniform blocks are padded to multiples of 16 bytes.
    pub padding: [u32; 3],
}

/// Cosines up to which a back counts as front. The inside of a closed surface is not seen where
/// it does not pass through itself; else the back is shown up to the silhouette.
const GRAZING_CLOSED: f32 = 0.3;
const GRAZING_OPEN: f32 = 0.02;

/// Gap between surface and floor, in radii of the surface.
const FLOOR_GAP: f32 = 0.02;
/// Half the side of the square that the shadow's texture covers, in the same.
const FOOTPRINT: f32 = 1.6;
/// Sines of the camera's elevation from which the shadow is seen, and is seen in full. From
/// below, the floor would hide the surface.
const SHADOW_ELEVATION: (f32, f32) = (0.02, 0.2);

impl Frame {
    /// The frame in which a surface is seen so, in a picture of such a size in pixels.
    pub fn new(
        camera: &Camera,
        drawing: &Drawing,
        style: &Style,
        field: Option<FieldRange>,
        effects: Effects,
        (width, height): (u32, u32),
    ) -> Self {
        let colour = |srgb| Vec4::from(linear(srgb));
        let palette = style.theme.palette();
        let (low, high) = field.map_or((0.0, 1.0), |field| (field.low, field.high));
        let (near, far) = camera.clip_planes();
        let on = |is_on: bool| if is_on { 1.0 } else { 0.0 };
        let back = if drawing.has_two_sides() {
            palette.back
        } else {
            palette.front
        };
        let floor = Floor::below(drawing, camera);
        let (hidden, seen) = SHADOW_ELEVATION;
        let elevation = ((camera.elevation().sin() - hidden) / (seen - hidden)).clamp(0.0, 1.0);
        Self {
            clip_from_view: camera.clip_from_view(),
            view_from_world: camera.view_from_world(),
            weights: Vec4::from(drawing.weights()),
            centre: colour(palette.centre),
            rim: colour(palette.rim),
            front: colour(palette.front),
            back: colour(back),
            marked: colour(palette.marked),
            wire: colour(palette.wire).truncate().extend(WIRE_OPACITY),
            floor: floor.plane,
            floor_u: floor.u,
            floor_v: floor.v,
            viewport: Vec2::new(width as f32, height as f32),
            pixel_size: camera.pixel_size(),
            near,
            far,
            // The middle of the map where a range is empty: a constant field is no extreme.
            field_low: if high > low { low } else { low - 0.5 },
            field_scale: if high > low { 1.0 / (high - low) } else { 1.0 },
            field_strength: on(field.is_some()),
            flatness: on(style.is_flat),
            grazing: if drawing.is_closed() && !style.inside && style.cut == 0.0 {
                GRAZING_CLOSED
            } else {
                GRAZING_OPEN
            },
            wire_half_width: 0.5 * style.line_width,
            hemisphere: palette.hemisphere,
            outline: palette.outline,
            occlusion: on(effects >= Effects::Occlusion),
            shadow: palette.shadow * elevation * on(effects >= Effects::Shadow),
            radius: drawing.bounds().radius,
            n_steps: drawing.n_steps() as u32,
            padding: [0; 3],
        }
    }
}

/// The floor as shaders know it, in view space.
struct Floor {
    plane: Vec4,
    u: Vec4,
    v: Vec4,
}

impl Floor {
    /// Just below a surface, across the axis of the turntable.
    fn below(drawing: &Drawing, camera: &Camera) -> Self {
        let bounds = drawing.bounds();
        let view = camera.view_from_world();
        let up = camera.up();
        let height = drawing.lowest(up) - FLOOR_GAP * bounds.radius;
        let across = up.any_orthonormal_vector();
        let scale = 0.5 / (FOOTPRINT * bounds.radius);
        // Affine in view space, as what it is in the world: n · x = n' · x' + (n · x − n' · x').
        let affine = |normal: Vec3, offset: f32| {
            let seen = view.transform_vector3(normal);
            let origin = view.transform_point3(Vec3::ZERO);
            seen.extend(offset - seen.dot(origin))
        };
        let place = |axis: Vec3| affine(scale * axis, 0.5 - scale * axis.dot(bounds.center));
        let origin = view.transform_point3(height * up);
        let normal = view.transform_vector3(up);
        Self {
            plane: normal.extend(normal.dot(origin)),
            u: place(across),
            v: place(up.cross(across)),
        }
    }
}

/// Mirror of `struct Line` in `line.wgsl`: how one set of edges is drawn.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct Line {
    /// Linear light and opacity; of segments with colours of their own the opacity only.
    pub colour: Vec4,
    /// Half the width in pixels.
    pub half_width: f32,
    /// How far in front of the surface they are drawn, in pixels.
    pub lift: f32,
    /// Uniform blocks are padded to multiples of 16 bytes.
    pub padding: [f32; 2],
}

impl Line {
    /// A line of such a colour, opacity and width in pixels.
    pub fn new(srgb: u32, opacity: f32, width: f32) -> Self {
        Self {
            colour: Vec4::from(linear(srgb)).truncate().extend(opacity),
            half_width: 0.5 * width,
            lift: 2.0 + width,
            padding: [0.0; 2],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A tetrahedron about (5, 0, 2), lowest at y = −1.
    const POSITIONS: [f32; 12] = [4., -1., 2., 6., -1., 2., 5., 1., 1., 5., 0.5, 3.];

    fn drawing() -> Drawing {
        let triangles = [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3];
        Drawing::new(&POSITIONS, &triangles, true).expect("a valid mesh")
    }

    fn seen(
        drawing: &Drawing,
        turn: impl FnOnce(&mut Camera),
        effects: Effects,
    ) -> (Camera, Frame) {
        let mut camera = Camera::default();
        camera.resize(640, 400);
        camera.set_bounds(drawing.bounds());
        camera.home(false);
        turn(&mut camera);
        let style = Style::default();
        let frame = Frame::new(&camera, drawing, &style, None, effects, (640, 400));
        (camera, frame)
    }

    #[test]
    fn the_floor_lies_just_below_the_surface_and_its_middle_below_the_centre() {
        let drawing = drawing();
        let bounds = drawing.bounds();
        let (camera, frame) = seen(&drawing, |c| c.orbit(130.0, 40.0), Effects::Occlusion);
        let view = camera.view_from_world();
        let height = |p: Vec3| view.transform_point3(p).dot(frame.floor.truncate()) - frame.floor.w;
        let place = |p: Vec3| {
            let p = view.transform_point3(p).extend(1.0);
            Vec2::new(frame.floor_u.dot(p), frame.floor_v.dot(p))
        };
        let gap = FLOOR_GAP * bounds.radius;
        assert!((height(Vec3::new(4., -1., 2.)) - gap).abs() < 1e-5);
        assert!((height(Vec3::new(9., 1., -7.)) - gap - 2.0).abs() < 1e-5);
        let middle = place(bounds.center - 7.0 * Vec3::Y);
        assert!(middle.distance(Vec2::splat(0.5)) < 1e-5, "{middle}");
        for p in POSITIONS.chunks_exact(3) {
            let within = place(Vec3::from_slice(p)) - 0.5;
            assert!(within.length() < 0.5 / FOOTPRINT + 1e-5, "{within}");
        }
        let side = place(bounds.center + 0.3 * bounds.radius * Vec3::X) - 0.5;
        assert!((side.length() - 0.15 / FOOTPRINT).abs() < 1e-5, "{side}");
    }

    #[test]
    fn the_shadow_is_seen_from_above_only_and_only_where_asked() {
        let drawing = drawing();
        let dark = Style::default().theme.palette().shadow;
        let shadow = |dy, effects| seen(&drawing, |c| c.orbit(0.0, dy), effects).1.shadow;
        assert_eq!(shadow(0.0, Effects::Occlusion), dark);
        assert_eq!(shadow(0.0, Effects::Shadow), dark);
        assert_eq!(shadow(0.0, Effects::None), 0.0);
        assert_eq!(shadow(-100.0, Effects::Occlusion), 0.0, "from below");
    }

    #[test]
    fn at_the_time_of_a_step_the_frame_is_that_of_the_step_alone() {
        let mut moving = drawing();
        let grown = POSITIONS.map(|c| 1.5 * c);
        moving.add_step(&grown, 1.0, false).expect("later");
        let still = |frame: Frame| Frame {
            weights: Vec4::X,
            n_steps: 1,
            ..frame
        };
        let turn = |c: &mut Camera| c.orbit(10.0, 20.0);
        for (time, positions) in [(0.0, POSITIONS), (1.0, grown)] {
            moving.set_time(time);
            let mut alone = drawing();
            alone.set_positions(&positions).expect("same length");
            let (_, blended) = seen(&moving, turn, Effects::Occlusion);
            let (_, stepped) = seen(&alone, turn, Effects::Occlusion);
            assert_eq!(still(blended), stepped);
        }
    }
}
