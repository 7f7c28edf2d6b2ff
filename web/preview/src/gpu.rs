//! The device and the surface of one canvas, and the news that the device was lost.

use std::sync::{Arc, Mutex, PoisonError};

use js_sys::Object;
use wasm_bindgen::JsCast;
use web_sys::{EventTarget, HtmlCanvasElement, OffscreenCanvas};
use wgpu::{Adapter, Device, Queue, Surface, SurfaceConfiguration, SurfaceTarget};

/// Sent to the window or the worker when a device is lost; whoever draws asks its own renderer then.
pub const LOST_EVENT: &str = "probewright-preview-lost";

/// What was lost and why; empty while all is well.
#[derive(Clone, Default)]
pub struct Fault(Arc<Mutex<Option<String>>>);

impl Fault {
    /// The reason, once there is one.
    pub fn reason(&self) -> Option<String> {
        let reason = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        reason.clone()
    }

    fn report(&self, reason: String) {
        let mut first = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        first.get_or_insert(reason);
        drop(first);
        announce();
    }
}

fn announce() {
    let (Ok(scope), Ok(event)) = (js_sys::global().dyn_into::<EventTarget>(), web_sys::Event::new(LOST_EVENT)) else {
        return;
    };
    // A listener that throws is the page's own matter.
    let _ = scope.dispatch_event(&event);
}

/// A canvas that can be drawn on.
pub struct Gpu {
    /// Device.
    pub device: Device,
    /// Queue of the device.
    pub queue: Queue,
    /// Surface of the canvas.
    pub surface: Surface<'static>,
    /// Size and format of the surface.
    pub config: SurfaceConfiguration,
    /// Samples a pixel.
    pub samples: u32,
    /// Loss of the device.
    pub fault: Fault,
}

/// Opens the device for a canvas; the reason if the browser has none that works here.
pub async fn open(canvas: Object) -> Result<Gpu, String> {
    let (target, width, height) = surface_target(canvas)?;
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    let surface = instance.create_surface(target).map_err(|error| error.to_string())?;
    let adapter = instance
        .request_adapter(&wgpu::RequestAdapterOptions { compatible_surface: Some(&surface), ..Default::default() })
        .await
        .map_err(|error| error.to_string())?;
    let (device, queue) = request_device(&adapter).await?;
    let fault = Fault::default();
    watch(&device, &fault);
    let config = configuration(&surface, &adapter, width, height)?;
    surface.configure(&device, &config);
    Ok(Gpu { device, queue, surface, config, samples: samples(&adapter), fault })
}

/// A canvas of the page, or one that belongs to a worker; its size.
fn surface_target(canvas: Object) -> Result<(SurfaceTarget<'static>, u32, u32), String> {
    let canvas = match canvas.dyn_into::<HtmlCanvasElement>() {
        Ok(canvas) => {
            let (width, height) = (canvas.width().max(1), canvas.height().max(1));
            return Ok((SurfaceTarget::Canvas(canvas), width, height));
        }
        Err(other) => other.dyn_into::<OffscreenCanvas>().map_err(|_| "no canvas")?,
    };
    let (width, height) = (canvas.width().max(1), canvas.height().max(1));
    Ok((SurfaceTarget::OffscreenCanvas(canvas), width, height))
}

/// Without a graphics card the same cores draw that the page runs on: four samples would take them from it. Lines are
/// smooth all the same, their own shader sees to it.
fn samples(adapter: &Adapter) -> u32 {
    match adapter.get_info().device_type {
        wgpu::DeviceType::Cpu => 1,
        _ => 4,
    }
}

async fn request_device(adapter: &Adapter) -> Result<(Device, Queue), String> {
    let descriptor = wgpu::DeviceDescriptor {
        label: Some("preview"),
        required_limits: wgpu::Limits::downlevel_webgl2_defaults().using_resolution(adapter.limits()),
        ..Default::default()
    };
    adapter.request_device(&descriptor).await.map_err(|error| error.to_string())
}

fn watch(device: &Device, fault: &Fault) {
    let lost = fault.clone();
    device.set_device_lost_callback(move |reason, text| {
        lost.report(format!("{reason:?}: {text}"));
    });
    let wrong = fault.clone();
    device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| {
        wrong.report(error.to_string());
    }));
}

/// A format that takes sRGB values as they are, so that every way of drawing shows the same colours.
fn configuration(
    surface: &Surface<'_>,
    adapter: &Adapter,
    width: u32,
    height: u32,
) -> Result<SurfaceConfiguration, String> {
    let mut config = surface
        .get_default_config(adapter, width, height)
        .ok_or("the surface has no configuration for this adapter")?;
    config.format = config.format.remove_srgb_suffix();
    Ok(config)
}
