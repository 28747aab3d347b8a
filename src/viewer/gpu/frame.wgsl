// Known to every shader: put in front of each of them. Mirrored by `frame.rs`.

struct Frame {
    clip_from_view: mat4x4f,
    view_from_world: mat4x4f,
    glow: vec4f,
    corner: vec4f,
    front: vec4f,
    back: vec4f,
    fixed_tint: vec4f,
    marked: vec4f,
    viewport: vec2f,
    pixel_size: f32,
    near: f32,
    field_low: f32,
    field_scale: f32,
    field_strength: f32,
    flatness: f32,
    grazing: f32,
}

@group(0) @binding(0) var<uniform> frame: Frame;
// Position and field value of every vertex. A texture rather than vertex buffers, so that
// lines can look up both ends of an edge; rather than a storage buffer, because WebGL2
// and compatibility mode have none in the vertex stage.
@group(0) @binding(1) var vertices: texture_2d<f32>;

fn vertex_at(index: u32) -> vec4f {
    return textureLoad(vertices, vec2u(index & 2047u, index >> 11u), 0);
}

fn view_position(world: vec3f) -> vec3f {
    return (frame.view_from_world * vec4f(world, 1.0)).xyz;
}

// The canvas stores sRGB bytes and does not encode by itself (IEC 61966-2-1).
fn encoded(light: vec3f) -> vec3f {
    let c = clamp(light, vec3f(0.0), vec3f(1.0));
    let curve = 1.055 * pow(max(c, vec3f(1e-5)), vec3f(1.0 / 2.4)) - 0.055;
    return select(curve, 12.92 * c, c <= vec3f(0.0031308));
}
