//! Edges as ribbons of fixed pixel width: the wireframe and the boundary loops.
//!
//! Each edge is one instance of a four-cornered strip that looks up its two ends in the
//! texture of vertices. So edges are sent once, and follow the surface for nothing.

use bytemuck::bytes_of;

use super::bindings::Bindings;
use super::device::Gpu;
use super::pipeline::{GrowingBuffer, Plan, pipeline, shader};
use crate::viewer::edges::Edge;
use crate::viewer::frame::Line;

/// The pipeline of all lines.
pub(super) struct LinePass {
    pipeline: wgpu::RenderPipeline,
    layout: wgpu::BindGroupLayout,
}

/// Edges drawn alike.
pub(super) struct EdgeSet {
    edges: GrowingBuffer,
    uniforms: wgpu::Buffer,
    group: wgpu::BindGroup,
}

impl LinePass {
    pub(super) fn new(gpu: &Gpu, bindings: &Bindings) -> Self {
        let layout = gpu
            .device
            .create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
                label: Some("line"),
                entries: &[wgpu::BindGroupLayoutEntry {
                    binding: 0,
                    visibility: wgpu::ShaderStages::VERTEX_FRAGMENT,
                    ty: wgpu::BindingType::Buffer {
                        ty: wgpu::BufferBindingType::Uniform,
                        has_dynamic_offset: false,
                        min_binding_size: None,
                    },
                    count: None,
                }],
            });
        let pipeline = pipeline(
            gpu,
            &Plan {
                label: "line",
                shader: &shader(gpu, "line", include_str!("line.wgsl")),
                fragment: "fragment",
                groups: &[Some(&bindings.layout), Some(&layout)],
                buffers: &[Some(wgpu::VertexBufferLayout {
                    array_stride: size_of::<Edge>() as u64,
                    step_mode: wgpu::VertexStepMode::Instance,
                    attributes: &wgpu::vertex_attr_array![0 => Uint32x2, 1 => Float32x2],
                })],
                topology: wgpu::PrimitiveTopology::TriangleStrip,
                is_opaque: false,
            },
        );
        Self { pipeline, layout }
    }

    pub(super) fn edge_set(&self, gpu: &Gpu) -> EdgeSet {
        let uniforms = gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("line"),
            size: size_of::<Line>() as u64,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let group = gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("line"),
            layout: &self.layout,
            entries: &[wgpu::BindGroupEntry {
                binding: 0,
                resource: uniforms.as_entire_binding(),
            }],
        });
        let edges = GrowingBuffer::new(gpu, wgpu::BufferUsages::VERTEX);
        EdgeSet {
            edges,
            uniforms,
            group,
        }
    }

    pub(super) fn draw(&self, pass: &mut wgpu::RenderPass<'_>, set: &EdgeSet) {
        let count = set.edges.count::<Edge>();
        if count > 0 {
            pass.set_pipeline(&self.pipeline);
            pass.set_bind_group(1, &set.group, &[]);
            pass.set_vertex_buffer(0, set.edges.slice());
            pass.draw(0..4, 0..count);
        }
    }
}

impl EdgeSet {
    pub(super) fn set_edges(&mut self, gpu: &Gpu, edges: &[Edge]) {
        self.edges.set(gpu, edges);
    }

    pub(super) fn set_line(&self, gpu: &Gpu, line: &Line) {
        gpu.queue.write_buffer(&self.uniforms, 0, bytes_of(line));
    }
}
