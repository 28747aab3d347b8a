//! Textures and groups of them, as the passes share them.

use super::device::{DEPTH_FORMAT, Gpu};

/// A texture that is written by the CPU: width, height, layers.
pub(super) fn data(
    gpu: &Gpu,
    format: wgpu::TextureFormat,
    (width, height, layers): (u32, u32, u32),
) -> wgpu::Texture {
    let usage = wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST;
    create(gpu, format, (width, height, layers), usage)
}

/// A texture that one pass draws into and another reads.
pub(super) fn target(
    gpu: &Gpu,
    format: wgpu::TextureFormat,
    size: (u32, u32),
) -> wgpu::TextureView {
    let usage = wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::RENDER_ATTACHMENT;
    create(gpu, format, (size.0, size.1, 1), usage).create_view(&Default::default())
}

/// A depth buffer for such a target.
pub(super) fn depth(gpu: &Gpu, size: (u32, u32)) -> wgpu::TextureView {
    let usage = wgpu::TextureUsages::RENDER_ATTACHMENT;
    create(gpu, DEPTH_FORMAT, (size.0, size.1, 1), usage).create_view(&Default::default())
}

fn create(
    gpu: &Gpu,
    format: wgpu::TextureFormat,
    (width, height, layers): (u32, u32, u32),
    usage: wgpu::TextureUsages,
) -> wgpu::Texture {
    gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: None,
        size: wgpu::Extent3d {
            width,
            height,
            depth_or_array_layers: layers,
        },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage,
        view_formats: &[],
    })
}

/// Overwrites one layer.
pub(super) fn write(gpu: &Gpu, texture: &wgpu::Texture, layer: u32, bytes: &[u8]) {
    let layout = wgpu::TexelCopyBufferLayout {
        offset: 0,
        bytes_per_row: Some(bytes.len() as u32 / texture.height()),
        rows_per_image: None,
    };
    let mut place = texture.as_image_copy();
    place.origin.z = layer;
    let mut size = texture.size();
    size.depth_or_array_layers = 1;
    gpu.queue.write_texture(place, bytes, layout, size);
}

/// Entry of a group for a block of uniforms.
pub(super) fn uniform_entry(binding: u32) -> wgpu::BindGroupLayoutEntry {
    entry(
        binding,
        wgpu::ShaderStages::VERTEX_FRAGMENT,
        wgpu::BindingType::Buffer {
            ty: wgpu::BufferBindingType::Uniform,
            has_dynamic_offset: false,
            min_binding_size: None,
        },
    )
}

/// Entry for a texture of which single texels are read.
pub(super) fn read_entry(
    binding: u32,
    visibility: wgpu::ShaderStages,
    dimension: wgpu::TextureViewDimension,
) -> wgpu::BindGroupLayoutEntry {
    texture_entry(binding, visibility, dimension, false)
}

/// Entry for a texture that is sampled smoothly.
pub(super) fn smooth_entry(binding: u32) -> wgpu::BindGroupLayoutEntry {
    let dimension = wgpu::TextureViewDimension::D2;
    texture_entry(binding, wgpu::ShaderStages::FRAGMENT, dimension, true)
}

/// Entry for a sampler of such textures.
pub(super) fn sampler_entry(binding: u32) -> wgpu::BindGroupLayoutEntry {
    let ty = wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering);
    entry(binding, wgpu::ShaderStages::FRAGMENT, ty)
}

fn texture_entry(
    binding: u32,
    visibility: wgpu::ShaderStages,
    view_dimension: wgpu::TextureViewDimension,
    filterable: bool,
) -> wgpu::BindGroupLayoutEntry {
    let ty = wgpu::BindingType::Texture {
        sample_type: wgpu::TextureSampleType::Float { filterable },
        view_dimension,
        multisampled: false,
    };
    entry(binding, visibility, ty)
}

fn entry(
    binding: u32,
    visibility: wgpu::ShaderStages,
    ty: wgpu::BindingType,
) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry {
        binding,
        visibility,
        ty,
        count: None,
    }
}

/// A group of resources at bindings 0, 1, 2, …
pub(super) fn group(
    gpu: &Gpu,
    layout: &wgpu::BindGroupLayout,
    resources: &[wgpu::BindingResource<'_>],
) -> wgpu::BindGroup {
    let bound = (0..).zip(resources);
    let entries: Vec<_> = bound
        .map(|(binding, resource)| wgpu::BindGroupEntry {
            binding,
            resource: resource.clone(),
        })
        .collect();
    gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: None,
        layout,
        entries: &entries,
    })
}
