//! A cloud of points, kept in a texture: each corner fetches the point that it belongs to by its own number. An
//! instance a point would cost more than the point, most of all without a graphics card.

use wgpu::{
    BindGroup, BindGroupLayout, Device, Extent3d, Origin3d, Queue, TexelCopyBufferLayout, TexelCopyTextureInfo,
    Texture, TextureAspect, TextureDescriptor, TextureDimension, TextureFormat, TextureUsages,
};

use crate::layout::{CLOUD_ROW, POINT_FLOATS};
use crate::texel;

const FLOATS_A_ROW: usize = CLOUD_ROW as usize * POINT_FLOATS;

/// Room for points, which come in pieces.
pub struct Cloud {
    texture: Texture,
    /// What the shader finds the texture by.
    pub bind: BindGroup,
    /// Points that came, from the first on without a gap.
    pub there: u32,
}

/// Makes room for so many points; none for 0.
pub fn reserve(device: &Device, layout: &BindGroupLayout, points: u32) -> Result<Option<Cloud>, String> {
    let rows = points.div_ceil(CLOUD_ROW);
    if rows == 0 {
        return Ok(None);
    }
    if rows > device.limits().max_texture_dimension_2d {
        return Err(format!("cloud: {points} points"));
    }
    let texture = device.create_texture(&TextureDescriptor {
        label: None,
        size: size(CLOUD_ROW, rows),
        mip_level_count: 1,
        sample_count: 1,
        dimension: TextureDimension::D2,
        format: TextureFormat::Rgba32Float,
        usage: TextureUsages::TEXTURE_BINDING | TextureUsages::COPY_DST,
        view_formats: &[],
    });
    let bind = texel::bind(device, layout, &texture.create_view(&Default::default()));
    Ok(Some(Cloud { texture, bind, there: 0 }))
}

impl Cloud {
    /// Takes further points. Only the last piece may end within a row.
    pub fn add(&mut self, queue: &Queue, points: &[f32]) -> Result<(), String> {
        if !points.len().is_multiple_of(POINT_FLOATS) || !self.there.is_multiple_of(CLOUD_ROW) {
            return Err("cloud: incomplete point or row".into());
        }
        let count = u32::try_from(points.len() / POINT_FLOATS).map_err(|error| error.to_string())?;
        let first = self.there / CLOUD_ROW;
        if first + count.div_ceil(CLOUD_ROW) > self.texture.height() {
            return Err("cloud: no room for these points".into());
        }
        let whole = count / CLOUD_ROW;
        let (rows, rest) = points.split_at(whole as usize * FLOATS_A_ROW);
        self.write(queue, first, rows, size(CLOUD_ROW, whole));
        self.write(queue, first + whole, rest, size(count % CLOUD_ROW, 1));
        self.there += count;
        Ok(())
    }

    fn write(&self, queue: &Queue, row: u32, points: &[f32], size: Extent3d) {
        if points.is_empty() {
            return;
        }
        let place = TexelCopyTextureInfo {
            texture: &self.texture,
            mip_level: 0,
            origin: Origin3d { x: 0, y: row, z: 0 },
            aspect: TextureAspect::All,
        };
        let rows = TexelCopyBufferLayout {
            offset: 0,
            bytes_per_row: Some(size_of::<[f32; FLOATS_A_ROW]>() as u32),
            rows_per_image: None,
        };
        queue.write_texture(place, bytemuck::cast_slice(points), rows, size);
    }
}

fn size(width: u32, height: u32) -> Extent3d {
    Extent3d { width, height, depth_or_array_layers: 1 }
}
