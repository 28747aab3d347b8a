//! The graphics device, the canvas it draws on, and what happens when it is lost.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use web_sys::HtmlCanvasElement;
use wgpu::CurrentSurfaceTexture;

use super::signal::Signal;
use crate::viewer::drawing::ROW;
use crate::viewer::error::{API, ViewerError};

/// Format of the depth buffer.
pub(super) const DEPTH_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Depth24Plus;

/// Whether this is the build for browsers without WebGPU.
pub(super) const IS_WEBGL: bool = cfg!(feature = "viewer-webgl");

/// Device, queue and canvas.
pub(super) struct Gpu {
    pub(super) device: wgpu::Device,
    pub(super) queue: wgpu::Queue,
    pub(super) samples: u32,
    pub(super) adapter: String,
    /// Whether it draws on the CPU.
    pub(super) is_software: bool,
    /// Why the device went away, once it has.
    pub(super) lost: Signal<String>,
    canvas: wgpu::Surface<'static>,
    config: wgpu::SurfaceConfiguration,
    depth: wgpu::TextureView,
    /// What is drawn into and then resolved; none with one sample a pixel.
    multisampled: Option<wgpu::TextureView>,
}

impl Gpu {
    /// Opens a device for a canvas, drawing with 1 or 4 samples a pixel.
    ///
    /// The adapter is asked for before the canvas: a canvas once asked for a WebGPU
    /// context can never have another kind. WebGL has no adapter without a canvas.
    pub(super) async fn open(canvas: HtmlCanvasElement, samples: u32) -> Result<Self, ViewerError> {
        let (width, height) = (canvas.width().max(1), canvas.height().max(1));
        let mut backend = wgpu::InstanceDescriptor::new_without_display_handle();
        if IS_WEBGL {
            backend.backends = wgpu::Backends::GL;
        }
        let instance = wgpu::Instance::new(backend);
        let surface = || {
            instance
                .create_surface(wgpu::SurfaceTarget::Canvas(canvas.clone()))
                .map_err(|error| no_canvas(error.to_string()))
        };
        let early = IS_WEBGL.then(surface).transpose()?;
        let adapter = instance
            .request_adapter(&wgpu::RequestAdapterOptions {
                power_preference: wgpu::PowerPreference::HighPerformance,
                compatible_surface: early.as_ref(),
                ..Default::default()
            })
            .await
            .map_err(|_| ViewerError::NoAdapter { api: API })?;
        let (device, queue) = adapter
            .request_device(&wgpu::DeviceDescriptor {
                // Nothing WebGL2 lacks, but meshes as large as the device takes.
                required_limits: wgpu::Limits::downlevel_webgl2_defaults()
                    .using_resolution(adapter.limits()),
                ..Default::default()
            })
            .await
            .map_err(|error| ViewerError::NoDevice {
                reason: error.to_string(),
            })?;
        let canvas = early.map_or_else(surface, Ok)?;

        // Never an sRGB format: shaders encode, so that every backend shows the same bytes.
        let formats = canvas.get_capabilities(&adapter).formats;
        let format = formats.into_iter().find(|format| !format.is_srgb());
        let mut config = canvas
            .get_default_config(&adapter, width, height)
            .ok_or_else(|| no_canvas("no configuration".to_owned()))?;
        config.format = format.unwrap_or(config.format);
        config.alpha_mode = wgpu::CompositeAlphaMode::Opaque;

        let lost = Signal::default();
        watch(&device, &lost);
        canvas.configure(&device, &config);
        let info = adapter.get_info();
        let is_software = info.device_type == wgpu::DeviceType::Cpu;
        let (depth, multisampled) = targets(&device, &config, samples);
        Ok(Self {
            adapter: if is_software {
                format!("{} (software)", info.name).trim().to_owned()
            } else {
                info.name
            },
            is_software,
            device,
            queue,
            samples,
            lost,
            canvas,
            config,
            depth,
            multisampled,
        })
    }

    /// Width and height of the picture in pixels.
    pub(super) fn size(&self) -> (u32, u32) {
        (self.config.width, self.config.height)
    }

    /// Format of the picture.
    pub(super) fn format(&self) -> wgpu::TextureFormat {
        self.config.format
    }

    /// Resizes the picture, within what the device can draw. Clears the canvas.
    pub(super) fn resize(&mut self, width: u32, height: u32) {
        let limit = self.device.limits().max_texture_dimension_2d;
        self.config.width = width.clamp(1, limit);
        self.config.height = height.clamp(1, limit);
        self.configure();
        (self.depth, self.multisampled) = targets(&self.device, &self.config, self.samples);
    }

    /// The texture to draw the next picture into; none when it must be tried again later.
    pub(super) fn next_texture(&self) -> Option<wgpu::SurfaceTexture> {
        match self.canvas.get_current_texture() {
            CurrentSurfaceTexture::Success(texture)
            | CurrentSurfaceTexture::Suboptimal(texture) => Some(texture),
            CurrentSurfaceTexture::Outdated | CurrentSurfaceTexture::Lost => {
                self.configure();
                None
            }
            _ => None,
        }
    }

    /// Refuses more vertices, in whole rows of a texture, than the device takes.
    pub(super) fn expect_room_for(&self, vertices: usize) -> Result<(), ViewerError> {
        let limit = self.device.limits().max_texture_dimension_2d as usize * ROW;
        if vertices <= limit {
            Ok(())
        } else {
            Err(ViewerError::TooLarge { vertices, limit })
        }
    }

    /// Records one render pass into `target`, cleared first.
    pub(super) fn render(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        target: &wgpu::TextureView,
        draw: impl FnOnce(&mut wgpu::RenderPass<'_>),
    ) {
        let (view, resolve_target) = match &self.multisampled {
            Some(view) => (view, Some(target)),
            None => (target, None),
        };
        let discard = |load| wgpu::Operations {
            load,
            store: wgpu::StoreOp::Discard,
        };
        let store = if resolve_target.is_some() {
            wgpu::StoreOp::Discard
        } else {
            wgpu::StoreOp::Store
        };
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("picture"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view,
                depth_slice: None,
                resolve_target,
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color::BLACK),
                    store,
                },
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &self.depth,
                depth_ops: Some(discard(wgpu::LoadOp::Clear(1.0))),
                stencil_ops: None,
            }),
            ..Default::default()
        });
        draw(&mut pass);
    }

    fn configure(&self) {
        self.canvas.configure(&self.device, &self.config);
    }
}

impl Drop for Gpu {
    /// Frees the memory now; a garbage collector sees only the small handle.
    fn drop(&mut self) {
        self.device.destroy();
    }
}

fn no_canvas(reason: String) -> ViewerError {
    ViewerError::NoCanvas { api: API, reason }
}

/// Notes the loss of the device, and logs the first error no one else handles: a fault in
/// a shader or pipeline would otherwise repeat every frame.
fn watch(device: &wgpu::Device, lost: &Signal<String>) {
    let signal = lost.clone();
    device.set_device_lost_callback(move |reason, message| {
        signal.set(format!("{reason:?}: {message}"));
    });
    let reported = AtomicBool::new(false);
    device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| {
        if !reported.swap(true, Ordering::Relaxed) {
            web_sys::console::error_1(&format!("wgpu error: {error}").into());
        }
    }));
}

/// Depth buffer and, above one sample, the texture to resolve from.
fn targets(
    device: &wgpu::Device,
    config: &wgpu::SurfaceConfiguration,
    samples: u32,
) -> (wgpu::TextureView, Option<wgpu::TextureView>) {
    let target = |format| {
        let texture = device.create_texture(&wgpu::TextureDescriptor {
            label: Some("target"),
            size: wgpu::Extent3d {
                width: config.width,
                height: config.height,
                depth_or_array_layers: 1,
            },
            mip_level_count: 1,
            sample_count: samples,
            dimension: wgpu::TextureDimension::D2,
            format,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT,
            view_formats: &[],
        });
        texture.create_view(&wgpu::TextureViewDescriptor::default())
    };
    (
        target(DEPTH_FORMAT),
        (samples > 1).then(|| target(config.format)),
    )
}
