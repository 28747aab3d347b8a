// A quiet backdrop: lighter behind the surface, darker towards the corners.

@vertex
fn vertex(@builtin(vertex_index) corner: u32) -> @builtin(position) vec4f {
    // One triangle that covers the picture, at the far plane.
    let x = f32(i32(corner & 1u) * 4 - 1);
    let y = f32(i32(corner >> 1u) * 4 - 1);
    return vec4f(x, y, 1.0, 1.0);
}

@fragment
fn fragment(@builtin(position) pixel: vec4f) -> @location(0) vec4f {
    let from_glow = (pixel.xy - vec2f(0.5, 0.42) * frame.viewport) / length(frame.viewport);
    let light = mix(frame.glow.rgb, frame.corner.rgb, smoothstep(0.0, 0.62, length(from_glow)));
    // Half a byte of fixed noise hides the bands a projector would show
    // (interleaved gradient noise, Jimenez 2014).
    let noise = fract(52.9829189 * fract(dot(pixel.xy, vec2f(0.06711056, 0.00583715))));
    return vec4f(encoded(light) + (noise - 0.5) / 255.0, 1.0);
}
