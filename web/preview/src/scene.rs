//! What is drawn: buffers made from the arrays of the page.

use std::ops::Range;

use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::{Buffer, BufferUsages, Device};

use crate::layout::{LINE_FLOATS, LINE_THROUGH, VERTEX_FLOATS};

/// Buffers of one scene; an absent buffer means that there is nothing of its kind.
#[derive(Default)]
pub struct Scene {
    /// Vertices and triangle corners.
    pub mesh: Option<(Buffer, Buffer)>,
    /// Corners one behind the other: solid parts, what stands and may fade, what moves and may fade, clear parts.
    pub corners: [Range<u32>; 4],
    /// Line instances.
    pub lines: Option<Buffer>,
    /// Those from the first one that is seen through the parts to the last of all.
    pub through: Range<u32>,
}

/// Uploads a scene; says what is wrong if the arrays do not fit together.
pub fn upload(
    device: &Device,
    vertices: &[f32],
    corners: &[u32],
    ends: &[u32],
    lines: &[f32],
) -> Result<Scene, String> {
    let all = count(corners.len())?;
    let ends: [u32; 3] = ends.try_into().map_err(|_| "corners: not three ends")?;
    check(vertices, corners, [ends[0], ends[1], ends[2], all], lines)?;
    let mesh = (!corners.is_empty()).then(|| {
        (
            buffer(device, bytemuck::cast_slice(vertices), BufferUsages::VERTEX),
            buffer(device, bytemuck::cast_slice(corners), BufferUsages::INDEX),
        )
    });
    let lines_buffer = (!lines.is_empty()).then(|| buffer(device, bytemuck::cast_slice(lines), BufferUsages::VERTEX));
    Ok(Scene {
        mesh,
        corners: [0..ends[0], ends[0]..ends[1], ends[1]..ends[2], ends[2]..all],
        lines: lines_buffer,
        through: count(hidden(lines))?..count(lines.len() / LINE_FLOATS)?,
    })
}

/// How many lines at the beginning nobody sees behind a part: edges, and the grid.
fn hidden(lines: &[f32]) -> usize {
    lines.chunks_exact(LINE_FLOATS).take_while(|line| line[LINE_THROUGH] == 0.0).count()
}

fn check(vertices: &[f32], corners: &[u32], ends: [u32; 4], lines: &[f32]) -> Result<(), String> {
    let vertex_count = count(vertices.len() / VERTEX_FLOATS)?;
    if !vertices.len().is_multiple_of(VERTEX_FLOATS) {
        return Err("vertices: incomplete vertex".into());
    }
    if !lines.len().is_multiple_of(LINE_FLOATS) {
        return Err("lines: incomplete line".into());
    }
    if ends.iter().any(|end| !end.is_multiple_of(3)) {
        return Err("corners: incomplete triangle".into());
    }
    if !ends.is_sorted() || corners.iter().any(|&corner| corner >= vertex_count) {
        return Err("corners: out of range".into());
    }
    Ok(())
}

fn count(length: usize) -> Result<u32, String> {
    u32::try_from(length).map_err(|error| error.to_string())
}

fn buffer(device: &Device, contents: &[u8], usage: BufferUsages) -> Buffer {
    device.create_buffer_init(&BufferInitDescriptor { label: None, contents, usage })
}
