struct View {
    matrix: mat4x4<f32>,
    right: vec4<f32>,
    up: vec4<f32>,
    back: vec4<f32>,
    screen: vec4<f32>, // width px, height px, time, faintness of what is still to come
    probe: vec4<f32>,  // offset mm, depth bias
    cloud: vec4<f32>,  // place mm, size of a point px
    outside: vec4<f32>, level: vec4<f32>, inside: vec4<f32>, // colours of points by their deviation
    full: vec4<f32>,   // deviation of full colour mm
}
@group(0) @binding(0) var<uniform> view: View;

// Parts: matt, lit by a key light over the left shoulder and a weak fill light. Fixed to the viewer.

struct Surface {
    @builtin(position) clip: vec4<f32>,
    @location(0) normal: vec3<f32>,
    @location(1) colour: vec4<f32>,
}

@vertex
fn mesh_vertex(
    @location(0) at: vec3<f32>,
    @location(1) normal: vec3<f32>,
    @location(2) colour: vec4<f32>,
    @location(3) moves: f32,
) -> Surface {
    let clip = view.matrix * vec4<f32>(at + moves * view.probe.xyz, 1.0);
    return Surface(clip, normal, colour);
}

@fragment
fn mesh_fragment(in: Surface) -> @location(0) vec4<f32> {
    var n = normalize(in.normal);
    if (dot(n, view.back.xyz) < 0.0) { n = -n; }
    let key = normalize(-0.45 * view.right.xyz + 0.75 * view.up.xyz + 0.8 * view.back.xyz);
    let fill = normalize(0.8 * view.right.xyz - 0.3 * view.up.xyz + 0.5 * view.back.xyz);
    let light = 0.6 + 0.4 * max(dot(n, key), 0.0) + 0.1 * max(dot(n, fill), 0.0);
    return vec4<f32>(min(in.colour.rgb * light, vec3<f32>(1.0)), in.colour.a);
}

// Lines and points: a capsule of constant width on the screen; a point is a line without length.

struct Stroke {
    @builtin(position) clip: vec4<f32>,
    @location(0) colour: vec4<f32>,
    @location(1) local: vec2<f32>,  // px along the line from its start, px across
    @location(2) shape: vec4<f32>,  // length px, half width px, dash period px, part of it already travelled
    @location(3) style: vec2<f32>,  // opacity of the part still to come, opacity behind the part
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
    let from_clip = view.matrix * vec4<f32>(a, 1.0);
    let to_clip = view.matrix * vec4<f32>(b, 1.0);
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
    let coming = select(view.screen.w, 0.0, style.w > 0.5);
    var out: Stroke;
    out.clip = vec4<f32>(px / (0.5 * view.screen.xy), depth, 1.0);
    out.colour = colour;
    out.local = local;
    out.shape = vec4<f32>(length_px, half_width, style.y, travelled);
    out.style = vec2<f32>(coming, behind.x);
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
    return cover * in.colour.a;
}

@fragment
fn line_fragment(in: Stroke) -> @location(0) vec4<f32> {
    return vec4<f32>(in.colour.rgb, coverage(in));
}

@fragment
fn line_hidden_fragment(in: Stroke) -> @location(0) vec4<f32> {
    return vec4<f32>(in.colour.rgb, coverage(in) * in.style.y);
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
