//! What every pass binds as group 0: the frame's uniforms, the vertices, the colour map.

use bytemuck::bytes_of;

use super::device::Gpu;
use crate::viewer::colour::{ColourMap, MAP_LENGTH, map_texels};
use crate::viewer::drawing::ROW;
use crate::viewer::frame::Frame;

/// Group 0 of every pipeline.
pub(super) struct Bindings {
    pub(super) layout: wgpu::BindGroupLayout,
    pub(super) group: wgpu::BindGroup,
    uniforms: wgpu::Buffer,
    vertices: wgpu::Texture,
    map: wgpu::Texture,
    sent_map: Option<ColourMap>,
}

impl Bindings {
    pub(super) fn new(gpu: &Gpu) -> Self {
        let device = &gpu.device;
        let layout = layout(device);
        let uniforms = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("frame"),
            size: size_of::<Frame>() as u64,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let vertices = texture(device, wgpu::TextureFormat::Rgba32Float, ROW as u32, 1);
        let map = texture(
            device,
            wgpu::TextureFormat::Rgba8UnormSrgb,
            MAP_LENGTH as u32,
            1,
        );
        let group = group(device, &layout, &uniforms, &vertices, &map);
        Self {
            layout,
            group,
            uniforms,
            vertices,
            map,
            sent_map: None,
        }
    }

    /// Sends the frame's uniforms.
    pub(super) fn set_frame(&self, gpu: &Gpu, frame: &Frame) {
        gpu.queue.write_buffer(&self.uniforms, 0, bytes_of(frame));
    }

    /// Sends positions and values, whole rows of [`ROW`] vertices. Only another number of
    /// rows makes a new texture.
    pub(super) fn set_vertices(&mut self, gpu: &Gpu, vertices: &[[f32; 4]]) {
        let rows = (vertices.len() / ROW) as u32;
        if rows != self.vertices.height() {
            let format = self.vertices.format();
            self.vertices = texture(&gpu.device, format, ROW as u32, rows);
            self.group = group(
                &gpu.device,
                &self.layout,
                &self.uniforms,
                &self.vertices,
                &self.map,
            );
        }
        write(gpu, &self.vertices, bytemuck::cast_slice(vertices));
    }

    /// Sends a colour map.
    pub(super) fn set_map(&mut self, gpu: &Gpu, map: ColourMap) {
        if self.sent_map != Some(map) {
            self.sent_map = Some(map);
            write(gpu, &self.map, &map_texels(map));
        }
    }
}

fn texture(
    device: &wgpu::Device,
    format: wgpu::TextureFormat,
    width: u32,
    height: u32,
) -> wgpu::Texture {
    device.create_texture(&wgpu::TextureDescriptor {
        label: None,
        size: wgpu::Extent3d {
            width,
            height,
            depth_or_array_layers: 1,
        },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    })
}

fn write(gpu: &Gpu, texture: &wgpu::Texture, bytes: &[u8]) {
    let layout = wgpu::TexelCopyBufferLayout {
        offset: 0,
        bytes_per_row: Some(bytes.len() as u32 / texture.height()),
        rows_per_image: None,
    };
    gpu.queue
        .write_texture(texture.as_image_copy(), bytes, layout, texture.size());
}

fn layout(device: &wgpu::Device) -> wgpu::BindGroupLayout {
    let texture = |filterable| wgpu::BindingType::Texture {
        sample_type: wgpu::TextureSampleType::Float { filterable },
        view_dimension: wgpu::TextureViewDimension::D2,
        multisampled: false,
    };
    let uniform = wgpu::BindingType::Buffer {
        ty: wgpu::BufferBindingType::Uniform,
        has_dynamic_offset: false,
        min_binding_size: None,
    };
    let sampler = wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering);
    let entry = |binding, visibility, ty| wgpu::BindGroupLayoutEntry {
        binding,
        visibility,
        ty,
        count: None,
    };
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("frame"),
        entries: &[
            entry(0, wgpu::ShaderStages::VERTEX_FRAGMENT, uniform),
            entry(1, wgpu::ShaderStages::VERTEX, texture(false)),
            entry(2, wgpu::ShaderStages::FRAGMENT, texture(true)),
            entry(3, wgpu::ShaderStages::FRAGMENT, sampler),
        ],
    })
}

fn group(
    device: &wgpu::Device,
    layout: &wgpu::BindGroupLayout,
    uniforms: &wgpu::Buffer,
    vertices: &wgpu::Texture,
    map: &wgpu::Texture,
) -> wgpu::BindGroup {
    let view = |texture: &wgpu::Texture| texture.create_view(&Default::default());
    let sampler = device.create_sampler(&wgpu::SamplerDescriptor {
        mag_filter: wgpu::FilterMode::Linear,
        min_filter: wgpu::FilterMode::Linear,
        ..Default::default()
    });
    let resources = [
        uniforms.as_entire_binding(),
        wgpu::BindingResource::TextureView(&view(vertices)),
        wgpu::BindingResource::TextureView(&view(map)),
        wgpu::BindingResource::Sampler(&sampler),
    ];
    let entry = |(binding, resource)| wgpu::BindGroupEntry { binding, resource };
    let entries: Vec<_> = (0..).zip(resources).map(entry).collect();
    device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some("frame"),
        layout,
        entries: &entries,
    })
}
