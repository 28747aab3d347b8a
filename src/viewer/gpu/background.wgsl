// A quiet backdrop: lighter behind the surface, darker towards the corners, with the shadow
// of the surface on a floor that is seen only by it.

@group(1) @binding(1) var smooth_sampler: sampler;
@group(1) @binding(3) var footprint: texture_2d<f32>;

@vertex
fn vertex(@builtin(vertex_index) corner: u32) -> @builtin(position) vec4f {
    return covering(corner);
}

@fragment
fn fragment(@builtin(position) pixel: vec4f) -> @location(0) vec4f {
    let from_centre = (pixel.xy - vec2f(0.5, 0.42) * frame.viewport) / length(frame.viewport);
    let light = mix(frame.centre.rgb, frame.rim.rgb, smoothstep(0.0, 0.62, length(from_centre)));
    // Half a byte of fixed noise hides the bands a projector would show
    // (interleaved gradient noise, Jimenez 2014).
    let noise = fract(52.9829189 * fract(dot(pixel.xy, vec2f(0.06711056, 0.00583715))));
    let shade = 1.0 - frame.shadow * shadow_at(sight_of(pixel.xy));
    return vec4f(shade * encoded(light) + (noise - 0.5) / 255.0, 1.0);
}

// How dark the floor is where a line of sight meets it. What is behind the eye or beyond the
// texture has no shadow.
fn shadow_at(sight: vec3f) -> f32 {
    let falling = dot(frame.floor.xyz, sight);
    let depth = frame.floor.w / select(-1e-6, falling, falling < -1e-6);
    let point = vec4f(depth * sight, 1.0);
    let at = vec2f(dot(frame.floor_u, point), dot(frame.floor_v, point));
    let dark = textureSampleLevel(footprint, smooth_sampler, at, 0.0).r;
    let is_met = falling < -1e-6 && depth > 0.0 && all(abs(at - 0.5) < vec2f(0.5));
    return select(0.0, dark, is_met);
}
