// The surface: a celadon glaze, lit by a studio that turns with the camera.

@group(1) @binding(0) var colour_map: texture_2d<f32>;
@group(1) @binding(1) var smooth_sampler: sampler;
@group(1) @binding(2) var openness: texture_2d<f32>;

struct Varying {
    // Invariant: the highlight is drawn exactly over what it highlights.
    @invariant @builtin(position) clip: vec4f,
    @location(0) position: vec3f,
    // At the centroid: at a silhouette the centre of a pixel may lie off the triangle, and
    // what is extrapolated there speckles the outline. The position is not: its
    // derivatives need equal spacing, and it stays on the ray of the pixel anyway.
    @location(1) @interpolate(perspective, centroid) normal: vec3f,
    // Field value along the colour map, held, value missing.
    @location(2) @interpolate(perspective, centroid) attributes: vec3f,
}

// What the wireframe needs beside that.
struct WireVarying {
    @invariant @builtin(position) clip: vec4f,
    @location(0) position: vec3f,
    @location(1) @interpolate(perspective, centroid) normal: vec3f,
    @location(2) @interpolate(perspective, centroid) attributes: vec3f,
    // Distance from each side of the triangle, 1 in the corner across; 1 everywhere for a
    // side that is no edge. Then the size on screen of edges about, in pixels, without
    // foreshortening.
    @location(3) sides: vec4f,
}

@vertex
fn vertex(@builtin(vertex_index) index: u32) -> Varying {
    return at_vertex(index, blended(index, NORMAL).xyz);
}

// Triangle by triangle: three vertices each, whose corners tell the sides; see `edges.rs`.
@vertex
fn vertex_wire(@builtin(vertex_index) number: u32, @location(0) corner: u32) -> WireVarying {
    let index = corner & 0x1fffffffu;
    let normal = blended(index, NORMAL);
    let at = at_vertex(index, normal.xyz);
    let own = number % 3u;
    let is_edge = vec3<bool>(
        ((corner >> 29u) & 1u) == 1u,
        ((corner >> 30u) & 1u) == 1u,
        ((corner >> 31u) & 1u) == 1u,
    );
    let across = vec3f(f32(own == 0u), f32(own == 1u), f32(own == 2u));
    let size = normal.w / (frame.pixel_size * max(-at.position.z, frame.near));
    let sides = vec4f(select(vec3f(1.0), across, is_edge), size);
    return WireVarying(at.clip, at.position, at.normal, at.attributes, sides);
}

fn at_vertex(index: u32, normal: vec3f) -> Varying {
    let data = blended(index, POSITION);
    let position = view_position(data.xyz);
    let along = (data.w - frame.field_low) * frame.field_scale;
    return Varying(
        frame.clip_from_view * vec4f(position, 1.0),
        position,
        (frame.view_from_world * vec4f(normal, 0.0)).xyz,
        vec3f(along, textureLoad(marks, place_of(index), 0).xy),
    );
}

struct Side {
    // Unit normal on the side of the viewer.
    normal: vec3f,
    is_back: bool,
}

// Both sides of a surface are lit alike, so a Möbius strip has no seam. A back seen at
// grazing incidence counts as front: at a silhouette, multisampling in software lets
// samples of the hidden side through, which would speckle the outline.
fn visible_side(in: Varying, is_front: bool, facet: vec3f, toward_eye: vec3f) -> Side {
    let is_away = dot(facet, toward_eye) < 0.0;
    let facet_outward = select(facet, -facet, is_away == is_front);
    // No vertex normal where all triangles about a vertex are degenerate.
    let is_flat = frame.flatness > 0.5 || dot(in.normal, in.normal) < 0.05;
    let outward = normalize(select(in.normal, facet_outward, is_flat));
    let is_back = !is_front && dot(outward, toward_eye) < -frame.grazing;
    let normal = select(outward, -outward, is_back);
    // What still looks away is bent back until it grazes.
    let bend = max(0.02 - dot(normal, toward_eye), 0.0);
    return Side(normalize(normal + bend * toward_eye), is_back);
}

struct Light {
    // What falls on the surface.
    diffuse: vec3f,
    // What it mirrors.
    gloss: f32,
}

// In linear light: a large warm key from the upper left that wraps around, a cool fill from
// the right, sky and ground; a soft box where the key is mirrored, and an outline at grazing
// incidence. Corners that are not open get less of sky and ground, and a little less of the
// lamps, which are large.
fn studio(normal: vec3f, toward_eye: vec3f, open: f32) -> Light {
    let key_direction = normalize(vec3f(-0.50, 0.66, 0.56));
    let fill_direction = normalize(vec3f(0.80, 0.10, 0.45));
    let key = max((dot(normal, key_direction) + 0.22) / 1.22, 0.0);
    let fill = max(dot(normal, fill_direction), 0.0);
    let around = mix(vec3f(0.34, 0.27, 0.24), vec3f(0.55, 0.60, 0.68), 0.5 + 0.5 * normal.y);
    let lamps = 0.80 * key * vec3f(1.0, 0.97, 0.92) + 0.17 * fill * vec3f(0.80, 0.90, 1.0);
    let mirrored = dot(reflect(-toward_eye, normal), key_direction);
    let box = max((mirrored - 0.80) / 0.20, 0.0);
    let grazing = 1.0 - max(dot(normal, toward_eye), 0.0);
    let outline = frame.outline * grazing * grazing * grazing * grazing;
    return Light(
        mix(0.5, 1.0, open) * lamps + frame.hemisphere * open * around + outline,
        0.16 * open * box * box,
    );
}

fn luminance(light: vec3f) -> f32 {
    return dot(light, vec3f(0.2126, 0.7152, 0.0722));
}

// How open to its surroundings the surface is at a pixel, from the half-size picture: from
// those of the four nearest points that are as far from the eye.
fn openness_at(pixel: vec2f, depth: f32) -> f32 {
    let size = vec2f(textureDimensions(openness));
    let at = pixel * size / frame.viewport - 0.5;
    let base = floor(at);
    var sum = vec2f(1e-4);
    let taps = select(0u, 4u, frame.occlusion > 0.5);
    for (var n = 0u; n < taps; n += 1u) {
        let offset = vec2f(f32(n & 1u), f32(n >> 1u));
        let share = 1.0 - abs(at - base - offset);
        let texel = clamp(base + offset, vec2f(0.0), size - 1.0);
        let data = textureLoad(openness, vec2u(texel), 0);
        let apart = abs(unpacked_depth(data.zw) - depth) / (0.1 * frame.radius);
        let weight = share.x * share.y * max(1.0 - apart, 0.01);
        sum += weight * vec2f(data.x, 1.0);
    }
    return sum.x / sum.y;
}

fn shaded(in: Varying, is_front: bool, facet: vec3f) -> vec3f {
    // Half-way between what is held and what moves, so many pixels away.
    let border = abs(in.attributes.y - 0.5) / max(fwidth(in.attributes.y), 1e-6);
    let along = clamp(in.attributes.x, 0.0, 1.0) * (255.0 / 256.0) + 0.5 / 256.0;
    let value = textureSampleLevel(colour_map, smooth_sampler, vec2f(along, 0.5), 0.0).rgb;
    let toward_eye = normalize(-in.position);
    let side = visible_side(in, is_front, facet, toward_eye);
    let light = studio(side.normal, toward_eye, openness_at(in.clip.xy, -in.position.z));

    let own = select(frame.front.rgb, frame.back.rgb, side.is_back);
    let plain = mix(own, vec3f(luminance(own)), 0.7 * in.attributes.y);
    // Colours that stand for values are lit by white light within narrow bounds: they are
    // those of the colour bar wherever they are. The bounds are reached gently, as a bend of
    // the light would be seen as a line.
    let bright = luminance(light.diffuse) + light.gloss;
    let shade = mix(0.7, 1.05, smoothstep(0.3, 1.1, bright));
    let coloured = frame.field_strength * (1.0 - in.attributes.z);
    let surface = mix(plain * light.diffuse + light.gloss, shade * value, coloured);
    return mix(surface, frame.wire.rgb, clamp(1.5 - border, 0.0, 1.0));
}

@fragment
fn fragment(in: Varying, @builtin(front_facing) is_front: bool) -> @location(0) vec4f {
    // Derivatives before any branch: control flow must be uniform here.
    let facet = cross(dpdx(in.position), dpdy(in.position));
    return vec4f(encoded(shaded(in, is_front, facet)), 1.0);
}

@fragment
fn fragment_wire(in: WireVarying, @builtin(front_facing) is_front: bool) -> @location(0) vec4f {
    let facet = cross(dpdx(in.position), dpdy(in.position));
    let right = dpdx(in.sides.xyz);
    let down = dpdy(in.sides.xyz);
    let slope = sqrt(right * right + down * down);
    let pixels = in.sides.xyz / max(slope, vec3f(1e-6));
    let nearest = min(min(pixels.x, pixels.y), pixels.z);
    let coverage = clamp(frame.wire_half_width + 0.5 - nearest, 0.0, 1.0);
    // A dense mesh would drown in its own lines, and they would make patterns.
    let width = 2.0 * frame.wire_half_width;
    let opacity = frame.wire.a * smoothstep(5.0 * width, 14.0 * width, in.sides.w);
    let surface = Varying(in.clip, in.position, in.normal, in.attributes);
    let light = encoded(shaded(surface, is_front, facet));
    return vec4f(mix(light, encoded(frame.wire.rgb), opacity * coverage), 1.0);
}

// Over triangles to be noticed, whatever they are coloured by.
@fragment
fn fragment_marked(in: Varying, @builtin(front_facing) is_front: bool) -> @location(0) vec4f {
    let facet = cross(dpdx(in.position), dpdy(in.position));
    let toward_eye = normalize(-in.position);
    let light = studio(visible_side(in, is_front, facet, toward_eye).normal, toward_eye, 1.0);
    return vec4f(encoded(frame.marked.rgb * light.diffuse + light.gloss), 0.9);
}

// What the search for corners needs: the normal seen, of which z is positive, and the depth.
@fragment
fn fragment_depth(in: Varying, @builtin(front_facing) is_front: bool) -> @location(0) vec4f {
    let facet = cross(dpdx(in.position), dpdy(in.position));
    let side = visible_side(in, is_front, facet, normalize(-in.position));
    return vec4f(0.5 + 0.5 * side.normal.xy, packed_depth(-in.position.z));
}
