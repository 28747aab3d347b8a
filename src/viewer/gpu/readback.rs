//! Reads a picture back from the GPU, for golden pictures.

use super::device::Gpu;
#[cfg(feature = "viewer-webgl")]
use super::polling::poll_until;
use super::signal::Signal;
use crate::viewer::error::ViewerError;

/// A picture as bytes: r, g, b, a, row after row from the top.
pub struct Picture {
    /// Width in pixels.
    pub width: u32,
    /// Height in pixels.
    pub height: u32,
    /// `4 · width · height` bytes.
    pub data: Vec<u8>,
}

/// A picture on its way back. Holds nothing of the viewer, so that drawing can go on.
pub(super) struct Readback {
    #[cfg(feature = "viewer-webgl")]
    device: wgpu::Device,
    buffer: wgpu::Buffer,
    mapped: Signal<bool>,
    lost: Signal<String>,
    width: u32,
    height: u32,
    swaps_red_and_blue: bool,
}

impl Readback {
    /// Draws into a texture of its own by `draw` and starts to read it.
    pub(super) fn start(
        gpu: &Gpu,
        draw: impl FnOnce(&mut wgpu::CommandEncoder, &wgpu::TextureView),
    ) -> Self {
        let (width, height) = gpu.size();
        let size = wgpu::Extent3d {
            width,
            height,
            depth_or_array_layers: 1,
        };
        let texture = gpu.device.create_texture(&wgpu::TextureDescriptor {
            label: Some("readback"),
            size,
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: gpu.format(),
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
            view_formats: &[],
        });
        let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("readback"),
            size: u64::from(bytes_per_row(width)) * u64::from(height),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        draw(&mut encoder, &texture.create_view(&Default::default()));
        encoder.copy_texture_to_buffer(
            texture.as_image_copy(),
            wgpu::TexelCopyBufferInfo {
                buffer: &buffer,
                layout: wgpu::TexelCopyBufferLayout {
                    offset: 0,
                    bytes_per_row: Some(bytes_per_row(width)),
                    rows_per_image: None,
                },
            },
            size,
        );
        gpu.queue.submit([encoder.finish()]);
        let mapped = Signal::default();
        let signal = mapped.clone();
        buffer.map_async(wgpu::MapMode::Read, .., move |result| {
            signal.set(result.is_ok())
        });
        Self {
            #[cfg(feature = "viewer-webgl")]
            device: gpu.device.clone(),
            buffer,
            mapped,
            lost: gpu.lost.clone(),
            width,
            height,
            swaps_red_and_blue: gpu.format() == wgpu::TextureFormat::Bgra8Unorm,
        }
    }

    /// The picture, once it is here.
    pub(super) async fn finish(self) -> Result<Picture, ViewerError> {
        let failure = || ViewerError::GpuLost {
            reason: self.lost.get().unwrap_or_default(),
        };
        #[cfg(feature = "viewer-webgl")]
        {
            let is_over = || self.mapped.get().is_some() || self.lost.get().is_some();
            poll_until(&self.device, is_over).await;
            if self.mapped.get().is_none() {
                return Err(failure());
            }
        }
        if !self.mapped.wait().await {
            return Err(failure());
        }
        let bytes = self.buffer.get_mapped_range(..).map_err(|_| failure())?;
        let rows = bytes.chunks_exact(bytes_per_row(self.width) as usize);
        let mut data: Vec<u8> = rows
            .flat_map(|row| &row[..4 * self.width as usize])
            .copied()
            .collect();
        if self.swaps_red_and_blue {
            data.chunks_exact_mut(4).for_each(|pixel| pixel.swap(0, 2));
        }
        Ok(Picture {
            width: self.width,
            height: self.height,
            data,
        })
    }
}

/// Rows of a copied texture begin at multiples of 256 bytes.
fn bytes_per_row(width: u32) -> u32 {
    (4 * width).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT)
}
