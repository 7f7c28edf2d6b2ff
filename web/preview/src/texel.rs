//! A texture that a shader reads pixel by pixel, in its second group.

use wgpu::{
    BindGroup, BindGroupDescriptor, BindGroupEntry, BindGroupLayout, BindGroupLayoutDescriptor, BindGroupLayoutEntry,
    BindingResource, BindingType, Device, ShaderStages, TextureSampleType, TextureView, TextureViewDimension,
};

/// What `shader.wgsl` expects in its second group.
pub fn bind_layout(device: &Device) -> BindGroupLayout {
    device.create_bind_group_layout(&BindGroupLayoutDescriptor {
        label: None,
        entries: &[BindGroupLayoutEntry {
            binding: 0,
            visibility: ShaderStages::VERTEX_FRAGMENT,
            ty: BindingType::Texture {
                sample_type: TextureSampleType::Float { filterable: false },
                view_dimension: TextureViewDimension::D2,
                multisampled: false,
            },
            count: None,
        }],
    })
}

/// Binds one.
pub fn bind(device: &Device, layout: &BindGroupLayout, view: &TextureView) -> BindGroup {
    device.create_bind_group(&BindGroupDescriptor {
        label: None,
        layout,
        entries: &[BindGroupEntry { binding: 0, resource: BindingResource::TextureView(view) }],
    })
}
