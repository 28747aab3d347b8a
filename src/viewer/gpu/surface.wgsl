// The surface: matte, a little warm, lit by a studio that turns with the camera.

@group(0) @binding(2) var colour_map: texture_2d<f32>;
@group(0) @binding(3) var colour_sampler: sampler;

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

@vertex
fn vertex(
    @builtin(vertex_index) index: u32,
    @location(0) normal: vec3f,
    @location(1) flags: vec4f,
) -> Varying {
    let data = vertex_at(index);
    let position = view_position(data.xyz);
    let along = (data.w - frame.field_low) * frame.field_scale;
    return Varying(
        frame.clip_from_view * vec4f(position, 1.0),
        position,
        (frame.view_from_world * vec4f(normal, 0.0)).xyz,
        vec3f(along, flags.xy),
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

fn lit(albedo: vec3f, normal: vec3f, toward_eye: vec3f) -> vec3f {
    // A large warm key from the upper left, a lamp at the camera so that nothing is lost in
    // the dark, a cool fill from the right, light from the sky and from the floor. They add
    // up to about 1 on what faces the eye: colours of a field are those of its colour bar.
    let key_direction = normalize(vec3f(-0.6, 0.65, 0.48));
    let fill_direction = normalize(vec3f(0.95, 0.1, 0.3));
    let key = max(0.88 * dot(normal, key_direction) + 0.12, 0.0);
    let lamp = max(dot(normal, toward_eye), 0.0);
    let fill = max(dot(normal, fill_direction), 0.0);
    let sky = 0.5 + 0.5 * normal.y;
    let light = 0.8 * key * vec3f(1.0, 0.96, 0.9)
        + 0.24 * lamp
        + 0.2 * fill * vec3f(0.72, 0.84, 1.0)
        + mix(vec3f(0.12, 0.105, 0.095), vec3f(0.15, 0.175, 0.21), sky);

    let halfway = normalize(key_direction + toward_eye);
    let gloss = 0.07 * pow(max(dot(normal, halfway), 0.0), 36.0);
    // Darker towards silhouettes, as if in dust: parts of one colour in front of each other
    // stay apart.
    let contour = 1.0 - 0.42 * pow(1.0 - lamp, 3.0);
    return albedo * light * contour + gloss;
}

@fragment
fn fragment(in: Varying, @builtin(front_facing) is_front: bool) -> @location(0) vec4f {
    // Derivatives and samples before any branch: control flow must be uniform here.
    let facet = cross(dpdx(in.position), dpdy(in.position));
    let along = clamp(in.attributes.x, 0.0, 1.0) * (255.0 / 256.0) + 0.5 / 256.0;
    let map_colour = textureSampleLevel(colour_map, colour_sampler, vec2f(along, 0.5), 0.0).rgb;

    let toward_eye = normalize(-in.position);
    let side = visible_side(in, is_front, facet, toward_eye);
    let plain = select(frame.front.rgb, frame.back.rgb, side.is_back);
    let coloured = frame.field_strength * (1.0 - in.attributes.z);
    let albedo = mix(plain, map_colour, coloured);
    // Not over a field: across the edge of what is held its colours must be comparable.
    let tinted = mix(albedo, frame.fixed_tint.rgb, 0.6 * in.attributes.y * (1.0 - coloured));
    return vec4f(encoded(lit(tinted, side.normal, toward_eye)), 1.0);
}

// Over triangles to be noticed, whatever they are coloured by.
@fragment
fn fragment_marked(in: Varying, @builtin(front_facing) is_front: bool) -> @location(0) vec4f {
    let facet = cross(dpdx(in.position), dpdy(in.position));
    let toward_eye = normalize(-in.position);
    let side = visible_side(in, is_front, facet, toward_eye);
    return vec4f(encoded(lit(frame.marked.rgb, side.normal, toward_eye)), 0.9);
}
