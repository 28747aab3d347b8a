// Known to every shader: put in front of each of them. Mirrored by `frame.rs`.

struct Frame {
    clip_from_view: mat4x4f,
    view_from_world: mat4x4f,
    weights: vec4f,
    centre: vec4f,
    rim: vec4f,
    front: vec4f,
    back: vec4f,
    marked: vec4f,
    wire: vec4f,
    floor: vec4f,
    floor_u: vec4f,
    floor_v: vec4f,
    viewport: vec2f,
    pixel_size: f32,
    near: f32,
    far: f32,
    field_low: f32,
    field_scale: f32,
    field_strength: f32,
    flatness: f32,
    grazing: f32,
    wire_half_width: f32,
    hemisphere: f32,
    outline: f32,
    occlusion: f32,
    shadow: f32,
    radius: f32,
    n_steps: u32,
}

@group(0) @binding(0) var<uniform> frame: Frame;
// Of each step two layers: position and field value of every vertex; normal, and mean length
// of the sides that meet there. A texture rather than vertex buffers, so that lines can look
// up both ends of an edge; rather than a storage buffer, because WebGL2 and compatibility
// mode have none in the vertex stage.
@group(0) @binding(1) var steps: texture_2d_array<f32>;
// Held, field value missing.
@group(0) @binding(2) var marks: texture_2d<f32>;

const POSITION: u32 = 0u;
const NORMAL: u32 = 1u;

fn place_of(index: u32) -> vec2u {
    return vec2u(index & 2047u, index >> 11u);
}

// At a step, all other weights are zero, and the sum is exactly what that step has. No branch
// leaves those out: in software both sides of one are computed.
fn blended(index: u32, layer: u32) -> vec4f {
    var sum = vec4f(0.0);
    for (var step = 0u; step < frame.n_steps; step += 1u) {
        sum += frame.weights[step] * textureLoad(steps, place_of(index), 2u * step + layer, 0);
    }
    return sum;
}

fn view_position(world: vec3f) -> vec3f {
    return (frame.view_from_world * vec4f(world, 1.0)).xyz;
}

// Corner of one triangle that covers the picture, at the far plane.
fn covering(corner: u32) -> vec4f {
    let x = f32(i32(corner & 1u) * 4 - 1);
    let y = f32(i32(corner >> 1u) * 4 - 1);
    return vec4f(x, y, 1.0, 1.0);
}

// The point of the plane at depth 1 that is seen at a pixel.
fn sight_of(pixel: vec2f) -> vec3f {
    let from_middle = pixel - 0.5 * frame.viewport;
    return vec3f(frame.pixel_size * vec2f(from_middle.x, -from_middle.y), -1.0);
}

// Depth in the last two of four bytes: fine enough, as the clip planes enclose the surface
// closely, and every device can draw into them.
fn packed_depth(depth: f32) -> vec2f {
    let along = clamp((depth - frame.near) / (frame.far - frame.near), 0.0, 1.0);
    let scaled = floor(65535.0 * along + 0.5);
    let high = floor(scaled / 256.0);
    return vec2f(high, scaled - 256.0 * high) / 255.0;
}

fn unpacked_depth(bytes: vec2f) -> f32 {
    let along = dot(bytes, vec2f(65280.0, 255.0)) / 65535.0;
    return frame.near + along * (frame.far - frame.near);
}

// The canvas stores sRGB bytes and does not encode by itself (IEC 61966-2-1).
fn encoded(light: vec3f) -> vec3f {
    let c = clamp(light, vec3f(0.0), vec3f(1.0));
    let curve = 1.055 * pow(max(c, vec3f(1e-5)), vec3f(1.0 / 2.4)) - 0.055;
    return select(curve, 12.92 * c, c <= vec3f(0.0031308));
}
