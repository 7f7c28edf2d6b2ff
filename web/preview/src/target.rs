//! What is drawn into: four samples a pixel and a depth buffer, as large as the canvas.

use wgpu::{Device, SurfaceConfiguration, TextureFormat, TextureView};

/// Samples a pixel.
pub const SAMPLES: u32 = 4;
/// Format of the depth buffer.
pub const DEPTH: TextureFormat = TextureFormat::Depth24Plus;

/// Attachments of one size.
pub struct Target {
    /// Colour, multisampled.
    pub colour: TextureView,
    /// Depth, multisampled.
    pub depth: TextureView,
}

/// Makes the attachments for the surface as it is configured.
pub fn attach(device: &Device, config: &SurfaceConfiguration) -> Target {
    Target {
        colour: texture(device, config, config.format),
        depth: texture(device, config, DEPTH),
    }
}

fn texture(device: &Device, config: &SurfaceConfiguration, format: TextureFormat) -> TextureView {
    let texture = device.create_texture(&wgpu::TextureDescriptor {
        label: None,
        size: wgpu::Extent3d {
            width: config.width,
            height: config.height,
            depth_or_array_layers: 1,
        },
        mip_level_count: 1,
        sample_count: SAMPLES,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT,
        view_formats: &[],
    });
    texture.create_view(&wgpu::TextureViewDescriptor::default())
}
