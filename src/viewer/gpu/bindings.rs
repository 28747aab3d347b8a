//! What every pass binds as group 0: the frame's uniforms, the steps, the marks.

use bytemuck::bytes_of;

use super::device::Gpu;
use super::texture::{self, read_entry, uniform_entry};
use crate::viewer::drawing::{Drawing, ROW};
use crate::viewer::frame::Frame;
use crate::viewer::motion::SLOTS;

/// Layers of the texture of steps that a step takes: positions and normals.
const LAYERS: u32 = 2;

/// Group 0 of every pipeline.
pub(super) struct Bindings {
    pub(super) layout: wgpu::BindGroupLayout,
    pub(super) group: wgpu::BindGroup,
    uniforms: wgpu::Buffer,
    steps: wgpu::Texture,
    marks: wgpu::Texture,
}

impl Bindings {
    pub(super) fn new(gpu: &Gpu) -> Self {
        let layout = gpu
            .device
            .create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
                label: Some("frame"),
                entries: &[
                    uniform_entry(0),
                    read_entry(
                        1,
                        wgpu::ShaderStages::VERTEX,
                        wgpu::TextureViewDimension::D2Array,
                    ),
                    read_entry(
                        2,
                        wgpu::ShaderStages::VERTEX,
                        wgpu::TextureViewDimension::D2,
                    ),
                ],
            });
        let uniforms = gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("frame"),
            size: size_of::<Frame>() as u64,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let steps = steps(gpu, 1, 1);
        let marks = marks(gpu, 1);
        let group = group(gpu, &layout, &uniforms, &steps, &marks);
        Self {
            layout,
            group,
            uniforms,
            steps,
            marks,
        }
    }

    /// Sends the frame's uniforms.
    pub(super) fn set_frame(&self, gpu: &Gpu, frame: &Frame) {
        gpu.queue.write_buffer(&self.uniforms, 0, bytes_of(frame));
    }

    /// Sends what has changed of the steps: `points`, the positions and values in these
    /// slots, `normals` the normals in those. Only more steps, or another number of rows,
    /// make new textures, and then all is sent.
    pub(super) fn set_steps(
        &mut self,
        gpu: &Gpu,
        drawing: &Drawing,
        mut points: [bool; SLOTS],
        mut normals: [bool; SLOTS],
    ) {
        let held = drawing.steps();
        let rows = (drawing.flags().len() / ROW) as u32;
        let layers = LAYERS * held.len() as u32;
        if rows != self.steps.height() || layers > self.steps.depth_or_array_layers() {
            self.steps = steps(gpu, rows, layers);
            (points, normals) = ([true; SLOTS], [true; SLOTS]);
            if rows != self.marks.height() {
                self.marks = marks(gpu, rows);
            }
            self.group = group(gpu, &self.layout, &self.uniforms, &self.steps, &self.marks);
        }
        for (slot, step) in held.iter().enumerate() {
            let layer = LAYERS * slot as u32;
            if points[slot] {
                texture::write(
                    gpu,
                    &self.steps,
                    layer,
                    bytemuck::cast_slice(step.vertices()),
                );
            }
            if normals[slot] {
                let normals = bytemuck::cast_slice(step.normals());
                texture::write(gpu, &self.steps, layer + 1, normals);
            }
        }
    }

    /// Sends the marks, after the steps of the same mesh.
    pub(super) fn set_marks(&self, gpu: &Gpu, drawing: &Drawing) {
        texture::write(gpu, &self.marks, 0, bytemuck::cast_slice(drawing.flags()));
    }
}

fn steps(gpu: &Gpu, rows: u32, layers: u32) -> wgpu::Texture {
    // Never a single layer: WebGL has another kind of texture for that.
    let size = (ROW as u32, rows, layers.max(LAYERS));
    texture::data(gpu, wgpu::TextureFormat::Rgba32Float, size)
}

fn marks(gpu: &Gpu, rows: u32) -> wgpu::Texture {
    texture::data(gpu, wgpu::TextureFormat::Rgba8Unorm, (ROW as u32, rows, 1))
}

fn group(
    gpu: &Gpu,
    layout: &wgpu::BindGroupLayout,
    uniforms: &wgpu::Buffer,
    steps: &wgpu::Texture,
    marks: &wgpu::Texture,
) -> wgpu::BindGroup {
    let steps = steps.create_view(&wgpu::TextureViewDescriptor {
        dimension: Some(wgpu::TextureViewDimension::D2Array),
        ..Default::default()
    });
    let marks = marks.create_view(&Default::default());
    texture::group(
        gpu,
        layout,
        &[
            uniforms.as_entire_binding(),
            wgpu::BindingResource::TextureView(&steps),
            wgpu::BindingResource::TextureView(&marks),
        ],
    )
}
