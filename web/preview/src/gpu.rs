//! The device and the surface of one canvas, and the news that the device was lost.

use std::sync::{Arc, Mutex, PoisonError};

use web_sys::HtmlCanvasElement;
use wgpu::{Adapter, Device, Queue, Surface, SurfaceConfiguration};

/// Sent to the window when a device is lost; whoever draws asks its own renderer then.
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
    let (Some(window), Ok(event)) = (web_sys::window(), web_sys::Event::new(LOST_EVENT)) else {
        return;
    };
    // A listener that throws is the page's own matter.
    let _ = window.dispatch_event(&event);
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
pub async fn open(canvas: HtmlCanvasElement) -> Result<Gpu, String> {
    let (width, height) = (canvas.width().max(1), canvas.height().max(1));
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    let surface = instance.create_surface(wgpu::SurfaceTarget::Canvas(canvas)).map_err(|error| error.to_string())?;
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
