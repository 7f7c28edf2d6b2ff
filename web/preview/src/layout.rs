//! Memory layout of what the page hands over. The page's `gpu.ts` writes exactly this.

use wgpu::{VertexAttribute, VertexBufferLayout, VertexFormat, VertexStepMode};

/// Floats of one mesh vertex: position 3, outward normal 3, RGBA 4, 1 if it moves with the probe, its finish (0 flat,
/// 1 metal of the part, 2 other metal, 3 dark and satin, 4 ceramic, 5 ruby, 6 luminous).
pub const VERTEX_FLOATS: usize = 12;
/// Floats of one line instance: ends 6, RGBA 4, width px, dash period px (0: solid), place in the trace (−1: always
/// there), its sort (1 if unseen before its place, else faint; 2 more for a tube; 4 more if it is cut away with the
/// part), opacity behind the part, part of an entry that it is travelled in.
pub const LINE_FLOATS: usize = 16;
/// Among them, the opacity behind the part.
pub const LINE_THROUGH: usize = 14;
/// Floats of one point of a cloud: position 3, deviation in mm.
pub const POINT_FLOATS: usize = 4;
/// Points in a row of the texture that holds a cloud (`shader.wgsl` says the same): every device has textures of that
/// width.
pub const CLOUD_ROW: u32 = 2048;
/// Words of one corner of the whole path: position 3 (f32), then how many entries of the trace are done there, times
/// four, plus the kind of the motion.
pub const PATH_WORDS: usize = 4;
/// Floats of the uniform block: matrix 16, right 4, up 4, towards the viewer 4 (the last of each is the place of the
/// eye in mm), screen 4 (width px, height px, time, faintness of what is still to come), probe 4 (offset in mm, depth
/// bias), cloud 4 (its place in mm, size of a point in px), colours 4 and 4 and 4 of points that lie outside, on the
/// surface and inside, then 4 (deviation of full colour and radius of the scene in mm), sky 4 (place of the map over
/// the ground in mm, one over its sizes), ground 4 (height, spacing of its grid, radius in mm; 1 where X is upright),
/// phase 4 (place of a line of the grid in mm, one over both reaches of occlusion in mm), colour 4 of the grid, plane 4
/// behind which the part is cut away (normal, distance in mm), colour 4 of what is cut, path 4 (its place in mm; the
/// last is unused), colour 4 of each of its four kinds of motion, and 4 behind everything.
pub const UNIFORM_FLOATS: usize = 104;
/// Floats of one cell of the map over the ground: heights of the part, blurred little and much, in mm above the ground,
/// and the shadow on the ground, 0 to 1; the last is unused.
pub const SKY_FLOATS: usize = 4;

const FLOAT: u64 = 4;

const fn attribute(format: VertexFormat, float: u64, location: u32) -> VertexAttribute {
    VertexAttribute { format, offset: float * FLOAT, shader_location: location }
}

const VERTEX: [VertexAttribute; 4] = [
    attribute(VertexFormat::Float32x3, 0, 0),
    attribute(VertexFormat::Float32x3, 3, 1),
    attribute(VertexFormat::Float32x4, 6, 2),
    attribute(VertexFormat::Float32x2, 10, 3),
];

const LINE: [VertexAttribute; 5] = [
    attribute(VertexFormat::Float32x3, 0, 0),
    attribute(VertexFormat::Float32x3, 3, 1),
    attribute(VertexFormat::Float32x4, 6, 2),
    attribute(VertexFormat::Float32x4, 10, 3),
    attribute(VertexFormat::Float32x2, 14, 4),
];

const PATH: [VertexAttribute; 2] = [attribute(VertexFormat::Float32x3, 0, 0), attribute(VertexFormat::Uint32, 3, 1)];

/// Layout of a mesh vertex.
pub fn vertex() -> VertexBufferLayout<'static> {
    VertexBufferLayout {
        array_stride: VERTEX_FLOATS as u64 * FLOAT,
        step_mode: VertexStepMode::Vertex,
        attributes: &VERTEX,
    }
}

/// Layout of a line instance.
pub fn line() -> VertexBufferLayout<'static> {
    VertexBufferLayout {
        array_stride: LINE_FLOATS as u64 * FLOAT,
        step_mode: VertexStepMode::Instance,
        attributes: &LINE,
    }
}

/// Layout of a corner of the whole path.
pub fn path() -> VertexBufferLayout<'static> {
    VertexBufferLayout { array_stride: PATH_WORDS as u64 * FLOAT, step_mode: VertexStepMode::Vertex, attributes: &PATH }
}
