//! The whole path of a run: strips of lines of one pixel. It comes in parts, each of many chunks; which of them are
//! drawn, and how fine, is asked with every frame (`levels.ts` of the page says what they are).

use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::{Buffer, BufferUsages, Device, IndexFormat, RenderPass};

use crate::layout::PATH_WORDS;

/// Numbers of one span to draw: its part, the first corner of its chunk, the first of its indices and their end.
pub const SPAN: usize = 4;

/// Parts of the path, as they came.
#[derive(Default)]
pub struct Path {
    parts: Vec<Part>,
}

struct Part {
    vertices: Buffer,
    indices: Buffer,
    /// Corners, and indices.
    counts: [usize; 2],
}

impl Path {
    /// Takes a further part. Indices count from the first corner of their chunk.
    pub fn add(&mut self, device: &Device, vertices: &[u32], indices: &[u16]) -> Result<(), String> {
        if !vertices.len().is_multiple_of(PATH_WORDS) || !indices.len().is_multiple_of(2) {
            return Err("path: incomplete corner or indices".into());
        }
        let buffer =
            |contents, usage| device.create_buffer_init(&BufferInitDescriptor { label: None, contents, usage });
        self.parts.push(Part {
            vertices: buffer(bytemuck::cast_slice(vertices), BufferUsages::VERTEX),
            indices: buffer(bytemuck::cast_slice(indices), BufferUsages::INDEX),
            counts: [vertices.len() / PATH_WORDS, indices.len()],
        });
        Ok(())
    }

    /// Draws spans; what is not there is left out.
    pub fn draw(&self, pass: &mut RenderPass<'_>, spans: &[u32]) {
        for span in spans.chunks_exact(SPAN) {
            let [part, first, from, to] = [span[0], span[1], span[2], span[3]];
            let Some(part) = self.parts.get(part as usize) else { continue };
            let [corners, indices] = part.counts;
            if first as usize >= corners || from >= to || to as usize > indices {
                continue;
            }
            pass.set_vertex_buffer(0, part.vertices.slice(u64::from(first) * (4 * PATH_WORDS as u64)..));
            pass.set_index_buffer(part.indices.slice(..), IndexFormat::Uint16);
            pass.draw_indexed(from..to, 0, 0..1);
        }
    }
}
