// How open to its surroundings a point of the surface is, found in the picture of normals and
// depths alone: scalable ambient obscurance (McGuire, Mara & Luebke, 2012). Both passes write
// openness into the first byte and keep the depth in the last two.

@group(1) @binding(0) var seen: texture_2d<f32>;

const SAMPLES: u32 = 12u;
// In radii of the surface.
const REACH: f32 = 0.16;

@vertex
fn vertex(@builtin(vertex_index) corner: u32) -> @builtin(position) vec4f {
    return covering(corner);
}

fn is_background(data: vec4f) -> bool {
    return data.z == 1.0 && data.w == 1.0;
}

fn texel_at(pixel: vec2f) -> vec2u {
    return vec2u(clamp(pixel, vec2f(0.0), vec2f(textureDimensions(seen)) - 1.0));
}

// The point of space seen at a pixel of this picture, which is smaller than the viewport.
fn point_at(pixel: vec2f, depth: f32) -> vec3f {
    return depth * sight_of(pixel * frame.viewport / vec2f(textureDimensions(seen)));
}

@fragment
fn fragment(@builtin(position) pixel: vec4f) -> @location(0) vec4f {
    let own = textureLoad(seen, vec2u(pixel.xy), 0);
    if is_background(own) {
        return vec4f(1.0);
    }
    let depth = unpacked_depth(own.zw);
    let point = point_at(pixel.xy, depth);
    let tilt = 2.0 * own.xy - 1.0;
    let normal = vec3f(tilt, sqrt(max(1.0 - dot(tilt, tilt), 0.0)));

    // From near less far around: twelve samples would be too few for so many pixels.
    let size = vec2f(textureDimensions(seen));
    let pixel_size = frame.pixel_size * depth * frame.viewport.y / size.y;
    let pixels = clamp(REACH * frame.radius / pixel_size, 2.0, 0.125 * size.y);
    let reach = pixels * pixel_size;
    // A spiral, turned otherwise at each of 4 × 4 neighbours, over which the blur averages.
    let cell = vec2u(pixel.xy) & vec2u(3u);
    let turn = f32((7u * (4u * cell.x + cell.y)) & 15u) / 16.0;
    var sum = 0.0;
    for (var n = 0u; n < SAMPLES; n += 1u) {
        let along = (f32(n) + 0.5) / f32(SAMPLES);
        let angle = 6.2831853 * (5.0 * along + turn);
        let at = pixel.xy + pixels * along * vec2f(cos(angle), sin(angle));
        // Beyond the picture nothing is known, and nothing darkens.
        let is_seen = all(at >= vec2f(0.0)) && all(at < size);
        let texel = texel_at(at);
        let there = point_at(vec2f(texel) + 0.5, unpacked_depth(textureLoad(seen, texel, 0).zw));
        let way = (there - point) / reach;
        let squared = dot(way, way);
        let near = max(1.0 - squared, 0.0);
        let rise = max(dot(way, normal) - 0.03, 0.0) / (squared + 0.01);
        sum += select(0.0, near * near * near * rise, is_seen);
    }
    let open = clamp(1.0 - 8.0 * sum / f32(SAMPLES), 0.0, 1.0);
    return vec4f(open, 0.0, own.zw);
}

// The mean of 4 × 4 neighbours that are about as far from the eye.
@fragment
fn fragment_blur(@builtin(position) pixel: vec4f) -> @location(0) vec4f {
    let own = textureLoad(seen, vec2u(pixel.xy), 0);
    let depth = unpacked_depth(own.zw);
    var sum = vec2f(0.0);
    for (var n = 0u; n < 16u; n += 1u) {
        let offset = vec2f(f32(n & 3u), f32(n >> 2u)) - 2.0;
        let data = textureLoad(seen, texel_at(pixel.xy + offset), 0);
        let apart = abs(unpacked_depth(data.zw) - depth) / (0.1 * frame.radius);
        sum += max(1.0 - apart, 0.0) * vec2f(data.x, 1.0);
    }
    return vec4f(sum.x / sum.y, 0.0, own.zw);
}
