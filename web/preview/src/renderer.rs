//! The one class that the page sees.

use std::ops::Range;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use js_sys::Object;
use wasm_bindgen::prelude::wasm_bindgen;
use wgpu::util::{BufferInitDescriptor, DeviceExt};
use wgpu::{BindGroup, Buffer, CurrentSurfaceTexture, LoadOp, RenderPass, StoreOp, TextureView};

use crate::cloud::Cloud;
use crate::gpu::Gpu;
use crate::layout::{SKY_FLOATS, UNIFORM_FLOATS};
use crate::path::Path;
use crate::pipelines::{Bindings, Light, Pipelines};
use crate::scene::Scene;
use crate::target::Target;
use crate::{cloud, gpu, pipelines, scene, sky, target, texel};

/// Draws on one canvas. Every failure is a text; after one the page takes the next way of drawing.
#[wasm_bindgen]
pub struct Renderer {
    gpu: Gpu,
    target: Target,
    bindings: Bindings,
    pipelines: Pipelines,
    light: Light,
    uniforms: Buffer,
    bind: BindGroup,
    scene: Scene,
    cloud: Option<Cloud>,
    path: Path,
    /// What `made` of the target is found by.
    made: Option<BindGroup>,
    drawn: Arc<AtomicBool>,
    background: wgpu::Color,
}

#[wasm_bindgen(wasm_bindgen_futures = js_sys::futures)]
impl Renderer {
    /// Opens a canvas of the page or of a worker.
    ///
    /// # Errors
    /// The browser offers no working adapter.
    pub async fn create(canvas: Object) -> Result<Renderer, String> {
        let gpu = gpu::open(canvas).await?;
        let uniforms = gpu.device.create_buffer_init(&BufferInitDescriptor {
            label: None,
            contents: bytemuck::cast_slice(&[0.0_f32; UNIFORM_FLOATS]),
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
        });
        let bindings = Bindings { view: sky::bind_layout(&gpu.device), texture: texel::bind_layout(&gpu.device) };
        let bind = sky::bind(&gpu, &bindings.view, &uniforms, 1, &[0.0; SKY_FLOATS])?;
        let light = Light { all: true, cut: false };
        let target = target::attach(&gpu);
        Ok(Renderer {
            made: made(&gpu, &bindings, &target),
            target,
            pipelines: pipelines::build(&gpu, &bindings, light),
            light,
            bindings,
            uniforms,
            bind,
            scene: Scene::default(),
            cloud: None,
            path: Path::default(),
            drawn: Arc::default(),
            background: wgpu::Color::BLACK,
            gpu,
        })
    }

    /// Replaces what is drawn. Layouts: see `layout.rs`. `ends`: where in the corners the solid parts end, then what
    /// stands and may fade, then what moves and may fade; the rest is seen through.
    ///
    /// # Errors
    /// More than the device holds.
    pub fn set_scene(&mut self, vertices: &[f32], corners: &[u32], ends: &[u32], lines: &[f32]) -> Result<(), String> {
        self.scene = scene::upload(&self.gpu.device, vertices, corners, ends, lines)?;
        Ok(())
    }

    /// Replaces the map over the ground: rows of so many cells.
    ///
    /// # Errors
    /// More than the device holds.
    pub fn set_sky(&mut self, columns: u32, cells: &[f32]) -> Result<(), String> {
        self.bind = sky::bind(&self.gpu, &self.bindings.view, &self.uniforms, columns, cells)?;
        Ok(())
    }

    /// Replaces the cloud by room for so many points, 0 by none; it stays while the scene changes.
    ///
    /// # Errors
    /// More than the device holds.
    pub fn reserve_cloud(&mut self, points: u32) -> Result<(), String> {
        self.cloud = cloud::reserve(&self.gpu.device, &self.bindings.texture, points)?;
        Ok(())
    }

    /// Further points of the cloud, in the order in which they are drawn. Only the last ones may be no whole rows.
    ///
    /// # Errors
    /// More points than there is room for.
    pub fn add_points(&mut self, points: &[f32]) -> Result<(), String> {
        match &mut self.cloud {
            Some(cloud) => cloud.add(&self.gpu.queue, points),
            None => Err("cloud: no room".into()),
        }
    }

    /// Takes the whole path away.
    pub fn clear_path(&mut self) {
        self.path = Path::default();
    }

    /// A further part of the whole path: its corners (`layout.rs`), and the indices of all its chunks.
    ///
    /// # Errors
    /// No whole corners.
    pub fn add_path(&mut self, vertices: &[u32], indices: &[u16]) -> Result<(), String> {
        self.path.add(&self.gpu.device, vertices, indices)
    }

    /// Camera, time and probe position as the uniform block of `layout.rs`.
    ///
    /// # Errors
    /// A block of another size.
    pub fn set_view(&self, uniforms: &[f32]) -> Result<(), String> {
        if uniforms.len() != UNIFORM_FLOATS {
            return Err(format!("view: {} floats", uniforms.len()));
        }
        let bytes = bytemuck::cast_slice(uniforms);
        self.gpu.queue.write_buffer(&self.uniforms, 0, bytes);
        Ok(())
    }

    /// Whether each pixel is lit, by what stands around too, or the corners of the surfaces only; and whether something
    /// of the part is cut away.
    pub fn set_light(&mut self, all: bool, cut: bool) {
        let light = Light { all, cut };
        if light != self.light {
            self.light = light;
            self.pipelines.relight(&self.gpu, light);
        }
    }

    /// Colour behind everything, 0 to 1.
    pub fn set_background(&mut self, r: f64, g: f64, b: f64) {
        self.background = wgpu::Color { r, g, b, a: 1.0 };
    }

    /// The canvas has a new size, device pixels.
    pub fn resize(&mut self, width: u32, height: u32) {
        let limit = self.gpu.device.limits().max_texture_dimension_2d;
        self.gpu.config.width = width.clamp(1, limit);
        self.gpu.config.height = height.clamp(1, limit);
        let gpu = &self.gpu;
        gpu.surface.configure(&gpu.device, &gpu.config);
        self.target = target::attach(gpu);
        self.made = made(gpu, &self.bindings, &self.target);
    }

    /// Draws one frame with the first `points` of the cloud and these spans of the path (`path.rs`). `faded`: 1 if what
    /// stands and may fade does, 2 more if what moves does.
    ///
    /// # Errors
    /// The device is lost.
    pub fn render(&self, points: u32, faded: u32, spans: &[u32]) -> Result<(), String> {
        self.present(Kept::Nothing, |pass| {
            self.behind(pass, points, faded);
            self.trail(pass, spans);
            self.before(pass, faded);
        })
    }

    /// Begins a picture that is made in several goes out of sight, with all but the path.
    ///
    /// # Errors
    /// The device is lost.
    pub fn begin(&self, points: u32, faded: u32) -> Result<(), String> {
        self.aside(Kept::Nothing, |pass| self.behind(pass, points, faded))
    }

    /// Further spans of the path in that picture.
    ///
    /// # Errors
    /// The device is lost.
    pub fn go_on(&self, spans: &[u32]) -> Result<(), String> {
        self.aside(Kept::Picture, |pass| self.trail(pass, spans))
    }

    /// That picture comes to the canvas, with what lies before the path.
    ///
    /// # Errors
    /// The device is lost.
    pub fn finish(&self, faded: u32) -> Result<(), String> {
        self.present(Kept::Picture, |pass| {
            if let Some(made) = &self.made {
                pass.set_bind_group(1, made, &[]);
                pass.set_pipeline(&self.pipelines.made);
                pass.draw(0..3, 0..1);
            }
            self.before(pass, faded);
        })
    }

    /// From now on [`Renderer::is_drawn`] speaks of all that was asked for up to here.
    pub fn watch(&mut self) {
        let drawn = Arc::new(AtomicBool::new(false));
        self.drawn = Arc::clone(&drawn);
        let done = move || drawn.store(true, Ordering::Relaxed);
        self.gpu.queue.on_submitted_work_done(done);
    }

    /// Whether the device has drawn what is watched. To be asked between two frames.
    pub fn is_drawn(&self) -> bool {
        // A device that cannot be asked is lost, which the next frame tells.
        let _ = self.gpu.device.poll(wgpu::PollType::Poll);
        self.drawn.load(Ordering::Relaxed)
    }
}

impl Renderer {
    /// The next image of the canvas; none while it is out of sight.
    fn frame(&self) -> Result<Option<wgpu::SurfaceTexture>, String> {
        let gpu = &self.gpu;
        match gpu.surface.get_current_texture() {
            CurrentSurfaceTexture::Success(frame) | CurrentSurfaceTexture::Suboptimal(frame) => Ok(Some(frame)),
            CurrentSurfaceTexture::Timeout | CurrentSurfaceTexture::Occluded => Ok(None),
            CurrentSurfaceTexture::Outdated => {
                gpu.surface.configure(&gpu.device, &gpu.config);
                Ok(None)
            }
            other => Err(format!("{other:?}")),
        }
    }

    /// Makes the next image of the canvas. Several samples come together in it; a single one is drawn there at once.
    fn present(&self, kept: Kept, make: impl FnOnce(&mut RenderPass<'_>)) -> Result<(), String> {
        self.sound()?;
        let Some(frame) = self.frame()? else {
            return Ok(());
        };
        let image = frame.texture.create_view(&Default::default());
        let (view, resolve_target) = match &self.target.colour {
            Some(colour) => (colour, Some(&image)),
            None => (&image, None),
        };
        self.submit((view, resolve_target), kept, StoreOp::Discard, make);
        self.gpu.queue.present(frame);
        self.sound()
    }

    /// Makes more of a picture that nobody sees yet.
    fn aside(&self, kept: Kept, make: impl FnOnce(&mut RenderPass<'_>)) -> Result<(), String> {
        self.sound()?;
        if let Some(picture) = self.target.colour.as_ref().or(self.target.made.as_ref()) {
            self.submit((picture, None), kept, StoreOp::Store, make);
        }
        self.sound()
    }

    fn submit(
        &self,
        (view, resolve_target): (&TextureView, Option<&TextureView>),
        kept: Kept,
        store: StoreOp,
        make: impl FnOnce(&mut RenderPass<'_>),
    ) {
        let (colour, depth) = match kept {
            Kept::Nothing => (LoadOp::Clear(self.background), LoadOp::Clear(1.0)),
            Kept::Picture => (LoadOp::Load, LoadOp::Load),
        };
        let seen = if resolve_target.is_some() { store } else { StoreOp::Store };
        let mut encoder = self.gpu.device.create_command_encoder(&Default::default());
        {
            let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
                color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                    view,
                    depth_slice: None,
                    resolve_target,
                    ops: wgpu::Operations { load: colour, store: seen },
                })],
                depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                    view: &self.target.depth,
                    depth_ops: Some(wgpu::Operations { load: depth, store }),
                    stencil_ops: None,
                }),
                ..Default::default()
            });
            pass.set_bind_group(0, &self.bind, &[]);
            make(&mut pass);
        }
        self.gpu.queue.submit([encoder.finish()]);
    }

    /// Tells of a device that was lost.
    fn sound(&self) -> Result<(), String> {
        self.gpu.fault.reason().map_or(Ok(()), Err)
    }
    /// What the path lies before: the ground, parts that do not fade, the cloud.
    fn behind(&self, pass: &mut RenderPass<'_>, points: u32, faded: u32) {
        let [solid, ..] = &self.scene.corners;
        pass.set_pipeline(&self.pipelines.ground);
        pass.draw(0..6, 0..1);
        self.draw_mesh(pass, &self.pipelines.lit.solid, solid);
        for (corners, _) in self.fading(faded).iter().filter(|(_, fades)| !fades) {
            self.draw_mesh(pass, &self.pipelines.lit.solid, corners);
        }
        if let Some(cloud) = &self.cloud {
            pass.set_bind_group(1, &cloud.bind, &[]);
            pass.set_pipeline(&self.pipelines.point);
            pass.draw(0..3 * points.min(cloud.there), 0..1);
        }
    }

    fn trail(&self, pass: &mut RenderPass<'_>, spans: &[u32]) {
        if !spans.is_empty() {
            pass.set_pipeline(&self.pipelines.path);
            self.path.draw(pass, spans);
        }
    }

    /// What lies before the path: lines behind the parts, lines before them, faded and clear parts.
    fn before(&self, pass: &mut RenderPass<'_>, faded: u32) {
        let scene = &self.scene;
        if let Some(lines) = &scene.lines {
            pass.set_vertex_buffer(0, lines.slice(..));
            pass.set_pipeline(&self.pipelines.lit.hidden);
            pass.draw(0..6, scene.through.clone());
            pass.set_pipeline(&self.pipelines.lit.line);
            pass.draw(0..6, 0..scene.through.end);
        }
        for (corners, _) in self.fading(faded).iter().filter(|(_, fades)| *fades) {
            self.draw_mesh(pass, &self.pipelines.lit.faded, corners);
        }
        self.draw_mesh(pass, &self.pipelines.lit.clear, &scene.corners[3]);
    }

    /// What may fade, and whether it does.
    fn fading(&self, faded: u32) -> [(&Range<u32>, bool); 2] {
        let [_, stands, moves, _] = &self.scene.corners;
        [(stands, faded & 1 != 0), (moves, faded & 2 != 0)]
    }

    fn draw_mesh(&self, pass: &mut RenderPass<'_>, pipeline: &wgpu::RenderPipeline, corners: &Range<u32>) {
        let Some((vertices, indices)) = &self.scene.mesh else {
            return;
        };
        if corners.is_empty() {
            return;
        }
        pass.set_pipeline(pipeline);
        pass.set_vertex_buffer(0, vertices.slice(..));
        pass.set_index_buffer(indices.slice(..), wgpu::IndexFormat::Uint32);
        pass.draw_indexed(corners.clone(), 0, 0..1);
    }
}

/// What of the picture before is drawn over.
#[derive(Clone, Copy)]
enum Kept {
    /// All begins anew.
    Nothing,
    /// Colours and depths stay, but for those of the canvas.
    Picture,
}

/// Binds what is made in several goes, where the canvas does not take it at once.
fn made(gpu: &Gpu, bindings: &Bindings, target: &Target) -> Option<BindGroup> {
    target.made.as_ref().map(|picture| texel::bind(&gpu.device, &bindings.texture, picture))
}
