// The shadow on the floor: the surface seen from straight above, the darker the lower it is,
// and blurred.

@group(1) @binding(0) var sharp: texture_2d<f32>;

// Heights above the floor, in radii of the surface, from which no shadow falls.
const HIGHEST: f32 = 1.7;
// Standard deviation of the blur and where it is cut off, in texels.
const SPREAD: f32 = 4.5;
const CUT: i32 = 10;

struct Varying {
    @builtin(position) clip: vec4f,
    @location(0) height: f32,
}

@vertex
fn vertex_footprint(@builtin(vertex_index) index: u32) -> Varying {
    let point = vec4f(view_position(blended(index, POSITION).xyz), 1.0);
    let at = vec2f(dot(frame.floor_u, point), dot(frame.floor_v, point));
    let height = (dot(frame.floor.xyz, point.xyz) - frame.floor.w) / frame.radius;
    return Varying(vec4f(2.0 * at.x - 1.0, 1.0 - 2.0 * at.y, 0.5, 1.0), height);
}

@fragment
fn fragment_footprint(in: Varying) -> @location(0) vec4f {
    let share = clamp(1.0 - in.height / HIGHEST, 0.0, 1.0);
    return vec4f(share * sqrt(share));
}

@vertex
fn vertex(@builtin(vertex_index) corner: u32) -> @builtin(position) vec4f {
    return covering(corner);
}

@fragment
fn fragment_across(@builtin(position) pixel: vec4f) -> @location(0) vec4f {
    return blurred(pixel.xy, vec2i(1, 0));
}

@fragment
fn fragment_down(@builtin(position) pixel: vec4f) -> @location(0) vec4f {
    return blurred(pixel.xy, vec2i(0, 1));
}

fn blurred(pixel: vec2f, step: vec2i) -> vec4f {
    let last = vec2i(textureDimensions(sharp)) - 1;
    var sum = vec2f(0.0);
    for (var n = -CUT; n <= CUT; n += 1) {
        let weight = exp(-0.5 * f32(n * n) / (SPREAD * SPREAD));
        let texel = clamp(vec2i(pixel) + n * step, vec2i(0), last);
        sum += weight * vec2f(textureLoad(sharp, texel, 0).x, 1.0);
    }
    return vec4f(sum.x / sum.y);
}
