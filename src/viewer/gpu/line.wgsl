// Edges and segments as ribbons of a fixed width in pixels, with round ends: one instance each.

struct Line {
    colour: vec4f,
    half_width: f32,
    lift: f32,
}

@group(1) @binding(0) var<uniform> line: Line;

struct Varying {
    @builtin(position) clip: vec4f,
    // In pixels: along the edge from its start, across it, its length.
    @location(0) place: vec3f,
    @location(1) colour: vec4f,
}

// One corner of a ribbon, and where it stands along the line.
struct Corner {
    clip: vec4f,
    place: vec3f,
}

// An edge of the mesh.
@vertex
fn vertex(@builtin(vertex_index) corner: u32, @location(0) ends: vec2u) -> Varying {
    let a = view_position(blended(ends.x, POSITION).xyz);
    let b = view_position(blended(ends.y, POSITION).xyz);
    let at = ribbon(corner, a, b);
    return Varying(at.clip, at.place, line.colour);
}

// A segment between two points of space, in its own colour.
@vertex
fn segment(
    @builtin(vertex_index) corner: u32,
    @location(0) start: vec3f,
    @location(1) end: vec3f,
    @location(2) colour: vec4f,
) -> Varying {
    let at = ribbon(corner, view_position(start), view_position(end));
    return Varying(at.clip, at.place, vec4f(colour.rgb, colour.a * line.colour.a));
}

fn ribbon(corner: u32, start_view: vec3f, end_view: vec3f) -> Corner {
    var a = start_view;
    var b = end_view;
    // Projected below by hand, so cut at the near plane by hand too.
    let plane = -frame.near;
    if min(a.z, b.z) >= plane {
        return Corner(vec4f(2.0, 2.0, 2.0, 1.0), vec3f(0.0));
    }
    if a.z > plane {
        a = mix(a, b, (a.z - plane) / (a.z - b.z));
    }
    if b.z > plane {
        b = mix(b, a, (b.z - plane) / (b.z - a.z));
    }

    let start = pixel_of(a);
    let span = pixel_of(b) - start;
    let length = length(span);
    let along = select(vec2f(1.0, 0.0), span / max(length, 1e-6), length > 1e-6);
    let across = vec2f(-along.y, along.x);

    let reach = line.half_width + 1.0;
    let at_end = (corner & 1u) == 1u;
    let offset_along = select(-reach, length + reach, at_end);
    let offset_across = select(-reach, reach, (corner & 2u) == 2u);
    let pixel = start + offset_along * along + offset_across * across;

    // Nearer to the eye by `lift` pixels, in depth only: half of a ribbon would else sink
    // into the triangle on its far side.
    let depth = select(a.z, b.z, at_end) * (1.0 - line.lift * frame.pixel_size);
    let lifted = frame.clip_from_view * vec4f(0.0, 0.0, depth, 1.0);
    return Corner(
        vec4f(2.0 * pixel / frame.viewport, lifted.z / lifted.w, 1.0),
        vec3f(offset_along, offset_across, length),
    );
}

// Pixels from the centre of the picture, y up.
fn pixel_of(view: vec3f) -> vec2f {
    let clip = frame.clip_from_view * vec4f(view, 1.0);
    return 0.5 * frame.viewport * clip.xy / clip.w;
}

@fragment
fn fragment(in: Varying) -> @location(0) vec4f {
    let beyond = in.place.x - clamp(in.place.x, 0.0, in.place.z);
    let distance = length(vec2f(beyond, in.place.y));
    let coverage = clamp(line.half_width + 0.5 - distance, 0.0, 1.0);
    return vec4f(encoded(in.colour.rgb), in.colour.a * coverage);
}
