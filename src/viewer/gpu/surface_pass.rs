//! The triangles, and the marked ones once more on top.

use super::bindings::Bindings;
use super::device::Gpu;
use super::pipeline::{GrowingBuffer, Plan, pipeline, shader};
use crate::viewer::drawing::Drawing;

/// Pipelines and buffers of the surface.
pub(super) struct SurfacePass {
    solid: wgpu::RenderPipeline,
    highlight: wgpu::RenderPipeline,
    normals: GrowingBuffer,
    flags: GrowingBuffer,
    triangles: GrowingBuffer,
    marked: GrowingBuffer,
}

impl SurfacePass {
    pub(super) fn new(gpu: &Gpu, bindings: &Bindings) -> Self {
        let normal = wgpu::vertex_attr_array![0 => Float32x3];
        let flag = wgpu::vertex_attr_array![1 => Unorm8x4];
        let layout = |stride, attributes| {
            Some(wgpu::VertexBufferLayout {
                array_stride: stride,
                step_mode: wgpu::VertexStepMode::Vertex,
                attributes,
            })
        };
        let shader = shader(gpu, "surface", include_str!("surface.wgsl"));
        let plan = |fragment, is_opaque| {
            pipeline(
                gpu,
                &Plan {
                    label: "surface",
                    shader: &shader,
                    vertex: "vertex",
                    fragment,
                    groups: &[Some(&bindings.layout)],
                    buffers: &[layout(12, &normal), layout(4, &flag)],
                    topology: wgpu::PrimitiveTopology::TriangleList,
                    is_opaque,
                    is_behind: false,
                },
            )
        };
        Self {
            solid: plan("fragment", true),
            highlight: plan("fragment_marked", false),
            normals: GrowingBuffer::new(gpu, wgpu::BufferUsages::VERTEX),
            flags: GrowingBuffer::new(gpu, wgpu::BufferUsages::VERTEX),
            triangles: GrowingBuffer::new(gpu, wgpu::BufferUsages::INDEX),
            marked: GrowingBuffer::new(gpu, wgpu::BufferUsages::INDEX),
        }
    }

    /// Takes over another mesh. Normals too, though they may not be computed yet: flat
    /// shading never looks at them, but a draw call wants the buffer to be long enough.
    pub(super) fn set_mesh(&mut self, gpu: &Gpu, drawing: &Drawing) {
        self.triangles.set(gpu, drawing.triangles());
        self.set_marked(gpu, drawing);
        self.set_normals(gpu, drawing);
    }

    pub(super) fn set_marked(&mut self, gpu: &Gpu, drawing: &Drawing) {
        self.marked.set(gpu, drawing.marked());
    }

    pub(super) fn set_normals(&mut self, gpu: &Gpu, drawing: &Drawing) {
        self.normals.set(gpu, drawing.normals());
    }

    pub(super) fn set_flags(&mut self, gpu: &Gpu, drawing: &Drawing) {
        self.flags.set(gpu, drawing.flags());
    }

    pub(super) fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        self.draw_triangles(pass, &self.solid, &self.triangles);
    }

    pub(super) fn draw_marked(&self, pass: &mut wgpu::RenderPass<'_>) {
        self.draw_triangles(pass, &self.highlight, &self.marked);
    }

    fn draw_triangles(
        &self,
        pass: &mut wgpu::RenderPass<'_>,
        pipeline: &wgpu::RenderPipeline,
        corners: &GrowingBuffer,
    ) {
        let count = corners.count::<u32>();
        if count > 0 {
            pass.set_pipeline(pipeline);
            pass.set_vertex_buffer(0, self.normals.slice());
            pass.set_vertex_buffer(1, self.flags.slice());
            pass.set_index_buffer(corners.slice(), wgpu::IndexFormat::Uint32);
            pass.draw_indexed(0..count, 0, 0..1);
        }
    }
}
