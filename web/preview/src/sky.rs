//! The map over the ground: heights and shadow of the part, from which the shader tells how much light arrives.

use wgpu::{
    BindGroup, BindGroupDescriptor, BindGroupEntry, BindGroupLayout, BindGroupLayoutDescriptor, BindGroupLayoutEntry,
    BindingResource, BindingType, Buffer, Device, Extent3d, FilterMode, SamplerBindingType, SamplerDescriptor,
    ShaderStages, TextureDescriptor, TextureDimension, TextureFormat, TextureSampleType, TextureUsages,
    TextureViewDimension, util::DeviceExt, util::TextureDataOrder,
};

use crate::gpu::Gpu;
use crate::layout::SKY_FLOATS;

/// What `shader.wgsl` expects in its first group.
pub fn bind_layout(device: &Device) -> BindGroupLayout {
    let entry = |binding, visibility, ty| BindGroupLayoutEntry { binding, visibility, ty, count: None };
    let block =
        BindingType::Buffer { ty: wgpu::BufferBindingType::Uniform, has_dynamic_offset: false, min_binding_size: None };
    let map = BindingType::Texture {
        sample_type: TextureSampleType::Float { filterable: true },
        view_dimension: TextureViewDimension::D2,
        multisampled: false,
    };
    device.create_bind_group_layout(&BindGroupLayoutDescriptor {
        label: None,
        entries: &[
            entry(0, ShaderStages::VERTEX_FRAGMENT, block),
            entry(1, ShaderStages::FRAGMENT, map),
            entry(2, ShaderStages::FRAGMENT, BindingType::Sampler(SamplerBindingType::Filtering)),
        ],
    })
}

/// Binds the uniform block and a map of rows of so many cells.
pub fn bind(
    gpu: &Gpu,
    layout: &BindGroupLayout,
    uniforms: &Buffer,
    columns: u32,
    cells: &[f32],
) -> Result<BindGroup, String> {
    let device = &gpu.device;
    let count = u32::try_from(cells.len() / SKY_FLOATS).map_err(|error| error.to_string())?;
    if columns == 0 || count == 0 || columns * (count / columns) != count {
        return Err(format!("sky: {count} cells in rows of {columns}"));
    }
    let halves: Vec<u16> = cells.iter().copied().map(half).collect();
    let descriptor = TextureDescriptor {
        label: None,
        size: Extent3d { width: columns, height: count / columns, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: TextureDimension::D2,
        format: TextureFormat::Rgba16Float,
        usage: TextureUsages::TEXTURE_BINDING,
        view_formats: &[],
    };
    let bytes = bytemuck::cast_slice(&halves);
    let map = device.create_texture_with_data(&gpu.queue, &descriptor, TextureDataOrder::LayerMajor, bytes);
    let smoothly = device.create_sampler(&SamplerDescriptor {
        mag_filter: FilterMode::Linear,
        min_filter: FilterMode::Linear,
        ..Default::default()
    });
    Ok(device.create_bind_group(&BindGroupDescriptor {
        label: None,
        layout,
        entries: &[
            BindGroupEntry { binding: 0, resource: uniforms.as_entire_binding() },
            BindGroupEntry {
                binding: 1,
                resource: BindingResource::TextureView(&map.create_view(&Default::default())),
            },
            BindGroupEntry { binding: 2, resource: BindingResource::Sampler(&smoothly) },
        ],
    }))
}

/// The nearest number of 16 bits below; what is too small is 0, what is too large the largest one. Every device blends
/// cells of 16 bits, not all those of 32.
fn half(value: f32) -> u16 {
    let bits = value.to_bits();
    let sign = (bits >> 16) as u16 & 0x8000;
    let exponent = (bits >> 23 & 0xff) as i32 - 112;
    match exponent {
        ..=0 => sign,
        31.. => sign | 0x7bff,
        _ => sign | (exponent as u16) << 10 | (bits >> 13 & 0x3ff) as u16,
    }
}
