//! What every shader knows of a frame: the uniform block of `frame.wgsl`.

use bytemuck::{Pod, Zeroable};
use glam::{Mat4, Vec2, Vec4};

/// Mirror of `struct Frame` in `frame.wgsl`, field by field; a test compares the layouts.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct Frame {
    /// Perspective projection.
    pub clip_from_view: Mat4,
    /// Rigid motion of the camera.
    pub view_from_world: Mat4,
    /// Background behind the surface, linear light like all colours here …
    pub glow: Vec4,
    /// … and in the corners.
    pub corner: Vec4,
    /// Front of the surface.
    pub front: Vec4,
    /// Back of the surface; equal to the front when there are no two sides.
    pub back: Vec4,
    /// Tint of held vertices.
    pub fixed: Vec4,
    /// Highlight of marked triangles.
    pub marked: Vec4,
    /// Width and height in pixels.
    pub viewport: Vec2,
    /// Size of a pixel in the world at unit depth.
    pub pixel_size: f32,
    /// Distance of the near clip plane.
    pub near: f32,
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
    /// Uniform blocks are padded to multiples of 16 bytes.
    pub padding: [f32; 3],
}

/// Mirror of `struct Line` in `line.wgsl`: how one set of edges is drawn.
#[repr(C)]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub struct Line {
    /// Linear light and opacity; of segments with colours of their own the opacity only.
    pub colour: Vec4,
    /// Half the width in pixels.
    pub half_width: f32,
    /// Where edges are shorter than this on screen, in pixels, they vanish …
    pub fade_from: f32,
    /// … and where they are longer than this, they are drawn in full.
    pub fade_to: f32,
    /// How far in front of the surface they are drawn, in pixels.
    pub lift: f32,
}
