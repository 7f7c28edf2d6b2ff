//! What is drawn into beside the canvas, as large as that: a depth buffer, and several samples a pixel.

use wgpu::{TextureFormat, TextureUsages, TextureView};

use crate::gpu::Gpu;

/// Format of the depth buffer.
pub const DEPTH: TextureFormat = TextureFormat::Depth24Plus;

/// Attachments of one size.
pub struct Target {
    /// Colour with several samples a pixel; none where one is enough, and the canvas takes it.
    pub colour: Option<TextureView>,
    /// Where one is enough: a picture that is made in several goes.
    pub made: Option<TextureView>,
    /// Depth, with as many samples.
    pub depth: TextureView,
}

/// Makes the attachments for the surface as it is configured.
pub fn attach(gpu: &Gpu) -> Target {
    let several = gpu.samples > 1;
    let format = gpu.config.format;
    Target {
        colour: several.then(|| texture(gpu, format, TextureUsages::empty())),
        made: (!several).then(|| texture(gpu, format, TextureUsages::TEXTURE_BINDING)),
        depth: texture(gpu, DEPTH, TextureUsages::empty()),
    }
}

fn texture(gpu: &Gpu, format: TextureFormat, more: TextureUsages) -> TextureView {
    let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: None,
        size: wgpu::Extent3d { width: gpu.config.width, height: gpu.config.height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: gpu.samples,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: TextureUsages::RENDER_ATTACHMENT | more,
        view_formats: &[],
    });
    texture.create_view(&wgpu::TextureViewDescriptor::default())
}
