//! Pictures made of pictures: what the passes of the effects share.

use super::bindings::Bindings;
use super::device::Gpu;
use super::pipeline::{Plan, Target, pipeline};
use super::texture::{self, read_entry};

/// A picture that one pass draws and another reads.
pub(super) struct Canvas {
    pub(super) view: wgpu::TextureView,
    group: wgpu::BindGroup,
}

/// How a filter binds the picture it reads, as group 1.
pub(super) struct Reading(pub(super) wgpu::BindGroupLayout);

impl Reading {
    pub(super) fn new(gpu: &Gpu) -> Self {
        let stages = wgpu::ShaderStages::FRAGMENT;
        let entries = [read_entry(0, stages, wgpu::TextureViewDimension::D2)];
        let layout = wgpu::BindGroupLayoutDescriptor {
            label: Some("filter"),
            entries: &entries,
        };
        Self(gpu.device.create_bind_group_layout(&layout))
    }

    /// A picture of such a size.
    pub(super) fn canvas(
        &self,
        gpu: &Gpu,
        format: wgpu::TextureFormat,
        size: (u32, u32),
    ) -> Canvas {
        let view = texture::target(gpu, format, size);
        let read = [wgpu::BindingResource::TextureView(&view)];
        let group = texture::group(gpu, &self.0, &read);
        Canvas { view, group }
    }

    /// The pipeline of a filter: `fragment` for each pixel of a picture of such a format.
    pub(super) fn filter(
        &self,
        gpu: &Gpu,
        bindings: &Bindings,
        shader: &wgpu::ShaderModule,
        fragment: &'static str,
        format: wgpu::TextureFormat,
    ) -> wgpu::RenderPipeline {
        pipeline(
            gpu,
            &Plan {
                label: "filter",
                shader,
                vertex: "vertex",
                fragment,
                groups: &[Some(&bindings.layout), Some(&self.0)],
                buffers: &[],
                topology: wgpu::PrimitiveTopology::TriangleList,
                target: Target::Flat(format),
            },
        )
    }
}

/// Records one pass into a picture, cleared to `clear` first, with group 0 bound.
pub(super) fn record(
    encoder: &mut wgpu::CommandEncoder,
    bindings: &Bindings,
    target: &wgpu::TextureView,
    depth: Option<&wgpu::TextureView>,
    clear: wgpu::Color,
    draw: impl FnOnce(&mut wgpu::RenderPass<'_>),
) {
    let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: None,
        color_attachments: &[Some(wgpu::RenderPassColorAttachment {
            view: target,
            depth_slice: None,
            resolve_target: None,
            ops: wgpu::Operations {
                load: wgpu::LoadOp::Clear(clear),
                store: wgpu::StoreOp::Store,
            },
        })],
        depth_stencil_attachment: depth.map(|view| wgpu::RenderPassDepthStencilAttachment {
            view,
            depth_ops: Some(wgpu::Operations {
                load: wgpu::LoadOp::Clear(1.0),
                store: wgpu::StoreOp::Discard,
            }),
            stencil_ops: None,
        }),
        ..Default::default()
    });
    pass.set_bind_group(0, &bindings.group, &[]);
    draw(&mut pass);
}

/// Filters one picture into another.
pub(super) fn apply(
    encoder: &mut wgpu::CommandEncoder,
    bindings: &Bindings,
    filter: &wgpu::RenderPipeline,
    from: &Canvas,
    to: &Canvas,
) {
    record(
        encoder,
        bindings,
        &to.view,
        None,
        wgpu::Color::WHITE,
        |pass| {
            pass.set_pipeline(filter);
            pass.set_bind_group(1, &from.group, &[]);
            pass.draw(0..3, 0..1);
        },
    );
}
