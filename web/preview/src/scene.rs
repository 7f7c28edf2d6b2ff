//! What is drawn: buffers made from the arrays of the page.

use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::{Buffer, BufferUsages, Device};

use crate::layout::{LINE_FLOATS, VERTEX_FLOATS};

/// Buffers of one scene; an absent buffer means that there is nothing of its kind.
#[derive(Default)]
pub struct Scene {
    /// Vertices and triangle corners, solid parts first.
    pub mesh: Option<(Buffer, Buffer)>,
    /// Corners of the solid parts.
    pub solid_corners: u32,
    /// Corners of all parts.
    pub corners: u32,
    /// Line instances.
    pub lines: Option<Buffer>,
    /// Number of them.
    pub line_count: u32,
}

/// Uploads a scene; says what is wrong if the arrays do not fit together.
pub fn upload(
    device: &Device,
    vertices: &[f32],
    corners: &[u32],
    solid_corners: u32,
    lines: &[f32],
) -> Result<Scene, String> {
    check(vertices, corners, solid_corners, lines)?;
    let mesh = (!corners.is_empty()).then(|| {
        (
            buffer(device, bytemuck::cast_slice(vertices), BufferUsages::VERTEX),
            buffer(device, bytemuck::cast_slice(corners), BufferUsages::INDEX),
        )
    });
    let lines_buffer = (!lines.is_empty()).then(|| buffer(device, bytemuck::cast_slice(lines), BufferUsages::VERTEX));
    Ok(Scene {
        mesh,
        solid_corners,
        corners: count(corners.len())?,
        lines: lines_buffer,
        line_count: count(lines.len() / LINE_FLOATS)?,
    })
}

fn check(vertices: &[f32], corners: &[u32], solid: u32, lines: &[f32]) -> Result<(), String> {
    let vertex_count = count(vertices.len() / VERTEX_FLOATS)?;
    if !vertices.len().is_multiple_of(VERTEX_FLOATS) {
        return Err("vertices: incomplete vertex".into());
    }
    if !lines.len().is_multiple_of(LINE_FLOATS) {
        return Err("lines: incomplete line".into());
    }
    if !corners.len().is_multiple_of(3) || !solid.is_multiple_of(3) {
        return Err("corners: incomplete triangle".into());
    }
    if solid > count(corners.len())? || corners.iter().any(|&corner| corner >= vertex_count) {
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
