struct View {
    matrix: mat4x4<f32>,
    right: vec4<f32>,  // directions on the screen; the last numbers of the three are the place of the eye, mm
    up: vec4<f32>,
    back: vec4<f32>,
    screen: vec4<f32>, // width px, height px, time, faintness of what is still to come
    probe: vec4<f32>,  // offset mm, depth bias
    cloud: vec4<f32>,  // place mm, size of a point px
    outside: vec4<f32>, level: vec4<f32>, inside: vec4<f32>, // colours of points by their deviation
    full: vec4<f32>,   // deviation of full colour mm, radius of the scene mm
    sky: vec4<f32>,    // place of the map over the ground mm, one over its sizes
    ground: vec4<f32>, // height mm, spacing of its grid mm, radius mm (0: none), 1 where X is upright
    phase: vec4<f32>,  // place of a line of the grid mm, one over both reaches of occlusion mm
    grid: vec4<f32>,   // colour of the grid
    plane: vec4<f32>,  // what is beyond it is cut away: normal, distance mm
    cut: vec4<f32>,    // colour of what is cut
    path: vec4<f32>,   // place of the whole path, mm
    kinds: array<vec4<f32>, 4>, // colours of its motions
    behind: vec4<f32>, // colour behind everything
}
/// Each pixel is lit, by what stands around too; else the corners of the surfaces only. Constants of a pipeline: a
/// processor that draws goes both ways wherever a number decides.
override ALL: bool = true;
override CUT: bool = true; // something of the part is cut away
@group(0) @binding(0) var<uniform> view: View;
// Over the ground: heights of the part, blurred little and much, mm above the ground; shadow on the ground.
@group(0) @binding(1) var sky: texture_2d<f32>;
@group(0) @binding(2) var smoothly: sampler;

/// Two places on the ground, and the height above it.
fn stands(at: vec3<f32>) -> vec3<f32> {
    let place = select(at, at.zyx, view.ground.w > 0.5);
    return vec3<f32>(place.xy, place.z - view.ground.x);
}

fn above(at: vec2<f32>) -> vec4<f32> {
    return textureSampleLevel(sky, smoothly, (at - view.sky.xy) * view.sky.zw, 0.0);
}

// The ground: a grid and the shadow of the part, both fading into the background.

struct Ground {
    @builtin(position) clip: vec4<f32>,
    @location(0) at: vec2<f32>,
}

@vertex
fn ground_vertex(@builtin(vertex_index) corner: u32) -> Ground {
    let side = vec2<f32>(
        select(-1.0, 1.0, corner == 1u || corner == 2u || corner == 4u),
        select(-1.0, 1.0, corner == 2u || corner == 4u || corner == 5u),
    );
    let at = side * view.ground.z;
    let place = vec3<f32>(at, view.ground.x);
    return Ground(view.matrix * vec4<f32>(select(place, place.zyx, view.ground.w > 0.5), 1.0), at);
}

@fragment
fn ground_fragment(in: Ground) -> @location(0) vec4<f32> {
    let fade = 1.0 - smoothstep(0.3, 1.0, length(in.at) / view.ground.z);
    let cells = (in.at - view.phase.xy) / view.ground.y;
    let away = abs(fract(cells + 0.5) - 0.5) / fwidth(cells);
    let line = clamp(1.0 - min(away.x, away.y), 0.0, 1.0) * view.grid.a * fade;
    let shade = above(in.at).z * fade;
    let alpha = shade + line * (1.0 - shade);
    if (alpha < 0.004) { discard; }
    return vec4<f32>(mix(vec3<f32>(0.04, 0.06, 0.1), view.grid.rgb, line * (1.0 - shade) / alpha), alpha);
}

// Parts: of metal and other matter in a studio with two softboxes, which is fixed to the viewer.

struct Surface {
    @builtin(position) clip: vec4<f32>,
    @location(0) normal: vec3<f32>,
    @location(1) colour: vec4<f32>,
    @location(2) at: vec3<f32>,
    @location(3) @interpolate(flat) finish: f32,
    @location(4) lit: vec4<f32>, // where not each pixel is lit
}

@vertex
fn mesh_vertex(
    @location(0) at: vec3<f32>,
    @location(1) normal: vec3<f32>,
    @location(2) colour: vec4<f32>,
    @location(3) more: vec2<f32>, // 1 if it moves with the probe, finish
) -> Surface {
    let place = at + more.x * view.probe.xyz;
    var lit = colour;
    if (!ALL) { lit = vec4<f32>(shaded(colour.rgb, more.y, normal, place), colour.a); }
    return Surface(view.matrix * vec4<f32>(place, 1.0), normal, colour, place, more.y, lit);
}

/// How much light comes from a direction, seen by the viewer: right, up, towards the viewer.
fn studio(way: vec3<f32>) -> f32 {
    let room = 0.38 + 0.27 * smoothstep(-0.8, 0.8, way.y) - 0.14 * way.x;
    let key = smoothstep(-0.95, -0.45, way.x) * (1.0 - smoothstep(-0.3, 0.15, way.x)) * smoothstep(-0.35, 0.25, way.y);
    let rim = smoothstep(0.55, 0.75, way.x) * (1.0 - smoothstep(0.85, 0.98, way.x)) * smoothstep(-0.6, 0.0, way.y);
    return room + 0.42 * key + 0.2 * rim;
}

/// How much of the light from above arrives, by what stands around.
fn openness(at: vec3<f32>, n: vec3<f32>) -> f32 {
    let place = stands(at);
    let aside = stands(at + n / view.phase.z * 0.6);
    let around = above(aside.xy);
    let near = clamp((around.x - place.z) * view.phase.z, 0.0, 1.0);
    let far = clamp((around.y - place.z) * view.phase.w, 0.0, 1.0);
    return (1.0 - 0.24 * near) * (1.0 - 0.3 * far);
}

fn to_viewer(way: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(dot(way, view.right.xyz), dot(way, view.up.xyz), dot(way, view.back.xyz));
}

/// The side of a surface that is seen.
fn facing(outwards: vec3<f32>, towards: vec3<f32>) -> vec3<f32> {
    return select(outwards, -outwards, dot(outwards, towards) < 0.0);
}

fn shaded(colour: vec3<f32>, finish: f32, outwards: vec3<f32>, at: vec3<f32>) -> vec3<f32> {
    let towards = normalize(vec3<f32>(view.right.w, view.up.w, view.back.w) - at);
    let n = facing(outwards, towards);
    let seen = to_viewer(n);
    let shift = vec3<f32>(to_viewer(at).xy * 0.1 / view.full.y, 0.0);
    let way = to_viewer(reflect(-towards, n)) + shift;
    let soft = 0.72 + 0.3 * seen.y - 0.12 * seen.x;
    let mirror = max(dot(way, vec3<f32>(-0.45, 0.6, 0.66)), 0.0);
    let eighth = mirror * mirror * mirror * mirror * mirror * mirror * mirror * mirror;
    let shine = eighth * eighth * eighth * eighth * eighth; // a power of 40
    let room = studio(way);
    if (finish < 0.5) { return colour * (0.6 + 0.4 * max(dot(seen, vec3<f32>(-0.38, 0.63, 0.67)), 0.0)); }
    if (finish < 2.5) { return colour * (0.45 * soft + 0.85 * room) + 0.1 * shine; }
    if (finish < 3.5) { return colour * (0.7 * soft + 0.25) + 0.1 * room * shine + 0.05 * room; }
    if (finish < 4.5) { return colour * (0.78 + 0.22 * soft) + 0.25 * shine; }
    if (finish < 5.5) { return colour * (0.5 + 0.55 * soft) + 0.9 * shine + 0.12 * (1.0 - seen.z); }
    return colour * (0.85 + 0.2 * soft);
}

fn surface(in: Surface, front: bool) -> vec4<f32> {
    if (CUT) {
        if (in.finish == 1.0 && dot(view.plane.xyz, in.at) > view.plane.w) { discard; }
        if (in.finish == 1.0 && !front) { return vec4<f32>(view.cut.rgb, in.colour.a); }
    }
    if (!ALL) { return in.lit; }
    let outwards = normalize(in.normal);
    let n = select(outwards, -outwards, dot(outwards, view.back.xyz) < 0.0);
    var colour = shaded(in.colour.rgb, in.finish, n, in.at);
    if (in.finish == 1.0 || in.finish == 2.0) { colour *= openness(in.at, n); }
    return vec4<f32>(min(colour, vec3<f32>(1.0)), in.colour.a);
}

@fragment
fn mesh_fragment(in: Surface, @builtin(front_facing) front: bool) -> @location(0) vec4<f32> {
    return surface(in, front);
}

@fragment
fn mesh_faded_fragment(in: Surface, @builtin(front_facing) front: bool) -> @location(0) vec4<f32> {
    return vec4<f32>(surface(in, front).rgb, 0.3);
}

// Lines and points: a capsule of constant width on the screen; a point is a line without length.

struct Stroke {
    @builtin(position) clip: vec4<f32>,
    @location(0) colour: vec4<f32>,
    @location(1) local: vec2<f32>,  // px along the line from its start, px across
    @location(2) shape: vec4<f32>,  // length px, half width px, dash period px, part of it already travelled
    @location(3) style: vec3<f32>,  // opacity of the part still to come, opacity behind the part, side of the light
    @location(4) at: vec4<f32>,     // place mm, 1 if it is cut away with the part; where something is
}

fn to_pixels(clip: vec4<f32>) -> vec2<f32> {
    return (clip.xy / clip.w) * 0.5 * view.screen.xy;
}

@vertex
fn line_vertex(
    @builtin(vertex_index) corner: u32,
    @location(0) a: vec3<f32>, @location(1) b: vec3<f32>, @location(2) colour: vec4<f32>,
    @location(3) style: vec4<f32>, @location(4) behind: vec2<f32>,
) -> Stroke {
    var from_clip = view.matrix * vec4<f32>(a, 1.0);
    var to_clip = view.matrix * vec4<f32>(b, 1.0);
    let near = 0.02; // behind the eye there is no place on the screen
    if (from_clip.w < near && to_clip.w > near) {
        from_clip = mix(from_clip, to_clip, (near - from_clip.w) / (to_clip.w - from_clip.w));
    }
    if (to_clip.w < near && from_clip.w > near) {
        to_clip = mix(to_clip, from_clip, (near - to_clip.w) / (from_clip.w - to_clip.w));
    }
    let from_px = to_pixels(from_clip);
    let line = to_pixels(to_clip) - from_px;
    let length_px = length(line);
    var along = vec2<f32>(1.0, 0.0);
    if (length_px > 1e-4) { along = line / length_px; }
    let half_width = 0.5 * style.x;
    let pad = half_width + 1.0;
    let end = f32(corner == 1u || corner == 2u || corner == 4u);
    let side = select(-1.0, 1.0, corner == 2u || corner == 4u || corner == 5u);
    let local = vec2<f32>(mix(-pad, length_px + pad, end), side * pad);
    let px = from_px + along * local.x + vec2<f32>(-along.y, along.x) * local.y;
    let depth = mix(from_clip.z / from_clip.w, to_clip.z / to_clip.w, end) - view.probe.w;
    let travelled = select(clamp((view.screen.z - style.z) / behind.y, 0.0, 1.0), 1.0, style.z < 0.0);
    let sort = u32(style.w); // 1: unseen before its place, 2: a tube, 4: cut away with the part
    let coming = select(view.screen.w, 0.0, (sort & 1u) != 0u);
    let lit = select(-1.0, 1.0, dot(vec2<f32>(-along.y, along.x), vec2<f32>(-0.6, 0.8)) > 0.0);
    var out: Stroke;
    out.clip = vec4<f32>(px / (0.5 * view.screen.xy), select(depth, 2.0, max(from_clip.w, to_clip.w) < near), 1.0);
    out.colour = colour;
    out.local = local;
    out.shape = vec4<f32>(length_px, half_width, style.y, travelled);
    out.style = vec3<f32>(coming, behind.x, select(0.0, lit, (sort & 2u) != 0u));
    out.at = vec4<f32>(mix(a, b, end), f32((sort & 4u) != 0u));
    return out;
}

fn coverage(in: Stroke) -> f32 {
    let beyond = in.local.x - clamp(in.local.x, 0.0, in.shape.x);
    var cover = clamp(in.shape.y - length(vec2<f32>(beyond, in.local.y)) + 0.5, 0.0, 1.0);
    if (in.shape.z > 0.0) {
        let phase = in.local.x - in.shape.z * floor(in.local.x / in.shape.z);
        cover *= clamp(0.6 * in.shape.z - phase + 0.5, 0.0, 1.0) * clamp(phase + 0.5, 0.0, 1.0);
    }
    let ahead = in.local.x > in.shape.w * in.shape.x || in.shape.w <= 0.0;
    if (ahead && in.shape.w < 1.0) { cover *= in.style.x; }
    if (CUT && in.at.w > 0.5 && dot(view.plane.xyz, in.at.xyz) > view.plane.w) { cover = 0.0; }
    return cover * in.colour.a;
}

/// A tube is darker at its sides and has a light along one of them.
fn inked(in: Stroke) -> vec3<f32> {
    let across = in.local.y / in.shape.y * in.style.z;
    let side = smoothstep(0.4, 1.0, abs(across));
    let light = 0.3 * smoothstep(0.2, 0.45, across) * (1.0 - smoothstep(0.45, 0.7, across));
    let tube = mix(in.colour.rgb * (1.0 - 0.4 * side), vec3<f32>(1.0), light);
    return select(tube, in.colour.rgb, in.style.z == 0.0);
}

@fragment
fn line_fragment(in: Stroke) -> @location(0) vec4<f32> {
    return vec4<f32>(inked(in), coverage(in));
}

@fragment
fn line_hidden_fragment(in: Stroke) -> @location(0) vec4<f32> {
    return vec4<f32>(inked(in), coverage(in) * in.style.y);
}

// The whole path: lines of one pixel. They hide each other and let nothing through, so that the order in which they are
// drawn makes no difference.

struct Trail {
    @builtin(position) clip: vec4<f32>,
    @location(0) colour: vec3<f32>,
    @location(1) ahead: f32, // entries until the trace is there
}

@vertex
fn path_vertex(@location(0) at: vec3<f32>, @location(1) done: u32) -> Trail {
    let clip = view.matrix * vec4<f32>(at + view.path.xyz, 1.0);
    let nearer = 0.5 * view.probe.w; // than the surface that it lies on, not than the lines around the step
    let ahead = clamp(f32(done >> 2u) - view.screen.z, -1.0, 1.0);
    return Trail(vec4<f32>(clip.xy, clip.z - nearer * clip.w, clip.w), view.kinds[done & 3u].rgb, ahead);
}

@fragment
fn path_fragment(in: Trail) -> @location(0) vec4<f32> {
    return vec4<f32>(mix(view.behind.rgb, in.colour, select(1.0, view.screen.w, in.ahead > 0.0)), 1.0);
}

// A picture that was made in several goes, brought to the canvas.

@group(1) @binding(0) var made: texture_2d<f32>;

@vertex
fn made_vertex(@builtin(vertex_index) corner: u32) -> @builtin(position) vec4<f32> {
    return vec4<f32>(select(-1.0, 3.0, corner == 1u), select(-1.0, 3.0, corner == 2u), 1.0, 1.0);
}

@fragment
fn made_fragment(@builtin(position) at: vec4<f32>) -> @location(0) vec4<f32> {
    return textureLoad(made, vec2<i32>(at.xy), 0);
}

// Points of a cloud: round, of constant size on the screen, cut out of a triangle around each.

struct Dot {
    @builtin(position) clip: vec4<f32>,
    @location(0) colour: vec4<f32>,
    @location(1) away: vec2<f32>, // from the middle, 1 at the rim
}
@group(1) @binding(0) var points: texture_2d<f32>; // X Y Z and the deviation, mm
const CLOUD_ROW: u32 = 2048u; // points in a row of it

@vertex
fn point_vertex(@builtin(vertex_index) corner: u32) -> Dot {
    let index = corner / 3u;
    let point = textureLoad(points, vec2<u32>(index % CLOUD_ROW, index / CLOUD_ROW), 0);
    let clip = view.matrix * vec4<f32>(point.xyz + view.cloud.xyz, 1.0);
    let way = f32(corner % 3u) - 1.0; // equilateral, its inner circle of radius 1
    let away = vec2<f32>(1.7320508 * way, select(-1.0, 2.0, way == 0.0));
    let offset = away * view.cloud.w / view.screen.xy * clip.w;
    let share = clamp(point.w / view.full.x, -1.0, 1.0);
    let colour = select(mix(view.level, view.inside, -share), mix(view.level, view.outside, share), share >= 0.0);
    return Dot(vec4<f32>(clip.xy + offset, clip.z - view.probe.w * clip.w, clip.w), colour, away);
}

@fragment
fn point_fragment(in: Dot) -> @location(0) vec4<f32> {
    if (dot(in.away, in.away) > 1.0) { discard; }
    return in.colour;
}
